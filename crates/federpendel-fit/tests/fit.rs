//! Fits to known motions: what is easy to get wrong.

use std::f64::consts::PI;

use federpendel::Mix;
use federpendel_fit::{
    Bootstrap, Edge, Fault, FitError, Intervals, Laws, Loss, Options, Parameters, Quantity,
    Recording, Standing, fit,
};

mod synthetic;
use synthetic::{Random, known};

const STOKES: Mix = Mix { stokes: true, coulomb: false, newton: false };

/// A decay of 20 swings from 1 m, 1,000 values.
fn truth() -> Parameters {
    Parameters {
        angular_frequency: 6.0,
        damping_rate: 0.1,
        coulomb_acceleration: 0.0,
        newton_rate: 0.0,
        position0: 1.0,
        velocity0: 0.0,
        equilibrium: 0.3,
    }
}

/// Positions of a motion at `times`, with noise of this standard deviation.
fn recorded(p: &Parameters, times: Vec<f64>, sigma: f64, seed: u64) -> Recording {
    let motion = p.motion(p.coulomb_acceleration).expect("in range");
    let mut random = Random(seed);
    let mut value = |&t: &f64| {
        let sample = motion.at(t - times[0]).expect("in range");
        p.equilibrium + sample.position + sigma * random.normal()
    };
    let values = times.iter().map(&mut value).collect();
    Recording { times, values, quantity: Quantity::Position, unit: "m".to_owned() }
}

fn even(duration: f64, count: usize) -> Vec<f64> {
    (0..count).map(|i| duration * i as f64 / (count - 1) as f64).collect()
}

#[test]
fn without_noise_the_truth_comes_back() {
    let p = Parameters { coulomb_acceleration: 0.2, newton_rate: 0.05, ..truth() };
    let report = fit(&recorded(&p, even(10.0, 1000), 0.0, 1), &Options::default()).expect("fits");
    let best = report.best().expect("a verdict has its model");
    assert_eq!(best.mix, Mix { stokes: true, coulomb: true, newton: true });
    for (name, value) in [
        ("angular_frequency", 6.0),
        ("damping_rate", 0.1),
        ("coulomb_acceleration", 0.2),
        ("newton_rate", 0.05),
        ("position0", 1.0),
        ("equilibrium", 0.3),
    ] {
        assert!((best.value(name) / value - 1.0).abs() < 1e-5, "{name}: {}", best.value(name));
    }
}

#[test]
fn strong_damping_needs_no_turning_points() {
    for (i, ratio) in [0.3, 0.5, 0.7, 1.0, 1.5].into_iter().enumerate() {
        let p = Parameters { damping_rate: 6.0 * ratio, velocity0: 3.0, ..truth() };
        let recording = recorded(&p, even(4.0, 400), 0.01, 7 + i as u64);
        let report = fit(&recording, &Options::default()).expect("fits");
        let stokes = report.model(STOKES).expect("all mixes are fitted");
        assert!(stokes.rms < 0.0112, "{ratio}: {}", stokes.rms);
        let rate = stokes.parameter("damping_rate").expect("it is fitted");
        let (value, stderr) = rate.value.zip(rate.stderr).expect("both are known");
        assert!((value - p.damping_rate).abs() < 4.0 * stderr, "{ratio}: {value} ± {stderr}");
        assert!(stderr < 0.2 * p.damping_rate, "{ratio}: {value} ± {stderr}");
        assert!(report.adequacy.adequate, "{ratio}: {:?}", report.adequacy);
    }
}

#[test]
fn times_need_not_be_even() {
    let mut random = Random(5);
    let times: Vec<f64> = even(12.0, 1500).into_iter().filter(|_| random.chance(0.4)).collect();
    let report = fit(&recorded(&truth(), times, 0.01, 3), &Options::default()).expect("fits");
    assert_eq!(report.verdict.mix, STOKES);
    let best = report.best().expect("a verdict has its model");
    assert!((best.rms / 0.01 - 1.0).abs() < 0.1);
}

#[test]
fn outliers_do_not_sway_a_robust_loss() {
    let mut recording = recorded(&truth(), even(10.0, 1000), 0.01, 9);
    let mut random = Random(11);
    for value in &mut recording.values {
        if random.chance(0.04) {
            *value += random.between(-2.0, 2.0);
        }
    }
    for loss in [Loss::Huber, Loss::Tukey] {
        let options = Options { loss, ..Options::default() };
        let report = fit(&recording, &options).expect("fits");
        let stokes = report.model(STOKES).expect("all mixes are fitted");
        let rate = stokes.value("damping_rate");
        assert!((rate - 0.1).abs() < 0.003, "{loss:?}: {rate}");
    }
    let squares = fit(&recording, &Options::default()).expect("fits");
    assert!(squares.best().is_some_and(|best| best.rms > 0.1));
}

