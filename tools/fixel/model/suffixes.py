# SPDX-License-Identifier: MIT
"""The endings of model files' names: of formats that are read, and of others. It needs no package."""

import os

from fixel.base.errors import ToolError

READ = (".obj", ".gltf", ".glb", ".stl", ".ply")
SUFFIXES = "an .obj, .gltf, .glb, .stl or .ply file"
_BLENDER = "open it in Blender and export it as glTF (.glb)"
_FREECAD = "open it in FreeCAD and export it as STL or glTF"
_UNPACK = "unpack it, and give the model in it"
# Formats that are not read: what they are, and the way to one that is.
_OTHERS = {
    ".fbx": ("an FBX file", _BLENDER), ".dae": ("a Collada file", _BLENDER), ".blend": ("a file of Blender", _BLENDER), ".blend1": ("a file of Blender", _BLENDER),
    ".3ds": ("a file of 3D Studio", _BLENDER),
    ".usd": ("a USD file", _BLENDER), ".usdz": ("a USD file", _BLENDER), ".usdc": ("a USD file", _BLENDER),
    ".usda": ("a USD file", _BLENDER), ".wrl": ("a VRML file", _BLENDER), ".x3d": ("an X3D file", _BLENDER),
    ".abc": ("an Alembic file", _BLENDER), ".vrm": ("a VRM file, which is a GLB file,", "rename it to .glb"),
    ".3mf": ("a 3MF file", "open it in a slicer or in FreeCAD and export it as STL"),
    ".step": ("a STEP file", _FREECAD),
    ".stp": ("a STEP file", _FREECAD), ".igs": ("an IGES file", _FREECAD), ".iges": ("an IGES file", _FREECAD),
    ".dxf": ("a DXF file", _FREECAD), ".amf": ("an AMF file", "open it in a slicer or in FreeCAD and export it as STL"),
    ".off": ("an OFF file", "open it in MeshLab and export it as PLY"), ".max": ("a file of 3ds Max", "export it there as OBJ"),
    ".c4d": ("a file of Cinema 4D", "export it there as glTF"), ".ma": ("a file of Maya", "export it there as OBJ"),
    ".mb": ("a file of Maya", "export it there as OBJ"),
    ".vox": ("a file of MagicaVoxel", "export it there as OBJ"),
    ".zip": ("an archive", _UNPACK), ".7z": ("an archive", _UNPACK), ".rar": ("an archive", _UNPACK), ".gz": ("an archive", _UNPACK),
    ".tar": ("an archive", _UNPACK), ".tgz": ("an archive", _UNPACK), ".bz2": ("an archive", _UNPACK), ".xz": ("an archive", _UNPACK),
}


def suffix_of(path):
    """The ending that says what a file holds."""
    return os.path.splitext(os.fspath(path))[1].lower()


def is_model(path):
    """Whether a file is a model, by its name."""
    return suffix_of(path) in READ


def holds_triangles(path):
    """Whether the format has triangles alone, so that flat faces come in pieces."""
    return suffix_of(path) in (".gltf", ".glb", ".stl", ".ply")


def refuse_other(path, where):
    """Refuses a file of a known format that is not read, with the way to one that is. where: what names the file."""
    if suffix_of(path) in _OTHERS:
        kind, way = _OTHERS[suffix_of(path)]
        raise ToolError(f"{where}: {kind} is not read: {way}")
