# SPDX-License-Identifier: MIT
"""Nodes of a glTF file as objects of a model without a scene file: which, their names, what they hang on, how they move."""

import json
import math
import re

import numpy
import pytest

from conftest import assert_one_sentence, run_cli
from fixel.base.errors import ToolError
from fixel.image import image
from fixel.model import gltf
from fixel.model.gltf_motion import between
from fixel.model.quantity import matrix
from fixel.scene import compiler, look, toml_scene, tracks
from model_files import CORNERS, File, WHEELS, about_x, car

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "host/frames", "host/judge", "host/raycast", "host/predict")


def compiled(path, **wanted):
    """(scene, notes) of a model as its author made it."""
    made, notes = compiler.compile_scene(str(path), 4, look=look.Look(**wanted))
    assert image.unpack(image.pack(made)) == made
    return made, notes


def placed(made, number, frame):
    """The vertices of an instance in a frame, by docs/extras/motion.md, section 2."""
    first = len(made.objects) - len(made.motions)
    points = numpy.array(made.models[made.objects[number].model].vertices) / 65536
    if number < first:
        return points + numpy.array(made.objects[number].centre) / 65536
    motion = made.motions[number - first]
    while motion is not None:
        keys, at = motion.keys, frame % motion.keys[-1].frame if motion.repeats else min(frame, motion.keys[-1].frame)
        one = max(i for i, key in enumerate(keys) if key.frame <= at)
        two = min(one + 1, len(keys) - 1)
        part = (at - keys[one].frame) / max(keys[two].frame - keys[one].frame, 1)
        centre = [a + (b - a) * part for a, b in zip(keys[one].centre, keys[two].centre)]
        scale = keys[one].scale + (keys[two].scale - keys[one].scale) * part
        angles = [a + ((b - a + (1 << 31)) % (1 << 32) - (1 << 31)) * part for a, b in zip(keys[one].angles, keys[two].angles)]
        rows = numpy.array(matrix((1, 1, 1), [angle * 360 / (1 << 32) for angle in angles]), dtype=float)
        points = points @ rows.T * scale / 65536 + numpy.array(centre) / 65536
        motion = made.motions[motion.parent - 1] if motion.parent else None
    return points


def by_name(made):
    return {name: number for number, name in enumerate(made.names)}


# --- which parts -----------------------------------------------------------------------------

def test_the_nodes_of_a_small_file_are_objects_with_names(tmp_path):
    made, _ = compiled(car(turns=False).write(tmp_path / "car.glb"))
    assert made.names == ["body", "cabin", "bonnet", "lamp", "lamp_2", *WHEELS] and not made.placements
    whole, _ = compiled(tmp_path / "car.glb", depth=0)
    assert len(whole.objects) == 1 and whole.names == []
    corners = [{tuple(numpy.round(point * 65536)) for number in range(len(scene.objects)) for point in placed(scene, number, 0)}
               for scene in (made, whole)]
    assert corners[0] == corners[1]         # to the last bit: no gap between two parts
    assert run_cli("export", "--c", tmp_path / "car.glb", "-o", tmp_path / "car.h").returncode == 0
    text = (tmp_path / "car.h").read_text()
    assert re.findall(r"CAR_INSTANCE_(\w+) = \d", text) == ["BODY", "CABIN", "BONNET", "LAMP", "LAMP_2", "WHEEL_FL", "WHEEL_FR", "WHEEL_BL", "WHEEL_BR"]


def test_a_name_is_the_nodes_the_meshs_or_a_number(tmp_path):
    made = File({"mesh": 0, "name": "box"}, {"mesh": 0, "name": " "}, {"mesh": 1}, {"mesh": 1, "name": "box"}, {"mesh": 0, "name": "box_2"}, roots=[0, 1, 2, 3, 4])
    made.box(name="plate")
    made.box()
    mesh, _ = gltf.read(str(made.write(tmp_path / "m.glb")))
    assert list(mesh.groups) == ["box", "plate", "node_2", "box_2", "box_2_2"]


