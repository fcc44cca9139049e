# SPDX-License-Identifier: MIT
"""What a file holds by its first bytes, where its name says something else."""

import os
import re

from fixel.base import reading
from fixel.base.errors import ToolError
from fixel.model import model_text, stl, suffixes

_START = 2048           # bytes that are looked at
_BLENDER = "open it in Blender and export it as glTF (.glb)"
_UNPACK = "unpack it, and give the model in it"
_POINTER = "fetch the file itself, as by git lfs pull"
_PAGE = "download the file itself"
_IMAGE = "give a model"
_FREECAD = "open it in FreeCAD and export it as STL or glTF"
# How files begin, what they are, and the way on. Texts come last, which a comment of another file might begin like.
_BEGINNINGS = (
    (rb"glTF", "a GLB file", ".glb"), (rb"ply[ \t]*[\r\n]", "a PLY file", ".ply"), (rb"\s*\{\s*\"", "a JSON text, as glTF is", ".gltf"),
    (rb"Kaydara FBX Binary|\s*; FBX", "an FBX file", _BLENDER), (rb"BLENDER[-_]?[v0-9]|\x28\xb5\x2f\xfd", "a file of Blender", _BLENDER),
    (rb"PXR-USDC|#usda", "a USD file", _BLENDER), (rb"VOX [\x00-\xff]\x00\x00\x00", "a file of MagicaVoxel", "export it there as OBJ"),
    (rb"PK\x03\x04[\x00-\xff]*3D/", "a 3MF file", "open it in a slicer or in FreeCAD and export it as STL"),
    (rb"PK\x03\x04|7z\xbc\xaf\x27\x1c|Rar!|\x1f\x8b\x08|BZh[1-9]|\xfd7zXZ", "an archive", _UNPACK),
    (rb"\x89PNG|\xff\xd8\xff|GIF8|BM[\x00-\xff]{4}\x00\x00\x00\x00|RIFF[\x00-\xff]{4}WEBP", "an image", _IMAGE),
    (rb"ISO-10303-21", "a STEP file", _FREECAD), (rb"#VRML", "a VRML file", _BLENDER), (rb"#X3D", "an X3D file", _BLENDER),
    (rb"version https://git-lfs", "a pointer of Git LFS, not the file", _POINTER),
    (rb"\s*(?:<\?xml[^>]*>\s*)?(?:<!--[^>]*-->\s*)?<COLLADA", "a Collada file", _BLENDER),
    (rb"(?i)\s*<(?:!DOCTYPE )?html", "a web page, not the file", _PAGE),
    (rb"(?i)\s*solid\b[^\0]*\n\s*(?:facet|endsolid)\b", "an STL file", ".stl"),
    (rb"(?:\s|#[^\r\n]*[\r\n])*(?:mtllib|usemtl|v|vn|vt|o|g)[ \t]+[^\r\n]", "an OBJ file", ".obj"),
)


def _as_bytes(start):
    """The beginning of a text in UTF-8, without a byte order mark."""
    rest, encoding = model_text.without_mark(start)
    return rest if encoding == "utf-8" else rest.decode(encoding, "replace").encode()


def _kind(path):
    """(what a file holds, the way on: the ending of its name, or words); None where it is not known."""
    start = reading.read_start(path, _START)
    text = _as_bytes(start)
    found = next(((kind, way) for pattern, kind, way in _BEGINNINGS if re.match(pattern, text)), None)
    if found is None and stl.is_whole(start, os.path.getsize(path)):
        return "an STL file", ".stl"
    return found


def refuse_other(path, name):
    """Refuses a file that holds something else than its name says. name: for the message."""
    found, suffix = _kind(path), suffixes.suffix_of(path)
    if found is None or found[1] == suffix or {found[1], suffix} == {".glb", ".gltf"}:
        return
    kind, way = found
    raise ToolError(f"{name}: holds {kind}: " + (f"rename it to {way}" if way.startswith(".") else way))
