# SPDX-License-Identifier: MIT
"""make compare and fixel compare: the three exits, tolerance, JSON, pictures."""

import json
import os
import struct
import zlib

import numpy
import pytest
from conftest import assert_one_sentence, dump_bytes, random_frames, run_cli, run_make
from PIL import Image
from test_input_bounds import run_bounded

from fixel.report import compare as comparison
from fixel.base import picture
from fixel.base.errors import ToolError

BUILT_PROGRAMS = ()
GREY = bytes(value for entry in range(256) for value in (entry, entry, entry))


def save(path, array):
    Image.fromarray(array).save(path)
    return path


@pytest.fixture
def pictures(tmp_path):
    """a.png; b.png, of which 6 pixels differ by 4; c.png, of another size."""
    a = numpy.random.default_rng(3).integers(10, 200, (20, 30, 3), dtype=numpy.uint8)
    b = a.copy()
    b[5:7, 10:13, 1] += 4
    return {name: save(tmp_path / f"{name}.png", array)
            for name, array in (("a", a), ("b", b), ("c", a[:10]))}


@pytest.fixture
def folders(tmp_path):
    """A dump of three frames, a folder of the same as PNGs, and a folder where frame 1 differs."""
    frames = random_frames(3)
    dump = tmp_path / "board.fxld"
    dump.write_bytes(dump_bytes(frames, GREY))
    same, other = tmp_path / "same", tmp_path / "other"
    for folder in (same, other):
        folder.mkdir()
        for number, frame in enumerate(frames):
            save(folder / f"frame_{number:04d}.png", frame)
    altered = frames[1].copy()
    altered[3, 4] ^= 1
    save(other / "frame_0001.png", altered)
    return {"dump": dump, "same": same, "other": other}


def compare(a, b, *more):
    return run_cli("compare", "--a", a, "--b", b, *more)


def test_equal(pictures):
    done = compare(pictures["a"], pictures["a"])
    assert done.returncode == 0
    assert "equal: 1 of 1 frames equal, 0 of 600 pixels differ, tolerance 0" in done.stdout


def test_different(pictures):
    done = compare(pictures["a"], pictures["b"])
    assert done.returncode == 1
    assert "different: 0 of 1 frames equal, 6 of 600 pixels differ" in done.stdout


@pytest.mark.parametrize("tolerance, code", [(0, 1), (3, 1), (4, 0), (255, 0)])
def test_tolerance_is_the_largest_difference_that_is_equal(pictures, tolerance, code):
    assert compare(pictures["a"], pictures["b"], "--tolerance", tolerance).returncode == code


@pytest.mark.parametrize("tolerance", ["-1", "256", "x", "1.5", ""])
def test_tolerance_that_is_none(pictures, tolerance):
    assert_one_sentence(compare(pictures["a"], pictures["a"], "--tolerance", tolerance), "TOLERANCE")


def test_json(pictures):
    result = json.loads(compare(pictures["a"], pictures["b"], "--json").stdout)
    assert (result["equal"], result["pixels_differing"], result["largest_difference"]) == (False, 6, 4)


def test_folder_dump_and_png_mix(folders):
    assert compare(folders["dump"], folders["same"]).returncode == 0
    assert compare(folders["dump"], folders["other"]).returncode == 1
    assert compare(folders["same"], folders["other"]).returncode == 1
    assert compare(folders["dump"], folders["dump"]).returncode == 0


def test_pictures_show_where(folders, tmp_path):
    out = tmp_path / "result"
    compare(folders["same"], folders["other"], "--out", out)
    assert sorted(file.name for file in out.iterdir()) == ["compare.json", "frame_0001_diff.png"]
    with Image.open(out / "frame_0001_diff.png") as sheet:
        marked = (numpy.asarray(sheet.convert("RGB")) == (255, 0, 160)).all(axis=2).sum()
        assert sheet.width > 3 * 32
        assert marked > 1       # once in the whole, more in the enlargement


def test_one_pixel_in_one_frame_is_found(folders):
    result = json.loads(compare(folders["dump"], folders["other"], "--json").stdout)
    assert [frame["pixels_differing"] for frame in result["per_frame"]] == [0, 1, 0]


def test_sizes_differ(pictures):
    assert_one_sentence(compare(pictures["a"], pictures["c"]), "30x20", "30x10")


