# SPDX-License-Identifier: MIT
"""Skins of glTF: where faces that hang on joints stand without an animation, how they move with one, and that nothing of one skeleton
parts from the rest of it."""

import json
import math

import numpy
import pytest

from conftest import run_cli
from fixel.model import gltf, gltf_nodes
from fixel.model.mesh import UNIT
from fixel.scene import framing, look, model_parts, toml_scene
from model_files import BONES, CORNERS, File, Limbs, SIDES, about_x, binds, biped, places_of
from test_gltf_nodes import by_name, compiled, placed, scale_of

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "host/frames", "host/judge", "host/raycast", "host/predict")
PARTS = ["hip", "shoulder", "elbow"]


def figure(soft=False, moves=True):
    """A trunk, an upper arm and a forearm of one mesh on three joints; the elbow bends by 90 degrees in one second. The joints stand
    elsewhere than when the mesh was bound: 5 units higher. soft: one corner of the trunk hangs on the shoulder too."""
    made = File({"name": "figure", "mesh": 0, "skin": 0, "translation": [9, 9, 9]}, {"name": "hip", "children": [2], "translation": [0, 5, 0]},
                {"name": "shoulder", "children": [3], "translation": [0, 2, 0]}, {"name": "elbow", "translation": [1, 0, 0]}, roots=[0, 1])
    boxes = [((1, 2, 1), (0, 1, 0)), ((1, 0.4, 0.4), (0.5, 2, 0)), ((1, 0.4, 0.4), (1.5, 2, 0))]
    points = [[c * s + m for c, s, m in zip(corner, size, middle)] for size, middle in boxes for corner in CORNERS]
    joints = [[joint, 0, 0, 0] for joint in range(3) for _ in CORNERS]
    weights = [[1, 0, 0, 0]] * len(points)
    if soft:
        joints[0], weights = [0, 1, 0, 0], [[0.5, 0.5, 0, 0], *weights[1:]]
    made.data["meshes"].append({"primitives": [{"attributes": {
        "POSITION": made.add(points, "<f4", "VEC3"), "JOINTS_0": made.add(joints, "<u1", "VEC4"), "WEIGHTS_0": made.add(weights, "<f4", "VEC4")},
        "indices": made.add((numpy.array(SIDES)[None] + 8 * numpy.arange(3)[:, None, None]).ravel(), "<u2", "SCALAR")}]})
    made.data["skins"] = [{"joints": [1, 2, 3], "inverseBindMatrices": binds(made, [(0, 0, 0), (0, 2, 0), (1, 2, 0)])}]
    if moves:
        half = math.radians(45)
        made.animate((3, "rotation", [0, 1], [[0, 0, 0, 1], [0, 0, math.sin(half), math.cos(half)]]))
    return made


def damaged(change, **how):
    """A figure after a change."""
    made = figure(**how)
    change(made, made.data["meshes"][0]["primitives"][0]["attributes"])
    return made


@pytest.mark.parametrize("soft", [False, True])
def test_each_face_of_a_skin_moves_with_one_joint(tmp_path, soft):
    made, notes = compiled(figure(soft).write(tmp_path / "m.glb"))
    assert made.names == PARTS and len(made.motions) == 1
    assert not any("left out" in note for note in notes)
    scale, hip = scale_of(made, 0, 1), placed(made, 0, 0)
    hip = (hip.min(axis=0) + hip.max(axis=0)) / 2
    for frame in (0, 10, 29):
        angle = math.radians(90 * frame / 30)
        middle = placed(made, 2, frame).mean(axis=0) - hip
        wanted = numpy.array([1 + 0.5 * math.cos(angle), 1 + 0.5 * math.sin(angle), 0]) * scale
        assert abs(middle - wanted).max() < 3e-3 * scale
    mesh, _ = gltf.read(str(tmp_path / "m.glb"))
    assert min(y for _, y, _ in mesh.vertices) == 5 * UNIT      # where the joints stand


