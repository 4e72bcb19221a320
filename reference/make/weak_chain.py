"""A chain of millions of swings under weak Newton friction (and dry friction), by the swing map of `weak`."""

import gmpy2

from . import weak
from .chain import Chain, Start, first_start
from .exact import real
from .nonlinear import DragFreeSwing, TaylorSwing

TERMS = (17, 20)  # of the map's power series in each route


class MapChain(Chain):
    """From rest, gamma = 0. Only some swings are kept, and samples must lie in them.

    Route 1 jumps with the Abel function where Newton friction acts alone. The heat of Newton friction
    up to a turning point is what the energy balance leaves."""

    def __init__(self, osc, x0, v0, swings, choose, route):
        assert v0 == 0 and osc.damping == 0
        self.osc, self.x0, self.creeps, self.margin = osc, x0, False, None
        self.offset, self.band = real(osc.offset), real(osc.band)
        self.make = (TaylorSwing, DragFreeSwing)[route]
        self.kappa, self.omega0 = real(osc.kappa), gmpy2.sqrt(real(osc.omega0_squared))
        first = first_start(osc, x0, v0)
        self.rests = self.band > 0
        self.number = self._count(first.y) if self.rests else swings
        marks = {n - 1 for n in choose(self.number)} | set(choose(self.number)) | {0}
        self.found = self._jump(self.kappa * first.y, marks, route)
        self.marks = sorted(self.found)
        if self.rests:
            self._check_rest()

    def _count(self, y):
        scaled = [float(self.kappa * q) for q in (y, self.offset, self.band)]
        return weak.count_to_rest(*scaled)

    def _jump(self, u, marks, route):
        if route == 1 and self.offset == 0:
            abel = weak.Abel()
            return {n: abel.after(u, n) for n in marks}
        return weak.iterate(u, self.kappa * self.offset, marks, TERMS[route])

    def _check_rest(self):
        before, after = (self._distance(n) for n in (self.number - 1, self.number))
        assert before > self.band >= after, "rest found in floating point is not the exact one"
        self._note_margin(before)
        self._note_margin(abs(after))

    def _distance(self, n):
        return self.found[n][0] / self.kappa + self.offset

    @property
    def count(self):
        return self.number

    def known_turnings(self, numbers):
        return [n for n in numbers if n in self.found]

    def start(self, n):
        u, turns, path = self.found[n]
        sigma = (1 if self.x0 > 0 else -1) * (-1) ** n
        path, x = path / self.kappa, self._distance(n)
        osc = self.osc
        lost = real(osc.stiffness) * (real(self.x0) ** 2 - x ** 2) / 2 - real(osc.kinetic_force) * path
        return Start(turns * gmpy2.const_pi() / self.omega0, sigma, u / self.kappa, real(0), real(0),
                     lost / real(osc.newton), path)

    def turning(self, n):
        start = self.start(n)
        return start.time, start.sigma * self._distance(n)

    def swing(self, n):
        return self.make(self.osc, self.found[n][0] / self.kappa, real(0))

    def index_at(self, time):
        return max(n for n in self.marks if self.start(n).time <= time)

    def _state_at_rest(self, rest):
        start = self.start(self.number)
        return rest[1], real(0), *self._heats(start.squares, start.cubes, start.path)
