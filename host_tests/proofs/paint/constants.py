# SPDX-License-Identifier: MIT
"""The constants of lib/paint, computed from their formulas. The row above each function says where they stand."""

from fixel.prove.exact import Real, ceil, nearest, root


# [[row]]
# id = "table of roots"
# function = "lib/paint/light_level.c:root_reciprocal"
# property = "each entry is the mean of 2^23 / value^(1/2) at both ends of its 2^25, rounded"
# checks = 96
# text = ["static const uint8_t roots[96] = {{*}}"]
def roots():
    """2^23 divided by the root of the value, at both ends of each 2^25 of it, from 2^30 to 2^32: the mean of the two."""
    ends = [2 ** 23 / root(Real(i) * 2 ** 25) for i in range(32, 129)]
    return [nearest((one + other) / 2) for one, other in zip(ends, ends[1:])]


# [[row]]
# id = "parts of the largest weight"
# function = "lib/paint/corner_gradients.c:find_least"
# property = "they are 9 2^11 2^(k/3), rounded up"
# checks = 7
# text = ["static const uint32_t parts[7] = {{*}}"]
def weight_parts():
    """9 2^11 2^(k/3), rounded up, for k from 0."""
    return [ceil(9 * 2 ** 11 * root(Real(2 ** k), 3)) for k in range(7)]


# [[row]]
# id = "ratio of the twist"
# function = "lib/paint/corner_gradients.c:find_least"
# property = "it is (16/15) (64/27) in 2^-30, rounded up, and a unit more"
# checks = 1
# text = ["{}u) + /* (16/15) (64/27) in 2^-30, and a unit */"]
def product_of_ratio():
    """(16/15) (64/27) in units of 2^-30, rounded up, and a unit more."""
    return [ceil(Real(16 * 64, 15 * 27) * 2 ** 30) + 1]


# [[row]]
# id = "tangent of the cube root"
# function = "lib/paint/corner_gradients.c:find_least"
# property = "they are its slope and its value at 0, rounded up"
# checks = 2
# text = ["(x * {}u >> 15) + {}u;"]
def tangent_of_cube_root():
    """The tangent at 2^(1/2): its change in units of 2^-16, and its value at 0, each rounded up."""
    at = root(Real(2), 6)
    return [ceil(2 ** 16 / (3 * at ** 2)), ceil(2 ** 16 * at * Real(2, 3))]


# [[row]]
# id = "least weight of 4"
# function = "lib/paint/gradients.c:find_least_weights"
# property = "it is 64 16^(-1/3), rounded up"
# checks = 1
# text = ["power_up(times_part(root, {}u), root_exponent - 6);"]
def bend_of_4():
    """64 16^(-1/3) in units of 2^-16, rounded up."""
    return [ceil(64 * 2 ** 16 / root(Real(16), 3))]


# [[row]]
# id = "least weights of 8"
# function = "lib/paint/gradients.c:fxl_find_least_weights"
# property = "they are at least 4^(-1/3), 2^(1/2) and 2^(2/3)"
# checks = 3
# text = [
#     "by_16 = times_part(of_16, {}u), by_4 = times_part(of_4, {}u);",
#     "times_part(of_4, {}u) : by_16",
# ]
def weights_of_8():
    """The decimals of the comment, which are above 4^(-1/3), 2^(1/2) and 2^(2/3) by less than 10^-4, in units of 2^-16, rounded
    up."""
    stated = {"0.62997": 1 / root(Real(4), 3), "1.41423": root(Real(2)), "1.58746": root(Real(4), 3)}
    assert all(0 < Real(words) - exact < Real(1, 10 ** 4) for words, exact in stated.items())
    return [ceil(Real(words) * 2 ** 16) for words in stated]


# place stipple: definition: the numbers of the pattern, by their bits
# [[row]]
# id = "pattern of opacities"
# function = "lib/paint/texel_place.h:fxl_is_stippled_away"
# property = "it is the ordered square of 4 x 4"
# checks = 16
# text = ["static const uint8_t stipple[16] = {{*}}"]
def stipple():
    """The square of 4 x 4 by bits: those of x and y alternate, from the lowest on, the first one xor y."""
    return [((x ^ y) & 1) << 3 | (y & 1) << 2 | ((x ^ y) & 2) | (y & 2) >> 1 for y in range(4) for x in range(4)]


# [[row]]
# id = "channels of RGB565"
# function = "lib/paint/rgb565_colour.h:fxl_blend_spread_565"
# property = "they are 5, 6 and 5 bits, and green is above in a word"
# checks = 4
# text = [
#     "#define FXL_RED_565 {}u",
#     "#define FXL_GREEN_565 {}u",
#     "#define FXL_BLUE_565 {}u",
#     "#define FXL_SPREAD_565 {}u",
# ]
def spread():
    """The channels of RGB565, and where a word has them: green in the upper half, the others in the lower."""
    red, green, blue = 31 << 11, 63 << 5, 31
    return [red, green, blue, green << 16 | red | blue]


# [[row]]
# id = "ends of channels of RGB565"
# function = "lib/paint/rgb565_colour.h:fxl_add_565"
# property = "they are the lowest and the highest bits of the channels of two colours"
# checks = 2
# text = [
#     "#define FXL_LOWEST_565  {}u",
#     "#define FXL_HIGHEST_565 {}u",
# ]
def ends():
    """The bits of one colour, in both halves of a word."""
    return [(1 << 11 | 1 << 5 | 1) * 65537, (1 << 15 | 1 << 10 | 1 << 4) * 65537]
