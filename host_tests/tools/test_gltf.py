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


# --- materials and accessors as other programs write them -----------------------------------------

STRIPES = png([[(200, 0, 0)] * 4 + [(0, 100, 0)] * 4] * 8)


def striped(uvs, changes=None, **more):
    """A square with an image that is red on the left and green on the right. changes: of the JSON."""
    data, blob = make(*SQUARE, uvs=uvs, image=more.pop("image", STRIPES), material=more.pop("material", None), **more)
    if changes:
        changes(data)
    return glb(data, blob)


def with_transform(**transform):
    def change(data):
        info = data["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]
        info["extensions"] = {"KHR_texture_transform": transform}
    return change


@pytest.mark.parametrize("transform, expected", [
    ({"offset": [0.5, 0.25]}, [(0.5, 0.25), (0.6, 0.25), (0.6, 0.45), (0.5, 0.45)]),
    ({"scale": [2, 3]}, [(0, 0), (0.2, 0), (0.2, 0.6), (0, 0.6)]),
    # To the left round, seen with v downward: what went to the right goes upward.
    ({"rotation": numpy.pi / 2}, [(0, 0), (0, -0.1), (0.2, -0.1), (0.2, 0)]),
    ({"rotation": numpy.pi / 2, "scale": [2, 1], "offset": [1, 1]}, [(1, 1), (1, 0.8), (1.2, 0.8), (1.2, 1)])])
def test_a_texture_transform(tmp_path, transform, expected):
    mesh, _ = read(tmp_path, striped([(0, 0), (0.1, 0), (0.1, 0.2), (0, 0.2)], with_transform(**transform)))
    assert numpy.allclose(mesh.surfaces.uvs[0][::-1], expected[:3], atol=1e-6)


def test_a_texture_transform_may_name_other_coordinates(tmp_path):
    def change(data):
        with_transform(texCoord=3)(data)
        attributes = data["meshes"][0]["primitives"][0]["attributes"]
        attributes["TEXCOORD_3"] = attributes.pop("TEXCOORD_0")
    mesh, _ = read(tmp_path, striped([(0, 0), (0.4, 0), (0.4, 1), (0, 1)], change))
    assert mesh.surfaces.colours()[0] == (200, 0, 0)


def with_sampler(across, down):
    def change(data):
        data["samplers"], data["textures"][0]["sampler"] = [{"wrapS": across, "wrapT": down}], 0
    return change


REPEAT, CLAMP, MIRROR = 10497, 33071, 33648


@pytest.mark.parametrize("wraps, uvs, clamped, note", [
    ((REPEAT, REPEAT), [(1.1, 0), (1.4, 0), (1.4, 1), (1.1, 1)], False, False),
    ((CLAMP, CLAMP), [(0.1, 0), (0.4, 0), (0.4, 1), (0.1, 1)], False, False),      # nothing is beyond
    ((CLAMP, CLAMP), [(1.1, 0), (1.4, 0), (1.4, 1), (1.1, 1)], True, False),
    ((CLAMP, REPEAT), [(1.1, 0), (1.4, 0), (1.4, 1), (1.1, 1)], True, False),      # upward nothing is beyond
    ((CLAMP, REPEAT), [(1.1, 0), (1.4, 0), (1.4, 2), (1.1, 2)], True, False),
    ((CLAMP, REPEAT), [(1.1, 0), (1.4, 0), (1.4, 2000), (1.1, 2000)], False, True)])    # its image would be 16,000 pixels high
def test_samplers_clamp_where_faces_are_beyond_the_image(tmp_path, wraps, uvs, clamped, note):
    mesh, notes = read(tmp_path, striped(uvs, with_sampler(*wraps)))
    assert mesh.surfaces.materials[0].clamp == clamped
    assert any("clamping of an image along one side alone" in each for each in notes) == note


@pytest.mark.parametrize("across, down", [(CLAMP, REPEAT), (CLAMP, MIRROR), (REPEAT, CLAMP), (MIRROR, CLAMP), (CLAMP, CLAMP), (MIRROR, REPEAT)])
def test_a_sampler_that_goes_on_differently_across_and_down(tmp_path, across, down):
    """Each point shows the texel that glTF's rules say, computed here one by one."""
    rows = numpy.arange(16 * 3, dtype=numpy.uint8).reshape(4, 4, 3) * 5
    uvs = [(-1.3, -0.6), (2.2, -0.6), (2.2, 1.7), (-1.3, 1.7)]
    mesh, notes = read(tmp_path, striped(uvs, with_sampler(across, down), image=png(rows)))
    material, found = mesh.surfaces.materials[0], dict(zip((mesh.vertices[c] for c in mesh.faces[0]), mesh.surfaces.uvs[0]))
    ends = [found[x * UNIT, y * UNIT, 0] for x, y in ((0, 0), (1, 1))]

    def place(part, mode):
        part = min(max(part, 0.0), 0.999) if mode == CLAMP else part % 1 if mode == REPEAT or int(part // 1) % 2 == 0 else 1 - part % 1
        return int(min(part, 0.999) * 4)
    for i, j in numpy.ndindex(17, 19):
        right, low = (i + 0.5) / 17, (j + 0.5) / 19
        u, v = (first + (last - first) * part for first, last, part in zip(*ends, (right, low)))
        u, v = (numpy.clip(each, 0, 0.9999) if material.clamp else each % 1 for each in (u, v))
        shown = material.image.pixels[int(v * material.image.height), int(u * material.image.width), :3]
        wanted = rows[place(-0.6 + 2.3 * low, down), place(-1.3 + 3.5 * right, across)]
        assert (shown == wanted).all(), (i, j)
    assert not any("clamping" in note for note in notes)


def test_a_sampler_that_mirrors(tmp_path):
    """Between 1 and 1.4 the image's right part lies mirrored: green."""
    mesh, _ = read(tmp_path, striped([(1.1, 0), (1.4, 0), (1.4, 1), (1.1, 1)], with_sampler(MIRROR, CLAMP)))
    assert mesh.surfaces.colours()[0] == (0, 100, 0) and mesh.surfaces.materials[0].image.width == 16
    mesh, _ = read(tmp_path, striped([(0, 1.2), (0.4, 1.2), (0.4, 1.9), (0, 1.9)], with_sampler(REPEAT, MIRROR)))
    assert mesh.surfaces.colours()[0] == (200, 0, 0) and mesh.surfaces.materials[0].image.height == 16


def rgba(*rows):
    from PIL import Image
    import io
    out = io.BytesIO()
    Image.fromarray(numpy.array(rows, dtype=numpy.uint8)).save(out, "PNG")
    return out.getvalue()


@pytest.mark.parametrize("entry, factor, alphas, opacity", [
    ({}, 0.5, [255, 255, 255], 1), ({"alphaMode": "OPAQUE"}, 1, [255, 255, 255], 1), ({"alphaMode": "MASK"}, 1, [0, 255, 255], 1),
    ({"alphaMode": "MASK", "alphaCutoff": 0.9}, 1, [0, 0, 255], 1), ({"alphaMode": "MASK"}, 0.6, [0, 0, 255], 1),
    ({"alphaMode": "MASK", "alphaCutoff": 0}, 1, [255, 255, 255], 1), ({"alphaMode": "MASK"}, 0, [0, 0, 0], 1),
    ({"alphaMode": "BLEND"}, 0.25, [100, 180, 255], 0.25)])
def test_alpha_modes(tmp_path, entry, factor, alphas, opacity):
    image = rgba([(9, 9, 9, 100), (9, 9, 9, 180), (9, 9, 9, 255)])
    mesh, _ = read(tmp_path, striped([(0, 0), (1, 0), (1, 1), (0, 1)], lambda data: data["materials"][0].update(entry), image=image,
                                     material={"baseColorFactor": [1, 1, 1, factor]}))
    material = mesh.surfaces.materials[0]
    assert material.image.pixels[0, :, 3].tolist() == alphas and material.opacity == opacity


@pytest.mark.parametrize("entry, colour, unlit, note", [
    ({"emissiveFactor": [1, 0, 0]}, (255, 0, 0), True, False),
    ({"emissiveFactor": [0.5, 0, 0], "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 2}}}, (255, 0, 0), True, False),
    ({"extensions": {"KHR_materials_unlit": {}}}, (0, 0, 0), True, False)])
def test_emissive_and_unlit_materials(tmp_path, entry, colour, unlit, note):
    data, blob = make(material={"baseColorFactor": [0, 0, 0, 1]})
    data["materials"][0].update(entry)
    mesh, notes = read(tmp_path, glb(data, blob))
    assert mesh.surfaces.colours()[0] == colour and mesh.surfaces.are_unlit() == unlit
    assert any("emissive" in each for each in notes) == note


@pytest.mark.parametrize("alphas, mode, note, opacity", [
    ((0, 100), "BLEND", False, 100 / 255), ((97, 100), "BLEND", False, 0.386), ((60, 128), "BLEND", True, 1), ((128, 255), "BLEND", True, 1),
    ((0, 255), "BLEND", False, 1), ((0, 128), "MASK", False, 1)])
def test_alpha_between_clear_and_opaque_is_named_where_it_would_blend(tmp_path, alphas, mode, note, opacity):
    """One alpha of all that is not clear is the opacity of the material."""
    image = png([[(200, 0, 0, alphas[0])] * 4 + [(0, 100, 0, alphas[1])] * 4] * 8)
    data, blob = make(uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], image=image)
    data["materials"][0]["alphaMode"] = mode
    mesh, notes = read(tmp_path, glb(data, blob))
    material = mesh.surfaces.materials[0]
    assert any('1 x "an image\'s alpha between clear and opaque: from a half on it is opaque"' in each for each in notes) == note
    assert abs(material.opacity - opacity) < 0.01
    if opacity < 1:
        assert set(material.image.pixels[..., 3].flat) == ({0, 255} if 0 in alphas else {255})


@pytest.mark.parametrize("colours, note", [([(255, 0, 0, 255), (0, 255, 0, 255)] * 2, True), ([(255, 255, 255, 255)] * 4, False)])
def test_colours_of_vertices_that_multiply_an_image_are_named(tmp_path, colours, note):
    _, notes = read(tmp_path, glb(*make(uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], image=png([[(200, 0, 0)]]), colours=colours)))
    assert any("the mean of a face's corners multiplies its image" in each for each in notes) == note
    assert not any("each face has the mean" in each for each in notes)


@pytest.mark.parametrize("alpha, mode, note", [(128, "BLEND", True), (128, "OPAQUE", False), (255, "BLEND", False)])
def test_alpha_of_the_colours_of_vertices_is_named(tmp_path, alpha, mode, note):
    data, blob = make(colours=[(255, 0, 0, alpha)] * 4, material={})
    data["materials"][0]["alphaMode"] = mode
    _, notes = read(tmp_path, glb(data, blob))
    assert any('1 x "alpha of the vertices\' colours"' in each for each in notes) == note


def test_an_emissive_colour_is_added_to_another_one_and_to_an_image(tmp_path):
    data, blob = make(material={"baseColorFactor": [0, 0.2158605, 0, 1]})
    data["materials"][0]["emissiveFactor"] = [1, 0, 0]
    mesh, _ = read(tmp_path, glb(data, blob))
    assert mesh.surfaces.colours()[0] == (255, 128, 0) and not mesh.surfaces.are_unlit()
    uvs = [(0, 0), (0.4, 0), (0.4, 1), (0, 1)]
    mesh, notes = read(tmp_path, striped(uvs, lambda data: data["materials"][0].update(emissiveFactor=[0, 0, 1])))
    assert mesh.surfaces.colours()[0] == (200, 0, 255) and not mesh.surfaces.are_unlit() and not any("emissive" in note for note in notes)
    glowing = {"baseColorFactor": [0, 0, 0, 1]}
    data, blob = make(*SQUARE, uvs=uvs, image=STRIPES, material=glowing)
    data["materials"][0] |= {"emissiveFactor": [1, 1, 1], "emissiveTexture": {"index": 0}}
    mesh, _ = read(tmp_path, glb(data, blob))
    assert mesh.surfaces.colours()[0] == (200, 0, 0) and mesh.surfaces.are_unlit()


def glowing(base, other, factor=(1, 1, 1), glow=(1, 1, 1), **info):
    """A square with two images of one column each: its own, and one that it emits. None: no image. info: of the one that it emits."""
    data, blob = make(*SQUARE, uvs=[(0, 0), (0.4, 0), (0.4, 1), (0, 1)], image=png([[base or (0, 0, 0)]]), material={"baseColorFactor": [*factor, 1]})
    more = png([[other or (0, 0, 0)] * 2])
    data["bufferViews"].append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(more)})
    data["images"].append({"bufferView": len(data["bufferViews"]) - 1})
    data["textures"].append({"source": 1})
    data["buffers"][0]["byteLength"] = len(blob + more)
    entry = data["materials"][0]
    if base is None:
        del entry["pbrMetallicRoughness"]["baseColorTexture"]
    entry |= {"emissiveFactor": list(glow), **({"emissiveTexture": {"index": 1, **info}} if other else {})}
    return glb(data, blob + more)