def test_a_figure_that_stands_still_is_one_object_unless_joints_are_kept(tmp_path):
    path = figure(moves=False).write(tmp_path / "s.glb")
    for wanted, names in (({}, ["figure"]), ({"keep": "elbow"}, PARTS)):
        still, notes = compiled(path, **wanted)
        assert still.names == names and not still.motions and not any("left out" in note for note in notes)
    moving = figure().write(tmp_path / "m.glb")
    none, notes = compiled(moving, animation="none")
    assert none.models == compiled(path)[0].models and not none.motions and sum("left out animations (1)" in note for note in notes) == 1
    done = run_cli("build", moving, "-o", tmp_path / "n.fxls", "--animation", "none")
    assert done.returncode == 0 and "left out animations (1)" in done.stderr and "--animation" not in done.stderr


def test_groups_of_a_scene_file_are_the_mesh_and_its_joints(tmp_path):
    figure().write(tmp_path / "m.glb")
    for keys, faces in (('group = "figure"', 36), ('group = "elbow"', 12), ('group = "figure"\nwithout = "hip"', 24)):
        (tmp_path / "s.toml").write_text(f'[[objects]]\nmodel = "m.glb"\n{keys}\nmerge = false\n')
        assert [len(model.faces) for model in toml_scene.compile_file(str(tmp_path / "s.toml"))[0].models] == [faces]


@pytest.mark.parametrize("make, frames", [(figure, 10), (biped, 16)])
def test_a_figure_is_drawn_as_double_draws_it(build, tmp_path, make, frames):
    done = run_cli("run", "--board", "mps2-an385", "--scene", make().write(tmp_path / "m.glb"), "--frames", frames, "--out", tmp_path / "run")
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "run" / "summary.json").read_text())
    assert summary["pixels_unexplained"] == 0 and summary["order_wrong_pixels"] == 0 and summary["host_frames_equal"]


@pytest.mark.parametrize("weight, is_alone", [(0, True), (1, False)])
def test_a_second_set_of_joints_counts(tmp_path, weight, is_alone):
    made = figure()
    made.data["meshes"][0]["primitives"][0]["attributes"] |= {"JOINTS_1": made.add([[2, 0, 0, 0]] * 24, "<u1", "VEC4"),
                                                               "WEIGHTS_1": made.add([[2 * weight, 0, 0, 0]] * 24, "<f4", "VEC4")}
    scene, notes = compiled(made.write(tmp_path / "m.glb"))
    assert scene.names == (PARTS if is_alone else ["elbow"])
    assert any("hang on several joints" in note and ": 24;" in note for note in notes) != is_alone


def test_a_skinned_node_without_faces_is_no_part(tmp_path):
    made = figure()
    made.data["accessors"].append({**made.data["accessors"][made.data["meshes"][0]["primitives"][0]["indices"]], "count": 0})
    made.data["meshes"].append({"primitives": [{**made.data["meshes"][0]["primitives"][0], "indices": len(made.data["accessors"]) - 1}]})
    made.data["nodes"].append({"name": "nothing", "mesh": 1, "skin": 0})
    made.data["scenes"][0]["nodes"].append(4)
    assert compiled(made.write(tmp_path / "m.glb"))[0].names == PARTS


def hat(made, *shares):
    """A figure with a hat of its own mesh, whose corners hang on these joints in turn."""
    made.data["nodes"].append({"name": "hat", "mesh": 1, "skin": 0})
    made.data["scenes"][0]["nodes"].append(len(made.data["nodes"]) - 1)
    rows = [shares[number % len(shares)] for number in range(8)]
    made.box((1, 0.5, 1), middle=(0.5, 3, 0), JOINTS_0=made.add([[*row, 0, 0, 0][:4] for row in rows], "<u1", "VEC4"),
             WEIGHTS_0=made.add([[1 / len(row)] * len(row) + [0] * (4 - len(row)) for row in rows], "<f4", "VEC4"))
    return made


