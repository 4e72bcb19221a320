//! One motion, in every form.

use std::io::{self, Write};

use federpendel::even_times;
use federpendel::{Sample, State};
use federpendel_text::Catalogue;
use federpendel_text::plot::{
    AveragedLaw, DecrementData, EnergyData, MotionData, PhaseData, Plot, swings,
};

use super::summary::{self, Noise};
use super::{Format, Report, Style, csv, json, plot};
use crate::progress::Progress;
use crate::record::Record;
use crate::sensor::Sensor;

/// What a picture of a motion shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Picture {
    /// x(t) with its envelope and turning points.
    #[default]
    Motion,
    /// The phase portrait with the sticking band.
    Phase,
    /// Where the energy goes.
    Energy,
    /// Loss per swing against amplitude.
    Decrement,
}

impl Picture {
    /// All of them.
    pub const ALL: [Picture; 4] =
        [Picture::Motion, Picture::Phase, Picture::Energy, Picture::Decrement];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Picture::Motion => "motion",
            Picture::Phase => "phase",
            Picture::Energy => "energy",
            Picture::Decrement => "decrement",
        }
    }

    /// The picture of this name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|picture| picture.name() == name)
    }

    /// The picture of `record`.
    pub(super) fn plot(self, record: &Record, catalogue: &Catalogue) -> io::Result<Plot> {
        match self {
            Picture::Motion => motion(record, catalogue),
            Picture::Phase => phase(record, catalogue),
            Picture::Energy => energy(record, catalogue),
            Picture::Decrement => Ok(decrement(record, catalogue)),
        }
    }
}

/// A record, and what its pictures show.
pub(crate) struct MotionReport<'a> {
    /// The record.
    pub record: &'a Record,
    /// What its pictures show.
    pub picture: Picture,
    /// What records it in tables, if not the computer.
    pub sensor: Option<Sensor>,
}

impl Report for MotionReport<'_> {
    fn record(&self) -> &Record {
        self.record
    }

    fn render(&self, format: Format, style: Style<'_>, out: &mut dyn Write) -> io::Result<()> {
        let plot = || self.picture.plot(self.record, style.catalogue);
        match format {
            Format::Summary => summary::write(self.record, &plot()?, style, out),
            Format::Csv => match &self.sensor {
                Some(sensor) => csv::write_recording(self.record, sensor, style.dialect, out),
                None => csv::write(self.record, style.dialect, out),
            },
            Format::Json => json::write(self.record, out),
            Format::Svg | Format::Png => plot::write(&plot()?, format, style.background, out),
            Format::Html => Err(io::ErrorKind::Unsupported.into()),
        }
    }
}

/// x(t) with its envelope and turning points, and beside it the method asked for.
fn motion(record: &Record, catalogue: &Catalogue) -> io::Result<Plot> {
    let drawn = record.drawn(&Progress::silent()).map_err(io::Error::other)?;
    let points = |samples: &[Sample]| -> Vec<(f64, f64)> {
        samples.iter().map(|sample| (sample.time, sample.position)).collect()
    };
    let (times, positions): (Vec<f64>, Vec<f64>) = points(&drawn.exact).into_iter().unzip();
    let outcome = Noise::of(record)?.outcome(record.outcome);
    let turning_points = record.plotted_turning_points();
    let oscillator = record.motion.oscillator();
    let State { position, velocity } = record.motion.release();
    let mut plot = Plot::motion(
        catalogue,
        &MotionData {
            mix: oscillator.friction().mix(),
            times: &times,
            positions: &positions,
            turning_points: &turning_points,
            from_rest: velocity == 0.0 && position != 0.0,
            outcome: &outcome,
            sticking_offset: oscillator.sticking_offset(),
        },
    );
    if let Some(other) = &drawn.other {
        let points = points(other);
        plot.compare(catalogue, record.motion.kind(), record.method.name(), points);
    }
    Ok(plot)
}

/// v against x of the exact motion.
fn phase(record: &Record, catalogue: &Catalogue) -> io::Result<Plot> {
    let drawn = record.drawn(&Progress::silent()).map_err(io::Error::other)?;
    let states: Vec<State> = drawn.exact.iter().map(Sample::state).collect();
    let oscillator = record.motion.oscillator();
    Ok(Plot::phase(
        catalogue,
        &PhaseData {
            mix: oscillator.friction().mix(),
            states: &states,
            turning_points: &record.plotted_turning_points(),
            outcome: &Noise::of(record)?.outcome(record.outcome),
            sticking_offset: oscillator.sticking_offset(),
        },
    ))
}

/// Times at which the energies are drawn.
const ENERGIES: usize = 2001;

/// Kinetic and potential energy and the heat of each law.
fn energy(record: &Record, catalogue: &Catalogue) -> io::Result<Plot> {
    let ledgers = even_times(record.duration, ENERGIES)
        .and_then(|times| record.motion.ledger(&times))
        .map_err(io::Error::other)?;
    let mix = record.motion.oscillator().friction().mix();
    Ok(Plot::energy(catalogue, &EnergyData { mix, ledgers: &ledgers }))
}

/// Loss per swing against mean amplitude, with the law of each friction.
fn decrement(record: &Record, catalogue: &Catalogue) -> Plot {
    let State { position, velocity } = record.motion.release();
    let release = (velocity == 0.0).then_some(position.abs());
    let turns = record.turning_points().map(|point| point.position.abs());
    let amplitudes: Vec<f64> = release.into_iter().chain(turns).take(MOST_SWINGS).collect();
    let law = AveragedLaw::of(record.motion.oscillator());
    let data = DecrementData { law, swings: &swings(&amplitudes), mean_of: 1, length: "m" };
    Plot::decrement(catalogue, &data)
}

/// Most swings that the decrement plot takes in.
const MOST_SWINGS: usize = 100_000;
