//! How wrong is the simple scheme? Its order, what it does at rest, and a method that sticks.

use federpendel::scheme::{self, Setting};
use federpendel::{Outcome, Result, State, even_times, lens};
use federpendel_text::plot::{ConvergenceData, MethodCurve, MethodRungs, OverlayData, Plot};

use crate::article::measure::{article_scheme, later};
use crate::article::writer::Writer;
use crate::article::{Case, Laboratory};
use crate::document::{Block, Row, Section};

/// Samples of the motion after the rest.
const SAMPLES: usize = 2001;

/// Rests that the time after the rest lasts.
const AFTER: f64 = 3.0;

pub fn section(writer: &Writer<'_>, laboratory: &Laboratory) -> Result<Section> {
    let mut blocks = writer.explain("article-scheme-order-text", Vec::new);
    blocks.extend(order(writer, laboratory));
    blocks.extend(writer.explain("article-scheme-rest-text", Vec::new));
    blocks.extend(rest(writer, &laboratory.coulomb)?);
    Ok(writer.section("scheme", blocks, vec![]))
}

/// Errors over six halvings of the step, without friction and with each law, beside the order that the backward
/// quotient (48) leaves.
fn order(writer: &Writer<'_>, laboratory: &Laboratory) -> Vec<Block> {
    let scheme = article_scheme();
    let cases = [
        ("none", 2, &laboratory.undamped),
        ("stokes", 1, &laboratory.stokes),
        ("coulomb", 1, &laboratory.coulomb),
        ("newton", 1, &laboratory.newton),
    ];
    let found = cases.map(|(name, order, case)| {
        let ladder = lens::ladder(&case.motion, scheme, &case.setting(), case.duration);
        (writer.catalogue.text(&format!("article-scheme-name-{name}")), order, ladder)
    });
    let methods: Vec<_> = found
        .iter()
        .enumerate()
        .map(|(number, (name, order, ladder))| MethodRungs {
            name,
            number,
            order: *order,
            rungs: &ladder.rungs,
        })
        .collect();
    let mix = laboratory.own.oscillator().friction().mix();
    let mut plot = Plot::convergence(writer.catalogue, &ConvergenceData { mix, methods: &methods });
    // Its title speaks of one experiment; here there is one for each law.
    let title = writer.catalogue.text("article-scheme-order-title");
    plot.description = plot.description.replace(&plot.title, &title);
    plot.title = title;
    let figure = Block::Figure {
        id: "figure-order".to_owned(),
        plots: vec![plot],
        caption: writer.catalogue.text("article-scheme-order-figure"),
    };
    let none = || "–".to_owned();
    let rows = found.iter().map(|(name, _, ladder)| {
        let order = ladder.order().map_or_else(none, |order| one_decimal(writer, order));
        let last = ladder.rungs.last();
        let error = last.map_or_else(none, |rung| writer.catalogue.quantity(rung.error, "m", 2));
        vec![name.clone(), order, error]
    });
    let text = |id: &str| writer.catalogue.text(id);
    let table = Block::Table {
        caption: text("article-scheme-table"),
        head: ["friction", "order", "error"]
            .map(|head| text(&format!("article-scheme-head-{head}")))
            .to_vec(),
        rows: rows.map(Row::from).collect(),
    };
    vec![figure, table]
}

/// An order with its first decimal, also where that is zero.
fn one_decimal(writer: &Writer<'_>, order: f64) -> String {
    format!("{order:.1}").replace('.', &writer.catalogue.language().decimal_sign().to_string())
}

/// The scheme and Moreau–Jean time stepping after the rest; nothing if the mass never rests or never moves.
fn rest(writer: &Writer<'_>, case: &Case) -> Result<Vec<Block>> {
    let Outcome::Rests(rest) = case.motion.outcome() else { return Ok(Vec::new()) };
    let Some(moreau_jean) = scheme::named("moreau-jean").filter(|_| rest.time > 0.0) else {
        return Ok(Vec::new());
    };
    let setting = case.setting();
    let times = even_times(AFTER * rest.time, SAMPLES)?;
    let methods =
        [(article_scheme(), "article-scheme-own"), (moreau_jean, "article-scheme-moreau")];
    let mut curves = Vec::new();
    for (method, id) in methods {
        let course = follow(method, &setting, &times);
        curves.extend(course.map(|positions| (method, writer.catalogue.text(id), positions)));
    }
    let mut blocks = vec![picture(writer, case, &times, &curves)?];
    blocks.push(table(writer, case, rest.position, &curves)?);
    Ok(blocks)
}

type Followed = (&'static scheme::Scheme, String, Vec<f64>);

fn follow(scheme: &scheme::Scheme, setting: &Setting, times: &[f64]) -> Option<Vec<f64>> {
    let mut course = lens::Course::new(scheme, setting).ok()?;
    let at = |time: &f64| course.at(*time).map(|state: State| state.position);
    times.iter().map(at).collect::<Result<Vec<f64>>>().ok()
}

fn picture(writer: &Writer<'_>, case: &Case, times: &[f64], curves: &[Followed]) -> Result<Block> {
    let samples = case.motion.samples(times)?;
    let positions: Vec<f64> = samples.iter().map(|sample| sample.position).collect();
    let methods: Vec<_> = curves
        .iter()
        .enumerate()
        .map(|(number, (_, name, positions))| MethodCurve { name, number, times, positions })
        .collect();
    let oscillator = case.oscillator();
    let turning_points: Vec<_> = case.motion.turning_points().collect();
    let plot = Plot::after_rest(
        writer.catalogue,
        &OverlayData {
            mix: oscillator.friction().mix(),
            kind: case.motion.kind(),
            times,
            positions: &positions,
            turning_points: &turning_points,
            outcome: &case.motion.outcome(),
            sticking_offset: oscillator.sticking_offset(),
            methods: &methods,
        },
    );
    let step = writer.time(case.setting().time_step());
    Ok(Block::Figure {
        id: "figure-rest".to_owned(),
        plots: vec![plot],
        caption: writer.catalogue.format("article-scheme-rest-figure", &[("step", step)]),
    })
}

fn table(writer: &Writer<'_>, case: &Case, place: f64, curves: &[Followed]) -> Result<Block> {
    let text = |id: &str| writer.catalogue.text(id);
    let length = |value: f64| writer.catalogue.quantity(value, "m", 4);
    let speed = |value: f64| writer.catalogue.quantity(value, "m/s", 2);
    let (time, setting) = (later(case), case.setting());
    let yes = |yes: bool| text(if yes { "article-yes" } else { "article-no" });
    let mut rows = vec![vec![text("article-scheme-motion"), length(place), yes(true), speed(0.0)]];
    for (method, name, _) in curves {
        let there = follow(method, &setting, &[time]);
        let there = there.map_or_else(|| "–".to_owned(), |positions| length(positions[0]));
        let ending = lens::ending(&case.motion, method, &setting)?;
        let rests = ending.map_or_else(|| "–".to_owned(), |ending| yes(ending.sticks));
        let creep = ending.and_then(|ending| ending.creep);
        let creep = creep.map_or_else(|| "–".to_owned(), speed);
        rows.push(vec![name.clone(), there, rests, creep]);
    }
    let place =
        writer.catalogue.format("article-scheme-head-place", &[("time", writer.time(time))]);
    Ok(Block::Table {
        caption: text("article-scheme-rest-table"),
        head: vec![
            text("article-scheme-head-method"),
            place,
            text("article-scheme-head-rests"),
            text("article-scheme-head-creep"),
        ],
        rows: rows.into_iter().map(Row::from).collect(),
    })
}
