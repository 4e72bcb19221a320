"""Strongly overdamped swings with Newton friction, where a series in time needs too many steps.

Scaled: u = kappa y, tau = omega0 t, g = gamma/omega0, so u'' + 2 g u' - u'^2 + u = 0. The fast layer
is crossed by series in time; what follows it is the slow manifold, described here in two ways.
"""

from operator import mul

import gmpy2

from .exact import real
from .nonlinear import DragFreeSwing, TaylorSwing, horner, square


class LayeredSwing:
    """A swing without reversal: `layer` until its fast part has vanished, then a subclass's slow motion."""

    duration = end = None
    order = 60

    def __init__(self, osc, y, v):
        layer = self.layer(osc, y, v)
        self.kappa, self.omega0 = real(osc.kappa), gmpy2.sqrt(real(osc.omega0_squared))
        self.g = real(osc.gamma) / self.omega0
        root = gmpy2.sqrt(real(osc.gamma ** 2 / osc.omega0_squared - 1))
        self.slow, self.fast = -1 / (self.g + root), -(self.g + root)
        # After this time the fast part is below the working precision relative to the slow one.
        bits = gmpy2.get_context().precision + 40
        self.leave = bits * gmpy2.log(real(2)) / (self.slow - self.fast) / self.omega0
        y, _, self.squares, self.cubes = layer.state(self.leave)
        self.crossing, self.u = layer, self.kappa * y
        self.prepare()

    def state(self, t):
        if t <= self.leave:
            return self.crossing.state(t)
        u, w, squares, cubes = self.slow_state((t - self.leave) * self.omega0)
        k, o = self.kappa, self.omega0
        return (u / k, w * o / k, self.squares + squares * o / k ** 2,
                self.cubes + cubes * o ** 2 / k ** 3)


class SlowManifoldSwing(LayeredSwing):
    """u' = h(u) with a power series h. On the manifold h h' + 2 g h - h^2 + u = 0 gives its
    coefficients, and tau = integral of du/h is a logarithm and a power series."""

    layer = TaylorSwing

    def prepare(self):
        h, h2 = [real(0), self.slow], [real(0), real(0), self.slow ** 2]
        for k in range(2, self.order):
            inner = sum(map(mul, h[2:k], h[k - 1:1:-1]), real(0))  # [h^2]_(k+1) without h_1 h_k
            value = (h2[k] - real(k + 1) / 2 * inner) / ((k + 1) * self.slow + 2 * self.g)
            h.append(value)
            h2.append(inner + 2 * self.slow * value)
        self.h, self.h2 = h, h2
        self.inverse = [1 / self.slow]  # u / h(u)
        for n in range(1, self.order - 1):
            self.inverse.append(-sum(map(mul, h[2:n + 2], self.inverse[n - 1::-1]), real(0)) / self.slow)
        self.clock = self._clock(self.u)

    def _clock(self, u):
        return self.inverse[0] * gmpy2.log(u) + horner(
            [real(0)] + [c / n for n, c in enumerate(self.inverse) if n], u)

    @staticmethod
    def _integral(series, u):
        return horner([real(0)] + [c / (n + 1) for n, c in enumerate(series)], u)

    def slow_state(self, tau):
        u = self.u * gmpy2.exp(self.slow * tau)
        for _ in range(12):
            u -= (self._clock(u) - self.clock - tau) * horner(self.h, u)
        squares = self._integral(self.h, u) - self._integral(self.h, self.u)
        cubes = self._integral(self.h2, self.u) - self._integral(self.h2, u)
        return u, horner(self.h, u), squares, cubes


class SlowExponentialSwing(LayeredSwing):
    """u = sum c_j E^j with E = A e^(slow tau): each c_j follows from the lower ones because
    (mu^2 + 2 g mu + 1) c_j = [u'^2]_j with mu = j slow. A meets u at the end of the layer."""

    layer = DragFreeSwing
    order = 50

    def prepare(self):
        c, w = [real(0), real(1)], [real(0), self.slow]
        for j in range(2, self.order):
            mu = j * self.slow
            c.append((square(w + [real(0)], j)) / ((mu - self.slow) * (mu - self.fast)))
            w.append(mu * c[-1])
        self.c, self.w = c, w
        w2 = [square(w, j) for j in range(self.order)]
        w3 = [sum(map(mul, w[:j + 1], w2[j::-1])) for j in range(self.order)]
        self.w2 = [real(0)] + [q / (j * self.slow) for j, q in enumerate(w2) if j]
        self.w3 = [real(0)] + [-q / (j * self.slow) for j, q in enumerate(w3) if j]
        slope = [j * q for j, q in enumerate(c)][1:]
        self.start = self.u
        for _ in range(12):
            self.start -= (horner(c, self.start) - self.u) / horner(slope, self.start)

    def slow_state(self, tau):
        e = self.start * gmpy2.exp(self.slow * tau)
        return (horner(self.c, e), horner(self.w, e), horner(self.w2, e) - horner(self.w2, self.start),
                horner(self.w3, e) - horner(self.w3, self.start))
