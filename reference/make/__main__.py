"""Compute every problem twice and write the files: `python -m make` inside `reference/`.

`python -m make NAME...` computes the named problems only and prints how far the routes agree."""

import json
import sys
import time
from decimal import Context, Decimal
from pathlib import Path

from .exact import precision
from .problems import MIXES, all_problems
from .solve import (METHODS, TOLERANCE, Problem, answers, chain, disagreement, energy_defect,
                    first_integral_defect)
from .times import sample_times

DIGITS = 36
EXACT = Context(prec=DIGITS)
LAWS = ("stokes", "coulomb", "newton")
NARROWEST_MARGIN = 1e-9  # of a decision between sticking and going on, unless it is a tie


def decimal(number):
    """A high-precision number as a decimal string of DIGITS significant digits."""
    if number == 0:
        return "0"
    # A context of its own: the usual one would cut the result to 28 digits.
    return str(Decimal(f"{number:.{DIGITS - 1}e}").normalize(EXACT)).replace("E", "e")


def compute(fields):
    """(entry of the file, largest disagreement)."""
    problem = Problem(fields)
    with precision(problem.bits(0)):
        first = chain(problem, 0)
        times = sample_times(fields["name"], first, problem.until, fields.get("logarithmic"))
        one = answers(problem, first, [float(t) for t in times])
        worst = max(energy_defect(problem, one["samples"]), first_integral_defect(problem, first))
        check_margin(fields, first)
        entry = describe(fields, problem, times, one)
    with precision(problem.bits(1)):
        two = answers(problem, chain(problem, 1, first), [float(t) for t in times])
    worst = max(worst, disagreement(one, two))
    if not worst <= TOLERANCE:
        raise ArithmeticError(f"{fields['name']}: routes differ by {worst:.1e}")
    return entry, worst


def check_margin(fields, solved):
    if solved.margin is not None and solved.margin < NARROWEST_MARGIN and not fields.get("edge"):
        raise ArithmeticError(f"{fields['name']}: too close to the band's edge, {float(solved.margin):.1e}")


def describe(fields, problem, times, answer):
    laws = fields["mix"].split("-")
    samples = []
    for t, (x, v, *heats) in zip(times, answer["samples"]):
        sample = {"time": t, "position": decimal(x), "velocity": decimal(v)}
        sample |= {f"heat_{law}": decimal(h) for law, h in zip(LAWS, heats) if law in laws}
        samples.append(sample)
    rest = answer["rest"]
    entry = {key: fields[key] for key in ("name", "corner", "description", "oscillator", "release")}
    if "swings_strict" in fields:
        entry |= {"tie": True, "swings_strict": fields["swings_strict"]}
    return entry | {
        "samples": samples,
        "turning_points": [{"index": n, "time": decimal(t), "position": decimal(x)}
                           for n, t, x in answer["turning"]],
        "rest": rest and {"time": decimal(rest[0]), "position": decimal(rest[1]), "swings": rest[2]},
        "limit": None if answer["limit"] is None else decimal(answer["limit"]),
        "digits": DIGITS,
        "method": METHODS[problem.kind],
    }


def write(mix, entries):
    data = {"schema": {"name": "federpendel-reference", "version": 1}, "mix": mix, "problems": entries}
    path = Path(__file__).parent.parent / f"{mix}.json"
    path.write_text(json.dumps(data, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def main(names):
    entries, failed, begin = {mix: [] for mix in MIXES}, [], time.time()
    for fields in all_problems():
        if names and fields["name"] not in names:
            continue
        start = time.time()
        try:
            entry, worst = compute(fields)
        except ArithmeticError as error:
            failed.append(str(error))
            print("FAILED", error, file=sys.stderr)
            continue
        entries[fields["mix"]].append(entry)
        print(f"{worst:8.1e} {time.time() - start:6.1f} s  {fields['name']}")
    if failed:
        sys.exit(f"{len(failed)} problems failed; nothing written")
    if not names:
        for mix, problems in entries.items():
            write(mix, problems)
    print(f"{sum(map(len, entries.values()))} problems in {time.time() - begin:.0f} s")


if __name__ == "__main__":
    main(sys.argv[1:])