@pytest.mark.parametrize("base, other, factor, glow, expected", [
    ((200, 0, 0), (0, 0, 150), (1, 1, 1), (1, 1, 1), (200, 0, 150)),
    ((188, 0, 0), (188, 0, 0), (1, 1, 1), (1, 1, 1), (255, 0, 0)),         # half the light and half the light
    ((188, 0, 0), (188, 0, 0), (1, 1, 1), (0.5, 1, 1), (225, 0, 0)),
    ((255, 255, 255), (0, 100, 0), (0.2158605, 0, 0), (1, 1, 1), (128, 100, 0)),
    (None, (0, 100, 0), (0.2158605, 0, 0), (1, 1, 1), (128, 100, 0)),
    ((200, 0, 0), (0, 0, 0), (1, 1, 1), (1, 1, 1), (200, 0, 0))])
def test_an_emissive_image_is_added_to_the_base(tmp_path, base, other, factor, glow, expected):
    mesh, notes = read(tmp_path, glowing(base, other, factor, glow))
    assert numpy.abs(numpy.subtract(mesh.surfaces.colours()[0], expected)).max() <= 1
    assert not mesh.surfaces.are_unlit() and not any("emissive" in note for note in notes)


def test_an_emissive_image_that_lies_otherwise_is_named(tmp_path):
    mesh, notes = read(tmp_path, glowing((200, 0, 0), (0, 0, 150), texCoord=1))
    assert mesh.surfaces.colours()[0] == (200, 0, 0) and any('1 x "emissive images that do not lie as the others do"' in note for note in notes)


