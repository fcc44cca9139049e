# SPDX-License-Identifier: MIT
"""The constants of lib/math, computed from their formulas. The rows of constants.toml say where each stands."""

from fixel.prove.exact import Real, ceil, floor, nearest, pi, power_below, root


def two_pi():
    """2 pi in units of 2^-61."""
    return [nearest(2 * pi() * 2 ** 61)]


def sine_divisors():
    """What the terms of the series are divided by, from the last: of the sine, then of the cosine."""
    return [2 * k * (2 * k + 1) for k in (5, 4, 3, 2, 1)] + [2 * k * (2 * k - 1) for k in (6, 5, 4, 3, 2, 1)]


def _omitted(power):
    """What the first omitted term is below at an eighth of a turn, as a power of 1/2."""
    term = Real(1)
    for k in range(1, power + 1):
        term = term * pi() / 4 / k
    return [power_below(term)]


def sine_omitted():
    return _omitted(13)


def cosine_omitted():
    return _omitted(14)


def reciprocals():
    """Of the middles of 2^15 + 2^9 i, from i = 0 to 64."""
    return [nearest(Real(1 << 23, (1 << 15) + (i << 9) + (1 << 8))) for i in range(65)]


def zeros_of_nibbles():
    """How many zeros 1 to 7 have in four bits: four bits for each."""
    return [sum((4 - n.bit_length()) << 4 * n for n in range(1, 8))]


def fields_of_view():
    """10 and 150 degrees in units of 2^-32 turn, to the nearest."""
    return [floor(Real(degrees, 360) * 2 ** 32 + Real(1, 2)) for degrees in (10, 150)]


def radius():
    """3^(1/2) times 2 8191 units, rounded up, in units of 2^-16."""
    return [ceil(root(Real(3)) * 2 * 8191), 2 ** 16]
