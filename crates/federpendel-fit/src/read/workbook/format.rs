//! Which numbers of a workbook are times: its file only says how they are shown.

use super::Value;

/// What a number is shown as.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    Number,
    Time,
    Duration,
}

impl Format {
    /// Formats that every workbook has. ECMA-376, part 1, section 18.8.30.
    fn built_in(id: usize) -> Self {
        match id {
            14..=22 | 27..=36 | 45 | 47 | 50..=58 => Format::Time,
            46 => Format::Duration,
            _ => Format::Number,
        }
    }

    /// A format as it is written, `dd.mm.yyyy` or `[h]:mm`, of which the part for positive numbers counts; what stands in
    /// quotes or behind a sign that quotes the next is shown as it is. ECMA-376, part 1, section 18.8.31.
    pub fn written(code: &str) -> Self {
        let mut signs = code.chars();
        while let Some(sign) = signs.next() {
            match sign.to_ascii_lowercase() {
                ';' => break,
                '\\' | '_' | '*' => drop(signs.next()),
                '"' => drop(signs.find(|sign| *sign == '"')),
                '[' => {
                    let inner: Vec<char> = signs.by_ref().take_while(|sign| *sign != ']').collect();
                    let all = |unit: &[char]| inner.iter().all(|sign| unit.contains(sign));
                    if !inner.is_empty()
                        && [['h', 'H'], ['m', 'M'], ['s', 'S']].iter().any(|unit| all(unit))
                    {
                        return Format::Duration;
                    }
                }
                'd' | 'm' | 'h' | 'y' | 's' => return Format::Time,
                _ => {}
            }
        }
        Format::Number
    }

    /// A number that is shown so.
    pub fn of(self, number: f64) -> Value<'static> {
        match self {
            Format::Number => Value::Number(number),
            _ => Value::Time { days: number, duration: self == Format::Duration },
        }
    }
}

/// All formats of a workbook by their number.
#[derive(Debug)]
pub(super) struct Formats(Vec<Format>);

impl Formats {
    pub fn new() -> Self {
        Formats((0..=u16::MAX.into()).map(Format::built_in).collect())
    }

    /// Takes one that is written in the workbook.
    pub fn set(&mut self, id: u16, format: Format) {
        self.0[usize::from(id)] = format;
    }

    pub fn get(&self, id: u16) -> Format {
        self.0[usize::from(id)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_that_show_times() {
        for code in [
            "dd.mm.yyyy",
            "H:MM:SS;@",
            "hh:mm AM/PM",
            "[$-407]d. mmm",
            "\"Y: \"m",
            "*-yyyy",
            "[Red]s.000",
        ] {
            assert_eq!(Format::written(code), Format::Time, "{code}");
        }
        for code in ["[h]:mm:ss", "[ss]", "[Blue]\\+[h]:mm;[Red]0", "[>=100][S].00"] {
            assert_eq!(Format::written(code), Format::Duration, "{code}");
        }
        for code in [
            "General",
            "0.00E+00",
            "0.0\" ms\"",
            "#,##0\\ \\s",
            "0_d",
            "0*y",
            "[Magenta]0",
            "[$m-407]0",
            "0;[h]",
            "",
        ] {
            assert_eq!(Format::written(code), Format::Number, "{code}");
        }
        assert_eq!(
            [0, 14, 22, 46, 47, 49].map(Format::built_in).map(|it| it as u8),
            [0, 1, 1, 2, 1, 0]
        );
    }
}
