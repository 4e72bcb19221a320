//! Elementary functions on several numbers at once, as plain loops that the compiler turns into
//! vector instructions where [`pulp`] has found them at run time.

use crate::double::PI;

/// Numbers worked on together: one register of the widest machines, several of others.
pub(crate) const LANES: usize = 8;

/// Numbers worked on together.
pub(crate) type Lanes = [f64; LANES];

/// The numbers that `value` gives for 0, 1, …; unlike `array::from_fn` always inlined, without which
/// the body would be compiled for the oldest machine.
#[inline(always)]
pub(crate) fn each(value: impl Fn(usize) -> f64) -> Lanes {
    let mut lanes = [0.0; LANES];
    for (i, lane) in lanes.iter_mut().enumerate() {
        *lane = value(i);
    }
    lanes
}

/// a·b + c, with one rounding where the machine does that in one instruction.
#[inline(always)]
pub(crate) fn mul_add<const FUSED: bool>(a: f64, b: f64, c: f64) -> f64 {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}

/// The exact error of the product `a`·`b` = `product` + error.
#[inline(always)]
pub(crate) fn product_error<const FUSED: bool>(a: f64, b: f64, product: f64) -> f64 {
    if FUSED {
        return a.mul_add(b, -product);
    }
    // Dekker's product of numbers split by Veltkamp; a fused operation in software would cost more.
    let split = |x: f64| {
        let high = x * 134_217_729.0;
        let high = high - (high - x);
        (high, x - high)
    };
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    ((ah * bh - product) + ah * bl + al * bh) + al * bl
}

/// The exact remainder of the rounded `quotient` = (`product` − remainder)/`divisor`.
#[inline(always)]
pub(crate) fn quotient_error<const FUSED: bool>(quotient: f64, divisor: f64, product: f64) -> f64 {
    if FUSED {
        return quotient.mul_add(-divisor, product);
    }
    let back = quotient * divisor;
    (product - back) - product_error::<FUSED>(quotient, divisor, back)
}

/// The polynomial Σ cₖ xᵏ, lowest coefficient first, as even part plus x times odd part: in each of the
/// two every product waits for the one before, but neither waits for the other.
#[inline(always)]
pub(crate) fn polynomial<const FUSED: bool, const TERMS: usize>(
    coefficients: &[f64; TERMS],
    x: &Lanes,
) -> Lanes {
    let square: Lanes = each(|i| x[i] * x[i]);
    let (pairs, single) = coefficients.as_chunks::<2>();
    let Some(([c, d], lower)) = pairs.split_last() else {
        return [single.first().copied().unwrap_or(0.0); LANES];
    };
    // The highest coefficients stand as they are: a sum that began with zero would multiply it.
    let mut even = match single {
        [highest] => each(|i| mul_add::<FUSED>(*highest, square[i], *c)),
        _ => [*c; LANES],
    };
    let mut odd = [*d; LANES];
    for [c, d] in lower.iter().rev() {
        for i in 0..LANES {
            even[i] = mul_add::<FUSED>(even[i], square[i], *c);
            odd[i] = mul_add::<FUSED>(odd[i], square[i], *d);
        }
    }
    each(|i| mul_add::<FUSED>(x[i], odd[i], even[i]))
}

/// sin x and cos x for |x| ≤ π/2 by their Taylor series, which end below rounding there.
#[inline(always)]
pub(crate) fn sin_cos<const FUSED: bool>(x: &Lanes) -> (Lanes, Lanes) {
    let square: Lanes = each(|i| x[i] * x[i]);
    let (sin, cos) = (polynomial::<FUSED, _>(&SIN, &square), polynomial::<FUSED, _>(&COS, &square));
    // The leading terms come last, so that only their rounding is left.
    let sin = each(|i| mul_add::<FUSED>(x[i] * square[i], sin[i], x[i]));
    let cos = each(|i| {
        let rest = mul_add::<FUSED>(square[i], cos[i], -0.5);
        mul_add::<FUSED>(square[i], rest, 1.0)
    });
    (sin, cos)
}

/// sin and cos of n (`phase`.0 + `phase`.1) for integers n, to rounding however many turns that is below 2⁵⁰: the
/// angle is reduced to |φ| ≤ π/2 in doubled precision.
#[inline(always)]
pub(crate) fn sin_cos_of_multiples<const FUSED: bool>(
    phase: (f64, f64),
    n: &Lanes,
) -> (Lanes, Lanes) {
    let product = each(|i| phase.0 * n[i]);
    let low = each(|i| {
        mul_add::<FUSED>(phase.1, n[i], product_error::<FUSED>(phase.0, n[i], product[i]))
    });
    let half_turns = each(|i| nearest(product[i] * std::f64::consts::FRAC_1_PI));
    let rest = each(|i| {
        let turned = half_turns[i] * PI.hi();
        let turned_low = product_error::<FUSED>(half_turns[i], PI.hi(), turned);
        let turned_low = mul_add::<FUSED>(half_turns[i], PI.lo(), turned_low);
        (product[i] - turned) + (low[i] - turned_low)
    });
    let (sin, cos) = sin_cos::<FUSED>(&rest);
    let sign = each(|i| {
        let odd = half_turns[i] - 2.0 * nearest(0.5 * half_turns[i]);
        1.0 - 2.0 * odd * odd
    });
    (each(|i| sign[i] * sin[i]), each(|i| sign[i] * cos[i]))
}

