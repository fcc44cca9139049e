# SPDX-License-Identifier: MIT
"""Numbers of a scene file as exact fractions, fractions as fixed point, and rotations of objects.

A number may be written as an integer, a decimal or a string such as "-360/512",
so that every rational can be said. Angles are degrees; "3/512 turn" is a part
of a full turn. Nothing passes through floating point."""

import functools
import math
import re
from decimal import Decimal, InvalidOperation
from fractions import Fraction

from fixel.base.errors import ToolError
from fixel.base.reading import quoted

Q16_ONE = 1 << 16
TURN = 1 << 32
COORDINATE_MAX = 8191

# Powers of ten outside this are a slip of the pen, and would make huge integers.
EXPONENT_MAX = 18
DIGITS_MAX = 24         # characters of a number

_RATIONAL = re.compile(r"\s*([+-]?\d{1,18})\s*/\s*(\d{1,18})\s*", re.ASCII)
_DECIMAL = re.compile(r"\s*[+-]?(\d{1,18}(\.\d{0,18})?|\.\d{1,18})([eE][+-]?\d{1,2})?\s*", re.ASCII)


def decimal(text):
    """A number of a TOML file; ValueError where it has too many digits or no exponent that there is."""
    if len(text) > DIGITS_MAX:
        raise ValueError("too many digits")
    try:
        return Decimal(text)
    except InvalidOperation:
        raise ValueError("no such exponent") from None


@functools.lru_cache(4096)
def _exact(value):
    """A Decimal or integer as a Fraction: the same object for most of the same number, which compares fast."""
    return Fraction(value)


def fraction(value, where):
    """A TOML number, or a string that says one, as a Fraction."""
    if isinstance(value, (bool, list, dict)) or value is None:
        raise ToolError(f'{where}: expected a number (like 1.5 or "3/512"), found {quoted(value)}')
    if isinstance(value, Fraction):
        return value
    if isinstance(value, str):
        rational = _RATIONAL.fullmatch(value)
        if rational and int(rational[2]) != 0:
            return Fraction(int(rational[1]), int(rational[2]))
        if not _DECIMAL.fullmatch(value):
            raise ToolError(f'{where}: {quoted(value)} is not a number (like "1.5" or "-360/512")')
        value = Decimal(value.strip())
    elif isinstance(value, float):
        value = Decimal(repr(value))
    if isinstance(value, Decimal):
        if not value.is_finite() or (value != 0 and abs(value.adjusted()) > EXPONENT_MAX):
            raise ToolError(f"{where}: {quoted(value)} is out of every range")
        return _exact(value)
    if isinstance(value, int):
        if abs(value) >= 10 ** EXPONENT_MAX:
            raise ToolError(f"{where}: the number is out of every range")
        return _exact(value)
    raise ToolError(f"{where}: expected a number, found {quoted(value)}")


def _times(value, numerator, denominator=1):
    """A Fraction or float times a ratio, to the nearest integer, halves upward: the rounding of SPEC.md."""
    above, below = value.as_integer_ratio()
    above, below = above * numerator, below * denominator
    return (2 * above + below) // (2 * below)


def q16(value):
    """A Fraction or float as 16.16."""
    return _times(value, Q16_ONE)


def q30(value):
    """A Fraction or float as 2.30."""
    return _times(value, 1 << 30)


def shown(value):
    """A Fraction for a message."""
    return f"{float(value):.10g}"


def in_range(value, low, high, where, unit=""):
    """The Fraction, if low <= value <= high."""
    if not low <= value <= high:
        unit = f" {unit}" if unit else ""
        raise ToolError(f"{where} = {shown(value)} is outside {shown(Fraction(low))}.."
                        f"{shown(Fraction(high))}{unit}")
    return value


def vector(value, where):
    """A list of three numbers."""
    if not isinstance(value, list) or len(value) != 3:
        raise ToolError(f"{where}: expected three numbers [x, y, z], found {quoted(value)}")
    return tuple(fraction(item, f"{where}[{i}]") for i, item in enumerate(value))


def position(value, where):
    """A point of the world, each coordinate within the range of SPEC.md, section 3."""
    point = vector(value, where)
    for i, item in enumerate(point):
        in_range(item, -COORDINATE_MAX, COORDINATE_MAX, f"{where}[{i}]", "world units")
    return point


def degrees(value, where):
    """An angle in degrees; a string may end in "turn"."""
    if isinstance(value, str) and value.strip().endswith("turn"):
        return 360 * fraction(value.strip()[:-4], where)
    return fraction(value, where)


def angle(value):
    """Degrees (a Fraction or float) as a binary angle; wraps."""
    return _times(value, TURN, 360) % TURN


_ONE = 1 << 52


def _sine_cosine(angle):
    """Sine and cosine of degrees in 2^-52; exact at quarter turns."""
    angle %= 360
    if angle % 90 == 0:
        quarter = int(angle // 90)
        return (0, _ONE, 0, -_ONE)[quarter], (_ONE, 0, -_ONE, 0)[quarter]
    radians = math.radians(float(angle))
    return round(math.sin(radians) * _ONE), round(math.cos(radians) * _ONE)


def sine_cosine(angle):
    """Sine and cosine of degrees; exact at quarter turns."""
    return tuple(Fraction(value, _ONE) for value in _sine_cosine(angle))


def product(a, b):
    """Of two matrices of 3x3."""
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def matrix(scale, rotation, quaternion=None):
    """Scale, then turn: an object turned by yaw, pitch and roll looks where a
    camera turned so would look. Its columns are the camera's rows (SPEC.md,
    section 1). A quaternion turns before the angles do."""
    factors = [s.as_integer_ratio() for s in scale]
    if quaternion:
        first = of_quaternion(*quaternion)
        return product(matrix((1, 1, 1), rotation), [[part * Fraction(*factor) for part, factor in zip(row, factors)] for row in first])
    (sy, cy), (sp, cp), (sr, cr) = map(_sine_cosine, rotation)
    # Integers in 2^-156 up to the last step: a Fraction takes ten times as long.
    right = (cr * cy * _ONE - sr * sp * sy, sr * cp * _ONE, -cr * sy * _ONE - sr * sp * cy)
    up = (-sr * cy * _ONE - cr * sp * sy, cr * cp * _ONE, sr * sy * _ONE - cr * sp * cy)
    forward = (cp * sy * _ONE, sp * _ONE * _ONE, cp * cy * _ONE)
    return [[Fraction(axis[row] * above, below * _ONE ** 3) for axis, (above, below) in zip((right, up, forward), factors)]
            for row in range(3)]


def of_quaternion(w, x, y, z):
    """The rows of the rotation that takes v to q v q*, exactly (docs/extras/orientation.md, 1.5)."""
    norm = Fraction(w * w + x * x + y * y + z * z)
    rows = ((w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z))
    return [[part / norm for part in row] for row in rows]
