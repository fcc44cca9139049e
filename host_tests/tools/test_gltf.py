# SPDX-License-Identifier: MIT
"""The reader of glTF: against trimesh, and what it refuses."""

import copy
import struct

import numpy
import pytest
import trimesh

from fixel.model import gltf
from fixel.base.errors import ToolError
from fixel.model.mesh import UNIT
from fixel.scene import compiler
from model_files import SQUARE, TETRAHEDRON, assert_refused, glb, gltf as make, gltf_text, png

TREE = [{"children": [1, 2], "translation": [3, -2, 1], "rotation": [0, 0.6, 0, 0.8]},
        {"mesh": 0, "name": "left", "scale": [2, 1, 0.5], "children": [3]},
        {"matrix": [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1], "mesh": 0},
        {"mesh": 0, "rotation": [0.5, 0.5, 0.5, 0.5], "scale": [1, 1, -1]}]


def read(tmp_path, data, name="model.glb"):
    (tmp_path / name).write_bytes(data)
    return gltf.read(str(tmp_path / name), name)


def corners_of(mesh):
    """Each face's corners as coordinates of the file, in the file's order, from the least on: a sorted list."""
    return sorted(from_least([(x / UNIT, y / UNIT, -z / UNIT) for x, y, z in (mesh.vertices[c] for c in reversed(face))])
                  for face in mesh.faces)


def from_least(points):
    """An outline that begins at its least corner."""
    points = [tuple(round(float(c), 6) for c in point) for point in points]
    start = points.index(min(points))
    return points[start:] + points[:start]


def by_trimesh(file):
    scene, found = trimesh.load_scene(file), []
    for node in scene.graph.nodes_geometry:
        matrix, name = scene.graph[node]
        geometry = scene.geometry[name]
        points = geometry.vertices @ matrix[:3, :3].T + matrix[:3, 3]
        for three in geometry.faces[:, ::-1 if numpy.linalg.det(matrix) < 0 else 1]:
            found.append(from_least([points[corner] for corner in three]))
    return sorted(found)


@pytest.mark.parametrize("pack, name", [(glb, "model.glb"), (gltf_text, "model.gltf")])
def test_nodes_place_the_triangles_as_trimesh_does(tmp_path, pack, name):
    data, blob = make(*TETRAHEDRON, nodes=TREE)
    mesh, _ = read(tmp_path, pack(data, blob), name)
    ours, theirs = corners_of(mesh), by_trimesh(tmp_path / name)
    assert len(ours) == 12 == len(theirs)
    assert numpy.allclose(numpy.array(ours), numpy.array(theirs), atol=1e-12)


@pytest.mark.parametrize("mode", [5, 6])
def test_strips_and_fans(tmp_path, mode):
    data, blob = make(*SQUARE)
    part = data["meshes"][0]["primitives"][0]
    part["mode"] = mode
    data["accessors"][part["indices"]]["count"] = 4
    strip = (0, 1, 3, 2) if mode == 5 else (0, 1, 2, 3)
    offset = data["bufferViews"][1]["byteOffset"]
    blob = blob[:offset] + struct.pack("<4H", *strip) + blob[offset + 8:]
    mesh, _ = read(tmp_path, glb(data, blob))
    wanted = {5: [(0, 1, 3), (1, 2, 3)], 6: [(0, 1, 2), (0, 2, 3)]}[mode]
    assert corners_of(mesh) == sorted(from_least([SQUARE[0][c] for c in three]) for three in wanted)
    assert all(mesh.places)


def test_points_and_lines_are_left_out(tmp_path):
    data, blob = make()
    data["meshes"][0]["primitives"].append({**data["meshes"][0]["primitives"][0], "mode": 1})
    mesh, notes = read(tmp_path, glb(data, blob))
    assert len(mesh.faces) == 2 and any("points and lines: 1" in note for note in notes)


def test_colours_of_materials(tmp_path):
    mesh, _ = read(tmp_path, glb(*make(material={"baseColorFactor": [1, 0.2158605, 0, 1]})))
    assert mesh.surfaces.colours()[0] == (255, 128, 0)      # the factor is light, the colour a screen's


