# SPDX-License-Identifier: MIT
"""The second display, an SSD0303 on mps2-an385: the middle of the frame, dark and light."""

import types

import numpy
import pytest

from fixel.board import dump, emulator, grey, oled, session
from fixel.base.errors import ToolError
from screens import flashed, screen_after

BOARD = "mps2-an385"
DISPLAY = ("-device", "ssd0303,address=0x3d,id=small")
WIDTH, HEIGHT = 96, 16


@pytest.fixture(scope="module")
def plaza(tmp_path_factory):
    return flashed(BOARD, "plaza", tmp_path_factory.mktemp("plaza"))


@pytest.fixture(scope="module")
def odd(tmp_path_factory):
    """A frame with an odd number of rows and columns around the window."""
    return flashed(BOARD, "tiny", tmp_path_factory.mktemp("odd"), (129, 61))


@pytest.fixture(scope="module")
def exact(tmp_path_factory):
    return flashed(BOARD, "tiny", tmp_path_factory.mktemp("exact"), (WIDTH, HEIGHT))


def middle(frame):
    """The window of a frame that the display shows."""
    height, width = frame.shape
    top, left = (height - HEIGHT) // 2, (width - WIDTH) // 2
    return frame[top:top + HEIGHT, left:left + WIDTH]


@pytest.mark.parametrize("name, frames", [("plaza", 31), ("plaza", 46), ("odd", 5), ("odd", 16), ("exact", 9)])
def test_every_pixel_of_the_window(request, tmp_path, name, frames):
    scene = request.getfixturevalue(name)
    picture, drawn = screen_after(scene, frames, tmp_path, "small", DISPLAY)
    levels = oled.levels(picture, 1)
    whole = grey.levels(scene.host.frames[frames - 1].pixels, scene.host.palette, 1)
    assert levels.shape == (HEIGHT, WIDTH)
    assert (levels == middle(whole)).all()
    assert 0 < levels.sum() < levels.size
    assert (drawn.frames[-1].pixels == scene.host.frames[frames - 1].pixels).all()


def test_a_frame_that_is_smaller_is_not_for_it(tmp_path, tmp_path_factory):
    small = flashed(BOARD, "tiny", tmp_path_factory.mktemp("small"), (WIDTH, HEIGHT - 1))
    picture, drawn = screen_after(small, 2, tmp_path, "small", DISPLAY)
    assert not oled.levels(picture, 1).any()
    assert (drawn.frames[-1].pixels == small.host.frames[1].pixels).all()


def test_without_it_the_board_shows_the_rest(plaza, tmp_path):
    """Nobody acknowledges: the run goes on. What QEMU then calls its screen is a notice, and refused."""
    with pytest.raises(ToolError, match="board mps2-an385 has no screen"):
        screen_after(plaza, 2, tmp_path)
    drawn = dump.read_dump(tmp_path / emulator.DUMP_NAME)
    assert (drawn.frames[-1].pixels == plaza.host.frames[1].pixels).all()


def test_at_another_address_it_does_not_answer(exact, tmp_path):
    picture, drawn = screen_after(exact, 2, tmp_path, "small", ("-device", "ssd0303,address=0x3c,id=small"))
    assert not numpy.asarray(picture).any()
    assert len(drawn.frames) == 2


@pytest.mark.parametrize("kinds, shows", [
    ([("qemu-console", "/machine/oled")], True),                                        # QEMU 7.2
    ([("qemu-console", ""), ("qemu-console", "")], False),
    ([("qemu-fixed-text-console", None), ("qemu-graphic-console", "/machine/oled")], True),    # QEMU 10
    ([("qemu-fixed-text-console", None), ("qemu-text-console", None)], False),
])
def test_what_counts_as_a_screen(kinds, shows):
    """A console for text is none, and in QEMU 10 has no device to ask for."""
    def execute(command, path, **arguments):
        if command == "qom-list":
            return [{"name": "type", "type": "string"}] + \
                [{"name": f"console[{number}]", "type": f"child<{kind}>"} for number, (kind, _) in enumerate(kinds)]
        device = kinds[int(path.split("[")[1][:-1])][1]
        if device is None:
            raise ToolError(f"QEMU refuses '{command}': no property {arguments['property']}")
        return device

    machine = types.SimpleNamespace(machine=types.SimpleNamespace(execute=execute))
    assert session.Session._has_screen(machine) == shows
