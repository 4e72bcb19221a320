//! Section 3: Coulomb friction.

use federpendel::article::{Reading, eq_61, eq_69, eq_78, eq_79};
use federpendel::{Result, State};
use federpendel_text::plot::Plot;

use super::{forces, numbered, unnumbered};
use crate::article::figure::{self, Look};
use crate::article::measure::turning_points;
use crate::article::writer::Writer;
use crate::article::{Case, Checks, Laboratory};
use crate::document::{Block, Section};
use crate::sketch::{self, Law};

/// The motion from one turning point to the next, released from rest at x0 > 0: PHYSICS of the crate `federpendel`, its
/// linear swing without Stokes friction.
const SWING: &str = r"x = (-1)^n \left[ f + \bigl( x_0 - (2n + 1) f \bigr) \cos(\omega_0 t - n\pi) \right], \qquad n \frac{T}{2} \le t \le (n + 1) \frac{T}{2}, \qquad f = \frac{\mu F_N}{C}";

pub fn section(writer: &Writer<'_>, laboratory: &Laboratory, checks: &Checks) -> Result<Section> {
    let mut blocks = vec![
        writer.say("article-coulomb-text"),
        forces(writer, &laboratory.coulomb, Law::Coulomb, "sketch-coulomb"),
        numbered("57", r"\ddot{x} + \frac{C}{m} x = -\operatorname{sign}(\dot{x})\, \mu g"),
    ];
    if laboratory.coulomb.motion.turning_points().next().is_none() {
        blocks.push(writer.notice("article-coulomb-stuck", &[]));
    }
    let sections = vec![
        scheme(writer, &laboratory.coulomb, checks)?,
        from_rest(writer, &laboratory.coulomb, checks)?,
        thrown(writer, laboratory, checks)?,
    ];
    Ok(writer.section("coulomb", blocks, sections))
}

fn scheme(writer: &Writer<'_>, case: &Case, checks: &Checks) -> Result<Section> {
    let times = figure::times(case)?;
    let curves: Vec<_> = figure::scheme(writer.catalogue.text("article-name-59"), case, &times)
        .into_iter()
        .collect();
    let step = writer.time(case.setting().time_step());
    let blocks = vec![
        writer.say("article-coulomb-scheme-text"),
        numbered(
            "59",
            r"x_{i+1} = 2x_i - x_{i-1} - \Delta t^2 \left( \frac{C}{m} x_i + \operatorname{sign}\!\left(\frac{x_i - x_{i-1}}{\Delta t}\right) \mu g \right)",
        ),
        numbered(
            "60",
            r"x_1 = x_0 + v_0 \Delta t - \frac{\Delta t^2}{2} \left( \frac{C}{m} x_0 + \operatorname{sign}(v_0)\, \mu g \right)",
        ),
        Block::Figure {
            id: "figure-coulomb-scheme".to_owned(),
            plots: figure::beside(writer, case, &curves)?,
            caption: writer.catalogue.format("article-coulomb-scheme-figure", &[("step", step)]),
        },
        writer.claims(&checks.coulomb_scheme),
    ];
    Ok(writer.section("coulomb-scheme", blocks, vec![]))
}

fn from_rest(writer: &Writer<'_>, case: &Case, checks: &Checks) -> Result<Section> {
    let mut blocks = vec![
        writer.say("article-coulomb-energy-text"),
        numbered("61", r"x = (x_0 - v_A t) \cos(\omega_0 t)"),
    ];
    blocks.extend(energy_sketch(writer, case));
    blocks.extend([
        numbered("64", r"F_R x_0 + F_R x_1 = \tfrac{1}{2} C x_0^2 - \tfrac{1}{2} C x_1^2"),
        numbered("67", r"\Delta x = \frac{2\mu m g}{C}"),
        Block::Figure {
            id: "figure-envelope".to_owned(),
            plots: vec![figure::motion(writer, case)?],
            caption: writer.catalogue.text("article-coulomb-envelope-figure"),
        },
        writer.say("article-coulomb-formula-text"),
        numbered(
            "68",
            r"v_A = \frac{\Delta x}{\frac{T}{2}} = \frac{\frac{2\mu m g}{C}}{2\pi\sqrt{\frac{m}{C}}} = \frac{2\mu m g}{\pi} \sqrt{\frac{C}{m}}",
        ),
        numbered("69", r"x = \left( x_0 - \frac{2\mu m g}{\pi}\, \omega_0 t \right) \cos(\omega_0 t)"),
        graph_from_rest(writer, case)?,
    ]);
    blocks.extend(writer.explain("article-coulomb-right-text", || vec![unnumbered(SWING)]));
    blocks.push(writer.claims(&checks.coulomb_rest));
    Ok(writer.section("coulomb-rest", blocks, vec![]))
}

