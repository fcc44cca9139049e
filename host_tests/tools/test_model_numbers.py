# SPDX-License-Identifier: MIT
"""What Python takes for a number and no format does, in each format: refused where it stands."""

import base64
import json
import struct

import pytest

from fixel.base.errors import ToolError
from fixel.model import model_text
from fixel.scene import compiler
from model_files import glb, gltf, png, stl, stl_text

BUILT_PROGRAMS = ()
WORDS = ["nan", "NaN", "-nan", "inf", "-inf", "Infinity", "1_0", "\u0661", "\uff11", "\u0967.5"]   # Arabic, full-width, Devanagari
VALUES = [float("nan"), float("inf"), float("-inf")]
OBJ = "mtllib m.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n"
MTL = "newmtl red\nKd 1 0 0\nd 0.5\nmap_Kd skin.png\n"
SCENE = '[[objects]]\nsolid = "box"\nscale = 1\n[path]\nkeys = [{ position = [0, 0, -4], yaw = 1 }]\n'


def refused(tmp_path, name, text, *words):
    (tmp_path / name).write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(ToolError) as caught:
        compiler.compile_scene(str(tmp_path / name), None if name.endswith(".toml") else 2)
    for word in words:
        assert word in str(caught.value)


@pytest.fixture(name="obj")
def _obj(tmp_path):
    """An OBJ file with a material and an image, which compiles; its folder."""
    (tmp_path / "m.mtl").write_text(MTL)
    (tmp_path / "skin.png").write_bytes(png([[(1, 2, 3)]]))
    (tmp_path / "m.obj").write_text(OBJ)
    compiler.compile_scene(str(tmp_path / "m.obj"), 2)
    return tmp_path


@pytest.mark.parametrize("word", WORDS)
@pytest.mark.parametrize("line, number", [("v 1 0 0", 4), ("vt 1 0", 7), ("f 1/1 2/2", 9), ("vt 0 1", 8)])
def test_numbers_of_obj_files(obj, line, number, word):
    spoilt = f"{line.rpartition('/' if line[0] == 'f' else ' ')[0]}{'/' if line[0] == 'f' else ' '}{word}"
    refused(obj, "m.obj", OBJ.replace(line, spoilt, 1), f"m.obj:{number}: ", word)


@pytest.mark.parametrize("word", WORDS + ["1" + "0" * 400])
@pytest.mark.parametrize("line, number", [("Kd 1 0 0", 2), ("d 0.5", 3)])
def test_numbers_of_mtl_files(obj, line, number, word):
    (obj / "m.mtl").write_text(MTL.replace(line, line.rpartition(" ")[0] + " " + word))
    refused(obj, "m.obj", OBJ, f"m.mtl:{number}: ", word[:40])


@pytest.mark.parametrize("word", WORDS)
def test_numbers_of_text_stl_files(tmp_path, word):
    refused(tmp_path, "m.stl", stl_text().replace(b"vertex 0 0 0", f"vertex 0 {word} 0".encode(), 1), "m.stl:4: ", word,
            "is not a number")


@pytest.mark.parametrize("value", VALUES)
def test_numbers_of_binary_stl_files(tmp_path, value):
    refused(tmp_path, "m.stl", stl([(0, 0, 0), (1, 0, 0), (0, value, 0), (0, 0, 1)]), "m.stl: triangle", f"is {value:g}")


@pytest.mark.parametrize("value", VALUES)
def test_json_numbers_of_gltf_files(tmp_path, value):
    data, blob = gltf(nodes=[{"mesh": 0, "translation": [0, value, 0]}])
    refused(tmp_path, "m.glb", glb(data, blob), "m.glb: ", "is not a number of JSON")


@pytest.mark.parametrize("word, complaint", [("1_0", "not JSON"), ("\u0661", "not JSON"),
                                             ("1e999", "translation must be 3 numbers")])
def test_words_of_gltf_files(tmp_path, word, complaint):
    data, blob = gltf(nodes=[{"mesh": 0, "translation": [0, 123, 0]}])
    data["buffers"][0]["uri"] = "data:;base64," + base64.b64encode(blob).decode()
    text = json.dumps(data)
    assert text.count("123,") == 1
    refused(tmp_path, "m.gltf", text.replace("123,", f"{word},"), "m.gltf", complaint)


@pytest.mark.parametrize("value", VALUES)
def test_positions_of_gltf_files(tmp_path, value):
    refused(tmp_path, "m.glb", glb(*gltf([(0, 0, 0), (1, 0, value), (1, 1, 0), (0, 1, 0)])), "of vertex 1 is ")


@pytest.mark.parametrize("value", VALUES)
def test_texture_coordinates_of_gltf_files(tmp_path, value):
    data = gltf(uvs=[(0, 0), (1, 0), (1, value), (0, 1)], image=png([[(1, 2, 3)]]))
    refused(tmp_path, "m.glb", glb(*data), f"TEXCOORD_0 of vertex 2 has the value {value:g}; it must be finite")


@pytest.mark.parametrize("value", VALUES)
def test_colours_of_vertices_of_gltf_files(tmp_path, value):
    data, blob = gltf()
    data["bufferViews"].append({"buffer": 0, "byteOffset": len(blob), "byteLength": 48})
    data["accessors"].append({"bufferView": len(data["bufferViews"]) - 1, "componentType": 5126, "count": 4, "type": "VEC3"})
    data["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = len(data["accessors"]) - 1
    blob += struct.pack("<12f", *[0.5] * 7, value, *[0.5] * 4)
    data["buffers"][0]["byteLength"] = len(blob)
    refused(tmp_path, "m.glb", glb(data, blob), f"COLOR_0 of vertex 2 has the value {value:g}; it must be finite")


@pytest.mark.parametrize("word", WORDS + ["1_0/2", "\u0661/2", "1/\u0662", "1_0/512 turn", "\u0661 turn", "nan turn", "1e\u0661"])
@pytest.mark.parametrize("line, key", [("scale = 1", "scale"), ("yaw = 1", "yaw")])
def test_quantities_in_strings_of_toml(tmp_path, line, key, word):
    refused(tmp_path, "s.toml", SCENE.replace(line, f'{key} = "{word}"'), "s.toml", key, "is not a number")


@pytest.mark.parametrize("word", ["nan", "inf", "-inf"])
def test_numbers_of_toml(tmp_path, word):
    refused(tmp_path, "s.toml", SCENE.replace("scale = 1", f"scale = {word}"), "s.toml", "scale", "out of every range")


@pytest.mark.parametrize("text, value", [("1", 1), ("-1.5", -1.5), ("+.5", 0.5), ("5.", 5), ("1e3", 1000), ("2.5E-1", 0.25)])
def test_numbers_that_are_taken(text, value):
    assert model_text.decimal(text) == value


@pytest.mark.parametrize("text", ["", ".", "-", "+", "e5", "1e", "1.2.3", "--1", "0x10", " 1", "1 ", "1e999"])
def test_what_is_no_number(text):
    with pytest.raises(ValueError):
        model_text.decimal(text)
