# SPDX-License-Identifier: MIT
"""Frames of RGB565: what the library draws on the host is explained by the reference renderer, and what is one off is not."""

import json
import struct
import zlib

import numpy
import pytest
from conftest import CHECKOUT, run_cli
from drawn_scenes import head
from test_surface_frames import built, drawn, judged

from fixel.board import dump

BUILT_PROGRAMS = ("host/frames", "host/judge", "boards/host/walk", "host/raycast", "host/predict")
# Textures, levels and smooth light; holes; blended glass; billboards; texels of RGB565, some added to what is beneath.
SCENES = (*(f"scenes/{name}" for name in ("gallery", "room", "car", "grove")), "host_tests/fuzz/scenes/texels")
METHODS = ((), ("--hidden", "depth"), ("--hidden", "depth-32"))
BLENDED = head(64, 48, ['pixels = "rgb565"', "near = 1", "far = 32"]) + """
%s
[light]
levels = 16
direction = [0, -1, 1]
dark = "#301008"
[[objects]]
solid = "box"
colour = "gold"
scale = 2
smooth = true
[[objects]]
solid = "box"
colour = "teal"
blend = true
smooth = true
scale = [1, 3, 0.5]
position = [0, 0, -2]
[path]
orbit = { centre = [0, 0, 0], radius = 6, height = 2, frames = 6 }
"""


@pytest.mark.parametrize("method", METHODS, ids=lambda words: words[-1] if words else "by-distance")
@pytest.mark.parametrize("name", SCENES, ids=lambda name: name.split("/")[-1])
def test_each_pixel_is_explained(build, tmp_path, name, method):
    image_file = built(CHECKOUT / f"{name}.toml", tmp_path)
    shown = drawn(build, image_file, "shown", "--pixels", "rgb565", "--frames", "3", *method)
    verdict = judged(build, image_file, shown, *method)
    assert verdict["pixels_unexplained"] == 0
    assert dump.read_dump(shown).frames[0].pixels.dtype.itemsize == 2


@pytest.mark.parametrize("pixels", ("palette", "rgb565"))
def test_a_scene_is_judged_of_which_all_is_seen_through(build, tmp_path, pixels):
    """No ray meets anything, and the faces are the reference's to judge."""
    scene = tmp_path / "glass.toml"
    scene.write_text((BLENDED % "").replace("smooth = true", "smooth = true\nopacity = 9", 1).replace("rgb565", pixels))
    done = run_cli("run", "--board", "host", "--scene", scene, "--frames", 2, "--out", tmp_path / "out")
    assert done.returncode == 0, done.stdout + done.stderr
    summary = json.loads((tmp_path / "out" / "summary.json").read_text(encoding="utf-8"))
    assert summary["pixels_unexplained"] == 0 and summary["frames"] == 2


OUTLINES = ("--outlines", "1")


@pytest.mark.parametrize("blend", ("true", '"add"'), ids=("blended", "added"))
def test_what_is_mixed_with_an_outline_is_explained_and_what_is_off_is_not(build, tmp_path, blend):
    """The teal box is mixed with the edges of the golden one behind it, and with its own. accuracy 4.2b, 4.2g-h."""
    scene = tmp_path / "outlined.toml"
    scene.write_text((BLENDED % "").replace("blend = true", f"blend = {blend}"))
    image_file = built(scene, tmp_path)
    plain = dump.read_dump(drawn(build, image_file, "plain"))
    shown = drawn(build, image_file, "shown", *OUTLINES)
    assert judged(build, image_file, shown, *OUTLINES)["pixels_unexplained"] == 0
    pixels = dump.read_dump(shown).frames[0].pixels
    lines = pixels != plain.frames[0].pixels
    values, counts = numpy.unique(pixels[lines], return_counts=True)
    colour = int(values[counts.argmax()])
    over = numpy.flatnonzero(lines & (pixels != colour))        # a line, and something over it
    assert len(over) > 20 and (pixels[lines] == colour).sum() > 20
    assert judged(build, image_file, shown)["pixels_unexplained"] > 20      # nobody speaks of outlines
    nowhere = int(numpy.flatnonzero(~around(lines, 3))[0])
    blob, size = shown.read_bytes(), dump.parse_head(shown.read_bytes(), "shown").frame_bytes
    for place, change in ((int(over[len(over) // 2]), 4 << 11), (int(over[len(over) // 3]), 8 << 5),
                          (nowhere, int(pixels.ravel()[nowhere]) ^ colour)):
        other = tmp_path / "other.fxld"
        other.write_bytes(with_pixel(blob, size, 0, place, change))
        assert judged(build, image_file, other, *OUTLINES)["pixels_unexplained"] == 1, place


def around(mask, distance):
    """What is within so many pixels of a mask, along and across."""
    height, width = mask.shape
    padded = numpy.pad(mask, distance)
    shifts = range(2 * distance + 1)
    return numpy.any([padded[y:y + height, x:x + width] for y in shifts for x in shifts], axis=0)


def test_bands_and_lists_make_no_difference(build, tmp_path):
    image_file = built(CHECKOUT / "scenes" / "gallery.toml", tmp_path)
    options = ("--pixels", "rgb565", "--frames", "2", "--hidden", "depth")
    whole = dump.read_dump(drawn(build, image_file, "whole", *options)).frames
    for number, more in enumerate((("--rows", "7"), ("--rows", "16", "--list", "600"), ("--list", "0"))):
        bands = dump.read_dump(drawn(build, image_file, f"bands-{number}", *options, *more)).frames
        assert [frame.sha256 for frame in bands] == [frame.sha256 for frame in whole]


def with_pixel(data, frame_bytes, frame, place, change):
    """A dump with another value of one pixel, and the checksum made right."""
    at = dump.HEAD.size + dump.PALETTE_BYTES + frame * frame_bytes + dump.FRAME_HEAD.size + 2 * place
    value, = struct.unpack_from("<H", data, at)
    data = data[:at] + struct.pack("<H", value ^ change) + data[at + 2:]
    return data[:-4] + struct.pack("<I", zlib.crc32(data[:-4]))


@pytest.mark.parametrize("blend", ("", "[palette]\nblend = 3\n"), ids=("half", "three-sixteenths"))
@pytest.mark.parametrize("method", METHODS[:2], ids=("by-distance", "depth"))
def test_a_blended_lit_pixel_is_explained_and_one_that_is_off_is_not(build, tmp_path, method, blend):
    """Two layers: each channel may be what the light's rounding leaves, and no more than that."""
    scene = tmp_path / "blended.toml"
    scene.write_text(BLENDED % blend)
    image_file = built(scene, tmp_path)
    shown = drawn(build, image_file, "shown", *method)
    assert judged(build, image_file, shown, *method)["pixels_unexplained"] == 0
    read = dump.read_dump(shown)
    head = dump.parse_head(shown.read_bytes(), "shown")
    colours, counts = numpy.unique(read.frames[0].pixels, return_counts=True)
    assert len(colours) > 8
    middle = int(numpy.flatnonzero((read.frames[0].pixels == colours[counts.argsort()[-2]]).ravel())[0])
    for change in (2 << 11, 2 << 5, 2):
        other = tmp_path / "other.fxld"
        other.write_bytes(with_pixel(shown.read_bytes(), head.frame_bytes, 0, middle, change))
        verdict = judged(build, image_file, other, *method)
        assert (verdict["pixels_unexplained"], verdict["pixels_inexplicable"]) == (1, 1)
