# SPDX-License-Identifier: MIT
"""What a display of few greys must show of a frame: written from docs/formats.md, section 4, alone.

The library's own is lib/screen/grey.c; neither was made from the other.
"""

import numpy

SIZE = 8    # rows and columns of the dither matrix
WEIGHTS = (54, 183, 19)


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
