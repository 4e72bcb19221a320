//! What friction does to the order of each method, as a table in Markdown.
//!
//! `cargo run --release -p federpendel --example orders`

use federpendel::lens;
use federpendel::scheme::{SCHEMES, Scheme, Setting};
use federpendel::{
    Coulomb, Error, Friction, Motion, Newton, NormalForce, Oscillator, Result, State, Stokes,
};

/// Length of the motions, s: some twelve periods, and beyond the rest of those that rest.
const DURATION: f64 = 15.0;

fn main() -> Result<()> {
    let motions = motions()?;
    let names: Vec<_> = motions.iter().map(|(name, _)| *name).collect();
    println!("| method | declared | {} | at rest |", names.join(" | "));
    println!("|---|---:|{}---|", "---:|".repeat(names.len()));
    for scheme in &SCHEMES {
        let orders: Vec<_> = motions.iter().map(|(_, motion)| order(motion, scheme)).collect();
        let rest = at_rest(&motions[3].1, scheme);
        println!("| `{}` | {} | {} | {rest} |", scheme.name, scheme.order, orders.join(" | "));
    }
    Ok(())
}

/// The reference cases: 0.5 kg on 20 N/m, released at rest at 10 cm.
fn motions() -> Result<Vec<(&'static str, Motion)>> {
    let dry = |kinetic| Coulomb::new(kinetic, kinetic, NormalForce::Weight(9.81));
    let all = Friction {
        stokes: Some(Stokes::new(0.05)?),
        coulomb: Some(dry(0.005)?),
        newton: Some(Newton::new(0.047)?),
    };
    let frictions: [(&str, Friction); 5] = [
        ("none", Friction::NONE),
        ("Stokes", Stokes::new(0.2)?.into()),
        ("Newton", Newton::new(0.235)?.into()),
        ("Coulomb", dry(0.02)?.into()),
        ("all three", all),
    ];
    let motion = |(name, friction)| {
        let oscillator = Oscillator::new(0.5, 20.0, friction)?;
        Ok((name, Motion::new(oscillator, State::new(0.1, 0.0)?)?))
    };
    frictions.into_iter().map(motion).collect()
}

fn order(motion: &Motion, scheme: &Scheme) -> String {
    match lens::ladder(motion, scheme, &Setting::of(motion), DURATION) {
        Ok(rungs) => {
            lens::order(&rungs).map_or("–".into(), |order| format!("{:.1}", order.abs()))
        }
        Err(Error::StepLimit { time, .. }) => format!("fails at {time:.2} s"),
        Err(error) => error.to_string(),
    }
}

fn at_rest(motion: &Motion, scheme: &Scheme) -> String {
    match lens::ending(motion, scheme, &Setting::of(motion)) {
        Ok(Some(ending)) if ending.sticks => "sticks".into(),
        Ok(Some(ending)) => format!("creeps {:.2} µm/s", 1e6 * ending.creep),
        Ok(None) => "–".into(),
        Err(error) => error.to_string(),
    }
}
