//! Files that appear whole or not at all, all of them or none.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use federpendel_text::Catalogue;
use tempfile::{Builder, NamedTempFile, TempPath};

use super::targets::real;
use crate::failure::Failure;

/// Writes every file beside its place, then puts all in place.
pub(super) fn write<Form: Copy>(
    files: &[(PathBuf, Form)],
    catalogue: &Catalogue,
    render: impl Fn(Form, &mut dyn Write) -> io::Result<()>,
) -> Result<(), Failure> {
    let failed = |path: &Path, error| Failure::system(catalogue, &crate::load::shown(path), &error);
    let mut written: Vec<(TempPath, &PathBuf, PathBuf)> = Vec::new();
    for (path, format) in files {
        // A link stays a link: what it points to is replaced.
        let place = real(path);
        let temporary = write_beside(&place, |out| render(*format, out))
            .map_err(|error| failed(path, error))?;
        written.push((temporary, path, place));
    }
    let mut placed: Vec<Placed> = Vec::new();
    for (temporary, path, place) in written {
        let done = set_aside(&place).and_then(|former| {
            temporary.persist(&place).map_err(|error| error.error)?;
            Ok(Placed { place: place.clone(), former })
        });
        match done {
            Ok(file) => placed.push(file),
            Err(error) => {
                placed.into_iter().for_each(Placed::take_back);
                return Err(failed(path, error));
            }
        }
    }
    Ok(())
}

/// A file put in place, and the one that was there before, which goes when this is dropped.
struct Placed {
    place: PathBuf,
    former: Option<TempPath>,
}

impl Placed {
    /// Makes the place what it was. What cannot be undone is the lesser trouble: an error is reported
    /// already.
    fn take_back(self) {
        let _ = match self.former {
            Some(former) => former.persist(&self.place).map_err(|error| error.error),
            None => fs::remove_file(&self.place),
        };
    }
}

/// A second name for the file in `place`, if there is one, so that it outlives its replacement; a
/// copy where the file system knows no second names.
fn set_aside(place: &Path) -> io::Result<Option<TempPath>> {
    if !place.exists() {
        return Ok(None);
    }
    let named = |path: &Path| {
        fs::hard_link(place, path).or_else(|error| match error.kind() {
            io::ErrorKind::AlreadyExists => Err(error),
            _ => fs::copy(place, path).map(|_| ()),
        })
    };
    Ok(Some(beside().make_in(folder_of(place), named)?.into_temp_path()))
}

/// Writes a file with a name of its own in the folder of `place`, down to the disk.
fn write_beside(
    place: &Path,
    render: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<TempPath> {
    let temporary = temporary_for(place)?;
    let (file, path) = temporary.into_parts();
    let mut out = BufWriter::new(file);
    render(&mut out)?;
    let file: File = out.into_inner().map_err(|error| error.into_error())?;
    file.sync_all()?;
    Ok(path)
}

/// A temporary file with the permissions that the file in `place` has, or a new one would get.
fn temporary_for(place: &Path) -> io::Result<NamedTempFile> {
    let mut builder = beside();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let temporary = builder.tempfile_in(folder_of(place))?;
    if let Ok(existing) = fs::metadata(place) {
        temporary.as_file().set_permissions(existing.permissions())?;
    }
    Ok(temporary)
}

/// Names of files that are not to stay.
fn beside<'a>() -> Builder<'a, 'a> {
    let mut builder = Builder::new();
    builder.prefix(".federpendel-").suffix(".tmp");
    builder
}

fn folder_of(place: &Path) -> &Path {
    let folder = place.parent().filter(|folder| !folder.as_os_str().is_empty());
    folder.unwrap_or(Path::new("."))
}

#[cfg(test)]
mod tests {
    use federpendel_text::Language;

    use super::super::Format;
    use super::*;

    /// Writes `old.csv`, `new.json` and `broken.svg`, whose place becomes a folder before anything is
    /// put in place.
    fn fails_at_the_last(folder: &Path) {
        let at = |name: &str| folder.join(name);
        let files = [
            (at("old.csv"), Format::Csv),
            (at("new.json"), Format::Json),
            (at("broken.svg"), Format::Svg),
        ];
        let written = write(&files, &Catalogue::new(Language::English), |format, out| {
            if format == Format::Svg {
                fs::create_dir(at("broken.svg"))?;
            }
            out.write_all(b"new")
        });
        assert!(written.is_err());
    }

    #[test]
    fn a_file_that_fails_takes_the_others_back() {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("old.csv"), "old").expect("a file");
        fails_at_the_last(folder.path());
        let entries = fs::read_dir(folder.path()).expect("a folder");
        let mut names: Vec<_> = entries.map(|entry| entry.expect("an entry").file_name()).collect();
        names.sort();
        assert_eq!(names, ["broken.svg", "old.csv"]);
        assert_eq!(fs::read(folder.path().join("old.csv")).expect("the old file"), b"old");
    }

    #[cfg(unix)]
    #[test]
    fn a_link_to_a_file_that_is_not_there_yet_stays_a_link() {
        let folder = tempfile::tempdir().expect("a folder");
        let link = folder.path().join("link.csv");
        std::os::unix::fs::symlink("motion.csv", &link).expect("a link");
        let catalogue = Catalogue::new(Language::English);
        let files = [(link.clone(), Format::Csv)];
        assert!(write(&files, &catalogue, |_, out| out.write_all(b"new")).is_ok());
        assert!(link.is_symlink());
        assert_eq!(fs::read(folder.path().join("motion.csv")).expect("the file"), b"new");
    }

    #[test]
    fn a_file_replaced_leaves_nothing_of_the_former_one() {
        let folder = tempfile::tempdir().expect("a folder");
        let place = folder.path().join("motion.csv");
        fs::write(&place, "a longer old text").expect("a file");
        let files = [(place.clone(), Format::Csv)];
        let catalogue = Catalogue::new(Language::English);
        assert!(write(&files, &catalogue, |_, out| out.write_all(b"new")).is_ok());
        assert_eq!(fs::read(&place).expect("the new file"), b"new");
        assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1);
    }
}
