# SPDX-License-Identifier: MIT
"""The readers of model files. A file that holds something else by its first bytes than its name says is refused."""

import os
import re

from fixel.base import foreign, reading
from fixel.base.errors import ToolError
from fixel.base.reading import quoted
from fixel.model import gltf, model_text, obj, ply, stl, suffixes

# How files of formats that are read begin, what they are, and the endings of their names. Texts come behind foreign.py's formats, some of
# which are texts that begin alike.
_BINARY = ((rb"glTF", "a GLB file", ".glb"), (rb"ply[ \t]*[\r\n]", "a PLY file", ".ply"))
_JSON = "a JSON text, as glTF is", ".gltf"
_TEXTS = (
    (rb"\s*\{\s*\"", *_JSON),
    (rb"(?i)\s*solid\b[^\0]*\n\s*(?:facet|endsolid)\b", "an STL file", ".stl"),
    (rb"(?:\s|#[^\r\n]*[\r\n])*(?:mtllib|usemtl|v|vn|vt|o|g)[ \t]+[^\r\n]", "an OBJ file", ".obj"),
)


def _as_bytes(start):
    """The beginning of a text in UTF-8, without a byte order mark."""
    rest, encoding = model_text.without_mark(start)
    return rest if encoding == "utf-8" else rest.decode(encoding, "replace").encode()


def _of(start, formats):
    return next(((kind, ending) for pattern, kind, ending in formats if re.match(pattern, start)), None)


def _kind(path):
    """((what a file holds, the ending of its name), None) of a format that is read, (None, a foreign.Foreign) of another one,
    (None, None) where it is not known."""
    start = reading.read_start(path, foreign.START)
    text = _as_bytes(start)
    known, other = _of(text, _BINARY), foreign.by_beginning(text)
    if known is None and other is None:
        known = _of(text, _TEXTS)
    if known is None and other is None and stl.is_whole(start, os.path.getsize(path)):
        known = "an STL file", ".stl"
    return known, None if known else other


def refuse_other(path, name):
    """Refuses a file that holds something else than its name says. name: for the message."""
    (known, other), suffix = _kind(path), suffixes.suffix_of(path)
    if known and known[1] != suffix and {known[1], suffix} != {".glb", ".gltf"}:
        raise ToolError(f"{name}: holds {known[0]}: rename it to {known[1]}")
    if other:
        raise ToolError(f"{name}: holds {other.kind}: {other.way_to_model()}")


def refuse_by_all(path, name):
    """Refuses a file of a known format whose name's ending is of no model: by what it holds, or by its name where that says more."""
    if os.path.isfile(path):
        known, other = _kind(path)
        is_vague = known == _JSON or other is not None and other.sort == foreign.CONTAINER
        if not (is_vague and foreign.by_ending(path)):
            refuse_other(path, name)
    suffixes.refuse_other(path, name)


def _checked(read):
    """A reader that refuses files that hold something else."""
    def checked(path, name=None, progress=None, sources=None):
        refuse_other(path, name or str(path))
        return read(path, name, progress, sources)
    return checked


def _read_stl(path, name=None, progress=None, sources=None):
    """Reads an STL file. Its first bytes may be anything, so only what is no STL file is looked at."""
    try:
        return stl.read(path, name, progress, sources)
    except ToolError:
        refuse_other(path, name or str(path))
        raise


_GLTF = _checked(gltf.read)
READERS = {".obj": _checked(obj.read), ".gltf": _GLTF, ".glb": _GLTF, ".stl": _read_stl, ".ply": _checked(ply.read)}


def reader_of(path):
    """The function that reads a file, by its name."""
    suffixes.refuse_other(path, quoted(str(path)))
    if not suffixes.is_model(path):
        raise ToolError(f"{quoted(str(path))}: a model is {suffixes.SUFFIXES}")
    return READERS[suffixes.suffix_of(path)]
