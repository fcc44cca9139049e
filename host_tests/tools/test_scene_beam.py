# SPDX-License-Identifier: MIT
"""Beams of light: in scene files, in images, and as the library reads them."""

from dataclasses import replace
from fractions import Fraction
import json
import subprocess
import sys

import pytest

from conftest import CHECKOUT, clipper_names, run_make
from fixel.image import image, image_beam
from fixel.scene import toml_scene
from fixel.base.errors import ToolError
# place field: images that are broken, for the tools
from scene_sections import entry_at, replaced, section
from test_scene_image import patched

BUILT_PROGRAMS = ("host/frames", "host/judge")
ROOM = """
[[beams]]
direction = [3, -4, 0]
window = [[-4, 1, -1], [-4, 2, -1], [-4, 2, 1], [-4, 1, 1]]

[[objects]]
solid = "box"
inside = true
scale = [8, 4, 8]
position = [0, 2, 0]

[path]
keys = [{ position = [0, 1, -3] }]
"""


def build(tmp_path, text):
    file = tmp_path / "scene.toml"
    file.write_text(text)
    return toml_scene.compile_file(str(file))[0]


def refused(tmp_path, text, *parts):
    with pytest.raises(ToolError) as caught:
        build(tmp_path, text)
    for part in parts:
        assert part in str(caught.value)


def inside(beam, *point):
    """Whether a point (world units) lies in a beam, exactly."""
    return all(sum(n * Fraction(c) * 65536 for n, c in zip(plane, point)) >= plane[3]
               for plane in beam.planes)


def test_a_window_makes_a_shaft(tmp_path):
    scene = build(tmp_path, ROOM)
    beam, = scene.beams
    assert beam.kind == image_beam.DIRECTION
    assert beam.source == (644245094, -858993459, 0)
    assert len(beam.planes) == 5
    assert inside(beam, -3, "0.5", 0)
    assert not inside(beam, -3, "0.5", "1.5")
    assert not inside(beam, -3, "1.5", 0)
    assert not inside(beam, -5, 3, 0)           # before the window
    back = image.unpack(image.pack(scene))
    assert back == scene and back.beams == scene.beams and back.lit == scene.lit


def test_a_point_makes_a_cone(tmp_path):
    beam, = build(tmp_path, ROOM.replace("direction = [3, -4, 0]", "position = [-7, 3, 0]")).beams
    assert beam.kind == image_beam.POINT and beam.source == (-7 << 16, 3 << 16, 0)
    assert inside(beam, -1, 0, 0) and inside(beam, "-3.9", "1.5", "0.9")
    assert not inside(beam, -1, 0, 4) and not inside(beam, -10, 4, 0)


def test_what_is_lit_is_lighter(tmp_path):
    scene = build(tmp_path, ROOM)
    used = {face.colour for model in scene.models for face in model.faces}
    for colour in used:
        assert scene.lit[colour] not in used
        assert sum(scene.palette[scene.lit[colour]]) > sum(scene.palette[colour])
    assert scene.lit[0] == 0 and scene.lit[255] == 255


def test_without_beams_an_image_is_as_it_was(tmp_path):
    scene = build(tmp_path, ROOM)
    dark = image.pack(replace(scene, beams=[]))
    assert section(dark, "beams") == section(dark, "lit") == (0, 0)
    lit = image.pack(scene)
    assert section(lit, "beams")[1] == len(scene.beams) and section(lit, "lit")[1] == 1
    assert dark == replaced(lit, beams=b"", lit=b"")


