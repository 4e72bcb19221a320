//! Text in the dialects of measuring programs.

mod reader;

use federpendel_fit::Quantity;
use federpendel_fit::read::{Choice, Clock, Decimal, Note, ReadError, Rows, Separator};
use reader::{fails, label, labels, read, read_with};

fn choice(value: &str) -> Choice {
    Choice { value: Some(value.to_owned()), ..Choice::default() }
}

#[test]
fn phyphox_in_all_its_variants() {
    let table = "\"Time (s)\"|\"Acceleration x (m/s^2)\"|\"Acceleration y (m/s^2)\"|\"Absolute acceleration (m/s^2)\"\n\
        0.000000000E0|1.003170490E-1|9.543418407E0|9.55E0\n\
        9.364549000E-3|9.696516991E-2|-9.600879431E0|9.61E0\n\
        1.136538300E-2|9.696516991E-2|9.620033026E0|9.62E0\n\
        1.336699700E-2|-1.5E-1|-9.7E0|9.71E0\n";
    for (separator, sign, decimal, mark) in [
        (Separator::Comma, ",", Decimal::Point, "."),
        (Separator::Tab, "\t", Decimal::Point, "."),
        (Separator::Semicolon, ";", Decimal::Point, "."),
        (Separator::Tab, "\t", Decimal::Comma, ","),
        (Separator::Semicolon, ";", Decimal::Comma, ","),
    ] {
        let text = table.replace('.', mark).replace('|', sign);
        let read = read(&text);
        assert_eq!((read.dialect.separator, read.dialect.decimal), (separator, decimal), "{text}");
        assert_eq!(read.recording.times, [0.0, 9.364549e-3, 1.1365383e-2, 1.3366997e-2]);
        assert_eq!(read.recording.values, [9.543418407, -9.600879431, 9.620033026, -9.7]);
        assert_eq!(read.value.label, "Acceleration y (m/s^2)");
        assert_eq!(labels(&read.others), ["Acceleration x (m/s^2)"]);
        assert_eq!(read.recording.quantity, Quantity::Acceleration);
        assert_eq!(read.recording.unit, "m/s^2");
        assert_eq!(read.notes, []);
    }
}

#[test]
fn a_magnitude_is_only_read_when_it_is_named() {
    let text = "t (s),x (m),Absolute displacement (m)\n0,1,9\n1,-1,1\n2,1,9\n3,-1,1\n";
    assert_eq!(read(text).value.label, "x (m)");
    let named = read_with(text, &choice("Absolute displacement")).unwrap();
    assert_eq!(named.recording.values, [9.0, 1.0, 9.0, 1.0]);
    let only = "t (s),Absolute displacement (m)\n0,9\n1,1\n2,9\n3,1\n";
    assert!(matches!(fails(only), ReadError::NoValue { .. }));
}

#[test]
fn tracker() {
    let text = "mass A\t\t\t\nt\tx\ty\t\n0.0\t1.0\t0.1\t\n0.1\t\t\t\n0.2\t-1.0\t0.1\t\n0.3\t0.5\t0.2\t\n\
        0.4\t-0.3\t0.1\t\n0.5\t\t\t\n0.6\t\t\t\n";
    let read = read(text);
    assert_eq!(read.recording.times, [0.0, 0.2, 0.3, 0.4]);
    assert_eq!(read.recording.values, [1.0, -1.0, 0.5, -0.3]);
    assert_eq!((label(&read), read.recording.quantity), ("x", Quantity::Position));
    let missing = Note::Missing(Rows { count: 1, first_line: 4 });
    assert_eq!(read.notes, [Note::TimeUnitAssumed, missing]);
}

#[test]
fn vernier() {
    let text = "Latest: Time (s),Latest: Position (m),Latest: Velocity (m/s)\n0,0.5,0\n0.05,0.4,-2\n0.1,0.1,-3\n0.15,-0.2,-1\n";
    let read = read(text);
    assert_eq!((label(&read), read.run.as_deref()), ("Latest: Position (m)", Some("Latest")));
    assert_eq!(read.recording.values, [0.5, 0.4, 0.1, -0.2]);
    let velocity = Choice { quantity: Some(Quantity::Velocity), ..Choice::default() };
    assert_eq!(read_with(text, &velocity).unwrap().recording.values, [0.0, -2.0, -3.0, -1.0]);
}

const RUNS: &str = "Time (s) Run #1,Angle (deg) Run #1,Time (s) Run #2,Angle (deg) Run #2\n\
    0,90,0,180\n1,-90,2,-180\n2,90,4,180\n3,-90,6,-180\n4,90,,\n";

