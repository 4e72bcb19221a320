//! Which outputs are asked for, checked before anything is computed.

use std::path::{Path, PathBuf, absolute, is_separator};

use federpendel_text::Catalogue;
use federpendel_text::plot::draw::Background;

use super::{Dialect, Format};
use crate::args::{Results, Subject};
use crate::failure::Failure;

/// The name of standard output among files.
const STDOUT: &str = "-";

/// Where results go.
#[derive(Debug)]
pub(crate) struct Targets {
    /// Files, each with its form.
    pub(super) files: Vec<(PathBuf, Format)>,
    /// The form for standard output.
    pub(super) stdout: Format,
    /// How CSV is written.
    pub(super) dialect: Dialect,
    /// Whether the summary tells everything.
    pub(super) details: bool,
    /// What pictures are drawn on.
    pub(super) background: Background,
}

impl Targets {
    /// The targets of a command on an experiment, whose file is none of them.
    ///
    /// # Errors
    /// As [`Targets::check`].
    pub(crate) fn of(
        subject: &Subject,
        results: &Results,
        forms: &[Format],
        catalogue: &Catalogue,
    ) -> Result<Self, Failure> {
        Self::check(subject.experiment.as_slice(), results, forms, catalogue)
    }

    /// Takes the targets from the results, none of which may be a file that is `read`; files can have one of the
    /// `forms`, and the first of them is written to standard output if that is named as a file.
    ///
    /// # Errors
    /// An extension that no form has, a folder, the same file twice.
    pub(crate) fn check(
        read: &[PathBuf],
        results: &Results,
        forms: &[Format],
        catalogue: &Catalogue,
    ) -> Result<Self, Failure> {
        let mut files: Vec<(PathBuf, Format)> = Vec::new();
        let mut taken: Vec<PathBuf> = read.iter().map(|path| real(path)).collect();
        let mut asks_stdout = false;
        for path in &results.outputs {
            let name = crate::load::shown(path);
            let refuse =
                |id| Failure::Input(catalogue.format(id, &[("name", name.clone().into())]));
            let place = if path == Path::new(STDOUT) { path.clone() } else { real(path) };
            if taken.contains(&place) {
                return Err(refuse("cli-output-twice"));
            }
            taken.push(place);
            if path == Path::new(STDOUT) {
                asks_stdout = true;
                continue;
            }
            if path.is_dir() || path.to_string_lossy().ends_with(is_separator) {
                return Err(refuse("cli-output-folder"));
            }
            // A link that leads in a circle is one still.
            if path.exists() && !path.is_file() || real(path).is_symlink() {
                return Err(refuse("cli-output-special"));
            }
            let format = format_of(path, &name, forms, catalogue)?;
            in_a_folder(path, &name, catalogue)?;
            files.push((path.clone(), format));
        }
        // Someone who names standard output as a file wants data there, not prose.
        let data = forms.first().copied().filter(|_| asks_stdout);
        let unsaid = data.unwrap_or(Format::Summary);
        Ok(Self {
            files,
            stdout: results.format.unwrap_or(unsaid),
            dialect: results.dialect,
            details: results.details,
            background: results.background,
        })
    }
}

impl Targets {
    /// Whether this form is asked for, in a file or on standard output.
    pub(crate) fn has(&self, form: Format) -> bool {
        self.stdout == form || self.files.iter().any(|(_, format)| *format == form)
    }
}

/// Refuses a file whose folder is missing; before the work, not after it.
fn in_a_folder(path: &Path, name: &str, catalogue: &Catalogue) -> Result<(), Failure> {
    match path.parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.exists()) {
        None => Ok(()),
        Some(folder) => {
            let folder = crate::load::shown(folder);
            let variables = [("name", name.into()), ("folder", folder.into())];
            Err(Failure::System(catalogue.format("cli-output-nowhere", &variables)))
        }
    }
}

fn format_of(
    path: &Path,
    name: &str,
    forms: &[Format],
    catalogue: &Catalogue,
) -> Result<Format, Failure> {
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or("");
    let extension = extension.to_ascii_lowercase();
    let known = forms.iter().copied().find(|format| format.name() == extension);
    known.ok_or_else(|| {
        let allowed = Format::extensions(forms);
        Failure::Input(
            catalogue.format(
                "cli-output-extension",
                &[("name", name.into()), ("allowed", allowed.into())],
            ),
        )
    })
}

/// More links on the way to a file lead in a circle.
const MOST_LINKS: usize = 40;

/// One spelling for each file, also for one that is not there yet; a link is what it points to.
pub(super) fn real(path: &Path) -> PathBuf {
    if let Ok(path) = path.canonicalize() {
        return path;
    }
    let mut whole = absolute(path).unwrap_or_else(|_| path.to_owned());
    for _ in 0..MOST_LINKS {
        let Ok(next) = whole.read_link() else { break };
        whole = whole.parent().unwrap_or(Path::new(".")).join(next);
    }
    match (whole.parent().and_then(|folder| folder.canonicalize().ok()), whole.file_name()) {
        (Some(folder), Some(name)) => folder.join(name),
        _ => whole,
    }
}
