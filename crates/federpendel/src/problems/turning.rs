//! Turning amplitudes of six mixes for ω0 = 1/s, released at rest at x0 = 1 m.

use super::{Known, KnownRest, Problem, coulomb, newton, oscillator, stokes};
use crate::friction::{Friction, NormalForce};
use crate::oscillator::State;

/// The six mixes. Mass and stiffness are 1, so that f = μF_N, γ = D/2 and κ = ½ρc_wA in SI numbers.
pub fn turning_amplitudes() -> [Problem; 6] {
    let dry = Some(coulomb(1.0, 1.0, NormalForce::Given(0.02)));
    let viscous = Some(stokes(0.1));
    let weak_drag = Some(newton(0.1));
    [
        case("newton, κ = 0.1", Friction { newton: weak_drag, ..Friction::NONE }, NEWTON_WEAK),
        case("newton, κ = 1", newton(1.0).into(), NEWTON_STRONG),
        case(
            "coulomb+newton",
            Friction { coulomb: dry, newton: weak_drag, stokes: None },
            COULOMB_NEWTON,
        ),
        case(
            "stokes+coulomb",
            Friction { stokes: viscous, coulomb: dry, newton: None },
            STOKES_COULOMB,
        ),
        case(
            "stokes+newton",
            Friction { stokes: viscous, newton: weak_drag, coulomb: None },
            STOKES_NEWTON,
        ),
        case("all three", Friction { stokes: viscous, coulomb: dry, newton: weak_drag }, ALL_THREE),
    ]
}

fn case(name: &'static str, friction: Friction, known: Known) -> Problem {
    Problem {
        name,
        source: "turning amplitudes for ω0 = 1, recomputed with 50 digits",
        oscillator: oscillator(1.0, 1.0, friction),
        release: State { position: 1.0, velocity: 0.0 },
        known,
    }
}

const NEWTON_WEAK: Known = Known {
    amplitudes: &[
        (1, 0.8821899862473064),
        (2, 0.789240320289402),
        (3, 0.7140265200811302),
        (6, 0.5553117408462527),
    ],
    first_turn: Some(3.146222556011009),
    ..Known::NOTHING
};

const NEWTON_STRONG: Known = Known {
    amplitudes: &[
        (1, 0.4107196860610394),
        (2, 0.2635683864175969),
        (3, 0.1945658418739881),
        (6, 0.1092323127910894),
    ],
    first_turn: Some(3.380971060358925),
    ..Known::NOTHING
};

const COULOMB_NEWTON: Known = Known {
    amplitudes: &[(1, 0.8465939158375397), (2, 0.7244557418629591), (3, 0.6239247416523626)],
    rest: Some(KnownRest { swings: 15, time: 47.14016236047838, position: 0.0141985129411459 }),
    ..Known::NOTHING
};

const STOKES_COULOMB: Known = Known {
    amplitudes: &[(1, 0.8173785351466213), (2, 0.6613343568555475), (3, 0.5279996166152029)],
    rest: Some(KnownRest { swings: 10, time: 31.45527022888002, position: 0.005492310546209 }),
    ..Known::NOTHING
};

const STOKES_NEWTON: Known = Known {
    amplitudes: &[
        (1, 0.7597890119430565),
        (2, 0.5931441144323207),
        (3, 0.4720232562450404),
        (6, 0.2557403887722295),
    ],
    ..Known::NOTHING
};

const ALL_THREE: Known = Known {
    amplitudes: &[(1, 0.7262577931039454), (2, 0.5347443098023209), (3, 0.3933958086431348)],
    rest: Some(KnownRest { swings: 9, time: 28.34342065441714, position: 0.0160770688577614 }),
    ..Known::NOTHING
};
