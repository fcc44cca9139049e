# SPDX-License-Identifier: MIT
"""Files that hold something else than their names say are refused with what they hold and the way on."""

import io
import zipfile

import pytest

from fixel.base.errors import ToolError
from fixel.model import model_file
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
         "7z": "an archive: unpack", "page": "a web page.*download", "lfs": "a pointer of Git LFS.*git lfs pull", "png": "an image: give a model"}
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
