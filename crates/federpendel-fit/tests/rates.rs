//! A few of the recordings of the example `rates`: from a cold start to the truth.

use federpendel_fit::{Options, Standing, fit};

mod synthetic;
use synthetic::{Random, known};

#[test]
fn cold_starts_reach_the_truth() {
    let mut random = Random(20_260_101);
    let (mut reached, mut covered, mut intervals, mut absent) = (0, 0, 0, 0);
    const COUNT: usize = 120;
    for i in 0..COUNT {
        let known = known(&mut random, 0.0).expect("in range");
        let report = fit(&known.recording, &Options::default()).expect("fits");
        assert!(report.window.first >= known.release, "{i}: {:?}", report.window);
        assert!(report.adequacy.adequate, "{i}: {:?}", report.adequacy);
        let model = report.model(known.mix).expect("all mixes are fitted");
        let noise = &known.noise[report.window.first..report.window.end];
        let truth: f64 = noise.iter().map(|n| n * n).sum();
        reached += usize::from(model.chi_square <= truth * (1.0 + 1e-9));
        let acts = [known.mix.stokes, known.mix.coulomb, known.mix.newton];
        let named = report.verdict.laws.map(|standing| standing == Standing::Acts);
        absent += (0..3).filter(|&law| named[law] && !acts[law]).count();
        for (name, value) in [
            ("angular_frequency", known.truth.angular_frequency),
            ("damping_rate", known.truth.damping_rate),
            ("coulomb_acceleration", known.truth.coulomb_acceleration),
            ("newton_rate", known.truth.newton_rate),
        ] {
            let Some(parameter) = model.parameter(name) else { continue };
            let (low, high) = parameter.interval95;
            intervals += 1;
            covered +=
                usize::from(low.is_none_or(|l| l <= value) && high.is_none_or(|h| h >= value));
        }
    }
    assert!(reached >= COUNT - 1, "{reached} of {COUNT}");
    assert!(absent <= 5, "{absent}");
    // Four standard deviations of what 95 % leave to chance.
    let share = covered as f64 / intervals as f64;
    assert!((0.91..0.99).contains(&share), "{covered} of {intervals}");
}
