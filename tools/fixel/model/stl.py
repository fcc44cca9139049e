# SPDX-License-Identifier: MIT
"""Reading STL, binary and text. x is to the right, y ahead and z upward, and outlines run counter-clockwise.

A binary file may have a colour of 15 bits in the two bytes behind each triangle, in one of two ways. With COLOR= in the
header (Magics), bit 15 is clear for a colour and red is lowest; without, bit 15 is set for a colour and blue is lowest.

The project has a reader of its own for STL: a refusal of a text file names the line, and a binary file is one table."""

import re

import numpy as np

from fixel.base.errors import ToolError
from fixel.model import model_text, number_text
from fixel.model.mesh import FILE_FACES_MAX, UNIT, Mesh
from fixel.base.reading import quoted
from fixel.model.sources import Sources
from fixel.model.surface import GREY, Material, Surfaces

FILE_MAX = 64 << 20         # bytes
COORDINATE_LIMIT = 10 ** 9
_START = 4096               # bytes in which a text has its first vertex
_HEAD = 84                  # bytes before the triangles of a binary file
_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_SKIPPED = {"solid", "facet", "outer", "endloop", "endfacet", "endsolid"}
_COLOUR = b"COLOR="
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


def _five_bits(value, lowest):
    """Three numbers of five bits as red, green, blue of 0..255. lowest: whether red, and not blue, is lowest."""
    parts = [(value >> shift & 31) * 255 // 31 for shift in (0, 5, 10)]
    return tuple(parts if lowest else parts[::-1])


def _surfaces(blob, attributes):
    """The surface.Surfaces of a binary file; None where no triangle has a colour. Of a file with COLOR= those without
    have that one."""
    place = blob.find(_COLOUR, 0, _HEAD - 8)     # four bytes of colour stand behind it
    common = tuple(blob[place + len(_COLOUR):][:3]) if place >= 0 else GREY
    has_own = attributes >> 15 == (0 if place >= 0 else 1)
    if place < 0 and not has_own.any():
        return None
    made, numbers = Surfaces(), {}
    for own, value in zip(has_own.tolist(), (attributes & 0x7FFF).tolist()):
        colour = _five_bits(value, place >= 0) if own else common
        if colour not in numbers:
            numbers[colour] = len(numbers)
            made.materials.append(Material("none", colour))
        made.add(numbers[colour])
    return made


def _binary(blob, name, count):
    _refuse_many(name, count)
    rows = np.frombuffer(blob, _TRIANGLE, count, _HEAD)
    corners = rows["corners"].astype(float)
    wrong = np.argwhere(~(np.abs(corners) <= COORDINATE_LIMIT))
    if len(wrong):
        face, corner, axis = wrong[0]
        raise ToolError(f"{name}: triangle {face}: {'xyz'[axis]} of corner {corner} is {corners[face, corner, axis]:g}; "
                        f"it must be within {COORDINATE_LIMIT:,}")
    after = len(blob) - _HEAD - count * _TRIANGLE.itemsize
    notes = [f"{name}: left out bytes after the last triangle: {after:,}"] if after else []
    return corners.reshape(-1, 3).tolist(), [f"{name}: triangle {face}" for face in range(count)], \
        _surfaces(blob, rows["attribute"]), notes


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
    points, places, begun, ended, after = [], [], 0, False, 0
    for number, line in model_text.lines_of(blob):
        words, where = line.split(), f"{name}:{number}"
        if progress and number % 4096 == 0:
            progress(f"{name}: line {number:,}")
        word = words[0].lower() if words else ""
        if word in _SKIPPED:
            ended = word == "endsolid"
        if ended and word not in _SKIPPED:
            after += bool(word)
        elif word == "vertex":
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
    return points, places, None, [f"{name}: left out lines after the last endsolid: {after:,}"] if after else []


def _is_text(blob):
    start = "".join(line for _, line in model_text.lines_of(blob[:_START])).lower()
    return re.match(r"\s*solid\b", start) and "vertex" in start


def _is_binary(blob, count):
    """Whether the header's triangles are there; a file that is longer is one unless it is a text."""
    whole = _HEAD + count * _TRIANGLE.itemsize
    return len(blob) == whole or (count and len(blob) > whole)


def read(path, name=None, progress=None, sources=None):
    """(mesh, notes). The name stands in messages. sources: those of the scene."""
    name = name or str(path)
    sources = sources or Sources()
    blob = sources.read(path, FILE_MAX, "simplify the model")
    count = int.from_bytes(blob[80:_HEAD], "little")
    if len(blob) >= _HEAD and _is_binary(blob, count):
        points, places, surfaces, notes = _binary(blob, name, count)
    elif _is_text(blob):
        points, places, surfaces, notes = _text(blob, name, progress)
    elif len(blob) < _HEAD:
        raise ToolError(f"{name}: {len(blob)} bytes are fewer than the {_HEAD} of the header of an STL file")
    else:
        raise ToolError(f"{name}: the header promises {count:,} triangles, which take {_HEAD + 50 * count:,} bytes; the file "
                        f"has {len(blob):,}: it is damaged, or no STL file")
    if not places:
        raise ToolError(f"{name}: there is no face in this file")
    vertices = [(exact(x), exact(z), exact(y)) for x, y, z in points]
    faces = [[3 * face + 2, 3 * face + 1, 3 * face] for face in range(len(places))]
    return Mesh(vertices, faces, places, surfaces, surfaces.uvs if surfaces else []), [f"{name}: {_CONVENTION}", *notes]
