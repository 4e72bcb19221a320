//! The heading of a column: a name, a unit, the run it belongs to; "Acceleration x (m/s^2)", "t / s", "Zeit in ms",
//! "angle_deg", "Latest: Time (s)", "Position (m) Run #1".

use super::unit;

/// A heading, taken apart.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Heading {
    /// As it stands in the file.
    pub label: String,
    /// Without unit and run.
    pub name: String,
    /// The unit; empty if there is none.
    pub unit: String,
    /// The run.
    pub run: Option<String>,
}

/// Words that begin the name of a run, in front of its number.
const RUN: &[&str] = &[
    "run",
    "lauf",
    "durchgang",
    "durchlauf",
    "messung",
    "versuch",
    "trial",
    "data set",
    "datensatz",
];

/// Units that are written behind a name and an underscore.
const SUFFIXES: &[(&str, &str)] = &[
    ("_m_s2", "m/s^2"),
    ("_m_s_2", "m/s^2"),
    ("_ms2", "m/s^2"),
    ("_mps2", "m/s^2"),
    ("_rad_s", "rad/s"),
    ("_deg_s", "deg/s"),
    ("_cm_s", "cm/s"),
    ("_mm_s", "mm/s"),
    ("_m_s", "m/s"),
    ("_mps", "m/s"),
    ("_dps", "deg/s"),
    ("_rad", "rad"),
    ("_deg", "deg"),
    ("_mm", "mm"),
    ("_cm", "cm"),
    ("_m", "m"),
    ("_g", "g"),
    ("_seconds", "s"),
    ("_sec", "s"),
    ("_ms", "ms"),
    ("_us", "us"),
    ("_ns", "ns"),
    ("_s", "s"),
    ("_min", "min"),
    ("_hz", "Hz"),
];

impl Heading {
    /// Takes a label apart.
    pub fn parse(label: &str) -> Self {
        let label = label.trim().replace("\"\"", "\"");
        let (rest, run) = split_run(&label);
        let (name, unit) = split_unit(&rest);
        Heading { name, unit, run, label }
    }

    /// The heading of a column without one.
    pub fn numbered(column: usize) -> Self {
        let name = (column + 1).to_string();
        Heading { label: name.clone(), name, unit: String::new(), run: None }
    }
}

/// Whether a text names a run.
pub(super) fn is_run(text: &str) -> bool {
    let text = text.trim().to_lowercase();
    let numbered = |rest: &str| {
        let rest = rest.trim_start().trim_start_matches(['#', ' ']);
        !rest.is_empty() && rest.chars().all(|c| c.is_ascii_digit())
    };
    text == "latest"
        || text == "data set"
        || RUN.iter().any(|word| text.strip_prefix(word).is_some_and(numbered))
}

/// A label without its run, and the run.
fn split_run(label: &str) -> (String, Option<String>) {
    if let Some((before, after)) = label.split_once(':')
        && is_run(before)
    {
        return (after.trim().to_owned(), Some(before.trim().to_owned()));
    }
    let small = label.to_ascii_lowercase();
    for word in RUN {
        let Some(at) = small.rfind(word).filter(|at| *at > 0) else { continue };
        let (before, after) = label.split_at(at);
        if is_run(after) {
            let before = before.trim_end_matches([' ', ',', ':', '\u{a0}']);
            return (before.to_owned(), Some(after.trim().to_owned()));
        }
    }
    (label.to_owned(), None)
}

/// A label without its unit, and the unit.
fn split_unit(label: &str) -> (String, String) {
    let owned = |name: &str, unit: &str| (name.trim().to_owned(), unit.trim().to_owned());
    if let Some((before, unit, after)) = bracketed(label) {
        let before = before.trim_end_matches([' ', '/']);
        return owned(&format!("{before} {}", after.trim()), unit);
    }
    // "m/s" alone is a unit; "s" alone is a path, "h" a height.
    if label.contains('/') && unit::parse(label).is_some() {
        return owned("", label);
    }
    for mark in ["/", " in ", ","] {
        if let Some((name, text)) = label.split_once(mark)
            && unit::parse(text).is_some()
        {
            return owned(name, text);
        }
    }
    let small = label.to_ascii_lowercase();
    for (suffix, unit) in SUFFIXES {
        if small.ends_with(suffix) && small.len() > suffix.len() {
            return owned(&label[..label.len() - suffix.len()], unit);
        }
    }
    owned(label, "")
}

/// What stands before, in and behind the last brackets, which may hold others.
fn bracketed(label: &str) -> Option<(&str, &str, &str)> {
    let close = label.rfind([')', ']', '}'])?;
    let mut depth = 0;
    let open = label[..=close].char_indices().rev().find_map(|(at, c)| {
        match c {
            ')' | ']' | '}' => depth += 1,
            '(' | '[' | '{' => depth -= 1,
            _ => {}
        }
        (depth == 0).then_some(at)
    })?;
    Some((&label[..open], &label[open + 1..close], &label[close + 1..]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(label: &str, name: &str, unit: &str, run: Option<&str>) {
        let heading = Heading::parse(label);
        let found = (heading.name.as_str(), heading.unit.as_str(), heading.run.as_deref());
        assert_eq!(found, (name, unit, run), "{label}");
    }

    #[test]
    fn headings_of_many_programs() {
        check("Time (s)", "Time", "s", None);
        check("Time ( s )", "Time", "s", None);
        check("Acceleration x (m/s^2)", "Acceleration x", "m/s^2", None);
        check("Linear Acceleration y (m/(s·s))", "Linear Acceleration y", "m/(s·s)", None);
        check("Latest: Time (s)", "Time", "s", Some("Latest"));
        check("Run 2: Position (m)", "Position", "m", Some("Run 2"));
        check("Data Set 1: Time (s)", "Time", "s", Some("Data Set 1"));
        check("Time (s) Run #1", "Time", "s", Some("Run #1"));
        check("Temperature, Ch P3 (°C) Run #12", "Temperature, Ch P3", "°C", Some("Run #12"));
        check("t / s", "t", "s", None);
        check("v / (m/s)", "v", "m/s", None);
        check("v/m/s", "v", "m/s", None);
        check("Auslenkung in cm", "Auslenkung", "cm", None);
        check("Zeit [ms]", "Zeit", "ms", None);
        check("angle_deg", "angle", "deg", None);
        check("time_s", "time", "s", None);
        check("a_x", "a_x", "", None);
        check("U/V", "U/V", "", None);
        check("s", "s", "", None);
        check("angular_velocity", "angular_velocity", "", None);
        check("broken (m", "broken (m", "", None);
        check(")(", ")(", "", None);
        check("", "", "", None);
    }
}
