//! The four reference cases on which accuracy and speed are measured: m = 0.5 kg, C = 20 N/m,
//! g = 9.81 m/s², released at rest at x0 = 0.1 m.

use super::{Known, KnownRest, Problem, coulomb, newton, oscillator, state, stokes};
use crate::friction::{Friction, NormalForce};
use crate::oscillator::State;

/// All four reference cases.
pub fn references() -> [Problem; 4] {
    [stokes_reference(), coulomb_reference(), newton_reference(), all_three_reference()]
}

fn reference(name: &'static str, friction: Friction, known: Known) -> Problem {
    Problem {
        name,
        source: "reference case of this project, recomputed with 40 digits",
        oscillator: oscillator(0.5, 20.0, friction),
        release: State { position: 0.1, velocity: 0.0 },
        known,
    }
}

/// Stokes friction, D = 0.2 kg/s; states from the closed form.
pub fn stokes_reference() -> Problem {
    const STATES: &[super::KnownState] = &[
        state(1.0, 0.0819122698837683, -0.0197890522953611),
        state(20.0, 0.00136244484264853, -0.00801904068065248),
    ];
    reference("stokes", stokes(0.2).into(), Known::states(STATES))
}

/// Coulomb friction, μ = 0.02: f = 4.905 mm, ten swings of π/ω0 to rest at 1.9 mm.
pub fn coulomb_reference() -> Problem {
    let law = coulomb(0.02, 0.02, NormalForce::Weight(9.81));
    let known = Known {
        amplitudes: &[(1, 0.09019), (2, 0.08038), (9, 0.01171), (10, 0.0019)],
        first_turn: Some(0.496729413289805),
        ..Known::rest(10, 4.96729413289805, 0.0019)
    };
    reference("coulomb", law.into(), known)
}

/// Newton friction, ½ρc_wA = 0.235 kg/m, κ = 0.47 1/m; turning amplitudes from the Lambert W
/// function, the first turning time by quadrature of the first integral.
pub fn newton_reference() -> Problem {
    let known = Known {
        amplitudes: &[
            (1, 0.0941008345925258),
            (2, 0.0888591048588156),
            (3, 0.0841706802657609),
            (6, 0.0726687506642883),
        ],
        first_turn: Some(0.49690159858123),
        ..Known::default()
    };
    reference("newton", newton(0.235).into(), known)
}

/// All three laws, D = 0.05 kg/s, μ = 0.005, ½ρc_wA = 0.047 kg/m: 26 swings.
pub fn all_three_reference() -> Problem {
    let friction = Friction {
        stokes: Some(stokes(0.05)),
        coulomb: Some(coulomb(0.005, 0.005, NormalForce::Weight(9.81))),
        newton: Some(newton(0.047)),
    };
    let rest = KnownRest { swings: 26, time: 12.9156488513554, position: 0.000289166337655 };
    reference("all three", friction, Known { rest: Some(rest), ..Known::default() })
}