@pytest.mark.parametrize("name", ["*/ int x; /*", 'a"b', "a\\b", "a\nb", "\u202eevil", "a\u2066b\u2069\u200f\x7f\x85", "%s%n", "[x]", "-keep", "\ud800x", "\U0001f642"])
def test_any_name_may_be_written_and_read_again(tmp_path, name):
    made = File({"name": name, "mesh": 0}, {"name": "other", "mesh": 0, "translation": [3, 0, 0]}, roots=[0, 1])
    made.box()
    path = made.write(tmp_path / "m.glb")
    assert run_cli("build", path, "-o", tmp_path / "a.fxls", "--write", tmp_path / "s.toml").returncode == 0
    assert all(letter.isprintable() for letter in (tmp_path / "s.toml").read_text(encoding="utf-8").replace("\n", "")), "marks of direction"
    assert run_cli("build", tmp_path / "s.toml", "-o", tmp_path / "b.fxls").returncode == 0
    assert (tmp_path / "a.fxls").read_bytes() == (tmp_path / "b.fxls").read_bytes()
    assert run_cli("export", "--c", path, "-o", tmp_path / "m.h").returncode == 0
    assert len(re.findall(r"M_INSTANCE_[A-Z0-9_]+ = [01]\b", (tmp_path / "m.h").read_text())) == 2


def crowd(count, meshes=2):
    """Boxes in a row, which share meshes."""
    made = File({"children": list(range(1, count + 1))}, *({"name": f"post {i}", "mesh": i % meshes, "translation": [2 * i, 0, 0]} for i in range(count)))
    for number in range(meshes):
        made.box(name=f"kind {number}")
    return made


def test_of_a_large_file_each_mesh_is_a_part_and_keep_names_more(tmp_path):
    path = crowd(63).write(tmp_path / "few.glb")
    assert len(compiled(path)[0].objects) == 63
    path = crowd(64).write(tmp_path / "many.glb")
    made, _ = compiled(path)
    assert made.names == ["kind 0", "kind 1"]
    made, _ = compiled(path, keep="post 1?,post 5")
    assert sorted(made.names) == sorted(["kind 0", "kind 1", "post 5", *(f"post {i}" for i in range(10, 20))])
    assert len(made.placements) == 11 and not made.motions      # a program may turn them
    made, _ = compiled(path, keep="post 5", depth=0)
    assert made.names == [None, "post 5"]
    with pytest.raises(ToolError, match='--keep: no node has a name like "pst 5"; the nearest is "post 5'):
        compiled(path, keep="pst 5")


def test_what_is_kept_hangs_on_what_is_kept_above_it(tmp_path):
    made, _ = compiled(car(turns=False).write(tmp_path / "car.glb"), keep="*")
    numbers = by_name(made)
    assert [motion.parent for motion in made.motions] == [0, *[1] * 8] and numbers["body"] == 0
    plain, _ = compiled(tmp_path / "car.glb")
    for name, number in numbers.items():
        assert abs(placed(made, number, 7) - placed(plain, by_name(plain)[name], 0)).max() < 1e-4


def hinged(count=0, *tracks):
    """A file of a node without faces, the hinge, with two boxes on it, and count boxes beside it."""
    made = File({"name": "wall", "mesh": 0}, {"name": "hinge", "translation": [3, 0.5, 0], "children": [2, 3]},
                {"name": "door", "mesh": 0, "translation": [1, 0, 0]}, {"name": "handle", "mesh": 0, "translation": [1.5, 0, 1], "scale": [0.1, 0.1, 0.1]},
                *({"name": f"post {i}", "mesh": 0, "translation": [0, 2 * i, 4]} for i in range(count)), roots=[0, 1, *range(4, 4 + count)])
    made.box(colour=(0.5, 0.5, 0.5, 1))
    if tracks:
        made.animate(*tracks)
    return made