def test_several_meshes_may_hang_on_one_joint(tmp_path):
    """A hat of its own mesh hangs on the shoulder, where a part of the first mesh hangs too."""
    scene, notes = compiled(hat(figure(), [1]).write(tmp_path / "m.glb"))
    assert scene.names == PARTS and not any("left out" in note for note in notes)
    mesh, _ = gltf.read(str(tmp_path / "m.glb"))
    assert max(y for _, y, _ in mesh.vertices) == (3 + 0.25 + 5) * UNIT        # as the joints stand: 5 higher than bound


def raised(arm, hand):
    """A trunk, an arm and a hand, three meshes on one skeleton whose shoulder turns by 90 degrees; arm, hand: the joints of their corners."""
    made = File({"name": "trunk", "mesh": 0, "skin": 0}, {"name": "arm", "mesh": 1, "skin": 0}, {"name": "hand", "mesh": 2, "skin": 0},
                {"name": "hip", "children": [4]}, {"name": "shoulder", "children": [5]}, {"name": "finger", "translation": [2, 0, 0]}, roots=[0, 1, 2, 3])
    for size, middle, shares in (((1, 2, 1), (-0.5, 0, 0), [0]), ((2, 0.5, 0.5), (1, 0, 0), arm), ((0.8, 0.8, 0.8), (2.4, 0, 0), hand)):
        made.box(size, middle=middle, JOINTS_0=made.add([[*shares, 0, 0, 0][:4]] * 8, "<u1", "VEC4"),
                 WEIGHTS_0=made.add([[1 / len(shares)] * len(shares) + [0] * (4 - len(shares))] * 8, "<f4", "VEC4"))
    made.data["skins"] = [{"joints": [3, 4, 5], "inverseBindMatrices": binds(made, [(0, 0, 0), (0, 0, 0), (2, 0, 0)])}]
    made.animate((4, "rotation", [0, 1], [[0, 0, 0, 1], [0, 0, math.sin(math.pi / 4), math.cos(math.pi / 4)]]))
    return made


def test_meshes_on_one_joint_and_on_two_rise_together(tmp_path):
    """The arm hangs on the shoulder, the hand on the shoulder and the finger."""
    for hand in ([1, 2], [2]):
        made, _ = compiled(raised([1], hand).write(tmp_path / "m.glb"))
        at = {frame: numpy.concatenate([placed(made, number, frame) for number in range(len(made.names))]) for frame in (0, 29)}
        heights = [points[:, 1].max() - points[:, 1].min() for points in at.values()]
        assert heights[1] > 1.8 * heights[0]
        scale, turn = heights[0] / 2, math.radians(90 * 29 / 30)
        shoulder = numpy.array([at[0][:, 0].min() + scale, (at[0][:, 1].min() + at[0][:, 1].max()) / 2])
        rotation = numpy.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
        moved = [name for name in made.names if name != "hip"]
        for name in moved:      # all that moves turns about the shoulder as one
            number = by_name(made)[name]
            wanted = (placed(made, number, 0)[:, :2] - shoulder) @ rotation.T + shoulder
            assert abs(placed(made, number, 29)[:, :2] - wanted).max() < 5e-3 * scale
        assert sum(len(made.models[made.objects[by_name(made)[name]].model].faces) for name in moved) >= 12


