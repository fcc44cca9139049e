# SPDX-License-Identifier: MIT
"""Lights and cameras of a glTF file, in a model without a scene file."""

import json
import math
import re

import numpy
import pytest

from conftest import run_cli
from fixel.base.errors import ToolError
from fixel.image import image
from fixel.scene import compiler, look, toml_scene
from model_files import File, about_x, car

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "host/frames", "host/judge", "host/raycast", "host/predict")
LIGHTS = "KHR_lights_punctual"


def compiled(path, frames=4, **wanted):
    made, notes = compiler.compile_scene(str(path), frames, look=look.Look(**wanted))
    assert image.unpack(image.pack(made)) == made
    return made, notes


def lit(tmp_path, *lights, nodes=None):
    """A box of 2 units with these lights, each at a node."""
    made = File({"name": "box", "mesh": 0}, *(nodes or [{"name": f"light {i}", "extensions": {LIGHTS: {"light": i}}} for i in range(len(lights))]),
                roots=list(range(1 + len(nodes or lights))), extensionsUsed=[LIGHTS], extensions={LIGHTS: {"lights": list(lights)}})
    made.box((2, 2, 2))
    return made.write(tmp_path / "m.glb")


def said(notes, *words):
    return sum(all(word in note for word in words) for note in notes)


def test_a_directional_light_is_that_of_the_scene(tmp_path):
    at = {"name": "sun", "rotation": about_x(-90), "extensions": {LIGHTS: {"light": 0}}}    # from above
    made, notes = compiled(lit(tmp_path, {"type": "directional", "intensity": 3}, nodes=[at]))
    assert [c / (1 << 30) for c in made.light.direction] == pytest.approx([0, -1, 0], abs=1e-4)
    assert made.light.strength == round((1 << 30) * 2 / 3) and not made.light.points and not said(notes, "lights")
    plain, more = compiler.compile_scene(str(tmp_path / "m.glb"), 4)
    assert plain.light is None and said(more, "left out lights (1)") == 1


def test_point_lights_have_a_place_a_range_and_a_part_of_the_brightest(tmp_path):
    nodes = [{"name": name, "translation": place, "extensions": {LIGHTS: {"light": number}}}
             for number, (name, place) in enumerate([("lamp", [0, 2, 3]), ("far lamp", [0, 0, -6]), ("torch", [3, 0, 0])])]
    made, notes = compiled(lit(tmp_path, {"type": "point", "intensity": 10, "range": 5}, {"type": "point", "intensity": 20, "color": [1, 0, 0]},
                               {"type": "spot", "intensity": 5, "spot": {}}, nodes=nodes))
    scale = 4 / math.sqrt(3)
    brightest = max(10, 20 * 0.2126, 5)
    found = {tuple(round(c / 65536 / scale, 2) for c in place): (reach / 65536, strength / (1 << 30)) for *place, reach, strength in made.light.points}
    assert set(found) == {(0, 2, -3), (0, 0, 6), (3, 0, 0)} and made.light.strength == 0
    assert found[0, 2, -3] == pytest.approx((5 * scale, 1), rel=1e-3)
    assert found[0, 0, 6] == pytest.approx((1.5 * (6 * scale + 4), 20 * 0.2126 / brightest), rel=1e-3)
    assert said(notes, "spot lights shine to all sides: 1 (first: torch)") == 1 and said(notes, "lights have no colour: 1 (first: far lamp)") == 1


def test_of_many_lights_the_brightest_are_taken(tmp_path):
    suns = [{"type": "directional", "intensity": i} for i in (1, 4)]
    lamps = [{"type": "point", "intensity": i} for i in (1, 2, 3, 4, 5, 6)]
    made, notes = compiled(lit(tmp_path, *suns, *lamps))
    assert sorted(round(point[4] * 6 / (1 << 30)) for point in made.light.points) == [3, 4, 5, 6]
    assert said(notes, "more directional lights than one", "light 0") == 1 and said(notes, "more point lights than 4", "light 3") == 1


def test_lights_without_strength_leave_the_tools_own(tmp_path):
    made, notes = compiled(lit(tmp_path, {"type": "point", "intensity": 0}))
    assert made.light is None and said(notes, "left out lights (1)") == 1


@pytest.mark.parametrize("entry, words", [
    ({"type": "point", "intensity": -1}, "intensity"), ({"type": "point", "color": [1]}, "color"), ({"type": "point", "range": "x"}, "range")])
def test_lights_that_make_no_sense_are_refused(tmp_path, entry, words):
    with pytest.raises(ToolError, match=words):
        compiled(lit(tmp_path, entry))
    with pytest.raises(ToolError, match="light 7 does not exist"):
        compiled(lit(tmp_path, {"type": "point"}, nodes=[{"extensions": {LIGHTS: {"light": 7}}}]))


# --- cameras -----------------------------------------------------------------------------------

