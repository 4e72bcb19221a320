//! Plans keep their promises: recordings as planned, made by another program part than the plan and fitted from a cold
//! start. The example `plan` does the same for more of them.

use federpendel_fit::plan::{Law, Plan, PlanError, RESOLVED, Setup, plan};

mod planned;
mod synthetic;
use planned::{EXPERIMENTS, record_and_fit};
use synthetic::Random;

/// Recordings of each law of an experiment.
const COUNT: usize = 80;

fn keeps_its_promise(number: usize, seed: u64) {
    let experiment = &EXPERIMENTS[number];
    let mut random = Random(seed);
    let setup = experiment.setup().expect("in range");
    let plan = plan(&setup).expect("a plan");
    for prospect in &plan.prospects {
        let (amplitude, promised) = prospect.smallest.expect("resolved");
        let (law, duration) = (prospect.law, promised.duration);
        let mut fitted = |amplitude| {
            record_and_fit(&setup, law, (amplitude, duration), COUNT, &mut random)
                .expect("in range")
        };
        let found = fitted(amplitude);
        let name = format!("{} {law:?} {found:?}", experiment.name);
        assert!(found.share_named() >= 0.95, "{name}");
        // A standard deviation of COUNT values is known to 1/√(2 COUNT) of itself, a mean to 1/√COUNT; four of those.
        let (share, count) = (found.spread(prospect.coefficient) / promised.stderr, COUNT as f64);
        assert!((share - 1.0).abs() < 4.0 / (2.0 * count).sqrt(), "{name}: {share}");
        let shift = (found.mean() - prospect.coefficient) / promised.stderr;
        assert!(shift.abs() < 4.0 / count.sqrt(), "{name}: {shift}");
        // One that is resolved from the first amplitude on may be by far.
        if amplitude > plan.rows[0].amplitude {
            assert!(fitted(amplitude / 3.0).share_named() < 0.5, "{name}");
        }
    }
}

#[test]
fn two_laws_are_seen_as_promised_in_positions() {
    keeps_its_promise(4, 11);
}

#[test]
fn two_laws_are_seen_as_promised_in_velocities() {
    keeps_its_promise(6, 12);
}

/// Where the mass rests, that it does tells of dry friction beyond what slopes do: the plan is on the safe side.
#[test]
fn dry_friction_that_stops_the_mass_is_seen_at_least_as_well_as_promised() {
    let setup = EXPERIMENTS[2].setup().expect("in range");
    let prospect = plan(&setup).expect("a plan").prospects[0];
    let (amplitude, promised) = prospect.smallest.expect("resolved");
    let release = (amplitude, promised.duration);
    let found =
        record_and_fit(&setup, Law::Coulomb, release, COUNT, &mut Random(13)).expect("in range");
    assert!(found.share_named() >= 0.95, "{found:?}");
    let share = found.spread(prospect.coefficient) / promised.stderr;
    assert!(share < 1.0 + 4.0 / (2.0 * COUNT as f64).sqrt(), "{share}");
}

#[test]
fn stokes_friction_is_seen_as_promised_in_short_recordings() {
    keeps_its_promise(0, 14);
}

fn planned_for(number: usize, change: impl Fn(&mut Setup)) -> Result<Plan, PlanError> {
    let mut setup = EXPERIMENTS[number].setup().expect("in range");
    change(&mut setup);
    plan(&setup)
}

/// By hand: of a weakly damped oscillation A e^(−γt) cos ωt recorded for long at a rate r, A and γ have the information
/// r/2σ² ∫ e^(−2γt) (1, −At)(1, −At)ᵀ dt, from which var γ = 16 γ³ σ²/(r A²); phase and ω do not mix with them.
#[test]
fn stokes_friction_alone_is_as_sure_as_by_hand() {
    let plan = planned_for(0, |setup| {
        setup.noise = 1e-5;
        setup.longest = Some(2000.0);
    });
    let plan = plan.expect("a plan");
    let (gamma, setup) = (plan.prospects[0].coefficient, plan.setup);
    let largest = plan.prospects[0].largest.expect("seen");
    let variance =
        16.0 * gamma.powi(3) * setup.noise.powi(2) / (setup.rate * setup.max_amplitude.powi(2));
    let share = largest.stderr / variance.sqrt();
    // Up to five per cent more, since the recording ends where the rest is not worth the time.
    assert!((0.99..1.06).contains(&share), "{share}");
}

#[test]
fn smallest_amplitudes_hold_for_all_larger_ones() {
    for (number, experiment) in EXPERIMENTS.iter().enumerate() {
        let plan = planned_for(number, |_| ()).expect("a plan");
        for prospect in &plan.prospects {
            let (smallest, _) = prospect.smallest.expect("resolved");
            let larger = plan.rows.iter().filter(|row| row.amplitude >= smallest);
            let known = larger.map(|row| row.laws[prospect.law as usize].expect("known"));
            let least = known.map(|known| known.significance).fold(f64::INFINITY, f64::min);
            assert!(least >= RESOLVED, "{} {:?}", experiment.name, prospect.law);
        }
        let advice = plan.advice().expect("resolved");
        assert!(plan.prospects.iter().all(|one| one.law.is_in(advice.laws)));
    }
}

#[test]
fn what_nothing_can_be_planned_for_is_refused() {
    let refused = |change: fn(&mut Setup)| planned_for(5, change).expect_err("refused");
    assert!(matches!(refused(|s| s.noise = 0.0), PlanError::NotPositive { name: "noise", .. }));
    assert!(matches!(refused(|s| s.rate = f64::NAN), PlanError::NotPositive { name: "rate", .. }));
    assert!(matches!(refused(|s| s.rate = 5.0), PlanError::RateTooLow { .. }));
    assert!(matches!(refused(|s| s.longest = Some(1.0)), PlanError::TooShort { .. }));
    assert!(matches!(refused(|s| s.min_amplitude = Some(0.4)), PlanError::Reversed { .. }));
    assert!(matches!(refused(|s| s.noise = 0.1), PlanError::Drowned { .. }));
    assert!(matches!(refused(|s| s.max_amplitude = 1e-4), PlanError::Sticks { .. }));
}