def matrix_of(place, turn=(0, 0, 0, 1)):
    x, y, z, w = turn
    made = numpy.eye(4)
    made[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)], [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                    [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    made[:3, 3] = place
    return made


def test_a_biped_walks_as_its_joints_do(tmp_path):
    """Each part, the hat of the head's node too, stands in a frame where its joint takes it; what a part has at rest is what the file has."""
    made, notes = compiled(biped().write(tmp_path / "m.glb"))
    assert sum("on which they hang the most: 90;" in note for note in notes) == 1
    numbers, places = by_name(made), places_of(BONES)
    assert set(numbers) == {*BONES, "hat"}
    mesh, _ = gltf.read(str(tmp_path / "m.glb"))
    assert sorted(number for name in numbers for number in mesh.numbers_of([name])) == list(range(len(mesh.faces)))     # each face once
    hips = placed(made, numbers["hat"], 0)
    scale = (hips[:, 0].max() - hips[:, 0].min()) / 0.7
    turns = {"thigh left": -35, "shin left": 60, "arm left": 30, "hand left": -40, "thigh right": 35, "shin right": 0, "arm right": -30, "hand right": 0}
    rests = {"shin": 30, "hand": -20}
    middle = hips.mean(axis=0) - numpy.array([0, places["head"][1] + 0.65, 0]) * scale     # the file's origin, with the hips at rest

    def worlds(quarter):
        found = {}
        for name, (above, place) in BONES.items():
            turn = (turns[name] if quarter else rests.get(name.split()[0], 0)) if name in turns else 0
            place = (0, 2 + 0.05 * quarter, 0) if name == "hips" else place
            found[name] = (found[above] if above else numpy.eye(4)) @ matrix_of(place, about_x(turn))
        return found
    begun, ended = worlds(0), worlds(1)
    flip = numpy.diag([1.0, 1, -1, 1])
    for name, number in numbers.items():
        joint = "head" if name == "hat" else name
        way = flip @ ended[joint] @ numpy.linalg.inv(begun[joint]) @ flip
        before = (placed(made, number, 0) - middle) / scale
        wanted = before @ way[:3, :3].T + way[:3, 3]
        assert abs((placed(made, number, 15) - middle) / scale - wanted).max() < 5e-3, name


def test_without_an_animation_the_vertices_stand_as_gltf_has_them(tmp_path):
    """A tube whose middle ring hangs on two joints, of which the upper one stands turned; normals turn with it."""
    made, limbs = File({"name": "tube", "mesh": 0, "skin": 0, "translation": [7, 7, 7], "scale": [3, 3, 3]},
                       {"name": "lower", "children": [2], "scale": [1, 1, 2]}, {"name": "upper", "translation": [0, 2, 0], "rotation": about_x(90)},
                       roots=[0, 1]), Limbs()
    limbs.add(1, ((0, 0, 0), 0.5, {0: 1}), ((0, 2, 0), 0.5, {0: 0.25, 1: 0.75}), ((0, 4, 0), 0.5, {1: 1}))
    limbs.mesh(made, "tube")
    made.data["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = made.add([(0, 1, 0)] * len(limbs.points), "<f4", "VEC3")
    made.data["skins"] = [{"joints": [1, 2], "inverseBindMatrices": binds(made, [(0, 0, 0), (0, 2, 0)])}]
    mesh, notes = gltf.read(str(made.write(tmp_path / "m.glb")))
    worlds = [numpy.diag([1.0, 1, 2, 1]), numpy.diag([1.0, 1, 2, 1]) @ matrix_of((0, 2, 0), about_x(90))]
    steps = [worlds[0], worlds[1] @ matrix_of((0, -2, 0))]
    wanted = set()
    for point, joints, weights in zip(limbs.points, limbs.joints, limbs.weights):
        moved = sum(weight * (steps[joint] @ [*point, 1])[:3] for joint, weight in zip(joints, weights))
        wanted.add(tuple(numpy.round(moved * (1, 1, -1), 5) + 0.0))
    assert {tuple(numpy.round([c / UNIT for c in vertex], 5) + 0.0) for vertex in mesh.vertices} == wanted
    assert not any("left out" in note for note in notes)
    ends = [normal for face, normals in zip(mesh.faces, mesh.normals) for corner, normal in zip(face, normals)
            if mesh.vertices[corner][2] < -3 * UNIT]
    assert ends and all(normal == pytest.approx((0, 0, -1), abs=1e-6) for normal in ends)
    del made.data["skins"][0]["inverseBindMatrices"]        # then the vertices are those of each joint
    mesh, _ = gltf.read(str(made.write(tmp_path / "n.glb")))
    assert max(abs(z) for _, _, z in mesh.vertices) == pytest.approx(8 * UNIT, rel=1e-6)


def test_a_mesh_that_a_joint_mirrors_looks_outward(tmp_path):
    made = figure(moves=False)
    made.data["nodes"][1]["scale"] = [-1, 1, 1]
    whole, notes = compiled(made.write(tmp_path / "m.glb"))
    plain, _ = compiled(figure(moves=False).write(tmp_path / "s.glb"))
    assert len(whole.models[0].faces) == len(plain.models[0].faces) and not any("turned round" in note for note in notes)


def test_joints_that_are_stretched_as_they_stand_move_and_as_they_move_are_told(tmp_path):
    made = figure()
    made.data["nodes"][1]["scale"] = [1, 3, 1]
    made.data["nodes"][3]["rotation"] = [0, 0, 1, 0]
    scene, notes = compiled(made.write(tmp_path / "m.glb"))
    assert len(scene.motions) == 1 and any("stretched in one direction as they move have one size in all: 1 (first: elbow)" in note for note in notes)
    made.data["nodes"][3]["children"] = [len(made.data["nodes"])]
    made.data["nodes"].append({"name": "tool", "mesh": 1, "translation": [1, 0, 0]})
    made.box()
    scene, _ = compiled(made.write(tmp_path / "m.glb"))
    numbers = by_name(scene)

    def apart(frame):
        """How far the tool is from the forearm, by the size at which this one is shown."""
        arm, tool = (placed(scene, numbers[name], frame) for name in ("elbow", "tool"))
        return math.dist(tool.mean(axis=0), arm.mean(axis=0)) / math.dist(arm[0], arm[-1])
    assert [apart(frame) for frame in (10, 20)] == pytest.approx([apart(0)] * 2, rel=0.01)      # it stays in the hand that is shown
    made = figure()
    made.data["nodes"][3]["scale"] = [1, 3, 1]
    assert not any("stretched" in note for note in compiled(made.write(tmp_path / "m.glb"))[1])


def test_a_skeleton_whose_root_moves_takes_all_along(tmp_path):
    """A node above the hip moves; the mesh's own node, which moves too, counts for nothing."""
    made = figure(moves=False)
    made.data["nodes"].append({"name": "root", "children": [1]})
    made.data["scenes"][0]["nodes"] = [0, 4]
    made.animate((4, "translation", [0, 1], [(0, 0, 0), (3, 0, 0)]), (0, "translation", [0, 1], [(0, 0, 0), (0, 90, 0)]))
    scene, _ = compiled(made.write(tmp_path / "m.glb"))
    scale = scale_of(scene, 0, 1)
    for number in range(len(scene.names)):
        assert abs(placed(scene, number, 15) - placed(scene, number, 0) - numpy.array([1.5 * scale, 0, 0])).max() < 3e-3 * scale


# --- what is not moved ----------------------------------------------------------------------------

DAMAGE = {
    "rows": lambda made, part: part.update(JOINTS_1=made.add([[0, 0, 0, 0]] * 5, "<u1", "VEC4"), WEIGHTS_1=made.add([[0, 0, 0, 0]] * 5, "<f4", "VEC4")),
    "joint": lambda made, part: made.data["skins"][0].update(joints=[1, 2, 77]),
    "outside": lambda made, part: (made.data["nodes"].append({"name": "else"}), made.data["skins"][0].update(joints=[1, 2, len(made.data["nodes"]) - 1])),
    "few": lambda made, part: made.data["skins"][0].update(joints=[1, 2]),
    "no joints": lambda made, part: part.pop("JOINTS_0"), "no weights": lambda made, part: part.pop("WEIGHTS_0"),
    "flat": lambda made, part: made.data["skins"][0].update(inverseBindMatrices=made.add([[0] * 15 + [1]] * 3, "<f4", "MAT4")),
    "few binds": lambda made, part: made.data["skins"][0].update(inverseBindMatrices=binds(made, [(0, 0, 0)])),
    "below 0": lambda made, part: part.update(WEIGHTS_0=made.add([[2, -1, 0, 0]] * 24, "<f4", "VEC4")),
    "NaN": lambda made, part: part.update(WEIGHTS_0=made.add([[math.nan, 1, 0, 0]] * 24, "<f4", "VEC4")),
    "five sets": lambda made, part: part.update({f"{key}_4": part[f"{key}_0"] for key in ("JOINTS", "WEIGHTS")}),
    "itself": lambda made, part: made.data["skins"][0].update(joints=[0, 2, 3]),
}


@pytest.mark.parametrize("kind", DAMAGE)
def test_a_damaged_skin_stays_in_the_pose_in_which_it_was_bound_and_so_does_its_skeleton(tmp_path, kind):
    """A hat that hangs on a joint as a node does not move either: nothing of the figure parts."""
    made = damaged(DAMAGE[kind])
    made.data["nodes"][3]["children"] = [len(made.data["nodes"])]
    made.data["nodes"].append({"name": "hat", "mesh": 1})
    made.box()
    scene, notes = compiled(made.write(tmp_path / "m.glb"))
    assert not scene.motions and sum("left out skins (1; first: figure)" in note for note in notes) == 1
    mesh, _ = gltf.read(str(tmp_path / "m.glb"))
    low = min(mesh.vertices[corner][1] for number in mesh.numbers_of(["figure"]) for corner in mesh.faces[number])
    assert kind == "itself" or low == 0


def test_what_shares_joints_with_a_damaged_skin_moves_with_the_whole_skeleton_alone(tmp_path):
    made = hat(damaged(lambda made, part: part.pop("WEIGHTS_0")), [2])
    made.data["nodes"].append({"name": "root", "children": [1]})
    made.data["scenes"][0]["nodes"] = [0, 4, 5]
    made.animate((5, "translation", [0, 1], [(0, 0, 0), (3, 0, 0)]), (3, "rotation", [0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]]), name="both")
    scene, _ = compiled(made.write(tmp_path / "m.glb"), animation="both")
    ways = [placed(scene, number, 15) - placed(scene, number, 0) for number in range(len(scene.names))]
    assert len(ways) == len(scene.motions) and all(abs(way - ways[0][0]).max() < 1e-3 < ways[0][0][0] for way in ways)


@pytest.mark.parametrize("module, limit", [(gltf_nodes, "_MOVES_MAX"), (model_parts, "POSES_MAX"), (framing, "KEYS_MAX")])
def test_of_an_animation_with_too_many_places_nothing_moves(tmp_path, monkeypatch, module, limit):
    monkeypatch.setattr(module, limit, 40)
    scene, notes = compiled(biped().write(tmp_path / "m.glb"))
    assert not scene.motions and sorted(scene.names) == ["figure", "hat"]
    assert sum("the limit of 40" in note and "stands still" in note for note in notes) == 1


def test_a_figure_whose_image_is_too_large_without_textures_stands_still(tmp_path):
    made, _ = compiled(biped().write(tmp_path / "m.glb"))
    still, _ = compiled(tmp_path / "m.glb", animation="none")
    wanted = look.smaller(look.Asked(), "rgb565", 16)
    assert [each.animation for each in wanted] == [""] * (len(wanted) - 1) + ["none"] and wanted[-1].smooth == wanted[-1].texels == 0
    assert look.after(wanted, made)[-1] == wanted[-1] and wanted[-1] not in look.after(wanted, still)
    assert "no animation" in look.smaller_text("m.glb", wanted[-1])
    assert all(each.animation == "walk" for each in look.smaller(look.Asked(animation="walk"), "rgb565", 16))