def test_colours_of_vertices(tmp_path):
    mesh, _ = read(tmp_path, glb(*make(colours=[(255, 0, 0, 255)] * 4, material={})))
    assert mesh.surfaces.colours()[1] == (255, 0, 0)


def test_an_image_colours_each_face_by_what_lies_on_it(tmp_path):
    image = png([[(200, 0, 0)] * 4 + [(0, 100, 0)] * 4] * 8)
    data, blob = make([(0, 0, 0), (1, 0, 0), (1, 1, 0), (2, 0, 0), (3, 0, 0), (3, 1, 0)], [(0, 1, 2), (3, 4, 5)],
                      uvs=[(0, 0), (0.4, 0), (0.4, 0.9), (0.6, 0), (1, 0), (1, 0.9)], image=image)
    mesh, _ = read(tmp_path, glb(data, blob))
    assert mesh.surfaces.colours() == [(200, 0, 0), (0, 100, 0)]


def test_images_and_buffers_beside_the_file(tmp_path):
    data, blob = make(uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], image=png([[(10, 20, 30)]]))
    (tmp_path / "part one.bin").write_bytes(blob)
    (tmp_path / "skin.png").write_bytes(png([[(40, 50, 60)]]))
    data["buffers"][0]["uri"], data["images"][0] = "part%20one.bin", {"uri": "skin.png"}
    (tmp_path / "model.gltf").write_text(__import__("json").dumps(data))
    mesh, _ = gltf.read(str(tmp_path / "model.gltf"), "model.gltf")
    assert mesh.surfaces.colours()[0] == (40, 50, 60)


def test_a_mirrored_node_keeps_its_fronts_outside(tmp_path):
    (tmp_path / "model.glb").write_bytes(glb(*make(*TETRAHEDRON, nodes=[{"mesh": 0, "scale": [-1, 1, 1]}])))
    compiled, notes = compiler.compile_scene(str(tmp_path / "model.glb"), 4)
    assert not any("turned round" in note or "inside out" in note for note in notes)
    assert compiled.models[0].kind == 0 and len(compiled.models[0].faces) == 4


# --- refusals -----------------------------------------------------------------------

def changed(path, value):
    """The sound file's JSON with a value at a path of keys."""
    data, blob = make(uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], image=png([[(1, 2, 3)]]))
    data, place = copy.deepcopy(data), None
    place = data
    for key in path[:-1]:
        place = place[key]
    if value is None:
        del place[path[-1]]
    else:
        place[path[-1]] = value
    return glb(data, blob)


def vertices(*values):
    data, blob = make([values, (1, 0, 0), (1, 1, 0), (0, 1, 0)])
    return glb(data, blob)


