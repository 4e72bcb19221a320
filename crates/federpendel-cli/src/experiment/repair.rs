//! The user's own line as TOML would have it, for messages about a line that is not TOML.

use toml::de::DeTable;

use super::Syntax;

/// Longest line that is shown repaired, characters: a message is to stay one line.
const LONGEST: usize = 60;

/// Quotes that word processors and telephones set and TOML does not know.
const TYPOGRAPHIC: [char; 10] = ['„', '“', '”', '‟', '»', '«', '‚', '‘', '’', '″'];

/// `line` with straight quotes, if its typographic ones are all that is wrong with it.
pub(super) fn straightened(line: &str) -> Option<String> {
    let straight = line.trim().replace(TYPOGRAPHIC, "\"");
    (straight != line.trim() && is_toml(&straight)).then_some(straight)
}

/// `line` without the slip that `problem` names, if it is TOML then.
pub(super) fn repaired(line: &str, problem: &Syntax) -> Option<String> {
    let line = line.trim();
    let fits = |candidate: &String| candidate.chars().count() <= LONGEST && is_toml(candidate);
    candidates(line, problem).into_iter().flatten().find(fits)
}

/// What may have been meant, the likeliest first.
fn candidates(line: &str, problem: &Syntax) -> Vec<Option<String>> {
    let quoted = |separator| {
        let (key, value) = line.split_once(separator)?;
        let value = value.trim().trim_matches(['"', '\'']);
        Some(format!("{} = \"{value}\"", key.trim()))
    };
    match problem {
        Syntax::UnclosedSection => vec![Some(format!("{}]", line.trim_end_matches(']')))],
        Syntax::UnclosedTable => vec![Some(format!("{line} }}")), Some(format!("{line}\" }}"))],
        Syntax::BadText => vec![Some(format!("{line}\"")), quoted("=")],
        Syntax::UnquotedText | Syntax::BadNumber => vec![quoted("=")],
        Syntax::NoEquals => vec![
            Some(line.replacen(':', " =", 1)).filter(|_| line.contains(':')),
            Some(line.replacen(' ', " = ", 1)).filter(|_| line.contains(' ')),
            quoted(":"),
            quoted(" "),
            Some(format!("{line} = 0.5")),
        ],
        Syntax::NoValue => vec![Some(format!("{line} 0.5"))],
        Syntax::Comma => vec![Some(line.replace(",,", ",")), Some(line.replace(", ,", ","))],
        _ => Vec::new(),
    }
}

fn is_toml(line: &str) -> bool {
    DeTable::parse(line).is_ok()
}

#[cfg(test)]
mod tests {
    use super::super::{Error, parse};

    #[test]
    fn the_example_is_made_of_the_line_itself() {
        for (file, example) in [
            ("[oscillator]\nmass = „250 g“\nstiffness = 1", Some("mass = \"250 g\"")),
            ("coulomb = { kinetic = “3 %” }", Some("coulomb = { kinetic = \"3 %\" }")),
            ("[release\nposition = 1", Some("[release]")),
            ("velocity = \"3 m/s", Some("velocity = \"3 m/s\"")),
            ("velocity: 3", Some("velocity = 3")),
            ("velocity \"3 m/s\"", Some("velocity = \"3 m/s\"")),
            ("velocity: 3 m/s", Some("velocity = \"3 m/s\"")),
            ("area = abc", Some("area = \"abc\"")),
            ("stokes = { damping = 3", Some("stokes = { damping = 3 }")),
            ("a = { b = 1,, c = 2 }", Some("a = { b = 1, c = 2 }")),
            ("stiffness =", Some("stiffness = 0.5")),
            ("[a] b = 1", None),
            ("= 3", None),
        ] {
            let Err(Error::Syntax { example: found, .. }) = parse(file.as_bytes()) else {
                panic!("{file}")
            };
            assert_eq!(found.as_deref(), example, "{file}");
        }
    }
}
