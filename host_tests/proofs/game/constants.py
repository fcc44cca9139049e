# SPDX-License-Identifier: MIT
"""The constants of lib/game, computed from their formulas. The row above each function says where they stand."""

from fixel.prove.exact import Real, arctangent, ceil, nearest, pi, root

TURNS = 36


# [[row]]
# id = "angles of halved tangents"
# function = "lib/game/player.c:halved_tangents"
# property = "each is the nearest integer"
# checks = 36
# text = ["static const int64_t halved_tangents[] = {{*}}"]
def halved_tangents():
    """The angles whose tangents are 1, 1/2, 1/4 and so on, in units of 2^-44 turn."""
    return [nearest(arctangent(Real(1, 2 ** k)) / (2 * pi()) * 2 ** 44) for k in range(TURNS)]


# [[row]]
# id = "growth of a turned vector"
# function = "lib/game/player.c:direction_of"
# property = "the stated factor is above that of all turns"
# checks = 1
# text = ["of {} in all, so components"]
def growth():
    """By how much all turns make a vector longer: three decimals, rounded up."""
    product = Real(1)
    for k in range(TURNS):
        product *= root(1 + Real(1, 4 ** k))
    return [ceil(product * 1000) / 1000]
