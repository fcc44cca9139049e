# SPDX-License-Identifier: MIT
"""Pictures of emulated OLEDs as the levels of their pixels.

QEMU shows each pixel as a square of 4 x 4 and level n of 0..highest as the
grey n * 255 / highest. A picture that is anything else is not of an OLED.
"""

import numpy

from fixel.base.errors import ToolError

MAGNIFIED = 4


def levels(picture, highest):
    """Levels (height x width) of a picture (height x width x 3, uint8)."""
    height, width = picture.shape[0] // MAGNIFIED, picture.shape[1] // MAGNIFIED
    small = picture[::MAGNIFIED, ::MAGNIFIED, 0][:height, :width]
    whole = numpy.repeat(numpy.repeat(small, MAGNIFIED, 0), MAGNIFIED, 1)
    if whole.shape != picture.shape[:2] or (picture != whole[..., None]).any():
        raise ToolError("the picture of the screen is not made of grey squares of 4 x 4", exit_code=1)
    if (small % (255 // highest)).any():
        raise ToolError(f"the picture of the screen has greys that are none of its {highest + 1}", exit_code=1)
    return small // (255 // highest)