#[test]
fn noise_that_hangs_together_is_no_fault_of_the_model() {
    let mut random = Random(77);
    for i in 0..40 {
        let known = known(&mut random, 0.95).expect("in range");
        let report = fit(&known.recording, &Options::default()).expect("fits");
        assert!(report.adequacy.adequate, "{i}: {:?}", report.adequacy);
    }
}

/// The angle of a pendulum or of a spring with cubic force, by Runge and Kutta's method.
fn integrated(force: impl Fn(f64) -> f64, start: f64, times: &[f64]) -> Vec<f64> {
    let slope = |x: f64, v: f64| (v, -36.0 * force(x) - 0.1 * v);
    let (mut x, mut v, mut now) = (start, 0.0, times[0]);
    let step = |(x, v): (f64, f64), h: f64| {
        let a = slope(x, v);
        let b = slope(x + h / 2.0 * a.0, v + h / 2.0 * a.1);
        let c = slope(x + h / 2.0 * b.0, v + h / 2.0 * b.1);
        let d = slope(x + h * c.0, v + h * c.1);
        let mean = |a: f64, b: f64, c: f64, d: f64| h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
        (x + mean(a.0, b.0, c.0, d.0), v + mean(a.1, b.1, c.1, d.1))
    };
    let mut values = Vec::new();
    for &time in times {
        while now < time {
            let h = (time - now).min(1e-3);
            (x, v) = step((x, v), h);
            now += h;
        }
        values.push(x);
    }
    values
}

#[test]
fn a_spring_that_is_not_linear_is_named() {
    let mut random = Random(3);
    let cubic = |x: f64| x + 0.2 * x * x * x;
    let cases: [(&dyn Fn(f64) -> f64, Fault); 2] =
        [(&f64::sin, Fault::Softening), (&cubic, Fault::Hardening)];
    for (force, fault) in cases {
        let times = even(15.0, 1500);
        let values = integrated(force, 1.0, &times);
        let values = values.iter().map(|x| x + 0.005 * random.normal()).collect();
        let recording =
            Recording { times, values, quantity: Quantity::Position, unit: String::new() };
        let report = fit(&recording, &Options::default()).expect("fits");
        assert!(!report.adequacy.adequate, "{:?}", report.adequacy);
        assert_eq!(report.adequacy.findings[0].fault, fault, "{:?}", report.adequacy);
    }
    // At small amplitudes a pendulum is as good as linear.
    let times = even(15.0, 1500);
    let values = integrated(f64::sin, 0.1, &times);
    let values = values.iter().map(|x| x + 0.001 * random.normal()).collect();
    let recording = Recording { times, values, quantity: Quantity::Position, unit: String::new() };
    let report = fit(&recording, &Options::default()).expect("fits");
    assert!(report.adequacy.adequate, "{:?}", report.adequacy);
}

#[test]
fn what_few_swings_cannot_tell_a_wider_release_can() {
    let p = Parameters { damping_rate: 0.05, position0: 0.2, ..truth() };
    let report = fit(&recorded(&p, even(4.0, 400), 0.002, 2), &Options::default()).expect("fits");
    assert!(!report.verdict.alternatives.is_empty());
    assert!(report.verdict.laws.contains(&Standing::Open), "{:?}", report.verdict);
    let reach = report.reaches[0];
    let from = reach.from.expect("it can be told");
    assert!(from > 1.05 * reach.amplitude, "{reach:?}");
    // Released from there, with some room for chance, the recording does tell.
    let wide = Parameters { position0: 1.5 * from, ..p };
    let longer = 4.0 + (wide.position0 / p.position0).ln() / p.damping_rate;
    let times = even(longer, (100.0 * longer) as usize);
    let report = fit(&recorded(&wide, times, 0.002, 2), &Options::default()).expect("fits");
    let left = report.verdict.alternatives.iter().chain([&report.verdict.mix]);
    let told = left.filter(|mix| reach.mixes.contains(mix)).count();
    assert!(told <= 1, "{:?}", report.verdict);
}

#[test]
fn the_rest_brackets_static_friction() {
    let mut random = Random(21);
    let (mut holds, mut of) = (0, 0);
    while of < 100 {
        let known = known(&mut random, 0.0).expect("in range");
        let position = known.recording.quantity == Quantity::Position;
        if known.rests.is_none_or(|turns| turns < 2) || !position {
            continue;
        }
        let report = fit(&known.recording, &Options::default()).expect("fits");
        let model = report.model(known.mix).expect("all mixes are fitted");
        of += 1;
        let Some(rest) = model.rest else { continue };
        let (low, high) = rest.static_acceleration;
        let a = known.static_acceleration;
        holds += usize::from(low <= a && high.is_none_or(|high| high >= a));
    }
    assert!(holds * 20 >= of * 19, "{holds} of {of}");
}

