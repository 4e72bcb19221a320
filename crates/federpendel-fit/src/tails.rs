//! The tails of χ².

/// The probability that χ² with one, two or three degrees of freedom exceeds `x`.
pub fn tails(x: f64) -> [f64; 3] {
    if x == f64::INFINITY {
        return [0.0; 3];
    }
    let one = erfc((x / 2.0).sqrt());
    let two = (-x / 2.0).exp();
    [one, two, one + (2.0 * x / std::f64::consts::PI).sqrt() * two]
}

/// The complementary error function for x ≥ 0, to 1.2e-7 of itself (Press et al., Numerical
/// Recipes, 6.2).
fn erfc(x: f64) -> f64 {
    const C: [f64; 10] = [
        -1.26551223,
        1.00002368,
        0.37409196,
        0.09678418,
        -0.18628806,
        0.27886807,
        -1.13520398,
        1.48851587,
        -0.82215223,
        0.17087277,
    ];
    let t = 1.0 / (1.0 + 0.5 * x);
    t * (-x * x + C.iter().rev().fold(0.0, |sum, c| sum * t + c)).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tails_are_those_of_tables() {
        // Abramowitz & Stegun, table 26.8: 5 % and 1 % points.
        for (x, i, p) in
            [(3.84146, 0, 0.05), (6.63490, 0, 0.01), (9.21034, 1, 0.01), (11.3449, 2, 0.01)]
        {
            assert!((tails(x)[i] / p - 1.0).abs() < 1e-4, "{x} {:?}", tails(x));
        }
    }
}
