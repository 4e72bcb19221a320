//! Measurement files of LabVIEW.

mod reader;

use federpendel_fit::Quantity;
use federpendel_fit::read::{Choice, Clock, ReadError};
use reader::{fails, read, read_with};

/// The headers of a file of LabVIEW, around what its segment says of channels and times.
fn labview(segment: &str, table: &str) -> String {
    let file = "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\nDecimal_Separator\t.\n\
        Date\t2026/03/04\nTime\t10:11:12.345\n***End_of_Header***\t\n\t\n";
    let segment = format!("{segment}Samples\t5\t5\t\n***End_of_Header***\t\t\t\n");
    format!("{file}{segment}{table}").replace('\n', "\r\n")
}

#[test]
fn labview_with_its_units() {
    let said = "Channels\t2\t\nY_Unit_Label\tV\tm/s^2\t\nX_Dimension\tTime\tTime\t\nX0\t0.0\t0.0\t\n\
        Delta_X\t0.25\t0.25\t\n";
    let rows = ["0.5", "-2", "1", "-0.5", "0.25"].iter().enumerate();
    let rows: String =
        rows.map(|(i, value)| format!("{}\t5\t{value}\n", 0.25 * i as f64)).collect();
    // A comment in the first row only, which programs write there.
    let commented = rows.replacen("0.5\n", "0.5\tbench 3\n", 1);
    let choice = Choice { value: Some("Acceleration".into()), ..Choice::default() };
    for rows in [&rows, &commented] {
        let text = labview(said, &format!("X_Value\tVoltage\tAcceleration\tComment\n{rows}"));
        let read = read_with(&text, &choice).unwrap();
        assert_eq!(read.recording.times, [0.0, 0.25, 0.5, 0.75, 1.0]);
        assert_eq!(read.recording.values, [0.5, -2.0, 1.0, -0.5, 0.25]);
        assert_eq!(read.recording.quantity, Quantity::Acceleration);
        assert_eq!((read.recording.unit.as_str(), &read.notes[..]), ("m/s^2", &[][..]));
    }
    // Without times the step between them stands above.
    let untimed = "X_Value\tAcceleration\tComment\n\t0.5\n\t-2\n\t1\n\t-0.5\n\t0.25\n";
    let read = read(&labview(&said.replace("V\t", ""), untimed));
    assert_eq!((read.clock, read.recording.times[4]), (Clock::Rate(4.0), 1.0));
    // A second segment is not read as if it belonged to the first.
    let twice = labview(said, &format!("X_Value\tVoltage\tAcceleration\tComment\n{rows}{said}"));
    assert!(matches!(fails(&twice), ReadError::NoNumber { line: 22, .. }), "{:?}", fails(&twice));
}
