# SPDX-License-Identifier: MIT
"""examples/crate: a crate with a texture, which turns by a lamp, as docs/extras/surfaces.md shows it."""

import subprocess

import numpy
from conftest import CHECKOUT
from PIL import Image

from fixel.report import examples


def test_the_crate_is_that_of_the_document(build):
    pixels, palette = examples.draw_example(build / "host" / "libfixel.a", "crate")
    shown = numpy.array(Image.open(CHECKOUT / "docs" / "crate.png").convert("RGB"))
    assert len(numpy.unique(pixels)) > 20  # grain and light
    assert numpy.array_equal(palette[pixels], shown)


def test_it_compiles_for_a_small_core(tmp_path):
    examples.write_scene(tmp_path)
    subprocess.run(["arm-none-eabi-gcc", "-mcpu=cortex-m0", "-mthumb", "-std=c11", "-Wall", "-Wextra", "-Werror", "-c",
                    f"-I{CHECKOUT / 'lib' / 'include'}", f"-I{tmp_path}", str(examples.CRATE)], cwd=tmp_path,
                   check=True)


def test_it_is_as_short_as_it_says():
    lines = examples.CRATE.read_text(encoding="utf-8").splitlines()
    assert len([line for line in lines if line.strip() and not line.startswith("/*")]) == 50
