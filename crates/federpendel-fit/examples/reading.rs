//! How long a large recording takes to read, and how much memory: `cargo run --release -p federpendel-fit --example
//! reading -- [ROWS] [standard|german|phyphox]`.

use std::fmt::Write;
use std::time::Instant;

use federpendel_fit::read::{Choice, recordings};

fn main() {
    let mut arguments = std::env::args().skip(1);
    let rows = arguments.next().and_then(|text| text.parse().ok()).unwrap_or(10_000_000);
    let dialect = arguments.next().unwrap_or_else(|| "standard".to_owned());
    let text = table(rows, &dialect);
    let before = peak();
    let began = Instant::now();
    let read = match recordings(text.as_bytes(), &Choice::default()) {
        Ok(read) => read,
        Err(error) => return println!("{error}"),
    };
    let seconds = began.elapsed().as_secs_f64();
    println!("{dialect}: {rows} rows, {:.0} MB of text", text.len() as f64 / 1e6);
    println!(
        "column {}, {} rows, notes {:?}",
        read[0].value.label,
        read[0].recording.times.len(),
        read[0].notes
    );
    println!("{seconds:.2} s, {:.0} MB/s", text.len() as f64 / 1e6 / seconds);
    if let (Some(before), Some(after)) = (before, peak()) {
        println!("{:.0} MB of memory beside the text", (after - before) as f64 / 1e3);
    }
}

/// A decaying oscillation.
fn table(rows: usize, dialect: &str) -> String {
    let mut text = String::with_capacity(rows * 100);
    text += match dialect {
        "phyphox" => {
            "\"Time (s)\",\"Acceleration x (m/s^2)\",\"Acceleration y (m/s^2)\",\"Acceleration z (m/s^2)\"\n"
        }
        "german" => "Zeit (s);Auslenkung (cm)\n",
        _ => "Time (s),Position (m)\n",
    };
    let begin = text.len();
    for row in 0..rows {
        let time = row as f64 * 1e-3;
        let value = (-1e-4 * time).exp() * (6.3 * time).cos();
        // A string takes everything.
        let _ = match dialect {
            "phyphox" => {
                writeln!(text, "{time:.9E},{:.9E},{value:.9E},{:.9E}", value * 0.1, value * 0.2)
            }
            "german" => writeln!(text, "{time:.3};{value:.6}"),
            _ => writeln!(text, "{time:.3},{value:.9}"),
        };
    }
    if dialect == "german" {
        text[..begin].to_owned() + &text[begin..].replace('.', ",")
    } else {
        text
    }
}

/// The most memory this process has held so far, kB, where Linux tells.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}
