"""The chain of swings: where each starts, where the mass sticks, the state at any time.

Every swing is described in mirrored coordinates in which the mass moves towards negative values:
y = sigma x - offset, y' <= 0. A swing object offers `duration` (None: no reversal any more),
`end` (y at the reversal) and `state(t)` = (y, y', integral of y'^2, integral of |y'|^3) since its start.
"""

from bisect import bisect_right
from dataclasses import dataclass

from .exact import real


@dataclass
class Start:
    """Beginning of a swing, and the integrals gathered before it."""

    time: object
    sigma: int
    y: object
    v: object
    squares: object
    cubes: object
    path: object


def first_start(osc, x0, v0):
    """The first swing's start, or None where the mass stays at rest from the beginning."""
    zero = real(0)
    if v0 == 0:
        if abs(x0) <= osc.band:
            return None
        sigma = 1 if x0 > 0 else -1
        return Start(zero, sigma, real(abs(x0) - osc.offset), zero, zero, zero, zero)
    sigma = -1 if v0 > 0 else 1
    return Start(zero, sigma, real(sigma * x0 - osc.offset), -real(abs(v0)), zero, zero, zero)


class Chain:
    """Swing after swing, made by `make_swing(y, v)`, until rest, creeping or `until` seconds."""

    def __init__(self, osc, x0, v0, make_swing, until=None, stop_after=None):
        self.osc, self.x0 = osc, x0
        self.offset, self.band = real(osc.offset), real(osc.band)
        self.starts, self.swings, self.times = [], [], []
        self.rests = self.creeps = False
        self.margin = None
        start = None if stop_after == 0 else first_start(osc, x0, v0)
        self.rests = start is None
        while start is not None:
            start = self._swing(start, make_swing, until, stop_after)

    def _swing(self, start, make_swing, until, stop_after):
        swing = make_swing(start.y, start.v)
        self.starts.append(start)
        self.swings.append(swing)
        self.times.append(start.time)
        if swing.duration is None:
            self.creeps = True
            return None
        after = self._after(start, swing)
        self.final = after
        distance = abs(after.x)
        if stop_after is not None:
            self.rests = len(self.swings) == stop_after
        else:
            self._note_margin(distance)
            self.rests = distance <= self.band
        if self.rests or (until is not None and after.time > until):
            return None
        sigma = 1 if after.x > 0 else -1
        return Start(after.time, sigma, distance - self.offset, real(0),
                     after.squares, after.cubes, after.path)

    def _note_margin(self, distance):
        """The narrowest decision between sticking and going on, relative to the band."""
        if self.band > 0:
            margin = abs(distance / self.band - 1)
            self.margin = margin if self.margin is None else min(self.margin, margin)

    def _after(self, start, swing):
        _, _, squares, cubes = swing.state(swing.duration)
        after = Start(start.time + swing.duration, start.sigma, swing.end, real(0),
                      start.squares + squares, start.cubes + cubes,
                      start.path + start.y - swing.end)
        after.x = start.sigma * (swing.end + self.offset)
        return after

    # What the answers are made of; a chain with a closed form overrides these.

    @property
    def count(self):
        """Number of completed swings that are known."""
        return len(self.swings) - (1 if self.creeps else 0)

    def start(self, index):
        return self.starts[index]

    def swing(self, index):
        return self.swings[index]

    def index_at(self, time):
        return bisect_right(self.times, time) - 1

    def known_turnings(self, numbers):
        """Those of the turning points asked for that this chain knows."""
        return numbers

    def turning(self, index):
        """(time, position) of turning point `index`, counted from 1."""
        after = self._after(self.start(index - 1), self.swing(index - 1))
        return after.time, after.x

    def rest(self):
        """(time, position, swings) or None."""
        if not self.rests:
            return None
        if self.count == 0:
            return real(0), real(self.x0), 0
        return (*self.turning(self.count), self.count)

    def limit(self):
        return self.start(self.count).sigma * self.offset if self.creeps else None

    def state(self, time):
        """(x, v, heat of Stokes, of Coulomb, of Newton) at that time."""
        rest = self.rest()
        if rest is not None and time >= rest[0]:
            return self._state_at_rest(rest)
        index = self.index_at(time)
        start = self.start(index)
        y, v, squares, cubes = self.swing(index).state(time - start.time)
        return (start.sigma * (y + self.offset), start.sigma * v,
                *self._heats(start.squares + squares, start.cubes + cubes,
                             start.path + start.y - y))

    def _state_at_rest(self, rest):
        if rest[2] == 0:
            return rest[1], real(0), real(0), real(0), real(0)
        last = rest[2] - 1
        after = self._after(self.start(last), self.swing(last))
        return after.x, real(0), *self._heats(after.squares, after.cubes, after.path)

    def _heats(self, squares, cubes, path):
        osc = self.osc
        return (real(osc.damping) * squares, real(osc.kinetic_force) * path,
                real(osc.newton) * cubes)
