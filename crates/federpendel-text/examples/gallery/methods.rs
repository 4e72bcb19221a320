//! Plots of the methods beside the exact motion: overlay, errors, convergence, work.

use std::f64::consts::PI;

use federpendel::lens::{Course, Rung, ladder};
use federpendel::scheme::{SCHEMES, Scheme, Setting};
use federpendel_text::Catalogue;
use federpendel_text::plot::{
    ConvergenceData, ErrorsData, MethodCurve, MethodErrors, MethodRungs, OverlayData, Plot,
};

use super::Drawn;
use super::motions::{Case, Record, cases, record};

/// A method on its own steps: times, positions, errors.
pub struct Followed {
    pub name: &'static str,
    pub times: Vec<f64>,
    pub positions: Vec<f64>,
    errors: Vec<f64>,
}

/// Steps per undamped period in the overlay, coarse enough to show differences, and for the errors.
const STEPS: [f64; 2] = [24.0, 1000.0];

pub fn course(record: &Record, scheme: &Scheme, steps: f64) -> Option<Followed> {
    let period = 2.0 * PI / record.motion.oscillator().angular_frequency();
    let setting = Setting::of(&record.motion).with_time_step(period / steps).ok()?;
    let mut course = Course::new(scheme, &setting).ok()?;
    let duration = *record.times.last()?;
    let (mut times, mut positions) = (Vec::new(), Vec::new());
    loop {
        let (time, state) = course.now();
        times.push(time);
        positions.push(state.position);
        if time >= duration || course.step().is_err() {
            break;
        }
    }
    let (mut exact, mut velocities) = (vec![0.0; times.len()], vec![0.0; times.len()]);
    record.motion.sample(&times, &mut exact, &mut velocities).ok()?;
    let errors = positions.iter().zip(&exact).map(|(x, exact)| x - exact).collect();
    Some(Followed { name: scheme.name, times, positions, errors })
}

pub fn plots(catalogue: &Catalogue) -> Drawn {
    let mut drawn = Vec::new();
    let shown =
        ["coulomb", "undamped", "stokes", "newton", "all", "stuck", "nothing", "overdamped"];
    for case in cases()?.iter().filter(|case| shown.contains(&case.0)) {
        let record = record(case)?;
        let mut add = |kind: &str, plot| drawn.push((format!("{kind}-{}", case.0), plot));
        let [coarse, fine] = STEPS.map(|steps| -> Vec<_> {
            SCHEMES.iter().filter_map(|scheme| course(&record, scheme, steps)).collect()
        });
        add("overlay", overlay(catalogue, &record, &coarse));
        add("overlay-two", overlay(catalogue, &record, &coarse[coarse.len() - 2..]));
        add("errors", errors(catalogue, &record, case, &fine));
        add("errors-two", errors(catalogue, &record, case, &fine[..2]));
        let setting = Setting::of(&record.motion);
        let rungs: Vec<(&Scheme, Vec<Rung>)> = SCHEMES
            .iter()
            .filter_map(|scheme| {
                let rungs = ladder(&record.motion, scheme, &setting, case.4).rungs;
                (!rungs.is_empty()).then_some((scheme, rungs))
            })
            .collect();
        let methods: Vec<_> = rungs
            .iter()
            .enumerate()
            .map(|(number, (scheme, rungs))| {
                let Scheme { name, order, .. } = **scheme;
                MethodRungs { name, number, order, rungs }
            })
            .collect();
        let data = ConvergenceData { mix: case.1.mix(), methods: &methods };
        add("convergence", Plot::convergence(catalogue, &data));
        add("work", Plot::work(catalogue, &data));
    }
    Ok(drawn)
}

fn overlay(catalogue: &Catalogue, record: &Record, courses: &[Followed]) -> Plot {
    let methods: Vec<_> = courses
        .iter()
        .enumerate()
        .map(|(number, course)| MethodCurve {
            name: course.name,
            number,
            times: &course.times,
            positions: &course.positions,
        })
        .collect();
    let oscillator = record.motion.oscillator();
    let data = OverlayData {
        mix: oscillator.friction().mix(),
        kind: record.motion.kind(),
        times: &record.times,
        positions: &record.positions,
        turning_points: &record.turning_points,
        outcome: &record.motion.outcome(),
        sticking_offset: oscillator.sticking_offset(),
        methods: &methods,
    };
    Plot::overlay(catalogue, &data)
}

fn errors(catalogue: &Catalogue, record: &Record, case: &Case, courses: &[Followed]) -> Plot {
    let methods: Vec<_> = courses
        .iter()
        .enumerate()
        .map(|(number, course)| MethodErrors {
            name: course.name,
            number,
            times: &course.times,
            errors: &course.errors,
        })
        .collect();
    let amplitude = case.2.abs().max(case.3.abs() / record.motion.oscillator().angular_frequency());
    Plot::errors(catalogue, &ErrorsData { mix: case.1.mix(), amplitude, methods: &methods })
}
