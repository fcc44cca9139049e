# SPDX-License-Identifier: MIT
"""The readers of model files."""

from fixel.model import content, gltf, obj, ply, stl
from fixel.base.errors import ToolError
from fixel.base.reading import quoted
from fixel.model.suffixes import SUFFIXES, is_model, refuse_other, suffix_of


def _checked(read):
    """A reader that refuses files that hold something else."""
    def checked(path, name=None, progress=None, sources=None):
        content.refuse_other(path, name or str(path))
        return read(path, name, progress, sources)
    return checked


def _read_stl(path, name=None, progress=None, sources=None):
    """Reads an STL file. Its first bytes may be anything, so only what is no STL file is looked at."""
    try:
        return stl.read(path, name, progress, sources)
    except ToolError:
        content.refuse_other(path, name or str(path))
        raise


_GLTF = _checked(gltf.read)
READERS = {".obj": _checked(obj.read), ".gltf": _GLTF, ".glb": _GLTF, ".stl": _read_stl, ".ply": _checked(ply.read)}


def reader_of(path):
    """The function that reads a file, by its name."""
    refuse_other(path, quoted(str(path)))
    if not is_model(path):
        raise ToolError(f"{quoted(str(path))}: a model is {SUFFIXES}")
    return READERS[suffix_of(path)]
