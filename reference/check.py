"""Quick check of the reference files: `python check.py` (needs requirements.txt).

1. every file obeys schema.json; names are unique; inputs are shortest binary64 strings;
2. in every sample of every problem kinetic + potential energy + heats is the energy of the release;
3. turning points, rest and samples of one problem do not contradict each other;
4. turning amplitudes that were printed before these files existed come out;
5. a few problems of each mix, drawn by a seed, are computed anew and must come out the same.
"""

import argparse
import json
import random
import sys
import time
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import jsonschema

from make.__main__ import compute
from make.exact import binary, shortest
from make.problems import MIXES, all_problems

HERE = Path(__file__).parent


# |x_1|, |x_2|, |x_3| and the rest (time, |position|, swings) for omega0 = 1, x0 = 1.
PRINTED = {
    "unit-n-kappa-0.1": (("0.8821899862473064", "0.7892403202894020", "0.7140265200811302"), None),
    "unit-n-kappa-1": (("0.4107196860610394", "0.2635683864175969", "0.1945658418739881"), None),
    "unit-cn-kappa-0.1": (("0.8465939158375397", "0.7244557418629591", "0.6239247416523626"),
                          ("47.14016236047838", "0.0141985129411459", 15)),
    "unit-sc-kappa-0": (("0.8173785351466213", "0.6613343568555475", "0.5279996166152029"),
                        ("31.45527022888002", "0.0054923105462090", 10)),
    "unit-sn-kappa-0.1": (("0.7597890119430565", "0.5931441144323207", "0.4720232562450404"), None),
    "unit-scn-kappa-0.1": (("0.7262577931039454", "0.5347443098023209", "0.3933958086431348"),
                           ("28.34342065441714", "0.0160770688577614", 9)),
    "laboratory-scn": ((), ("12.9156488513554", "0.000289166337655", 26)),
}


def number(text):
    return Fraction(Decimal(text))


def load():
    schema = jsonschema.Draft202012Validator(json.loads((HERE / "schema.json").read_text("utf-8")))
    problems = {}
    for mix in MIXES:
        data = json.loads((HERE / f"{mix}.json").read_text("utf-8"))
        schema.validate(data)
        assert data["mix"] == mix
        for problem in data["problems"]:
            assert problem["name"] not in problems, f"{problem['name']} occurs twice"
            problems[problem["name"]] = problem
    return problems


def check_inputs(problem):
    inputs = [*problem["oscillator"].values(), *problem["release"].values()]
    for text in inputs + [s["time"] for s in problem["samples"]]:
        assert text == shortest(text), f"{text} is not the shortest string of its binary64 number"


def check_energy(problem):
    m, c = (binary(problem["oscillator"][key]) for key in ("mass", "stiffness"))
    energy = lambda x, v: (m * v * v + c * x * x) / 2
    first = energy(*(binary(problem["release"][key]) for key in ("position", "velocity")))
    for sample in problem["samples"]:
        heats = sum(number(sample[key]) for key in sample if key.startswith("heat"))
        now = energy(number(sample["position"]), number(sample["velocity"])) + heats
        assert abs(now - first) <= first / 10 ** 34, f"energy is lost at t = {sample['time']}"


def check_rest(problem):
    turning, rest = problem["turning_points"], problem["rest"]
    times = [number(t["time"]) for t in turning]
    assert times == sorted(times)
    if rest is None:
        return
    if rest["swings"]:
        last = turning[-1]
        assert (last["index"], last["time"], last["position"]) == (rest["swings"], rest["time"], rest["position"])
    for sample in problem["samples"]:
        if binary(sample["time"]) > number(rest["time"]):
            assert sample["position"] == rest["position"] and sample["velocity"] == "0"


def check_printed(problems):
    close = lambda text, printed: abs(abs(number(text)) - number(printed)) < Fraction(1, 10 ** 13)
    for name, (amplitudes, rest) in PRINTED.items():
        problem = problems[name]
        for point, printed in zip(problem["turning_points"], amplitudes):
            assert close(point["position"], printed), f"{name}: turning point {point['index']}"
        if rest:
            found = problem["rest"]
            assert found["swings"] == rest[2] and close(found["position"], rest[1]), name
            assert close(found["time"], rest[0]), f"{name}: rest"


def recompute(problems, seconds, seed):
    """Problems in random order, one of each mix after the other, until the time is used up."""
    source, begin, done = random.Random(seed), time.time(), 0
    queues = {mix: [] for mix in MIXES}
    for fields in all_problems():
        queues[fields["mix"]].append(fields)
    for queue in queues.values():
        source.shuffle(queue)
    while time.time() - begin < seconds and any(queues.values()):
        for queue in filter(None, queues.values()):
            fields = queue.pop()
            if fields.get("many") and fields["mix"] == "newton":
                continue  # two million swings, too long for a quick check
            entry, _ = compute(fields)
            assert entry == problems[fields["name"]], f"{fields['name']} comes out differently"
            done += 1
    return done


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=25, help="time for computing problems anew")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    problems = load()
    assert set(problems) == {p["name"] for p in all_problems()}, "files and script list different problems"
    for name, problem in problems.items():
        try:
            check_inputs(problem)
            check_energy(problem)
            check_rest(problem)
        except AssertionError as error:
            sys.exit(f"{name}: {error}")
    check_printed(problems)
    done = recompute(problems, options.seconds, options.seed)
    print(f"{len(problems)} problems are consistent; {done} computed anew, all equal")


if __name__ == "__main__":
    main()
