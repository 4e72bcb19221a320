//! What stands in the sections of the report, from headings to the ends of curves: that the right number stands in the
//! right place.

use federpendel::{Coulomb, Friction, Newton, NormalForce, Oscillator, State, Stokes};
use federpendel_report::article::{Checks, Edition, Laboratory, document};
use federpendel_report::{Block, Document, Section};
use federpendel_text::plot::Plot;
use federpendel_text::{Catalogue, Language};

const WEIGHT: NormalForce = NormalForce::Weight(9.81);

fn laboratory(friction: Friction, x0: f64, v0: f64) -> Laboratory {
    let oscillator = Oscillator::new(0.5, 20.0, friction).unwrap();
    Laboratory::new(oscillator, WEIGHT, State::new(x0, v0).unwrap(), None, None).unwrap()
}

fn report(laboratory: &Laboratory, edition: Edition) -> (Checks, Document) {
    let checks = Checks::of(laboratory).unwrap();
    let catalogue = Catalogue::new(Language::English);
    let document = document(laboratory, &checks, edition, &catalogue).unwrap();
    (checks, document)
}

fn built_in() -> Laboratory {
    laboratory(Coulomb::new(0.02, 0.02, WEIGHT).unwrap().into(), 0.1, 0.0)
}

/// Headings, tables, captions, curves and labels as lines.
fn lines(sections: &[Section], depth: usize) -> String {
    let mut text = String::new();
    for section in sections {
        text += &format!("{} {}\n", "#".repeat(depth), section.heading);
        for block in &section.blocks {
            text += &block_lines(block);
        }
        text += &lines(&section.sections, depth + 1);
    }
    text
}

fn block_lines(block: &Block) -> String {
    match block {
        Block::Figure { id, plots, caption } => {
            let plots: String = plots.iter().map(plot_lines).collect();
            format!("[{id}] {caption}\n{plots}")
        }
        Block::Sketch { id, svg, caption } => {
            format!("[{id}] {caption}\n    {}\n", labels(svg).join(" | "))
        }
        Block::Table { caption, head, rows, .. } => {
            let rows = rows.iter().map(|row| format!("    {}\n", row.cells.join(" | ")));
            format!("{caption}\n    {}\n{}", head.join(" | "), rows.collect::<String>())
        }
        Block::Notice(text) => format!("! {text}\n"),
        Block::Formula { number, tex } => format!("{} {tex}\n", number.as_deref().unwrap_or("()")),
        Block::Claims(claims) => {
            let names: Vec<_> =
                claims.iter().map(|claim| format!("{} {}", claim.number, claim.id)).collect();
            format!("claims: {}\n", names.join(", "))
        }
        Block::Paragraph(_) | Block::List(_) => String::new(),
    }
}

/// The axes of a plot, and where each curve begins, how far it reaches and where it ends. What is below a millionth of the
/// largest is left of rounding.
fn plot_lines(plot: &Plot) -> String {
    let mut text = format!("    {} / {}\n", plot.x.label, plot.y.label);
    for series in &plot.series {
        let heights = || series.points.iter().map(|point| point.1);
        let largest = heights().fold(0.0, |most: f64, height| most.max(height.abs()));
        let logarithmic = plot.y.label.contains("Δx|");
        let round = |value: f64| {
            if logarithmic {
                format!("10^{:.0}", value.abs().log10())
            } else if value.abs() < 1e-6 * largest {
                "0".to_owned()
            } else {
                format!("{value:.3e}")
            }
        };
        let first = series.points.first().map_or(f64::NAN, |point| point.1);
        let last = series.points.last().map_or(f64::NAN, |point| point.1);
        // What is rounding alone differs from one processor to the next.
        if logarithmic && largest < 1e-12 {
            text += &format!("      {}: rounding\n", series.name);
            continue;
        }
        text += &format!(
            "      {}: {} … {} (to {})\n",
            series.name,
            round(first),
            round(last),
            round(largest)
        );
    }
    text
}

/// The texts of a drawing.
fn labels(svg: &str) -> Vec<String> {
    let inside = |text: &str| {
        let mut plain = String::new();
        let mut tag = false;
        for sign in text.chars() {
            match sign {
                '<' => tag = true,
                '>' => tag = false,
                _ if !tag => plain.push(sign),
                _ => {}
            }
        }
        plain
    };
    let texts = svg.split("<text").skip(1);
    let bodies = texts.filter_map(|text| text.split_once('>')?.1.split_once("</text>"));
    bodies.map(|(body, _)| inside(body)).collect()
}

#[test]
fn the_report_on_the_built_in_experiment() {
    let (_, document) = report(&built_in(), Edition::Report);
    insta::assert_snapshot!(lines(&document.sections, 1));
}

#[test]
fn the_report_on_all_laws_at_once() {
    let friction = Friction {
        stokes: Some(Stokes::new(0.05).unwrap()),
        coulomb: Some(Coulomb::new(0.005, 0.01, WEIGHT).unwrap()),
        newton: Some(Newton::new(0.047).unwrap()),
    };
    let (_, document) = report(&laboratory(friction, -0.1, 0.4), Edition::Report);
    insta::assert_snapshot!(lines(&document.sections, 1));
}

#[test]
fn claims_stand_in_order_under_their_numbers() {
    let (checks, document) = report(&built_in(), Edition::Report);
    let text = lines(&document.sections, 1);
    let listed = text
        .lines()
        .filter_map(|line| line.strip_prefix("claims: "))
        .collect::<Vec<_>>()
        .join(", ");
    let expected: Vec<_> = checks
        .all()
        .enumerate()
        .map(|(index, check)| format!("{} {}", index + 1, check.id))
        .collect();
    assert_eq!(listed, expected.join(", "));
    let errata = document.sections.last().expect("a last section");
    let Some(Block::Table { rows, .. }) = errata.blocks.last() else { panic!("a table") };
    for row in rows {
        let id = row.target.as_deref().expect("a claim");
        assert!(expected.contains(&format!("{} {id}", row.cells[0])), "{row:?}");
    }
}

#[test]
fn a_worksheet_gives_no_answer_away() {
    let (_, document) = report(&built_in(), Edition::Worksheet);
    let whole = format!("{document:?}");
    for answer in
        ["first order only", "Two things can be added", "sign(0)", "Right is", "always the same"]
    {
        assert!(!whole.contains(answer), "{answer}");
    }
}
