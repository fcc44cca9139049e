# SPDX-License-Identifier: MIT
"""The readers of model files."""

from fixel.model import gltf, obj, ply, stl
from fixel.base.errors import ToolError
from fixel.base.reading import quoted
from fixel.model.suffixes import SUFFIXES, is_model, refuse_other, suffix_of

READERS = {".obj": obj.read, ".gltf": gltf.read, ".glb": gltf.read, ".stl": stl.read, ".ply": ply.read}


def reader_of(path):
    """The function that reads a file, by its name."""
    refuse_other(path, quoted(str(path)))
    if not is_model(path):
        raise ToolError(f"{quoted(str(path))}: a model is {SUFFIXES}")
    return READERS[suffix_of(path)]
