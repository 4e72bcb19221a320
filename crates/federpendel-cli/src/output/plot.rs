//! Pictures of the motion.

use std::io::{self, Write};

use federpendel::{Sample, State};
use federpendel_text::Catalogue;
use federpendel_text::plot::draw::{Background, Size, png, svg, terminal};
use federpendel_text::plot::{MotionData, Plot};

use super::summary::Noise;
use crate::progress::Progress;
use crate::record::Record;

/// Device pixels per CSS pixel of a PNG, for sharp prints and screens.
const SCALE: f32 = 2.0;

pub(super) fn write_svg(
    record: &Record,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    let picture = svg(&plot(record, catalogue)?, Size::default(), Background::Light);
    out.write_all(picture.as_bytes())
}

pub(super) fn write_png(
    record: &Record,
    catalogue: &Catalogue,
    out: &mut dyn Write,
) -> io::Result<()> {
    let picture = png(&plot(record, catalogue)?, Size::default(), Background::Light, SCALE);
    out.write_all(&picture.map_err(io::Error::other)?)
}

pub(super) fn write_terminal(
    record: &Record,
    catalogue: &Catalogue,
    (columns, rows): (usize, usize),
    out: &mut dyn Write,
) -> io::Result<()> {
    let colour = console::colors_enabled();
    let text = terminal(&plot(record, catalogue)?, columns, rows, colour);
    out.write_all(text.as_bytes())
}

/// x(t) with its envelope and turning points, and beside it the method asked for.
fn plot(record: &Record, catalogue: &Catalogue) -> io::Result<Plot> {
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
