"""SciPy told the physics: one direction at a time, up to the event v = 0, where the mass sticks or
turns back."""

import bisect
import time

from scipy.integrate import solve_ivp

from problem import sign
from scipy_textbook import ATOL, RTOL


def solve(problem, method, limit):
    """Goes from reversal to reversal."""
    work = 0
    begun = time.perf_counter()
    now, x, v = 0.0, problem.position, problem.velocity
    rows = [(now, x, v)]
    while now < problem.duration:
        if v == 0.0 and problem.sticks(x):
            rows += [(later, x, 0.0) for later in after(problem.times, now)]
            break
        direction = sign(v) or -sign(x)

        def rate(_time, state):
            nonlocal work
            work += 1
            return [state[1], problem.rate(state[0], state[1], direction)]

        def reversal(_time, state):
            return state[1]

        reversal.terminal = True
        reversal.direction = -direction
        found = solve_ivp(
            rate,
            (now, problem.duration),
            [x, v],
            method=method,
            t_eval=after(problem.times, now),
            events=reversal,
            rtol=RTOL,
            atol=ATOL,
        )
        rows += [tuple(map(float, row)) for row in zip(found.t, *found.y)]
        if found.status == -1:
            return rows, work, f"failed: {found.message}"
        if found.status == 0:
            break
        now, x, v = float(found.t_events[0][0]), float(found.y_events[0][0][0]), 0.0
        if time.perf_counter() - begun > limit:
            return rows, work, f"gave up after {limit:g} s, at {now:.9g} s"
    return rows, work, ""


def after(times, now):
    """Those of `times`, which rise, that are later than `now`."""
    return times[bisect.bisect_right(times, now):]
