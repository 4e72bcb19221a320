//! Numbers that are easy to say and to set, evenly spread in the logarithm.

/// How many there are in a decade: one is about a tenth larger than the one before it, as in the series E24 of IEC 60063.
const PER_DECADE: f64 = 24.0;

/// From `low` to `high`, both above zero and `low` below `high`: these two, and between them numbers with two
/// significant digits.
pub fn steps(low: f64, high: f64) -> Vec<f64> {
    let place = |x: f64| PER_DECADE * x.log10();
    let (first, last) = (place(low).floor() as i64, place(high).ceil() as i64);
    let between = (first..=last).map(|i| two_digits(10f64.powf(i as f64 / PER_DECADE)));
    let mut steps = vec![low];
    steps.extend(between.filter(|&x| x > low && x < high));
    steps.push(high);
    steps
}

/// The number with two significant digits next to this one.
fn two_digits(x: f64) -> f64 {
    format!("{x:.1e}").parse().unwrap_or(x)
}

/// The first number with two significant digits that is not below this one, which is above zero.
pub fn rounded_up(x: f64) -> f64 {
    let near = two_digits(x);
    let unit = 10f64.powi(x.log10().floor() as i32 - 1);
    if near < x { two_digits(near + unit) } else { near }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_even_and_short() {
        let steps = steps(0.0123, 0.4);
        assert_eq!((steps[0], steps[steps.len() - 1]), (0.0123, 0.4));
        assert!(steps.windows(2).all(|pair| pair[1] > pair[0] && pair[1] < 1.17 * pair[0]));
        for step in &steps[1..] {
            assert!(step.to_string().trim_start_matches(['0', '.']).len() <= 2, "{step}");
        }
    }

    #[test]
    fn rounding_up_never_falls_below() {
        for (x, up) in [(0.0123, 0.013), (0.012, 0.012), (9.94, 10.0), (81.0, 81.0), (372.5, 380.0)]
        {
            assert_eq!(rounded_up(x), up);
        }
    }
}
