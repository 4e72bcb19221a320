//! Rows out of order, gaps and holes; files that are no recordings.

mod reader;

use federpendel_fit::read::{Choice, Decimal, Field, Found, Note, ReadError, Rows, recordings};
use reader::{fails, read};

fn rows(count: usize, first_line: usize) -> Rows {
    Rows { count, first_line }
}

#[test]
fn times_out_of_order_are_sorted() {
    let read = read("t (s),x (m)\n0,1\n2,3\n1,2\n\n4,5\n3,4\n");
    assert_eq!(read.recording.times, [0.0, 1.0, 2.0, 3.0, 4.0]);
    assert_eq!(read.recording.values, [1.0, 2.0, 3.0, 4.0, 5.0]);
    assert_eq!(read.notes, [Note::Sorted(rows(2, 4))]);
}

#[test]
fn equal_times_are_merged() {
    let read = read("t (s),x (m)\n0,1\n1,2\n1,4\n1,6\n# note\n2,5\n3,1\n3,2\n4,0\n");
    assert_eq!(read.recording.times, [0.0, 1.0, 2.0, 3.0, 4.0]);
    assert_eq!(read.recording.values, [1.0, 4.0, 5.0, 1.5, 0.0]);
    assert_eq!(read.notes, [Note::Averaged(rows(3, 4))]);
}

#[test]
fn gaps_are_told() {
    let read = read("t (s),x (m)\n0,1\n1,2\n2,1\n12,2\n13,1\n14,2\n22,0\n");
    assert_eq!(read.notes, [Note::Gaps { rows: rows(2, 5), longest: 10.0, usual: 1.0 }]);
}

#[test]
fn cells_without_numbers_are_left_out() {
    let read = read("t (s),x (m)\n0,1\n1,NaN\n2,\n,3\n3,#N/A\n#N/A,5\n4,1\n5,0\n6,-inf\n7,1\n");
    assert_eq!(read.recording.times, [0.0, 4.0, 5.0, 7.0]);
    assert_eq!(read.notes, [Note::Missing(rows(6, 3))]);
}

#[test]
fn a_last_line_cut_short_is_left_out() {
    let read = read("t (s),x (m),y (m)\n0,1,0\n1,2,0\n2,1,0\n3,2,0\n4,1");
    assert_eq!(read.recording.times.len(), 4);
    assert_eq!(read.notes, [Note::CutOff { line: 6 }]);
}

#[test]
fn recordings_below_each_other_are_runs() {
    let mut text = "t,x\n".to_owned();
    for row in 0..90 {
        text += &format!("{},{}\n", row % 30, row % 4 + row / 30);
    }
    let all = recordings(text.as_bytes(), &Choice::default()).unwrap();
    let runs: Vec<_> = all.iter().map(|read| read.run.as_deref()).collect();
    assert_eq!(runs, [Some("1"), Some("2"), Some("3")]);
    let times: Vec<f64> = (0..30).map(f64::from).collect();
    assert!(all.iter().all(|read| read.recording.times == times));
    assert_eq!(all[2].recording.values[..3], [2.0, 3.0, 4.0]);
    let run = |run: &str| Choice { run: Some(run.into()), ..Choice::default() };
    assert_eq!(recordings(text.as_bytes(), &run("2")).unwrap(), all[1..2]);
    let (asked, runs) = ("4".to_owned(), ["1", "2", "3"].map(str::to_owned).into());
    assert_eq!(recordings(text.as_bytes(), &run("4")), Err(ReadError::RunNotFound { asked, runs }));
    // Lines are those of the file, in the second run, too.
    let text = text.replacen("0,3\n1,4\n", "0,3\n\n1,4\n1,5\n", 1);
    let second = recordings(text.as_bytes(), &run("2")).unwrap().remove(0);
    assert_eq!(second.notes, [Note::TimeUnitAssumed, Note::Averaged(rows(1, 35))]);
    // Of runs side by side none may start over.
    let beside: String =
        (0..60).map(|row| format!("{0},{1},{0},{1}\n", row % 30, row % 4)).collect();
    let error = fails(&format!("t,x,t,x\n{beside}"));
    assert_eq!(error, ReadError::StartsOver { line: 32, value: 0.0, before: 29.0 });
    let unnamed = recordings(b"t,x\n0,1\n1,2\n2,1\n3,2\n", &run("1"));
    assert_eq!(unnamed, Err(ReadError::RunNotFound { asked: "1".into(), runs: Vec::new() }));
}

