//! The report on the article, in every form.

mod summary;

use std::collections::BTreeSet;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use federpendel_report::article::{Checks, Edition, Laboratory, document};
use federpendel_report::html;
use federpendel_text::Catalogue;

use super::targets::Targets;
use super::{Format, json, to_stdout, whole};
use crate::failure::{Failure, note};

/// The checks of the article's claims, and what they are about.
pub(crate) struct ArticleReport<'a> {
    /// What the report is about.
    pub laboratory: &'a Laboratory,
    /// What was found.
    pub checks: &'a Checks,
    /// Whether pages are written as a worksheet, with the solutions beside it.
    pub worksheet: bool,
    /// Numbers of the claims that pages hold; none for all.
    pub claims: Option<BTreeSet<usize>>,
}

/// A file with the report.
#[derive(Clone, Copy)]
enum Form {
    Page(Edition),
    Json,
}

impl ArticleReport<'_> {
    /// Writes the report to all targets: the files appear together and whole, then standard output.
    pub(crate) fn write(&self, targets: &Targets, catalogue: &Catalogue) -> Result<(), Failure> {
        let files = self.files(targets, catalogue)?;
        whole::write(&files, catalogue, |form, out| match form {
            Form::Page(edition) => self.page(edition, catalogue, out),
            Form::Json => json::write_article(self.checks, catalogue, out),
        })?;
        for (path, _) in &files {
            note(&catalogue.format("cli-written", &[("name", path.display().to_string().into())]));
        }
        to_stdout(
            |out| match targets.stdout {
                Format::Json => json::write_article(self.checks, catalogue, out),
                _ => summary::write(self, targets, catalogue, out),
            },
            catalogue,
        )
    }

    /// The files that are asked for; a worksheet has its solutions beside it.
    fn files(
        &self,
        targets: &Targets,
        catalogue: &Catalogue,
    ) -> Result<Vec<(PathBuf, Form)>, Failure> {
        let mut files = Vec::new();
        for (path, format) in &targets.files {
            match format {
                Format::Html if self.worksheet => {
                    let solutions = beside(path, &catalogue.text("article-solutions-file"));
                    if targets.files.iter().any(|(path, _)| *path == solutions) {
                        let name = solutions.display().to_string();
                        return Err(Failure::Input(
                            catalogue.format("cli-output-twice", &[("name", name.into())]),
                        ));
                    }
                    files.push((path.clone(), Form::Page(Edition::Worksheet)));
                    files.push((solutions, Form::Page(Edition::Solutions)));
                }
                Format::Html => files.push((path.clone(), Form::Page(Edition::Report))),
                _ => files.push((path.clone(), Form::Json)),
            }
        }
        Ok(files)
    }

    fn page(&self, edition: Edition, catalogue: &Catalogue, out: &mut dyn Write) -> io::Result<()> {
        let mut document =
            document(self.laboratory, self.checks, edition, catalogue).map_err(io::Error::other)?;
        if let Some(numbers) = &self.claims {
            document.keep_claims(numbers);
        }
        let page = html::page(&document, catalogue).map_err(io::Error::other)?;
        out.write_all(page.as_bytes())
    }
}

/// `folder/name.html` with `suffix` behind the name.
fn beside(path: &Path, suffix: &str) -> PathBuf {
    let mut name = path.file_stem().unwrap_or_default().to_os_string();
    name.push(suffix);
    if let Some(extension) = path.extension() {
        name.push(".");
        name.push(extension);
    }
    path.with_file_name(name)
}
