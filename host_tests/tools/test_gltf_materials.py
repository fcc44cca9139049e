# SPDX-License-Identifier: MIT
"""Materials of glTF as other programs write them: images with their transforms and samplers, alpha modes, emissive and unlit ones, colours of
vertices, and which faces show from both sides."""

import json

import numpy
import pytest

from conftest import run_cli
from fixel.base.errors import ToolError
from fixel.image import image
from fixel.model.mesh import UNIT
from fixel.scene import compiler, look, toml_scene
from model_files import File, SQUARE, TETRAHEDRON, glb, gltf as make, png
from test_gltf import read

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "host/frames", "host/judge", "host/raycast", "host/predict")
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


# --- both sides ---------------------------------------------------------------------

def faces(path, wanted=look.Look()):
    made, notes = compiler.compile_scene(str(path), 4, look=wanted)
    assert image.unpack(image.pack(made)) == made
    return sum(len(model.faces) for model in made.models), notes


def square(tmp_path, **material):
    data, blob = make(*SQUARE, material={})
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
        data, blob = make(*TETRAHEDRON, material={})
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
