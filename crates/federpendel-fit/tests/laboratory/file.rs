//! Recordings as the programs write them.

use std::error::Error;
use std::io::{Cursor, Write};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use super::{EXPERIMENTS, Experiment};
use crate::synthetic::Random;

type Rows = Vec<(f64, f64)>;

/// A file: its name and what stands in it.
type File = (&'static str, Vec<u8>);

/// Every file. The same at every call.
pub fn files() -> Result<Vec<File>, Box<dyn Error>> {
    let mut recorded: Vec<(&Experiment, Rows)> = Vec::new();
    for (seed, experiment) in (1..).zip(&EXPERIMENTS) {
        recorded.push((experiment, experiment.record(seed)?));
    }
    let [phyphox, german, tracker, vernier, first, second, own] = &recorded[..] else {
        return Err("seven recordings".into());
    };
    Ok(vec![
        (phyphox.0.file(), telephone(&phyphox.1, ',', false).into_bytes()),
        (german.0.file(), archive(&telephone(&german.1, ';', true))?),
        (tracker.0.file(), film(&tracker.1).into_bytes()),
        (vernier.0.file(), detector(&vernier.1).into_bytes()),
        (first.0.file(), runs(&first.1, &second.1).into_bytes()),
        (own.0.file(), table(&own.1).into_bytes()),
    ])
}

/// phyphox, "Acceleration without g": three components in nine digits and their size.
fn telephone(rows: &Rows, separator: char, comma: bool) -> String {
    let names = ["Acceleration x", "Acceleration y", "Acceleration z", "Absolute acceleration"];
    let mut header = vec!["\"Time (s)\"".to_owned()];
    header.extend(names.map(|name| format!("\"{name} (m/s^2)\"")));
    let mut random = Random(99);
    let mut lines = vec![header.join(&separator.to_string())];
    for &(time, y) in rows {
        // A telephone does not hang quite straight.
        let (x, z) = (0.03 * y + 0.02 * random.normal(), -0.05 * y + 0.04 * random.normal());
        let size = (x * x + y * y + z * z).sqrt();
        let cells = [time, x, y, z, size].map(scientific);
        lines.push(cells.join(&separator.to_string()));
    }
    let text = lines.join("\n") + "\n";
    if comma { text.replace('.', ",") } else { text }
}

/// `9.543418407E0`.
fn scientific(value: f64) -> String {
    format!("{value:.9e}").replace('e', "E")
}

/// The archive that phyphox exports.
fn archive(table: &str) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        // The archive is the same whenever it is made.
        .last_modified_time(DateTime::default());
    for (name, text) in [
        ("Raw Data.csv", table),
        ("meta/device.csv", "\"property\";\"value\"\n\"deviceModel\";\"federpendel\"\n"),
    ] {
        archive.start_file(name, options)?;
        archive.write_all(text.as_bytes())?;
    }
    Ok(archive.finish()?.into_inner())
}

/// Tracker: the name of the track, then columns with a tab after each; where the mark was lost the cells
/// are empty.
fn film(rows: &Rows) -> String {
    let lost = |i: usize| (60..63).contains(&i);
    let line = |(i, (time, x)): (usize, &(f64, f64))| match lost(i) {
        true => format!("{time:.6E}\t\t\t\n"),
        false => format!("{time:.6E}\t{x:.6E}\t{:.6E}\t\n", 0.002),
    };
    let lines: String = rows.iter().enumerate().map(line).collect();
    format!("block\nt\tx\ty\t\n{lines}")
}

/// Vernier Graphical Analysis.
fn detector(rows: &Rows) -> String {
    let line = |(time, x): &(f64, f64)| format!("{time:.2},{x:.4}\n");
    let lines: String = rows.iter().map(line).collect();
    format!("Latest: Time (s),Latest: Position (m)\n{lines}")
}

/// PASCO Capstone: two runs side by side.
fn runs(first: &Rows, second: &Rows) -> String {
    let line = |((t1, x1), (t2, x2)): (&(f64, f64), &(f64, f64))| {
        format!("{t1:.3},{x1:.4},{t2:.3},{x2:.4}\n")
    };
    let lines: String = first.iter().zip(second).map(line).collect();
    format!("Time (s) Run #1,Position (m) Run #1,Time (s) Run #2,Position (m) Run #2\n{lines}")
}

/// Our own, for a German spreadsheet.
fn table(rows: &Rows) -> String {
    let line = |(time, v): &(f64, f64)| format!("{time:.2};{v:.4}\n").replace('.', ",");
    let lines: String = rows.iter().map(line).collect();
    format!("Time (s);Velocity (m/s)\n{lines}")
}
