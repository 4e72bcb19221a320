//! Worked examples of textbooks and the web that are motions, by their numbers W01 to W23.
//!
//! W17, W18, W21 and W22 test formulas and are not here. The answers are recomputed; where the
//! published ones are wrong, the tests say so.

use super::{Known, Problem, coulomb, oscillator, state, stokes};
use crate::friction::{Friction, NormalForce};
use crate::oscillator::State;

const OPENSTAX_PHYSICS: &str =
    "OpenStax College Physics, Ex. 16.7(b) (osbooks-college-physics-bundle, module m42246)";
const OPENSTAX_CALCULUS: &str = "OpenStax Calculus 7.3 (osbooks-calculus-bundle, module m54044)";

/// The textbook motions. W15 and W16 have two each, without and with friction. In W16 and W20 a
/// constant force F acts: positions are from the new equilibrium F/C.
pub fn textbook() -> Vec<Problem> {
    let mut problems = dry();
    problems.extend(viscous_openstax());
    problems.extend(viscous_others());
    problems
}

fn problem(
    name: &'static str,
    source: &'static str,
    (mass, stiffness, friction): (f64, f64, Friction),
    (position, velocity): (f64, f64),
    known: Known,
) -> Problem {
    let oscillator = oscillator(mass, stiffness, friction);
    Problem { name, source, oscillator, release: State { position, velocity }, known }
}

/// W01 to W07: Coulomb friction, from |x_n| = |x0| − 2nf.
fn dry() -> Vec<Problem> {
    let weight = |mu: f64, g: f64| Friction::from(coulomb(mu, mu, NormalForce::Weight(g)));
    let force = |newtons| Friction::from(coulomb(1.0, 1.0, NormalForce::Given(newtons)));
    let static_ = Friction::from(coulomb(0.085, 0.1, NormalForce::Weight(9.8)));
    vec![
        problem(
            "W01",
            OPENSTAX_PHYSICS,
            (0.2, 50.0, weight(0.08, 9.8)),
            (0.1, 0.0),
            Known::rest(16, 3.17906824505475, -0.000352),
        ),
        problem(
            "W02",
            "OpenStax College Physics, the same example with 20 times the friction",
            (0.2, 50.0, force(3.136)),
            (0.1, 0.0),
            Known::rest(1, 0.198691765315922, 0.02544),
        ),
        problem(
            "W03",
            "OpenStax College Physics, exercise with 0.5 kg (module m42246)",
            (0.5, 50.0, weight(0.06, 9.8)),
            (0.2, 0.0),
            Known::rest(17, 5.34070751110265, -0.00008),
        ),
        problem(
            "W04",
            "OpenStax College Physics, problem with 0.750 kg (module m42247)",
            (0.75, 150.0, static_),
            (0.0098, 0.0),
            Known::rest(1, 0.222144146907918, -0.00147),
        ),
        problem(
            "W05",
            "Irodov 4.82 (solveirodov.com); the seventh swing ends on the edge of the band",
            (0.5, 245.0, weight(0.1, 9.8)),
            (0.03, 0.0),
            Known::rest(7, 0.99345882657961, -0.002),
        ),
        problem(
            "W06",
            "a problem of Rao (edu.com 775441); it ends in the very centre",
            (20.0, 10000.0, force(50.0)),
            (0.05, 0.0),
            Known::rest(5, 0.702481473104073, 0.0),
        ),
        problem(
            "W07",
            "code_aster SDND100, V5.01.100",
            (1.0, 10000.0, weight(0.1, 10.0)),
            (0.00085, 0.0),
            Known {
                amplitudes: &[(1, 0.00065), (2, 0.00045), (3, 0.00025), (4, 0.00005)],
                ..Known::rest(4, 0.125663706143592, 0.00005)
            },
        ),
    ]
}