@pytest.mark.parametrize("depth", [0, 16])
def test_a_kept_node_without_faces_has_those_that_hang_on_it(tmp_path, depth):
    path = hinged().write(tmp_path / "m.glb")
    made, _ = compiled(path, keep="hinge", depth=depth)
    plain, _ = compiled(path)
    assert made.names == ["wall" if depth else None, "hinge"] and len(made.placements) == 1
    assert {tuple(point) for number in (0, 1) for point in placed(made, number, 0).round(4)} == \
        {tuple(point) for number in range(3) for point in placed(plain, number, 0).round(4)}
    named, notes = compiled(path, keep="hinge,door,handle", depth=depth)
    assert named.names == ["wall" if depth else None, "door", "handle"]
    assert any('no faces are no objects: 1 (first: hinge' in note for note in notes)


@pytest.mark.parametrize("count, depth", [(0, 16), (70, 16), (0, 0)])
def test_what_hangs_on_an_animated_node_without_faces_moves_with_it(tmp_path, count, depth):
    turn = (1, "rotation", [0, 1, 2], [[0, 0, 0, 1], about_x(90), about_x(180)])
    made, _ = compiled(hinged(count, turn).write(tmp_path / "m.glb"), depth=depth)
    still, _ = compiled(hinged(count).write(tmp_path / "s.glb"), keep="door,handle", depth=depth)
    assert made.motions and still.placements
    found, wanted = ([tuple(point) for number in range(len(scene.objects)) for point in placed(scene, number, 0)] for scene in (made, still))
    assert len(found) == 8 * (3 + count) and scaled(found) == scaled(wanted)


def scaled(points):
    """Points with their middle at the origin and their largest coordinate 1, for files that are framed otherwise."""
    found = numpy.array(sorted(points))
    found -= (found.min(axis=0) + found.max(axis=0)) / 2
    return {tuple(point) for point in (found / abs(found).max()).round(2) + 0.0}


def test_an_image_on_several_parts_is_one_texture(tmp_path):
    from model_files import png
    made = car(turns=False)
    uvs = made.add([(x, z) for x, _, z in numpy.array(CORNERS) + 0.5], "<f4", "VEC2")
    for mesh in made.data["meshes"]:
        mesh["primitives"][0]["attributes"]["TEXCOORD_0"] = uvs
        mesh["primitives"][0]["material"] = 0
    blob = png([[(8 * x, 8 * y, 40) for x in range(32)] for y in range(32)])
    made.data["images"], made.data["textures"] = [{"bufferView": len(made.data["bufferViews"]), "mimeType": "image/png"}], [{"source": 0}]
    made.data["bufferViews"].append({"buffer": 0, "byteOffset": len(made.blob), "byteLength": len(blob)})
    made.blob += blob
    made.data["materials"][0] = {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}
    scene, _ = compiled(made.write(tmp_path / "car.glb"))
    assert len(scene.objects) == 9 and len(scene.surfaces.textures) == 1


# --- motion ----------------------------------------------------------------------------------

def scale_of(made, number, size):
    """World units of one of the file, by the width of a part."""
    points = placed(made, number, 0)
    return (points[:, 0].max() - points[:, 0].min()) / size


def test_wheels_turn_on_a_body_that_moves(tmp_path):
    made, notes = compiled(car().write(tmp_path / "car.glb"))
    assert any("the animation takes 60 frames and moves 9 of 9 parts" in note for note in notes) and not any("left out" in note for note in notes)
    numbers = by_name(made)
    scale, parents = scale_of(made, numbers["body"], 2), [motion.parent for motion in made.motions]
    assert parents[0] == 0 and set(parents[1:]) == {1}
    middle = placed(made, numbers["body"], 0).mean(axis=0)
    for frame in (0, 1, 7, 15, 22, 30, 44, 59, 60, 75):
        rise = 0.4 * (1 - abs(frame % 60 - 30) / 30)
        angle = math.radians(frame * 6)
        for name, (x, z) in WHEELS.items():
            corners = numpy.array(CORNERS) * (0.3, 0.9, 0.9)
            turned = numpy.column_stack([corners[:, 0], corners[:, 1] * math.cos(angle) - corners[:, 2] * math.sin(angle),
                                         corners[:, 1] * math.sin(angle) + corners[:, 2] * math.cos(angle)]) + (x, rise - 0.4, z)
            wanted = turned * (1, 1, -1) * scale + middle
            found = placed(made, numbers[name], frame)
            assert max(min(abs(point - other).max() for other in found) for point in wanted) < 2e-3 * scale, (frame, name)


