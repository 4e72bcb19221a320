//! Any table, written in any dialect, reads back the same numbers; no bytes make the reader panic.

use federpendel_fit::read::{Choice, recordings};
use proptest::prelude::*;

/// How a table is written.
#[derive(Debug, Clone)]
struct Writing {
    separator: &'static str,
    comma: bool,
    quotes: bool,
    exponents: bool,
    mark: bool,
    header: Option<&'static [&'static str; 4]>,
    preamble: &'static str,
    end: &'static str,
    trailing: bool,
    last_end: bool,
    utf16: bool,
}

const HEADERS: [[&str; 4]; 4] = [
    ["Time (s)", "x (m)", "y (m)", "z (m)"],
    ["t", "a", "b", "c"],
    ["Zeit [s]", "Höhe [V]", "Winkel in rad", "q"],
    ["Time (s) Run #1", "Angle (rad) Run #1", "U (V) Run #1", "I (A) Run #1"],
];

fn writing() -> impl Strategy<Value = Writing> {
    let text = (
        prop::sample::select(vec![
            (",", false),
            (",", true),
            (";", false),
            (";", true),
            ("\t", false),
            ("\t", true),
            (" ", false),
            (" ", true),
        ]),
        any::<bool>(),
        any::<bool>(),
        any::<bool>(),
        prop::option::of(prop::sample::select(HEADERS.iter().collect::<Vec<_>>())),
    );
    let lines = (
        prop::sample::select(vec![
            "",
            "# a note, of 3; words\n",
            "Track A\n\n",
            "Date: 1.2.2024\nBy: A, B\n",
        ]),
        prop::sample::select(vec!["\n", "\r\n", "\r"]),
        any::<bool>(),
        any::<bool>(),
        any::<bool>(),
    );
    (text, lines).prop_map(|(text, lines)| {
        let ((separator, comma), quotes, exponents, mark, header) = text;
        let (preamble, end, trailing, last_end, utf16) = lines;
        // Commas cannot be both without quotes; blanks neither begin nor end a cell.
        let quotes = quotes || separator == "," && comma;
        let trailing = trailing && separator != " ";
        let preamble = if header.is_some() { preamble } else { "" };
        Writing {
            separator,
            comma,
            quotes,
            exponents,
            mark,
            header,
            preamble,
            end,
            trailing,
            last_end,
            utf16,
        }
    })
}

impl Writing {
    fn line(&self, cells: impl Iterator<Item = String>, quotes: bool) -> String {
        let cells: Vec<String> =
            cells.map(|cell| if quotes { format!("\"{cell}\"") } else { cell }).collect();
        cells.join(self.separator) + if self.trailing { self.separator } else { "" }
    }

    fn number(&self, number: f64) -> String {
        let text = if self.exponents { format!("{number:E}") } else { format!("{number}") };
        if self.comma { text.replace('.', ",") } else { text }
    }

    fn write(&self, rows: &[[f64; 4]], columns: usize) -> Vec<u8> {
        let mut lines = Vec::new();
        if let Some(header) = self.header {
            let names = header[..columns].iter().map(|name| (*name).to_owned());
            lines.push(self.line(names, self.quotes || self.separator == " "));
        }
        lines.extend(rows.iter().map(|row| {
            self.line(row[..columns].iter().map(|number| self.number(*number)), self.quotes)
        }));
        let text =
            self.preamble.to_owned() + &lines.join("\n") + if self.last_end { "\n" } else { "" };
        let text = text.replace('\n', self.end);
        let marked = if self.mark { format!("\u{feff}{text}") } else { text };
        if self.utf16 {
            marked.encode_utf16().flat_map(u16::to_le_bytes).collect()
        } else {
            marked.into_bytes()
        }
    }
}

fn table() -> impl Strategy<Value = Vec<[f64; 4]>> {
    let number = prop_oneof![
        -1e3..1e3_f64,
        (-1000..1000_i32).prop_map(|number| f64::from(number) / 16.0),
        -1e-9..1e-9_f64,
        -1e99..1e99_f64,
    ];
    let row = (1e-6..10.0_f64, prop::array::uniform3(number));
    prop::collection::vec(row, 4..40).prop_map(|rows| {
        let mut time = -3.0;
        let row = |(step, [a, b, c]): (f64, [f64; 3])| {
            time += step;
            [time, a, b, c]
        };
        rows.into_iter().map(row).collect()
    })
}

proptest! {
    #[test]
    fn any_table_reads_back_the_same_numbers(
        writing in writing(), rows in table(), columns in 2..=4_usize, value in 0..6_usize,
    ) {
        let value = 1 + value % (columns - 1);
        prop_assume!(rows.iter().any(|row| row[value] != rows[0][value]));
        let bytes = writing.write(&rows, columns);
        let choice = Choice { value: Some((value + 1).to_string()), ..Choice::default() };
        let read = recordings(&bytes, &choice).map_err(|error| {
            TestCaseError::fail(format!("{error}\n{}", String::from_utf8_lossy(&bytes)))
        })?;
        prop_assert_eq!(read.len(), 1);
        let recording = &read[0].recording;
        let times: Vec<f64> = rows.iter().map(|row| row[0]).collect();
        let values: Vec<f64> = rows.iter().map(|row| row[value]).collect();
        prop_assert_eq!(&recording.times, &times, "{}", String::from_utf8_lossy(&bytes));
        prop_assert_eq!(&recording.values, &values, "{}", String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn no_bytes_make_it_panic(text in "([0-9,.;\t \n\"#-]|time|x \\(m\\)|nan|Run #1|\\PC){0,80}", cut in 0..80_usize) {
        let bytes = text.as_bytes();
        let bytes = &bytes[..bytes.len().saturating_sub(cut)];
        for read in recordings(bytes, &Choice::default()).into_iter().flatten() {
            prop_assert!(read.recording.times.is_sorted_by(|a, b| a < b));
            prop_assert_eq!(read.recording.times.len(), read.recording.values.len());
        }
    }
}
