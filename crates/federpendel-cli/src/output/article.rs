//! The report on the article, in every form.

mod summary;

use std::collections::BTreeSet;

use federpendel_report::article::{Checks, Edition, Laboratory, document};
use federpendel_report::html;
use federpendel_text::Catalogue;

use super::targets::Targets;
use super::{Format, json, say_written, to_stdout, whole};
use crate::failure::Failure;

/// The checks of the article's claims, and what they are about.
pub(crate) struct ArticleReport<'a> {
    /// What the report is about.
    pub laboratory: &'a Laboratory,
    /// What was found.
    pub checks: &'a Checks,
    /// Whether pages are written as a worksheet; every second page then holds the solutions to the one before.
    pub worksheet: bool,
    /// Numbers of the claims that pages hold; none for all.
    pub claims: Option<BTreeSet<usize>>,
}

impl ArticleReport<'_> {
    /// Writes the report to all targets: the files appear together and whole, then standard output.
    pub(crate) fn write(&self, targets: &Targets, catalogue: &Catalogue) -> Result<(), Failure> {
        let contents = self.contents(targets, catalogue)?;
        let paths = targets.files.iter().map(|(path, _)| path.clone());
        let files: Vec<_> = paths.zip(&contents).collect();
        whole::write(&files, catalogue, |content, out| out.write_all(content))?;
        say_written(targets, catalogue);
        to_stdout(
            |out| match targets.stdout {
                Format::Json => json::write_article(self.checks, catalogue, out),
                _ => summary::write(self, targets, catalogue, out),
            },
            catalogue,
        )
    }

    /// What is to stand in each file.
    fn contents(&self, targets: &Targets, catalogue: &Catalogue) -> Result<Vec<Vec<u8>>, Failure> {
        let mut pages = 0;
        let mut contents = Vec::new();
        for (path, format) in &targets.files {
            let mut content = Vec::new();
            if *format == Format::Html {
                let edition = match (self.worksheet, pages % 2) {
                    (false, _) => Edition::Report,
                    (true, 0) => Edition::Worksheet,
                    (true, _) => Edition::Solutions,
                };
                pages += 1;
                content.extend(self.page(edition, catalogue)?.into_bytes());
            } else {
                let written = json::write_article(self.checks, catalogue, &mut content);
                let name = crate::load::shown(path);
                written.map_err(|error| Failure::system(catalogue, &name, &error))?;
            }
            contents.push(content);
        }
        Ok(contents)
    }

    fn page(&self, edition: Edition, catalogue: &Catalogue) -> Result<String, Failure> {
        let document = document(self.laboratory, self.checks, edition, catalogue);
        let mut document = document.map_err(|error| Failure::core(catalogue, &error))?;
        if let Some(numbers) = &self.claims {
            document.keep_claims(numbers);
        }
        // Only a mistake in the catalogue or the template can fail here, which tests have found.
        html::page(&document, catalogue).map_err(|error| Failure::System(error.to_string()))
    }
}
