//! The mass on a horizontal guide, with the forces on it.

use federpendel_text::Catalogue;

use super::body::{MASS, ground, mass, spring};
use super::pen::{Anchor, Pen, Said};

/// What slows the mass.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Law {
    /// Nothing.
    None,
    /// A viscous fluid around it.
    Stokes,
    /// The guide.
    Coulomb,
    /// A fluid that swirls around it.
    Newton,
}

/// The side to which the mass is displaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// The spring is compressed.
    Left,
    /// The spring is stretched.
    Right,
}

const SIZE: (f64, f64) = (640.0, 282.0);
const WALL: f64 = 50.0;
const FLOOR: f64 = 174.0;
/// Where the middle of the mass is when the spring is relaxed.
const RELAXED: f64 = 330.0;
/// Where the wall and the fluid end.
const CEILING: f64 = 12.0;
/// Where the guide and the axis end.
const END: f64 = 610.0;
const DISPLACEMENT: f64 = 110.0;
const AXIS: f64 = 238.0;

/// The mass, displaced to `side` and on its way back: spring force, weight, normal force, and the friction of `law`,
/// which dry friction exerts where the mass touches the guide and a fluid on the body. Ids begin with `id`.
pub fn guide(id: &str, law: Law, side: Side, catalogue: &Catalogue) -> String {
    let mut pen = Pen::default();
    // Towards the relaxed position.
    let back = if side == Side::Right { -1.0 } else { 1.0 };
    let x = RELAXED - back * DISPLACEMENT;
    if matches!(law, Law::Stokes | Law::Newton) {
        pen.group("fluid", |pen| {
            pen.outline(&[(WALL, CEILING), (END, CEILING), (END, FLOOR), (WALL, FLOOR)]);
        });
    }
    axis(&mut pen, x);
    ground(&mut pen, (WALL, FLOOR), FLOOR - CEILING, END);
    spring(&mut pen, WALL, x - MASS.0, FLOOR - 28.0);
    mass(&mut pen, (x, FLOOR));
    upright_forces(&mut pen, x);
    sideways_forces(&mut pen, x, back, law);
    pen.finish(id, SIZE, &says(law, side, catalogue))
}

/// The axis below the guide, with the relaxed position and that of the mass.
fn axis(pen: &mut Pen, x: f64) {
    pen.group("thin", |pen| {
        pen.arrow((WALL, AXIS), (END, AXIS));
        pen.line(&[(RELAXED, AXIS - 5.0), (RELAXED, AXIS + 5.0)]);
        pen.line(&[(x, AXIS - 5.0), (x, AXIS + 5.0)]);
    });
    pen.group("guideline", |pen| pen.line(&[(RELAXED, CEILING), (RELAXED, AXIS)]));
    pen.label((RELAXED, AXIS + 26.0), Anchor::Middle, "0");
    pen.label((x, AXIS + 26.0), Anchor::Middle, "$x_0$");
    pen.label((END, AXIS + 26.0), Anchor::End, "$x$");
}

fn upright_forces(pen: &mut Pen, x: f64) {
    let length = 84.0;
    pen.group("force weight", |pen| {
        let middle = FLOOR - 0.5 * MASS.1;
        pen.circle((x, middle), 2.5);
        pen.arrow((x, middle), (x, middle + length));
        pen.label((x + 9.0, middle + length - 2.0), Anchor::Start, "$F_G$");
        // Beside the weight, so that both are seen.
        pen.arrow((x - 14.0, FLOOR), (x - 14.0, FLOOR - length - 34.0));
        pen.label((x - 22.0, FLOOR - length - 20.0), Anchor::End, "$F_N$");
    });
}

fn sideways_forces(pen: &mut Pen, x: f64, back: f64, law: Law) {
    let edge = |side: f64| x + side * MASS.0;
    let outside = if back < 0.0 { Anchor::End } else { Anchor::Start };
    let middle = FLOOR - 0.5 * MASS.1;
    pen.group("force elastic", |pen| {
        pen.arrow((x, middle), (x + back * 118.0, middle));
        pen.label((edge(back) + back * 10.0, middle - 10.0), outside, "$F_F$ = −$Cx$");
    });
    pen.group("velocity", |pen| {
        let (height, from) = (FLOOR - MASS.1 - 46.0, x + back * 30.0);
        pen.arrow((from, height), (from + back * 60.0, height));
        pen.label((from + back * 30.0, height - 9.0), Anchor::Middle, "$v$");
    });
    let (from, height, label) = match law {
        Law::None => return,
        // Where mass and guide touch, just above the line of the guide.
        Law::Coulomb => (x, FLOOR - 4.0, FLOOR + 26.0),
        Law::Stokes | Law::Newton => (edge(-back), middle, middle - 11.0),
    };
    let against = if back < 0.0 { Anchor::Start } else { Anchor::End };
    pen.group("force friction", |pen| {
        pen.arrow((from, height), (edge(-back) - back * 62.0, height));
        pen.label((edge(-back) - back * 26.0, label), against, "$F_R$");
    });
}

fn says(law: Law, side: Side, catalogue: &Catalogue) -> Said {
    let law = match law {
        Law::None => "none",
        Law::Stokes => "stokes",
        Law::Coulomb => "coulomb",
        Law::Newton => "newton",
    };
    let side = match side {
        Side::Left => "left",
        Side::Right => "right",
    };
    let variables = [("law", law.into()), ("side", side.into())];
    Said {
        title: catalogue.format("sketch-guide", &variables[..1]),
        description: catalogue.format("sketch-guide.description", &variables),
    }
}
