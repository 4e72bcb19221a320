"""Strong Newton friction."""

from .build import SHORT, TURBULENT, problem, scaled


def problems():
    return from_rest() + fast_throws()


def from_rest():
    return [problem(mix, f"drag-{SHORT[mix]}-{drag:g}", "strong-drag", f"kappa |x0| = {drag:g}",
                    scaled(mix, 0.5, 0.05, 0.4 / drag / 20, drag), 0.5 if drag != 10 else -0.5,
                    periods=4 + drag ** 0.5 / 2 if "coulomb" not in mix else None)
            for mix in TURBULENT for drag in (1.0, 10.0, 100.0, 1000.0)]


def fast_throws():
    """kappa v0/omega0 = 1000 from the centre, and from a displaced place."""
    result = []
    for mix in TURBULENT:
        for name, x0, v0 in (("centre", 0.0, 1000.0), ("inward", 0.3, -100.0), ("outward", -0.3, -1000.0)):
            result.append(problem(mix, f"throw-{SHORT[mix]}-{name}", "fast-throw",
                                  f"kappa |v0|/omega0 = {abs(v0):g}", scaled(mix, 1.0, 0.05, 0.02, 1.0),
                                  x0, v0, periods=5 if "coulomb" not in mix else None))
    return result
