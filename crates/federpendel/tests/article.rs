//! The article's formulas by equation number, against numbers and relations that are not their own.

use federpendel::article::{
    ComplexForm, Equation, Formula, Reading, critical, eq_16, eq_20, eq_36, eq_41, eq_46, eq_61,
    eq_67, eq_68, eq_69, eq_70, eq_76, eq_77, eq_78, eq_79, overdamped,
};
use federpendel::{
    Coulomb, Error, Friction, Mix, Mode, Newton, NormalForce, Oscillator, Sample, State, Stokes,
};

fn state(position: f64, velocity: f64) -> State {
    State::new(position, velocity).unwrap()
}

fn undamped(mass: f64, stiffness: f64) -> Oscillator {
    Oscillator::new(mass, stiffness, Friction::NONE).unwrap()
}

fn viscous(mass: f64, damping: f64, stiffness: f64) -> Oscillator {
    Oscillator::new(mass, stiffness, Stokes::new(damping).unwrap()).unwrap()
}

/// m = 0.5 kg, C = 20 N/m, μ = 0.02 with this static coefficient, g = 9.81 m/s².
fn dry(static_: f64) -> Oscillator {
    let law = Coulomb::new(0.02, static_, NormalForce::Weight(9.81)).unwrap();
    Oscillator::new(0.5, 20.0, law).unwrap()
}

fn all_mixes() -> Vec<Friction> {
    let (stokes, newton) = (Stokes::new(0.2).unwrap(), Newton::new(0.235).unwrap());
    let coulomb = Coulomb::new(0.02, 0.02, NormalForce::Given(4.905)).unwrap();
    (0..8)
        .map(|bits| Friction {
            stokes: (bits & 1 > 0).then_some(stokes),
            coulomb: (bits & 2 > 0).then_some(coulomb),
            newton: (bits & 4 > 0).then_some(newton),
        })
        .collect()
}

#[track_caller]
fn assert_close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} is not {expected} ± {tolerance}");
}

/// Velocity and acceleration against central differences of the position.
#[track_caller]
fn assert_derivatives(formula: &Formula, time: f64) {
    let step = 1e-4;
    let [before, here, after] =
        [time - step, time, time + step].map(|time| formula.at(time).unwrap());
    let slope = (after.position - before.position) / (2.0 * step);
    assert_close(here.velocity, slope, 1e-5 * (1.0 + slope.abs()));
    let slope = (after.velocity - before.velocity) / (2.0 * step);
    assert_close(here.acceleration, slope, 1e-5 * (1.0 + slope.abs()));
}

/// m x″ + D x′ + C x of a sample.
fn residual(oscillator: &Oscillator, damping: f64, sample: &Sample) -> f64 {
    oscillator.mass() * sample.acceleration
        + damping * sample.velocity
        + oscillator.stiffness() * sample.position
}

#[test]
fn the_undamped_solution_passes_through_known_states() {
    // m = 0.5, C = 2: ω0 = 2, and after a quarter and half a period x = v0/ω0 and −x0.
    let oscillator = undamped(0.5, 2.0);
    assert_eq!(eq_16(&oscillator), 2.0);
    assert_eq!(eq_70(&oscillator), 2.0);
    let formula = eq_20(&oscillator, state(0.3, -1.4)).unwrap();
    let quarter = std::f64::consts::FRAC_PI_4;
    assert_close(formula.at(quarter).unwrap().position, -0.7, 1e-15);
    assert_close(formula.at(2.0 * quarter).unwrap().position, -0.3, 1e-15);
    assert_close(formula.at(2.0 * quarter).unwrap().velocity, 1.4, 1e-15);
    assert_eq!(formula.equation(), Equation::Eq20);
    assert_eq!(formula.amplitude_end(), None);
    assert_derivatives(&formula, 1.7);
}

