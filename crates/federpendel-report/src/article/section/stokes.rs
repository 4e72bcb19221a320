//! Section 2: Stokes friction.

use federpendel::article::eq_46;
use federpendel::{Motion, Result, even_times};
use federpendel_text::plot::{Course, CoursesData, Plot, Role, RootsData};

use super::{forces, numbered};
use crate::article::figure::{self, Look};
use crate::article::writer::Writer;
use crate::article::{Case, Checks, Laboratory};
use crate::document::{Block, Section};
use crate::sketch::Law;

/// γ/ω0 of the motion below critical damping.
const BELOW: f64 = 0.15;

pub fn section(writer: &Writer<'_>, laboratory: &Laboratory, checks: &Checks) -> Result<Section> {
    let case = &laboratory.stokes;
    let analytic = writer.section(
        "stokes-analytic",
        vec![
            writer.say("article-stokes-roots-text"),
            numbered("35", r"\lambda^2 + \frac{D}{m} \lambda + \omega_0^2 = 0"),
            numbered("36", r"\lambda_{1,2} = -\frac{D}{2m} \pm \sqrt{\frac{D^2}{4m^2} - \omega_0^2}"),
            roots(writer, case),
            writer.say("article-stokes-solution-text"),
            numbered(
                "46",
                r"x = e^{-\gamma t} \left( x_0 \cos(\omega t) + \frac{v_0 + \gamma x_0}{\omega} \sin(\omega t) \right)",
            ),
            numbered("47", r"\gamma = \frac{D}{2m}, \qquad \omega = \sqrt{\omega_0^2 - \frac{D^2}{4m^2}}"),
            regimes(writer, case)?,
            writer.claims(&checks.stokes),
        ],
        vec![],
    );
    let numeric = writer.section(
        "stokes-numeric",
        vec![
            writer.say("article-stokes-scheme-text"),
            numbered("48", r"\dot{x} \approx \frac{x_i - x_{i-1}}{\Delta t}"),
            numbered("49", r"\ddot{x} \approx \frac{x_{i+1} - 2x_i + x_{i-1}}{\Delta t^2}"),
            numbered(
                "51",
                r"x_{i+1} = 2x_i - x_{i-1} - \Delta t^2 \left( \frac{D}{m} \frac{x_i - x_{i-1}}{\Delta t} + \frac{C}{m} x_i \right)",
            ),
            numbered(
                "54",
                r"x_1 = x_0 + v_0 \Delta t - \frac{\Delta t^2}{2} \left( \frac{D}{m} v_0 + \frac{C}{m} x_0 \right)",
            ),
            graph(writer, case)?,
            writer.claims(&checks.quotients),
        ],
        vec![],
    );
    let blocks = vec![
        writer.say("article-stokes-text"),
        forces(writer, case, Law::Stokes, "sketch-stokes"),
        numbered("30", r"\ddot{x} + \frac{D}{m} \dot{x} + \frac{C}{m} x = 0"),
    ];
    Ok(writer.section("stokes", blocks, vec![analytic, numeric]))
}

fn roots(writer: &Writer<'_>, case: &Case) -> Block {
    let oscillator = case.oscillator();
    let data =
        RootsData { omega0: oscillator.angular_frequency(), gamma: oscillator.damping_rate() };
    Block::Figure {
        id: "figure-roots".to_owned(),
        plots: vec![Plot::roots(writer.catalogue, &data)],
        caption: writer.catalogue.text("article-stokes-roots-figure"),
    }
}

/// The three regimes of the same mass and spring.
fn regimes(writer: &Writer<'_>, case: &Case) -> Result<Block> {
    let duration = 6.0 * std::f64::consts::PI / case.oscillator().angular_frequency();
    let times = even_times(duration, 601)?;
    let ratio = writer.catalogue.number(BELOW, 2).into();
    let names = [
        (BELOW, writer.catalogue.format("article-stokes-regime-below", &[("ratio", ratio)])),
        (1.0, writer.catalogue.text("article-stokes-regime-critical")),
        (2.0, writer.catalogue.text("article-stokes-regime-above")),
    ];
    let mut curves = Vec::new();
    for (ratio, name) in names {
        let motion = Motion::new(case.damped(ratio)?, case.release())?;
        let samples = motion.samples(&times)?;
        curves.push((name, samples.iter().map(|sample| sample.position).collect::<Vec<f64>>()));
    }
    let courses: Vec<_> = curves
        .iter()
        .enumerate()
        .map(|(n, (name, positions))| Course {
            name,
            role: Role::Comparison(n),
            times: &times,
            positions,
        })
        .collect();
    let title = writer.catalogue.text("article-stokes-regimes-figure");
    Ok(Block::Figure {
        id: "figure-regimes".to_owned(),
        plots: vec![Plot::courses(
            writer.catalogue,
            &CoursesData { title: &title, curves: &courses },
        )],
        caption: writer.catalogue.text("article-stokes-regimes-figure"),
    })
}

/// The article's graph: formula and scheme over the motion.
fn graph(writer: &Writer<'_>, case: &Case) -> Result<Block> {
    let times = figure::times(case)?;
    let name = |id: &str| writer.catalogue.text(id);
    let formula = eq_46(case.oscillator(), case.release()).ok();
    let curves: Vec<_> = formula
        .map(|formula| figure::formula(name("article-name-46"), Look::Printed, &formula, &times))
        .into_iter()
        .chain(figure::scheme(name("article-name-51"), case, &times))
        .collect();
    let step = ("step", writer.time(case.setting().time_step()));
    let with_step: Vec<_> = writer.release(case).into_iter().chain([step]).collect();
    Ok(Block::Figure {
        id: "figure-stokes".to_owned(),
        plots: figure::beside(writer, case, &curves)?,
        caption: writer.catalogue.format("article-stokes-figure", &with_step),
    })
}
