# SPDX-License-Identifier: MIT
"""The OLED of lm3s6965evb, as QEMU shows it, pixel for pixel against the host's frames."""

import numpy
import pytest

from fixel.board import grey, oled
from fixel.base.errors import ToolError
from screens import flashed, screen_after

BOARD = "lm3s6965evb"
HIGHEST = 15
SIZE = (128, 64)


@pytest.fixture(scope="module")
def tiny(tmp_path_factory):
    return flashed(BOARD, "tiny", tmp_path_factory.mktemp("tiny"))


@pytest.fixture(scope="module")
def plaza(tmp_path_factory):
    return flashed(BOARD, "plaza", tmp_path_factory.mktemp("plaza"), SIZE)


def assert_shown(scene, frames, folder):
    """After so many frames the screen shows the last of the host's, in its 16 greys."""
    picture, dump = screen_after(scene, frames, folder)
    for drawn, expected in zip(dump.frames, scene.host.frames):
        assert (drawn.pixels == expected.pixels).all()
    levels = oled.levels(picture, HIGHEST)
    assert levels.shape == (SIZE[1], SIZE[0])
    expected = grey.levels(scene.host.frames[frames - 1].pixels, scene.host.palette, HIGHEST)
    differ = numpy.argwhere(levels != expected)
    assert not len(differ), f"{len(differ)} pixels, the first at row, column {differ[0]}"
    return levels


@pytest.mark.parametrize("frames", (1, 6, 11, 16))
def test_every_pixel_of_tiny(tiny, tmp_path, frames):
    assert_shown(tiny, frames, tmp_path)


@pytest.mark.parametrize("frames", (1, 46, 106))
def test_every_pixel_of_the_plaza(plaza, tmp_path, frames):
    levels = assert_shown(plaza, frames, tmp_path)
    assert len(numpy.unique(levels)) > 8     # the test is worth little on a few greys


def test_frames_of_another_size_are_not_for_it(tmp_path, tmp_path_factory):
    """The run goes on without the screen, which nobody has touched."""
    wide = flashed(BOARD, "tiny", tmp_path_factory.mktemp("wide"), (128, 65))
    picture, dump = screen_after(wide, 2, tmp_path)
    assert len(dump.frames) == 2
    assert (dump.frames[1].pixels == wide.host.frames[1].pixels).all()
    assert not oled.levels(picture, HIGHEST).any()


def test_what_is_no_picture_of_an_oled_is_refused():
    picture = numpy.zeros((256, 512, 3), numpy.uint8)
    picture[4:8, 8:12] = 34
    assert oled.levels(picture, HIGHEST)[1, 2] == 2
    for change, words in ((lambda p: p.__setitem__((5, 9), 17), "squares"),
                          (lambda p: p.__setitem__((slice(4, 8), slice(8, 12), 2), 17), "squares"),
                          (lambda p: p.__setitem__((slice(0, 4), slice(0, 4)), 18), "none of its 16")):
        broken = picture.copy()
        change(broken)
        with pytest.raises(ToolError, match=words):
            oled.levels(broken, HIGHEST)
    with pytest.raises(ToolError, match="squares"):
        oled.levels(picture[:-1], HIGHEST)
