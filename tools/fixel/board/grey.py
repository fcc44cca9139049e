# SPDX-License-Identifier: MIT
"""What a display of few greys must show of a frame: written from docs/formats.md, section 4, alone. And what an emulated OLED shows.

The library's own is lib/screen/grey.c; neither was made from the other. QEMU shows each pixel of an OLED as a square of 4 x 4, and
level n of 0..highest as the grey n * 255 / highest. A picture that is anything else is not of an OLED.
"""

import numpy

from fixel.base.errors import ToolError

SIZE = 8    # rows and columns of the dither matrix
WEIGHTS = (54, 183, 19)
MAGNIFIED = 4


def matrix():
    """B(x, y) of docs/formats.md as an array B[y, x]."""
    y, x = numpy.indices((SIZE, SIZE))
    total = numpy.zeros((SIZE, SIZE), numpy.int64)
    for k in range(3):
        x_bit, y_bit = (x >> k) & 1, (y >> k) & 1
        total += 4 ** (2 - k) * (2 * (x_bit ^ y_bit) + y_bit)
    return total


def luma(palette):
    """Y of each entry of a palette (256 x 3)."""
    return (palette.astype(numpy.int64) @ WEIGHTS + 128) // 256


def levels(pixels, palette, highest):
    """Levels 0..highest of a frame of palette indices, an array of the same shape."""
    height, width = pixels.shape
    repeats = (-(-height // SIZE), -(-width // SIZE))
    threshold = 2 * numpy.tile(matrix(), repeats)[:height, :width] + 1     # in 128ths
    whole, rest = numpy.divmod(highest * luma(palette)[pixels], 255)
    return (whole + (rest * 128 > threshold * 255)).astype(numpy.uint8)


def levels_of_screen(picture, highest):
    """Levels (height x width) of a picture (height x width x 3, uint8)."""
    height, width = picture.shape[0] // MAGNIFIED, picture.shape[1] // MAGNIFIED
    small = picture[::MAGNIFIED, ::MAGNIFIED, 0][:height, :width]
    whole = numpy.repeat(numpy.repeat(small, MAGNIFIED, 0), MAGNIFIED, 1)
    if whole.shape != picture.shape[:2] or (picture != whole[..., None]).any():
        raise ToolError("the picture of the screen is not made of grey squares of 4 x 4", exit_code=1)
    if (small % (255 // highest)).any():
        raise ToolError(f"the picture of the screen has greys that are none of its {highest + 1}", exit_code=1)
    return small // (255 // highest)
