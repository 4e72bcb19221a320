"""Millions of swings under weak Newton friction without Stokes friction.

One swing in scaled form: from u > 0 at rest to -B(u) after the time T(u)/omega0. With
q = 1 - e^(-u) the swing is conservative, q'^2/2 + V(q) = const, V = (1 - e^(-2u)(1 + 2u))/4;
with X = sign(u) sqrt(2 V) the reversals lie at X and -X, and T is the integral of dq/dX over
X sin(theta). All coefficients are rational (T: times pi).
"""

from fractions import Fraction

import gmpy2

from .exact import real

TERMS = 20


def multiply(a, b):
    result = [Fraction(0)] * TERMS
    for i, p in enumerate(a):
        if p:
            for j, q in enumerate(b[:TERMS - i]):
                result[i + j] += p * q
    return result


def compose(outer, inner):
    """outer(inner(z)); inner has no constant term."""
    result = [Fraction(0)] * TERMS
    for c in reversed(outer):
        result = multiply(result, inner)
        result[0] += c
    return result


def square_root(a):
    """Square root of a series that starts with 1."""
    root = [Fraction(1)] + [Fraction(0)] * (TERMS - 1)
    for n in range(1, TERMS):
        root[n] = (a[n] - sum(root[i] * root[n - i] for i in range(1, n))) / 2
    return root


def inverse(a):
    """The series b with a(b(z)) = z; a starts with z."""
    result = [Fraction(0), Fraction(1)] + [Fraction(0)] * (TERMS - 2)
    for n in range(2, TERMS):
        result[n] -= compose(a, result)[n]
    return result


def swing_series():
    """Coefficients of B(u) and of T(u)/pi."""
    factorial = [Fraction(1)]
    for n in range(1, TERMS + 3):
        factorial.append(factorial[-1] * n)
    e = [Fraction((-2) ** n) / factorial[n] for n in range(TERMS + 2)]
    energy = [Fraction(0)] * (TERMS + 2)  # 2 V = (1 - e^(-2u)(1 + 2u)) / 2 = u^2 - ...
    for n in range(1, TERMS + 2):
        energy[n] = -(e[n] + 2 * e[n - 1]) / 2
    x_of_u = [Fraction(0)] + square_root(energy[2:])[:TERMS - 1]
    u_of_x = inverse(x_of_u)
    b = [-c for c in compose(u_of_x, [-c for c in x_of_u])]
    q_of_u = [Fraction(0)] + [-Fraction((-1) ** n) / factorial[n] for n in range(1, TERMS)]
    q_of_x = compose(q_of_u, u_of_x)
    duration = [Fraction(0)] * TERMS  # mean of sin^n over half a turn times n-th coefficient of dq/dX
    mean = Fraction(1)
    for n in range(0, TERMS - 1, 2):
        duration[n] = (n + 1) * q_of_x[n + 1] * mean
        mean = mean * (n + 1) / (n + 2)
    return b, compose(duration, x_of_u)


def evaluate(coefficients, u):
    value = coefficients[-1]
    for c in coefficients[-2::-1]:
        value = value * u + c
    return value


def iterate(u, offset, wanted, terms):
    """{n: (u_n, sum of T/pi, scaled path)} for the wanted n, by carrying out the swings one by one.

    u is measured from the swing's centre: u' = B(u) - 2 offset (offset scaled by kappa)."""
    b, t = ([real(c) for c in series[:terms]] for series in swing_series())
    total, path, found, wanted, twice = real(0), real(0), {}, set(wanted), 2 * offset
    for n in range(max(wanted) + 1):
        if n in wanted:
            found[n] = (u, total, path)
        total += evaluate(t, u)
        far = evaluate(b, u)
        path += u + far
        u = far - twice
    return found


def count_to_rest(u, offset, band):
    """Number of swings until u + offset <= band, in ordinary floating point (checked afterwards)."""
    n = 0
    while u + offset > band:
        u += u * u * (-4 / 3 + u * (16 / 9 - u * 352 / 135)) - 2 * offset
        n += 1
    return n


class Abel:
    """n swings at once for pure Newton friction: A(B(u)) = A(u) + 1 with
    A = alpha/u + beta ln u + a power series, and D(B(u)) = D(u) + T(u)/pi - 1."""

    def __init__(self):
        b, t = swing_series()
        ratio = b[1:] + [Fraction(0)]
        self.alpha = -1 / b[2]
        powers = [[Fraction(1)] + [Fraction(0)] * (TERMS - 1)]
        for _ in range(TERMS):
            powers.append(multiply(powers[-1], b))
        self.a, self.beta = self._solve_abel(b, ratio, powers)
        t[0] -= 1
        self.d = self._difference(t, b, powers)

    @staticmethod
    def _difference(target, b, powers):
        """The power series D with D(B(u)) - D(u) = target(u), target = O(u^2)."""
        target, d = list(target), [Fraction(0)] * TERMS
        for k in range(1, TERMS - 2):
            d[k] = target[k + 1] / (k * b[2])
            for n in range(k + 1, TERMS):
                target[n] -= d[k] * powers[k][n]
        return d

    def _solve_abel(self, b, ratio, powers):
        reciprocal = [Fraction(1)] + [Fraction(0)] * (TERMS - 1)
        for n in range(1, TERMS):
            reciprocal[n] = -sum(ratio[i] * reciprocal[n - i] for i in range(1, n + 1))
        # alpha (1/B - 1/u): shift by one power; reliable up to TERMS - 3.
        target = [-self.alpha * c for c in reciprocal[1:]] + [Fraction(0)]
        target[0] += 1
        logarithm = self._logarithm(ratio)
        beta = target[1] / logarithm[1]
        target = [p - beta * q for p, q in zip(target, logarithm)]
        return self._difference(target, b, powers), beta

    @staticmethod
    def _logarithm(ratio):
        log = [Fraction(0)] * TERMS
        for n in range(1, TERMS):
            log[n] = ratio[n] - sum((k * log[k] * ratio[n - k] for k in range(1, n)), Fraction(0)) / n
        return log

    def _function(self, u):
        return (real(self.alpha) / u + real(self.beta) * gmpy2.log(u)
                + evaluate([real(c) for c in self.a[:TERMS - 4]], u))

    def after(self, u0, n):
        """(u_n, sum of T/pi over n swings)."""
        target = self._function(u0) + n
        u = u0 / (1 + n * u0 / real(self.alpha))
        for _ in range(60):
            u += (self._function(u) - target) * u * u / real(self.alpha)
        d = [real(c) for c in self.d[:TERMS - 4]]
        return u, n + evaluate(d, u) - evaluate(d, u0), real(0)