#[test]
fn broken_rows_are_refused_with_their_line() {
    let cell = |text: &str| fails(&format!("t (s);x (m)\n0;1,5\n1;2,5\n2;{text}\n3;1,5\n4;2\n"));
    let no_number = |value: &str| {
        let (column, value, decimal) = ("x (m)".into(), value.into(), Decimal::Comma);
        ReadError::NoNumber { line: 4, column, value, decimal }
    };
    for text in ["1.234,5", "1.5", "1 234", "abc", "12:30", "1,5 m", "1e"] {
        assert_eq!(cell(text), no_number(text));
    }
    for (text, found) in [("1;2", 3), ("1;2;3", 4)] {
        assert_eq!(cell(text), ReadError::Cells { line: 4, found, expected: 2 });
    }
    for text in ["1e101", "-1e400"] {
        let (column, value) = ("x (m)".to_owned(), text.to_owned());
        let expected = ReadError::OutOfRange { line: 4, column, value, most: 1e100 };
        assert_eq!(cell(text), expected);
    }
    let short = fails("t,x\n0,1\n1\n2,1\n3,2\n4,5\n");
    assert_eq!(short, ReadError::Cells { line: 3, found: 1, expected: 2 });
    // The first row, too, is held against the header.
    let first = fails("t,x\n0,1,2\n1,1\n2,1\n3,2\n4,5\n");
    assert_eq!(first, ReadError::Cells { line: 2, found: 3, expected: 2 });
    let grouped = fails("t,x\n0,\"1,234.5\"\n1,2.5\n2,1.5\n3,2\n4,5\n");
    let (column, value, decimal) = ("x".into(), "1,234.5".into(), Decimal::Point);
    let expected = ReadError::NoNumber { line: 2, column, value, decimal };
    assert_eq!(grouped, expected);
}

#[test]
fn a_column_of_values_without_a_number_is_refused_at_its_first_cell() {
    // Words, and points where the times have commas.
    for (text, column, value, decimal) in [
        ("t (s),a (m/s^2)\n0,err\n1,#NV\n2,err\n3,#NV\n", "a (m/s^2)", "err", Decimal::Point),
        ("t;x\n0,5;-0.1\n1,5;0.2\n2,5;0.1\n3,5;0.3\n", "x", "-0.1", Decimal::Comma),
        ("t,n,note,x (m)\n0,0,a,b\n1,1,a,b\n2,2,a,b\n3,3,a,b\n", "x (m)", "b", Decimal::Point),
    ] {
        let (column, value) = (column.to_owned(), value.to_owned());
        assert_eq!(fails(text), ReadError::NoNumber { line: 2, column, value, decimal });
    }
}

#[test]
fn headers_that_do_not_fit_are_refused() {
    let found = fails("t (s);x (m);y (m)\n0;1\n1;2\n2;1\n3;2\n");
    assert_eq!(found, ReadError::HeaderCells { line: 1, found: 3, expected: 2 });
    let found = fails("a,b,c\n0,1\n1,2\n2,1\n3,2\n");
    assert_eq!(found, ReadError::HeaderCells { line: 1, found: 3, expected: 2 });
    let clock = fails("Time,x (m)\n12:30:05,1\n12:30:06,2\n12:30:67,1\n12:30:08,2\n");
    let (column, value, decimal) = ("Time".into(), "12:30:67".into(), Decimal::Point);
    assert_eq!(clock, ReadError::NoNumber { line: 4, column, value, decimal });
    assert!(matches!(fails("t (s),x (m)\n"), ReadError::NoRows { line: 1, .. }));
    let unit = fails("Time (frames),x (m)\n0,1\n1,2\n2,1\n3,2\n");
    assert!(matches!(unit, ReadError::TimeUnit { ref unit, .. } if unit == "frames"), "{unit:?}");
    let frames = fails("frame,x (m)\n0,1\n1,2\n2,1\n3,2\n");
    assert!(matches!(frames, ReadError::NoTime { .. }), "{frames:?}");
    let no_time = fails("x,y\n5,1\n1,2\n2,1\n3,2\n");
    assert!(matches!(no_time, ReadError::NoTime { .. }), "{no_time:?}");
}

#[test]
fn more_columns_than_any_program_writes_are_refused() {
    let row = ["1"; 5000].join(",") + "\n";
    let expected = ReadError::TooManyColumns { found: 5000, most: 4096 };
    assert_eq!(fails(&row.repeat(4)), expected);
}

#[test]
fn tables_without_an_oscillation_in_them() {
    let row = fails("t (s),x (m)\n0,1\n");
    assert_eq!(row, ReadError::TooFewRows { rows: 1, least: 4 });
    let value = fails("t (s),x (m)\n0,1\n1,1\n2,1\n3,1\n");
    assert_eq!(value, ReadError::ConstantValue { column: "x (m)".into(), value: 1.0 });
    let time = fails("t (s),x (m)\n7,1\n7,2\n7,1\n7,2\n");
    assert_eq!(time, ReadError::ConstantTime { column: "t (s)".into(), value: 7.0 });
}

