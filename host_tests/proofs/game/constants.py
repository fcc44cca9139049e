# SPDX-License-Identifier: MIT
"""The constants of lib/game, computed from their formulas. The rows of constants.toml say where each stands."""

from fixel.prove.exact import Real, arctangent, ceil, nearest, pi, root

TURNS = 36


def halved_tangents():
    """The angles whose tangents are 1, 1/2, 1/4 and so on, in units of 2^-44 turn."""
    return [nearest(arctangent(Real(1, 2 ** k)) / (2 * pi()) * 2 ** 44) for k in range(TURNS)]


def growth():
    """By how much all turns make a vector longer: three decimals, rounded up."""
    product = Real(1)
    for k in range(TURNS):
        product *= root(1 + Real(1, 4 ** k))
    return [ceil(product * 1000) / 1000]
