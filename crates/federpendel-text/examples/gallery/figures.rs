//! Plots that stand within a report: roots, several motions, what methods make of a motion.

use federpendel::article::Formula;
use federpendel::scheme::SCHEMES;
use federpendel::{Friction, Newton, Stokes};
use federpendel_text::plot::{
    Course, CoursesData, Losses, LossesData, MethodCurve, OverlayData, Plot, Role, RootsData,
};
use federpendel_text::{Catalogue, Language};

use super::Drawn;
use super::methods::course;
use super::motions::{Record, cases, record};

pub fn plots(catalogue: &Catalogue) -> Drawn {
    let mut drawn = Vec::new();
    let mut add = |name: &str, plot| drawn.push((name.to_owned(), plot));
    let omega0 = 40f64.sqrt();
    for (name, ratio) in
        [("weak", 0.03), ("half", 0.5), ("critical", 1.0), ("strong", 1.6), ("stronger", 12.0)]
    {
        let data = RootsData { omega0, gamma: ratio * omega0 };
        add(&format!("roots-{name}"), Plot::roots(catalogue, &data));
    }
    add("courses-regimes", regimes(catalogue)?);
    let laws = laws()?;
    let title = words(catalogue, "Which friction is it?", "Welche Reibung ist es?");
    add("courses-laws", courses(catalogue, title, &laws));
    add("losses", losses(catalogue, &laws));
    for case in cases()? {
        let duration = match case.0 {
            "coulomb" => 20.0,
            "all" | "stokes" | "stuck" => case.4,
            _ => continue,
        };
        let record = record(&(case.0, case.1, case.2, case.3, duration))?;
        add(&format!("beside-{}", case.0), over(catalogue, &record, Plot::beside));
        add(&format!("after-rest-{}", case.0), over(catalogue, &record, Plot::after_rest));
    }
    Ok(drawn)
}

fn words<'a>(catalogue: &Catalogue, english: &'a str, german: &'a str) -> &'a str {
    if catalogue.language() == Language::German { german } else { english }
}

/// Motions with what each is called and stands for.
type Named = Vec<(&'static str, Role, Record)>;

fn regimes(catalogue: &Catalogue) -> federpendel::Result<Plot> {
    let omega0 = 40f64.sqrt();
    let mut named: Named = Vec::new();
    for (n, (name, ratio)) in
        [("γ < ω₀", 0.1), ("γ = ω₀", 1.0), ("γ > ω₀", 3.0)].into_iter().enumerate()
    {
        // D = 2mγ.
        let friction = Stokes::new(ratio * omega0)?.into();
        named.push((name, Role::Comparison(n), record(&("", friction, 0.1, 0.0, 5.0))?));
    }
    let title = words(catalogue, "Three regimes", "Schwingfall, Grenzfall, Kriechfall");
    Ok(courses(catalogue, title, &named))
}

/// One motion for each law, as strong as the others at large amplitudes.
fn laws() -> federpendel::Result<Named> {
    let frictions: [(&str, Role, Friction); 3] = [
        ("Stokes", Role::Stokes, Stokes::new(0.2)?.into()),
        ("Coulomb", Role::Coulomb, cases()?[0].1),
        ("Newton", Role::Newton, Newton::new(1.5)?.into()),
    ];
    let named = frictions
        .into_iter()
        .map(|(name, role, friction)| Ok((name, role, record(&("", friction, 0.1, 0.0, 12.0))?)));
    named.collect()
}

fn courses(catalogue: &Catalogue, title: &str, named: &Named) -> Plot {
    let curve = |(name, role, record): &'_ (&'static str, Role, Record)| {
        (*name, *role, record.times.clone(), record.positions.clone())
    };
    let owned: Vec<_> = named.iter().map(curve).collect();
    let curves: Vec<_> = owned
        .iter()
        .map(|(name, role, times, positions)| Course { name, role: *role, times, positions })
        .collect();
    Plot::courses(catalogue, &CoursesData { title, curves: &curves })
}

fn losses(catalogue: &Catalogue, named: &Named) -> Plot {
    let amplitudes: Vec<Vec<f64>> = named
        .iter()
        .map(|(_, _, record)| {
            let turns = record.turning_points.iter().map(|point| point.position);
            std::iter::once(record.positions[0]).chain(turns).collect()
        })
        .collect();
    let motions: Vec<_> = named
        .iter()
        .zip(&amplitudes)
        .map(|((name, role, record), amplitudes)| {
            let oscillator = record.motion.oscillator();
            Losses { name, role: *role, oscillator, amplitudes }
        })
        .collect();
    Plot::losses(catalogue, &LossesData { motions: &motions })
}

/// The article's formula in print, put right, and two methods over a motion.
fn over(
    catalogue: &Catalogue,
    record: &Record,
    plot: fn(&Catalogue, &OverlayData<'_>) -> Plot,
) -> Plot {
    let (oscillator, release) = (record.motion.oscillator(), record.motion.release());
    let mut named: Vec<(&str, Vec<f64>, Vec<f64>)> = Vec::new();
    for (name, formula) in [
        (
            words(catalogue, "Formula in print", "Gedruckte Formel"),
            Formula::printed(oscillator, release),
        ),
        (
            words(catalogue, "Formula put right", "Berichtigte Formel"),
            Formula::corrected(oscillator, release),
        ),
    ] {
        let Ok(formula) = formula else { continue };
        let positions = record.times.iter().map(|t| formula.at(*t).map_or(0.0, |at| at.position));
        named.push((name, record.times.clone(), positions.collect()));
    }
    for scheme in
        SCHEMES.iter().filter(|scheme| ["article-scheme", "rk4-tanh"].contains(&scheme.name))
    {
        if let Some(course) = course(record, scheme, 100.0) {
            named.push((course.name, course.times, course.positions));
        }
    }
    let methods: Vec<_> = named
        .iter()
        .enumerate()
        .map(|(number, (name, times, positions))| MethodCurve { name, number, times, positions })
        .collect();
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
    plot(catalogue, &data)
}
