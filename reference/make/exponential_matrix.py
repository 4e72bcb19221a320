"""The second route for linear swings: no trigonometry, only matrix exponentials and powers.

(y, y') and (y^2, y y', y'^2, integral of y'^2) each obey a linear equation with constant coefficients;
the flow over a time t is the exponential of a matrix, computed by a Taylor sum and repeated squaring.
"""

import gmpy2

from .chain import Chain, Start
from .exact import real


def product(a, b):
    columns = list(zip(*b))
    return [[sum(map(lambda p, q: p * q, row, column)) for column in columns] for row in a]


def identity(n):
    return [[real(i == j) for j in range(n)] for i in range(n)]


def power(matrix, n):
    result = identity(len(matrix))
    while n:
        if n & 1:
            result = product(result, matrix)
        matrix = product(matrix, matrix)
        n >>= 1
    return result


def exponential(matrix, t):
    norm = max(sum(abs(e) for e in row) for row in matrix) * t
    halvings = max(0, gmpy2.get_exp(norm) + 8) if norm else 0
    step = [[e * t / 2 ** halvings for e in row] for row in matrix]
    result, term, n = identity(len(matrix)), identity(len(matrix)), 0
    smallest = real(2) ** -(gmpy2.get_context().precision + 10)
    while max(abs(e) for row in term for e in row) > smallest:
        n += 1
        term = [[e / n for e in row] for row in product(term, step)]
        result = [[p + q for p, q in zip(a, b)] for a, b in zip(result, term)]
    for _ in range(halvings):
        result = product(result, result)
    return result


class MatrixSwing:
    """A swing whose reversal is found by stepping and root finding."""

    def __init__(self, osc, y, v):
        self.gamma, self.w2 = real(osc.gamma), real(osc.omega0_squared)
        g, w2, zero, one = self.gamma, self.w2, real(0), real(1)
        self.flow = [[zero, one], [-w2, -2 * g]]
        self.quadratic = [[zero, real(2), zero, zero], [-w2, -2 * g, one, zero],
                          [zero, -2 * w2, -4 * g, zero], [zero, zero, one, zero]]
        self.y, self.v = y, v
        self.scan = self._scan_step(osc)
        self.duration = self._reversal()
        self.end = None if self.duration is None else self._move(self.duration)[0]

    @staticmethod
    def _scan_step(osc):
        """Short against the swing (underdamped) or against the fast decay (overdamped)."""
        if osc.discriminant > 0:
            return gmpy2.const_pi() / gmpy2.sqrt(real(osc.discriminant)) / 16
        return 1 / (16 * real(osc.gamma))

    def _move(self, t):
        (a, b), (c, d) = exponential(self.flow, t)
        return a * self.y + b * self.v, c * self.y + d * self.v

    def _creeps(self, y, v, sign):
        """Overdamped and slower than the critical line y' = -gamma y: never crosses the centre."""
        return sign and y > 0 and -v <= self.gamma * y

    def _reversal(self):
        overdamped = self.gamma ** 2 >= self.w2
        (a, b), (c, d) = exponential(self.flow, self.scan)
        y, v, t = self.y, self.v, real(0)
        while True:
            if self._creeps(y, v, overdamped):
                return None
            y, v, t = a * y + b * v, c * y + d * v, t + self.scan
            if v >= 0:
                return self._refine(t - self.scan, t)

    def _refine(self, low, high):
        for _ in range(20):
            middle = (low + high) / 2
            if self._move(middle)[1] < 0:
                low = middle
            else:
                high = middle
        t = (low + high) / 2
        for _ in range(12):
            y, v = self._move(t)
            t -= v / (-self.w2 * y - 2 * self.gamma * v)
        return t

    def state(self, t):
        y, v = self._move(t)
        if t == self.duration:
            v = real(0)
        start = (self.y ** 2, self.y * self.v, self.v ** 2, real(0))
        squares = sum(map(lambda p, q: p * q, exponential(self.quadratic, t)[3], start))
        return y, v, squares, real(0)


class PowerChain(Chain):
    """Many linear swings by powers of the matrix that maps (A^2, A, 1, sum of squares, path) one swing on."""

    def __init__(self, osc, x0, v0, count):
        super().__init__(osc, x0, v0, lambda y, v: MatrixSwing(osc, y, v), until=-1)
        self.make = lambda y: MatrixSwing(osc, y, real(0))
        self.first = self.final
        unit = self.make(real(1))
        r, f, q = -unit.end, self.offset, unit.state(unit.duration)[2]
        self.half = unit.duration
        zero, one = real(0), real(1)
        self.step = [[r * r, -4 * f * r, 4 * f * f, zero, zero], [zero, r, -2 * f, zero, zero],
                     [zero, zero, one, zero, zero], [q, zero, zero, one, zero],
                     [zero, 1 + r, zero, zero, one]]
        self.number, self.rests = count, self._rests_at(count)

    def _rests_at(self, n):
        """The band is reached with swing n and not one swing before."""
        if self.band == 0 or (self.offset == 0 and self.osc.gamma == 0):
            return False
        before, after = self.start(n - 1), self.start(n)
        return before.y + self.offset > self.band and after.y + self.offset <= self.band

    @property
    def count(self):
        return self.number

    def index_at(self, time):
        return 0 if time < self.first.time else 1 + int(gmpy2.floor((time - self.first.time) / self.half))

    def start(self, index):
        if index == 0:
            return self.starts[0]
        n = index - 1
        a = abs(self.first.x) - self.offset
        begin = (a * a, a, real(1), self.first.squares, self.first.path)
        _, a, _, squares, path = (sum(map(lambda p, q: p * q, row, begin))
                                  for row in power(self.step, n))
        sigma = (1 if self.first.x > 0 else -1) * (-1) ** n
        return Start(self.first.time + n * self.half, sigma, a, real(0), squares, real(0), path)

    def swing(self, index):
        return self.swings[0] if index == 0 else self.make(self.start(index).y)
