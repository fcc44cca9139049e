# SPDX-License-Identifier: MIT
"""Models in files of any format that the tools read."""

import os

from fixel.model import gltf, obj, stl
from fixel.base.errors import ToolError
from fixel.base.reading import quoted

READERS = {".obj": obj.read, ".gltf": gltf.read, ".glb": gltf.read, ".stl": stl.read}
SUFFIXES = "an .obj, .gltf, .glb or .stl file"


def suffix_of(path):
    """The ending that says what a file holds."""
    return os.path.splitext(os.fspath(path))[1].lower()


def is_model(path):
    """Whether a file is a model, by its name."""
    return suffix_of(path) in READERS


def holds_triangles(path):
    """Whether the format has triangles alone, so that flat faces come in pieces."""
    return suffix_of(path) in (".gltf", ".glb", ".stl")


def reader_of(path):
    """The function that reads a file, by its name."""
    if not is_model(path):
        raise ToolError(f"{quoted(str(path))}: a model is {SUFFIXES}")
    return READERS[suffix_of(path)]
