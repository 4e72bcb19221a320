//! `article`: its checks, its pages, its refusals.

mod common;

use common::Workplace;
use serde_json::Value;

/// Digits in which the results of all processors agree.
const DIGITS: usize = 7;

/// Below this share of the other numbers of a check a number is what rounding leaves.
const NOTHING: f64 = 1e-9;

fn checks(arguments: &[&str]) -> Vec<Value> {
    let workplace = Workplace::new();
    let finished = workplace.run(&[&["article", "--format", "json"], arguments].concat());
    assert_eq!(finished.status, Some(0), "{arguments:?}: {}", finished.err);
    let document = common::document(&finished.out, "article.schema.json");
    document["checks"].as_array().expect("checks").clone()
}

fn verdict(checks: &[Value], id: &str) -> String {
    let check = checks.iter().find(|check| check["id"] == id).expect(id);
    check["verdict"].as_str().expect("a verdict").to_owned()
}

/// The first number of a check on either side.
fn value(checks: &[Value], id: &str, side: &str, place: usize) -> f64 {
    let check = checks.iter().find(|check| check["id"] == id).expect(id);
    check[side][place]["value"].as_f64().expect(id)
}

/// A check on a line or a few: its numbers rounded, what is left of rounding as 0.
fn lines(check: &Value) -> String {
    let mut text = format!(
        "{} ({}): {}\n",
        text(check, "id"),
        text(check, "equation"),
        text(check, "verdict")
    );
    let numbers = |side: &str| check[side].as_array().expect("figures").clone();
    let all = [numbers("computed"), numbers("expected")].concat();
    let largest = all
        .iter()
        .filter_map(|figure| figure["value"].as_f64())
        .fold(1.0, |a: f64, b| a.max(b.abs()));
    for side in ["computed", "expected"] {
        for figure in numbers(side) {
            let value = match figure["value"].as_f64() {
                None => "none".to_owned(),
                Some(value) if value.abs() < NOTHING * largest => "0".to_owned(),
                Some(value) => format!("{value:.*e}", DIGITS - 1),
            };
            let (symbol, unit) = (self::text(&figure, "symbol"), self::text(&figure, "unit"));
            text += &format!("    {side}: {symbol} = {value} {unit}\n");
        }
    }
    text
}

fn text<'a>(value: &'a Value, field: &str) -> &'a str {
    value[field].as_str().expect(field)
}

#[test]
fn the_checks_of_the_built_in_experiment() {
    let lines: String = checks(&[]).iter().map(lines).collect();
    insta::assert_snapshot!(lines);
}

/// The errors of the article, with the numbers that independent programs have found for this experiment.
#[test]
fn published_errors_are_found() {
    let checks = checks(&[]);
    for (id, side, place, expected, tolerance) in [
        ("decay-left", "computed", 0, 0.019749, 1e-6),
        ("decay-middle", "computed", 0, 0.009875, 1e-6),
        ("decay-right", "computed", 0, 0.39498, 1e-5),
        ("linear-solution", "computed", 0, 4.905e-3, 1e-6),
        ("after-rest", "computed", 0, -0.19964, 1e-5),
        ("after-rest", "computed", 1, -5.279, 1e-3),
        ("general-linear-solution", "computed", 0, 4.808e-3, 1e-6),
        ("general-linear-solution", "computed", 1, 4.843e-3, 1e-6),
        ("agreement-general", "computed", 0, 0.204, 5e-4),
        ("after-rest", "expected", 0, 1.9e-3, 1e-9),
    ] {
        let found = value(&checks, id, side, place);
        assert!((found - expected).abs() <= tolerance, "{id}: {found}");
    }
    for id in [
        "lost-factor",
        "quotient-orders",
        "scheme-order-stokes",
        "stability",
        "start-order",
        "static-friction",
        "start-coulomb",
        "scheme-rests",
        "scheme-order-coulomb",
        "decay-middle",
        "decay-right",
        "letter-c",
        "linear-solution",
        "linear-start",
        "negative-release",
        "written-out",
        "after-rest",
        "agreement-coulomb",
        "agreement-proves",
        "quadrant",
        "phase-at-rest",
        "general-linear-solution",
        "general-turning-points",
        "general-written-out",
        "general-after-rest",
        "agreement-general",
        "scheme-order-newton",
        "only-numeric",
    ] {
        assert_eq!(verdict(&checks, id), "fails", "{id}");
    }
}

#[test]
fn one_newton_per_metre_hides_the_factor_c() {
    let checks = checks(&["--stiffness", "1 N/m", "--position", "0.5 m"]);
    for id in ["decay-right", "written-out", "general-written-out"] {
        assert_eq!(verdict(&checks, id), "holds-here", "{id}");
    }
    for id in ["decay-middle", "decay-dimension"] {
        assert_eq!(verdict(&checks, id), "fails", "{id}");
    }
}

#[test]
fn the_report_is_about_the_experiment() {
    let own = checks(&["--damping", "30 kg/s", "--normal-force", "3 N", "--kinetic", "0.02"]);
    for id in ["damped-solution", "frequency-lowered", "exponential-decay", "normal-force"] {
        assert_eq!(verdict(&own, id), "not-applicable", "{id}");
    }
    assert_eq!(verdict(&own, "overdamped-solution"), "holds");
    let force = value(&own, "friction-force", "expected", 0);
    assert!((force - 0.06).abs() < 1e-15, "{force}");
    let given = ["--density", "1000 kg/m^3", "--drag-coefficient", "0.9", "--area", "10 cm^2"];
    assert_eq!(value(&checks(&given), "letter-c", "computed", 0), 0.9);
}

