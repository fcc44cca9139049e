# SPDX-License-Identifier: MIT
"""The constants of lib/view, computed from their formulas. The rows of constants.toml say where each stands."""

from fixel.prove.exact import Real, floor, root


def root_half():
    """2^30 / 2^(1/2), rounded downward, less 1."""
    return [floor(2 ** 30 / root(Real(2))) - 1]


def gaps():
    """Sedgewick's: 4^k + 3 2^(k-1) + 1, and 1."""
    return [4 ** k + 3 * 2 ** (k - 1) + 1 for k in range(7, 0, -1)] + [1]
