# SPDX-License-Identifier: MIT
"""The reader of glTF: against trimesh, and files as other programs write them."""

import struct

import numpy
import pytest
import trimesh

from fixel.model import gltf
from fixel.base.errors import ToolError
from fixel.model.mesh import UNIT
from fixel.scene import compiler
from model_files import SQUARE, TETRAHEDRON, glb, gltf as make, gltf_text, png

BUILT_PROGRAMS = ()
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


def test_corners_that_are_no_triangle_are_left_out(tmp_path):
    data, blob = make()
    data["accessors"][1]["count"] = 5
    mesh, notes = read(tmp_path, glb(data, blob))
    assert len(mesh.faces) == 1 and any('left out: 1 x "last corners, which are no triangle" (first: node 0 ("thing"): mesh 0, primitive 0)' in note for note in notes)


def test_points_and_lines_are_left_out(tmp_path):
    data, blob = make()
    data["meshes"][0]["primitives"].append({**data["meshes"][0]["primitives"][0], "mode": 1})
    mesh, notes = read(tmp_path, glb(data, blob))
    assert len(mesh.faces) == 2 and any("points and lines: 1" in note for note in notes)
    data["meshes"][0]["primitives"] = data["meshes"][0]["primitives"][1:]
    with pytest.raises(ToolError, match="no face in this file: it has 1 primitives of points and lines"):
        read(tmp_path, glb(data, blob))


def test_colours_of_materials(tmp_path):
    mesh, _ = read(tmp_path, glb(*make(material={"baseColorFactor": [1, 0.2158605, 0, 1]})))
    assert mesh.surfaces.colours()[0] == (255, 128, 0)      # the factor is light, the colour a screen's


def test_a_part_without_a_material_is_white_and_has_the_colours_of_its_vertices(tmp_path):
    assert read(tmp_path, glb(*make()))[0].surfaces.colours()[0] == (255, 255, 255)
    assert read(tmp_path, glb(*make(colours=[(255, 0, 255, 255)] * 4)))[0].surfaces.colours()[0] == (255, 0, 255)


@pytest.mark.parametrize("down", [False, True])
def test_a_plane_that_looks_down_shows_its_back(tmp_path, down):
    """The circle lies above the model, so nothing at all would be seen."""
    points = [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)]
    (tmp_path / "model.glb").write_bytes(glb(*make(points, [(0, 1, 2), (0, 2, 3)] if down else [(0, 2, 1), (0, 3, 2)])))
    made, notes = compiler.compile_scene(str(tmp_path / "model.glb"), 4)
    assert len(made.models[0].faces) == (2 if down else 1) and any("the circle sees no face from its front" in note for note in notes) == down


def test_colours_of_vertices(tmp_path):
    mesh, _ = read(tmp_path, glb(*make(colours=[(255, 0, 0, 255)] * 4, material={})))
    assert mesh.surfaces.colours()[1] == (255, 0, 0)


def test_whole_numbers_are_colours_of_vertices_whether_they_say_so_or_not(tmp_path):
    data, blob = make(colours=[(0, 55, 255, 255)] * 4, material={})
    del data["accessors"][-1]["normalized"]
    assert read(tmp_path, glb(data, blob))[0].surfaces.colours()[1] == (0, 128, 255)


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


def test_an_image_that_is_not_there_is_a_note_and_others_are_found_by_other_names(tmp_path):
    data, blob = make(uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], image=png([[(10, 20, 30)]]), material={"baseColorFactor": [1, 0, 0, 1]})
    data["images"][0] = {"uri": "tex/Gone%20one.png"}
    mesh, notes = read(tmp_path, glb(data, blob))
    assert mesh.surfaces.colours()[0] == (255, 0, 0)
    assert sum('image 0: there is no image "tex/Gone one.png"' in note for note in notes) == 1
    (tmp_path / "gone one.PNG").write_bytes(png([[(40, 50, 60)]]))
    mesh, notes = read(tmp_path, glb(data, blob))
    assert mesh.surfaces.colours()[0] == (40, 0, 0) and sum('"gone one.PNG" is read instead' in note for note in notes) == 1


def test_a_mirrored_node_keeps_its_fronts_outside(tmp_path):
    (tmp_path / "model.glb").write_bytes(glb(*make(*TETRAHEDRON, nodes=[{"mesh": 0, "scale": [-1, 1, 1]}])))
    compiled, notes = compiler.compile_scene(str(tmp_path / "model.glb"), 4)
    assert not any("turned round" in note or "inside out" in note for note in notes)
    assert compiled.models[0].kind == 0 and len(compiled.models[0].faces) == 4


# --- files as other programs write them -----------------------------------------