/// The energy argument for the first swing; none if the mass stays where it is.
fn energy_sketch(writer: &Writer<'_>, case: &Case) -> Option<Block> {
    let turn = turning_points(&case.motion, 1)?[0];
    let oscillator = case.oscillator();
    let energy = |position: f64| {
        let energy = oscillator.potential_energy(State { position, velocity: 0.0 });
        writer.catalogue.quantity(energy, "J", 4)
    };
    let start = case.release().position;
    let force = oscillator.offset() * oscillator.stiffness();
    let work = force * (turn.position - start).abs();
    let numbers = sketch::Given {
        start: writer.catalogue.quantity(start.abs(), "m", 4),
        turn: writer.catalogue.quantity(turn.position.abs(), "m", 4),
        start_energy: energy(start),
        turn_energy: energy(turn.position),
        work: writer.catalogue.quantity(work, "J", 4),
    };
    let mut caption = writer.catalogue.text("article-coulomb-energy-sketch");
    if start < 0.0 {
        caption = format!("{caption} {}", writer.catalogue.text("article-coulomb-energy-mirrored"));
    }
    Some(Block::Sketch {
        id: "sketch-energy".to_owned(),
        svg: sketch::loss("sketch-energy", &numbers, writer.catalogue),
        caption,
    })
}

fn graph_from_rest(writer: &Writer<'_>, case: &Case) -> Result<Block> {
    Ok(Block::Figure {
        id: "figure-coulomb".to_owned(),
        plots: plots_from_rest(writer, case)?,
        caption: writer.catalogue.text("article-coulomb-figure"),
    })
}

/// Release from rest: the motion, both readings of the formula, and the scheme; and their errors.
pub fn plots_from_rest(writer: &Writer<'_>, case: &Case) -> Result<Vec<Plot>> {
    let times = figure::times(case)?;
    let (oscillator, from) = (case.oscillator(), case.release().position);
    let name = |id: &str| writer.catalogue.text(id);
    let printed = eq_69(oscillator, from, Reading::Printed)?;
    let corrected = eq_61(oscillator, from, Reading::Corrected)?;
    let mut curves = vec![
        figure::formula(name("article-name-69"), Look::Printed, &printed, &times),
        figure::formula(name("article-name-61"), Look::Corrected, &corrected, &times),
    ];
    curves.extend(figure::scheme(name("article-name-59"), case, &times));
    figure::beside(writer, case, &curves)
}

fn thrown(writer: &Writer<'_>, laboratory: &Laboratory, checks: &Checks) -> Result<Section> {
    let mut blocks = vec![
        writer.say("article-coulomb-thrown-text"),
        numbered(
            "72",
            r"x_0 \cos(\omega_0 t) + \frac{v_0}{\omega_0} \sin(\omega_0 t) = A \sin(\omega_0 t + \varphi)",
        ),
        numbered("76", r"A = \sqrt{x_0^2 + \left(\frac{v_0}{\omega_0}\right)^2}"),
        numbered("77", r"\varphi = \arctan\left(\frac{x_0 \omega_0}{v_0}\right)"),
        numbered("78", r"x = (A - v_A t) \sin(\omega_0 t + \varphi)"),
    ];
    for (case, id) in laboratory.thrown.iter().zip(["figure-thrown-back", "figure-thrown-on"]) {
        blocks.push(graph_thrown(writer, case, id)?);
    }
    blocks.push(writer.claims(&checks.coulomb_thrown));
    Ok(writer.section("coulomb-thrown", blocks, vec![]))
}

fn graph_thrown(writer: &Writer<'_>, case: &Case, id: &str) -> Result<Block> {
    let times = figure::times(case)?;
    let (oscillator, release) = (case.oscillator(), case.release());
    let name = |id: &str| writer.catalogue.text(id);
    let printed = eq_79(oscillator, release, Reading::Printed)?;
    let corrected = eq_78(oscillator, release, Reading::Corrected)?;
    let mut curves = vec![
        figure::formula(name("article-name-79"), Look::Printed, &printed, &times),
        figure::formula(name("article-name-78"), Look::Corrected, &corrected, &times),
    ];
    curves.extend(figure::scheme(name("article-name-59"), case, &times));
    Ok(Block::Figure {
        id: id.to_owned(),
        plots: figure::beside(writer, case, &curves)?,
        caption: writer.catalogue.format("article-coulomb-forward-figure", &writer.release(case)),
    })
}
