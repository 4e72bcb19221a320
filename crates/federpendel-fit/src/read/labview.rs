//! Measurement files of LabVIEW (.lvm): a header of the file and one of the segment, each of a name and its values a line,
//! before the table.

use super::heading::Heading;
use super::line::{Line, Separator, decode};

/// How a file begins, and what ends each of its headers.
const BEGINS: &[u8] = b"LabVIEW Measurement";
const HEADER_ENDS: &[u8] = b"***End_of_Header***";

/// Headers before the first table. A third one belongs to a second table, which no recording goes on in.
const HEADERS: usize = 2;

/// What the headers say.
pub(super) struct Header<'a> {
    lines: &'a [Line<'a>],
}

impl<'a> Header<'a> {
    /// The headers that a file begins with, and the lines behind them.
    pub fn split(lines: &'a [Line<'a>]) -> Option<(Self, &'a [Line<'a>])> {
        lines.first().filter(|line| line.text.starts_with(BEGINS))?;
        let ends = |(_, line): &(usize, &Line)| line.text.starts_with(HEADER_ENDS);
        let (last, _) = lines.iter().enumerate().filter(ends).take(HEADERS).last()?;
        let (lines, table) = lines.split_at(last + 1);
        Some((Header { lines }, table))
    }

    /// What stands behind a name, for each channel.
    fn said(&self, name: &str) -> Vec<String> {
        let said = self.lines.iter().find_map(|line| {
            let line = decode(line.text);
            let behind = line.strip_prefix(name)?.strip_prefix(['\t', ',', ';'])?;
            Some(behind.split(['\t', ',', ';']).map(|cell| cell.trim().to_owned()).collect())
        });
        said.unwrap_or_default()
    }

    /// What stands between cells.
    pub fn separator(&self) -> Option<Separator> {
        let said = self.said("Separator");
        let named = [("Tab", Separator::Tab), ("Comma", Separator::Comma)];
        named
            .into_iter()
            .find(|(name, _)| said.first().is_some_and(|said| said == name))
            .map(|one| one.1)
    }

    /// Whether the first column of each channel is a time.
    fn is_timed(&self) -> bool {
        self.said("X_Dimension").iter().any(|dimension| dimension == "Time")
    }

    /// Gives headings the units of their channels, where they have none.
    pub fn name_units(&self, headings: &mut [Heading]) {
        let mut units = self.said("Y_Unit_Label").into_iter();
        for heading in headings.iter_mut().filter(|heading| heading.name != "Comment") {
            let unit = match heading.name.as_str() {
                "X_Value" => self.is_timed().then(|| "s".to_owned()),
                _ => units.next(),
            };
            if heading.unit.is_empty() {
                heading.unit = unit.unwrap_or_default();
            }
        }
    }

    /// The step between times that a table without times has, by a name under which it is looked for.
    pub fn step(&self) -> Option<String> {
        let step = self.said("Delta_X").into_iter().find(|step| !step.is_empty())?;
        self.is_timed().then(|| format!("dt = {step} s"))
    }
}
