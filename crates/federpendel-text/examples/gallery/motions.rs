//! Plots of one motion: displacement, phase portrait, energy, loss of amplitude.

use federpendel::{
    Coulomb, Friction, Motion, Newton, NormalForce, Oscillator, State, Stokes, TurningPoint,
};
use federpendel_text::Catalogue;
use federpendel_text::plot::{
    AveragedLaw, DecrementData, EnergyData, MotionData, PhaseData, Plot, swings,
};

use super::Drawn;

/// Name, friction, position (m) and velocity (m/s) of release, duration (s).
pub type Case = (&'static str, Friction, f64, f64, f64);

pub fn cases() -> federpendel::Result<Vec<Case>> {
    let stokes = |damping| Stokes::new(damping).map(Friction::from);
    let coulomb =
        |kinetic, held| Coulomb::new(kinetic, held, NormalForce::Weight(9.81)).map(Friction::from);
    let all = Friction {
        stokes: Some(Stokes::new(0.05)?),
        coulomb: Some(Coulomb::new(0.002, 0.003, NormalForce::Weight(9.81))?),
        newton: Some(Newton::new(0.235)?),
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

/// A motion and its record.
pub struct Record {
    pub motion: Motion,
    pub times: Vec<f64>,
    pub positions: Vec<f64>,
    pub velocities: Vec<f64>,
    pub turning_points: Vec<TurningPoint>,
}

pub fn record(case: &Case) -> federpendel::Result<Record> {
    let (_, friction, position, velocity, duration) = *case;
    let oscillator = Oscillator::new(0.5, 20.0, friction)?;
    let motion = Motion::new(oscillator, State::new(position, velocity)?)?;
    let times: Vec<f64> = (0..2001).map(|i| duration * f64::from(i) / 2000.0).collect();
    let (mut positions, mut velocities) = (vec![0.0; 2001], vec![0.0; 2001]);
    motion.sample(&times, &mut positions, &mut velocities)?;
    let turning_points =
        motion.turning_points().take_while(|point| point.time <= duration).collect();
    Ok(Record { motion, times, positions, velocities, turning_points })
}

pub fn plots(catalogue: &Catalogue) -> Drawn {
    let mut drawn = Vec::new();
    for case in cases()? {
        let record = record(&case)?;
        let mut add = |kind: &str, plot| drawn.push((format!("{kind}-{}", case.0), plot));
        add("motion", motion(catalogue, &record, case.3 == 0.0));
        // A closed curve of very many swings is no picture.
        if case.0 != "many" {
            add("phase", phase(catalogue, &record));
            let ledgers = record.motion.ledger(&record.times)?;
            let data = EnergyData { mix: case.1.mix(), ledgers: &ledgers };
            add("energy", Plot::energy(catalogue, &data));
            let release = (case.3 == 0.0).then_some(case.2);
            let turns = record.turning_points.iter().map(|point| point.position);
            let amplitudes: Vec<_> = release.into_iter().chain(turns).collect();
            let law = AveragedLaw::of(record.motion.oscillator());
            let data = DecrementData { law, swings: &swings(&amplitudes), mean_of: 1, length: "m" };
            add("decrement", Plot::decrement(catalogue, &data));
        }
    }
    Ok(drawn)
}

fn motion(catalogue: &Catalogue, record: &Record, from_rest: bool) -> Plot {
    let oscillator = record.motion.oscillator();
    let data = MotionData {
        mix: oscillator.friction().mix(),
        times: &record.times,
        positions: &record.positions,
        turning_points: &record.turning_points,
        from_rest,
        outcome: &record.motion.outcome(),
        sticking_offset: oscillator.sticking_offset(),
    };
    Plot::motion(catalogue, &data)
}

fn phase(catalogue: &Catalogue, record: &Record) -> Plot {
    let oscillator = record.motion.oscillator();
    let states: Vec<_> = record
        .positions
        .iter()
        .zip(&record.velocities)
        .map(|(&position, &velocity)| State { position, velocity })
        .collect();
    let data = PhaseData {
        mix: oscillator.friction().mix(),
        states: &states,
        turning_points: &record.turning_points,
        outcome: &record.motion.outcome(),
        sticking_offset: oscillator.sticking_offset(),
    };
    Plot::phase(catalogue, &data)
}