#[test]
fn pasco_runs_side_by_side() {
    use std::f64::consts::{FRAC_PI_2, PI};
    let all = federpendel_fit::read::recordings(RUNS.as_bytes(), &Choice::default()).unwrap();
    assert_eq!(all.len(), 2);
    assert_eq!(all[0].recording.values, [FRAC_PI_2, -FRAC_PI_2, FRAC_PI_2, -FRAC_PI_2, FRAC_PI_2]);
    assert_eq!(all[1].recording.values, [PI, -PI, PI, -PI]);
    assert_eq!(all[1].recording.times, [0.0, 2.0, 4.0, 6.0]);
    assert_eq!((all[1].run.as_deref(), &all[1].recording.unit[..]), (Some("Run #2"), "rad"));
    assert!(all.iter().all(|read| read.notes.is_empty()), "{all:?}");
    for asked in ["2", "run #2", "Run #2"] {
        let run = Choice { run: Some(asked.to_owned()), ..Choice::default() };
        assert_eq!(read_with(RUNS, &run).unwrap(), all[1], "{asked}");
    }
    let run = Choice { run: Some("3".to_owned()), ..Choice::default() };
    let runs = vec!["Run #1".to_owned(), "Run #2".to_owned()];
    assert_eq!(read_with(RUNS, &run), Err(ReadError::RunNotFound { asked: "3".into(), runs }));
}

#[test]
fn runs_that_share_a_time_are_one_each() {
    let text = "Time (s) Run #1,x (m) Run #1,x (m) Run #2\n0,1,2\n1,-1,-2\n2,1,2\n3,-1,-2\n";
    let all = federpendel_fit::read::recordings(text.as_bytes(), &Choice::default()).unwrap();
    assert_eq!(all[1].recording.values, [2.0, -2.0, 2.0, -2.0]);
    assert_eq!(all[1].recording.times, [0.0, 1.0, 2.0, 3.0]);
}

#[test]
fn a_run_that_is_none_is_told_beside_the_others() {
    let text = "Time (s) Run #1,x (m) Run #1,Time (s) Run #2,x (m) Run #2\n0,1,0,1\n1,-1,,\n2,1,,\n3,-1,,\n";
    let why = Box::new(ReadError::TooFewRows { rows: 1, least: 4 });
    assert_eq!(read(text).notes, [Note::RunLeftOut { run: "Run #2".into(), why }]);
}

#[test]
fn runs_named_in_a_line_of_their_own() {
    let text = "Run #1\t\tRun #2\t\nTime (s)\tx (m)\tTime (s)\tx (m)\n0\t1\t0\t2\n1\t-1\t1\t-2\n2\t1\t2\t2\n3\t-1\t3\t-2\n";
    let all = federpendel_fit::read::recordings(text.as_bytes(), &Choice::default()).unwrap();
    let runs: Vec<_> = all.iter().map(|read| read.run.as_deref()).collect();
    assert_eq!(runs, [Some("Run #1"), Some("Run #2")]);
    assert_eq!(all[1].recording.values[0], 2.0);
}

#[test]
fn our_own_tables() {
    let text = "Time (s),Position (m),Velocity (m/s),Acceleration (m/s^2),Mode\n\
        0,0.1,0,-3.8,-1\n0.5,0.05,-1.5,-3.7,-1\n1.0,-0.1,-2.1,3.7,1\n1.5,0.02,1,3.6,0\n";
    let german = text.replace(',', ";").replace('.', ",");
    for text in [text, &german] {
        let read = read(text);
        assert_eq!(label(&read), "Position (m)");
        assert_eq!(read.recording.values, [0.1, 0.05, -0.1, 0.02]);
        assert_eq!(labels(&read.others), ["Velocity (m/s)", "Acceleration (m/s^2)"]);
        let second = read_with(text, &choice("velocity")).unwrap();
        assert_eq!(second.recording.values, [0.0, -1.5, -2.1, 1.0]);
        assert_eq!(second.recording.quantity, Quantity::Velocity);
        assert_eq!(read_with(text, &choice("3")).unwrap(), second);
    }
}

#[test]
fn german_headings_and_small_units() {
    let text = "\u{feff}# Versuch vom Montag; Feder 3\n\"Zeit (ms)\";\"Auslenkung (cm)\"\n0;1,5\n20;-1,25\n40;1\n60;-0,75\n";
    let cm = read(text);
    assert_eq!(cm.recording.times, [0.0, 0.02, 0.04, 0.06]);
    assert_eq!(cm.recording.values, [0.015, -0.0125, 0.01, -0.0075]);
    assert_eq!((cm.recording.quantity, &cm.recording.unit[..]), (Quantity::Position, "m"));
    let g = read("Zeit / min\tBeschleunigung in g\n0\t1\n0,5\t-1\n1\t0,5\n2\t-0,5\n");
    assert_eq!(g.recording.times, [0.0, 30.0, 60.0, 120.0]);
    assert_eq!(g.recording.values, [9.80665, -9.80665, 4.903325, -4.903325]);
    // °, ² and ö in Latin-1.
    let latin = b"Zeit [s];H\xf6he [mm];Winkel [\xb0]\n0;1;90\n1;2;-90\n2;1;90\n3;2;-90\n";
    let latin1 = federpendel_fit::read::recordings(latin, &choice("Winkel")).unwrap();
    assert_eq!(latin1[0].recording.values[0], std::f64::consts::FRAC_PI_2);
    assert_eq!(labels(&latin1[0].others), ["Höhe [mm]"]);
}

