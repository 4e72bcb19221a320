"""The Rust crates that `benches/` runs, by the program `samples` there; they take a setting, their name."""

import subprocess
from pathlib import Path

BENCHES = Path(__file__).resolve().parents[1]


def solve(problem, setting, limit):
    """Rows (t, x), the work, which the crates do not all tell, and a remark."""
    command = ["cargo", "run", "-q", "--release", "--bin", "samples", "--", setting, problem.name]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit, cwd=BENCHES)
    except subprocess.TimeoutExpired:
        return [], "–", f"gave up after {limit:g} s"
    if done.returncode:
        return [], "–", "failed: " + " ".join(done.stderr.split())
    lines = done.stdout.splitlines()[1:]
    return [tuple(map(float, line.split(","))) for line in lines], "–", ""