def test_an_animated_car_is_drawn_as_double_draws_it_and_by_its_scene_file(build, tmp_path):
    path = car().write(tmp_path / "car.glb")
    done = run_cli("run", "--board", "mps2-an385", "--scene", path, "--frames", 20, "--out", tmp_path / "run", "--write", tmp_path / "s.toml")
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "run" / "summary.json").read_text())
    assert summary["pixels_unexplained"] == 0 and summary["order_wrong_pixels"] == 0 and summary["host_frames_equal"]
    assert run_cli("build", path, "-o", tmp_path / "a.fxls", "--frames", 20).returncode == 0
    assert run_cli("build", tmp_path / "s.toml", "-o", tmp_path / "b.fxls").returncode == 0
    assert (tmp_path / "a.fxls").read_bytes() == (tmp_path / "b.fxls").read_bytes()
    assert len(toml_scene.compile_file(str(tmp_path / "s.toml"))[0].motions) == 9


def test_what_hangs_on_a_node_without_faces_moves_with_it(tmp_path):
    made = File({"children": [1, 2], "scale": [1, 3, 1]}, {"name": "arm", "mesh": 0, "translation": [2, 0, 0]}, {"name": "foot", "mesh": 0})
    made.box()
    made.animate((0, "translation", [0, 1], [(0, 0, 0), (0, 0, 3)]))
    scene, notes = compiled(made.write(tmp_path / "m.glb"))
    assert len(scene.motions) == 2 and not any(motion.parent for motion in scene.motions)
    scale = scale_of(scene, 0, 1)
    for number in (0, 1):
        way = placed(scene, number, 15) - placed(scene, number, 0)
        assert abs(way - (0, 0, -1.5 * scale)).max() < 1e-3 and not any("stretched" in note for note in notes)


def test_uneven_sizes_in_motion_are_told(tmp_path):
    made = File({"name": "jelly", "mesh": 0})
    made.box()
    made.animate((0, "scale", [0, 1], [(1, 1, 1), (1, 2, 1)]))
    _, notes = compiled(made.write(tmp_path / "m.glb"))
    assert any("stretched in one direction" in note and "(first: jelly)" in note for note in notes)


def test_of_several_animations_one_is_played(tmp_path):
    made = File({"name": "thing", "mesh": 0})
    made.box()
    made.animate((0, "translation", [0, 1], [(0, 0, 0), (1, 0, 0)]), name="walk")
    made.animate((0, "translation", [0, 2], [(0, 0, 0), (0, 1, 0)]), name="jump")
    path = made.write(tmp_path / "m.glb")
    for wanted, frames in (("", 30), ("jump", 60), ("j*", 60)):
        scene, notes = compiled(path, animation=wanted)
        assert scene.motions[0].keys[-1].frame == frames and any(f"left out other animations (1); --animation NAME plays another one: {'jump' if not wanted else 'walk'}" in note for note in notes)
    with pytest.raises(ToolError, match='--animation: no animation .* like "fly"; the file\'s: walk, jump'):
        compiled(path, animation="fly")


def test_tracks_of_every_interpolation():
    times, at = numpy.array([0.0, 1.0, 3.0]), numpy.array([-1.0, 0.0, 0.5, 1.0, 2.0, 3.0, 9.0])
    values = numpy.array([[0.0], [2.0], [4.0]])
    assert between(times, values, "LINEAR", at, False)[:, 0].tolist() == [0, 0, 1, 2, 3, 4, 4]
    assert between(times, values, "STEP", at, False)[:, 0].tolist() == [0, 0, 0, 2, 2, 4, 4]
    line = numpy.array([[9.0], [0.0], [2.0], [2.0], [2.0], [1.0], [1.0], [4.0], [9.0]])   # tangents of the straight lines
    assert numpy.allclose(between(times, line, "CUBICSPLINE", at, False)[:, 0], [0, 0, 1, 2, 3, 4, 4])
    turns = numpy.array([about_x(0), [-c for c in about_x(90)]])       # the same turn as +90 degrees
    found = between(numpy.array([0.0, 1.0]), turns, "LINEAR", numpy.array([0.5]), True)[0]
    assert abs(abs(found @ about_x(45)) - 1) < 1e-9