@pytest.mark.parametrize("mode, alpha, is_shown", [("MASK", 0.4, False), ("MASK", 0.5, True), ("BLEND", 0, False), ("BLEND", 0.1, True),
                                                  ("OPAQUE", 0, True)])
def test_what_is_wholly_clear_is_left_out(tmp_path, mode, alpha, is_shown):
    data, blob = make(material={"baseColorFactor": [1, 0, 0, alpha]})
    data["materials"][0]["alphaMode"] = mode
    part = data["meshes"][0]["primitives"][0]
    data["meshes"][0]["primitives"].append({**part, "material": 1})
    data["materials"].append({})
    mesh, notes = read(tmp_path, glb(data, blob))
    assert len(mesh.faces) == (4 if is_shown else 2) and any('1 x "faces of materials that are wholly clear"' in note for note in notes) != is_shown
    data["meshes"][0]["primitives"] = [part]
    if not is_shown:
        with pytest.raises(ToolError, match="wholly clear"):
            read(tmp_path, glb(data, blob))


def test_materials_of_specular_and_glossiness(tmp_path):
    data, blob = make(*SQUARE, uvs=[(0, 0), (0.4, 0), (0.4, 1), (0, 1)], image=STRIPES, material={})
    del data["materials"][0]["pbrMetallicRoughness"]
    data["materials"][0]["extensions"] = {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0, 1, 1, 1],
                                                                                "diffuseTexture": {"index": 0}}}
    mesh, _ = read(tmp_path, glb(data, blob))
    assert mesh.surfaces.colours()[0] == (0, 0, 0) and mesh.surfaces.materials[0].image