#[test]
fn headers_of_two_lines_and_other_separators() {
    let two = "name,length\nTime,Position\n(s),(mm)\n0,1000\n1,-1000\n2,1000\n3,-1000\n";
    assert_eq!(read(two).recording.values, [1.0, -1.0, 1.0, -1.0]);
    let pasco = "Voltage, ChA, Run #1\r\nTime ( s )\tVoltage ( V )\r\n0.0\t0.1\r\n0.1\t-0.1\r\n0.2\t0.1\r\n0.3\t-0.1\r\n";
    let volts = read(pasco);
    assert_eq!((label(&volts), &volts.recording.unit[..]), ("Voltage ( V )", "V"));
    assert_eq!(volts.notes, [Note::QuantityAssumed]);
    for header in ["# time, x", "time (s) angular velocity (rad/s)", "% t[s]  v[m/s]", "t v"] {
        let text = format!("{header}\n 0.0   1.5\n 1.0  -1.5\n 2.0   1.5\n 3.0  -1.5\n");
        let read = read(&text);
        assert!(read.dialect.header, "{header}");
        assert_eq!(read.recording.values, [1.5, -1.5, 1.5, -1.5], "{header}");
    }
}

#[test]
fn a_header_with_comments_below_and_several_times() {
    let text = "Time (ms),x (cm)\n# from here, all well\n0,1\n1,-1\n2,1\n3,-1\n";
    assert_eq!(read(text).recording.values, [0.01, -0.01, 0.01, -0.01]);
    let text = "sep=;\ntime;seconds_elapsed;Latency (ms);z\n1700000000000000000;0;5;1\n1700000000010000000;0,01;5;2\n\
        1700000000020000000;0,02;5;1\n1700000000030000000;0,03;5;2\n";
    let read = read(text);
    assert_eq!((&read.recording.times[..], label(&read)), (&[0.0, 0.01, 0.02, 0.03][..], "z"));
}

#[test]
fn preamble_comments_and_quoted_decimal_commas() {
    let text = "Report of 2024, 5 pages\nOperator: A, B\n\nTime (s),x (m)\n\"0,0\",\"1,5\"\n\"1,0\",\"-1,5\"\n# pause\n\n\"2,0\",\"1,5\"\n\"3,0\",\"-1,5\"\n";
    let read = read(text);
    assert_eq!((read.dialect.separator, read.dialect.decimal), (Separator::Comma, Decimal::Comma));
    assert_eq!(read.recording.values, [1.5, -1.5, 1.5, -1.5]);
    assert_eq!(read.notes, []);
}

#[test]
fn no_header() {
    let text = "10.000\t-0.683\n10.010\t-0.694\n10.020\t-0.702\n10.030\t-0.699\n";
    let read = read(text);
    assert_eq!(read.recording.times, [10.0, 10.01, 10.02, 10.03]);
    assert_eq!((label(&read), read.recording.quantity), ("2", Quantity::Position));
    assert!(!read.dialect.header);
    assert_eq!(read.notes, [Note::TimeGuessed, Note::TimeUnitAssumed, Note::QuantityAssumed]);
}

#[test]
fn even_times_from_a_rate() {
    let text = "trigger_start_deg, sample_rate, duration_sec\n90, 1000, 5 \n-90.36\n-90.64\nNaN\n-90.91\n-91\n";
    let read = read(text);
    assert_eq!(read.clock, Clock::Rate(1000.0));
    assert_eq!(read.recording.times, [0.0, 0.001, 0.003, 0.004]);
    let given = Choice { rate: Some(10.0), ..Choice::default() };
    let column = "x (cm)\n1\n-1\n1\n-1\n";
    assert_eq!(read_with(column, &given).unwrap().recording.times, [0.0, 0.1, 0.2, 0.3]);
    assert!(matches!(fails(column), ReadError::NoTime { .. }));
}