def test_a_track_keeps_every_frame_with_few_keys():
    generator = numpy.random.default_rng(3)
    wild = generator.uniform(-400, 400, (40, 3)).cumsum(axis=0) / 8
    for degrees in (wild, numpy.outer(numpy.arange(90), (0, 7, 0)), numpy.outer(numpy.arange(50), (3, -2, 5))):
        turns = numpy.array([numpy.array(matrix((1, 1, 1), list(row)), dtype=float) for row in degrees])
        rows = tracks.keys(numpy.zeros((len(turns), 3)), turns, numpy.ones(len(turns)))
        frames, found = numpy.cumsum([0] + [row.get("frames", 1) for row in rows])[:-1], [[float(c) for c in row.get("turn", (0, 0, 0))] for row in rows]
        assert frames[-1] == len(turns) - 1
        for frame, turn in enumerate(turns):
            angles = [numpy.interp(frame, frames, column) for column in zip(*found)]
            assert abs(numpy.array(matrix((1, 1, 1), angles), dtype=float) - turn).max() < 4e-3
    assert len(rows) <= 5       # the last one, past straight down


@pytest.mark.parametrize("size", [1e-2, 1e-4, 1e-6])
def test_an_animation_moves_what_stands_in_a_small_node(tmp_path, size):
    made = File({"children": [1], "scale": [size] * 3}, {"name": "arm", "mesh": 0})
    made.box((2, 2, 2))
    made.animate((1, "translation", [0, 1], [(0, 0, 0), (3, 0, 0)]))
    scene, notes = compiled(made.write(tmp_path / "m.glb"))
    assert len(scene.motions) == 1 and not any("no size" in note for note in notes)


def test_a_node_of_scale_0_is_left_out_with_a_note(tmp_path):
    made = File({"name": "hidden", "mesh": 0, "scale": [0, 0, 0]}, {"name": "thing", "mesh": 0}, {"name": "dust", "mesh": 0, "scale": [1e-6] * 3},
                roots=[0, 1, 2])
    made.box()
    scene, notes = compiled(made.write(tmp_path / "m.glb"))
    assert len(scene.objects) == 1 and any("too small to have an area, or have the scale 0: 2 (first: hidden)" in note for note in notes)


def test_times_may_repeat_and_begin_below_0(tmp_path):
    times = numpy.array([0.0, 1.0, 1.0, 2.0])
    values = numpy.array([[0.0], [1.0], [5.0], [6.0]])
    at = numpy.array([0.0, 0.5, 0.999, 1.0, 1.5, 2.0])
    assert between(times, values, "LINEAR", at, False)[:, 0] == pytest.approx([0, 0.5, 0.999, 5, 5.5, 6])
    assert between(times[:3], values[:3], "STEP", at, False)[:, 0].tolist() == [0, 0, 0, 5, 5, 5]
    made = File({"name": "thing", "mesh": 0})
    made.box()
    made.animate((0, "translation", [-1, 1, 1], [(0, 0, 0), (2, 0, 0), (3, 0, 0)]))
    scene, _ = compiled(made.write(tmp_path / "m.glb"))
    assert len(scene.motions) == 1


