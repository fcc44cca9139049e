# SPDX-License-Identifier: MIT
"""The constants of lib/view, computed from their formulas. The row above each function says where they stand."""

from fixel.prove.exact import Real, floor, root


# [[row]]
# id = "half of a root"
# function = "lib/view/off_centre.c:ROOT_HALF"
# property = "it is 2^30 / 2^(1/2), less 1"
# checks = 1
# text = ["#define ROOT_HALF {}"]
def root_half():
    """2^30 / 2^(1/2), rounded downward, less 1."""
    return [floor(2 ** 30 / root(Real(2))) - 1]


# [[row]]
# id = "gaps of the sort"
# function = "lib/view/order.c:fxl_sort_instances"
# property = "they are Sedgewick's"
# checks = 8
# text = ["static const uint16_t gaps[] = {{*}}"]
def gaps():
    """Sedgewick's: 4^k + 3 2^(k-1) + 1, and 1."""
    return [4 ** k + 3 * 2 ** (k - 1) + 1 for k in range(7, 0, -1)] + [1]
