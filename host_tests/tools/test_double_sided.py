# SPDX-License-Identifier: MIT
"""doubleSided of a glTF material: which faces show from both sides."""

import json

import pytest

from conftest import run_cli
from fixel.base.errors import ToolError
from fixel.image import image
from fixel.scene import compiler, look, toml_scene
from model_files import File, SQUARE, TETRAHEDRON, glb, gltf


def faces(path, wanted=look.Look()):
    made, notes = compiler.compile_scene(str(path), 4, look=wanted)
    assert image.unpack(image.pack(made)) == made
    return sum(len(model.faces) for model in made.models), notes


def square(tmp_path, **material):
    data, blob = gltf(*SQUARE, material={})
    data["materials"][0] |= material
    (tmp_path / "m.glb").write_bytes(glb(data, blob))
    return tmp_path / "m.glb"


@pytest.mark.parametrize("wanted", [look.Look(), look.PLAIN])
def test_an_open_model_shows_its_backs_if_its_material_says_so(tmp_path, wanted):
    for value, count in ((True, 2), (False, 1), (None, 1)):     # two triangles in a plane are one face
        found, notes = faces(square(tmp_path, **({} if value is None else {"doubleSided": value})), wanted)
        assert found == count
        assert any(f"show {count - 1} of 1 faces from both sides" in note for note in notes)


def test_a_closed_model_has_no_backs_unless_one_sees_through_it(tmp_path):
    for material, count in (({"doubleSided": True}, 4), ({"doubleSided": True, "alphaMode": "MASK"}, 8), ({"alphaMode": "BLEND"}, 4)):
        data, blob = gltf(*TETRAHEDRON, material={})
        data["materials"][0] |= material
        (tmp_path / "m.glb").write_bytes(glb(data, blob))
        assert faces(tmp_path / "m.glb")[0] == count


def test_each_material_says_it_for_its_own_faces(tmp_path):
    made = File({"children": [1, 2]}, {"name": "flag", "mesh": 0}, {"name": "wall", "mesh": 1, "translation": [0, 0, 2]})
    for _ in range(2):
        made.data["meshes"].append({"primitives": [{"attributes": {"POSITION": made.add(SQUARE[0], "<f4", "VEC3")}, "material": len(made.data["materials"]),
                                                    "indices": made.add([c for three in SQUARE[1] for c in three], "<u2", "SCALAR")}]})
        made.data["materials"].append({"doubleSided": not made.data["materials"]})
    path = made.write(tmp_path / "m.glb")
    scene, _ = compiler.compile_scene(str(path), 4, look=look.Look())
    assert {name: len(scene.models[each.model].faces) for name, each in zip(scene.names, scene.objects)} == {"flag": 2, "wall": 1}
    whole, _ = compiler.compile_scene(str(path), 4, look=look.Look(depth=0))
    assert [len(model.faces) for model in whole.models] == [3]


def test_a_flag_is_seen_from_behind_and_a_wall_is_not(build, tmp_path):
    shown = []
    for value in (True, False):
        done = run_cli("run", "--board", "mps2-an385", "--scene", square(tmp_path, doubleSided=value), "--frames", 4, "--out", tmp_path / "run")
        assert done.returncode == 0, done.stderr
        summary = json.loads((tmp_path / "run" / "summary.json").read_text())
        assert summary["pixels_unexplained"] == 0 and summary["host_frames_equal"]
        assert summary["order_wrong_pixels"] == 0 and summary["order_judged_pixels"] > 0      # the back of the wall is not there
        from fixel.board import dump
        shown.append([bool((frame.pixels != frame.pixels[0, 0]).any()) for frame in dump.read_dump(tmp_path / "run" / "board.fxld").frames])
    assert all(shown[0]) and any(shown[1]) and not all(shown[1])


def test_two_sided_of_a_scene_file(tmp_path):
    square(tmp_path, doubleSided=True)
    (tmp_path / "m.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    text = '[[objects]]\nmodel = "{}"\ntwo_sided = {}\n'
    for name, value, count in (("m.glb", '"file"', 2), ("m.glb", "false", 1), ("m.glb", '"open"', 2)):
        (tmp_path / "s.toml").write_text(text.format(name, value))
        made, _ = toml_scene.compile_file(str(tmp_path / "s.toml"))
        assert len(made.models[0].faces) == count
    for name, value, said in (("m.obj", '"file"', "is for a glTF file"), ("m.glb", '"both"', 'expected true, false, "open" or "file"')):
        (tmp_path / "s.toml").write_text(text.format(name, value))
        with pytest.raises(ToolError, match=said):
            toml_scene.compile_file(str(tmp_path / "s.toml"))