#[test]
fn files_of_another_kind_are_called_what_they_are() {
    let found = |bytes: &[u8]| match recordings(bytes, &Choice::default()) {
        Err(ReadError::NoTable { found, .. }) => found,
        other => panic!("{other:?}"),
    };
    assert_eq!(found(b"\x89PNG\r\n\x1a\n"), Found::Picture);
    assert_eq!(found(b"%PDF-1.7 1 2 3"), Found::Pdf);
    assert_eq!(found(b"\x1f\x8b\x08\x00"), Found::Gzip);
    assert_eq!(found(b"<?xml version=\"1.0\"?><object/>"), Found::Xml);
    assert_eq!(found(b"{\"t\": [1, 2, 3]}"), Found::Json);
    assert_eq!(found(b"1,2\n3,4\n\x00\x01\x02\x03"), Found::Binary);
    assert_eq!(found("Das ist kein Versuch.\nNur Text.\n".as_bytes()), Found::Prose);
    for bytes in [&b""[..], b"\n \n\r\n", b"\xef\xbb\xbf", b"\xff\xfe"] {
        assert_eq!(recordings(bytes, &Choice::default()), Err(ReadError::Empty));
    }
    for bytes in [&b"PK\x03\x04 and no more"[..], b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1 and no more"] {
        let read = recordings(bytes, &Choice::default());
        assert!(matches!(read, Err(ReadError::Damaged { .. })), "{read:?}");
    }
}

#[test]
fn choices_that_do_not_fit_name_what_there_is() {
    let text = b"t (s),x (m),x (cm)\n0,1,2\n1,2,1\n2,1,2\n3,2,1\n";
    let columns: Vec<String> = ["t (s)", "x (m)", "x (cm)"].map(str::to_owned).into();
    let value = |asked: &str| Choice { value: Some(asked.into()), ..Choice::default() };
    let found = recordings(text, &value("z"));
    let (field, asked) = (Field::Value, "z".to_owned());
    assert_eq!(found, Err(ReadError::ColumnNotFound { field, asked, columns: columns.clone() }));
    let found = recordings(text, &value("x"));
    let asked = "x".to_owned();
    let columns = columns[1..].to_vec();
    assert_eq!(found, Err(ReadError::ColumnAmbiguous { field, asked, columns }));
    let quantity = Some(federpendel_fit::Quantity::Velocity);
    let found = recordings(text, &Choice { quantity, ..value("x (m)") });
    assert!(matches!(found, Err(ReadError::QuantityUnit { .. })), "{found:?}");
    for rate in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let found = recordings(text, &Choice { rate: Some(rate), ..Choice::default() });
        assert!(matches!(found, Err(ReadError::Rate { .. })), "{found:?}");
    }
    let table = Choice { table: Some("Sheet2".into()), ..Choice::default() };
    assert!(matches!(recordings(text, &table), Err(ReadError::TableNotFound { .. })));
}

#[test]
fn a_rate_beside_a_column_of_times() {
    let text = "t (s),x (m)\n0,1\n1,-1\n2,1\n3,-1\n";
    let rate = Choice { rate: Some(10.0), ..Choice::default() };
    let read = reader::read_with(text, &rate).unwrap();
    assert_eq!(read.recording.times, [0.0, 0.1, 0.2, 0.3]);
    assert_eq!(read.notes, [Note::TimeIgnored { column: "t (s)".into() }]);
    let both = Choice { time: Some("t".into()), ..rate };
    let refused = Err(ReadError::RateAndTime { time: "t".into() });
    assert_eq!(recordings(text.as_bytes(), &both), refused);
}

#[test]
fn digits_in_groups_are_refused_where_they_stand() {
    for text in [
        "Zeit in s;Weg in mm\n0,00;1.299,6\n0,02;1.295,6\n0,04;999,1\n",
        "Zeit in ms;Weg in mm\n0;1.299,6\n20;1.295,6\n40;1.280,1\n",
        "time (s),position (mm)\n0.00,\"1,299.6\"\n0.02,\"1,295.6\"\n0.04,\"1,280.1\"\n",
    ] {
        let error = fails(text);
        let ReadError::NoNumber { line: 2, column, .. } = &error else {
            panic!("{error:?}\n{text}")
        };
        assert!(column.ends_with("mm") || column.ends_with("(mm)"), "{column}");
    }
}
