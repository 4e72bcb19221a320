//! Every cell as calamine reads it, a library for all that workbooks hold.

use std::io::Cursor;

use calamine::{DataType, Reader, Sheets, open_workbook_auto_from_rs};

use super::super::archive::Archive;
use super::super::source::Container;
use super::*;

/// A cell in words, its number to the last bit.
fn told(value: Value) -> String {
    match value {
        Value::Number(number) => format!("number {number:e}"),
        Value::Time { days, duration } => format!("time {days:e} {duration}"),
        Value::Text(text) => format!("text {text:?}"),
        Value::Truth(yes) => format!("truth {yes}"),
        Value::Error => "error".to_owned(),
    }
}

type Cells = Vec<(u32, u32, String)>;

fn open<'a>(
    file: &'a mut Cursor<&[u8]>,
    container: Container,
) -> Result<Box<dyn Book + 'a>, ReadError> {
    Ok(match container {
        Container::Xls => Box::new(Xls::open(file.get_ref())?),
        _ => Box::new(Xlsx::open(Archive::new(file)?)?),
    })
}

/// The sheets that hold something.
fn own(bytes: &[u8], container: Container) -> Result<Vec<(String, Cells)>, ReadError> {
    let mut file = Cursor::new(bytes);
    let mut book = open(&mut file, container)?;
    let mut sheets = Vec::new();
    for name in book.sheets() {
        let mut cells = Vec::new();
        let read = book.cells(&name, &mut |row, column, value| {
            // An empty text is none.
            if value != Value::Text("") {
                cells.push((row, column, told(value)));
            }
            Ok(true)
        });
        // A sheet of nothing but a chart is none.
        if read.is_ok() && !cells.is_empty() {
            sheets.push((name, cells));
        }
    }
    Ok(sheets)
}

fn library(bytes: &[u8]) -> Result<Vec<(String, Cells)>, calamine::Error> {
    let mut book: Sheets<_> = open_workbook_auto_from_rs(Cursor::new(bytes))?;
    let mut sheets = Vec::new();
    for name in book.sheet_names() {
        let Ok(range) = book.worksheet_range(&name) else { continue };
        let (top, left) = range.start().unwrap_or_default();
        let cells: Cells = range
            .used_cells()
            .filter(|(_, _, value)| value.get_string() != Some(""))
            .map(|(row, column, value)| {
                let number = value.get_int().map(|number| number as f64).or(value.get_float());
                let text = value.get_string().or(value.get_datetime_iso());
                let value = if let Some(time) = value.get_datetime() {
                    Value::Time { days: time.as_f64(), duration: time.is_duration() }
                } else if let Some(number) = number {
                    Value::Number(number)
                } else if let Some(truth) = value.get_bool() {
                    Value::Truth(truth)
                } else {
                    text.map_or(Value::Error, Value::Text)
                };
                (top + row as u32, left + column as u32, told(value))
            })
            .collect();
        if !cells.is_empty() {
            sheets.push((name, cells));
        }
    }
    Ok(sheets)
}

/// Holds every cell against the library's; says how many there are.
fn same(bytes: &[u8], container: Container) -> usize {
    let sheets = own(bytes, container).unwrap();
    assert_eq!(sheets, library(bytes).unwrap());
    sheets.iter().map(|(_, cells)| cells.len()).sum()
}

const RAW_DATA: &[u8] = include_bytes!("../../../tests/data/raw-data.xls");
/// Written by xlwt 1.3: numbers as integers, hundredths and floats, times, durations, truths, a formula without result,
/// texts; texts of thousands of signs, some of them beyond Latin-1, that go on in further records.
const KINDS: &[u8] = include_bytes!("../../../tests/data/kinds.xls");
const VERNIER: &[u8] = include_bytes!("../../../tests/data/vernier.xls");

#[test]
fn workbooks_before_2007_hold_what_the_library_reads() {
    assert_eq!(same(RAW_DATA, Container::Xls), 40);
    assert_eq!(same(KINDS, Container::Xls), 46);
    assert_eq!(same(VERNIER, Container::Xls), 1510);
}

/// Where these bytes stand, again and again.
fn places(bytes: &[u8], wanted: &[u8]) -> Vec<usize> {
    let windows = bytes.windows(wanted.len()).enumerate();
    windows.filter(|(_, found)| *found == wanted).map(|(at, _)| at).collect()
}

