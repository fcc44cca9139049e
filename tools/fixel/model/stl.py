# SPDX-License-Identifier: MIT
"""Reading STL, binary and text. x is to the right, y ahead and z upward, and outlines run counter-clockwise.

The project has a reader of its own for STL: a refusal of a text file names the line, and a binary file is one table."""

import re

import numpy as np

from fixel.base.errors import ToolError
from fixel.model import number_text
from fixel.model.mesh import FILE_FACES_MAX, UNIT, Mesh
from fixel.base.reading import quoted
from fixel.model.sources import Sources

FILE_MAX = 64 << 20         # bytes
COORDINATE_LIMIT = 10 ** 9
_HEAD = 84                  # bytes before the triangles of a binary file
_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_SKIPPED = {"solid", "facet", "outer", "endloop", "endfacet", "endsolid"}
_CONVENTION = ("right-handed, counter-clockwise and with z upward, as STL is: y and z were exchanged and every outline "
               "reversed")


def exact(value):
    """A float in units of 1/UNIT."""
    above, below = float(value).as_integer_ratio()
    return above * UNIT // below


def _refuse_many(name, count):
    if count > FILE_FACES_MAX:
        raise ToolError(f"{name}: {count:,} triangles are more than the limit of {FILE_FACES_MAX:,}; a scene image has room for "
                        "fewer, so simplify the model")


def _binary(blob, name, count):
    _refuse_many(name, count)
    corners = np.frombuffer(blob, _TRIANGLE, count, _HEAD)["corners"].astype(float)
    wrong = np.argwhere(~(np.abs(corners) <= COORDINATE_LIMIT))
    if len(wrong):
        face, corner, axis = wrong[0]
        raise ToolError(f"{name}: triangle {face}: {'xyz'[axis]} of corner {corner} is {corners[face, corner, axis]:g}; "
                        f"it must be within {COORDINATE_LIMIT:,}")
    return corners.reshape(-1, 3).tolist(), [f"{name}: triangle {face}" for face in range(count)]


def _number(word, where):
    try:
        value = number_text.decimal(word)
    except ValueError:
        raise ToolError(f"{where}: {quoted(word)} is not a number") from None
    if not abs(value) <= COORDINATE_LIMIT:
        raise ToolError(f"{where}: coordinate {quoted(word)} is out of every range: it must be within "
                        f"{COORDINATE_LIMIT:,}")
    return value


def _text(blob, name, progress):
    points, places, begun = [], [], 0
    for number, line in enumerate(blob.decode("utf-8", "replace").splitlines(), 1):
        words, where = line.split(), f"{name}:{number}"
        if progress and number % 4096 == 0:
            progress(f"{name}: line {number:,}")
        word = words[0].lower() if words else ""
        if word == "vertex":
            if len(words) != 4:
                raise ToolError(f"{where}: vertex needs 3 numbers, found {len(words) - 1}")
            points.append([_number(each, where) for each in words[1:]])
        elif word == "facet":
            begun = number
        elif word == "endloop":
            if len(points) != 3 * len(places) + 3:
                raise ToolError(f"{where}: a facet has three vertices; this one has {len(points) - 3 * len(places)}")
            places.append(f"{name}:{begun or number}")
            _refuse_many(name, len(places))
        elif word and word not in _SKIPPED:
            raise ToolError(f"{where}: unknown statement {quoted(words[0])}; is this an STL file?")
    if len(points) != 3 * len(places):
        raise ToolError(f"{name}: the file ends within a facet: its last lines are missing")
    return points, places


def _is_text(blob):
    return re.match(rb"\s*solid\b", blob) and b"vertex" in blob[:4096]


def read(path, name=None, progress=None, sources=None):
    """(mesh, notes). The name stands in messages. sources: those of the scene."""
    name = name or str(path)
    sources = sources or Sources()
    blob = sources.read(path, FILE_MAX, "simplify the model")
    count = int.from_bytes(blob[80:_HEAD], "little")
    if len(blob) >= _HEAD and len(blob) == _HEAD + count * _TRIANGLE.itemsize:
        points, places = _binary(blob, name, count)
    elif _is_text(blob):
        points, places = _text(blob, name, progress)
    elif len(blob) < _HEAD:
        raise ToolError(f"{name}: {len(blob)} bytes are fewer than the {_HEAD} of the header of an STL file")
    else:
        raise ToolError(f"{name}: the header promises {count:,} triangles, which take {_HEAD + 50 * count:,} bytes; the file "
                        f"has {len(blob):,}: it is damaged, or no STL file")
    if not places:
        raise ToolError(f"{name}: there is no face in this file")
    vertices = [(exact(x), exact(z), exact(y)) for x, y, z in points]
    faces = [[3 * face + 2, 3 * face + 1, 3 * face] for face in range(len(places))]
    return Mesh(vertices, faces, places), [f"{name}: {_CONVENTION}"]
