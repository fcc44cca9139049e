# SPDX-License-Identifier: MIT
"""What the reader of glTF refuses, in one sentence. Each member of a file as something else than it must be: a null member is as if it were not
there, and whatever else stands there is read or refused."""

import copy
import json
import os
import struct

import pytest

from fixel.base.errors import ToolError
from fixel.model import gltf
from fixel.scene import framing, look
from model_files import File, TETRAHEDRON, about_x, assert_refused, glb, gltf as make, png
from test_gltf import read as read_file

BUILT_PROGRAMS = ()
LOOKS = (look.Look(), look.Look(camera="*", animation="*", keep="*"))
FRAMED = ("animations", "cameras", "extensions", "nodes", "skins")
SHARE = 5
ODD = [None, True, "text", "", -1, 0.5, 7, 2 ** 31, 2 ** 63, -2 ** 40, 10 ** 400, 1e308, 1e-320, [], {}, [None], [[]], [{}], {"a": 1}, [1e308] * 16, [0] * 3, [0] * 4]


def rich():
    """(JSON, bytes) of a file that has one of nearly everything."""
    made = File({"name": "root", "mesh": 0, "children": [1, 2, 3, 4, 5], "scale": [1, 2, 1], "rotation": [0, 0, 0, 1], "translation": [0, 0, 0]},
                {"name": "eye", "camera": 0, "translation": [0, 0, 9]}, {"name": "flat", "camera": 1},
                {"name": "lamp", "extensions": {"KHR_lights_punctual": {"light": 0}}, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1]},
                {"name": "arm", "mesh": 1, "skin": 0}, {"name": "bone", "extensions": {"KHR_lights_punctual": {"light": 1}}})
    made.box()
    made.box()
    data = made.data
    data["cameras"] = [{"type": "perspective", "name": "c", "perspective": {"yfov": 1, "znear": 1, "zfar": 100, "aspectRatio": 1}},
                       {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 1, "zfar": 2}}]
    data["extensionsUsed"], data["extensionsRequired"] = ["KHR_lights_punctual", "KHR_materials_variants"], ["KHR_texture_transform"]
    data["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "spot", "name": "l", "color": [1, 1, 1], "intensity": 3, "range": 9, "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}},
        {"type": "directional", "intensity": 1}]}}
    one, two = data["meshes"][0]["primitives"][0], data["meshes"][1]["primitives"][0]
    points = [[0, 0, 0]] * 8
    one["attributes"] |= {"TEXCOORD_0": made.add([[0, 0]] * 4 + [[1, 1]] * 4, "<f4", "VEC2"), "COLOR_0": made.add([[9, 9, 9, 255]] * 8, "<u1", "VEC4", normalized=True),
                          "NORMAL": made.add([[0, 0, 1]] * 8, "<f4", "VEC3")}
    one |= {"mode": 4, "targets": [{"POSITION": made.add(points, "<f4", "VEC3")}], "extensions": {"KHR_materials_variants": {"mappings": []}}}
    two["attributes"] |= {"JOINTS_0": made.add([[0, 0, 0, 0]] * 8, "<u1", "VEC4"), "WEIGHTS_0": made.add([[1, 0, 0, 0]] * 8, "<f4", "VEC4")}
    data["skins"] = [{"joints": [5], "inverseBindMatrices": made.add([[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]], "<f4", "MAT4"), "skeleton": 5}]
    data["accessors"][0] |= {"byteOffset": 0, "sparse": {
        "count": 1, "indices": {"bufferView": data["accessors"][made.add([0], "<u2", "SCALAR")]["bufferView"], "componentType": 5123, "byteOffset": 0},
        "values": {"bufferView": data["accessors"][made.add([[-0.5, -0.5, -0.5]], "<f4", "VEC3")]["bufferView"], "byteOffset": 0}}}
    made.animate((5, "rotation", [0, 1], [about_x(0), about_x(90)], "LINEAR"), (0, "translation", [0, 1], [[0, 0, 0], [0, 1, 0]], "STEP"), name="move")
    blob = png([[(200, 9, 9, 255), (9, 200, 9, 90)]] * 2)
    data["images"] = [{"bufferView": len(data["bufferViews"]), "mimeType": "image/png", "name": "i"}, {"uri": "gone.png"}]
    data["bufferViews"].append({"buffer": 0, "byteOffset": len(made.blob), "byteLength": len(blob)})
    made.blob += blob + b"\0" * (-len(blob) % 4)
    data["samplers"] = [{"wrapS": 33648, "wrapT": 33071, "magFilter": 9728}]
    data["textures"] = [{"source": 0, "sampler": 0}, {"extensions": {"EXT_texture_webp": {"source": 0}}}, {"source": 1}]
    transform = {"extensions": {"KHR_texture_transform": {"offset": [0.5, 0], "scale": [2, 2], "rotation": 0.5, "texCoord": 0}}}
    data["materials"][0] |= {
        "name": "m", "alphaMode": "MASK", "alphaCutoff": 0.4, "doubleSided": True, "emissiveFactor": [0.1, 0, 0], "emissiveTexture": {"index": 1, "texCoord": 0},
        "normalTexture": {"index": 0}, "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 2}},
        "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.9], "baseColorTexture": {"index": 0, "texCoord": 0, **transform}, "metallicRoughnessTexture": {"index": 2}}}
    data["materials"][1] |= {"alphaMode": "BLEND", "extensions": {
        "KHR_materials_unlit": {}, "KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [1, 0, 0, 0.5], "diffuseTexture": {"index": 2}}}}
    data["buffers"] = [{"byteLength": len(made.blob), "name": "b"}]
    return data, made.blob


DATA, BLOB = rich()


def places(value, path=()):
    """The path of each member and each entry of a list."""
    for key, inner in value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ():
        yield (*path, key)
        yield from places(inner, (*path, key))


def changed(path, value):
    """The JSON with another value at a place."""
    data = copy.deepcopy(DATA)
    inner = data
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = value
    return data


def without(path):
    data = changed(path, None)
    inner = data
    for key in path[:-1]:
        inner = inner[key]
    del inner[path[-1]]
    return data


def read(folder, data):
    """What the reader makes of a file: vertices, faces and notes, or the words of its refusal."""
    (folder / "m.glb").write_bytes(glb(data, BLOB))
    try:
        mesh, notes = gltf.read(str(folder / "m.glb"), "m.glb")
        return mesh.vertices, mesh.faces, notes
    except ToolError as error:
        return error.message


def compiled(folder, data, chosen):
    (folder / "m.glb").write_bytes(glb(data, BLOB))
    return framing.compile_model(str(folder / "m.glb"), 2, look=chosen)


def test_the_file_itself_is_read_with_all_that_it_has(tmp_path):
    for chosen in LOOKS:
        scene, notes = compiled(tmp_path, DATA, chosen)
        assert scene.models and not any("damaged" in note for note in notes)


@pytest.mark.parametrize("path", [path for path in places(DATA) if isinstance(path[-1], str)], ids=lambda path: ".".join(map(str, path)))
def test_a_member_that_is_null_is_as_if_it_were_not_there(tmp_path, path):
    assert read(tmp_path, changed(path, None)) == read(tmp_path, without(path))


@pytest.mark.parametrize("first", sorted(DATA))
def test_whatever_stands_at_a_place_is_read_or_refused_in_a_sentence(tmp_path, first):
    """Nothing else than ToolError comes, which is one sentence. What the framing of a model reads goes through it too. Of the values each place
    gets some, and its neighbour others; make test WHOLE=1 tries all."""
    tried = 0
    for number, path in enumerate(path for path in places(DATA) if path[0] == first):
        for value in ODD if os.environ.get("FIXEL_WHOLE") else ODD[number % SHARE::SHARE]:
            data = changed(path, value)
            try:
                if first in FRAMED:
                    compiled(tmp_path, data, LOOKS[1])
                else:
                    read(tmp_path, data)
            except ToolError as error:
                assert "\n" not in error.message and len(error.message) < 600
            except Exception as error:
                pytest.fail(f"{'.'.join(map(str, path))} = {json.dumps(value)[:60]}: {type(error).__name__}: {error}")
            tried += 1
    assert tried


# --- refusals -----------------------------------------------------------------------

def with_value(path, value):
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
    "cycle": (with_value(["nodes"], [{"children": [1]}, {"children": [0], "name": "knot"}]), ["node 0", "cycle"]),
    "knot": (with_value(["nodes"], [{"children": [1, 1]}, {"mesh": 0}]), ["node 1", "one parent"]),
    "no node": (with_value(["scenes"], [{"nodes": [7]}]), ["node 7 does not exist"]),
    "child": (with_value(["nodes"], [{"children": ["x"], "name": "arm"}]), ['node 0 ("arm")', "children"]),
    "NaN": (vertices(float("nan"), 0, 0), ['node 0 ("thing")', "mesh 0, primitive 0", "x of vertex 0 is nan"]),
    "huge": (vertices(0, 3e30, 0), ["y of vertex 0", "1,000,000,000"]),
    "matrix": (with_value(["nodes", 0, "matrix"], [1e300] * 16), ["node 0", "matrix"]),
    "two numbers": (with_value(["nodes", 0, "translation"], [1, 2]), ["node 0", "translation must be 3 numbers"]),
    "no list": (with_value(["nodes", 0, "translation"], 1), ["node 0", "translation must be 3 numbers"]),
    "truth": (with_value(["nodes", 0, "scale"], [1, True, 1]), ["node 0", "scale must be 3 numbers"]),
    "word": (with_value(["nodes", 0, "scale"], [1, "2", 1]), ["node 0", "scale must be 3 numbers"]),
    "rotation": (with_value(["nodes", 0, "rotation"], [0, 0, 0, 0]), ["node 0", "rotation"]),
    "infinite": (with_value(["nodes", 0, "scale"], [float("inf"), 1, 1]), ["value Infinity", "not a number of JSON"]),
    "no faces": (with_value(["nodes"], [{"name": "empty"}]), ["no face"]),
    "buffer": (with_value(["buffers", 0, "byteLength"], 1 << 31), ["buffer 0", "2,147,483,648 bytes are promised"]),
    "view": (with_value(["bufferViews", 0, "byteLength"], 1 << 20), ["buffer view reaches"]),
    "count": (with_value(["accessors", 0, "count"], 200_000), ["accessor 0", "do not fit"]),
    "absurd count": (with_value(["accessors", 0, "count"], 1 << 31), ["accessor 0", "2,147,483,648 values do not fit"]),
    "stride": (with_value(["bufferViews", 0, "byteStride"], 4), ["accessor 0"]),
    "index": (with_value(["accessors", 0, "count"], 2), ["indices name vertex 3 of 2"]),
    "sparse": (with_value(["accessors", 0, "sparse"], {}), ["sparse"]),
    "no accessor": (with_value(["meshes", 0, "primitives", 0, "indices"], 99), ["accessor 99 does not exist"]),
    "no position": (with_value(["meshes", 0, "primitives", 0, "attributes"], {}), ["no POSITION"]),
    "outside": (with_value(["buffers", 0], {"uri": "../../etc/gone", "byteLength": 4}), ["buffer 0", "there is no file", "../../etc/gone"]),
    "material": (with_value(["meshes", 0, "primitives", 0, "material"], 5), ["material 5 does not exist"]),
    "version": (with_value(["asset", "version"], "1.0"), ['"1.0"', "only 2.0"]),
    "new meshopt": (with_value(["extensionsRequired"], ["KHR_meshopt_compression"]), ["meshopt", "gltf-transform"]),
    "meshopt": (with_value(["extensionsRequired"], ["EXT_meshopt_compression"]), ["meshopt", "gltf-transform"]),
    "draco": (with_value(["extensionsRequired"], ["KHR_draco_mesh_compression"]), ["Draco", "gltf-transform"]),
    "instancing": (with_value(["extensionsRequired"], ["EXT_mesh_gpu_instancing"]), ["EXT_mesh_gpu_instancing", "Blender", "as nodes"]),
    "empty": (b"", ["the file is empty"]),
    "key": (with_value(["bufferViews", 0, "byteLength"], None), ["byteLength is missing"]),
    "no version": (with_value(["asset"], {}), ["names no version", "npx gltf-pipeline"]),
    "sampler": (with_value(["textures", 0, "sampler"], 3), ["sampler 3 does not exist"]),
    "alpha": (with_value(["materials", 0, "alphaMode"], "GLASS"), ['"GLASS"', "OPAQUE"]),
    "emissive image": (with_value(["materials", 0], {"emissiveFactor": [1, 1, 1], "emissiveTexture": {}}), ["material 0", "index is missing"]),
    "emissive": (with_value(["materials", 0, "emissiveFactor"], [1, 2]), ["emissiveFactor must be 3 numbers"]),
    "transform": (with_value(["materials", 0, "pbrMetallicRoughness", "baseColorTexture", "extensions"],
                          {"KHR_texture_transform": {"offset": 3}}), ["offset must be 2 numbers"]),
    "extensions": (with_value(["materials", 0, "extensions"], [1]), ["extensions is no object"]),
    "extension": (with_value(["extensionsRequired"], ["KHR_draco_mesh_compression"]), ["KHR_draco_mesh_compression"]),
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
    assert_refused(read_file, tmp_path, *BAD[kind], most=400)


def test_nodes_that_read_the_same_part_often(tmp_path):
    """Few bytes, much work."""
    data, blob = make(*TETRAHEDRON, nodes=[{"mesh": 0}] * 8000)
    data["scenes"][0]["nodes"] = list(range(8000))
    data["meshes"][0]["primitives"] *= 100
    with pytest.raises(ToolError, match="65,535 primitives"):
        read_file(tmp_path, glb(data, blob))


def test_a_part_that_is_cut_off_behind_its_head_is_refused(tmp_path):
    data, blob = make()
    whole = glb(data, blob)
    cut = bytearray(whole[:len(whole) - len(blob)])
    struct.pack_into("<I", cut, 8, len(cut))
    with pytest.raises(ToolError, match=f"a part promises {len(blob):,} bytes and 0 are there"):
        read_file(tmp_path, bytes(cut))
