//! How long a large recording takes to read, and how much memory: `cargo run --release -p federpendel-fit --example
//! reading -- [ROWS] [standard|german|phyphox]`.

use std::io::{self, BufWriter, Write};
use std::time::Instant;

use federpendel_fit::read::{Choice, recordings_from};

fn main() -> io::Result<()> {
    let mut arguments = std::env::args().skip(1);
    let rows = arguments.next().and_then(|text| text.parse().ok()).unwrap_or(10_000_000);
    let dialect = arguments.next().unwrap_or_else(|| "standard".to_owned());
    let mut file = BufWriter::new(tempfile::tempfile()?);
    write(&mut file, rows, &dialect)?;
    let file = file.into_inner()?;
    let megabytes = file.metadata()?.len() as f64 / 1e6;
    let began = Instant::now();
    let read = match recordings_from(file, &Choice::default()) {
        Ok(read) => read,
        Err(error) => return Err(io::Error::other(error)),
    };
    let seconds = began.elapsed().as_secs_f64();
    println!("{dialect}: {rows} rows, {megabytes:.0} MB of text");
    println!(
        "column {}, {} rows, notes {:?}",
        read[0].value.label,
        read[0].recording.times.len(),
        read[0].notes
    );
    println!("{seconds:.2} s, {:.0} MB/s", megabytes / seconds);
    if let Some(peak) = peak() {
        println!("{:.0} MB of memory at most", peak as f64 / 1e3);
    }
    Ok(())
}

/// A decaying oscillation.
fn write(file: &mut impl Write, rows: usize, dialect: &str) -> io::Result<()> {
    file.write_all(match dialect {
        "phyphox" => {
            b"\"Time (s)\",\"Acceleration x (m/s^2)\",\"Acceleration y (m/s^2)\",\"Acceleration z (m/s^2)\"\n"
        }
        "german" => b"Zeit (s);Auslenkung (cm)\n",
        _ => b"Time (s),Position (m)\n",
    })?;
    for row in 0..rows {
        let time = row as f64 * 1e-3;
        let value = (-1e-4 * time).exp() * (6.3 * time).cos();
        match dialect {
            "phyphox" => {
                writeln!(file, "{time:.9E},{:.9E},{value:.9E},{:.9E}", value * 0.1, value * 0.2)
            }
            "german" => {
                file.write_all(format!("{time:.3};{value:.6}\n").replace('.', ",").as_bytes())
            }
            _ => writeln!(file, "{time:.3},{value:.9}"),
        }?;
    }
    Ok(())
}

/// The most memory this process has held so far, kB, where Linux tells.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}
