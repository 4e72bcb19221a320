"""Where the mass sticks: static friction, the band, its edge, and ties."""

from fractions import Fraction

from ..exact import Oscillator, binary
from .build import DRY, MIXES, SHORT, problem, scaled

WEAK = {"stokes": 0.02, "newton": 0.1}


def problems():
    return static_above_kinetic() + no_kinetic() + band() + at_rest() + ties()


def static_above_kinetic():
    return [problem(mix, f"static-{SHORT[mix]}-{ratio:g}", "static-above-kinetic", f"mu_s = {ratio:g} mu_k",
                    scaled(mix, 0.3, **WEAK, coulomb=0.031, static=0.031 * ratio, mass=2.0, stiffness=50.0),
                    0.3 if ratio != 1.5 else -0.3) for mix in DRY for ratio in (1.2, 1.5, 3.0)]


def no_kinetic():
    return [problem(mix, f"static-only-{SHORT[mix]}", "static-without-kinetic", "mu_k = 0, mu_s > 0",
                    scaled(mix, 0.3, **WEAK, coulomb=0.0, static=0.35, mass=2.0, stiffness=50.0), 0.3,
                    periods=10 if mix == "coulomb" else None) for mix in DRY]


def band():
    result = []
    cases = [("inside", "released inside the band", 0.08, 0.0), ("outside", "released just outside", 0.1001, 0.0),
             ("thrown", "thrown from inside the band", -0.05, 3.0),
             ("thrown-once", "thrown from the centre, sticks after one swing", 0.0, 0.35)]
    for mix in DRY:
        for name, text, x0, v0 in cases:
            result.append(problem(mix, f"band-{SHORT[mix]}-{name}", "sticking-band", text + ", mu_s = 2 mu_k",
                                  scaled(mix, 1.0, **WEAK, coulomb=0.05, static=0.1, stiffness=4.0), x0, v0))
    return result


def at_rest():
    return [problem(mix, f"at-rest-{SHORT[mix]}", "at-rest", "x0 = v0 = 0: nothing happens",
                    scaled(mix, 1.0, **WEAK, coulomb=0.1), 0.0) for mix in MIXES]


# (mass, stiffness, normal force or None for 9.81 m, mu_k, mu_s or None, x0): in decimals
# |x0| - 2 N f = f_s holds exactly.
TIES = [("1", "10", "1", "0.1", None, "0.15"), ("1", "10", "1", "0.1", None, "-0.17"),
        ("1", "20", "5", "0.02", None, "0.095"), ("0.5", "20", None, "0.02", None, "0.103005"),
        ("0.5", "20", None, "0.02", None, "-0.044145"), ("0.3", "7", "2.1", "0.1", None, "0.81"),
        ("0.2", "5", "1", "0.3", None, "0.3"), ("2", "50", None, "0.1", None, "0.19620"),
        ("1", "100", "10", "0.3", "0.36", "0.276"), ("0.1", "10", "1", "0.2", "0.3", "0.23"),
        ("0.7", "10", "3", "0.01", "0.02", "0.6"), ("1", "10", "1", "0.1", None, "0.01"),
        ("1", "30", "3", "0.7", None, "-0.07"), ("0.05", "2.5", None, "0.15", "0.3", "0.23544"),
        ("0.1", "3", "0.6", "0.07", None, "0.882"), ("1", "10", "1", "0.3", None, "1.77"),
        ("0.4", "15", "2", "0.15", None, "0.14"), ("0.4", "15", "0.9", "0.15", None, "0.315"),
        ("0.4", "40", "3", "0.15", None, "0.61875"), ("0.4", "40", "2", "0.1", None, "0.135"),
        ("0.4", "12", "1.5", "0.15", None, "1.03125"), ("0.4", "40", "1.5", "0.3", None, "0.88875")]


def ties():
    return [p for p in (tie(i + 1, *case) for i, case in enumerate(TIES)) if p]


def tie(number, mass, stiffness, normal, kinetic, static, x0):
    fields = {"mass": mass, "stiffness": stiffness, "kinetic": kinetic}
    fields |= {"normal_force": normal} if normal else {"gravity": "9.81"}
    if static:
        fields["static"] = static
    exact_count, on_edge = count(fields, x0, Fraction)
    if not on_edge:
        raise ValueError(f"tie {number} does not end on the edge")
    entry = problem("coulomb", f"tie-{number}", "tie", "ends on the edge of the band exactly, in decimals",
                    {key: float(value) for key, value in fields.items()}, float(x0))
    return entry | {"stop_after": exact_count, "swings_strict": count(fields, x0, binary)[0], "edge": True}


def count(fields, x0, reading):
    """(number of swings, ends on the edge) with rational arithmetic."""
    osc = Oscillator.read(fields, reading)
    steps = (abs(reading(x0)) - osc.band) / (2 * osc.offset)
    return max(0, -(-steps.numerator // steps.denominator)), steps.denominator == 1 and steps >= 0
