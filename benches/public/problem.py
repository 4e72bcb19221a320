"""A reference problem as plain numbers, and the times at which it is sampled."""

import json
import math
from dataclasses import dataclass
from pathlib import Path

REFERENCE = Path(__file__).resolve().parents[2] / "reference"

# Even samples besides the stored times.
SAMPLES = 2000

# A mass that rests is watched until this many times the time of its rest.
AFTER_REST = 1.25


@dataclass
class Problem:
    """All in SI units; friction that does not act is zero."""

    name: str
    description: str
    mass: float
    stiffness: float
    damping: float
    kinetic_force: float
    static_force: float
    newton: float
    position: float
    velocity: float
    duration: float
    times: list

    def rate(self, x, v, sign):
        """The acceleration; `sign` is the direction in which friction takes the mass to move."""
        friction = self.damping * v + sign * (self.kinetic_force + self.newton * v * v)
        return -(self.stiffness * x + friction) / self.mass

    def sticks(self, x):
        """Whether dry friction holds the mass where its velocity is zero."""
        return self.stiffness * abs(x) <= self.static_force


def load(name):
    """The problem of this name, from whichever file holds it."""
    for path in sorted(REFERENCE.glob("*.json")):
        if path.name == "schema.json":
            continue
        for found in json.loads(path.read_text())["problems"]:
            if found["name"] == name:
                return read(found)
    raise SystemExit(f"no problem is called {name}")


def read(found):
    given = {key: float(value) for key, value in found["oscillator"].items()}
    stored = [float(sample["time"]) for sample in found["samples"]]
    rest = found["rest"] and float(found["rest"]["time"])
    duration = AFTER_REST * rest if rest else max(stored)
    even = [duration * i / (SAMPLES - 1) for i in range(SAMPLES)]
    pressing = given.get("normal_force", given["mass"] * given.get("gravity", 0.0))
    kinetic = given.get("kinetic", 0.0)
    return Problem(
        name=found["name"],
        description=found["description"],
        mass=given["mass"],
        stiffness=given["stiffness"],
        damping=given.get("damping", 0.0),
        kinetic_force=kinetic * pressing,
        static_force=given.get("static", kinetic) * pressing,
        newton=given.get("newton_coefficient", 0.0),
        position=float(found["release"]["position"]),
        velocity=float(found["release"]["velocity"]),
        duration=duration,
        times=sorted(set(even + [time for time in stored if time <= duration])),
    )


def sign(value):
    """−1, 0 or 1."""
    return math.copysign(1.0, value) if value else 0.0
