//! The tables in docs/article.md against the code: every equation of the article has a row, and every
//! name in them exists.

mod names;
mod tables;

use std::fs;
use std::path::Path;

use names::Names;
use tables::Table;

/// Number of the article's last equation.
const LAST: u32 = 86;

fn tables() -> Vec<Table> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/article.md");
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("docs/article.md: {error}"));
    tables::read(&text)
}

fn names() -> Names {
    Names::of(Path::new(env!("CARGO_MANIFEST_DIR")))
}

#[track_caller]
fn assert_none(complaints: &[String]) {
    assert!(complaints.is_empty(), "docs/article.md:\n  {}", complaints.join("\n  "));
}

#[test]
fn every_equation_stands_in_one_row() {
    let rows = tables().into_iter().filter(|table| table.is_of_equations()).flat_map(|t| t.rows);
    let numbers: Vec<u32> = rows.flat_map(|row| row.equations()).collect();
    let mut complaints = Vec::new();
    for number in 1..=LAST {
        match numbers.iter().filter(|&&n| n == number).count() {
            0 => complaints.push(format!("equation ({number}) is missing")),
            1 => {}
            count => complaints.push(format!("equation ({number}) stands in {count} rows")),
        }
    }
    for number in numbers.iter().filter(|number| !(1..=LAST).contains(number)) {
        complaints.push(format!("the article has no equation ({number})"));
    }
    assert_none(&complaints);
}

#[test]
fn every_name_exists() {
    let names = names();
    let mut complaints = Vec::new();
    for row in tables().iter().flat_map(|table| &table.rows) {
        if row.code_names().is_empty() {
            complaints.push(format!("line {}: no name in the column of the code", row.line));
        }
        for name in row.names() {
            if let Err(why) = names.check(name) {
                complaints.push(format!("line {}: `{name}`: {why}", row.line));
            }
        }
    }
    assert_none(&complaints);
}

/// A function that is named for an equation is missing from no row of that equation.
#[test]
fn every_function_named_for_an_equation_is_told() {
    let tables = tables();
    let rows = || tables.iter().filter(|table| table.is_of_equations()).flat_map(|t| &t.rows);
    let mut complaints = Vec::new();
    let functions = names().public_below("article");
    let mut numbered = 0;
    for function in &functions {
        let Some(number) = equation_of(function) else { continue };
        numbered += 1;
        let told = rows().any(|row| {
            row.equations().contains(&number) && row.code_names().contains(&function.as_str())
        });
        if !told {
            complaints.push(format!("the row of ({number}) does not name `{function}`"));
        }
    }
    assert!(numbered > 10, "few functions are named for an equation: {functions:?}");
    assert_none(&complaints);
}

/// 28 of `article::ComplexForm::eq_28_constants`.
fn equation_of(function: &str) -> Option<u32> {
    let (_, name) = function.rsplit_once("::")?;
    name.strip_prefix("eq_")?.split('_').next()?.parse().ok()
}

/// The check itself can fail: beside each name that exists one that is wrong in some way.
#[test]
fn wrong_names_are_found_out() {
    let names = names();
    for (right, wrong, why) in [
        ("article::eq_46", "article::eq_47", "`article` has no public `eq_47`"),
        ("Oscillator::period", "Oscillator::perioda", "`Oscillator` has no public `perioda`"),
        ("NormalForce::Weight", "NormalForce::Heavy", "no public `Heavy`"),
        ("article::DampedRates", "DampedRates", "the crate has no public `DampedRates`"),
        ("scheme::article::Scheme::run", "scheme::Scheme::run", "no public `run`"),
        ("crate::swing::linear::Propagator::rates", "swing::linear", "no public `swing`"),
        ("crate::swing::linear", "crate::swing::straight", "`swing` has no `straight`"),
        ("lens::ladder", "lens::gauge", "no public `gauge`"),
        ("crate::oscillator::Oscillator::reduced", "Oscillator::reduced", "no public `reduced`"),
        ("tests/article.rs", "tests/particle.rs", "no such file"),
        ("tests/article.rs::the_damped_rates", "tests/article.rs::dry", "no such test"),
        ("src/swing/linear.rs::tests::transfers_compose", "src/lib.rs::tests", "no such test"),
    ] {
        names.check(right).unwrap_or_else(|why| panic!("{right}: {why}"));
        let found = names.check(wrong).expect_err(wrong);
        assert!(found.contains(why), "{wrong}: {found}");
    }
}
