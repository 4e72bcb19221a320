//! Tables and numbers in Markdown.

use federpendel_benches::clock::Timing;

/// A heading, a table and its rows.
pub fn table(heading: &str, columns: &[&str], rows: &[Vec<String>]) -> String {
    let mut text = format!("### {heading}\n\n| {} |\n", columns.join(" | "));
    text += &format!("|---|{}\n", "---:|".repeat(columns.len() - 1));
    for row in rows {
        text += &format!("| {} |\n", row.join(" | "));
    }
    text + "\n"
}

/// A time with three digits.
pub fn seconds(value: f64) -> String {
    let (scaled, unit) = match value {
        v if v < 0.9995e-6 => (v * 1e9, "ns"),
        v if v < 0.9995e-3 => (v * 1e6, "µs"),
        v if v < 0.9995 => (v * 1e3, "ms"),
        v => (v, "s"),
    };
    format!("{} {unit}", digits(scaled))
}

/// Least and median.
pub fn timing(timing: Timing) -> String {
    format!("{} / {}", seconds(timing.least), seconds(timing.median))
}

/// How many times longer the peer took, by the medians of the same rounds.
pub fn ratio(peer: Timing, ours: Timing) -> String {
    format!("{} ×", digits(peer.median / ours.median))
}

/// Three digits, or as many as stand before the point.
pub fn digits(value: f64) -> String {
    let places = match value {
        v if v < 9.995 => 2,
        v if v < 99.95 => 1,
        _ => 0,
    };
    format!("{value:.places$}")
}
