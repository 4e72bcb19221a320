//! Lines that fit.

use console::measure_text_width;

/// Longest word that may be a unit, with the comma or bracket behind it.
const UNIT: usize = 6;

/// `text` in lines of at most `columns`, where its words allow; a number and its unit stay together.
pub(crate) fn wrap(text: &str, columns: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    let mut width = 0;
    for word in words(text) {
        let length = measure_text_width(&word);
        if width > 0 && width + 1 + length > columns {
            lines.push(String::new());
            width = 0;
        }
        if let Some(line) = lines.last_mut() {
            if width > 0 {
                line.push(' ');
                width += 1;
            }
            line.push_str(&word);
        }
        width += length;
    }
    lines
}

/// The words of `text`, a number with the unit behind it as one.
fn words(text: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut number = false;
    for word in text.split(' ') {
        match words.last_mut().filter(|_| number && measure_text_width(word) <= UNIT) {
            Some(last) => *last = format!("{last} {word}"),
            None => words.push(word.to_owned()),
        }
        number = word.ends_with(|sign: char| sign.is_ascii_digit() || "⁰¹²³⁴⁵⁶⁷⁸⁹".contains(sign));
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_full_and_numbers_keep_their_units() {
        let text = "am Ende 36,1 µJ (exakte Bewegung), 34,63 µJ";
        assert_eq!(wrap(text, 13), ["am Ende", "36,1 µJ", "(exakte", "Bewegung),", "34,63 µJ"]);
        assert_eq!(wrap(text, 100), [text]);
        for columns in 1..60 {
            assert_eq!(wrap(text, columns).join(" "), text);
        }
        assert_eq!(wrap("", 10), [""]);
    }
}
