# SPDX-License-Identifier: MIT
"""The constants of lib/math, computed from their formulas. The row above each function says where they stand."""

from fixel.prove.exact import Real, ceil, floor, nearest, pi, power_below, root


# [[row]]
# id = "2 pi"
# function = "lib/math/angle.c:TWO_PI_Q61"
# property = "it is the nearest integer"
# checks = 1
# text = ["#define TWO_PI_Q61 {}u"]
def two_pi():
    """2 pi in units of 2^-61."""
    return [nearest(2 * pi() * 2 ** 61)]


# [[row]]
# id = "divisors of the series"
# function = "lib/math/angle.c:factors"
# property = "they are 2k (2k + 1) and 2k (2k - 1)"
# checks = 11
# text = ["static const uint64_t factors[] = {BY({}), BY({}), BY({}), BY({}), BY({}), BY({}), BY({}), BY({}), BY({}), BY({}), BY({})};"]
def sine_divisors():
    """What the terms of the series are divided by, from the last: of the sine, then of the cosine."""
    return [2 * k * (2 * k + 1) for k in (5, 4, 3, 2, 1)] + [2 * k * (2 * k - 1) for k in (6, 5, 4, 3, 2, 1)]


def _omitted(power):
    """What the first omitted term is below at an eighth of a turn, as a power of 1/2."""
    term = Real(1)
    for k in range(1, power + 1):
        term = term * pi() / 4 / k
    return [power_below(term)]


# [[row]]
# id = "omitted terms of the sine"
# function = "lib/math/angle.c:factors"
# property = "they are below the stated power of 2"
# checks = 1
# text = ["x^13/13! < 2^-{} for x <= pi/4."]
def sine_omitted():
    return _omitted(13)


# [[row]]
# id = "omitted terms of the cosine"
# function = "lib/math/angle.c:factors"
# property = "they are below the stated power of 2"
# checks = 1
# text = ["x^14/14! < 2^-{} for x <= pi/4."]
def cosine_omitted():
    return _omitted(14)


# [[row]]
# id = "table of reciprocals, Armv6-M"
# function = "lib/math/core.h:fxl_reciprocals"
# property = "each entry is 2^23 / (2^15 + 2^9 i + 2^8), rounded"
# checks = 65
# text = ["static const uint8_t fxl_reciprocals[65] = {{*}}"]
def reciprocals():
    """Of the middles of 2^15 + 2^9 i, from i = 0 to 64."""
    return [nearest(Real(1 << 23, (1 << 15) + (i << 9) + (1 << 8))) for i in range(65)]


# [[row]]
# id = "zeros of four bits"
# function = "lib/math/core.h:fxl_leading_zeros"
# property = "the word has the count of zeros of each four bits"
# checks = 1
# text = ["({}u >> (value >> 28) * 4u & 15u)"]
def zeros_of_nibbles():
    """How many zeros 1 to 7 have in four bits: four bits for each."""
    return [sum((4 - n.bit_length()) << 4 * n for n in range(1, 8))]


# [[row]]
# id = "least and largest field of view"
# function = "lib/include/fixel/types.h:FXL_FOV_MIN"
# property = "they are 10 and 150 degrees, to the nearest unit"
# checks = 2
# text = ["#define FXL_FOV_MIN FXL_CAST(fxl_angle, {}u)", "#define FXL_FOV_MAX FXL_CAST(fxl_angle, {}u)"]
def fields_of_view():
    """10 and 150 degrees in units of 2^-32 turn, to the nearest."""
    return [floor(Real(degrees, 360) * 2 ** 32 + Real(1, 2)) for degrees in (10, 150)]


# [[row]]
# id = "largest radius"
# function = "lib/include/fixel/types.h:FXL_RADIUS_MAX"
# property = "it is the diagonal of twice the largest coordinate, rounded up to a unit"
# checks = 2
# text = ["#define FXL_RADIUS_MAX FXL_CAST(fxl_q16_16, {} * {})"]
def radius():
    """3^(1/2) times 2 8191 units, rounded up, in units of 2^-16."""
    return [ceil(root(Real(3)) * 2 * 8191), 2 ** 16]
