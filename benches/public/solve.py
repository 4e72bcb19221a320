"""Solves one problem with one solver: python solve.py SOLVER SETTING PROBLEM OUT.csv [LIMIT]

Writes the samples and prints what it took, as JSON."""

import importlib
import json
import sys
import time

from problem import load

SOLVERS = ["scipy_textbook", "scipy_events", "mujoco_joint", "rust_peer"]


def main():
    solver, setting, name, out, *rest = sys.argv[1:]
    limit = float(rest[0]) if rest else 60.0
    if solver not in SOLVERS:
        raise SystemExit(f"{solver} is no solver; there are {', '.join(SOLVERS)}")
    problem = load(name)
    module = importlib.import_module(solver)
    begun = time.perf_counter()
    rows, work, remark = module.solve(problem, setting, limit)
    wall = time.perf_counter() - begun
    with open(out, "w") as file:
        with_velocity = not rows or len(rows[0]) == 3
        file.write("time,position,velocity\n" if with_velocity else "time,position\n")
        file.writelines(",".join(map(repr, row)) + "\n" for row in rows)
    print(json.dumps({"samples": len(rows), "work": work, "wall": wall, "remark": remark}))


if __name__ == "__main__":
    main()