@pytest.mark.parametrize("old, new, parts", [
    ("direction = [3, -4, 0]\n", "", ["beams[0]", "direction"]),
    ("direction = [3, -4, 0]", "direction = [0, 0, 0]", ["no direction"]),
    ("direction = [3, -4, 0]", "direction = [0, -1, 0]", ["plane of the window"]),
    ("direction = [3, -4, 0]", "direction = [3, -4, 0]\nposition = [0, 0, 0]", ["beams[0]"]),
    ("[-4, 2, 1], [-4, 1, 1]", "[-4, 1, 1], [-4, 2, 1]", ["not convex"]),
    ("direction = [3, -4, 0]", "direktion = [3, -4, 0]", ['"direction"']),
    ('solid = "box"', 'solid = "prism"\nsides = 20', ["too many to be split"]),
])
def test_what_makes_no_beam(tmp_path, old, new, parts):
    assert old in ROOM
    if "sides" in new:
        scene = build(tmp_path, ROOM.replace(old, new))
        with pytest.raises(ToolError, match=parts[0]):
            image.pack(scene)
    else:
        refused(tmp_path, ROOM.replace(old, new), *parts)


def test_damaged_beams_are_refused(tmp_path):
    blob = image.pack(build(tmp_path, ROOM))
    beams, _ = section(blob, "beams")
    at_beams, at_lit = entry_at(blob, "beams"), entry_at(blob, "lit")
    for offset, data, status in [
            (at_beams + 8, b"\0", "count"), (at_beams + 8, b"\5", "count"), (at_lit + 8, b"\2", "count"),
            (at_beams + 4, b"\xfc\xff\xff\x7f", "offset"), (at_lit + 4, b"\xfc\xff\xff\x7f", "offset"),
            (at_lit + 3, b"\1", "reserved"), (beams + 12, b"\2", "reserved"),
            (beams + 13, b"\0", "count"), (beams + 13, b"\4", "reserved"), (beams, b"\0\0\0\0", "normal"),
            (beams + 19, b"\x20", "normal"), (beams + 35, b"\x40", "range")]:
        with pytest.raises(ToolError, match=f"^{status}:"):
            image.unpack(patched(blob, offset, data))


def test_normals_are_rounded_once():
    for vector in [(1, 0, 0), (3, -4, 0), (1, 1, 1), (-5, 7, 11), (1 << 62, -1, 3)]:
        unit = image_beam.unit(vector)
        square = sum(c * c for c in vector)
        for rounded, exact in zip(unit, vector):
            # |2 rounded -+ 1| / 2 stands around 2^30 |exact| / sqrt(square).
            wanted = exact * exact << 62
            assert (2 * abs(rounded) - 1) ** 2 * square <= wanted or rounded == 0
            assert wanted <= (2 * abs(rounded) + 1) ** 2 * square
            assert rounded * exact >= 0


def test_the_scene_of_a_room_is_the_twins(tmp_path):
    """All of beam.toml, judged."""
    done = run_make("run", "BOARD=host", "SCENE=scenes/beam.toml", "SCREEN=160x120", f"OUT={tmp_path / 'run'}")
    assert done.returncode == 0, done.stdout + done.stderr
    summary = json.loads((tmp_path / "run" / "summary.json").read_text())
    assert summary["pixels_unexplained"] == 0
    assert summary["polygons"]["refused"] == 0


@pytest.mark.parametrize("clipper", clipper_names(but=("world", "half-spaces")))
@pytest.mark.parametrize("hidden", ["sorted", "spans"])
def test_every_way_draws_the_room(clipper, hidden, tmp_path, build_of_scene):
    frames, found = tmp_path / "frames.fxld", tmp_path / "found.json"
    programs = CHECKOUT / "build" / "host"
    subprocess.run([programs / "frames", build_of_scene, frames, "--clipper", clipper, "--hidden", hidden,
                    "--rows", "7", "--list", "900"], check=True, capture_output=True)
    subprocess.run([programs / "judge", build_of_scene, frames, "--json", found, "--clipper", clipper],
                   check=False, capture_output=True)
    verdict = json.loads(found.read_text())
    assert verdict["pixels_unexplained"] == 0
    assert verdict["pixels_differing"] < 10


@pytest.fixture(scope="module", name="build_of_scene")
def fixture_build_of_scene(tmp_path_factory):
    out = tmp_path_factory.mktemp("beam") / "beam.fxls"
    subprocess.run([sys.executable, CHECKOUT / "tools" / "scene.py", "build", CHECKOUT / "scenes" / "beam.toml",
                    "-o", out, "--screen", "160x120"], check=True, capture_output=True)
    return out
