//! What friction does to the order of each method, as a table in Markdown.
//!
//! `cargo run --release -p federpendel --example orders`

use federpendel::lens;
use federpendel::scheme::{SCHEMES, Scheme, Setting};
use federpendel::{
    Coulomb, Error, Friction, Motion, Newton, NormalForce, Oscillator, Result, State, Stokes,
};

/// A motion and the length of its record, s.
type Case = (&'static str, Motion, f64);

fn main() -> Result<()> {
    let motions = motions()?;
    let names: Vec<_> = motions.iter().map(|case| case.0).collect();
    println!("| method | declared | {} | at rest |", names.join(" | "));
    println!("|---|---:|{}---|", "---:|".repeat(names.len()));
    for scheme in &SCHEMES {
        let orders: Vec<_> = motions.iter().map(|case| order(case, scheme)).collect();
        let rest = at_rest(&motions[3].1, scheme);
        println!("| `{}` | {} | {} | {rest} |", scheme.name, scheme.order, orders.join(" | "));
    }
    Ok(())
}

/// The reference cases: 0.5 kg on 20 N/m, released at rest at 10 cm, until shortly after the rest or for twelve
/// periods.
fn motions() -> Result<Vec<Case>> {
    let dry = |kinetic| Coulomb::new(kinetic, kinetic, NormalForce::Weight(9.81));
    let all = Friction {
        stokes: Some(Stokes::new(0.05)?),
        coulomb: Some(dry(0.005)?),
        newton: Some(Newton::new(0.047)?),
    };
    let frictions: [(&str, Friction, f64); 5] = [
        ("none", Friction::NONE, 11.92),
        ("Stokes", Stokes::new(0.2)?.into(), 11.92),
        ("Newton", Newton::new(0.235)?.into(), 11.92),
        ("Coulomb", dry(0.02)?.into(), 5.5),
        ("all three", all, 14.0),
    ];
    let motion = |(name, friction, duration)| {
        let oscillator = Oscillator::new(0.5, 20.0, friction)?;
        Ok((name, Motion::new(oscillator, State::new(0.1, 0.0)?)?, duration))
    };
    frictions.into_iter().map(motion).collect()
}

fn order((_, motion, duration): &Case, scheme: &Scheme) -> String {
    let ladder = lens::ladder(motion, scheme, &Setting::of(motion), *duration);
    match (ladder.order(), ladder.failed.map(|failed| failed.error)) {
        // Adding zero turns −0.0 into 0.0.
        (Some(order), _) => format!("{:.1}", (10.0 * order).round() / 10.0 + 0.0),
        (None, Some(Error::StepLimit { time, .. })) => format!("fails at {time:.2} s"),
        (None, Some(error)) => error.to_string(),
        (None, None) => "–".into(),
    }
}

fn at_rest(motion: &Motion, scheme: &Scheme) -> String {
    match lens::ending(motion, scheme, &Setting::of(motion)) {
        Ok(Some(ending)) if ending.sticks => "sticks".into(),
        Ok(Some(ending)) => match ending.creep {
            Some(creep) => format!("creeps {:.2} µm/s", 1e6 * creep),
            None => "swings on".into(),
        },
        Ok(None) => "–".into(),
        Err(error) => error.to_string(),
    }
}