#[test]
fn the_complex_solution_is_the_real_one() {
    for (position, velocity) in [(0.1, 0.0), (-0.1, 0.3), (0.0, -2.0), (0.7, 0.4)] {
        let oscillator = undamped(0.5, 20.0);
        let release = state(position, velocity);
        let real = eq_20(&oscillator, release).unwrap();
        let complex = ComplexForm::new(&oscillator, release).unwrap();
        for time in [0.0, 0.1, 1.0, 7.3] {
            let expected = real.at(time).unwrap().position;
            for value in [
                complex.eq_25(time),
                complex.eq_26(time),
                complex.eq_27(time),
                complex.eq_28(time, Reading::Corrected),
            ] {
                assert_close(value.re, expected, 1e-15);
                assert_close(value.im, 0.0, 1e-15);
            }
        }
    }
}

#[test]
fn the_lost_factor_i_makes_the_printed_solution_complex() {
    let oscillator = undamped(0.5, 2.0);
    let complex = ComplexForm::new(&oscillator, state(0.3, -1.4)).unwrap();
    let [first, second] = complex.eq_28_constants(Reading::Printed);
    assert_eq!((first.re, first.im), (0.3, 0.0));
    assert_eq!((second.re, second.im), (0.0, 0.7));
    let [_, second] = complex.eq_28_constants(Reading::Corrected);
    assert_eq!((second.re, second.im), (-0.7, 0.0));
    // At a quarter of the period the printed x is imaginary altogether.
    let value = complex.eq_28(std::f64::consts::FRAC_PI_4, Reading::Printed);
    assert_close(value.re, 0.0, 1e-15);
    assert_close(value.im, 0.7, 1e-15);
}

#[test]
fn the_characteristic_roots_solve_the_characteristic_equation() {
    // Roots by hand: λ² + 5λ + 6, λ² + 2λ + 10, λ² + 14λ + 49, λ² + 4.
    let roots = |mass, damping, stiffness| eq_36(&viscous(mass, damping, stiffness)).unwrap();
    let [slow, fast] = roots(0.5, 2.5, 3.0);
    assert_close(slow.re, -2.0, 1e-15);
    assert_close(fast.re, -3.0, 1e-15);
    assert_eq!((slow.im, fast.im), (0.0, 0.0));
    let [upper, lower] = roots(0.5, 1.0, 5.0);
    assert_close(upper.re, -1.0, 1e-15);
    assert_close(upper.im, 3.0, 1e-15);
    assert_eq!((lower.re, lower.im), (upper.re, -upper.im));
    let [first, second] = roots(1.0, 14.0, 49.0);
    assert_eq!([first.re, second.re], [-7.0, -7.0]);
    let [upper, _] = eq_36(&undamped(1.0, 4.0)).unwrap();
    assert_eq!((upper.re.abs(), upper.im), (0.0, 2.0));
    // Strong damping, γ/ω0 = 1e8: the slow root −ω0²/(2γ) must not drown in γ.
    let [slow, _] = roots(0.5, 1e8, 0.5);
    assert_close(slow.re, -5e-9, 1e-23);
}

#[test]
fn the_damped_rates() {
    let rates = eq_41(&viscous(1.0, 0.3, 24.0)).unwrap();
    assert_close(rates.damping_rate, 0.15, 1e-16);
    assert_close(rates.angular_frequency, 4.8966826, 5e-8);
    let refused = eq_41(&viscous(1.0, 14.0, 49.0)).unwrap_err();
    assert!(refused.to_string().contains("critical"), "{refused}");
}

#[test]
fn stokes_solutions_of_every_regime() {
    // Position and velocity with 40 digits from the closed forms; see problems::textbook.
    for (oscillator, damping, release, time, x, v, equation) in [
        (
            viscous(0.5, 1.0, 5.0),
            1.0,
            state(0.75, 0.0),
            1.0,
            -0.260169627384176,
            -0.129787874257933,
            Equation::Eq46,
        ),
        (
            viscous(2.0, 16.0, 24.0),
            16.0,
            state(0.4, 0.0),
            0.5,
            0.210770251029293,
            -0.381710847364294,
            Equation::Overdamped,
        ),
        (
            viscous(1.0, 14.0, 49.0),
            14.0,
            state(0.0, -3.0),
            0.3,
            -0.110210785427684,
            0.40410621323484,
            Equation::Critical,
        ),
    ] {
        for formula in [Formula::printed, Formula::corrected] {
            let formula = formula(&oscillator, release).unwrap();
            let sample = formula.at(time).unwrap();
            assert_eq!(formula.equation(), equation);
            assert_close(sample.position, x, 1e-14);
            assert_close(sample.velocity, v, 1e-14);
            assert_close(residual(&oscillator, damping, &sample), 0.0, 1e-13);
            assert_derivatives(&formula, time);
            let start = formula.at(0.0).unwrap();
            assert_close(start.position, release.position, 1e-15);
            assert_close(start.velocity, release.velocity, 1e-14);
        }
    }
}

