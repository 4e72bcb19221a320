//! Section 1: no friction, solved on two routes.

use federpendel::Result;
use federpendel::article::{ComplexForm, eq_20};

use super::{forces, numbered};
use crate::article::figure::{self, Look};
use crate::article::writer::Writer;
use crate::article::{Checks, Laboratory};
use crate::document::{Block, Section};
use crate::sketch::Law;

pub fn section(writer: &Writer<'_>, laboratory: &Laboratory, checks: &Checks) -> Result<Section> {
    let trigonometric = writer.section(
        "trigonometric",
        vec![
            writer.say("article-trigonometric-text"),
            numbered("16", r"\omega_0 = \pm\sqrt{\frac{C}{m}}"),
            numbered("20", r"x = x_0 \cos(\omega_0 t) + \frac{v_0}{\omega_0} \sin(\omega_0 t)"),
        ],
        vec![],
    );
    let exponential = writer.section(
        "exponential",
        vec![
            writer.say("article-exponential-text"),
            numbered("24", r"\lambda_{1,2} = \pm\sqrt{\frac{C}{m}}\, i = \pm\omega_0 i"),
            numbered("25", r"x = \tilde{C}_1 e^{i\omega_0 t} + \tilde{C}_2 e^{-i\omega_0 t}"),
            numbered(
                "27",
                r"\phantom{x} = (\tilde{C}_1 + \tilde{C}_2) \cos(\omega_0 t) + i (\tilde{C}_1 - \tilde{C}_2) \sin(\omega_0 t)",
            ),
            numbered("28", r"\phantom{x} = C_1 \cos(\omega_0 t) + C_2 \sin(\omega_0 t)"),
            figure(writer, laboratory)?,
            writer.claims(&checks.undamped),
        ],
        vec![],
    );
    let blocks = vec![
        writer.say("article-undamped-text"),
        forces(writer, &laboratory.undamped, Law::None, "sketch-undamped"),
        numbered("2", r"m \ddot{x} = -C x"),
        numbered("3", r"\ddot{x} + \frac{C}{m} x = 0"),
    ];
    Ok(writer.section("undamped", blocks, vec![trigonometric, exponential]))
}

fn figure(writer: &Writer<'_>, laboratory: &Laboratory) -> Result<Block> {
    let case = &laboratory.undamped;
    let times = figure::times(case)?;
    let real = eq_20(case.oscillator(), case.release())?;
    let complex = ComplexForm::new(case.oscillator(), case.release())?;
    let name = |id: &str| writer.catalogue.text(id);
    let curves = [
        figure::formula(name("article-name-20"), Look::Printed, &real, &times),
        figure::curve(name("article-name-25"), Look::Corrected, &times, |t| complex.eq_25(t).re),
    ];
    Ok(Block::Figure {
        id: "figure-undamped".to_owned(),
        plots: figure::beside(writer, case, &curves)?,
        caption: writer.catalogue.format("article-undamped-figure", &writer.release(case)),
    })
}
