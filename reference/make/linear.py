"""Without Newton friction a swing has a closed form, and so has the whole chain."""

from gmpy2 import atan2, atanh, ceil, cos, exp, floor, log, sin, sqrt

from .chain import Chain, Start
from .exact import real


class ClosedSwing:
    """y = e^(-gamma t) [y0 c + (v0 + gamma y0) S], one branch for each sign of the exact discriminant."""

    def __init__(self, osc, y, v):
        self.gamma, self.w2 = real(osc.gamma), real(osc.omega0_squared)
        self.sign = (osc.discriminant > 0) - (osc.discriminant < 0)
        self.root = sqrt(abs(real(osc.discriminant)))
        self.y, self.v = y, v
        self.slope = self.gamma * v + self.w2 * y
        self.duration = self._duration()
        self.end = None if self.duration is None else self.state(self.duration)[0]

    def _duration(self):
        """First positive zero of v0 c - (gamma v0 + omega0^2 y0) S."""
        if self.sign > 0:
            return atan2(abs(self.v) * self.root, -self.slope) / self.root
        if self.slope >= 0 or self.v == 0:
            return None
        if self.sign == 0:
            return self.v / self.slope
        ratio = self.root * self.v / self.slope
        return atanh(ratio) / self.root if ratio < 1 else None

    def _functions(self, t):
        """e^(-gamma t) c and e^(-gamma t) S; decaying exponentials only, so nothing overflows."""
        decay = exp(-self.gamma * t)
        if self.sign > 0:
            return decay * cos(self.root * t), decay * sin(self.root * t) / self.root
        if self.sign == 0:
            return decay, decay * t
        slow = exp(-self.w2 / (self.gamma + self.root) * t)
        fast = exp(-(self.gamma + self.root) * t)
        return (slow + fast) / 2, (slow - fast) / (2 * self.root)

    def state(self, t):
        c, s = self._functions(t)
        y = self.y * c + (self.v + self.gamma * self.y) * s
        v = self.v * c - self.slope * s
        if t == self.duration:
            v = real(0)
        return y, v, self._squares(y, v), real(0)

    def _squares(self, y, v):
        """Integral of y'^2, from d(y'^2 + omega0^2 y^2)/dt = -4 gamma y'^2."""
        if self.gamma == 0:
            return real(0)
        lost = self.v ** 2 - v ** 2 + self.w2 * (self.y ** 2 - y ** 2)
        return lost / (4 * self.gamma)


class GeometricChain(Chain):
    """Underdamped (or undamped) and linear: turning point number n costs the same for every n.

    After the first reversal the swings start at amplitudes A about their own centres with
    A' = r A - 2 offset, r = e^(-gamma pi / root)."""

    def __init__(self, osc, x0, v0, until=None, stop_after=None):
        super().__init__(osc, x0, v0, lambda y, v: ClosedSwing(osc, y, v), until=-1,
                         stop_after=stop_after)
        self.until, self.number = until, len(self.swings)
        self.only_first = self.rests
        if self.only_first:
            return
        self.first = self.final
        self.root = sqrt(real(osc.discriminant))
        self.half = 2 * atan2(real(1), real(0)) / self.root
        self.ratio = exp(-real(osc.gamma) * self.half)
        self.first_amplitude = abs(self.first.x) - self.offset
        self.first_sigma = 1 if self.first.x > 0 else -1
        self.number = stop_after or self._swings_to_rest()
        self.rests = self.number is not None
        self._margins()

    def _amplitude(self, n):
        """A at the start of the n-th swing after the first reversal (n = 0, 1, ...)."""
        if self.ratio == 1:
            return self.first_amplitude - 2 * n * self.offset
        fixed = -2 * self.offset / (1 - self.ratio)
        return fixed + self.ratio ** n * (self.first_amplitude - fixed)

    def _sums(self, n):
        """Sums of A and of A^2 over the first n swings after the first reversal."""
        a, f, r = self.first_amplitude, self.offset, self.ratio
        if r == 1:
            return (n * a - f * n * (n - 1),
                    n * a ** 2 - 2 * a * f * n * (n - 1) + 2 * f ** 2 * n * (n - 1) * (2 * n - 1) / 3)
        p = -2 * f / (1 - r)
        q = a - p
        one, two = (1 - r ** n) / (1 - r), (1 - r ** (2 * n)) / (1 - r ** 2)
        return n * p + q * one, n * p ** 2 + 2 * p * q * one + q ** 2 * two

    def _swings_to_rest(self):
        """Smallest number of swings after which the distance is inside the band."""
        if self.band == 0 or (self.ratio == 1 and self.offset == 0):
            return None
        level = self.band - self.offset
        if self.ratio == 1:
            guess = (self.first_amplitude - level) / (2 * self.offset)
        else:
            fixed = -2 * self.offset / (1 - self.ratio)
            guess = log((level - fixed) / (self.first_amplitude - fixed)) / log(self.ratio)
        n = max(1, int(ceil(guess)) - 1)
        while self._amplitude(n) > level:
            n += 1
        return n + 1

    def _margins(self):
        if self.rests:
            for n in (self.number - 2, self.number - 1):
                self._note_margin(abs(self._amplitude(max(n, 0)) + self.offset))

    @property
    def count(self):
        return self.index_at(self.until) if self.number is None else self.number

    def index_at(self, time):
        if self.only_first or time < self.first.time:
            return 0
        return 1 + int(floor((time - self.first.time) / self.half))

    def start(self, index):
        if index == 0:
            return self.starts[0]
        n = index - 1
        a_sum, a2_sum = self._sums(n)
        w2, gamma = real(self.osc.omega0_squared), real(self.osc.gamma)
        squares = w2 * (1 - self.ratio ** 2) * a2_sum / (4 * gamma) if gamma else real(0)
        return Start(self.first.time + n * self.half, self.first_sigma * (-1) ** n,
                     self._amplitude(n), real(0), self.first.squares + squares, real(0),
                     self.first.path + (1 + self.ratio) * a_sum)

    def swing(self, index):
        if index == 0:
            return self.swings[0]
        return ClosedSwing(self.osc, self._amplitude(index - 1), real(0))
