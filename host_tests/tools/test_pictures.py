# SPDX-License-Identifier: MIT
"""Pictures of frames: colours, animations, what a comparison shows, and how a recording is played."""

import io
import types

import numpy
import pytest
from PIL import Image

import warm_start
from board_programs import ROOT
from conftest import TOOLS, dump_bytes, environment
from fixel.base import picture
from fixel.base.errors import ToolError
from fixel.report import pictures
from fixel.view import record
from viewers import plaza_image, ready, ready_board  # noqa: F401, fixtures

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "host/live")
PALETTE = numpy.array([[number, 255 - number, 7] for number in range(256)], dtype=numpy.uint8)


def noise(height, width, seed=1):
    return numpy.random.default_rng(seed).integers(0, 256, (height, width), dtype=numpy.uint8)


def test_each_channel_of_rgb565_is_rounded_to_nearest():
    colours = picture.rgb565_colours()
    assert colours.shape == (65536, 3)
    for channel, (shift, most) in enumerate(((11, 31), (5, 63), (0, 31))):
        for value in range(most + 1):
            alone = colours[value << shift]
            assert alone[channel] == int(255 * value / most + 0.5)
            assert [alone[other] for other in range(3) if other != channel] == [0, 0]
    assert colours[0xFFFF].tolist() == [255, 255, 255]


def test_an_animation_has_each_frame_for_as_long_and_does_not_end():
    frames = [noise(9, 12, seed) for seed in range(3)]
    with Image.open(io.BytesIO(picture.animation_bytes(frames, PALETTE, 50))) as opened:
        assert (opened.n_frames, opened.size, opened.info["loop"]) == (3, (12, 9), 0)
        for number, frame in enumerate(frames):
            opened.seek(number)
            assert opened.info["duration"] == 50
            assert (numpy.asarray(opened.convert("RGB")) == PALETTE[frame]).all()


def test_a_png_has_the_indices_and_the_palette():
    frame = noise(5, 8)
    with Image.open(io.BytesIO(picture.png_bytes(picture.palette_image(frame, PALETTE)))) as opened:
        assert opened.mode == "P" and (numpy.asarray(opened) == frame).all()
        assert (numpy.asarray(opened.convert("RGB")) == picture.as_rgb(frame, PALETTE)).all()


def test_what_differs_is_marked_on_grey_with_a_ring_about_it():
    colours = numpy.full((9, 11, 3), (30, 60, 90), numpy.uint8)
    differs = numpy.zeros((9, 11), bool)
    differs[4, 5] = True
    panel = picture.difference_panel(colours, differs, 3)
    for y in range(9):
        for x in range(11):
            away = max(abs(y - 4), abs(x - 5))
            wanted = {0: picture.MARK, 3: picture.RING}.get(away, (41, 41, 41))     # 60 * 0.35 + 20
            assert tuple(panel[y, x]) == wanted, (x, y)
    assert not (picture.difference_panel(colours, differs) == picture.RING).all(axis=2).any()


def test_a_ring_stops_at_the_border():
    differs = numpy.zeros((6, 6), bool)
    differs[0, 5] = True
    panel = picture.difference_panel(numpy.zeros((6, 6, 3), numpy.uint8), differs, 3)
    ring = (panel == picture.RING).all(axis=2)
    assert {(int(y), int(x)) for y, x in zip(*numpy.nonzero(ring))} == {(3, 2), (3, 3), (3, 4), (3, 5), (0, 2), (1, 2), (2, 2)}


@pytest.mark.parametrize("width, scale", [(48, 2), (120, 5)])
def test_a_comparison_shows_both_and_the_difference_and_enlarges_where_they_differ(width, scale):
    height, gap, caption = 32, picture.GAP, picture.CAPTION
    a = PALETTE[noise(height, width)]
    b = a.copy()
    b[10, 20] = (1, 2, 3)
    differs = (a != b).any(axis=2)
    sheet = numpy.asarray(picture.side_by_side(a, b, differs, ["one", "two"]))
    y0, y1, x0, x1 = picture.differing_region(differs)
    enlarged = 24 * scale
    assert sheet.shape == (gap + height + caption + gap + enlarged + caption + gap, gap + 3 * (max(width, enlarged) + gap), 3)
    difference = picture.difference_panel(a, differs, picture.RING_DISTANCE)
    for number, wanted in enumerate((a, b, difference)):
        left = gap + number * (width + gap)
        assert (sheet[gap + caption:gap + caption + height, left:left + width] == wanted).all()
    top = gap + height + 2 * caption + gap
    for number, wanted in enumerate((a, b, picture.difference_panel(a, differs))):
        left = gap + number * (enlarged + gap)
        found = sheet[top:top + enlarged, left:left + enlarged]
        for y, x in ((0, 0), (0, scale - 1), (scale - 1, 0)):       # each pixel is a square
            assert (found[y::scale, x::scale] == wanted[y0:y1, x0:x1]).all()
    assert (sheet[:gap] == picture.PAPER).all() and (sheet[-gap:] == picture.PAPER).all()
    assert (sheet[:, :gap] == picture.PAPER).all()


