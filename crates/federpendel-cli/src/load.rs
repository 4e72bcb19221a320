//! The experiment that a command is about: the file's, or the built-in one, with the overrides.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use federpendel_text::{Catalogue, plain};
use sysinfo::{MemoryRefreshKind, RefreshKind, System};

use crate::args::Subject;
use crate::experiment::{self, BUILT_IN, Experiment, LARGEST_FILE};
use crate::failure::Failure;
use crate::record::BYTES_PER_SAMPLE;
use crate::words::experiment_error;

/// Memory taken to be free on a system that does not say, bytes.
const UNKNOWN_MEMORY: u64 = 1 << 30;

/// Reads the experiment; with `copies` of every sample beside the exact ones as many of them must fit.
pub(crate) fn experiment(
    subject: &Subject,
    copies: usize,
    catalogue: &Catalogue,
) -> Result<Experiment, Failure> {
    let (name, bytes) = match &subject.experiment {
        Some(path) => (Some(shown(path)), read(path, LARGEST_FILE, catalogue)?),
        None => (None, BUILT_IN.as_bytes().to_vec()),
    };
    let overrides = subject.overrides.iter().map(|(field, quantity)| (*field, quantity.as_str()));
    experiment::parse(&bytes)
        .and_then(|mut draft| {
            draft.override_with(overrides)?;
            draft.resolve(samples_that_fit() / (1 + copies))
        })
        .map_err(|error| Failure::Input(experiment_error(catalogue, &error, name.as_deref())))
}

/// The bytes of a file, of `-` those of standard input; one more than the `largest` number allowed
/// decides its fate.
pub(crate) fn read(path: &Path, largest: usize, catalogue: &Catalogue) -> Result<Vec<u8>, Failure> {
    let limit = largest as u64 + 1;
    let mut bytes = Vec::new();
    let done = if path == Path::new("-") {
        io::stdin().take(limit).read_to_end(&mut bytes)
    } else {
        File::open(path).and_then(|file| file.take(limit).read_to_end(&mut bytes))
    };
    done.map_err(|error| Failure::system(catalogue, &shown(path), &error))?;
    Ok(bytes)
}

/// A path as messages and results say it.
pub(crate) fn shown(path: &Path) -> String {
    plain(&path.display().to_string())
}

/// A file that can be read from its beginning again: that of this name, where it lies.
///
/// Standard input and pipes pass only once. They go to a file without a name, not into memory, which a recording may be
/// larger than; the system removes it with the program. TMPDIR says on which disk.
pub(crate) fn seekable(path: &Path, catalogue: &Catalogue) -> Result<File, Failure> {
    let refused = |error: io::Error| Failure::system(catalogue, &shown(path), &error);
    if path == Path::new("-") {
        return spooled(io::stdin(), catalogue, refused);
    }
    let file = File::open(path).map_err(refused)?;
    let lies = file.metadata().map_err(refused)?.is_file();
    if lies { Ok(file) } else { spooled(file, catalogue, refused) }
}

/// What passes only once, in a file; `refused` says that it cannot be read.
fn spooled(
    mut from: impl Read,
    catalogue: &Catalogue,
    refused: impl Fn(io::Error) -> Failure,
) -> Result<File, Failure> {
    let here = |error: io::Error| {
        let folder = ("folder", shown(&std::env::temp_dir()).into());
        Failure::system(catalogue, &catalogue.format("cli-temporary-folder", &[folder]), &error)
    };
    let mut file = tempfile::tempfile().map_err(here)?;
    io::copy(&mut from, &mut file).map_err(|error| match error.kind() {
        io::ErrorKind::StorageFull => here(error),
        _ => refused(error),
    })?;
    Ok(file)
}

/// Half of the memory that is free, in samples: the rest is for the system and for plots.
fn samples_that_fit() -> usize {
    let memory = RefreshKind::nothing().with_memory(MemoryRefreshKind::nothing().with_ram());
    let free = match System::new_with_specifics(memory) {
        Ok(system) => {
            let container = system.cgroup_limits().map_or(u64::MAX, |limits| limits.free_memory);
            system.available_memory().min(container)
        }
        Err(_) => UNKNOWN_MEMORY,
    };
    usize::try_from(free / 2 / BYTES_PER_SAMPLE).unwrap_or(usize::MAX)
}