#[test]
fn the_three_stokes_solutions_refuse_each_others_regime() {
    let under = viscous(0.5, 1.0, 5.0);
    let release = state(1.0, 0.0);
    for refused in [overdamped(&under, release), critical(&under, release)] {
        assert!(matches!(refused, Err(Error::NoSuchSolution { .. })), "{refused:?}");
    }
    let over = viscous(2.0, 16.0, 24.0);
    for refused in [eq_46(&over, release), critical(&over, release)] {
        assert!(matches!(refused, Err(Error::NoSuchSolution { .. })), "{refused:?}");
    }
    assert!(overdamped(&over, release).is_ok());
}

#[test]
fn the_regimes_run_into_each_other() {
    // x(1) for ω0 = 1, x0 = 0, v0 = 1 at critical damping is e^(−1); γ moves it by about
    // d/dγ = −e^(−1) + O(γ − 1) … to first order in γ − 1.
    let position = |gamma: f64| {
        let oscillator = viscous(1.0, 2.0 * gamma, 1.0);
        Formula::printed(&oscillator, state(0.0, 1.0)).unwrap().at(1.0).unwrap().position
    };
    let expected = (-1f64).exp();
    for power in 1..=16 {
        let apart = 10f64.powi(-power);
        for gamma in [1.0 - apart, 1.0 + apart] {
            assert_close(position(gamma), expected, apart + 4e-16);
        }
    }
    // Far above it, x runs down the slow root: x0 e^(−ω0²t/2γ), without cancelling.
    let creeping = viscous(1.0, 2e8, 1.0);
    let sample = Formula::printed(&creeping, state(1.0, 0.0)).unwrap().at(2e8).unwrap();
    assert_close(sample.position, (-1f64).exp(), 1e-14);
    assert_close(sample.velocity, -5e-9 * (-1f64).exp(), 1e-23);
}

#[test]
fn the_loss_per_swing_and_the_three_sides_of_the_decay_velocity() {
    let oscillator = dry(0.02);
    assert_close(eq_67(&oscillator).unwrap(), 0.00981, 1e-17);
    let sides = eq_68(&oscillator).unwrap();
    // 2μg/(πω0) with μ = 0.02, g = 9.81, ω0 = √40, with 20 digits: 0.019749177...
    assert_close(sides.left, 0.019749, 5e-7);
    assert_close(sides.middle, 0.009875, 5e-7);
    assert_close(sides.right, 0.39498, 5e-6);
    assert_close(sides.middle / sides.left, 0.5, 1e-15);
    assert_close(sides.right / sides.left, 20.0, 1e-13);
    // A normal force of its own takes the place of the weight; a static coefficient has no effect.
    let given = Coulomb::new(0.04, 0.5, NormalForce::Given(2.4525)).unwrap();
    let given = eq_68(&Oscillator::new(0.5, 20.0, given).unwrap()).unwrap();
    assert_close(given.left, sides.left, 1e-17);
    assert_eq!(eq_68(&dry(0.3)).unwrap(), sides);
}

