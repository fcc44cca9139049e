# SPDX-License-Identifier: MIT
"""Greys: what tools/fixel/board/grey.py says, and that the library says the same."""

import ctypes
import subprocess

import numpy
import pytest

from conftest import CHECKOUT
from fixel.board import grey

PALETTE = numpy.random.default_rng(9).integers(0, 256, (256, 3), dtype=numpy.uint8)
EVEN = numpy.repeat(numpy.arange(256, dtype=numpy.uint8)[:, None], 3, 1)


def test_the_matrix():
    matrix = grey.matrix()
    assert sorted(matrix.ravel()) == list(range(64))
    assert list(matrix[0]) == [0, 32, 8, 40, 2, 34, 10, 42]     # as docs/formats.md has it


def test_luma():
    colours = numpy.array([[255, 255, 255], [0, 0, 0], [255, 0, 0], [0, 255, 0], [0, 0, 255], [1, 0, 4]])
    assert list(grey.luma(colours)) == [255, 0, 54, 182, 19, 1]
    assert list(grey.luma(EVEN)) == list(range(256))


@pytest.mark.parametrize("colour, highest, lighter", [
    (0, 15, 0), (17, 15, 0), (255, 15, 0),      # levels themselves
    (1, 15, 4), (9, 15, 34), (16, 15, 60),      # 64 * 1/17 = 3.8; 64 * 9/17 = 33.9; 60.2
    (64, 1, 16), (127, 1, 32), (254, 1, 64)])   # 16.06; 31.9; 63.7
def test_how_many_of_64_pixels_show_the_lighter_level(colour, highest, lighter):
    pixels = numpy.full((8, 8), colour, numpy.uint8)
    levels = grey.levels(pixels, EVEN, highest)
    assert (levels != colour * highest // 255).sum() == lighter


def test_a_frame_that_is_no_multiple_of_the_matrix():
    pixels = numpy.full((11, 13), 100, numpy.uint8)
    levels = grey.levels(pixels, EVEN, 15)
    assert levels.shape == (11, 13)
    assert (levels[8:, :8] == levels[:3, :8]).all() and (levels[:, 8:] == levels[:, :5]).all()


@pytest.fixture(scope="module")
def part(tmp_path_factory):
    """The library's, for the host."""
    library = tmp_path_factory.mktemp("grey") / "grey.so"
    subprocess.run(["gcc", "-std=c11", "-shared", "-fPIC", "-Ilib/include", "lib/screen/grey.c", "-o", library],
                   cwd=CHECKOUT, check=True)
    return ctypes.CDLL(str(library))


@pytest.mark.parametrize("highest", (1, 3, 15, 63, 255))
@pytest.mark.parametrize("palette", (EVEN, PALETTE), ids=("even", "random"))
def test_the_library_says_the_same_of_every_colour_at_every_place(part, palette, highest):
    table = (ctypes.c_uint16 * 256)()
    part.fxl_grey_table(table, palette.tobytes(), highest)
    part.fxl_grey_level.restype = ctypes.c_uint8
    for colour in range(256):
        expected = grey.levels(numpy.full((8, 8), colour, numpy.uint8), palette, highest)
        found = [[part.fxl_grey_level(ctypes.c_uint16(table[colour]), x, y) for x in range(8)] for y in range(8)]
        assert (expected == found).all(), colour