def test_what_is_compressed_without_being_required_so_is_refused_by_name(tmp_path):
    """Draco and meshopt may stand beside values that are not compressed; where they do not, there is nothing else to read."""
    data, blob = make()
    data["meshes"][0]["primitives"][0]["extensions"] = {"KHR_draco_mesh_compression": {"bufferView": 0, "attributes": {"POSITION": 0}}}
    assert len(read(tmp_path, glb(data, blob))[0].faces) == 2
    for accessor in data["accessors"]:
        del accessor["bufferView"]
    with pytest.raises(ToolError, match="primitive 0: KHR_draco_mesh_compression.*gltf-transform"):
        read(tmp_path, glb(data, blob))
    data, blob = make()
    data["buffers"].append({"byteLength": len(blob), "extensions": {"EXT_meshopt_compression": {"fallback": True}}})
    for view in data["bufferViews"]:
        view["buffer"] = 1
    with pytest.raises(ToolError, match="buffer 1: EXT_meshopt_compression.*gltf-transform"):
        read(tmp_path, glb(data, blob))


def test_scenes_that_are_not_shown_and_instances_are_named(tmp_path):
    data, blob = make()
    data |= {"scenes": [{"nodes": [0]}, {"nodes": [0], "name": "night"}, {}], "scene": 1, "extensionsUsed": ["EXT_mesh_gpu_instancing"]}
    _, notes = read(tmp_path, glb(data, blob))
    assert any('scene 1 ("night") is shown: left out 2 other scenes' in note for note in notes)
    assert any("lists of instances (EXT_mesh_gpu_instancing)" in note and "Blender" in note for note in notes)


@pytest.mark.parametrize("change", [lambda text: text.rstrip("="), lambda text: text[:8] + "\n" + text[8:], lambda text: text.replace("=", "%3D")])
def test_base64_as_browsers_take_it(tmp_path, change):
    data, blob = make()
    packed = gltf_text(data, blob + b"\0").decode()
    head, rest = packed.split("base64,")
    text, tail = rest.split('"', 1)
    whole = f"{head}base64,{change(text)}\"{tail}".replace("\n", "\\n")
    assert whole != packed and len(read(tmp_path, whole.encode(), "model.gltf")[0].faces) == 2


def test_zeros_behind_the_json_of_a_glb_file(tmp_path):
    whole = bytearray(glb(*make()))
    size, = struct.unpack_from("<I", whole, 12)
    end = 20 + len(whole[20:20 + size].rstrip(b" "))
    filled = bytes(whole[:12]) + struct.pack("<II", end - 20 + 4, 0x4E4F534A) + bytes(whole[20:end]) + bytes(4) + bytes(whole[20 + size:])
    struct.pack_into("<I", whole := bytearray(filled), 8, len(filled))
    assert len(read(tmp_path, bytes(whole))[0].faces) == 2


def with_bytes(rows, component):
    """A sound file with other indices: (JSON, binary part), and the number of their accessor."""
    data, blob = make(*SQUARE)
    packed = numpy.array(rows, dtype=component).tobytes()
    data["bufferViews"].append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(packed)})
    return data, blob + packed + b"\0" * (-len(packed) % 4)


@pytest.mark.parametrize("component, kind", [("<u1", 5121), ("<u2", 5123), ("<u4", 5125)])
def test_indices_of_every_size(tmp_path, component, kind):
    data, blob = with_bytes([0, 1, 2, 0, 2, 3], component)
    data["accessors"].append({"bufferView": len(data["bufferViews"]) - 1, "count": 6, "type": "SCALAR", "componentType": kind})
    data["meshes"][0]["primitives"][0]["indices"], data["buffers"][0]["byteLength"] = len(data["accessors"]) - 1, len(blob)
    mesh, _ = read(tmp_path, glb(data, blob))
    assert len(mesh.faces) == 2


def test_signed_normalised_numbers_end_at_minus_one(tmp_path):
    data, blob = with_bytes([(-128, 127, 0, 0), (127, 127, 0, 0), (0, -127, 64, 0), (1, 2, 3, 0)], "<i1")
    data["bufferViews"][-1]["byteStride"] = 4
    data["accessors"][0] = {"bufferView": len(data["bufferViews"]) - 1, "count": 4, "type": "VEC3", "componentType": 5120, "normalized": True}
    data["buffers"][0]["byteLength"], data["extensionsRequired"] = len(blob), ["KHR_mesh_quantization"]
    mesh, _ = read(tmp_path, glb(data, blob))
    assert min(x for x, _, _ in mesh.vertices) == -UNIT and max(y for _, y, _ in mesh.vertices) == UNIT