#[test]
fn the_window_can_be_chosen() {
    let recording = recorded(&truth(), even(10.0, 1000), 0.01, 4);
    let options = Options { from: Some(2.0), to: Some(8.0), ..Options::default() };
    let report = fit(&recording, &options).expect("fits");
    assert_eq!((report.window.begins, report.window.ends), (Edge::Given, Edge::Given));
    assert!(report.window.from >= 2.0 && report.window.to <= 8.0 && report.window.from < 2.02);
}

#[test]
fn the_hand_before_and_the_quiet_after_are_left_out() {
    let p = Parameters { damping_rate: 0.6, ..truth() };
    let mut recording = recorded(&p, even(60.0, 6000), 0.005, 4);
    // Held for two seconds: the same record, later.
    let mut random = Random(8);
    let held = (0..200).map(|_| p.equilibrium + p.position0 + 0.005 * random.normal());
    recording.values = held.chain(recording.values).collect();
    recording.times = (0..recording.values.len()).map(|i| 5.0 + 0.01 * i as f64).collect();
    let report = fit(&recording, &Options::default()).expect("fits");
    assert_eq!((report.window.begins, report.window.ends), (Edge::Held, Edge::Still));
    assert!((7.0..7.2).contains(&report.window.from), "{:?}", report.window);
    assert!(report.window.to < 30.0, "{:?}", report.window);
    assert_eq!(report.verdict.mix, STOKES);
}

#[test]
fn intervals_of_all_kinds_agree() {
    let recording = recorded(&truth(), even(10.0, 1000), 0.02, 4);
    let widths = [
        Intervals::Covariance,
        Intervals::Profile,
        Intervals::Bootstrap(Bootstrap { repeats: 300, seed: 1 }),
    ]
    .map(|intervals| {
        let options = Options { intervals, sigma: Some(0.02), ..Options::default() };
        let report = fit(&recording, &options).expect("fits");
        let best = report.best().expect("a verdict has its model");
        assert!((best.reduced - 1.0).abs() < 0.15, "{}", best.reduced);
        let (low, high) = best.parameter("damping_rate").expect("it is fitted").interval95;
        high.expect("it is closed") - low.expect("it is closed")
    });
    for width in widths {
        assert!((width / widths[0] - 1.0).abs() < 0.2, "{widths:?}");
    }
}

#[test]
fn what_cannot_be_fitted_is_refused() {
    let good = recorded(&truth(), even(10.0, 100), 0.01, 4);
    let fails = |change: &dyn Fn(&mut Recording, &mut Options)| {
        let (mut recording, mut options) = (good.clone(), Options::default());
        change(&mut recording, &mut options);
        fit(&recording, &options).expect_err("it is refused")
    };
    let few = fails(&|r, _| (r.times.truncate(11), r.values.truncate(11)).0);
    assert!(matches!(few, FitError::TooFew { found: 11, .. }), "{few}");
    let length = fails(&|r, _| r.values.truncate(50));
    assert!(matches!(length, FitError::Length { times: 100, values: 50 }), "{length}");
    let value = fails(&|r, _| r.values[7] = f64::NAN);
    assert!(matches!(value, FitError::Value { index: 7, what: "value", .. }), "{value}");
    let time = fails(&|r, _| r.times[7] = r.times[6]);
    assert!(matches!(time, FitError::Value { index: 7, what: "time", .. }), "{time}");
    let still = fails(&|r, _| r.values.fill(2.5));
    assert!(matches!(still, FitError::Still { .. }), "{still}");
    let window = fails(&|_, o| o.from = Some(9.5));
    assert!(matches!(window, FitError::TooFew { .. }), "{window}");
    let sigma = fails(&|_, o| o.sigma = Some(0.0));
    assert!(matches!(sigma, FitError::Option { name: "sigma", .. }), "{sigma}");
    let empty = fails(&|r, _| (r.times.clear(), r.values.clear()).0);
    assert!(matches!(empty, FitError::TooFew { found: 0, .. }), "{empty}");
}

