//! Measures everything, or the sections named, and prints it as Markdown; with `--write FILE` also
//! puts all of it into the document, between the two marks that say where it begins and ends.

mod integrators;
mod long;
mod machine;
mod markdown;
mod records;
mod scheme;
mod states;

use std::process::ExitCode;

const BEGIN: &str = "<!-- measured: begin -->";
const END: &str = "<!-- measured: end -->";

/// A part of the report: its name, and what measures it.
type Section = (&'static str, fn() -> String);

const SECTIONS: [Section; 6] = [
    ("machine", machine::section),
    ("records", records::section),
    ("states", states::section),
    ("long", long::section),
    ("scheme", scheme::section),
    ("integrators", integrators::section),
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (file, wanted) = match &arguments[..] {
        [flag, file] if flag == "--write" => (Some(file), &[][..]),
        names if names.iter().all(|name| SECTIONS.iter().any(|section| section.0 == name)) => {
            (None, names)
        }
        _ => {
            eprintln!("usage: table [--write FILE | SECTION...]");
            eprintln!("sections: {}", SECTIONS.map(|section| section.0).join(", "));
            return ExitCode::from(2);
        }
    };
    let mut report = String::new();
    for (name, section) in SECTIONS {
        if wanted.is_empty() || wanted.iter().any(|wanted| wanted == name) {
            eprintln!("measuring: {name}");
            let text = section();
            print!("{text}");
            report += &text;
        }
    }
    match file.map(|file| write(file, &report)) {
        Some(Err(error)) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
        _ => ExitCode::SUCCESS,
    }
}

/// Replaces what stands between the marks of `file`.
fn write(file: &str, report: &str) -> Result<(), String> {
    let text = std::fs::read_to_string(file).map_err(|error| format!("{file}: {error}"))?;
    let parts = text.split_once(BEGIN).and_then(|(before, rest)| {
        let (_, after) = rest.split_once(END)?;
        Some(format!("{before}{BEGIN}\n\n{report}\n{END}{after}"))
    });
    let text = parts.ok_or_else(|| format!("{file}: the marks {BEGIN} and {END} are missing"))?;
    std::fs::write(file, text).map_err(|error| format!("{file}: {error}"))
}
