//! Labels of a drawing, with symbols as they are printed.

use super::pen::escape;

/// How a part of a label is set.
#[derive(Clone, Copy, PartialEq)]
enum Face {
    Upright,
    Slanted,
    Index,
}

/// How far an index is lowered, over the size of the label, and how large it is.
const INDEX: (f64, f64) = (0.2, 0.7);

/// The content of an SVG `text`: between dollar signs letters are slanted, and what follows a `_` is an index.
pub fn set(label: &str) -> String {
    let mut set = String::new();
    let mut before = Face::Upright;
    for (face, run) in runs(label) {
        let (lowered, size) = INDEX;
        let style = match (before, face) {
            (_, Face::Index) => format!(" dy=\"{:.3}em\" font-size=\"{size}em\"", lowered / size),
            (Face::Index, _) => format!(" dy=\"-{lowered}em\""),
            _ => String::new(),
        };
        let slant = if face == Face::Slanted { " font-style=\"italic\"" } else { "" };
        set += &format!("<tspan{style}{slant}>{}</tspan>", escape(&run));
        before = face;
    }
    set
}

/// The label in pieces of one face.
fn runs(label: &str) -> Vec<(Face, String)> {
    let mut runs: Vec<(Face, String)> = Vec::new();
    let (mut symbols, mut index) = (false, false);
    for sign in label.chars() {
        match sign {
            '$' => symbols = !symbols,
            '_' if symbols => index = true,
            _ => {
                index &= sign.is_ascii_alphanumeric();
                let face = match sign {
                    _ if index => Face::Index,
                    _ if symbols && sign.is_alphabetic() => Face::Slanted,
                    _ => Face::Upright,
                };
                match runs.last_mut() {
                    Some((last, run)) if *last == face => run.push(sign),
                    _ => runs.push((face, sign.to_string())),
                }
            }
        }
        index &= symbols;
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_slant_and_indices_sink_and_end() {
        use Face::{Index, Slanted, Upright};
        let faces: Vec<_> = runs("½$C x_0$² = 2 m").into_iter().collect();
        let expected = [
            (Upright, "½"),
            (Slanted, "C"),
            (Upright, " "),
            (Slanted, "x"),
            (Index, "0"),
            (Upright, "² = 2 m"),
        ];
        let expected: Vec<_> = expected.map(|(face, run)| (face, run.to_owned())).into();
        assert!(faces == expected);
        assert!(set("$F_R$ < 1").ends_with("<tspan dy=\"-0.2em\"> &lt; 1</tspan>"));
    }
}