#[test]
fn utf_16_and_old_line_ends() {
    let text = "Time (s)\tWinkel (°)\r0\t90\r1\t-90\r2\t90\r3\t-90\r";
    let expected = read(text).recording;
    for bytes in [u16::to_le_bytes, u16::to_be_bytes] {
        for text in [format!("\u{feff}{text}"), text.to_owned()] {
            let encoded: Vec<u8> = text.encode_utf16().flat_map(bytes).collect();
            let read = federpendel_fit::read::recordings(&encoded, &Choice::default()).unwrap();
            assert_eq!(read[0].recording, expected);
        }
    }
}

#[test]
fn decimal_commas_that_come_late() {
    let mut text = "t;x\n".to_owned();
    for row in 0..2000 {
        text += &format!("{row};{}\n", row % 3);
    }
    text += "2000;0,5\n2001,5;1\n";
    let read = read(&text);
    assert_eq!(read.recording.times.last(), Some(&2001.5));
    assert_eq!(read.dialect.decimal, Decimal::Comma);
}

/// Header of a table kept by hand, and rows below it.
const REMARKED: &str = "Nr.;Zeit in s;Auslenkung in cm;Bemerkung\n\
    1;0,0;5,5;losgelassen\n2;0,1;-4,5\n3;0,2;3,5\n4;0,3;-2,5\n5;0,4;1,5\n";

#[test]
fn a_remark_in_the_first_row_hides_no_header() {
    let filled = REMARKED.replace(",5\n", ",5;\n");
    let later = REMARKED.replace(";losgelassen", "").replace("-2,5", "-2,5;gestoßen");
    for text in [REMARKED, &filled, &later] {
        let read = read(text);
        assert_eq!(label(&read), "Auslenkung in cm", "{text}");
        assert_eq!(read.recording.times, [0.0, 0.1, 0.2, 0.3, 0.4], "{text}");
        assert_eq!(read.recording.values, [5.5, -4.5, 3.5, -2.5, 1.5].map(|cm| cm / 100.0));
        assert_eq!(read.notes, [], "{text}");
    }
    // A row that lacks more than the remark is none.
    let broken = REMARKED.replace("3;0,2;3,5", "3;0,2");
    assert_eq!(fails(&broken), ReadError::Cells { line: 4, found: 2, expected: 4 });
}

#[test]
fn a_comma_between_integers_is_a_decimal_sign_under_one_heading() {
    let rate = Choice { rate: Some(10.0), ..Choice::default() };
    let (rows, values) = ("12,03\n-11,5\n10\n-8,25\n", [12.03, -11.5, 10.0, -8.25]);
    for (header, factor) in [("x in cm\n", 100.0), ("", 1.0), ("Messung 1\n", 1.0)] {
        let read = read_with(&format!("{header}{rows}"), &rate).unwrap();
        assert_eq!(read.recording.values, values.map(|value| value / factor), "{header}");
        assert_eq!(read.dialect.decimal, Decimal::Comma);
    }
    // Two headings, or first integers that rise, are two columns.
    let two = read_with("x,y\n12,03\n-11,5\n10,7\n-8,25\n", &rate).unwrap();
    assert_eq!(two.recording.values, [12.0, -11.0, 10.0, -8.0]);
    assert_eq!(read("0,5\n1,7\n2,9\n3,5\n").recording.values, [5.0, 7.0, 9.0, 5.0]);
    // Neither is known here.
    for text in ["12,3\n11,5\n10,7\n8,25\n", "0,00,12,3\n0,10,11,5\n0,20,10,7\n0,30,8,25\n"] {
        assert!(matches!(fails(text), ReadError::Commas { line: 1, .. }), "{text}");
    }
}

#[test]
fn what_a_terminal_obeys_is_blank_in_names() {
    let text = "Run\u{7} #1,\n\u{1b}t\u{7} (s),\u{1b}[31mx\u{9b} (m)\n0,1\n1,-1\n2,1\n3,-1\n";
    let read = read(text);
    assert_eq!((label(&read), &read.value.name[..]), ("[31mx  (m)", "[31mx"));
    assert_eq!(read.run.as_deref(), Some("Run  #1"));
}

#[test]
fn times_of_day_count_from_the_first() {
    let rows = "23:59:59,500;1,5\n23:59:59,750;-1,5\n0:00:00,000;1,5\n;0\n00:00:00,250;-1,5\n";
    for header in ["Uhrzeit;x in cm\n", "Zeit (hh:mm:ss);x in cm\n"] {
        let read = read(&format!("{header}{rows}"));
        assert_eq!(read.recording.times, [0.0, 0.25, 0.5, 0.75]);
        assert_eq!(read.recording.values[..2], [0.015, -0.015]);
        assert_eq!(read.notes, [Note::Missing(Rows { count: 1, first_line: 5 })]);
    }
    assert_eq!(read(rows).recording.times, [0.0, 0.25, 0.5, 0.75]);
}
