"""Makes stiff_swings.csv: single swings under strong Stokes and Newton friction, to 25 digits.

    y'' = -y - 2 zeta y' + kappa y'^2        (dimensionless time tau, canonical direction y' <= 0)

Two methods at 60 digits, neither of which the Rust code uses:

* Taylor series of order 70 in tau, steps of three fifths of what the last terms allow; for zeta <= 30 all the way.
* For zeta >= 100, as soon as the fast transient has fallen below 1e-50: the slow manifold. With sigma = tau/(2 zeta),
  V = dy/dsigma and epsilon = 1/(4 zeta^2) the equation is V = -y + kappa epsilon V^2 - epsilon dV/dsigma, and
  iterating it on a Taylor series in sigma gains a factor of about epsilon each time.

Where both apply (zeta = 100, until sigma = 0.05) they are compared, and must agree to 40 digits.
A line is zeta, kappa, y0, w0, kind, tau, y, w; kind is `at` or `reversal`; inputs (and tau of `at`) are the doubles
next to the decimals. Run: python stiff_swings.py > stiff_swings.csv (mpmath, better with gmpy2; half a minute).
"""

import sys

from mpmath import mp, mpf, nstr

mp.dps = 60
ORDER = 70
SLOW_TERMS, SLOW_ROUNDS = 45, 16


def series(zeta, kappa, y0, w0):
    """Taylor coefficients of y and w in tau."""
    y, w = [y0], [w0]
    for k in range(ORDER):
        square = 2 * mp.fdot((w[i], w[k - i]) for i in range((k + 1) // 2))
        if k % 2 == 0:
            square += w[k // 2] ** 2
        y.append(w[k] / (k + 1))
        w.append((-y[k] - 2 * zeta * w[k] + kappa * square) / (k + 1))
    return y, w


def value(coefficients, x):
    return mp.polyval(coefficients[::-1], x)


def slope(coefficients, x):
    return value([k * c for k, c in enumerate(coefficients)][1:], x)


def allowed_step(y, w):
    """The step after which the terms have fallen to 1e-55 of the largest coefficient's part."""
    scale = max(abs(y[0]), abs(w[0]), mpf(10) ** -30)
    last = max(max(abs(c[k]) ** (mpf(1) / k) for k in range(ORDER - 3, ORDER + 1)) for c in (y, w))
    return (scale * mpf(10) ** -55) ** (mpf(1) / ORDER) / last


def slow_series(zeta, kappa, y0):
    """Taylor coefficients of y and V in sigma on the slow manifold."""
    epsilon = 1 / (4 * zeta**2)
    length = SLOW_TERMS + SLOW_ROUNDS
    upper = [mpf(0)] * (length + 1)
    for _ in range(SLOW_ROUNDS):
        length -= 1
        y, v = [y0], []
        for k in range(length):
            # V_k itself stands on both sides: (V^2)_k = 2 V_0 V_k + known, V_0 by a quadratic equation.
            rest = -y[k] - epsilon * (k + 1) * upper[k + 1]
            a = kappa * epsilon
            if k == 0:
                v.append(2 * rest / (1 + mp.sqrt(1 - 4 * a * rest)))
            else:
                rest += a * mp.fsum(v[i] * v[k - i] for i in range(1, k))
                v.append(rest / (1 - 2 * a * v[0]))
            y.append(v[k] / (k + 1))
        upper = v + [mpf(0)]
    return y[:SLOW_TERMS], v[:SLOW_TERMS]


def swing(zeta, kappa, y0, w0, times, brute=False):
    """Rows (kind, tau, y, w) at the times, ending at a reversal if there is one."""
    zeta, kappa, y, w = map(mpf, (zeta, kappa, y0, w0))
    tau, rows, pending = mpf(0), [], [mpf(t) for t in times]
    slow = False
    while pending:
        if not slow and not brute and zeta >= 100 and tau > 60 / zeta:
            manifold = slow_series(zeta, kappa, y)[1][0] / (2 * zeta)
            slow = abs(w - manifold) < mpf(10) ** -50
        if slow:
            ys, vs = slow_series(zeta, kappa, y)
            ws = [c / (2 * zeta) for c in vs]
            unit, step = 2 * zeta, 2 * zeta / mpf(10)
        else:
            ys, ws = series(zeta, kappa, y, w)
            unit, step = mpf(1), allowed_step(ys, ws) * 3 / 5
        end = value(ws, step / unit)
        if end > 0:
            assert not slow
            root = mp.findroot(lambda x: value(ws, x), (step / 2, step / 2 * mpf("1.01")))
            assert 0 <= root <= step and abs(value(ws, root)) < mpf(10) ** -45
            step = root
        while pending and pending[0] <= tau + step:
            x = (pending.pop(0) - tau) / unit
            rows.append(("at", tau + x * unit, value(ys, x), value(ws, x)))
        tau, y, w = tau + step, value(ys, step / unit), value(ws, step / unit)
        if end > 0:
            rows.append(("reversal", tau, y, mpf(0)))
            break
    return rows


CASES = [
    # zeta, kappa, y0, w0
    (3, 0.001, 1, 0), (3, 1, 1, 0), (3, 1000, 1, 0),
    (5, 0.1, 1, 0), (10, 10, 1, 0), (10, 1000, 1, 0), (30, 100, 1, 0),
    (100, 1000, 1, 0), (100, 1, 1, 0), (1000, 10, 1, 0), (1000, 1000, 1, 0),
    (10000, 0.001, 1, 0), (10000, 0.1, 1, 0), (10000, 1000, 1, 0),
    (3, 1, 1, -1000), (3, 1, 1, -5), (3, 1, -1, -1000), (3, 1, 0, -1000), (3, 1000, -1, -0.00001),
    (10, 1, -1000, -1), (10, 0.1, 1, -100), (100, 0.5, 0.25, -60), (100, 0.1, -1, -0.01), (1000, 1, 0, -1000),
    (10000, 1, 1, -1000), (10000, 10, -0.001, -100), (10000, 1, -1, -1e-9), (5, 1000, 0.01, -1),
    (5, 0.0025, 0.1, -1.087), (200, 5e-7, 20, -9396),
]


def times(zeta, kappa, y0, w0):
    fast = 2 * zeta + kappa * abs(w0) + (kappa * abs(y0)) ** 0.5
    slow = 2 * zeta + (kappa * abs(y0)) ** 0.5
    return [f / fast for f in (0.3, 1.7, 6.0)] + [f * slow for f in (0.01, 0.3, 2.0, 9.0)]


def check():
    args = (100, 20, 1, 0, [2.0, 10.0])
    for (_, _, y, w), (_, _, yb, wb) in zip(swing(*args), swing(*args, brute=True)):
        assert abs(y / yb - 1) < mpf(10) ** -40 and abs(w / wb - 1) < mpf(10) ** -40, (y, yb, w, wb)


if __name__ == "__main__":
    check()
    print("zeta,kappa,y0,w0,kind,tau,y,w")
    for case in CASES:
        zeta, kappa, y0, w0 = case
        for kind, tau, y, w in swing(zeta, kappa, y0, w0, sorted(float(t) for t in times(*case))):
            stamp = repr(float(tau)) if kind == "at" else nstr(tau, 25)
            print(zeta, kappa, y0, w0, kind, stamp, nstr(y, 25), nstr(w, 25), sep=",")
        print(case, file=sys.stderr)
