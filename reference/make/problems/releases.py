"""Every combination of signs of position and velocity, many swings, and other units."""

from .build import DRY, MIXES, SHORT, problem, scaled

SIGNS = [("left", -1, 0), ("right-outward", 1, 0.7), ("right-inward", 1, -0.6), ("left-inward", -1, 0.9),
         ("left-outward", -1, -0.8), ("centre-right", 0, 1.1), ("centre-left", 0, -1.3)]
STRENGTH = {"stokes": 0.06, "coulomb": 0.045, "newton": 0.3}


def problems():
    return signs() + sixty_swings() + units() + stopped_throws()


def signs():
    result = []
    for mix in MIXES:
        for name, side, speed in SIGNS:
            fields = scaled(mix, 0.2, **STRENGTH, mass=0.25, stiffness=9.0)
            result.append(problem(mix, f"release-{SHORT[mix]}-{name}", "release-signs",
                                  f"x0 and v0 of chosen signs: {name.replace('-', ', ')}",
                                  fields, 0.2 * side, 1.2 * speed))
    return result


def sixty_swings():
    weak = {"stokes": 0.003, "coulomb": 0.0084, "newton": 0.02}
    alone = {"coulomb": {"coulomb": 0.00831}, "stokes-coulomb": {"stokes": 0.006, "coulomb": 0.0042},
             "coulomb-newton": {"newton": 0.02, "coulomb": 0.0042},
             "stokes-coulomb-newton": {"stokes": 0.003, "coulomb": 0.0034, "newton": 0.015}}
    return [problem(mix, f"sixty-{SHORT[mix]}", "sixty-swings", "about sixty swings",
                    scaled(mix, 0.15, **alone.get(mix, weak), mass=0.4, stiffness=25.0), 0.15,
                    periods=None if mix in DRY else 30.2) for mix in MIXES]


def units():
    scales = [("light-soft", 1e-6, 1e-6, 1e-3), ("heavy-stiff", 1e6, 1e6, 2.0), ("light-stiff", 1e-6, 1e6, -1e-6)]
    scales.append(("heavy-soft", 1e6, 1e-6, -1e3))
    result = []
    for number, mix in enumerate(MIXES):
        for name, mass, stiffness, x0 in (scales[number % 4], scales[(number + 2) % 4], scales[(number + 3) % 4]):
            result.append(problem(mix, f"units-{SHORT[mix]}-{name}", "units",
                                  f"m = {mass:g} kg, C = {stiffness:g} N/m, x0 = {x0:g} m",
                                  scaled(mix, x0, **STRENGTH, mass=mass, stiffness=stiffness), x0))
    return result


def stopped_throws():
    """Thrown where dry friction is far stronger than the spring: the centre of the swing lies far off."""
    cases = [("3", 3.0, 0.0, 0.02, 0.1), ("1e4", 1e4, -0.7, 0.3, 5.0), ("1e9", 1e9, 0.4, 40.0, 2e3)]
    result = []
    for mix in DRY:
        for name, ratio, x0, stokes, newton in cases:
            fields = scaled(mix, 0.2, stokes=stokes, coulomb=ratio, newton=newton, mass=0.25, stiffness=9.0)
            result.append(problem(mix, f"stopped-{SHORT[mix]}-{name}", "stopped-throw",
                                  f"offset {name} times the amplitude, which ends a throw at once",
                                  fields, 0.2 * x0, 1.2))
    return result