/// The nearest integer for |x| < 2⁵¹. Beside so large a number a sum has no digits after the point; the rounding of
/// the library would be a call for each number.
#[inline(always)]
fn nearest(x: f64) -> f64 {
    const LARGE: f64 = 1.5 * (1_u64 << 52) as f64;
    (x + LARGE) - LARGE
}

/// e^x by `TERMS` terms of its series: with [`FEW_TERMS`] for |x| ≤ [`FEW_TERMS_REACH`], with all of them for
/// |x| ≤ 1.3. Unlike the usual reduction by powers of two, that is nothing but products and sums, which
/// the compiler turns into vector instructions reliably.
#[inline(always)]
pub(crate) fn exp<const FUSED: bool, const TERMS: usize>(x: &Lanes) -> Lanes {
    let tail = polynomial::<FUSED, TERMS>(const { &factorials::<TERMS>(1, 1, 1.0) }, x);
    each(|i| mul_add::<FUSED>(x[i], tail[i], 1.0))
}

/// Terms of [`exp`] beyond 1 for small numbers.
pub(crate) const FEW_TERMS: usize = 10;
/// Up to here they are enough.
pub(crate) const FEW_TERMS_REACH: f64 = 0.1;
/// Terms of [`exp`] beyond 1 for all numbers up to 1.3.
pub(crate) const ALL_TERMS: usize = 22;

/// What follows x in the series of the sine, over x³.
const SIN: [f64; 11] = factorials(3, 2, -1.0);
/// What follows 1 − x²/2 in the series of the cosine, over x⁴.
const COS: [f64; 11] = factorials(4, 2, 1.0);

/// ±1/n! for n = `first`, `first` + `step`, …; with `step` 2 the signs alternate.
const fn factorials<const N: usize>(first: usize, step: usize, sign: f64) -> [f64; N] {
    let mut table = [0.0; N];
    let (mut k, mut sign) = (0, sign);
    while k < N {
        let (mut n, mut factorial) = (1, 1.0);
        while n <= first + k * step {
            factorial *= n as f64;
            n += 1;
        }
        table[k] = sign / factorial;
        sign *= if step == 2 { -1.0 } else { 1.0 };
        k += 1;
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::double::Double;

    /// Against the system's library, both with and without fused operations.
    #[test]
    fn functions_agree_with_the_library() {
        let check_at = |x: f64| {
            let lanes = [x; LANES];
            for (sin, cos) in [sin_cos::<true>(&lanes), sin_cos::<false>(&lanes)] {
                assert!((sin[0] - x.sin()).abs() <= 2.3e-16, "{x} {} {}", sin[0], x.sin());
                assert!((cos[0] - x.cos()).abs() <= 2.3e-16, "{x} {} {}", cos[0], x.cos());
            }
            let check = |x: f64, e: Lanes, within: f64| {
                assert!((e[0] - x.exp()).abs() <= within, "{x} {} {}", e[0], x.exp());
            };
            let (few, all) = (x / 1.57 * FEW_TERMS_REACH, x / 1.57 * 1.3);
            check(few, exp::<true, FEW_TERMS>(&[few; LANES]), 2.3e-16);
            check(few, exp::<false, FEW_TERMS>(&[few; LANES]), 2.3e-16);
            check(all, exp::<true, ALL_TERMS>(&[all; LANES]), 4.5e-16 * all.exp().max(1.0));
            check(all, exp::<false, ALL_TERMS>(&[all; LANES]), 4.5e-16 * all.exp().max(1.0));
        };
        (-1570..=1570).for_each(|i| check_at(f64::from(i) * 1e-3));
    }

    /// Against the library at a phase reduced in doubled precision.
    #[test]
    fn multiples_of_a_phase_keep_their_digits() {
        let phase = Double::from(0.7) / 3.0;
        for n in [0.0, 1.0, 6.0, 7.0, 13.0, 14.0, 41.0, 1e4 + 1.0, 1e7 + 3.0, 1e9 + 7.0] {
            let turns = (phase * n / (2.0 * PI)).hi().floor();
            let rest = (phase * n - 2.0 * PI * turns).hi();
            let parts = (phase.hi(), phase.lo());
            let (lanes, expected) = ([n; LANES], (rest.sin(), rest.cos()));
            for (sin, cos) in [
                sin_cos_of_multiples::<true>(parts, &lanes),
                sin_cos_of_multiples::<false>(parts, &lanes),
            ] {
                assert!((sin[0] - expected.0).abs() <= 7e-16, "{n} {} {}", sin[0], expected.0);
                assert!((cos[0] - expected.1).abs() <= 7e-16, "{n} {} {}", cos[0], expected.1);
            }
        }
    }

    #[test]
    fn products_lose_nothing() {
        for (a, b) in [(0.1, 0.3), (1e10 / 3.0, 1.0 / 7.0), (6.324555320336759, 19.998)] {
            let product = a * b;
            assert_eq!(product_error::<true>(a, b, product), product_error::<false>(a, b, product));
        }
    }
}