def test_counts_differ(folders, pictures):
    assert_one_sentence(compare(folders["dump"], pictures["a"]), "3 frames", "1")


def test_names_differ(folders):
    (folders["other"] / "frame_0002.png").rename(folders["other"] / "frame_0007.png")
    assert_one_sentence(compare(folders["same"], folders["other"]), "only one of")


def test_nothing_there(tmp_path, pictures):
    assert_one_sentence(compare(tmp_path / "none.png", pictures["a"]), "none.png", "no such file")


def test_pictures_of_differences_are_no_frames(folders):
    """A comparison whose results go to the folder of the frames, and the same once more."""
    for _ in range(2):
        done = compare(folders["same"], folders["other"], "--out", folders["other"])
        assert done.returncode == 1 and "2 of 3 frames equal" in done.stdout, done.stderr
    assert (folders["other"] / "frame_0001_diff.png").exists()


def test_empty_folder(tmp_path, pictures):
    (tmp_path / "empty").mkdir()
    assert_one_sentence(compare(tmp_path / "empty", pictures["a"]), "without a PNG")


def test_not_a_picture(tmp_path, pictures):
    (tmp_path / "text.png").write_text("no picture")
    assert_one_sentence(compare(tmp_path / "text.png", pictures["a"]), "text.png")


def test_truncated_picture(tmp_path, pictures):
    (tmp_path / "cut.png").write_bytes(pictures["a"].read_bytes()[:200])
    assert_one_sentence(compare(tmp_path / "cut.png", pictures["a"]), "cut.png")


def test_sixteen_bits(tmp_path, pictures):
    Image.fromarray(numpy.zeros((20, 30), numpy.uint16)).save(tmp_path / "deep.png")
    assert_one_sentence(compare(tmp_path / "deep.png", pictures["a"]), "8 bits")


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def made_png(path, width, height, depth=1, colour=0, row=None, more=b""):
    """A PNG written here, since Pillow writes neither all depths nor damage: every row the same, more after its head."""
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[colour]
    row = bytes(-(-width * depth * channels // 8)) if row is None else row
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, 0))
                     + more + chunk(b"IDAT", zlib.compress((b"\0" + row) * height)) + chunk(b"IEND", b""))
    return path


@pytest.mark.parametrize("colour", [0, 2, 4, 6], ids=["grey", "RGB", "grey with alpha", "RGBA"])
def test_sixteen_bits_of_every_kind(tmp_path, colour):
    """Pillow drops the lower eight bits of most of them in silence: a difference in them would be called equal."""
    deep = made_png(tmp_path / "deep.png", 4, 4, 16, colour)
    assert_one_sentence(compare(deep, deep), "deep.png", "has 16 bits a channel", "at most 8 bits")


@pytest.mark.parametrize("kind", ["FIFO", "device", "folder"])
@pytest.mark.parametrize("name", ["frame_0000.png", "board.fxld"])
def test_what_is_no_regular_file_is_not_waited_for(tmp_path, kind, name):
    folder = tmp_path / "fold"
    folder.mkdir()
    file = folder / name
    {"FIFO": lambda: os.mkfifo(file), "device": lambda: file.symlink_to("/dev/zero"), "folder": file.mkdir}[kind]()
    for path in ([folder] if name.endswith(".png") else []) + ([file] if kind != "folder" else []):
        code, said = run_bounded("compare", "--a", path, "--b", path)
        assert code == 2 and f"{name}: is a {kind}; give a regular file" in said


def test_a_name_that_is_too_long(pictures):
    assert_one_sentence(compare("a" * 5000, pictures["a"]), "no such file")


def test_files_beyond_the_limit(tmp_path):
    for name, words in (("big.png", "limit of 67,108,864"), ("big.fxld", "limit of 1,073,741,824")):
        with (tmp_path / name).open("wb") as file:
            file.truncate((1 << 30) + 1)
        code, said = run_bounded("compare", "--a", tmp_path / name, "--b", tmp_path / name)
        assert code == 2 and f"{name}: 1,073,741,825 bytes" in said and words in said


@pytest.mark.parametrize("width, height", [(13_000, 13_000), (4097, 1), (1, 4097), (4096, 2049), (60_000, 60_000),
                                           (1 << 31, 9)])
