//! What a check can find in some experiment is said in both languages, and the formulas in it can be set.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use federpendel::{Coulomb, Friction, Newton, NormalForce, Oscillator, State, Stokes};
use federpendel_report::Verdict;
use federpendel_report::article::Laboratory;
use federpendel_report::article::{Check, Checks};
use federpendel_text::{Catalogue, Language};
use math_core::{LatexToMathML, MathCoreConfig, MathDisplay};

const WEIGHT: NormalForce = NormalForce::Weight(9.81);

fn stokes(damping: f64) -> Friction {
    Stokes::new(damping).unwrap().into()
}

fn coulomb(kinetic: f64, static_: f64, normal_force: NormalForce) -> Friction {
    Coulomb::new(kinetic, static_, normal_force).unwrap().into()
}

fn newton(coefficient: f64) -> Friction {
    Newton::new(coefficient).unwrap().into()
}

/// Mass (kg) and stiffness (N/m) with friction, and a release (m, m/s).
type Experiment = (&'static str, [f64; 2], Friction, [f64; 2]);

/// From mild to extreme, so that every verdict that a check can reach is reached.
fn experiments() -> Vec<Experiment> {
    let usual = [0.5, 20.0];
    let rest = [0.1, 0.0];
    let dry = coulomb(0.02, 0.02, WEIGHT);
    let all = Friction {
        stokes: stokes(0.05).stokes,
        coulomb: coulomb(0.005, 0.005, WEIGHT).coulomb,
        newton: newton(0.047).newton,
    };
    vec![
        ("the built-in one", usual, dry, rest),
        ("C = 1 N/m", [0.5, 1.0], dry, [0.5, 0.0]),
        ("no friction", usual, Friction::NONE, rest),
        ("no release", usual, Friction::NONE, [0.0, 0.0]),
        ("weak Stokes", usual, stokes(0.3), rest),
        ("strong Stokes", usual, stokes(5.0), rest),
        ("critical", [1.0, 4.0], stokes(4.0), rest),
        ("overdamped", usual, stokes(30.0), rest),
        ("overdamped and thrown", usual, stokes(30.0), [0.1, -9.0]),
        ("far overdamped", [1.0, 1.0], stokes(200.0), rest),
        ("a start without a third derivative", [1.0, 1.0], stokes(0.5), [0.15, 0.1]),
        ("sticks where it is released", usual, coulomb(0.5, 0.5, WEIGHT), rest),
        ("is held where it is released", usual, coulomb(0.1, 0.5, WEIGHT), rest),
        ("does not pass the middle", usual, coulomb(0.3, 0.3, WEIGHT), rest),
        ("sticks at twice the release", usual, coulomb(1.0, 1.0, WEIGHT), rest),
        ("the scheme runs away", usual, stokes(3000.0), rest),
        ("next to critical", usual, stokes(6.32455), rest),
        ("a release in the backward quotient's blind spot", [1.0, 9.7], Friction::NONE, rest),
        ("hardly any velocity", usual, dry, [0.1, 1e-9]),
        ("the scheme runs away without overflow", usual, stokes(1100.0), rest),
        ("hardly any amplitude", usual, dry, [1e-7, 0.0]),
        ("a small mass", [1e-12, 100.0], coulomb(1.0, 1.0, NormalForce::Given(1e-7)), [1e-6, 0.0]),
        (
            "thrown, it is small",
            [1e-12, 1000.0],
            coulomb(1.0, 1.0, NormalForce::Given(1e-7)),
            [1e-6, 3.0],
        ),
        ("slow", [2e6, 1e-3], Friction::NONE, [0.1, -1e-6]),
        ("stopped at once", usual, coulomb(500.0, 500.0, WEIGHT), [5e-4, -2.0]),
        ("one swing", usual, coulomb(0.2, 0.2, WEIGHT), rest),
        ("two swings", usual, coulomb(0.1, 0.1, WEIGHT), rest),
        ("static friction", usual, coulomb(0.02, 0.1, WEIGHT), rest),
        ("very weak Coulomb", usual, coulomb(1e-5, 1e-5, WEIGHT), rest),
        ("hardly any Coulomb", usual, coulomb(1e-8, 1e-8, WEIGHT), rest),
        ("x0 < 0", usual, dry, [-0.1, 0.0]),
        ("x0 = 0", usual, dry, [0.0, 0.5]),
        ("v0 < 0", usual, dry, [0.1, -0.4]),
        ("fast", usual, dry, [0.01, 10.0]),
        ("hanging", usual, coulomb(0.02, 0.02, NormalForce::Given(3.0)), rest),
        ("strong Newton", usual, newton(50.0), rest),
        ("very strong Newton", usual, newton(5000.0), rest),
        ("all three", usual, all, rest),
        ("all three, thrown", usual, all, [-0.1, 0.7]),
    ]
}

fn laboratory((name, [mass, stiffness], friction, [x0, v0]): &Experiment) -> Laboratory {
    let oscillator = Oscillator::new(*mass, *stiffness, *friction).expect(name);
    let normal_force = friction.coulomb.map_or(WEIGHT, |law| law.normal_force());
    let release = State::new(*x0, *v0).expect(name);
    Laboratory::new(oscillator, normal_force, release, None, None).expect(name)
}

fn all_checks(laboratory: &Laboratory) -> Vec<Check> {
    Checks::of(laboratory).expect("checks").all().cloned().collect()
}

/// The checks of every experiment, each with its name.
static ALL_CHECKS: LazyLock<Vec<(&str, Vec<Check>)>> = LazyLock::new(|| {
    let mut all: Vec<_> = experiments()
        .iter()
        .map(|experiment| (experiment.0, all_checks(&laboratory(experiment))))
        .collect();
    // A drag coefficient that is in number the stiffness.
    let mut coincidence = laboratory(&experiments()[1]);
    coincidence.drag_coefficient = Some(1.0);
    all.push(("c_w = C", all_checks(&coincidence)));
    all
});

/// The ids in the catalogue of what may be said of a check.
fn ids(check: &str) -> [String; 5] {
    let finding = |verdict: Verdict| format!("check-{check}.{}", verdict.name());
    let [holds, fails, holds_here, not_applicable] = Verdict::ALL.map(finding);
    [format!("check-{check}"), holds, fails, holds_here, not_applicable]
}

#[test]
fn every_claim_and_every_finding_is_said_in_both_languages() {
    let mut met = BTreeSet::new();
    for language in Language::ALL {
        let catalogue = Catalogue::new(language);
        for (name, checks) in ALL_CHECKS.iter() {
            for &Check { id, verdict, .. } in checks {
                assert!(catalogue.contains(&format!("check-{id}")), "{language:?} {name}: {id}");
                met.insert(verdict.name());
                let finding = format!("check-{id}.{}", verdict.name());
                // Where a claim holds the numbers may say enough.
                let said = verdict == Verdict::Holds || catalogue.contains(&finding);
                assert!(said, "{language:?} {name}: {finding}");
            }
        }
    }
    assert_eq!(met.len(), Verdict::ALL.len(), "{met:?}");
}

/// What is right in the article is right in every experiment.
const RIGHT: [&str; 42] = [
    "harmonic",
    "angular-frequency",
    "constants",
    "general-solution",
    "imaginary-roots",
    "both-routes",
    "chain-25-27",
    "only-linear",
    "stokes-force",
    "characteristic-roots",
    "oscillates-below-critical",
    "conjugate-roots",
    "complex-form",
    "damped-constants",
    "derivative",
    "damped-solution",
    "frequency-lowered",
    "exponential-decay",
    "overdamped-solution",
    "critical-solution",
    "recursion-stokes",
    "start-stokes",
    "friction-force",
    "normal-force",
    "opposes-motion",
    "recursion-coulomb",
    "linear-decay",
    "work-energy",
    "energy-chain",
    "loss",
    "half-period",
    "period-chain",
    "decay-left",
    "frequency-unchanged",
    "analytic-exists",
    "linear-turning-points",
    "one-sine",
    "coefficients",
    "amplitude",
    "tangent",
    "drag-force",
    "recursion-newton",
];

/// What is wrong in the article never holds, but for chance.
const WRONG: [&str; 28] = [
    "lost-factor",
    "quotient-orders",
    "scheme-order-stokes",
    "stability",
    "start-order",
    "static-friction",
    "start-coulomb",
    "scheme-rests",
    "scheme-order-coulomb",
    "decay-middle",
    "decay-right",
    "decay-dimension",
    "letter-c",
    "linear-solution",
    "linear-start",
    "negative-release",
    "written-out",
    "after-rest",
    "agreement-proves",
    "quadrant",
    "phase-at-rest",
    "general-linear-solution",
    "general-turning-points",
    "general-written-out",
    "general-after-rest",
    "agreement-general",
    "scheme-order-newton",
    "only-numeric",
];

#[test]
fn right_claims_never_fail_and_wrong_ones_never_hold() {
    let first: Vec<_> = ALL_CHECKS[0].1.iter().map(|check| check.id).collect();
    for id in RIGHT.iter().chain(&WRONG) {
        assert!(first.contains(id), "no check {id}");
    }
    for (name, checks) in ALL_CHECKS.iter() {
        for check in checks {
            let verdict = check.verdict;
            let wrongly = RIGHT.contains(&check.id) && verdict == Verdict::Fails
                || WRONG.contains(&check.id) && verdict == Verdict::Holds;
            assert!(!wrongly, "{name}: {} {}: {check:?}", check.id, verdict.name());
        }
    }
}

#[test]
fn every_check_is_there_in_every_experiment() {
    let all = &*ALL_CHECKS;
    let names = |checks: &[Check]| checks.iter().map(|check| check.id).collect::<Vec<_>>();
    let first = names(&all[0].1);
    assert_eq!(first.iter().collect::<BTreeSet<_>>().len(), first.len(), "an id stands twice");
    for (name, checks) in all {
        assert_eq!(names(checks), first, "{name}");
    }
}

#[test]
fn formulas_in_texts_can_be_set() {
    let converter = LatexToMathML::new(MathCoreConfig::default()).expect("a converter");
    let mut formulas = 0;
    for language in Language::ALL {
        let catalogue = Catalogue::new(language);
        for check in &ALL_CHECKS[0].1 {
            for id in ids(check.id).iter().filter(|id| catalogue.contains(id)) {
                let text = catalogue.text(id);
                let parts: Vec<_> = text.split('$').collect();
                assert!(parts.len() % 2 == 1, "{language:?} {id}: a dollar sign too few: {text}");
                assert!(!text.contains(['{', '}']), "{language:?} {id}: {text}");
                for outside in parts.iter().step_by(2) {
                    assert!(!outside.contains('\\'), "{language:?} {id}: {outside}");
                }
                for formula in parts.iter().skip(1).step_by(2) {
                    let set = converter.convert_with_local_state(formula, MathDisplay::Inline);
                    assert!(set.is_ok(), "{language:?} {id}: {formula}: {:?}", set.err());
                    formulas += 1;
                }
            }
        }
    }
    assert!(formulas > 100, "{formulas}");
}

#[test]
fn both_languages_have_the_same_formulas() {
    let [english, german] = Language::ALL.map(Catalogue::new);
    let formulas = |catalogue: &Catalogue, id: &str| {
        let text = catalogue.text(id);
        let mut formulas: Vec<_> = text.split('$').skip(1).step_by(2).map(str::to_owned).collect();
        formulas.sort();
        formulas
    };
    let numbers = |catalogue: &Catalogue, id: &str| -> BTreeSet<String> {
        let text = catalogue.text(id);
        let inside = text.split('(').skip(1).filter_map(|rest| rest.split(')').next());
        inside.filter(|number| number.parse::<u8>().is_ok()).map(str::to_owned).collect()
    };
    for check in &ALL_CHECKS[0].1 {
        for id in ids(check.id).iter().filter(|id| english.contains(id)) {
            assert_eq!(formulas(&english, id), formulas(&german, id), "{id}");
            assert_eq!(numbers(&english, id), numbers(&german, id), "{id}");
        }
    }
}