#[test]
fn amplitude_and_phase_turn_back_into_the_release() {
    let oscillator = dry(0.02);
    let omega = 40f64.sqrt();
    for (x, v) in [(0.1, 0.3), (-0.1, 0.3), (0.1, -0.3), (-0.1, -0.3), (0.0, -0.2), (0.0, 0.2)] {
        let amplitude = eq_76(&oscillator, state(x, v)).unwrap();
        let phase = eq_77(&oscillator, state(x, v), Reading::Corrected).unwrap();
        // (75)
        assert_close(amplitude * phase.sin(), x, 1e-16);
        assert_close(amplitude * phase.cos(), v / omega, 1e-16);
        let printed = eq_77(&oscillator, state(x, v), Reading::Printed).unwrap();
        let side = if v < 0.0 { -1.0 } else { 1.0 };
        assert_close(amplitude * printed.sin(), side * x, 1e-16);
        assert_close(amplitude * printed.cos(), side * v / omega, 1e-16);
    }
    for reading in [Reading::Printed, Reading::Corrected] {
        let phase = |x| eq_77(&oscillator, state(x, 0.0), reading).unwrap();
        assert_eq!(phase(0.1), std::f64::consts::FRAC_PI_2);
        assert_eq!(phase(-0.1), -std::f64::consts::FRAC_PI_2);
        let nowhere = state(0.0, 0.0);
        assert_eq!(eq_77(&oscillator, nowhere, reading), Err(Error::NoPhase));
        assert_eq!(eq_79(&oscillator, nowhere, reading), Err(Error::NoPhase));
    }
}

#[test]
fn the_coulomb_formulas_and_how_they_relate() {
    let oscillator = dry(0.02);
    let at = |formula: federpendel::Result<Formula>, time| formula.unwrap().at(time).unwrap();
    let both = [Reading::Printed, Reading::Corrected];
    for time in [0.0, 0.3, 2.0, 7.7] {
        let [printed, corrected] = both.map(|reading| at(eq_69(&oscillator, 0.1, reading), time));
        let cos = (40f64.sqrt() * time).cos();
        // From rest at x0 > 0 the wrong v_A is the only difference, 0.375230... m/s.
        assert_close(corrected.position - printed.position, 0.375234 * time * cos, 1e-5);
        let [plain, same] = both.map(|reading| at(eq_61(&oscillator, 0.1, reading), time));
        assert_eq!(plain, same);
        assert_eq!(corrected, same);
        // (78) from rest is (61); mirrored releases give mirrored motions, corrected only.
        let general = at(eq_78(&oscillator, state(0.1, 0.0), Reading::Corrected), time);
        assert_close(general.position, same.position, 1e-16);
        let mirrored = at(eq_61(&oscillator, -0.1, Reading::Corrected), time);
        assert_eq!(mirrored.position, -same.position);
        let [first, second] = [eq_78, eq_79]
            .map(|equation| at(equation(&oscillator, state(0.1, -0.3), Reading::Corrected), time));
        assert_eq!(first, second);
    }
    // In print the amplitude grows for x0 < 0: after half a period |x| = 0.1 + Δx.
    let half_period = std::f64::consts::PI / 40f64.sqrt();
    let grown = at(eq_61(&oscillator, -0.1, Reading::Printed), half_period);
    assert_close(grown.position, 0.10981, 1e-15);
    let fallen = at(eq_61(&oscillator, -0.1, Reading::Corrected), half_period);
    assert_close(fallen.position, 0.09019, 1e-15);
    // The printed phase mirrors the start for v0 < 0.
    let start = at(eq_78(&oscillator, state(0.1, -0.3), Reading::Printed), 0.0);
    assert_close(start.position, -0.1, 1e-16);
}

#[test]
fn the_formula_for_a_release_and_its_derivatives() {
    let oscillator = dry(0.03);
    for (position, velocity, printed, corrected) in [
        (0.1, 0.0, Equation::Eq69, Equation::Eq61),
        (-0.1, 0.0, Equation::Eq69, Equation::Eq61),
        (0.1, 0.3, Equation::Eq79, Equation::Eq78),
        (0.0, -0.3, Equation::Eq79, Equation::Eq78),
    ] {
        let release = state(position, velocity);
        let formula = Formula::printed(&oscillator, release).unwrap();
        assert_eq!(formula.equation(), printed);
        assert_derivatives(&formula, 1.234);
        let formula = Formula::corrected(&oscillator, release).unwrap();
        assert_eq!(formula.equation(), corrected);
        assert_derivatives(&formula, 1.234);
        // It starts at x0, but with the velocity −v_A sign(x0) too much, (78) by −v_A sin φ.
        let start = formula.at(0.0).unwrap();
        assert_close(start.position, position, 1e-16);
        let amplitude = position.hypot(velocity / 40f64.sqrt());
        let slip = 0.019749177 * position / amplitude;
        assert_close(start.velocity, velocity - slip, 1e-6);
    }
}

