//! Files that are handed out piece by piece read the same as whole ones; what no file can be read for is said.

use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::path::Path;

use federpendel_fit::read::{Choice, ReadError, recordings, recordings_from};

/// Hands out one to seven bytes at a time, and fails behind so many.
struct Pieces<'a> {
    bytes: Cursor<&'a [u8]>,
    calls: usize,
    most: u64,
}

impl<'a> Pieces<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        Pieces { bytes: Cursor::new(bytes), calls: 0, most: u64::MAX }
    }
}

impl Read for Pieces<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.calls += 1;
        if self.bytes.position() >= self.most {
            return Err(io::Error::from_raw_os_error(5));
        }
        if self.calls.is_multiple_of(5) {
            return Err(io::ErrorKind::Interrupted.into());
        }
        let most = buffer.len().min(1 + self.calls % 7);
        self.bytes.read(&mut buffer[..most])
    }
}

impl Seek for Pieces<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.bytes.seek(to)
    }
}

/// All files of a folder of the repository.
fn files(folder: &str) -> Vec<(String, Vec<u8>)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(folder);
    let entries = std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("a file"));
    entries
        .map(|entry| {
            let bytes = std::fs::read(entry.path()).expect("a file");
            (entry.file_name().to_string_lossy().into_owned(), bytes)
        })
        .collect()
}

fn utf16(text: &str, unit: fn(u16) -> [u8; 2]) -> Vec<u8> {
    ["\u{feff}", text].concat().encode_utf16().flat_map(unit).collect()
}

#[track_caller]
fn same(name: &str, bytes: &[u8]) {
    let choice = Choice::default();
    let whole = recordings(bytes, &choice);
    assert!(recordings_from(Pieces::new(bytes), &choice) == whole, "{name}: another recording");
}

#[test]
fn any_file_reads_the_same_in_pieces() {
    let all = [files("examples/recordings"), files("fuzz/seeds/recording")].concat();
    assert!(all.len() > 15);
    for (name, bytes) in &all {
        same(name, bytes);
        let Ok(text) = std::str::from_utf8(bytes) else { continue };
        // A clef takes two units of UTF-16, which pieces part.
        let text = ["𝄞 Recording\n", text].concat();
        let read = recordings(text.as_bytes(), &Choice::default());
        for wide in [utf16(&text, u16::to_le_bytes), utf16(&text, u16::to_be_bytes)] {
            same(name, &wide);
            assert!(recordings(&wide, &Choice::default()) == read, "{name}: another in UTF-16");
        }
    }
}

/// Of a table larger than what is looked at as a whole samples choose the column.
#[test]
fn a_large_table_reads_the_same_in_pieces() {
    let row = |row: u32| {
        let (quiet, loud) = (row % 3, if row < 100_000 { 0 } else { row % 5 });
        format!("{row};{quiet};{loud};ä\r\n")
    };
    let rows = 250_000;
    let text: String = (0..rows).map(row).collect();
    let text = ["t (s);a (m);b (m);remark\r\n", &text].concat();
    let wide = utf16(&text, u16::to_le_bytes);
    for bytes in [text.as_bytes(), &wide] {
        same("large", bytes);
        let read = recordings(bytes, &Choice::default()).expect("a recording").remove(0);
        assert_eq!((read.value.name.as_str(), read.recording.times.len()), ("b", rows as usize));
        assert!(read.recording.times.iter().enumerate().all(|(row, time)| row as f64 == *time));
        assert_eq!(read.recording.values[100_001..100_004], [1.0, 2.0, 3.0]);
    }
}

/// Integers for megabytes, then a decimal comma.
#[test]
fn a_decimal_sign_is_found_wherever_it_first_stands() {
    let rows: String = (0..400_000).map(|row| format!("{row};{}\n", row % 7)).collect();
    let text = ["t (s);x (m)\n", &rows, "400000;1,5\n"].concat();
    same("decimal", text.as_bytes());
    let read = recordings(text.as_bytes(), &Choice::default()).expect("a recording").remove(0);
    assert_eq!(read.recording.values.last(), Some(&1.5));
}

#[test]
fn what_the_system_does_not_read_is_its_own_error() {
    let text = (0..100).map(|row| format!("{row},{}\n", row % 7)).collect::<String>();
    for most in [0, 100] {
        let broken = Pieces { most, ..Pieces::new(text.as_bytes()) };
        match recordings_from(broken, &Choice::default()) {
            Err(ReadError::System(error)) => assert_eq!(error.0.raw_os_error(), Some(5)),
            other => panic!("{other:?}"),
        }
    }
}

/// Below the lines that tell the layout.
#[test]
fn a_line_without_end_is_refused() {
    let rows: String = (0..600).map(|row| format!("{row};{}\n", row % 7)).collect();
    let rows = "t (s);x (m)\n".to_owned() + &rows;
    let endless = "1 ".repeat(1 << 20);
    // The longest that is allowed has so many blanks behind its numbers, and its end.
    let blanks = " ".repeat((1 << 20) - "600;3".len() - 1);
    let refused = Err(ReadError::LongLine { line: 602, most: 1 << 20 });
    for last in [&endless, &format!("{endless}\n601;1\n"), &format!("600;3{blanks} \n601;4\n")] {
        let text = rows.clone() + last;
        assert_eq!(recordings(text.as_bytes(), &Choice::default()), refused);
    }
    let text = rows + "600;3" + &blanks + "\n601;4\n";
    let read = recordings(text.as_bytes(), &Choice::default()).expect("a recording").remove(0);
    assert_eq!(read.recording.values[600..], [3.0, 4.0]);
}
