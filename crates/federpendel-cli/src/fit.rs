//! `federpendel fit`: read recordings, fit them, say what was found.

mod options;

pub(crate) use options::{INTERVALS, LOSSES, laws};

use std::io;
use std::path::Path;

use federpendel_fit::read::{Choice, Read, ReadError, SystemError, recordings_from};
use federpendel_fit::{Given, Options, fit};
use federpendel_report::recording::{Fitted, fit_error, read_error, read_note};
use federpendel_text::Catalogue;

use crate::args::Fit;
use crate::beside::given;
use crate::failure::{Failure, note};
use crate::load;
use crate::output::{self, Format, Targets};

/// What became of all recordings.
#[derive(Default)]
pub(crate) struct Fits {
    /// Those that were fitted.
    pub fitted: Vec<Fitted>,
    /// Those that were not.
    pub failed: Vec<Failed>,
    /// What is said of how files were read: the sentence, and the files in order.
    notes: Vec<(String, Vec<String>)>,
}

impl Fits {
    fn note(&mut self, sentence: String, file: &str) {
        match self.notes.iter_mut().find(|(said, _)| *said == sentence) {
            Some((_, files)) => files.push(file.to_owned()),
            None => self.notes.push((sentence, vec![file.to_owned()])),
        }
    }

    /// Says how files were read; what is true of several of them once.
    fn say_notes(&self, catalogue: &Catalogue) {
        for (sentence, files) in &self.notes {
            let Some((first, others)) = files.split_first() else { continue };
            let files = match others.len() {
                0 => first.clone(),
                count => {
                    let variables = [("first", first.as_str().into()), ("count", count.into())];
                    catalogue.format("fit-note-files", &variables)
                }
            };
            note(&format!("{files}: {sentence}"));
        }
    }
}

/// A recording without a fit.
pub(crate) struct Failed {
    /// What it is called.
    pub name: String,
    /// Why there is none.
    pub failure: Failure,
}

pub(crate) fn run(arguments: &Fit, catalogue: &Catalogue) -> Result<(), Failure> {
    let targets =
        Targets::check(&arguments.recordings, &arguments.results, &Format::OF_FITS, catalogue)?;
    let choice = options::choice(arguments, catalogue)?;
    let options = options::options(arguments, catalogue)?;
    let given = given(&arguments.beside, catalogue)?;
    let sigma = options::sigma_unit(arguments);
    let mut fits = Fits::default();
    for path in &arguments.recordings {
        add(path, &mut fits, (&choice, &options, sigma, &given), catalogue);
    }
    fits.say_notes(catalogue);
    // With a single recording there is nothing to write, and nothing to add to why.
    if fits.fitted.is_empty() && fits.failed.len() == 1 {
        return Err(fits.failed.remove(0).failure);
    }
    if !fits.fitted.is_empty() {
        output::write_fits(&fits, arguments.picture, &targets, catalogue)?;
    }
    complete(&fits, catalogue)
}

/// Fits all recordings of a file. One that fails does not stop those behind it.
fn add(
    path: &Path,
    fits: &mut Fits,
    (choice, options, sigma, given): (&Choice, &Options, Option<&str>, &Given),
    catalogue: &Catalogue,
) {
    let file = load::shown(path);
    let reads = match read(path, &file, choice, catalogue) {
        Ok(reads) => reads,
        Err(failure) => return fits.failed.push(Failed { name: file, failure }),
    };
    for read in reads {
        for remark in &read.notes {
            fits.note(read_note(catalogue, remark), &file);
        }
        let name = name(&file, &read);
        let report = same_unit(sigma, &read, &name, catalogue).and_then(|()| {
            fit(&read.recording, options)
                .map_err(|error| Failure::Input(fit_error(catalogue, &error, &name)))
        });
        match report {
            Ok(report) => fits.fitted.push(Fitted::new(name, read, report).beside(given)),
            Err(failure) => fits.failed.push(Failed { name, failure }),
        }
    }
}

/// Refuses a standard deviation in another unit than the values.
fn same_unit(
    sigma: Option<&str>,
    read: &Read,
    name: &str,
    catalogue: &Catalogue,
) -> Result<(), Failure> {
    let found = &read.recording.unit;
    match sigma.filter(|unit| unit != found) {
        None => Ok(()),
        Some(unit) => {
            let found = catalogue.quoted(found);
            let variables = [("name", name.into()), ("unit", unit.into()), ("found", found.into())];
            Err(Failure::Input(catalogue.format("fit-sigma-unit", &variables)))
        }
    }
}

/// All recordings of a file.
fn read(
    path: &Path,
    file: &str,
    choice: &Choice,
    catalogue: &Catalogue,
) -> Result<Vec<Read>, Failure> {
    let refused = |error: &io::Error| Failure::system(catalogue, file, error);
    let seekable = load::seekable(path, catalogue)?;
    recordings_from(seekable, choice).map_err(|error| match error {
        ReadError::System(SystemError(error)) => refused(&error),
        error => Failure::Input(read_error(catalogue, &error, file)),
    })
}

/// What a recording is called: its file, and its run if there are several.
fn name(file: &str, read: &Read) -> String {
    match &read.run {
        Some(run) => format!("{file} ({run})"),
        None => file.to_owned(),
    }
}

/// Names those that failed after all that was written: a long list of results hides what came before it.
fn complete(fits: &Fits, catalogue: &Catalogue) -> Result<(), Failure> {
    if fits.failed.is_empty() {
        return Ok(());
    }
    for failed in &fits.failed {
        failed.failure.report(catalogue);
    }
    let variables = [
        ("failed", fits.failed.len().into()),
        ("all", (fits.failed.len() + fits.fitted.len()).into()),
    ];
    Err(Failure::Input(catalogue.format("fit-some-failed", &variables)))
}