def test_a_webp_image_beside_and_a_ktx2_image_alone(tmp_path):
    def change(data, **extensions):
        data["textures"][0] = {"extensions": extensions, **({"source": 0} if "both" in extensions else {})}
    uvs = [(0, 0), (0.4, 0), (0.4, 1), (0, 1)]
    mesh, _ = read(tmp_path, striped(uvs, lambda data: change(data, EXT_texture_webp={"source": 0})))
    assert mesh.surfaces.colours()[0] == (200, 0, 0)
    mesh, _ = read(tmp_path, striped(uvs, lambda data: change(data, both={}, KHR_texture_basisu={"source": 7})))
    assert mesh.surfaces.colours()[0] == (200, 0, 0)
    for extension, command in (("KHR_texture_basisu", "ktxdecompress in.glb out.glb"), ("EXT_texture_avif", "png --formats avif")):
        mesh, notes = read(tmp_path, striped(uvs, lambda data: change(data, **{extension: {"source": 0}})))
        assert mesh.surfaces.colours()[0] == (255, 255, 255)
        assert sum(extension in note and command in note and "PNG" in note for note in notes) == 1


@pytest.mark.parametrize("texture, words", [({}, 'formats that are not read"'), ({"extensions": {"MSFT_texture_dds": {"source": 0}}}, "(MSFT_texture_dds)")])
def test_a_texture_without_an_image_that_is_read_is_named(tmp_path, texture, words):
    mesh, notes = read(tmp_path, striped([(0, 0), (0.4, 0), (0.4, 1), (0, 1)], lambda data: data.update(textures=[texture]),
                                         material={"baseColorFactor": [0, 1, 0, 1]}))
    assert mesh.surfaces.colours()[0] == (0, 255, 0) and sum(words in note for note in notes) == 1


