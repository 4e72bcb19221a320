//! Texts with formulas as plain text, for terminals and files: `$\omega_0$` as ω₀.

/// What the commands of TeX in the catalogue look like, a longer one before one that it begins with.
const SIGNS: [(&str, &str); 32] = [
    (r"\ddot x", "ẍ"),
    (r"\dot x", "ẋ"),
    (r"\tilde C", "C̃"),
    (r"\arctan", "arctan"),
    (r"\operatorname", ""),
    (r"\varphi", "φ"),
    (r"\lambda", "λ"),
    (r"\omega", "ω"),
    (r"\gamma", "γ"),
    (r"\zeta", "ζ"),
    (r"\kappa", "κ"),
    (r"\Delta ", "Δ"),
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

/// Stands for a dollar sign that is none of a formula; no text holds it.
const DOLLAR: &str = "\u{0}";

/// `text` with its formulas in signs.
pub fn text(text: &str) -> String {
    let text = text.replace(r"\$", DOLLAR);
    let pieces = text.split('$').enumerate();
    let plain: String = pieces
        .map(|(place, piece)| if place % 2 == 0 { piece.to_owned() } else { formula(piece) })
        .collect();
    plain.replace(DOLLAR, "$")
}

/// A formula in signs.
pub fn formula(tex: &str) -> String {
    let mut plain =
        SIGNS.iter().fold(fractions(tex), |plain, (command, sign)| plain.replace(command, sign));
    for (sign, lowered) in LOWERED {
        plain = plain.replace(&format!("_{sign}"), &lowered.to_string());
    }
    plain.replace('-', "−").replace("^2", "²").replace(['{', '}'], "")
}

/// `\frac{a}{b}` as (a/b).
fn fractions(tex: &str) -> String {
    let mut pieces = tex.split(r"\frac{");
    let before = pieces.next().unwrap_or_default().to_owned();
    pieces.fold(before, |before, piece| {
        let piece = piece.replacen("}{", "/", 1).replacen('}', ")", 1);
        format!("{before}({piece}")
    })
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
        let law = r"$\Delta A = 2f + \frac{\pi\gamma}{\omega_0} A + \frac{4}{3} \kappa A^2$";
        assert_eq!(text(law), "ΔA = 2f + (πγ/ω₀) A + (4/3) κ A²");
    }

    #[test]
    fn a_dollar_in_the_name_of_a_file_is_no_formula() {
        let name = crate::document::literal("5$-omega_0-7$.csv");
        assert_eq!(text(&format!(r"{name}: $\omega_0$")), "5$-omega_0-7$.csv: ω₀");
    }
}
