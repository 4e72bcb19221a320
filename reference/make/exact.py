"""Inputs: binary64 numbers read exactly, and the coefficients reduced from them."""

from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction

import gmpy2


@contextmanager
def precision(bits):
    """All arithmetic inside works with that many bits."""
    with gmpy2.context(gmpy2.get_context(), precision=bits):
        yield


def real(value):
    """A rational number (or one of another precision) rounded once to the working precision."""
    if isinstance(value, Fraction):
        return gmpy2.mpfr(gmpy2.mpq(value.numerator, value.denominator))
    return gmpy2.mpfr(value)


def shortest(number):
    """The shortest decimal string that reads back as the same binary64 number."""
    text = repr(float(number))
    return text[:-2] if text.endswith(".0") else text


def binary(text):
    """The exact value of the binary64 number that the string denotes."""
    return Fraction(float(text))


@dataclass(frozen=True)
class Oscillator:
    """Exact rational parameters. `reading` turns a decimal string into a rational: `binary`
    for every answer, `Fraction` only where a tie is decided in decimals."""

    mass: Fraction
    stiffness: Fraction
    damping: Fraction
    kinetic_force: Fraction
    static_force: Fraction
    newton: Fraction

    @classmethod
    def read(cls, fields, reading=binary):
        get = lambda key: reading(fields[key]) if key in fields else Fraction(0)
        normal = get("normal_force") if "normal_force" in fields else get("mass") * get("gravity")
        kinetic = get("kinetic")
        static = get("static") if "static" in fields else kinetic
        return cls(get("mass"), get("stiffness"), get("damping"),
                   kinetic * normal, static * normal, get("newton_coefficient"))

    @property
    def omega0_squared(self):
        return self.stiffness / self.mass

    @property
    def gamma(self):
        return self.damping / (2 * self.mass)

    @property
    def kappa(self):
        return self.newton / self.mass

    @property
    def offset(self):
        return self.kinetic_force / self.stiffness

    @property
    def band(self):
        return self.static_force / self.stiffness

    @property
    def discriminant(self):
        """omega0^2 - gamma^2; its sign is the regime and is exact here."""
        return self.omega0_squared - self.gamma ** 2