/// A program may write cells in any order, and one over another.
#[test]
fn cells_out_of_order_are_put_in_order() {
    let mut book = RAW_DATA.to_vec();
    // Records of numbers, their rows behind kind and length.
    let numbers = places(&book, &[0x03, 0x02, 14, 0]);
    let (first, last) = (numbers[0] + 4, numbers[numbers.len() - 1] + 4);
    let row = book[first..first + 2].to_vec();
    book.copy_within(last..last + 2, first);
    book[last..last + 2].copy_from_slice(&row);
    assert!(same(&book, Container::Xls) > 30);
    let (column, other) = (numbers[2] + 6, numbers[1] + 6);
    book.copy_within(column..column + 2, other);
    assert!(same(&book, Container::Xls) > 30);
}

#[test]
fn workbooks_since_2007_hold_what_the_library_reads() {
    let mut book = rust_xlsxwriter::Workbook::new();
    let formats = ["General", "0.00E+00", "dd.mm.yyyy hh:mm", "[h]:mm:ss", "0.0\" ms\"", "mm:ss.0"]
        .map(|code| rust_xlsxwriter::Format::new().set_num_format(code));
    for name in ["Raw Data", "Blatt & <zwei>"] {
        let sheet = book.add_worksheet().set_name(name).unwrap();
        for row in 0..2000_u32 {
            // Any bits that make a number.
            let bits = u64::from(row + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(row);
            let number = f64::from_bits(bits);
            let number = if number.is_finite() { number } else { f64::from(row) / 7.0 };
            let format = &formats[row as usize % formats.len()];
            sheet.write_with_format(row, 0, number, format).unwrap();
            sheet.write(row, 3 + (row % 5) as u16, f64::from(row) * 0.01).unwrap();
        }
        for (row, text) in
            ["x in µm", "a & b < \"c\"", " Ω≈²\t😀 ", "_x0041_", "\r\nzwei"].iter().enumerate()
        {
            sheet.write(row as u32, 9, *text).unwrap();
            sheet.write(row as u32, 10, row % 2 == 0).unwrap();
            let formula =
                rust_xlsxwriter::Formula::new("=1/0").set_result(["#DIV/0!", "2.5", "t"][row % 3]);
            sheet.write(row as u32, 11, formula).unwrap();
        }
    }
    assert_eq!(same(&book.save_to_buffer().unwrap(), Container::Xlsx), 2 * 4015);
    let vernier = include_bytes!("../../../tests/data/vernier.xlsx");
    assert_eq!(same(vernier, Container::Xlsx), 1510);
}

/// A workbook of these parts, which differ from program to program.
fn book(strings: &str, styles: &str, sheet: &str) -> Vec<u8> {
    const ROOT: &str = "<Relationships><Relationship Id='a' Type='http://x/relationships/officeDocument' \
        Target='xl/workbook.xml'/></Relationships>";
    const PARTS: &str = "<Relationships><Relationship Id='r1' Type='http://x/relationships/worksheet' \
        Target='/xl/Daten/eins.xml'/></Relationships>";
    const BOOK: &str = "<?xml version='1.0'?>\n<!-- > --><x:workbook xmlns:x='x'><x:sheets>\
        <x:sheet name='Raw &#68;ata &gt;' r:id='r1'/></x:sheets></x:workbook>";
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, text) in [
        ("_rels/.rels", ROOT),
        ("xl/_rels/workbook.xml.rels", PARTS),
        ("xl/workbook.xml", BOOK),
        ("xl/sharedStrings.xml", strings),
        ("xl/styles.xml", styles),
        ("xl/Daten/eins.xml", sheet),
    ] {
        archive.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
        std::io::Write::write_all(&mut archive, text.as_bytes()).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

const STRINGS: &str = "<sst><si><t xml:space='preserve'> a </t></si><si><r><t>rich</t></r><r><rPr/><t> text</t></r>\
    <rPh><t>spoken</t></rPh></si><si/><si><t><![CDATA[<&>]]></t></si><si><t> _x0009_</t></si></sst>";
const STYLES: &str = "<styleSheet><numFmts count='1'><numFmt numFmtId='170' formatCode='[h]:mm'/></numFmts>\
    <cellStyleXfs><xf numFmtId='14'/></cellStyleXfs><cellXfs><xf numFmtId='0'/><xf numFmtId='14'/><xf numFmtId='170'/>\
    </cellXfs><dxfs><dxf><numFmt numFmtId='0' formatCode='hh'/></dxf></dxfs></styleSheet>";

#[test]
fn workbooks_of_unusual_programs_hold_what_the_library_reads() {
    let sheet = "<worksheet><sheetData><row><c><v>1</v></c><c t='s'><v>0</v></c><c t=\"s\"><v>1</v></c></row>\
        <row r='4' ht=\"3 > 2\"><c r='C4' s='1'><v>2.5</v></c><c s='2'><v>.5</v></c><c r='f4' t='str'><f>A1&amp;\"&lt;\"</f>\
        <v>b&#10;&lt;</v></c></row><row><c t='inlineStr'><v>0</v><is><t>in</t><phoneticPr/></is></c><c t='b'><v>1</v></c>\
        <c t='b'><v>false</v></c><c t='e'><v>#N/A</v></c><c t='d'><v>2026-01-02T03:04:05</v></c><c t='n'/><c><v/></c>\
        <c><v>word</v></c><c t='s'><v>3</v></c><c t='s'><v>4</v></c><c t='s'><v>2</v></c><c><v>-1E-3</v></c></row>\
        </sheetData><legacy/></worksheet>";
    assert_eq!(same(&book(STRINGS, STYLES, sheet), Container::Xlsx), 15);
}

/// What is refused here, and never with a panic or without an end.
#[test]
fn damaged_workbooks_are_refused() {
    let read = |sheet: &str| {
        let bytes = book(STRINGS, STYLES, sheet);
        let mut file = Cursor::new(&bytes[..]);
        let mut book = open(&mut file, Container::Xlsx).unwrap();
        let sheet = book.sheets().remove(0);
        book.cells(&sheet, &mut |_, _, _| Ok(true))
    };
    let cell = |cell: &str| {
        read(&format!("<worksheet><sheetData><row>{cell}</row></sheetData></worksheet>"))
    };
    for (written, reason) in [
        ("<c t='s'><v>5</v></c>", "no such shared text"),
        ("<c r='A0'><v>5</v></c>", "no such cell"),
        ("<c r='7'><v>5</v></c>", "no such cell"),
        ("<c r='AAAAAAAA7'><v>5</v></c>", "no such cell"),
        ("<c r='A99999999999'><v>5</v></c>", "no such cell"),
    ] {
        assert_eq!(cell(written), Err(damaged(reason)), "{written}");
    }
    assert_eq!(cell("<c r='XFD1048576'><v>5</v></c>"), Ok(()));
    assert_eq!(read("<worksheet><sheetData><row>"), Err(damaged("XML cut off")));
    let bytes = book("<sst><si>", STYLES, "");
    assert_eq!(
        open(&mut Cursor::new(&bytes[..]), Container::Xlsx).err(),
        Some(damaged("XML cut off"))
    );
}

#[test]
fn a_workbook_with_a_password_is_told_from_a_damaged_one() {
    let refused = |bytes: &[u8]| own(bytes, Container::Xls).err();
    // What an .xlsx with a password comes in: another stream in the same kind of file.
    let utf16 = |name: &str| name.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<_>>();
    let mut book = RAW_DATA.to_vec();
    let at = places(&book, &utf16("Workbook"))[0];
    book[at..][..32].copy_from_slice(&utf16("EncryptedPackage"));
    assert_eq!(refused(&book), Some(ReadError::Password));
    book[at..][..32].copy_from_slice(&utf16("AnythingElseHere"));
    assert_eq!(refused(&book), Some(damaged("no workbook in it")));
    let mut book = RAW_DATA.to_vec();
    // The record of the code page becomes that of a password.
    let at = places(&book, &[0x42, 0, 2, 0])[0];
    book[at] = 0x2f;
    assert_eq!(refused(&book), Some(ReadError::Password));
}

/// Bytes changed, cut and doubled at random: refused or read, in the end.
#[test]
fn no_damage_makes_it_panic() {
    let sheet = "<worksheet><sheetData><row r='1'><c r='A1' s='2'><v>1</v></c><c t='s'><v>1</v></c></row></sheetData></worksheet>";
    let plain = book(STRINGS, STYLES, sheet);
    let mut random = 1_u64;
    let mut next = |below: usize| {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (random >> 33) as usize % below
    };
    let mut refused = 0;
    for round in 0..6000 {
        let (bytes, container) = match round % 3 {
            0 => (RAW_DATA, Container::Xls),
            1 => (KINDS, Container::Xls),
            _ => (&plain[..], Container::Xlsx),
        };
        let mut bytes = bytes.to_vec();
        for _ in 0..=next(8) {
            let at = next(bytes.len());
            bytes[at] = [0, 1, 0xff, bytes[at] ^ 1 << next(8)][next(4)];
        }
        if next(4) == 0 {
            bytes.truncate(next(bytes.len()));
        }
        refused += usize::from(own(&bytes, container).is_err());
    }
    assert!((500..5500).contains(&refused), "{refused}");
}