BAD = {
    "cycle": (changed(["nodes"], [{"children": [1]}, {"children": [0], "name": "knot"}]), ["node 0", "cycle"]),
    "knot": (changed(["nodes"], [{"children": [1, 1]}, {"mesh": 0}]), ["node 1", "one parent"]),
    "no node": (changed(["scenes"], [{"nodes": [7]}]), ["node 7 does not exist"]),
    "child": (changed(["nodes"], [{"children": ["x"], "name": "arm"}]), ['node 0 ("arm")', "children"]),
    "NaN": (vertices(float("nan"), 0, 0), ['node 0 ("thing")', "mesh 0, primitive 0", "x of vertex 0 is nan"]),
    "huge": (vertices(0, 3e30, 0), ["y of vertex 0", "1,000,000,000"]),
    "matrix": (changed(["nodes", 0, "matrix"], [1e300] * 16), ["node 0", "matrix"]),
    "two numbers": (changed(["nodes", 0, "translation"], [1, 2]), ["node 0", "translation must be 3 numbers"]),
    "no list": (changed(["nodes", 0, "translation"], 1), ["node 0", "translation must be 3 numbers"]),
    "truth": (changed(["nodes", 0, "scale"], [1, True, 1]), ["node 0", "scale must be 3 numbers"]),
    "word": (changed(["nodes", 0, "scale"], [1, "2", 1]), ["node 0", "scale must be 3 numbers"]),
    "rotation": (changed(["nodes", 0, "rotation"], [0, 0, 0, 0]), ["node 0", "rotation"]),
    "infinite": (changed(["nodes", 0, "scale"], [float("inf"), 1, 1]), ["value Infinity", "not a number of JSON"]),
    "no faces": (changed(["nodes"], [{"name": "empty"}]), ["no face"]),
    "buffer": (changed(["buffers", 0, "byteLength"], 1 << 31), ["buffer 0", "2,147,483,648 bytes are promised"]),
    "view": (changed(["bufferViews", 0, "byteLength"], 1 << 20), ["buffer view reaches"]),
    "count": (changed(["accessors", 0, "count"], 200_000), ["accessor 0", "do not fit"]),
    "absurd count": (changed(["accessors", 0, "count"], 1 << 31), ["accessor 0", "2,147,483,648 values do not fit"]),
    "stride": (changed(["bufferViews", 0, "byteStride"], 4), ["accessor 0"]),
    "index": (changed(["accessors", 0, "count"], 2), ["indices name vertex 3 of 2"]),
    "sparse": (changed(["accessors", 0, "sparse"], {}), ["sparse"]),
    "no accessor": (changed(["meshes", 0, "primitives", 0, "indices"], 99), ["accessor 99 does not exist"]),
    "no position": (changed(["meshes", 0, "primitives", 0, "attributes"], {}), ["no POSITION"]),
    "texture": (changed(["images", 0], {"uri": "gone.png"}), ["image 0", '"gone.png"', "model's folder"]),
    "outside": (changed(["images", 0], {"uri": "../../etc/passwd"}), ["image 0", "there is no file", "../../etc/passwd"]),
    "address": (changed(["images", 0], {"uri": "https://example.org/a.png"}), ["image 0", "model's folder"]),
    "image": (changed(["images", 0, "bufferView"], 0), ["image 0", "cannot be read"]),
    "material": (changed(["meshes", 0, "primitives", 0, "material"], 5), ["material 5 does not exist"]),
    "version": (changed(["asset", "version"], "1.0"), ['"1.0"', "only 2.0"]),
    "extension": (changed(["extensionsRequired"], ["KHR_draco_mesh_compression"]), ["KHR_draco_mesh_compression"]),
    "no JSON": (b"{nonsense", ["not JSON"]),
    "deep": (b"[" * 100_000, ["nested"]),
    "list": (b"[]", ["not a glTF file"]),
    "digits": (b'{"asset": ' + b"9" * 9000 + b"}", ["thousands of digits"]),
    "header": (struct.pack("<4sII", b"glTF", 2, 1 << 31) + bytes(40), ["header promises 2,147,483,648 bytes"]),
    "part": (struct.pack("<4sIIII", b"glTF", 2, 40, 1 << 31, 0x4E4F534A) + bytes(20), ["promises 2,147,483,648 bytes"]),
    "old": (struct.pack("<4sII", b"glTF", 1, 12), ["version 1"]),
}


@pytest.mark.parametrize("kind", BAD)
def test_what_is_wrong_is_said_in_one_sentence(tmp_path, kind):
    assert_refused(read, tmp_path, *BAD[kind], most=400)


def test_nodes_that_read_the_same_part_often(tmp_path):
    """Few bytes, much work."""
    data, blob = make(*TETRAHEDRON, nodes=[{"mesh": 0}] * 8000)
    data["scenes"][0]["nodes"] = list(range(8000))
    data["meshes"][0]["primitives"] *= 100
    with pytest.raises(ToolError, match="65,535 primitives"):
        read(tmp_path, glb(data, blob))


def test_a_part_that_is_cut_off_behind_its_head_is_refused(tmp_path):
    data, blob = make()
    whole = glb(data, blob)
    cut = bytearray(whole[:len(whole) - len(blob)])
    struct.pack_into("<I", cut, 8, len(cut))
    with pytest.raises(ToolError, match=f"a part promises {len(blob):,} bytes and 0 are there"):
        read(tmp_path, bytes(cut))
