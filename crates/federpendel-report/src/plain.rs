//! Texts with formulas as plain text, for terminals and files: `$\omega_0$` as ω₀.

/// What the commands of TeX in the catalogue look like, a longer one before one that it begins with.
const SIGNS: [(&str, &str); 30] = [
    (r"\ddot x", "ẍ"),
    (r"\dot x", "ẋ"),
    (r"\tilde C", "C̃"),
    (r"\arctan", "arctan"),
    (r"\operatorname", ""),
    (r"\varphi", "φ"),
    (r"\lambda", "λ"),
    (r"\omega", "ω"),
    (r"\gamma", "γ"),
    (r"\kappa", "κ"),
    (r"\Delta", "Δ"),
    (r"\infty", "∞"),
    (r"\times", "×"),
    (r"\sqrt", "√"),
    (r"\cdot", "·"),
    (r"\sin", "sin"),
    (r"\cos", "cos"),
    (r"\tan", "tan"),
    (r"\rho", "ρ"),
    (r"\mu", "μ"),
    (r"\pi", "π"),
    (r"\pm", "±"),
    (r"\ll", "≪"),
    (r"\le", "≤"),
    (r"\ge", "≥"),
    (r"\ne", "≠"),
    (r"\to", "→"),
    (r"\,", " "),
    (r"\ ", " "),
    (r"'", "′"),
];

/// Signs that can be lowered; others keep their underscore.
const LOWERED: [(char, char); 13] = [
    ('0', '₀'),
    ('1', '₁'),
    ('2', '₂'),
    ('3', '₃'),
    ('4', '₄'),
    ('i', 'ᵢ'),
    ('n', 'ₙ'),
    ('s', 'ₛ'),
    ('a', 'ₐ'),
    ('e', 'ₑ'),
    ('k', 'ₖ'),
    ('p', 'ₚ'),
    ('x', 'ₓ'),
];

/// `text` with its formulas in signs.
pub fn text(text: &str) -> String {
    let pieces = text.split('$').enumerate();
    pieces
        .map(|(place, piece)| if place % 2 == 0 { piece.to_owned() } else { formula(piece) })
        .collect()
}

fn formula(tex: &str) -> String {
    let mut plain =
        SIGNS.iter().fold(tex.to_owned(), |plain, (command, sign)| plain.replace(command, sign));
    for (sign, lowered) in LOWERED {
        plain = plain.replace(&format!("_{sign}"), &lowered.to_string());
    }
    plain.replace('-', "−").replace("^2", "²").replace(['{', '}'], "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_become_signs() {
        assert_eq!(
            text(r"the offset $f$, $|x_0| - v_A t$ and $\omega_0$"),
            "the offset f, |x₀| − v_A t and ω₀"
        );
        assert_eq!(text(r"$\ddot x = -\omega_0^2 x$"), "ẍ = −ω₀² x");
    }
}
