"""Turns numbers into the fields of a problem."""

import math

from ..exact import shortest

MIXES = ("undamped", "stokes", "coulomb", "newton", "stokes-coulomb", "stokes-newton",
         "coulomb-newton", "stokes-coulomb-newton")
LINEAR = ("undamped", "stokes", "coulomb", "stokes-coulomb")
DRY = tuple(mix for mix in MIXES if "coulomb" in mix)
TURBULENT = tuple(mix for mix in MIXES if "newton" in mix)
SHORT = {"undamped": "free", "stokes": "s", "coulomb": "c", "newton": "n", "stokes-coulomb": "sc",
         "stokes-newton": "sn", "coulomb-newton": "cn", "stokes-coulomb-newton": "scn"}
FOREVER = 1e4  # periods after which a mass with dry friction has come to rest in every problem here


def problem(mix, name, corner, description, oscillator, x0, v0=0.0, periods=None, **extra):
    """`oscillator` maps the schema's field names to numbers; `periods` of 2 pi/omega0 are covered."""
    period = 2 * math.pi * math.sqrt(oscillator["mass"] / oscillator["stiffness"])
    if periods is None:
        periods = FOREVER if "coulomb" in mix else 8
    return {"mix": mix, "name": name, "corner": corner, "description": description,
            "oscillator": {key: shortest(value) for key, value in oscillator.items()},
            "release": {"position": shortest(x0), "velocity": shortest(v0)},
            "until": periods * period, **extra}


def scaled(mix, x0, stokes=0.0, coulomb=0.0, newton=0.0, mass=1.0, stiffness=1.0, static=None):
    """Oscillator fields from dimensionless strengths: gamma/omega0, offset/x0, kappa x0.

    The normal force is C |x0|, so the coefficients of dry friction are offset/x0 and band/x0."""
    fields = {"mass": mass, "stiffness": stiffness}
    size = abs(x0)
    if "stokes" in mix:
        fields["damping"] = tidy(2 * stokes * math.sqrt(mass * stiffness))
    if "coulomb" in mix:
        fields |= {"normal_force": tidy(stiffness * size), "kinetic": tidy(coulomb)}
        if static is not None:
            fields["static"] = tidy(static)
    if "newton" in mix:
        fields["newton_coefficient"] = tidy(newton * mass / size)
    return fields


def tidy(value):
    """Without the last bits of noise, so that the decimal strings stay short; 15 digits keep 1 - 1e-12."""
    return float(f"{value:.15g}")