def test_a_node_with_a_matrix_is_named_where_the_animation_would_move_it(tmp_path):
    made = File({"name": "thing", "mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1]})
    made.box()
    made.animate((0, "translation", [0, 1], [(0, 0, 0), (2, 0, 0)]))
    _, notes = compiled(made.write(tmp_path / "m.glb"))
    assert any("nodes with a matrix stay where they stand" in note and "1 (first: thing)" in note for note in notes)


@pytest.mark.parametrize("words, said", [
    (["--keep", "whel"], "--keep"), (["--animation", "fly"], "drive"), (["--tree", "all", "--keep", "body"], "--tree and --keep exclude"),
    (["--look", "--keep nothing"], "--keep")])
def test_what_does_not_go(tmp_path, words, said):
    done = run_cli("build", car().write(tmp_path / "car.glb"), "-o", tmp_path / "a.fxls", *words)
    assert_one_sentence(done, said)


def test_keep_is_refused_without_nodes_and_a_tree_stands_still(tmp_path):
    (tmp_path / "m.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    assert_one_sentence(run_cli("build", tmp_path / "m.obj", "-o", tmp_path / "a.fxls", "--keep", "*"), "m.obj", "--keep is for the nodes of a glTF file, and for o and g of an OBJ file")
    made, notes = compiler.compile_scene(str(car().write(tmp_path / "car.glb")), 4, layers="all", look=look.Look(depth=0))
    assert made.tree and not made.motions and any("left out animations (1)" in note for note in notes)


@pytest.mark.parametrize("damage, said", [
    (lambda data: data["animations"][0]["channels"][0].update(sampler=99), "a channel has no sampler"),
    (lambda data: data["animations"][0]["samplers"][0].update(output=0), "times fall|not read here"),
    (lambda data: data["animations"][0]["samplers"][0].update(interpolation="X"), "interpolation"),
    (lambda data: data.update(animations=[3]), "list of objects")])
def test_damaged_animations_are_refused(tmp_path, damage, said):
    made = car()
    damage(made.data)
    with pytest.raises(ToolError, match=said):
        compiled(made.write(tmp_path / "car.glb"))


def test_a_track_of_a_path_that_is_no_text_is_left_out(tmp_path):
    made = car()
    made.data["animations"][0]["channels"][0]["target"]["path"] = ["rotation"]
    _, notes = compiled(made.write(tmp_path / "car.glb"))
    assert any("left out tracks that move no node (1)" in note for note in notes)


# --- in a scene file ----------------------------------------------------------------------------

def test_groups_of_a_scene_file_are_nodes(tmp_path):
    car(turns=False).write(tmp_path / "car.glb")
    text = '[[objects]]\nmodel = "car.glb"\ngroup = ["wheel fl", "body"]\nanchor = "node"\nposition = [1, 2, 3]\n'
    (tmp_path / "s.toml").write_text(text)
    made, _ = toml_scene.compile_file(str(tmp_path / "s.toml"))
    assert made.objects[0].centre == (1 << 16, 2 << 16, 3 << 16) and len(made.models[0].vertices) == 16
    body = max(made.models[0].vertices)
    assert [c / 65536 for c in body] == pytest.approx([1 + 1.1, 0.3 + 0.4, 2 + 1.3], abs=1e-4)
    for change, said in (('"wheel fl", "body"', '"whel"'), ('anchor = "node"\n', 'anchor = "nod"\n')):
        (tmp_path / "s.toml").write_text(text.replace(change, said))
        with pytest.raises(ToolError, match="nearest name|did you mean"):
            toml_scene.compile_file(str(tmp_path / "s.toml"))
    (tmp_path / "s.toml").write_text('[[objects]]\nsolid = "box"\nanchor = "node"\n')
    with pytest.raises(ToolError, match='"node" needs a group'):
        toml_scene.compile_file(str(tmp_path / "s.toml"))


# --- o and g of an OBJ file -----------------------------------------------------------------------

def house(path, lid=True):
    """A cube, in the groups box and lid; two tetrahedra beside it, wheel 1 and wheel 2, of which g names one more."""
    points = [(x, y, z) for y in (0, 1) for x, z in ((0, 0), (1, 0), (1, 1), (0, 1))]
    lines = [f"v {x} {y} {z}" for x, y, z in points]
    for x in (3, 5):
        lines += [f"v {x + a} {b} {c}" for a, b, c in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
    lines += ["o box", "f 1 2 3 4", "f 1 5 6 2", "f 2 6 7 3", "f 3 7 8 4", "f 4 8 5 1", *(["g lid", "f 8 7 6 5"] if lid else []), "g rest"]
    for first, names in ((9, "o wheel 1"), (13, "o wheel 2\ng spare")):
        a, b, c, d = range(first, first + 4)
        lines += [names, f"f {a} {c} {b}", f"f {a} {b} {d}", f"f {a} {d} {c}", f"f {b} {c} {d}"]
    path.write_text("\n".join(lines) + "\n")
    return path


def test_groups_that_keep_names_are_objects(tmp_path):
    path = house(tmp_path / "m.obj")
    whole, _ = compiled(path)
    for keep, names in (("wheel*", [None, "wheel 1", "wheel 2"]), ("spare,wheel*", [None, "wheel 1", "wheel 2"]),
                        ("spare", [None, "spare"]), ("lid", [None, "lid"]), ("box,wheel 1,spare", ["box", "wheel 1", "spare"]),
                        ("*", ["box", "wheel 1", "wheel 2"])):
        made, _ = compiled(path, keep=keep)
        assert made.names == names and len(made.placements) == len(names) - (None in names) and not made.motions
        assert sum(len(model.faces) for model in (made.models[each.model] for each in made.objects)) == len(whole.models[0].faces)
        assert {tuple((point * 65536).round()) for number in range(len(made.objects)) for point in placed(made, number, 0)} == \
            {tuple((point * 65536).round()) for point in placed(whole, 0, 0)}
    assert run_cli("export", "--c", path, "-o", tmp_path / "m.h", "--keep", "wheel*").returncode == 0
    assert re.findall(r"M_INSTANCE_(\w+) = \d", (tmp_path / "m.h").read_text()) == ["WHEEL_1", "WHEEL_2"]


def test_a_kept_group_turns_about_its_middle(tmp_path):
    made, _ = compiled(house(tmp_path / "m.obj"), keep="wheel 1")
    points = placed(made, 1, 0)
    centre = numpy.array(made.objects[1].centre) / 65536
    assert abs((points.min(axis=0) + points.max(axis=0)) / 2 - centre).max() < 1e-4


def test_a_part_that_is_cut_off_a_closed_model_shows_its_front_alone(tmp_path):
    made, _ = compiled(house(tmp_path / "m.obj"), keep="lid")
    assert sorted(len(made.models[each.model].faces) for each in made.objects) == [1, 13]
    made, _ = compiled(house(tmp_path / "open.obj", lid=False), keep="wheel 1")
    assert sorted(len(made.models[each.model].faces) for each in made.objects) == [4, 2 * 9]


def test_what_keep_does_not_find_in_groups_is_said(tmp_path):
    with pytest.raises(ToolError, match='--keep: no group has a name like "whel 1"; the nearest is "wheel 1"'):
        compiled(house(tmp_path / "m.obj"), keep="whel 1")


@pytest.mark.parametrize("name, keep", [("m.obj", "lid"), ("m.obj", "spare,wheel*"), ("m.glb", "hinge")])
def test_a_scene_file_of_what_is_kept_gives_the_same_frames(tmp_path, name, keep):
    path = house(tmp_path / name) if name == "m.obj" else hinged().write(tmp_path / name)
    assert run_cli("build", path, "-o", tmp_path / "a.fxls", "--keep", keep, "--write", tmp_path / "s.toml").returncode == 0
    assert run_cli("build", tmp_path / "s.toml", "-o", tmp_path / "b.fxls").returncode == 0
    assert (tmp_path / "a.fxls").read_bytes() == (tmp_path / "b.fxls").read_bytes()


def test_without_leaves_groups_out(tmp_path):
    house(tmp_path / "m.obj")
    text = '[[objects]]\nmodel = "m.obj"\n{}\n'
    for keys, faces in (('without = "lid"', 13), ('without = ["lid", "box"]', 8), ('group = ["box", "wheel 1"]\nwithout = "lid"', 9)):
        (tmp_path / "s.toml").write_text(text.format(keys))
        made, _ = toml_scene.compile_file(str(tmp_path / "s.toml"))
        assert len(made.models[0].faces) == faces
    for keys, said in (('without = "lit"', 'no group "lit"; the nearest name is "lid"'), ('group = "lid"\nwithout = "box"', "no face of m.obj is left"),
                       ("without = 3", "without")):
        (tmp_path / "s.toml").write_text(text.format(keys))
        with pytest.raises(ToolError, match=said):
            toml_scene.compile_file(str(tmp_path / "s.toml"))