#[test]
fn pages_are_whole_in_both_languages() {
    for (language, title) in [("de", "ein Artikel, nachgerechnet"), ("en", "an article, checked")] {
        let workplace = Workplace::new();
        let finished = workplace.run(&["article", "--lang", language, "-o", "article.html"]);
        assert_eq!(finished.status, Some(0), "{}", finished.err);
        let page = String::from_utf8(workplace.read("article.html")).expect("UTF-8");
        assert!(page.starts_with("<!DOCTYPE html>") && page.trim_end().ends_with("</html>"));
        assert!(page.contains(title) && page.contains(&format!("<html lang=\"{language}\">")));
        for outside in ["<script", "http:", "https:", "src=", "@import", "url("] {
            let inside = page.replace("http://www.w3.org", "").replace("url(#", "");
            let found = inside.contains(outside);
            assert!(!found, "{outside} in the page");
        }
        assert_eq!(page.matches("type=\"checkbox\"").count(), 0);
        assert_eq!(page.matches("class=\"claim\"").count(), checks(&[]).len());
    }
}

#[test]
fn a_worksheet_has_its_solutions_beside_it() {
    let workplace = Workplace::new();
    let finished = workplace.run(&["article", "--worksheet", "-o", "sheet.html"]);
    assert_eq!(finished.status, Some(0), "{}", finished.err);
    assert_eq!(workplace.files(), ["sheet-solutions.html", "sheet.html"]);
    let read = |name: &str| String::from_utf8(workplace.read(name)).expect("UTF-8");
    let (sheet, solutions) = (read("sheet.html"), read("sheet-solutions.html"));
    let marks = |page: &str| page.matches("class=\"verdict ").count();
    assert_eq!((marks(&sheet), marks(&solutions)), (0, checks(&[]).len()));
    assert_eq!(sheet.matches("<textarea").count(), checks(&[]).len());
    assert!(!sheet.contains("class=\"finding\"") && solutions.contains("class=\"finding\""));
}

#[test]
fn solutions_overwrite_nothing_that_was_asked_for() {
    let workplace = Workplace::new();
    let experiment = b"[oscillator]\nmass = 1\nstiffness = 1\n[release]\nposition = 1\n";
    workplace.write("exp-solutions.html", experiment);
    workplace.folder("w-solutions.html");
    for arguments in [
        &["article", "exp-solutions.html", "--worksheet", "-o", "exp.html"][..],
        &["article", "--worksheet", "-o", "s.html", "-o", "./s-solutions.html"],
        &["article", "--worksheet", "-o", "w.html"],
    ] {
        let finished = workplace.run(arguments);
        assert_eq!(finished.status, Some(2), "{arguments:?}: {}", finished.err);
        assert_eq!(workplace.files(), ["exp-solutions.html", "w-solutions.html"], "{arguments:?}");
    }
    assert_eq!(workplace.read("exp-solutions.html"), experiment);
}

#[test]
fn a_page_can_hold_some_claims_alone() {
    let workplace = Workplace::new();
    let finished =
        workplace.run(&["article", "--worksheet", "--claims", "8,44-46", "-o", "sheet.html"]);
    assert_eq!(finished.status, Some(0), "{}", finished.err);
    let sheet = String::from_utf8(workplace.read("sheet.html")).expect("UTF-8");
    assert_eq!(sheet.matches("class=\"claim\"").count(), 4);
    for (id, stays) in
        [("experiment", true), ("exponential", true), ("coulomb-rest", true), ("newton", false)]
    {
        assert_eq!(sheet.contains(&format!("<section id=\"{id}\">")), stays, "{id}");
    }
}

#[test]
fn what_is_wrong_is_refused_and_nothing_is_written() {
    let workplace = Workplace::new();
    for (arguments, said) in [
        (&["article", "-o", "article.svg"][..], ".html"),
        (&["article", "--format", "csv"], "summary"),
        (&["article", "--mass", "250 m"], "mass"),
        (&["article", "--dt", "1 ms"], "--dt"),
        (&["article", "--worksheet", "-o", "a.html", "-o", "a-solutions.html"], "a-solutions.html"),
        (&["articel"], "article"),
        (&["article", "one.toml", "two.toml"], "two.toml"),
        (&["article", "--worksheet"], ".html"),
        (&["article", "--worksheet", "-o", "sheet.json"], ".html"),
        (&["article", "--claims", "3"], ".html"),
        (&["article", "--claims", "47-43", "-o", "a.html"], "47-43"),
        (&["article", "--claims", "0,5", "-o", "a.html"], "0,5"),
    ] {
        let finished = workplace.run(arguments);
        assert_eq!(finished.status, Some(2), "{arguments:?}");
        assert!(finished.err.contains(said), "{arguments:?}: {}", finished.err);
        assert!(workplace.files().is_empty(), "{arguments:?}");
    }
}

#[test]
fn the_summary_is_a_picture_a_sentence_and_what_does_not_hold() {
    let workplace = Workplace::new();
    let short = workplace.run(&["article"]);
    assert!(
        short.out.contains("claims checked here") && short.out.contains("44–47"),
        "{}",
        short.out
    );
    assert!(short.out.lines().count() < 40 && short.out.contains("-o article.html"));
    let long = workplace.run(&["article", "--details"]);
    for check in checks(&[]) {
        let claim: Vec<_> = check["claim"].as_str().expect("a claim").split(' ').collect();
        let said: Vec<_> = long.out.split_whitespace().collect();
        assert!(
            said.windows(claim.len().min(6)).any(|words| words == &claim[..words.len()]),
            "{claim:?}"
        );
    }
    assert!(!long.out.contains(['$', '\\']), "{}", long.out);
}