@pytest.mark.parametrize("has_view", [True, False])
def test_a_sparse_accessor_replaces_some_values(tmp_path, has_view):
    data, blob = with_bytes([3, 0], "<u2")      # rows 3, and 0 of none
    values = numpy.array([(7, 8, 9)], dtype="<f4").tobytes()
    data["bufferViews"].append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(values)})
    blob += values
    data["buffers"][0]["byteLength"] = len(blob)
    table = data["accessors"][0]
    table["sparse"] = {"count": 1, "indices": {"bufferView": len(data["bufferViews"]) - 2, "componentType": 5123},
                       "values": {"bufferView": len(data["bufferViews"]) - 1}}
    if not has_view:
        del table["bufferView"]
    mesh, _ = read(tmp_path, glb(data, blob))
    points = {(x / UNIT, y / UNIT, -z / UNIT) for x, y, z in mesh.vertices}
    assert (7, 8, 9) in points and ((1, 1, 0) in points) == has_view
    table["sparse"]["count"], whole = 2, struct.pack("<H", 4)
    place = data["bufferViews"][-2]["byteOffset"] + 2
    with pytest.raises(ToolError, match="do not fit|sparse replaces value 4 of 4"):
        read(tmp_path, glb(data, blob[:place] + whole + blob[place + 2:]))


def test_a_skinned_node_is_not_moved_by_itself(tmp_path):
    data, blob = make(*TETRAHEDRON, nodes=[{"mesh": 0, "skin": 0, "translation": [9, 9, 9]}])
    data["skins"] = [{"joints": [0]}]
    mesh, notes = read(tmp_path, glb(data, blob))
    assert max(max(map(abs, point)) for point in mesh.vertices) == UNIT and any("left out skins (1; first: " in note for note in notes)


def test_everything_that_is_left_out_is_told_in_a_line_each(tmp_path):
    data, blob = make(*TETRAHEDRON, material={})
    data["materials"][0] |= {"normalTexture": {"index": 5}, "occlusionTexture": {}, "pbrMetallicRoughness": {"metallicRoughnessTexture": {"index": 5}}}
    data["meshes"][0]["primitives"][0]["targets"] = [{}]
    data |= {"animations": [{}, {}], "cameras": [{}], "extensions": {"KHR_lights_punctual": {"lights": [{}]}},
             "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_variants", "X_other"]}
    _, notes = read(tmp_path, glb(data, blob))
    for words in ("left out animations (2)", "left out cameras (1)", "left out lights (1)", "other shapes (morph targets) of parts of meshes: 1",
                  "left out other materials (KHR_materials_variants): the model has those that it has without; Blender",
                  'left out what the extensions "X_other" say', '1 x "normal maps", 1 x "occlusion maps", 1 x "metallic and roughness maps"'):
        assert sum(words in note for note in notes) == 1, words


def test_a_deep_tree_of_nodes_that_all_move(tmp_path):
    """As deep as is read: no part of the tool calls itself once a node."""
    count = 1000
    data, blob = make(*TETRAHEDRON, nodes=[*({"children": [number + 1], "translation": [0, 0, 0.01]} for number in range(count - 1)), {"mesh": 0}])
    data["bufferViews"].append({"buffer": 0, "byteOffset": len(blob), "byteLength": 32})
    blob += struct.pack("<8f", 0, 1, 0, 0, 0, 1, 0, 0)
    data["buffers"][0]["byteLength"] = len(blob)
    for offset, kind in ((0, "SCALAR"), (8, "VEC3")):
        data["accessors"].append({"bufferView": len(data["bufferViews"]) - 1, "byteOffset": offset, "count": 2, "type": kind, "componentType": 5126})
    last = len(data["accessors"])
    data["animations"] = [{"samplers": [{"input": last - 2, "output": last - 1}],
                           "channels": [{"sampler": 0, "target": {"node": number, "path": "translation"}} for number in range(count)]}]
    mesh, _ = read(tmp_path, glb(data, blob))
    nodes, frames, _ = mesh.scenery.play(None)
    assert frames == 30 and nodes["node_999"].poses()[15, 0, 3] == pytest.approx(500)
    place = data["bufferViews"][-1]["byteOffset"] + 4
    blob = blob[:place] + struct.pack("<f", 299.9) + blob[place + 4:]
    mesh, _ = read(tmp_path, glb(data, blob))
    nodes, frames, notes = mesh.scenery.play(None)
    assert frames == 0 and nodes["node_999"].poses is None      # the model stands still, and is told so
    assert any("animation 0: it moves more nodes in 8,997 frames than the limit of 4,194,304 places" in note for note in notes)


def test_normals_of_another_number_are_left_out_unread(tmp_path):
    data, blob = make(*SQUARE)
    data["accessors"].append({"count": 1 << 31, "type": "VEC3", "componentType": 5126})
    data["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = len(data["accessors"]) - 1
    assert read(tmp_path, glb(data, blob))[0].normals == []
