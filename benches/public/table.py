"""Runs every solver on every problem, has the samples scored, and writes the tables.

    python table.py                                    # prints them
    python table.py laboratory-c                       # of one problem
    python table.py --write ../../docs/benchmark.md    # puts them into the document

The score comes from the program of this checkout, or from another one (--score "federpendel score").
Each run is a process of its own with a limit of time (--limit, 60 s)."""

import argparse
import json
import platform
import shlex
import subprocess
import sys
import tempfile
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from problem import load

HERE = Path(__file__).resolve().parent
BEGIN, END = "<!-- measured: begin -->", "<!-- measured: end -->"

PROBLEMS = [
    "laboratory-s",
    "laboratory-n",
    "laboratory-c",
    "laboratory-scn",
    "static-c-3",
    "stopped-c-1e4",
]

# Title, module, setting.
RUNS = [
    ("SciPy DOP853, sign(v)", "scipy_textbook", "DOP853"),
    ("SciPy LSODA, sign(v)", "scipy_textbook", "LSODA"),
    ("SciPy Radau, sign(v)", "scipy_textbook", "Radau"),
    ("SciPy DOP853, events", "scipy_events", "DOP853"),
    ("SciPy LSODA, events", "scipy_events", "LSODA"),
    ("SciPy Radau, events", "scipy_events", "Radau"),
    ("MuJoCo, step 2 ms (default)", "mujoco_joint", "0.002"),
    ("MuJoCo, step 0.1 ms", "mujoco_joint", "0.0001"),
    ("MuJoCo, step 0.1 ms, hard", "mujoco_joint", "0.0001 hard"),
    ("ode_solvers Dopri5, sign(v)", "rust_peer", "ode_solvers Dopri5"),
    ("ode_solvers Dop853, sign(v)", "rust_peer", "ode_solvers Dop853"),
    ("differential-equations dopri5, sign(v)", "rust_peer", "differential-equations dopri5"),
    ("differential-equations dop853, sign(v)", "rust_peer", "differential-equations dop853"),
    ("diffsol tsit45, sign(v)", "rust_peer", "diffsol tsit45"),
    ("diffsol bdf, sign(v)", "rust_peer", "diffsol bdf"),
]

# A process may start and write for this much longer than it may solve, s.
GRACE = 30


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--score", default="cargo run -q --release -- score")
    parser.add_argument("--limit", type=float, default=60.0)
    parser.add_argument("--solver", default="", help="only those whose title has this in it")
    parser.add_argument("--write", type=Path)
    parser.add_argument("problems", nargs="*", default=PROBLEMS)
    options = parser.parse_args()
    report = machine(options.limit)
    for name in options.problems:
        report += table(name, options)
    print(report)
    if options.write:
        write(options.write, report)


def machine(limit):
    packages = ", ".join(map(package, ("scipy", "mujoco", "numpy")))
    where = f"{platform.machine()}, Python {platform.python_version()}"
    return f"Measured on: {where}; {packages}. Limit of a run: {limit:g} s.\n"


def package(name):
    """Name and version; a solver that is missing fails in its own rows only."""
    try:
        return f"{name} {version(name)}"
    except PackageNotFoundError:
        return f"{name} missing (pip install -r requirements.txt)"


def table(name, options):
    problem = load(name)
    lines = [
        f"\n### {name}: {problem.description}\n",
        "| solver | samples | largest error of x | of v | after rest | work | time | remark |",
        "|---|---:|---:|---:|---|---:|---:|---|",
    ]
    for title, module, setting in RUNS:
        # The Rust program knows the reference cases only.
        knows = module != "rust_peer" or name.startswith("laboratory-")
        if options.solver not in title or not knows:
            continue
        print(f"{name}: {title}", file=sys.stderr)
        cells = [title, *run(module, setting, name, options)]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def run(module, setting, name, options):
    """The cells of a row."""
    with tempfile.TemporaryDirectory() as folder:
        out = str(Path(folder) / "samples.csv")
        command = [sys.executable, HERE / "solve.py", module, setting, name, out]
        try:
            done = subprocess.run(
                [*command, str(options.limit)],
                capture_output=True,
                text=True,
                timeout=options.limit + GRACE,
            )
        except subprocess.TimeoutExpired:
            return failed(f"gave up after {options.limit:g} s, within one step")
        if done.returncode:
            return failed(f"failed: {done.stderr.strip().splitlines()[-1]}")
        taken = json.loads(done.stdout.splitlines()[-1])
        if not taken["samples"]:
            return failed(taken["remark"])
        scored = subprocess.run(
            [*shlex.split(options.score), out, "--problem", name, "--format", "json"],
            capture_output=True,
            text=True,
            cwd=HERE.parents[1],
        )
    if scored.returncode:
        reason = scored.stderr.strip().rsplit(": ", 1)[-1]
        return failed(f"{taken['remark']} not scored: {reason}".strip())
    return row(json.loads(scored.stdout), taken)


def failed(reason):
    return ["–"] * 6 + [reason.replace("|", "/")]


def row(score, taken):
    velocity = (score["velocity"] or {}).get("max_error")
    return [
        str(score["samples"]),
        f"{score['position']['max_error']:.1e}",
        "–" if velocity is None else f"{velocity:.1e}",
        at_rest(score["rest"]),
        str(taken["work"]),
        f"{taken['wall']:.3g} s",
        taken["remark"].replace("|", "/"),
    ]


def at_rest(rest):
    if rest is None:
        return "never rests"
    if rest["sticks"] is None:
        return "too few samples"
    if rest["sticks"]:
        return "sticks"
    return f"moves: {rest['creep']:.1e} m/s, within {rest['range']:.1e} m"


def write(path, report):
    """Replaces what stands between the marks."""
    text = path.read_text()
    before, rest = text.split(BEGIN, 1)
    after = rest.split(END, 1)[1]
    path.write_text(f"{before}{BEGIN}\n\n{report}\n{END}{after}")


if __name__ == "__main__":
    main()