def test_a_ktx2_image_may_be_required_where_it_stands_beside_another_and_is_known_by_its_bytes(tmp_path):
    uvs = [(0, 0), (0.4, 0), (0.4, 1), (0, 1)]
    mesh, _ = read(tmp_path, striped(uvs, lambda data: data.update(extensionsRequired=["KHR_texture_basisu"])))
    assert mesh.surfaces.colours()[0] == (200, 0, 0)
    _, notes = read(tmp_path, striped(uvs, image=b"\xabKTX 20\xbb\r\n\x1a\n" + bytes(60)))
    assert sum("KTX" in note and "ktxdecompress in.glb out.glb" in note for note in notes) == 1


def test_an_image_on_faces_without_its_coordinates_is_named(tmp_path):
    _, notes = read(tmp_path, striped([(0, 0), (1, 0), (1, 1), (0, 1)], with_transform(texCoord=1)))
    assert any('1 x "images on faces without coordinates for them"' in note for note in notes)


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
    "outside": (changed(["buffers", 0], {"uri": "../../etc/gone", "byteLength": 4}), ["buffer 0", "there is no file", "../../etc/gone"]),
    "material": (changed(["meshes", 0, "primitives", 0, "material"], 5), ["material 5 does not exist"]),
    "version": (changed(["asset", "version"], "1.0"), ['"1.0"', "only 2.0"]),
    "new meshopt": (changed(["extensionsRequired"], ["KHR_meshopt_compression"]), ["meshopt", "gltf-transform"]),
    "meshopt": (changed(["extensionsRequired"], ["EXT_meshopt_compression"]), ["meshopt", "gltf-transform"]),
    "draco": (changed(["extensionsRequired"], ["KHR_draco_mesh_compression"]), ["Draco", "gltf-transform"]),
    "instancing": (changed(["extensionsRequired"], ["EXT_mesh_gpu_instancing"]), ["EXT_mesh_gpu_instancing", "Blender", "as nodes"]),
    "empty": (b"", ["the file is empty"]),
    "key": (changed(["bufferViews", 0, "byteLength"], None), ["byteLength is missing"]),
    "no version": (changed(["asset"], {}), ["names no version", "npx gltf-pipeline"]),
    "sampler": (changed(["textures", 0, "sampler"], 3), ["sampler 3 does not exist"]),
    "alpha": (changed(["materials", 0, "alphaMode"], "GLASS"), ['"GLASS"', "OPAQUE"]),
    "emissive image": (changed(["materials", 0], {"emissiveFactor": [1, 1, 1], "emissiveTexture": {}}), ["material 0", "index is missing"]),
    "emissive": (changed(["materials", 0, "emissiveFactor"], [1, 2]), ["emissiveFactor must be 3 numbers"]),
    "transform": (changed(["materials", 0, "pbrMetallicRoughness", "baseColorTexture", "extensions"],
                          {"KHR_texture_transform": {"offset": 3}}), ["offset must be 2 numbers"]),
    "extensions": (changed(["materials", 0, "extensions"], [1]), ["extensions is no object"]),
    "extension": (changed(["extensionsRequired"], ["KHR_draco_mesh_compression"]), ["KHR_draco_mesh_compression"]),
    "no JSON": (b"{nonsense", ["not JSON"]),
    "deep": (b"[" * 100_000, ["nested"]),
    "list": (b"[]", ["not a glTF file"]),
    "digits": (b'{"asset": ' + b"9" * 9000 + b"}", ["thousands of digits"]),
    "header": (struct.pack("<4sII", b"glTF", 2, 1 << 31) + bytes(40), ["header promises 2,147,483,648 bytes"]),
    "part": (struct.pack("<4sIIII", b"glTF", 2, 40, 1 << 31, 0x4E4F534A) + bytes(20), ["promises 2,147,483,648 bytes"]),
    "old": (struct.pack("<4sII", b"glTF", 1, 12), ["version 1", "npx gltf-pipeline"]),
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
