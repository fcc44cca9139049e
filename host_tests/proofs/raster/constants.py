# SPDX-License-Identifier: MIT
"""The constants of lib/raster, computed from their formulas. The row above each function says where they stand."""

from fixel.prove.exact import Real, nearest


# [[row]]
# id = "table of an edge, Armv6-M"
# function = "lib/raster/edge_divide.h:fxl_edge_reciprocals"
# property = "each entry is 2^15 / (i + 1/2), rounded"
# checks = 128
# text = ["static const uint8_t fxl_edge_reciprocals[128] = {{*}}"]

# [[row]]
# id = "table of an edge, assembly of Armv6-M"
# function = "lib/raster/edge_near_armv6m.S:reciprocals"
# property = "it is the same table"
# checks = 128
# text = ["reciprocals:{.byte}"]
def reciprocals():
    """Of i + 1/2, from i = 128 to 255."""
    return [nearest(Real(1 << 16, 2 * i + 1)) for i in range(128, 256)]
