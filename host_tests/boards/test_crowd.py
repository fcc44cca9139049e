# SPDX-License-Identifier: MIT
"""The example that puts up cubes at run time draws the picture of docs/extras/world.md."""

import numpy
from conftest import CHECKOUT
from PIL import Image

from fixel.report import examples


def test_the_crowd_is_that_of_the_document(build):
    pixels, palette = examples.draw_example(build / "host" / "libfixel.a", "crowd")
    shown = numpy.array(Image.open(CHECKOUT / "docs" / "world.png").convert("RGB"))
    assert len(numpy.unique(pixels)) > 100
    assert numpy.array_equal(palette[pixels], shown)
