//! Files that appear whole or not at all, all of them or none.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use federpendel_text::Catalogue;
use tempfile::{Builder, NamedTempFile, TempPath};

use super::Format;
use crate::failure::Failure;

/// Writes every file beside its place, then puts all in place.
pub(super) fn write(
    files: &[(PathBuf, Format)],
    catalogue: &Catalogue,
    render: impl Fn(Format, &mut dyn Write) -> io::Result<()>,
) -> Result<(), Failure> {
    let failed =
        |path: &Path, error| Failure::system(catalogue, &path.display().to_string(), &error);
    let mut written: Vec<(TempPath, PathBuf)> = Vec::new();
    for (path, format) in files {
        // A link stays a link: what it points to is replaced.
        let place = path.canonicalize().unwrap_or_else(|_| path.clone());
        let temporary = write_beside(&place, |out| render(*format, out))
            .map_err(|error| failed(path, error))?;
        written.push((temporary, place));
    }
    let mut new: Vec<PathBuf> = Vec::new();
    for (temporary, place) in written {
        let is_new = !place.exists();
        if let Err(error) = temporary.persist(&place) {
            // Nothing half done stays; what cannot be removed is already the lesser trouble.
            for path in &new {
                let _ = fs::remove_file(path);
            }
            return Err(failed(&place, error.error));
        }
        if is_new {
            new.push(place);
        }
    }
    Ok(())
}

/// Writes a file with a name of its own in the folder of `place`, down to the disk.
fn write_beside(
    place: &Path,
    render: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<TempPath> {
    let folder = place.parent().filter(|folder| !folder.as_os_str().is_empty());
    let temporary = temporary_in(folder.unwrap_or(Path::new(".")), place)?;
    let (file, path) = temporary.into_parts();
    let mut out = BufWriter::new(file);
    render(&mut out)?;
    let file: File = out.into_inner().map_err(|error| error.into_error())?;
    file.sync_all()?;
    Ok(path)
}

/// A temporary file with the permissions that the file in `place` has, or a new one would get.
fn temporary_in(folder: &Path, place: &Path) -> io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(".federpendel-").suffix(".tmp");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let temporary = builder.tempfile_in(folder)?;
    if let Ok(existing) = fs::metadata(place) {
        temporary.as_file().set_permissions(existing.permissions())?;
    }
    Ok(temporary)
}