def test_pictures_of_too_many_pixels(tmp_path, width, height):
    head = struct.pack(">IIBBBBB", width, height, 1, 0, 0, 0, 0)
    bomb = made_png(tmp_path / "bomb.png", 1, 1)
    bomb.write_bytes(bomb.read_bytes()[:8] + chunk(b"IHDR", head) + bomb.read_bytes()[33:])
    twice = made_png(tmp_path / "twice.png", 1, 1, more=chunk(b"IHDR", head))
    for file in (bomb, twice):
        code, said = run_bounded("compare", "--a", file, "--b", file)
        assert code == 2 and "Warning" not in said and len(said.splitlines()) == 1
        if file == bomb or "cannot be read" not in said:
            assert f"{width}x{height} pixels are too many" in said and "4,096 a side and 8,388,608 together" in said


@pytest.mark.parametrize("width, height", [(4096, 2048), (2048, 4096)])
def test_pictures_of_as_many_pixels_as_there_may_be(tmp_path, width, height):
    a = made_png(tmp_path / "a.png", width, height, 8, 6, bytes(range(256)) * (width // 64))
    b = made_png(tmp_path / "b.png", width, height, 1, row=b"\xff" * (width // 8))
    out = tmp_path / "out"
    code, said = run_bounded("compare", "--a", a, "--b", b, "--out", out)
    assert code == 1 and "of 8,388,608 pixels" in said


def test_the_picture_of_large_ones_shows_the_part_that_differs(tmp_path):
    a = numpy.zeros((1100, 3000), numpy.uint8)
    b = a.copy()
    b[1098, 2990:] = 9
    out = tmp_path / "out"
    assert compare(save(tmp_path / "a.png", a), save(tmp_path / "b.png", b), "--out", out).returncode == 1
    with Image.open(out / "a_diff.png") as sheet:
        assert 3 * 1024 < sheet.width < 3 * 1024 + 99
        assert (numpy.asarray(sheet.convert("RGB")) == (255, 0, 160)).all(axis=2).sum() > 10


@pytest.mark.parametrize("width, height", [(0, 5), (5, 0)])
def test_a_png_without_pixels(tmp_path, width, height):
    none = made_png(tmp_path / "none.png", width, height)
    assert_one_sentence(compare(none, none), "none.png: cannot be read: its head is damaged")


def test_a_png_with_very_many_texts(tmp_path):
    profile = chunk(b"iCCP", b"n\0\0" + zlib.compress(bytes((1 << 20) - 1), 9))
    file = made_png(tmp_path / "texts.png", 4, 4, more=profile * 2000)
    code, said = run_bounded("compare", "--a", file, "--b", file)
    assert code == 2 and "more than 64 chunks of compressed text" in said


@pytest.mark.parametrize("mode, options", [
    ("1", {"transparency": 0}), ("L", {"transparency": 7}), ("LA", {}), ("P", {"transparency": 3}),
    ("P", {"transparency": bytes(range(200))}), ("RGB", {"transparency": (0, 0, 0)}), ("RGBA", {})])
def test_every_kind_of_png_is_read_as_pillow_does(tmp_path, mode, options):
    noise = numpy.random.default_rng(5).integers(0, 256, (300, 40, 4), dtype=numpy.uint8)
    noise[::3, ::3] = 0
    file = tmp_path / "some.png"
    image = Image.fromarray(noise) if mode == "RGBA" else Image.fromarray(noise[..., :3]).convert(mode)
    image.save(file, **options)
    with Image.open(file) as opened:
        assert (comparison.read_png(file) == numpy.asarray(opened.convert("RGBA"))).all()


@pytest.mark.parametrize("tolerance", ["1" * 5000, "0" * 5000, "x" * 5000])
def test_tolerance_of_very_many_characters(pictures, tolerance):
    done = compare(pictures["a"], pictures["a"], "--tolerance", tolerance)
    assert_one_sentence(done, "TOLERANCE", "from 0 to 255")
    assert len(done.stderr) < 300


def test_names_that_control_a_terminal(tmp_path, pictures):
    bad = "x\x1b[31m\x07\ny"
    for name in ("a", "b", "c"):
        (tmp_path / f"{name}_of").mkdir()
        pictures[name].rename(tmp_path / f"{name}_of" / f"{bad}.png")
    done = compare(tmp_path / "a_of", tmp_path / "b_of", "--out", tmp_path / f"out{bad}")
    assert done.returncode == 1 and len(done.stdout.splitlines()) == 5
    assert "x\\x1b[31m\\x07\\ny  " in done.stdout and "outx\\x1b[31m\\x07\\ny\n" in done.stdout
    assert "\x1b" not in done.stdout and "\x07" not in done.stdout
    done = compare(tmp_path / "a_of", tmp_path / "c_of")
    assert_one_sentence(done, "x\\x1b[31m\\x07\\ny: the sizes differ: 30x20 and 30x10")
    assert len(done.stderr.splitlines()) == 1


def test_damaged_dump_leaves_nothing(tmp_path, folders):
    damaged = tmp_path / "damaged.fxld"
    data = bytearray(folders["dump"].read_bytes())
    data[2000] ^= 1
    damaged.write_bytes(data)
    out = tmp_path / "result"
    assert_one_sentence(compare(damaged, folders["same"], "--out", out), "checksum")
    assert not out.exists()
    assert not list(tmp_path.glob(".fixel*"))


def test_unwritable_out(tmp_path, pictures):
    below_a_file = pictures["a"] / "out"
    assert_one_sentence(compare(pictures["a"], pictures["b"], "--out", below_a_file), "cannot be written")


@pytest.mark.parametrize("a, b, code", [("a", "a", 0), ("a", "b", 1), ("a", "c", 2)])
def test_make_compare_gives_the_same_exits(pictures, tmp_path, a, b, code):
    done = run_make("compare", f"A={pictures[a]}", f"B={pictures[b]}", f"OUT={tmp_path / 'out'}")
    assert done.returncode == code, done.stdout + done.stderr


def test_make_compare_without_b(pictures):
    done = run_make("compare", f"A={pictures['a']}")
    assert done.returncode == 2 and "B= is missing" in done.stderr


def test_enlargement_centres_a_single_pixel():
    differs = numpy.zeros((240, 320), bool)
    differs[112, 193] = True
    y0, y1, x0, x1 = picture.differing_region(differs, 24)
    assert (y1 - y0, x1 - x0) == (24, 24)
    assert abs((y0 + y1) / 2 - 112) <= 1 and abs((x0 + x1) / 2 - 193) <= 1


def test_enlargement_stays_within_the_frame():
    differs = numpy.zeros((20, 400), bool)
    differs[0, 399] = True
    y0, y1, x0, x1 = picture.differing_region(differs, 24)
    assert (y0, y1) == (0, 20) and x1 <= 400 and x0 <= 399 < x1


@pytest.mark.parametrize("width, height, taken", [
    (comparison.SIDE_MAX, 1, True), (1, comparison.SIDE_MAX, True), (comparison.SIDE_MAX + 1, 1, False),
    (1, comparison.SIDE_MAX + 1, False), (comparison.SIDE_MAX, comparison.PIXELS_MAX // comparison.SIDE_MAX, True),
    (comparison.SIDE_MAX, comparison.PIXELS_MAX // comparison.SIDE_MAX + 1, False)])
def test_the_largest_picture(width, height, taken):
    if taken:
        comparison.check_size("a.png", width, height)
        return
    with pytest.raises(ToolError, match="pixels are too many"):
        comparison.check_size("a.png", width, height)


@pytest.mark.parametrize("places", [[50], [40, 70], [0], [99], [10, 80, 85, 90]])
def test_of_a_large_picture_the_part_is_shown_that_differs_most(monkeypatch, places):
    """Of several parts of a screen's size that differ as much, the middle one."""
    monkeypatch.setattr(comparison.dump, "SCREEN_MAX", 40)
    counts = numpy.zeros(100, int)
    counts[places] = 1
    shown = comparison.fullest(counts)
    most = max(counts[first:first + 40].sum() for first in range(61))
    assert shown.stop - shown.start == 40 and counts[shown].sum() == most
    starts = [first for first in range(61) if counts[first:first + 40].sum() == most]
    assert shown.start == starts[len(starts) // 2]
    assert comparison.fullest(counts[:30]) == slice(0, 30)
