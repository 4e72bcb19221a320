//! What dry friction costs in one swing.

use federpendel_text::Catalogue;

use super::body::{MASS, ground, mass, spring};
use super::pen::{Anchor, Pen, Said};

/// Values that stand in the drawing, with their units.
#[derive(Debug, Clone)]
pub struct Given {
    /// The displacement at release.
    pub start: String,
    /// How far the mass gets on the other side.
    pub turn: String,
    /// Energy of the spring at release.
    pub start_energy: String,
    /// Energy of the spring on the other side.
    pub turn_energy: String,
    /// The work of friction on the way.
    pub work: String,
}

const SIZE: (f64, f64) = (730.0, 456.0);
const WALL: f64 = 50.0;
const END: f64 = 680.0;
const RELAXED: f64 = 310.0;
/// Displacements of the mass. Friction takes more here than it does as a rule, so that it is seen.
const START: f64 = 150.0;
const TURN: f64 = -105.0;
/// Heights of the guide at the start and at the turning point.
const FLOORS: [f64; 2] = [148.0, 400.0];
/// Where there is room beside the mass in either place.
const BESIDE: f64 = 520.0;
const WAY: f64 = 206.0;

/// The mass at release and half a period later at its turning point, with the energies of the spring there
/// and the work of friction along the way. Ids begin with `id`.
pub fn loss(id: &str, given: &Given, catalogue: &Catalogue) -> String {
    let mut pen = Pen::default();
    for x in [RELAXED + START, RELAXED, RELAXED + TURN] {
        pen.group("guideline", |pen| pen.line(&[(x, 30.0), (x, FLOORS[1] + 44.0)]));
    }
    for (floor, displacement) in FLOORS.into_iter().zip([START, TURN]) {
        ground(&mut pen, (WALL, floor), 100.0, END);
        spring(&mut pen, WALL, RELAXED + displacement - MASS.0, floor - 28.0);
        mass(&mut pen, (RELAXED + displacement, floor));
    }
    way(&mut pen, given);
    displacement(&mut pen, START, 24.0, &format!("$x_0$ = {}", given.start));
    displacement(&mut pen, TURN, FLOORS[1] + 44.0, &format!("$x_1$ = {}", given.turn));
    energy(&mut pen, 0, "$t$ = 0", &format!("½$Cx_0$² = {}", given.start_energy));
    energy(&mut pen, 1, "$t$ = $T$/2", &format!("½$Cx_1$² = {}", given.turn_energy));
    pen.finish(id, SIZE, &Said::plain(catalogue, "sketch-loss", "sketch-loss.description"))
}

/// The way from one place to the other, and what it costs.
fn way(pen: &mut Pen, given: &Given) {
    pen.group("force friction", |pen| {
        pen.arrow((RELAXED + START, WAY), (RELAXED + TURN, WAY));
        let cost = format!("$F_R$ ($x_0$ + $x_1$) = {}", given.work);
        pen.label((RELAXED + 0.5 * (START + TURN), WAY + 27.0), Anchor::Middle, &cost);
    });
}

/// A length from the relaxed position.
fn displacement(pen: &mut Pen, displacement: f64, height: f64, label: &str) {
    pen.group("thin", |pen| pen.arrow((RELAXED, height), (RELAXED + displacement, height)));
    pen.label((RELAXED + 0.5 * displacement, height - 7.0), Anchor::Middle, label);
}

/// When it is, and the energy of the spring, to the right of the mass.
fn energy(pen: &mut Pen, place: usize, time: &str, energy: &str) {
    pen.label((BESIDE, FLOORS[place] - 72.0), Anchor::Start, time);
    pen.group("force elastic", |pen| {
        pen.label((BESIDE, FLOORS[place] - 42.0), Anchor::Start, energy);
    });
}
