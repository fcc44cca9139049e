# SPDX-License-Identifier: MIT
"""The OLEDs that QEMU shows: every pixel against the host's frames in the display's greys, which the library makes as the tools do."""

import ctypes
import subprocess
import types

import numpy
import pytest
from board_programs import flashed, screen_after

from conftest import CHECKOUT
from fixel.base.errors import ToolError
from fixel.board import dump, emulator, grey, session

BUILT_PROGRAMS = ()


# --- lm3s6965evb: 128x64, 16 greys --------------------------------------------------

LARGE = "lm3s6965evb"
HIGHEST = 15
SIZE = (128, 64)


@pytest.fixture(scope="module")
def tiny(tmp_path_factory):
    return flashed(LARGE, "tiny", tmp_path_factory.mktemp("tiny"))


@pytest.fixture(scope="module")
def large_plaza(tmp_path_factory):
    return flashed(LARGE, "plaza", tmp_path_factory.mktemp("plaza"), SIZE)


def assert_shown(scene, frames, folder):
    """After so many frames the screen shows the last of the host's, in its 16 greys."""
    picture, dump = screen_after(scene, frames, folder)
    for drawn, expected in zip(dump.frames, scene.host.frames):
        assert (drawn.pixels == expected.pixels).all()
    levels = grey.levels_of_screen(picture, HIGHEST)
    assert levels.shape == (SIZE[1], SIZE[0])
    expected = grey.levels(scene.host.frames[frames - 1].pixels, scene.host.palette, HIGHEST)
    differ = numpy.argwhere(levels != expected)
    assert not len(differ), f"{len(differ)} pixels, the first at row, column {differ[0]}"
    return levels


@pytest.mark.parametrize("frames", (1, 6, 11, 16))
def test_every_pixel_of_tiny(tiny, tmp_path, frames):
    assert_shown(tiny, frames, tmp_path)


@pytest.mark.parametrize("frames", (1, 46, 106))
def test_every_pixel_of_the_plaza(large_plaza, tmp_path, frames):
    levels = assert_shown(large_plaza, frames, tmp_path)
    assert len(numpy.unique(levels)) > 8     # the test is worth little on a few greys


def test_frames_of_another_size_are_not_for_it(tmp_path, tmp_path_factory):
    """The run goes on without the screen, which nobody has touched."""
    wide = flashed(LARGE, "tiny", tmp_path_factory.mktemp("wide"), (128, 65))
    picture, dump = screen_after(wide, 2, tmp_path)
    assert len(dump.frames) == 2
    assert (dump.frames[1].pixels == wide.host.frames[1].pixels).all()
    assert not grey.levels_of_screen(picture, HIGHEST).any()


def test_what_is_no_picture_of_an_oled_is_refused():
    picture = numpy.zeros((256, 512, 3), numpy.uint8)
    picture[4:8, 8:12] = 34
    assert grey.levels_of_screen(picture, HIGHEST)[1, 2] == 2
    for change, words in ((lambda p: p.__setitem__((5, 9), 17), "squares"),
                          (lambda p: p.__setitem__((slice(4, 8), slice(8, 12), 2), 17), "squares"),
                          (lambda p: p.__setitem__((slice(0, 4), slice(0, 4)), 18), "none of its 16")):
        broken = picture.copy()
        change(broken)
        with pytest.raises(ToolError, match=words):
            grey.levels_of_screen(broken, HIGHEST)
    with pytest.raises(ToolError, match="squares"):
        grey.levels_of_screen(picture[:-1], HIGHEST)


# --- an SSD0303 on mps2-an385: the middle of the frame, dark and light --------------

SMALL = "mps2-an385"
DISPLAY = ("-device", "ssd0303,address=0x3d,id=small")
WIDTH, HEIGHT = 96, 16


@pytest.fixture(scope="module")
def plaza(tmp_path_factory):
    return flashed(SMALL, "plaza", tmp_path_factory.mktemp("plaza"))


@pytest.fixture(scope="module")
def odd(tmp_path_factory):
    """A frame with an odd number of rows and columns around the window."""
    return flashed(SMALL, "tiny", tmp_path_factory.mktemp("odd"), (129, 61))


@pytest.fixture(scope="module")
def exact(tmp_path_factory):
    return flashed(SMALL, "tiny", tmp_path_factory.mktemp("exact"), (WIDTH, HEIGHT))


def middle(frame):
    """The window of a frame that the display shows."""
    height, width = frame.shape
    top, left = (height - HEIGHT) // 2, (width - WIDTH) // 2
    return frame[top:top + HEIGHT, left:left + WIDTH]


@pytest.mark.parametrize("name, frames", [("plaza", 31), ("plaza", 46), ("odd", 5), ("odd", 16), ("exact", 9)])
def test_every_pixel_of_the_window(request, tmp_path, name, frames):
    scene = request.getfixturevalue(name)
    picture, drawn = screen_after(scene, frames, tmp_path, "small", DISPLAY)
    levels = grey.levels_of_screen(picture, 1)
    whole = grey.levels(scene.host.frames[frames - 1].pixels, scene.host.palette, 1)
    assert levels.shape == (HEIGHT, WIDTH)
    assert (levels == middle(whole)).all()
    assert 0 < levels.sum() < levels.size
    assert (drawn.frames[-1].pixels == scene.host.frames[frames - 1].pixels).all()


def test_a_frame_that_is_smaller_is_not_for_it(tmp_path, tmp_path_factory):
    small = flashed(SMALL, "tiny", tmp_path_factory.mktemp("small"), (WIDTH, HEIGHT - 1))
    picture, drawn = screen_after(small, 2, tmp_path, "small", DISPLAY)
    assert not grey.levels_of_screen(picture, 1).any()
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


# --- greys --------------------------------------------------------------------------

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
