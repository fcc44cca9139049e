# SPDX-License-Identifier: MIT
"""Files that hold something else than their names say are refused with what they hold and the way on."""

import io
import zipfile

import pytest

from conftest import assert_one_sentence, run_cli
from fixel.base import foreign
from fixel.base.errors import ToolError
from fixel.model import model_file, suffixes
from fixel.scene import compiler
from model_files import glb, gltf, png, stl, stl_text
from test_obj import CUBE
from test_ply import binary


def _zip(name):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        archive.writestr(name, CUBE)
    return out.getvalue()


DATA = {
    "obj": CUBE.encode(), "marked obj": CUBE.encode("utf-16"), "glb": glb(*gltf()), "gltf": b'{"asset": {"version": "2.0"}}', "ply": binary(),
    "stl": stl([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]), "text stl": stl_text(), "zip": _zip("a.obj"), "3mf": _zip("3D/3dmodel.model"),
    "fbx": b"Kaydara FBX Binary  \0\x1a\0" + bytes(90), "fbx text": b"; FBX 7.3.0 project file\n", "blend": b"BLENDER-v293" + bytes(90),
    "dae": b'<?xml version="1.0"?>\n<COLLADA xmlns="x">', "usd": b"#usda 1.0\n", "vox": b"VOX \x96\0\0\0MAIN", "7z": b"7z\xbc\xaf\x27\x1c\0",
    "page": b"<!DOCTYPE html>\n<html>", "lfs": b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n", "png": png([[(1, 2, 3)]])}
WORDS = {"obj": "an OBJ file: rename it to .obj", "marked obj": "an OBJ file: rename", "glb": "a GLB file: rename it to .glb", "gltf": "a JSON text.*rename it to .gltf",
         "ply": "a PLY file: rename it to .ply", "stl": "an STL file: rename it to .stl", "text stl": "an STL file: rename it to .stl",
         "zip": "an archive: unpack it", "3mf": "a 3MF file: .*STL", "fbx": "an FBX file: .*Blender", "fbx text": "an FBX file: .*Blender",
         "blend": "a file of Blender: .*glTF", "dae": "a Collada file: .*Blender", "usd": "a USD file: .*Blender", "vox": "a file of MagicaVoxel: export it there as OBJ",
         "7z": "an archive: unpack", "page": "a web page.*download", "lfs": "a pointer of Git LFS.*git lfs pull", "png": "an image: 'fixel texture'"}
OWN = {"obj": {"obj", "marked obj"}, "glb": {"glb", "gltf"}, "gltf": {"glb", "gltf"}, "ply": {"ply"}, "stl": {"stl", "text stl"}}


@pytest.mark.parametrize("suffix", OWN)
@pytest.mark.parametrize("kind", DATA)
def test_content_goes_before_the_name(tmp_path, suffix, kind):
    path = tmp_path / f"model.{suffix}"
    path.write_bytes(DATA[kind])
    if kind in OWN[suffix]:
        if kind != "gltf":      # which has no face
            assert model_file.reader_of(path)(str(path))[0].faces
        return
    with pytest.raises(ToolError, match=f"model.{suffix}: holds {WORDS[kind]}"):
        model_file.reader_of(path)(str(path), path.name)


@pytest.mark.parametrize("head", [b"ply\n", b"solid thing\nfacet", b"<html>", b"glTF", b"v 1 2 3\n", b"PK\x03\x04"])
def test_a_binary_stl_file_may_begin_with_anything(tmp_path, head):
    path = tmp_path / "model.stl"
    path.write_bytes(head.ljust(80, b" ") + DATA["stl"][80:])
    assert len(model_file.reader_of(path)(str(path))[0].faces) == 4


# Beginnings of formats that no test above has; what they must be named.
BEGINNINGS = {
    "bbmodel": (b'{"meta":{"format_version":"4.9","model_format":"free"}}', "Blockbench"), "md2": (b"IDP2\x08\0\0\0", "Quake"), "md3": (b"IDP3", "Quake"),
    "mdl": (b"IDST\x0a\0\0\0", "Half-Life"), "iqm": (b"INTERQUAKEMODEL\0", "Inter-Quake"), "md5mesh": (b"MD5Version 10\n", "Doom 3"),
    "bsp": (b"IBSP\x2e\0\0\0", "level"), "old bsp": (b"\x1d\0\0\0" + bytes(40), "level"), "map": (b'// Game: Quake\n// Format: Valve\n{\n"classname" "worldspawn"\n}', "TrenchBroom"),
    "tmx": (b'<?xml version="1.0" encoding="UTF-8"?>\n<map version="1.10">', "Tiled"), "tmj": (b'{ "compressionlevel":-1,\n "height":8,', "Tiled"),
    "ldtk": (b'{\n\t"__header__": {\n\t\t"fileType": "LDtk Project JSON"', "LDtk"),
    "aseprite": (b"\x40\0\0\0\xe0\xa5" + bytes(40), "Aseprite"), "ttf": (b"\0\1\0\0\0\x0c" + bytes(40), "TrueType"), "otf": (b"OTTO\0", "OpenType"), "woff2": (b"wOF2", "font"),
    "bdf": (b"STARTFONT 2.1\n", "fixel font"), "qoi": (b"qoif\0\0\0\x08", "QOI"), "svg": (b'<?xml version="1.0"?>\n<svg xmlns="x">', "SVG"), "dds": (b"DDS ", "DDS"),
    "tif": (b"II*\0", "TIFF"), "psd": (b"8BPS", "PSD"), "3ds": (b"MM\x10\0\0\0\x02\0\x0a\0\0\0", "3D Studio"), "step": (b"ISO-10303-21;\nHEADER;", "STEP"),
    "ifc": (b"ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));", "IFC"), "usdz": (b"PK\x03\x04" + bytes(26) + b"house.usdc", "USD"), "jpg": (b"\xff\xd8\xff\xe0", "fixel texture"),
    "godot": (b"[gd_scene load_steps=2 format=3]\n", "Godot"), "dxf": (b"  0\r\nSECTION\r\n", "DXF"), "las": (b"LASF", "points"), "ole": (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "SolidWorks"),
    "fxls": (b"FXLS" + bytes(40), "scene image"), "mtl": (b"# Blender MTL\nnewmtl a\n", "materials")}


@pytest.mark.parametrize("kind", BEGINNINGS)
def test_a_file_without_an_ending_is_known_by_how_it_begins(tmp_path, kind):
    blob, word = BEGINNINGS[kind]
    (tmp_path / "unnamed").write_bytes(blob)
    with pytest.raises(ToolError, match=f"unnamed: holds .*{word}"):
        compiler.compile_scene(str(tmp_path / "unnamed"))
    (tmp_path / "model.obj").write_bytes(blob)
    with pytest.raises(ToolError, match=f"model.obj: holds .*{word}"):
        compiler.compile_scene(str(tmp_path / "model.obj"))


@pytest.mark.parametrize("found", foreign.FORMATS, ids=lambda found: found.kind)
def test_a_format_is_known_by_its_endings_whatever_is_in_the_file(tmp_path, found):
    """Each row names what the file is and a way on. A file that is not there, or says nothing, is known by its name; an object of a scene is
    refused alike."""
    assert found.endings or found.beginning
    assert len(found.way.split()) >= 3 and not found.way.endswith(".")
    for ending in found.endings:
        path = tmp_path / f"thing{ending.upper()}"
        for blob in (None, b"\x9d\xfe nothing that begins like a file"):
            if blob:
                path.write_bytes(blob)
            with pytest.raises(ToolError) as refused:
                compiler.compile_scene(str(path))
            assert found.kind in refused.value.message and found.way in refused.value.message
        (tmp_path / "scene.toml").write_text(f'[path]\norbit = {{ radius = 4 }}\n[[objects]]\nmodel = "thing{ending}"\n')
        with pytest.raises(ToolError) as refused:
            compiler.compile_scene(str(tmp_path / "scene.toml"))
        assert found.way in refused.value.message


def test_no_ending_is_of_two_formats_or_of_one_that_is_read():
    endings = [ending for found in foreign.FORMATS for ending in found.endings]
    assert len(endings) == len(set(endings)) and not set(endings) & set(suffixes.READ)


@pytest.mark.parametrize("kind, name, word", [("zip", "level.litematic", "Minecraft"), ("zip", "part.f3d", "Fusion"), ("zip", "thing.zip", "unpack"),
                                              ("gltf", "level.tmj", "Tiled"), ("gltf", "cow.bbmodel", "Blockbench"), ("gltf", "thing.json", "rename")])
def test_an_archive_or_a_json_text_is_known_by_its_name_where_that_says_more(tmp_path, kind, name, word):
    (tmp_path / name).write_bytes(DATA[kind])
    with pytest.raises(ToolError, match=word):
        compiler.compile_scene(str(tmp_path / name))


@pytest.mark.parametrize("kind, word", [("ttf", "otf2bdf"), ("jpg", "no font"), ("blend", "no font")])
def test_fixel_font_names_what_it_was_given(tmp_path, kind, word):
    (tmp_path / "font").write_bytes(BEGINNINGS.get(kind, (DATA.get(kind),))[0])
    assert_one_sentence(run_cli("font", tmp_path / "font", "-o", tmp_path / "out.h"), word)
