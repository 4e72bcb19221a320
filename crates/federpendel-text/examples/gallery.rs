//! Draws motions of every kind, to look at: `cargo run --example gallery -- FOLDER`.

use std::error::Error;
use std::path::Path;
use std::{env, fs};

use federpendel::{Coulomb, Friction, Motion, Newton, NormalForce, Oscillator, State, Stokes};
use federpendel_text::plot::draw::{Background, Size, png, svg, terminal};
use federpendel_text::plot::{MotionData, Plot};
use federpendel_text::{Catalogue, Language};

/// Name, friction, position (m) and velocity (m/s) of release, duration (s).
type Case = (&'static str, Friction, f64, f64, f64);

fn cases() -> federpendel::Result<Vec<Case>> {
    let stokes = |damping| Stokes::new(damping).map(Friction::from);
    let coulomb =
        |kinetic, held| Coulomb::new(kinetic, held, NormalForce::Weight(9.81)).map(Friction::from);
    let all = Friction {
        stokes: Some(Stokes::new(0.05)?),
        coulomb: Some(Coulomb::new(0.005, 0.005, NormalForce::Weight(9.81))?),
        newton: Some(Newton::new(0.047)?),
    };
    Ok(vec![
        ("coulomb", coulomb(0.02, 0.02)?, 0.1, 0.0, 6.0),
        ("undamped", Friction::NONE, 0.1, 0.0, 12.0),
        ("stokes", stokes(0.2)?, 0.1, 0.0, 20.0),
        ("newton", Newton::new(0.235)?.into(), 0.1, -0.4, 20.0),
        ("all", all, 0.1, 0.0, 15.0),
        ("overdamped", stokes(20.0)?, 0.1, 0.0, 6.0),
        ("stuck", coulomb(0.2, 0.3)?, 0.001, 0.0, 1.0),
        ("nothing", Friction::NONE, 0.0, 0.0, 1.0),
        ("many", stokes(2e-6)?, 0.1, 0.0, 500_000.0),
        ("hundred", stokes(0.01)?, 0.1, 0.0, 100.0),
        ("short", Friction::NONE, 2e-6, 0.0, 0.001),
    ])
}

fn plot(catalogue: &Catalogue, case: &Case) -> federpendel::Result<Plot> {
    let (_, friction, position, velocity, duration) = *case;
    let oscillator = Oscillator::new(0.5, 20.0, friction)?;
    let motion = Motion::new(oscillator, State::new(position, velocity)?)?;
    let times: Vec<f64> = (0..2001).map(|i| duration * f64::from(i) / 2000.0).collect();
    let (mut positions, mut velocities) = (vec![0.0; 2001], vec![0.0; 2001]);
    motion.sample(&times, &mut positions, &mut velocities)?;
    let turning_points: Vec<_> =
        motion.turning_points().take_while(|point| point.time <= duration).collect();
    let data = MotionData {
        mix: friction.mix(),
        times: &times,
        positions: &positions,
        turning_points: &turning_points,
        from_rest: velocity == 0.0,
        outcome: &motion.outcome(),
        sticking_offset: oscillator.sticking_offset(),
    };
    Ok(Plot::motion(catalogue, &data))
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::args().nth(1).ok_or("usage: gallery FOLDER")?;
    let folder = Path::new(&folder);
    fs::create_dir_all(folder)?;
    for case in cases()? {
        for language in Language::ALL {
            let plot = plot(&Catalogue::new(language), &case)?;
            let file = |end: &str| folder.join(format!("{}-{}{end}", case.0, language.tag()));
            for (background, end) in [(Background::Light, ""), (Background::Dark, "-dark")] {
                let size = Size::default();
                fs::write(file(&format!("{end}.svg")), svg(&plot, size, background))?;
                fs::write(file(&format!("{end}.png")), png(&plot, size, background, 2.0)?)?;
            }
            let texts = [60, 80, 120, 200].map(|columns| terminal(&plot, columns, 24, false));
            fs::write(file(".txt"), texts.concat())?;
            fs::write(file(".ansi"), terminal(&plot, 80, 24, true))?;
        }
    }
    Ok(())
}
