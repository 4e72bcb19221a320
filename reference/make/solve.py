"""Which route computes which problem, and what must agree before an answer counts."""

import gmpy2

from .chain import Chain
from .exact import Oscillator, binary, real
from .exponential_matrix import MatrixSwing, PowerChain
from .linear import ClosedSwing, GeometricChain
from .nonlinear import DragFreeSwing, TaylorSwing
from .stiff import SlowExponentialSwing, SlowManifoldSwing
from .weak_chain import MapChain

TOLERANCE = 1e-36
LINEAR_BITS, LINEAR_BITS_2 = 520, 480
NONLINEAR_BITS, NONLINEAR_BITS_2 = 300, 250
FEW = 400  # swings that may be followed one by one with matrix exponentials

METHODS = {
    "linear": "closed form of every swing; matrix exponentials, swing by swing",
    "linear-many": "closed form of swing number n; matrix powers",
    "series": "Taylor series of y; Taylor series with e^(-kappa y), other order and precision",
    "stiff": "slow manifold as a power series in y; as a series of exponentials in time",
    "map": "swing map as a power series, swing by swing; other order and precision, Abel function "
           "where only Newton friction acts",
}


class Problem:
    """Exact inputs of one problem, as the file gives them."""

    def __init__(self, fields):
        self.fields = fields
        self.osc = Oscillator.read(fields["oscillator"])
        self.x0 = binary(fields["release"]["position"])
        self.v0 = binary(fields["release"]["velocity"])
        self.stop_after = fields.get("stop_after")
        self.until = fields["until"]

    @property
    def kind(self):
        osc = self.osc
        if osc.newton == 0:
            return "linear-many" if self.fields.get("many") else "linear"
        if self.fields.get("many"):
            return "map"
        return "stiff" if osc.gamma ** 2 > 25 * osc.omega0_squared else "series"

    def bits(self, route):
        pair = (LINEAR_BITS, LINEAR_BITS_2) if self.osc.newton == 0 else (NONLINEAR_BITS, NONLINEAR_BITS_2)
        return pair[route]


def chain(problem, route, first=None):
    """The chain of swings by route 0 or 1; must be called and used at the route's precision."""
    osc, x0, v0 = problem.osc, problem.x0, problem.v0
    follow = lambda make: Chain(osc, x0, v0, make, real(problem.until), problem.stop_after)
    kind = problem.kind
    if kind in ("linear", "linear-many"):
        if route == 0 and osc.discriminant > 0:
            return GeometricChain(osc, x0, v0, real(problem.until), problem.stop_after)
        if kind == "linear-many":
            return PowerChain(osc, x0, v0, first.count)
        swing = (ClosedSwing, MatrixSwing)[route]
        return follow(lambda y, v: swing(osc, y, v))
    if kind == "map":
        return MapChain(osc, x0, v0, problem.fields["many"], turning_numbers, route)
    series = (TaylorSwing, DragFreeSwing)[route]
    if kind == "stiff" and (route == 0 or osc.gamma ** 2 > 2500 * osc.omega0_squared):
        layered = (SlowManifoldSwing, SlowExponentialSwing)[route]
        return follow(lambda y, v: stiff_swing(osc, y, v, series, layered))
    return follow(lambda y, v: series(osc, y, v))


def stiff_swing(osc, y, v, series, layered):
    swing = series(osc, y, v)
    return swing if swing.duration is not None else layered(osc, y, v)


def turning_numbers(count):
    """The first ten, a few between, and the last five."""
    chosen = set(range(1, min(count, 10) + 1)) | set(range(max(1, count - 4), count + 1))
    chosen |= {count * k // 4 for k in (1, 2, 3) if count >= 4}
    return sorted(chosen)


def answers(problem, chain, times):
    """Everything the file states, as high-precision numbers."""
    count = chain.count
    while count and not chain.rests and chain.turning(count)[0] > problem.until:
        count -= 1
    return {
        "turning": [(n, *chain.turning(n)) for n in chain.known_turnings(turning_numbers(count))],
        "rest": chain.rest(),
        "limit": chain.limit(),
        "samples": [chain.state(real(t)) for t in times],
    }


def disagreement(a, b):
    """Largest relative difference between two nested answers of the same shape."""
    if isinstance(a, dict):
        return max(disagreement(a[k], b[k]) for k in a)
    if isinstance(a, (list, tuple)):
        if len(a) != len(b):
            raise ArithmeticError("the routes found different events")
        return max((disagreement(p, q) for p, q in zip(a, b)), default=0.0)
    if a is None or b is None or isinstance(a, (int, str)):
        if a != b:
            raise ArithmeticError(f"the routes found {a} and {b}")
        return 0.0
    return 0.0 if a == b else float(abs(a - b) / max(abs(a), abs(b)))


def energy_defect(problem, samples):
    """How far kinetic + potential energy + heats is from the first energy, relative."""
    m, c = real(problem.osc.mass), real(problem.osc.stiffness)
    first = m * real(problem.v0) ** 2 / 2 + c * real(problem.x0) ** 2 / 2
    if first == 0:
        return 0.0
    return max(float(abs(m * v * v / 2 + c * x * x / 2 + sum(heats) - first) / first)
               for x, v, *heats in samples)


def first_integral_defect(problem, chain):
    """gamma = 0: one whole swing from rest against ln(1-2kb)+2kb = ln(1+2ka)-2ka and a quadrature."""
    osc = problem.osc
    if osc.newton == 0 or osc.damping != 0 or problem.kind != "series" or chain.count < 2:
        return 0.0
    swing, start, kappa = chain.swing(1), chain.start(1), real(osc.kappa)
    a, b = kappa * start.y, -kappa * swing.end
    turning = (gmpy2.log1p(-2 * b) + 2 * b) / (gmpy2.log1p(2 * a) - 2 * a) - 1
    duration = scaled_duration(a, b) / gmpy2.sqrt(real(osc.omega0_squared)) / swing.duration - 1
    return float(max(abs(turning), abs(duration)))


def scaled_duration(a, b, nodes=200):
    """Integral of du/|u'| from -b to a. With u = middle + half sin(theta) the integrand is smooth and
    periodic in theta, so that the midpoint rule converges exponentially."""
    middle, half, step = (a - b) / 2, (a + b) / 2, gmpy2.const_pi() / nodes
    total = real(0)
    for k in range(nodes):
        theta = (k + real(1) / 2) * step - gmpy2.const_pi() / 2
        u = middle + half * gmpy2.sin(theta)
        speed2 = u - a - (a + real(1) / 2) * gmpy2.expm1(2 * (u - a))
        total += half * gmpy2.cos(theta) / gmpy2.sqrt(speed2)
    return total * step
