# SPDX-License-Identifier: MIT
"""The constants of lib/raster, computed from their formulas. The rows of constants.toml say where each stands."""

from fixel.prove.exact import Real, nearest


def reciprocals():
    """Of i + 1/2, from i = 128 to 255."""
    return [nearest(Real(1 << 16, 2 * i + 1)) for i in range(128, 256)]
