//! Which friction is it? Three motions, and what tells them apart.

use federpendel::{Motion, Result, State, even_times};
use federpendel_text::plot::{Course, CoursesData, Losses, LossesData, Plot, Role};

use crate::article::figure::amplitudes;
use crate::article::writer::Writer;
use crate::article::{Case, Checks, Laboratory};
use crate::document::{Block, Row, Section};

/// Periods that are shown of the three motions.
const PERIODS: f64 = 8.0;

/// The laws in the order of this section.
const ROLES: [Role; 3] = [Role::Coulomb, Role::Stokes, Role::Newton];

/// Samples of a curve.
const SAMPLES: usize = 801;

pub fn section(writer: &Writer<'_>, laboratory: &Laboratory, checks: &Checks) -> Result<Section> {
    let cases = released_alike(laboratory)?;
    let names = ["coulomb", "stokes", "newton"]
        .map(|law| writer.catalogue.text(&format!("article-law-{law}")));
    let motions = motions(writer, &cases, &names)?;
    let mut blocks = writer.explain("article-which-text", Vec::new);
    blocks.extend([motions, losses(writer, &cases, &names)]);
    blocks.extend(writer.unless_blank(|| table(writer, &cases, &names)));
    blocks.push(writer.claims(&checks.decrement));
    Ok(writer.section("which", blocks, vec![]))
}

/// The three laws from the same rest.
fn released_alike(laboratory: &Laboratory) -> Result<[Case; 3]> {
    let from = laboratory.coulomb.release().position;
    let alike =
        |case: &Case| Ok(Case::on(Motion::new(*case.oscillator(), State::new(from, 0.0)?)?));
    Ok([alike(&laboratory.coulomb)?, alike(&laboratory.stokes)?, alike(&laboratory.newton)?])
}

fn motions(writer: &Writer<'_>, cases: &[Case; 3], names: &[String; 3]) -> Result<Block> {
    let period = 2.0 * std::f64::consts::PI / cases[0].oscillator().angular_frequency();
    let times = even_times(PERIODS * period, SAMPLES)?;
    let mut curves = Vec::new();
    for case in cases {
        let samples = case.motion.samples(&times)?;
        curves.push(samples.iter().map(|sample| sample.position).collect::<Vec<f64>>());
    }
    let title = writer.catalogue.text("article-which-motions-figure");
    let courses: Vec<_> = names
        .iter()
        .zip(&curves)
        .zip(ROLES)
        .map(|((name, positions), role)| Course { name, role, times: &times, positions })
        .collect();
    Ok(Block::Figure {
        id: "figure-which".to_owned(),
        plots: vec![Plot::courses(
            writer.catalogue,
            &CoursesData { title: &title, curves: &courses },
        )],
        caption: writer.catalogue.text("article-which-motions-figure"),
    })
}

fn losses(writer: &Writer<'_>, cases: &[Case; 3], names: &[String; 3]) -> Block {
    let amplitudes = cases.each_ref().map(amplitudes);
    let losses: Vec<_> = cases
        .iter()
        .zip(names)
        .zip(&amplitudes)
        .zip(ROLES)
        .map(|(((case, name), amplitudes), role)| Losses {
            name,
            role,
            oscillator: case.oscillator(),
            amplitudes,
        })
        .collect();
    Block::Figure {
        id: "figure-losses".to_owned(),
        plots: vec![Plot::losses(writer.catalogue, &LossesData { motions: &losses })],
        caption: writer.catalogue.text(
            writer.either("article-which-losses-figure", "article-which-losses-blank-figure"),
        ),
    }
}

fn table(writer: &Writer<'_>, cases: &[Case; 3], names: &[String; 3]) -> Block {
    let text = |id: &str| writer.catalogue.text(id);
    let formulas = [r"$2f$", r"$(\pi\gamma/\omega_0) A$", r"$\frac{4}{3}\kappa A^2$"];
    let decays = ["article-which-linear", "article-which-exponential", "article-which-hyperbolic"];
    let rows = cases.iter().zip(names).zip(formulas.iter().zip(decays)).map(
        |((case, name), (formula, decay))| {
            let first =
                amplitudes(case).windows(2).next().map(|pair| pair[0].abs() - pair[1].abs());
            let lost = first
                .map_or_else(|| "–".to_owned(), |loss| writer.catalogue.quantity(loss, "m", 4));
            vec![name.clone(), (*formula).to_owned(), text(decay), lost]
        },
    );
    Block::Table {
        caption: text("article-which-table"),
        head: ["law", "loss", "decay", "measured"]
            .map(|head| text(&format!("article-which-head-{head}")))
            .to_vec(),
        rows: rows.map(Row::from).collect(),
    }
}
