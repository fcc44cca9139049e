# SPDX-License-Identifier: MIT
"""The constants of lib/screen, computed from their formulas. The row above each function says where they stand."""

from fixel.prove.exact import Real, nearest


# [[row]]
# id = "weights of luma"
# function = "lib/screen/grey.c:fxl_luma"
# property = "they are those of Rec. 709"
# checks = 3
# text = ["#define WEIGHT_RED {}u", "#define WEIGHT_GREEN {}u", "#define WEIGHT_BLUE {}u"]
def weights():
    """Rec. 709 in 256ths: red and green are rounded to nearest, and blue is the rest."""
    red, green = nearest(Real(2126, 10000) * 256), nearest(Real(7152, 10000) * 256)
    return [red, green, 256 - red - green]


# [[row]]
# id = "pattern of dither"
# function = "lib/screen/grey.c:offsets"
# property = "it is the ordered square of 8 x 8"
# checks = 64
# text = ["static const uint8_t offsets[8][8] = {{*}}"]
def dither():
    """The ordered square of 8 x 8: the bits of x xor y and of y alternate, from the lowest on."""
    def number(x, y):
        return sum(((x ^ y) >> k & 1) << (5 - 2 * k) | (y >> k & 1) << (4 - 2 * k) for k in range(3))
    return [number(x, y) for y in range(8) for x in range(8)]


# [[row]]
# id = "channels as bytes"
# function = "lib/screen/grey.c:fxl_grey_of_rgb565"
# property = "their factors and offsets are the least that give 255 c / 31 and 255 c / 63, rounded, by a shift of 6"
# checks = 6
# text = ["(red * {}u + {}u) >> 6", "(green * {}u + {}u) >> 6", "(blue * {}u + {}u) >> 6"]
def channels_to_bytes():
    """The least multiplier, for each shift of 6, whose sums give 255 c / 31 and 255 c / 63 to nearest: with the least offset."""
    def least(highest, shift):
        wanted = [nearest(Real(255 * c, highest)) for c in range(highest + 1)]
        for factor in range((wanted[-1] << shift) // highest, 1024):
            for offset in range(1 << shift):
                if all((c * factor + offset) >> shift == wanted[c] for c in range(highest + 1)):
                    return [factor, offset]
        return []
    return [*least(31, 6), *least(63, 6), *least(31, 6)]
