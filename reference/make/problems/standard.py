"""Cases with printed numbers, and seeded random ones."""

import random

from .build import MIXES, SHORT, problem, scaled, tidy

LAB = {"mass": 0.5, "stiffness": 20.0}
GRAVITY = {"gravity": 9.81}


def problems():
    return reference_cases() + unit_cases() + random_cases()


def reference_cases():
    corner, text = "reference-case", "0.5 kg on 20 N/m, released at 10 cm: {}"
    laws = {
        "undamped": {},
        "stokes": {"damping": 0.2},
        "coulomb": GRAVITY | {"kinetic": 0.02},
        "newton": {"newton_coefficient": 0.235},
        "stokes-coulomb": GRAVITY | {"damping": 0.1, "kinetic": 0.01},
        "stokes-newton": {"damping": 0.1, "newton_coefficient": 0.094},
        "coulomb-newton": GRAVITY | {"kinetic": 0.01, "newton_coefficient": 0.094},
        "stokes-coulomb-newton": GRAVITY | {"damping": 0.05, "kinetic": 0.005, "newton_coefficient": 0.047},
    }
    return [problem(mix, f"laboratory-{SHORT[mix]}", corner, text.format(mix), LAB | law, 0.1, periods=20.1)
            for mix, law in laws.items()]


def unit_cases():
    """omega0 = 1 and unit amplitude: the turning amplitudes that the project prints."""
    cases = [("newton", 0, 0, 0.1), ("newton", 0, 0, 1), ("coulomb-newton", 0, 0.02, 0.1),
             ("stokes-coulomb", 0.05, 0.02, 0), ("stokes-newton", 0.05, 0, 0.1),
             ("stokes-coulomb-newton", 0.05, 0.02, 0.1)]
    return [problem(mix, f"unit-{SHORT[mix]}-kappa-{k:g}", "unit-amplitude",
                    f"omega0 = 1, x0 = 1: gamma = {g:g}, offset = {f:g}, kappa = {k:g}",
                    scaled(mix, 1.0, g, f, k), 1.0) for mix, g, f, k in cases]


def random_cases():
    return [random_case(mix, number) for mix in MIXES[1:] for number in range(random_count(mix))]


def random_count(mix):
    return 5 + 2 * mix.count("-")


def random_case(mix, number):
    """Strengths such that about 5 to 60 swings matter; the laws share the loss of amplitude."""
    source = random.Random(f"{mix} {number}")
    swings = source.randint(5, 60)
    share = lambda: source.uniform(0.3, 1.2) / (1 + mix.count("-"))
    mass, stiffness = (tidy(float(f"{10 ** source.uniform(-2, 2):.3g}")) for _ in range(2))
    x0 = float(f"{10 ** source.uniform(-3, 0) * source.choice((-1, 1)):.4g}")
    strengths = {"stokes": share() * 2 / (3.14 * swings), "coulomb": share() / (2 * swings),
                 "newton": share() * 3 / swings}
    rounded = {law: float(f"{value:.4g}") for law, value in strengths.items()}
    ratio = source.choice((None, None, 1.2, 1.5))
    fields = scaled(mix, x0, **rounded, mass=mass, stiffness=stiffness,
                    static=ratio and rounded["coulomb"] * ratio)
    speed = abs(x0) * (stiffness / mass) ** 0.5
    v0 = source.choice((0.0, float(f"{speed * source.uniform(-1.5, 1.5):.4g}")))
    return problem(mix, f"random-{SHORT[mix]}-{number + 1}", "random", "random strengths, seeded",
                   fields, x0, v0, periods=None if "coulomb" in mix else swings / 2)
