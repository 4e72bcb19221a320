//! Section 4: Newton friction.

use federpendel::Result;

use super::{forces, numbered, unnumbered};
use crate::article::figure;
use crate::article::writer::Writer;
use crate::article::{Checks, Laboratory};
use crate::document::{Block, Section};
use crate::sketch::{self, Law};

pub fn section(writer: &Writer<'_>, laboratory: &Laboratory, checks: &Checks) -> Result<Section> {
    let case = &laboratory.newton;
    let times = figure::times(case)?;
    let curves: Vec<_> = figure::scheme(writer.catalogue.text("article-name-85"), case, &times)
        .into_iter()
        .collect();
    let step = ("step", writer.time(case.setting().time_step()));
    let with_step: Vec<_> = writer.release(case).into_iter().chain([step]).collect();
    let graph = Block::Figure {
        id: "figure-newton".to_owned(),
        plots: figure::beside(writer, case, &curves)?,
        caption: writer.catalogue.format("article-newton-figure", &with_step),
    };
    let decrement = Block::Figure {
        id: "figure-newton-decrement".to_owned(),
        plots: vec![figure::decrement(writer, case)],
        caption: writer.catalogue.text("article-newton-decrement-figure"),
    };
    let mut blocks = vec![
        writer.say("article-newton-text"),
        forces(writer, case, Law::Newton, "sketch-newton"),
        Block::Sketch {
            id: "sketch-stream".to_owned(),
            svg: sketch::stream("sketch-stream", writer.catalogue),
            caption: writer.catalogue.text("article-newton-sketch"),
        },
        numbered(
            "83",
            r"\ddot{x} + \frac{C}{m} x = -\operatorname{sign}(\dot{x})\, \frac{1}{2m} \rho c_w A \dot{x}^2",
        ),
        writer.say("article-newton-scheme-text"),
        numbered(
            "85",
            r"x_{i+1} = 2x_i - x_{i-1} - \Delta t^2 \left( \frac{C}{m} x_i + \operatorname{sign}\!\left(\frac{x_i - x_{i-1}}{\Delta t}\right) \frac{1}{2m} \rho c_w A \left(\frac{x_i - x_{i-1}}{\Delta t}\right)^2 \right)",
        ),
        numbered(
            "86",
            r"x_1 = x_0 + v_0 \Delta t - \frac{\Delta t^2}{2} \left( \frac{C}{m} x_0 + \operatorname{sign}(v_0)\, \frac{1}{2m} \rho c_w A v_0^2 \right)",
        ),
    ];
    blocks.extend(writer.explain("article-newton-known-text", || {
        vec![unnumbered(
            r"\kappa = \frac{\rho c_w A}{2m}, \qquad |x_{n+1}| = \frac{1 + W_0\!\left( -(1 + 2\kappa |x_n|)\, e^{-(1 + 2\kappa |x_n|)} \right)}{2\kappa}",
        )]
    }));
    blocks.extend([graph, decrement, writer.claims(&checks.newton)]);
    Ok(writer.section("newton", blocks, vec![]))
}
