"""SciPy told what stands in a textbook: friction against sign(v), with sign(0) = 0, and no sticking."""

import time

from scipy.integrate import DOP853, LSODA, Radau

from problem import sign

METHODS = {"DOP853": DOP853, "LSODA": LSODA, "Radau": Radau}
RTOL, ATOL = 1e-9, 1e-12


def solve(problem, method, limit):
    """Steps to the end or until `limit` seconds are over, and reads the dense output."""
    work = 0

    def rate(_time, state):
        nonlocal work
        work += 1
        x, v = state
        return [v, problem.rate(x, v, sign(v))]

    begun = time.perf_counter()
    start = [problem.position, problem.velocity]
    solver = METHODS[method](rate, 0.0, start, problem.duration, rtol=RTOL, atol=ATOL)
    rows = [(0.0, *start)]
    waiting = iter(problem.times[1:])
    following = next(waiting)
    remark = ""
    while solver.status == "running" and following is not None:
        message = solver.step()
        if solver.status == "failed":
            remark = f"failed at {solver.t:.9g} s: {message}"
            break
        dense = None
        while following is not None and following <= solver.t:
            dense = dense or solver.dense_output()
            rows.append((following, *map(float, dense(following))))
            following = next(waiting, None)
        if time.perf_counter() - begun > limit:
            remark = f"gave up after {limit:g} s, at {solver.t:.9g} s"
            break
    return rows, work, remark
