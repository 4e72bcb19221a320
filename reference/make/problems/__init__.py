"""All reference problems, one file per group of corners."""

from . import damping, drag, long, releases, rest, standard
from .build import MIXES as MIXES


def all_problems():
    problems = [p for group in (standard, releases, damping, drag, rest, long) for p in group.problems()]
    names = [p["name"] for p in problems]
    assert len(names) == len(set(names)), sorted({n for n in names if names.count(n) > 1})
    return problems