def filmed(tmp_path, **camera):
    """A car with two cameras, of which one moves."""
    made = car()
    made.data["cameras"] = [{"type": "perspective", "perspective": {"yfov": math.radians(50), "znear": 0.1}}, {"type": "orthographic", "orthographic": {}}]
    nodes = made.data["nodes"]
    nodes += [{"name": "front", "camera": 0, "translation": [0, 1, 9]}, {"name": "dolly", "camera": 0, "translation": [0, 0, 12]},
              {"name": "plan", "camera": 1}]
    made.data["scenes"][0]["nodes"] += [9, 10, 11]
    made.animate((10, "translation", [0, 1], [(0, 0, 12), (3, 0, 12)]), (10, "rotation", [0, 1], [[0, 0, 0, 1], [0, math.sin(0.2), 0, math.cos(0.2)]]),
                 name="pan")
    return made.write(tmp_path / "m.glb")


def test_a_camera_makes_the_path_where_it_is_asked_for(tmp_path):
    path = filmed(tmp_path)
    plain, notes = compiled(path)
    assert said(notes, "left out cameras (2)") == 1
    made, notes = compiled(path, None, camera="front")
    assert len(made.path) == 60 and len(set(made.path)) == 1 and not said(notes, "left out cameras (2)") and said(notes, "seen by front for 60 frames")
    x, y, z, *angles = made.path[0]
    scale = 4 / max(math.dist((0, 0, 0), (1.25, 0.875, 2.05)), 1)
    assert not any(angles) and z < 0 and abs(x) <= 1 and abs(y / 65536) < 2 * scale
    assert made.fov * 360 / (1 << 32) == pytest.approx(2 * math.degrees(math.atan(math.tan(math.radians(25)) * 4 / 3)), abs=0.02)
    assert plain.fov != made.fov
    with pytest.raises(ToolError, match='--camera: no camera has a name like "side"; the file\'s: front, dolly, plan'):
        compiled(path, camera="side")


@pytest.mark.parametrize("near", [0, 0.5])
def test_an_orthographic_camera_makes_an_orthographic_lens(tmp_path, near):
    made = car()
    made.data["cameras"] = [{"type": "orthographic", "orthographic": {"xmag": 4, "ymag": 3, "znear": near, "zfar": 50}}]
    made.data["nodes"].append({"name": "plan", "camera": 0, "translation": [0, 0, 12]})
    made.data["scenes"][0]["nodes"].append(9)
    path = made.write(tmp_path / "m.glb")
    seen, notes = compiled(path, None, camera="plan")
    (scale,) = {float(found) for note in notes for found in re.findall(r"scaled by ([\d.]+)", note)}
    assert seen.scale / 65536 == pytest.approx(seen.width / (2 * 4 * scale), rel=1e-3)
    assert said(notes, "znear is 0") == (near == 0) and (seen.near == 256) == (near == 0)


@pytest.mark.parametrize("table", [{}, {"yfov": 0}, {"yfov": 4}, {"yfov": "wide"}, {"yfov": 1, "znear": -1}])
def test_a_camera_that_makes_no_sense_is_refused_only_where_it_is_asked_for(tmp_path, table):
    made = car()
    made.data["cameras"] = [{"type": "perspective", "perspective": table}]
    made.data["nodes"].append({"name": "front", "camera": 0})
    made.data["scenes"][0]["nodes"].append(9)
    path = made.write(tmp_path / "m.glb")
    assert said(compiled(path)[1], "left out cameras (1)") == 1
    with pytest.raises(ToolError, match='"front" has no perspective'):
        compiled(path, camera="front")


def test_a_camera_that_moves_is_followed(tmp_path):
    made, _ = compiled(filmed(tmp_path), None, camera="dolly", animation="pan")
    assert len(made.path) == 30 and made.path[0][3:] == (0, 0, 0)
    scale = (made.path[15][0] - made.path[0][0]) / 65536 / 1.5
    for frame, pose in enumerate(made.path):
        assert abs(pose[0] / 65536 - 0.1 * frame * scale) < 0.01 * scale
        yaw = (pose[3] + (1 << 31)) % (1 << 32) - (1 << 31)
        assert yaw * 2 * math.pi / (1 << 32) == pytest.approx(-0.4 * frame / 30, abs=2e-3)     # to the left
    more, _ = compiled(tmp_path / "m.glb", 40, camera="dolly", animation="pan")
    assert more.path[:30] == made.path and more.path[30][0] == made.path[0][0]


def test_a_lit_and_filmed_car_is_drawn_as_double_draws_it_and_by_its_scene_file(build, tmp_path):
    path = filmed(tmp_path)
    done = run_cli("run", "--board", "mps2-an385", "--scene", path, "--frames", 6, "--out", tmp_path / "run", "--write", tmp_path / "s.toml",
                   "--camera", "front")
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "run" / "summary.json").read_text())
    assert summary["pixels_unexplained"] == 0 and summary["order_wrong_pixels"] == 0 and summary["host_frames_equal"]
    made, _ = compiled(path, 6, camera="front")
    assert image.pack(toml_scene.compile_file(str(tmp_path / "s.toml"))[0]) == image.pack(made)
    assert len({numpy.float64(pose[2]) for pose in made.path}) == 1
