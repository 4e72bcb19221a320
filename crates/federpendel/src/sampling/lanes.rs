//! Elementary functions on several numbers at once, as plain loops that the compiler turns into
//! vector instructions where [`pulp`] has found them at run time.

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

/// The polynomial Σ cₖ xᵏ, lowest coefficient first.
#[inline(always)]
pub(crate) fn polynomial<const FUSED: bool>(coefficients: &[f64], x: &Lanes) -> Lanes {
    let (last, rest) = coefficients.split_last().unwrap_or((&0.0, &[]));
    let mut sum = [*last; LANES];
    for c in rest.iter().rev() {
        for i in 0..LANES {
            sum[i] = mul_add::<FUSED>(sum[i], x[i], *c);
        }
    }
    sum
}

/// Two polynomials with the first `TERMS` of these coefficients at once.
#[inline(always)]
pub(crate) fn two_polynomials<const FUSED: bool, const TERMS: usize>(
    first: &[f64],
    second: &[f64],
    x: &Lanes,
) -> (Lanes, Lanes) {
    let (mut a, mut b) = ([0.0; LANES], [0.0; LANES]);
    for n in (0..TERMS).rev() {
        for i in 0..LANES {
            a[i] = mul_add::<FUSED>(a[i], x[i], first[n]);
            b[i] = mul_add::<FUSED>(b[i], x[i], second[n]);
        }
    }
    (a, b)
}

/// sin x and cos x for |x| ≤ π/2 by their Taylor series, which end below rounding there.
#[inline(always)]
pub(crate) fn sin_cos<const FUSED: bool>(x: &Lanes) -> (Lanes, Lanes) {
    let square: Lanes = each(|i| x[i] * x[i]);
    let tail = polynomial::<FUSED>(&SIN, &square);
    let cos = polynomial::<FUSED>(&COS, &square);
    let sin = each(|i| mul_add::<FUSED>(x[i] * square[i], tail[i], x[i]));
    (sin, cos)
}

/// e^x for |x| < 700.
#[inline(always)]
pub(crate) fn exp<const FUSED: bool>(x: &Lanes) -> Lanes {
    // Adding 1.5·2⁵² rounds to an integer and leaves it in the low bits.
    const ROUND: f64 = 6_755_399_441_055_744.0;
    const LN_2_HIGH: f64 = 6.931_471_803_691_238e-1;
    const LN_2_LOW: f64 = 1.908_214_929_270_587_7e-10;
    let shifted: Lanes = each(|i| mul_add::<FUSED>(x[i], std::f64::consts::LOG2_E, ROUND));
    let power: Lanes = each(|i| shifted[i] - ROUND);
    let r: Lanes = each(|i| {
        let r = mul_add::<FUSED>(power[i], -LN_2_HIGH, x[i]);
        mul_add::<FUSED>(power[i], -LN_2_LOW, r)
    });
    let series = polynomial::<FUSED>(&EXP, &r);
    each(|i| {
        let scale = (shifted[i].to_bits() << 52).wrapping_add(1.0f64.to_bits());
        series[i] * f64::from_bits(scale)
    })
}

/// Σ (−1)ᵏ x²ᵏ/(2k + 3)!, times −1: what follows x in the sine, over x³.
const SIN: [f64; 11] = factorials(3, 2, -1.0);
/// Σ (−1)ᵏ x²ᵏ/(2k)!.
const COS: [f64; 13] = factorials(0, 2, 1.0);
/// Σ xᵏ/k!.
const EXP: [f64; 14] = factorials(0, 1, 1.0);

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

    /// Against the system's library, both with and without fused operations.
    #[test]
    fn functions_agree_with_the_library() {
        let check = |x: f64| {
            let lanes = [x; LANES];
            for (sin, cos) in [sin_cos::<true>(&lanes), sin_cos::<false>(&lanes)] {
                assert!((sin[0] - x.sin()).abs() <= 2.3e-16, "{x} {} {}", sin[0], x.sin());
                assert!((cos[0] - x.cos()).abs() <= 2.3e-16, "{x} {} {}", cos[0], x.cos());
            }
            let x = x * 20.0;
            for e in [exp::<true>(&[x; LANES]), exp::<false>(&[x; LANES])] {
                assert!((e[0] / x.exp() - 1.0).abs() <= 4.5e-16, "{x} {} {}", e[0], x.exp());
            }
        };
        (-1570..=1570).for_each(|i| check(f64::from(i) * 1e-3));
    }

    #[test]
    fn products_lose_nothing() {
        for (a, b) in [(0.1, 0.3), (1e10 / 3.0, 1.0 / 7.0), (6.324555320336759, 19.998)] {
            let product = a * b;
            assert_eq!(product_error::<true>(a, b, product), product_error::<false>(a, b, product));
        }
    }
}