#[test]
fn the_end_of_the_amplitude() {
    let oscillator = dry(0.02);
    let rest = state(0.1, 0.0);
    let corrected = Formula::corrected(&oscillator, rest).unwrap();
    assert_close(corrected.amplitude_end().unwrap(), 0.1 / 0.0197491, 1e-4);
    // In print the right side of (68) makes it end twenty times too early.
    let printed = Formula::printed(&oscillator, rest).unwrap();
    assert_close(printed.amplitude_end().unwrap(), 0.005 / 0.0197491, 1e-5);
    // x0 < 0 in print, and a release at rest in the centre: it only grows.
    let growing = Formula::printed(&oscillator, state(-0.1, 0.0)).unwrap();
    assert_eq!(growing.amplitude_end(), Some(0.0));
    let nowhere = Formula::printed(&oscillator, state(0.0, 0.0)).unwrap();
    assert_eq!(nowhere.equation(), Equation::Eq69);
    assert_eq!(nowhere.amplitude_end(), Some(0.0));
    assert!(nowhere.at(1.0).unwrap().position.is_finite());
}

#[test]
fn other_mixes_are_refused_by_name() {
    for friction in all_mixes() {
        let mix = friction.mix();
        let solved = [mix.stokes, mix.coulomb, mix.newton].iter().filter(|&&acts| acts).count();
        let solved = solved == 0 || solved == 1 && !mix.newton;
        let oscillator = Oscillator::new(0.5, 20.0, friction).unwrap();
        for velocity in [0.0, 0.3] {
            for formula in [Formula::printed, Formula::corrected] {
                match formula(&oscillator, state(0.1, velocity)) {
                    Ok(_) => assert!(solved, "{mix}"),
                    Err(error) => {
                        assert!(!solved, "{mix}");
                        assert_eq!(error, Error::NotInArticle { mix });
                        assert!(error.to_string().contains(&mix.to_string()));
                    }
                }
            }
        }
        let only_coulomb = mix == Mix { coulomb: true, ..Mix::default() };
        assert_eq!(eq_67(&oscillator).is_ok(), only_coulomb);
        let linear = !mix.coulomb && !mix.newton;
        assert_eq!(eq_36(&oscillator).is_ok(), linear);
        assert_eq!(eq_46(&oscillator, state(0.1, 0.0)).is_ok(), linear);
        assert_eq!(eq_20(&oscillator, state(0.1, 0.0)).is_ok(), mix == Mix::default());
    }
}

#[test]
fn what_is_not_finite_is_refused() {
    let oscillator = dry(0.02);
    for release in [
        State { position: f64::NAN, velocity: 0.0 },
        State { position: 0.1, velocity: f64::INFINITY },
    ] {
        for formula in [Formula::printed, Formula::corrected] {
            let refused = formula(&oscillator, release);
            assert!(matches!(refused, Err(Error::Parameter { .. })), "{refused:?}");
        }
    }
    let formula = Formula::printed(&oscillator, state(0.1, 0.0)).unwrap();
    for time in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(formula.at(time), Err(Error::Parameter { name: "time", .. })));
    }
    let huge = Formula::printed(&oscillator, state(1e308, 1e308)).unwrap();
    assert!(matches!(huge.at(1.0), Err(Error::Derived { .. })));
}

#[test]
fn the_mode_is_the_direction_just_after() {
    let formula = Formula::printed(&undamped(1.0, 1.0), state(1.0, 0.0)).unwrap();
    assert_eq!(formula.at(0.0).unwrap().mode, Mode::Backward);
    assert_eq!(formula.at(4.0).unwrap().mode, Mode::Forward);
    let resting = Formula::printed(&undamped(1.0, 1.0), state(0.0, 0.0)).unwrap();
    assert_eq!(resting.at(1.0).unwrap().mode, Mode::Stuck);
}