def test_equal_or_small_frames_are_not_enlarged():
    a = PALETTE[noise(32, 48)]
    same = numpy.zeros((32, 48), bool)
    assert picture.side_by_side(a, a, same, ["a", "b"]).size == (picture.GAP + 3 * (48 + picture.GAP), 2 * picture.GAP + picture.CAPTION + 32)
    for height, rows in ((15, 1), (16, 2)):
        small = PALETTE[noise(height, 48)]
        differs = numpy.ones((height, 48), bool)
        enlarged = (rows - 1) * (2 * height + picture.CAPTION + picture.GAP)
        assert picture.side_by_side(small, small, differs, ["a", "b"]).size[1] == 2 * picture.GAP + picture.CAPTION + height + enlarged


def test_frames_stand_side_by_side_with_white_between_them(tmp_path):
    drawn = [noise(6, 10, seed) % 3 for seed in range(3)]
    (tmp_path / "a.fxld").write_bytes(dump_bytes(drawn, PALETTE.tobytes()))
    words = ["--dumps", *[str(tmp_path / "a.fxld")] * 2, "--out", str(tmp_path / "row.png"), "--frames"]
    assert pictures.main([*words, "2,0"]) == 0
    with Image.open(tmp_path / "row.png") as opened:
        row = numpy.asarray(opened.convert("RGB"))
    gap = pictures.GAP
    assert row.shape == (6, 2 * 10 + gap, 3)
    assert (row[:, :10] == PALETTE[drawn[2]]).all() and (row[:, 10 + gap:] == PALETTE[drawn[0]]).all()
    assert (row[:, 10:10 + gap] == 255).all()
    with pytest.raises(ToolError, match="a number for each of --dumps"):
        pictures.main([*words, "2"])


def test_a_recording_holds_keys_down_until_it_lets_them_go():
    said = []
    keyboard = types.SimpleNamespace(**{name: lambda key, name=name: said.append((name, key)) for name in ("down", "up", "press")})
    record.play(types.SimpleNamespace(keyboard=keyboard), ["+w", "2", "-w"])
    assert said == [("down", "w"), ("press", "2"), ("up", "w")]


# The command with a small window and one format, a small one: pictures of the whole window and their colours take most of
# its time.
SMALL_RECORDING = """import sys
sys.path.insert(0, {tools!r})
from fixel import launcher
from fixel.base.errors import run_main
from fixel.view import record
record.WIDTH, record.HEIGHT, record.FORMATS = 640, 400, [(240, 30)]
run_main(launcher.main)
"""


def test_the_recording(scene, build, tmp_path):
    ready("mps2-an385", build)
    file = tmp_path / "window.webp"
    words = ["record", "--board", "mps2-an385", "--scene", scene, "--build", build, "--out", file]
    done = warm_start.run(["fixel", *map(str, words)], ROOT, environment(), SMALL_RECORDING.format(tools=str(TOOLS)))
    assert done.returncode == 0, done.stderr
    with Image.open(file) as recording:
        frames = []
        for number in range(recording.n_frames):
            recording.seek(number)
            frames.append(numpy.asarray(recording.convert("RGB")))
    assert len(frames) >= 10 and file.stat().st_size < 1.5e6     # a slow machine draws fewer in the time of the walk
    changes = [numpy.mean((one != other).any(axis=2)) for one, other in zip(frames, frames[1:])]
    assert numpy.mean(numpy.array(changes) > 0.01) > 0.7    # it walks most of the time


def test_a_recording_of_much_change_is_made_smaller_until_it_fits(monkeypatch):
    monkeypatch.setattr(record, "FORMATS", [(60, 90), (40, 60), (20, 1)])
    monkeypatch.setattr(record, "SIZE_MAX", 4000)
    noise = numpy.random.default_rng(1)

    def width(side, count):
        shots = []
        for _ in range(count):
            block = io.BytesIO()
            Image.fromarray(noise.integers(0, 256, (side, side, 3), dtype=numpy.uint8)).save(block, "PNG")
            shots.append(block.getvalue())
        data = record.fitting(shots, [100] * count)
        with Image.open(io.BytesIO(data)) as animation:
            assert len(data) <= record.SIZE_MAX
            return animation.width

    assert width(1, 2) == 60 and width(60, 2) < 60
    with pytest.raises(ToolError, match="the smallest recording takes .* bytes; 4,000 are allowed"):
        width(60, 200)
