# SPDX-License-Identifier: MIT
"""make compare and tools/compare.py: the three exits, tolerance, JSON, pictures."""

import json

import numpy
import pytest
from conftest import assert_one_sentence, dump_bytes, random_frames, run_cli, run_make
from PIL import Image

from fixel import picture

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
    assert done.returncode == 0 and "equal" in done.stdout


def test_different(pictures):
    done = compare(pictures["a"], pictures["b"])
    assert done.returncode == 1
    assert "different" in done.stdout and "6 of 600 pixels" in done.stdout


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