/// W08 to W14: Stokes friction in every regime.
fn viscous_openstax() -> Vec<Problem> {
    let case = |name, (mass, damping, stiffness), release, known| {
        let system = (mass, stiffness, stokes(damping).into());
        problem(name, OPENSTAX_CALCULUS, system, release, Known::states(known))
    };
    vec![
        case(
            "W08",
            (0.5, 2.5, 3.0),
            (0.0, -5.0),
            const { &[state(10.0, -1.03053002310443e-8, 2.06101325809403e-8)] },
        ),
        case(
            "W09",
            (2.0, 16.0, 24.0),
            (0.4, 0.0),
            const { &[state(0.5, 0.210770251029293, -0.381710847364294)] },
        ),
        case(
            "W10",
            (12.0, 240.0, 1152.0),
            (1.0 / 3.0, 10.0),
            const { &[state(0.1, 0.618869703354969, -1.13583094261852)] },
        ),
        case(
            "W11",
            (1.0, 14.0, 49.0),
            (0.0, -3.0),
            const { &[state(0.3, -0.110210785427684, 0.404106213234840)] },
        ),
        case(
            "W12",
            (0.03125, 0.5, 2.0),
            (0.5, 0.0),
            const { &[state(0.3, 0.154220520592001, -0.870892351578360)] },
        ),
        case(
            "W13",
            (0.5, 1.0, 5.0),
            (0.75, 0.0),
            const { &[state(1.0, -0.260169627384176, -0.129787874257933)] },
        ),
        case(
            "W14",
            (1.0, 4.0, 20.0),
            (-0.24, 0.0),
            const { &[state(0.5, -0.00339937174689716, 0.401414195087115)] },
        ),
    ]
}

/// W15, W16, W19, W20, W23: no friction and Stokes friction, from other sources.
fn viscous_others() -> Vec<Problem> {
    let thomson_99 = "ANSYS VM74 (Thomson p. 99), as PTC Creo Simulate mvst001";
    let thomson_102 = "ANSYS VM75 (Thomson p. 102), as MIDAS/Gen example 43";
    let case = |name, source, (mass, damping, stiffness), release, known| {
        let system = (mass, stiffness, stokes(damping).into());
        problem(name, source, system, release, Known::states(known))
    };
    vec![
        case(
            "W15 ζ = 0",
            thomson_99,
            (0.5, 0.0, 200.0),
            (0.0, 20.0),
            const { &[state(0.1, 0.909297426825682, -8.32293673094285)] },
        ),
        case(
            "W15 ζ = 0.7",
            thomson_99,
            (0.5, 14.0, 200.0),
            (0.0, 20.0),
            const { &[state(0.1, 0.341804301226263, -4.08478305024122)] },
        ),
        Problem {
            known: Known { amplitudes: &[(1, 1.0)], ..Known::NOTHING },
            ..case("W16 ζ = 0", thomson_102, (0.5, 0.0, 200.0), (-1.0, 0.0), &[])
        },
        case(
            "W16 ζ = 0.5",
            thomson_102,
            (0.5, 10.0, 200.0),
            (-1.0, 0.0),
            const { &[state(0.2, 0.153122768414049, -0.990597594838296)] },
        ),
        case(
            "W19",
            "RIT phys283 (ans_p.txt), with the parameters inferred from the answer",
            (1.0, 0.3, 24.0),
            (-2.5, 1.0),
            const { &[state(2.0, 1.69358885108808, -3.95345004823896)] },
        ),
        case(
            "W20",
            "EXUDYN, coordinateSpringDamper.py",
            (1.6, 8.0, 4000.0),
            (-0.1, 1.0),
            const { &[state(1.0, -0.00816801321245308, -0.0533602260403267)] },
        ),
        case(
            "W23",
            "scipy-lectures, plot_odeint_damped_spring_mass",
            (0.5, 0.4, 4.0),
            (1.0, 0.0),
            const { &[state(10.0, -0.01692191106936, -0.014176607404328)] },
        ),
    ]
}
