"""Sample times: irregular, some just after reversals, some after rest; all of them binary64 numbers."""

import random

from .exact import real, shortest


def rounded(value, digits=12):
    return float(f"{float(value):.{digits}g}")


def sample_times(name, chain, until, logarithmic):
    """Sorted distinct times as strings, seeded by the problem's name."""
    source = random.Random(name)
    if hasattr(chain, "marks"):
        times = in_marked_swings(source, chain)
    else:
        end = until if chain.rest() is None or chain.count == 0 else min(until, float(chain.rest()[0]))
        times = spread(source, end, logarithmic) + after_turnings(source, chain, end)
    times += after_rest(source, chain)
    return [shortest(t) for t in sorted({0.0, *times})]


def spread(source, end, logarithmic):
    """Uniform, or over six decades where a fast layer comes before slow creeping."""
    if logarithmic:
        return [rounded(end * 10 ** -(6 * (k + source.random()) / 14), 6) for k in range(14)]
    return [rounded(end * (k + source.random()) / 11, 8) for k in range(11)]


def after_turnings(source, chain, end):
    """Shortly after the first, second, middle and last reversal (by 1e-6 to 1e-1 of a swing)."""
    count, times = chain.count, []
    for n in sorted(n for n in {1, 2, count // 2, count - 1} if 0 < n < count):
        at, following = float(chain.turning(n)[0]), float(chain.turning(n + 1)[0])
        if at < end:
            times.append(rounded(at + (following - at) * 10 ** source.uniform(-6, -1), 16))
    return times


def in_marked_swings(source, chain):
    """A long map chain knows the state only in a few swings."""
    times, half = [], 3.14 / float(chain.omega0)
    for n in chain.marks[:-1]:
        if n + 1 in chain.found:
            times.append(rounded(float(chain.start(n).time) + half * source.uniform(0.001, 0.999), 15))
    return times


def after_rest(source, chain):
    rest = chain.rest()
    if rest is None:
        return []
    if chain.count == 0:
        return [rounded(source.uniform(0.1, 1), 6), rounded(source.uniform(1, 1e3), 6)]
    at = float(rest[0])
    first = next(t for t in (rounded(at * (1 + 10.0 ** -k), 16) for k in (9, 8, 7)) if real(t) > rest[0])
    return [first, rounded(1.05 * at, 6), rounded(10 * at, 6)]
