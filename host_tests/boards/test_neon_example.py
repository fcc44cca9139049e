# SPDX-License-Identifier: MIT
"""examples/neon: a wall of bricks, glass and a lamp in 16 bits a pixel, as docs/extras/rgb565.md shows it."""

import subprocess

import numpy
from conftest import CHECKOUT
from PIL import Image

from fixel.base import picture
from fixel.report import examples

NEON = CHECKOUT / "examples" / "neon" / "main.c"


def test_the_picture_is_that_of_the_document(build):
    pixels = examples.draw_wide(build / "host" / "libfixel.a", "neon")
    shown = numpy.array(Image.open(CHECKOUT / "docs" / "neon.png").convert("RGB"))
    assert len(numpy.unique(pixels)) > 256  # more than a palette has
    assert numpy.array_equal(picture.as_rgb(pixels, picture.rgb565_colours()), shown)


def test_a_channel_of_a_picture_is_rounded_to_nearest():
    image = picture.as_rgb(numpy.array([[0xFFFF, 0, 1 << 11 | 1 << 5 | 1, 16 << 11 | 32 << 5 | 16]], "<u2"), picture.rgb565_colours())
    assert image.tolist() == [[[255, 255, 255], [0, 0, 0], [8, 4, 8], [132, 130, 132]]]


def test_it_compiles_for_a_small_core(tmp_path):
    subprocess.run(["arm-none-eabi-gcc", "-mcpu=cortex-m0", "-mthumb", "-std=c11", "-O2", "-Wall", "-Wextra", "-Werror", "-c",
                    f"-I{CHECKOUT / 'lib' / 'include'}", str(NEON)], cwd=tmp_path, check=True)


def test_it_is_as_short_as_it_says():
    lines = NEON.read_text(encoding="utf-8").splitlines()
    assert len([line for line in lines if line.strip() and not line.startswith("/*")]) == 68
