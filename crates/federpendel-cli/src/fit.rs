//! `federpendel fit`: read recordings, fit them, say what was found.

use std::path::Path;

use federpendel::Mix;
use federpendel_fit::read::{Choice, Read, recordings};
use federpendel_fit::{FitReport, Intervals, Options, fit};
use federpendel_report::recording::{Fitted, fit_error, read_error, read_note};
use federpendel_text::Catalogue;

use crate::args::Fit;
use crate::failure::{Failure, note};
use crate::load;
use crate::output::{self, Format, Targets};
use crate::quantity::{Dimension, parse};
use crate::words::quantity_problem;

/// Largest recording that is read, bytes.
const LARGEST_RECORDING: usize = 4 << 30;

pub(crate) fn run(arguments: &Fit, catalogue: &Catalogue) -> Result<(), Failure> {
    let targets =
        Targets::check(&arguments.recordings, &arguments.results, &Format::OF_FITS, catalogue)?;
    let options = options(arguments, catalogue)?;
    let mut fitted = Vec::new();
    let mut failed: Option<Failure> = None;
    for path in &arguments.recordings {
        match one(path, arguments, &options, catalogue) {
            Ok(found) => fitted.extend(found),
            // A bad file does not stop those behind it; the last one may still be all there is to say.
            Err(failure) => {
                if let Some(before) = failed.replace(failure) {
                    before.report(catalogue);
                }
            }
        }
    }
    match failed {
        Some(failure) if fitted.is_empty() => return Err(failure),
        Some(failure) => {
            failure.report(catalogue);
        }
        None => {}
    }
    output::write_fits(&fitted, arguments.picture, &targets, catalogue)
}

/// All recordings of a file, fitted.
fn one(
    path: &Path,
    arguments: &Fit,
    options: &Options,
    catalogue: &Catalogue,
) -> Result<Vec<Fitted>, Failure> {
    let file = path.display().to_string();
    let bytes = load::read(path, LARGEST_RECORDING, catalogue)?;
    let choice = Choice {
        time: arguments.time.clone(),
        value: arguments.value.clone(),
        quantity: arguments.quantity,
        run: arguments.run.clone(),
        ..Choice::default()
    };
    let reads = recordings(&bytes, &choice)
        .map_err(|error| Failure::Input(read_error(catalogue, &error, &file)))?;
    let fitted = reads.into_iter().map(|read| {
        for remark in &read.notes {
            note(&format!("{file}: {}", read_note(catalogue, remark)));
        }
        let report = fit(&read.recording, options);
        let report: FitReport =
            report.map_err(|error| Failure::Input(fit_error(catalogue, &error, &file)))?;
        Ok(Fitted::new(name(&file, &read), read, report))
    });
    fitted.collect()
}

/// What a recording is called: its file, and its run if there are several.
fn name(file: &str, read: &Read) -> String {
    match &read.run {
        Some(run) => format!("{file} ({run})"),
        None => file.to_owned(),
    }
}

fn options(arguments: &Fit, catalogue: &Catalogue) -> Result<Options, Failure> {
    let time = |name: &str, written: &Option<String>| {
        let value = |written: &String| {
            parse(written, Dimension::Time)
                .map_err(|error| refused(name, written, &error, catalogue))
        };
        written.as_ref().map(value).transpose()
    };
    let sigma = |written: &String| {
        parse(written, Dimension::Number)
            .map_err(|error| refused("sigma", written, &error, catalogue))
    };
    Ok(Options {
        laws: laws(arguments.laws.as_deref(), catalogue)?,
        from: time("from", &arguments.from)?,
        to: time("to", &arguments.to)?,
        sigma: arguments.sigma.as_ref().map(sigma).transpose()?,
        intervals: if arguments.profile { Intervals::Profile } else { Intervals::Covariance },
        ..Options::default()
    })
}

fn refused(
    name: &str,
    written: &str,
    error: &crate::quantity::Error,
    catalogue: &Catalogue,
) -> Failure {
    let variables = [
        ("name", format!("--{name}").into()),
        ("value", catalogue.quoted(written).into()),
        ("problem", quantity_problem(catalogue, error).into()),
    ];
    Failure::Input(catalogue.format("fit-option-refused", &variables))
}

/// The laws that may act: `auto`, `none`, or a list of them.
fn laws(written: Option<&str>, catalogue: &Catalogue) -> Result<Mix, Failure> {
    let mut mix = Mix::default();
    match written {
        None | Some("auto") => return Ok(Mix { stokes: true, coulomb: true, newton: true }),
        Some("none") => return Ok(mix),
        Some(list) => {
            for name in list.split(',') {
                match name.trim() {
                    "stokes" => mix.stokes = true,
                    "coulomb" => mix.coulomb = true,
                    "newton" => mix.newton = true,
                    other => {
                        let variables = [("value", other.into())];
                        return Err(Failure::Input(
                            catalogue.format("fit-laws-refused", &variables),
                        ));
                    }
                }
            }
        }
    }
    Ok(mix)
}
