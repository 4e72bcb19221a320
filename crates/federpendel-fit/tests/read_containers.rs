//! Archives and workbooks.

use std::io::{Cursor, Write};

use federpendel_fit::Quantity;
use federpendel_fit::read::{Choice, Container, Decimal, Read, ReadError, recordings};
use rust_xlsxwriter::{Format, Workbook};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

const TABLE: &str = "\"Time (s)\";\"Winkel (rad)\"\n0;0,5\n1;-0,5\n2;0,25\n3;-0,25\n";

fn archive(files: &[(&str, &str)]) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, text) in files {
        archive.start_file(*name, SimpleFileOptions::default()).unwrap();
        archive.write_all(text.as_bytes()).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

fn table(name: &str) -> Choice {
    Choice { table: Some(name.to_owned()), ..Choice::default() }
}

fn one(bytes: &[u8], choice: &Choice) -> Result<Read, ReadError> {
    recordings(bytes, choice).map(|mut all| all.remove(0))
}

#[test]
fn an_archive_of_phyphox() {
    let notes = ("meta/device.csv", "\"property\",\"value\"\n\"version\",\"1\"\n");
    let bytes = archive(&[("Raw Data.csv", TABLE), notes, ("meta/time.csv", "a,b\n1,2\n")]);
    let read = one(&bytes, &Choice::default()).unwrap();
    assert_eq!(read.recording.values, [0.5, -0.5, 0.25, -0.25]);
    assert_eq!(read.dialect.container, Container::Zip);
    assert_eq!(read.dialect.table.as_deref(), Some("Raw Data.csv"));
    assert!(recordings(&bytes[..bytes.len() / 2], &Choice::default()).is_err());
    assert!(one(&archive(&[("bench.lvm", TABLE)]), &Choice::default()).is_ok());
}

#[test]
fn an_archive_of_several_tables() {
    let other = TABLE.replace("0,5", "7");
    let bytes = archive(&[("a/Accelerometer.csv", TABLE), ("a/Gyroscope.csv", &other)]);
    let tables = vec!["a/Accelerometer.csv".to_owned(), "a/Gyroscope.csv".to_owned()];
    let several = one(&bytes, &Choice::default());
    assert_eq!(several, Err(ReadError::SeveralTables { tables: tables.clone() }));
    assert_eq!(one(&bytes, &table("gyroscope")).unwrap().recording.values[0], 7.0);
    let asked = Some("nothing".to_owned());
    assert_eq!(one(&bytes, &table("nothing")), Err(ReadError::TableNotFound { asked, tables }));
    let none = one(&archive(&[("a.png", "")]), &Choice::default());
    assert!(matches!(none, Err(ReadError::TableNotFound { .. })), "{none:?}");
}

fn workbook() -> Vec<u8> {
    let mut book = Workbook::new();
    let sheet = book.add_worksheet().set_name("Raw Data").unwrap();
    // A line above, an empty column beside.
    sheet.write(0, 1, "measured\ton \"Monday\"").unwrap();
    for (column, name) in
        ["Time (ms)", "Position (cm)", "Absolute position (cm)"].iter().enumerate()
    {
        sheet.write(2, column as u16 + 1, *name).unwrap();
    }
    for (row, value) in [0.1, -0.2, 1e-300, 1.0 / 3.0, 12345.678].iter().enumerate() {
        sheet.write(row as u32 + 3, 1, row as f64).unwrap();
        sheet.write(row as u32 + 3, 2, *value).unwrap();
        sheet.write(row as u32 + 3, 3, f64::abs(*value)).unwrap();
    }
    let sheet = book.add_worksheet().set_name("Metadata Device").unwrap();
    sheet.write(0, 0, "property").unwrap();
    book.save_to_buffer().unwrap()
}

#[test]
fn a_workbook_of_today() {
    let read = one(&workbook(), &Choice::default()).unwrap();
    let expected = [0.1, -0.2, 1e-300, 1.0 / 3.0, 12345.678].map(|value| value * 1.0 / 100.0);
    assert_eq!(read.recording.values, expected);
    assert_eq!(read.recording.times, [0.0, 1.0, 2.0, 3.0, 4.0].map(|time| time / 1000.0));
    assert_eq!(read.dialect.container, Container::Xlsx);
    assert_eq!((read.recording.quantity, read.value.number), (Quantity::Position, 3));
}

#[test]
fn errors_in_a_workbook_name_its_rows() {
    let mut book = Workbook::new();
    let sheet = book.add_worksheet();
    for (column, name) in ["t (s)", "x (m)"].iter().enumerate() {
        sheet.write(3, column as u16, *name).unwrap();
    }
    for row in 0..6_u32 {
        sheet.write(row + 4, 0, row).unwrap();
        sheet.write(row + 4, 1, f64::from(row % 2)).unwrap();
    }
    sheet.write(7, 1, "lost").unwrap();
    let read = one(&book.save_to_buffer().unwrap(), &Choice::default());
    let (column, value, decimal) = ("x (m)".to_owned(), "lost".to_owned(), Decimal::Point);
    assert_eq!(read, Err(ReadError::NoNumber { line: 8, column, value, decimal }));
}

/// Written by xlwt 1.3: times 0, 0.25, …, of two components the second oscillates more.
#[test]
fn a_workbook_before_2007() {
    let bytes = include_bytes!("data/raw-data.xls");
    let read = one(bytes, &Choice::default()).unwrap();
    assert_eq!(read.dialect.container, Container::Xls);
    assert_eq!(read.value.label, "Linear Acceleration y (m/s^2)");
    assert_eq!(read.recording.times, [0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75]);
    assert_eq!(read.recording.values[..4], [0.5, -0.25, 0.125, -0.0625]);
    assert!(one(&bytes[..3000], &Choice::default()).is_err());
}

/// `examples/recordings/vernier.csv`, written into the first of three sheets by XlsxWriter 3.3 and by xlwt 1.3.
#[test]
fn a_recording_is_the_same_as_text_and_in_workbooks() {
    let text = include_bytes!("../../../examples/recordings/vernier.csv");
    let text = one(text, &Choice::default()).unwrap();
    let books: [(&[u8], _); 2] = [
        (include_bytes!("data/vernier.xlsx"), Container::Xlsx),
        (include_bytes!("data/vernier.xls"), Container::Xls),
    ];
    for (bytes, container) in books {
        let read = one(bytes, &Choice::default()).unwrap();
        assert_eq!(read.recording, text.recording);
        assert_eq!(
            (&read.value, &read.clock, &read.notes),
            (&text.value, &text.clock, &text.notes)
        );
        assert_eq!(read.dialect.container, container);
        assert_eq!(read.dialect.table.as_deref(), Some("Raw Data"));
        let other = one(bytes, &table("Metadata Time"));
        assert!(matches!(other, Err(ReadError::TableNotFound { .. })), "{other:?}");
    }
}

#[test]
fn workbooks_that_are_too_large_are_refused() {
    let mut book = Workbook::new();
    book.add_worksheet().write(0, 5000, 1.0).unwrap();
    let wide = one(&book.save_to_buffer().unwrap(), &Choice::default());
    assert_eq!(wide, Err(ReadError::TooManyColumns { found: 5001, most: 4096 }));
    // Two entries of the directory at the end of an archive: 24 bytes behind its mark stands the unpacked size.
    let mut bytes = workbook();
    let marks = bytes.windows(4).enumerate().filter(|(_, mark)| *mark == b"PK\x01\x02");
    let marks: Vec<usize> = marks.map(|(at, _)| at + 24).take(2).collect();
    for at in marks {
        bytes[at..at + 4].copy_from_slice(&0xf000_0000_u32.to_le_bytes());
    }
    let large = one(&bytes, &Choice::default());
    assert!(matches!(large, Err(ReadError::TooLarge { .. })), "{large:?}");
}

#[test]
fn a_column_of_remarks_may_be_empty_or_nearly() {
    for remarks in [&[][..], &[1], &[3], &[1, 2, 3, 4, 5]] {
        let mut book = Workbook::new();
        let sheet = book.add_worksheet();
        let header = ["Nr.", "Zeit in s", "Auslenkung in cm", "Bemerkung"];
        sheet.write_row(0, 0, header).unwrap();
        for row in 1..6_u32 {
            let time = f64::from(row) / 4.0;
            let value = time * f64::from(row % 2);
            sheet.write_row(row, 0, [f64::from(row), time, value]).unwrap();
        }
        for row in remarks {
            sheet.write(*row, 3, "losgelassen").unwrap();
        }
        let read = one(&book.save_to_buffer().unwrap(), &Choice::default()).unwrap();
        assert_eq!(read.value.label, "Auslenkung in cm", "{remarks:?}");
        assert_eq!(read.recording.times, [0.25, 0.5, 0.75, 1.0, 1.25], "{remarks:?}");
        assert_eq!(read.notes, [], "{remarks:?}");
    }
}

#[test]
fn the_only_table_with_times_and_numbers_is_taken() {
    let notes = "m;250 g\nk;12 N/m\nA;5\nB;6\n";
    let read = one(&archive(&[("notes.txt", notes), ("b.csv", TABLE)]), &Choice::default());
    assert_eq!(read.unwrap().dialect.table.as_deref(), Some("b.csv"));
    let mut book = Workbook::new();
    for (at, name) in ["Deckblatt", "Messung", "Aufgaben"].iter().enumerate() {
        let sheet = book.add_worksheet().set_name(*name).unwrap();
        sheet.write_row(0, 0, ["Zeit in s", "Winkel in rad"]).unwrap();
        for row in 0..if at == 1 { 8 } else { 0_u32 } {
            sheet.write_row(row + 1, 0, [f64::from(row), f64::from(row % 2)]).unwrap();
        }
    }
    let read = one(&book.save_to_buffer().unwrap(), &Choice::default()).unwrap();
    assert_eq!(read.dialect.table.as_deref(), Some("Messung"));
    assert_eq!(read.recording.values.len(), 8);
}

#[test]
fn an_archive_of_no_files_holds_no_table() {
    let none = one(&archive(&[]), &Choice::default());
    assert_eq!(none, Err(ReadError::TableNotFound { asked: None, tables: Vec::new() }));
}

/// A line of 32 MB packs into 32 kB; that its columns are counted up to 2 MB only shows that no more was unpacked.
#[test]
fn an_archive_is_unpacked_no_further_than_its_first_lines_allow() {
    let mut bomb = ZipWriter::new(Cursor::new(Vec::new()));
    bomb.start_file("a.csv", SimpleFileOptions::default()).unwrap();
    bomb.write_all("1,".repeat(1 << 24).as_bytes()).unwrap();
    match one(&bomb.finish().unwrap().into_inner(), &Choice::default()) {
        Err(ReadError::TooManyColumns { found, most: 4096 }) => assert!(found < 1 << 21, "{found}"),
        other => panic!("{other:?}"),
    }
}

/// Days since 1900 as a workbook keeps times: of a day, of a dated day, of a duration.
#[test]
fn times_of_day_in_a_workbook() {
    for (date, shown) in
        [(0.0, "hh:mm:ss.000"), (45_000.0, "dd.mm.yyyy hh:mm:ss"), (1.5, "[h]:mm:ss")]
    {
        let mut book = Workbook::new();
        let sheet = book.add_worksheet();
        sheet.write_row(0, 0, ["Zeit", "x in cm"]).unwrap();
        let format = Format::new().set_num_format(shown);
        for row in 0..5_u32 {
            let time = date + 0.25 + f64::from(row) * 0.125 / 86_400.0;
            sheet.write_with_format(row + 1, 0, time, &format).unwrap();
            sheet.write(row + 1, 1, row % 2).unwrap();
        }
        let read = one(&book.save_to_buffer().unwrap(), &Choice::default()).unwrap();
        assert_eq!(read.recording.times, [0.0, 0.125, 0.25, 0.375, 0.5], "{shown}");
    }
}
