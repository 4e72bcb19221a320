"""Swings with Newton friction: Taylor series in time, by two different recurrences.

In the coordinates of `chain` one swing obeys y'' + 2 gamma y' - kappa y'^2 + omega0^2 y = 0.
"""

from bisect import bisect_right
from operator import mul

import gmpy2

from .exact import real


def square(v, n):
    """Coefficient n of the square of a series."""
    half = (n + 1) // 2
    total = 2 * sum(map(mul, v[:half], v[n:n - half:-1])) if half else real(0)
    return total if n % 2 else total + v[n // 2] * v[n // 2]


def convolution(a, b, n):
    return sum(map(mul, a[:n + 1], b[n::-1]))


def horner(coefficients, h):
    value = real(0)
    for c in reversed(coefficients):
        value = value * h + c
    return value


def integral(coefficients, h):
    """Integral of a series from 0 to h."""
    return h * horner([c / (n + 1) for n, c in enumerate(coefficients)], h)


class SeriesSwing:
    """Steps of Taylor series; a subclass supplies the coefficients of y and y'."""

    order = 90

    def __init__(self, osc, y, v):
        self.gamma, self.kappa, self.w2 = real(osc.gamma), real(osc.kappa), real(osc.omega0_squared)
        self.omega0 = gmpy2.sqrt(self.w2)
        self.may_creep = osc.gamma ** 2 >= osc.omega0_squared
        self.times, self.steps = [], []
        self.now = (real(0), y, v, real(0), real(0))
        self.duration = self.end = None
        self.creeps = False
        while self.duration is None and not self.creeps:
            self._advance()

    def _advance(self):
        t, y, v, squares, cubes = self.now
        # With gamma >= omega0 a mass slower than the line y' = -gamma y cannot cross the centre.
        self.creeps = self.creeps or bool(self.may_creep and y > 0 and -v <= self.gamma * y)
        ys, vs = self.coefficients(y, v)
        h = self._step(ys, vs)
        self.times.append(t)
        self.steps.append((ys, vs, squares, cubes))
        if not self.creeps and horner(vs, h) >= 0:
            h = self._reversal(vs, h)
            self.duration, self.end = t + h, horner(ys, h)
        self.now = (t + h, *self._evaluate(len(self.steps) - 1, h))

    def _step(self, ys, vs):
        """The largest step at which the last two terms of both series vanish in the working precision."""
        bits = gmpy2.get_context().precision
        scale = max(abs(ys[0]), abs(vs[0]) / self.omega0)
        best = None
        for series, unit in ((ys, scale), (vs, scale * self.omega0)):
            for n in (len(series) - 2, len(series) - 1):
                if series[n] != 0:
                    exponent = (gmpy2.get_exp(unit) - gmpy2.get_exp(series[n]) - bits) / n
                    best = exponent if best is None else min(best, exponent)
        return gmpy2.exp2(real(best))

    def _reversal(self, vs, h):
        low, high = real(0), h
        for _ in range(16):
            middle = (low + high) / 2
            if horner(vs, middle) < 0:
                low = middle
            else:
                high = middle
        slope = [n * c for n, c in enumerate(vs)][1:]
        t = (low + high) / 2
        for _ in range(7):
            t -= horner(vs, t) / horner(slope, t)
        return t

    def _evaluate(self, index, h):
        ys, vs, squares, cubes = self.steps[index]
        v2 = [square(vs, n) for n in range(len(vs))]
        v3 = [convolution(vs, v2, n) for n in range(len(vs))]
        return (horner(ys, h), horner(vs, h), squares + integral(v2, h), cubes - integral(v3, h))

    def state(self, t):
        while self.duration is None and t > self.now[0]:
            self._advance()
        index = bisect_right(self.times, t) - 1
        y, v, squares, cubes = self._evaluate(index, t - self.times[index])
        return y, real(0) if t == self.duration else v, squares, cubes


class TaylorSwing(SeriesSwing):
    """The equation as it stands: a Cauchy product for y'^2."""

    order = 84

    def coefficients(self, y, v):
        ys, vs = [y], [v]
        for n in range(self.order):
            vs.append((self.kappa * square(vs, n) - 2 * self.gamma * vs[n] - self.w2 * ys[n]) / (n + 1))
            ys.append(vs[n] / (n + 1))
        return ys, vs


class DragFreeSwing(SeriesSwing):
    """With w = e^(-kappa (y - y_start)) and p = w y' the square of the speed disappears:
    p' = -2 gamma p - omega0^2 w y, w' = -kappa p, y' = p / w (a division of series)."""

    order = 60

    def coefficients(self, y, v):
        ys, vs, ws, ps = [y], [v], [real(1)], [v]
        for n in range(self.order):
            ps.append((-2 * self.gamma * ps[n] - self.w2 * convolution(ws, ys, n)) / (n + 1))
            ws.append(-self.kappa * ps[n] / (n + 1))
            ys.append(vs[n] / (n + 1))
            vs.append(ps[n + 1] - sum(map(mul, vs, ws[n + 1:0:-1])))
        return ys, vs