#[test]
fn only_allowed_laws_are_fitted() {
    let recording = recorded(&truth(), even(10.0, 1000), 0.01, 4);
    let both = Mix { newton: true, ..STOKES };
    for (mix, models) in [(Mix::default(), 1), (STOKES, 2), (both, 4)] {
        let with = |laws| fit(&recording, &Options { laws, ..Options::default() }).expect("fits");
        let among = with(Laws::Among(mix));
        assert_eq!(among.models.len(), models);
        assert_eq!(among.verdict.mix.stokes, mix.stokes);
        assert_eq!(among.verdict.laws[1], Standing::Excluded);
        let exactly = with(Laws::Exactly(mix));
        assert_eq!(exactly.verdict.mix, mix);
        assert_eq!(exactly.models.len(), models);
    }
}

#[test]
fn shares_are_those_of_averaging() {
    // Over a swing of slow decay Stokes friction takes πγω₀A², Coulomb 2a_cA, Newton (4/3)κω₀²A³.
    let p =
        Parameters { damping_rate: 0.02, coulomb_acceleration: 0.15, newton_rate: 0.01, ..truth() };
    let recording = recorded(&p, even(4.0, 2000), 1e-4, 4);
    let report = fit(&recording, &Options::default()).expect("fits");
    let (omega, mut amplitude) =
        (p.angular_frequency, p.position0.hypot(p.velocity0 / p.angular_frequency));
    let mut lost = [0.0; 3];
    for _ in 0..(4.0 * omega / PI) as usize {
        let swing = [
            PI * p.damping_rate * omega * amplitude.powi(2),
            2.0 * p.coulomb_acceleration * amplitude,
            4.0 / 3.0 * p.newton_rate * (omega * amplitude).powi(2) * amplitude,
        ];
        lost.iter_mut().zip(swing).for_each(|(sum, one)| *sum += one);
        amplitude -= swing.iter().sum::<f64>() / (omega * omega * amplitude);
    }
    let total: f64 = lost.iter().sum();
    for (found, lost) in report.shares.expect("something is lost").iter().zip(lost) {
        assert!((found - lost / total).abs() < 0.04, "{found} {lost} {total}");
    }
}

#[test]
fn many_values_are_condensed_without_loss() {
    // So many that means are fitted, and every fourth of them, which are fitted one by one.
    let p = Parameters { coulomb_acceleration: 0.2, ..truth() };
    let all = recorded(&p, even(10.0, 240_000), 0.02, 5);
    let every_fourth = |values: &[f64]| values.iter().step_by(4).copied().collect();
    let (times, values) = (every_fourth(&all.times), every_fourth(&all.values));
    let some = fit(&Recording { times, values, ..all.clone() }, &Options::default()).expect("fits");
    let all = fit(&all, &Options::default()).expect("fits");
    assert_eq!(all.verdict.mix, some.verdict.mix);
    assert_eq!(all.residuals.len(), all.samples);
    assert!(all.window.end - all.window.first == all.samples && all.samples > 200_000);
    let ratio = |of: fn(&federpendel_fit::FitReport) -> f64| of(&all) / of(&some);
    assert!((ratio(|report| report.effective_samples) / 4.0 - 1.0).abs() < 0.1);
    let best = |report: &federpendel_fit::FitReport| report.best().expect("a verdict").clone();
    let (all, some) = (best(&all), best(&some));
    assert!((all.rms / 0.02 - 1.0).abs() < 0.01 && (some.rms / 0.02 - 1.0).abs() < 0.01);
    for (all, some) in all.parameters.iter().zip(&some.parameters) {
        let (Some(one), Some(other)) = (all.stderr, some.stderr) else { continue };
        assert!((other / one / 2.0 - 1.0).abs() < 0.1, "{}: {one} {other}", all.name);
    }
    for (name, truth) in [("damping_rate", 0.1), ("coulomb_acceleration", 0.2)] {
        let found = all.parameter(name).expect("fitted");
        let (value, stderr) = (found.value.expect("a value"), found.stderr.expect("an error"));
        assert!((value - truth).abs() < 4.0 * stderr, "{name} {value} {stderr}");
    }
}

#[test]
fn means_keep_the_amplitude() {
    // 480 swings of 210 values: means of two are smaller by 3e-5, 150 standard errors.
    let p = Parameters { damping_rate: 1e-3, ..truth() };
    let recording = recorded(&p, even(480.0 * PI / p.angular_frequency, 100_800), 2e-5, 6);
    let report = fit(&recording, &Options::default()).expect("fits");
    let best = report.best().expect("a verdict");
    let of = |name| {
        let found = best.parameter(name).expect("fitted");
        (found.value.expect("a value"), found.stderr.expect("an error"))
    };
    let (position, stderr) = of("position0");
    let amplitude = position.hypot(of("velocity0").0 / of("angular_frequency").0);
    assert!((amplitude - p.position0).abs() < 4.0 * stderr, "{amplitude} {stderr}");
    assert!(stderr < 1e-6, "{stderr}");
}
