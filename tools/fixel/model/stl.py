# SPDX-License-Identifier: MIT
"""Reading STL, binary and text. x is to the right, y ahead and z upward, and outlines run counter-clockwise.

A binary file may have a colour of 15 bits in the two bytes behind each triangle, in one of two ways. With COLOR= in the
header (Magics), bit 15 is clear for a colour and red is lowest; without, bit 15 is set for a colour and blue is lowest.
Without COLOR= the bytes of a file that gives all its triangles one colour are no colours: programs leave any bytes there.

The project has a reader of its own for STL: a refusal of a text file names the line, and a binary file is one table."""

import re

import numpy as np

from fixel.base.errors import ToolError
from fixel.base.notes import Usual
from fixel.model import model_text
from fixel.model.mesh import FILE_FACES_MAX, Mesh, UNIT
from fixel.base.reading import quoted
from fixel.model.sources import Sources
from fixel.model.surface import GREY, Material, Surfaces, WHITE

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


def _surfaces(blob, attributes, name):
    """(the surface.Surfaces of a binary file, None where no triangle has a colour; notes). Of a file with COLOR= the triangles
    without a colour of their own have that one."""
    place = blob.find(_COLOUR, 0, _HEAD - 8)     # four bytes of colour stand behind it
    is_said = place >= 0
    common = tuple(blob[place + len(_COLOUR):][:3]) if is_said else GREY
    has_own = attributes >> 15 == (0 if is_said else 1)
    if not is_said and not has_own.any():
        return None, []
    colours = [_five_bits(value, is_said) if own else common
               for own, value in zip(has_own.tolist(), (attributes & 0x7FFF).tolist())]
    count = len(set(colours))
    if not is_said and count == 1:
        return None, [f"{name}: the two bytes behind every triangle are 0x{attributes[0]:04x}: without COLOR= in the head, and without "
                      "a second colour, they are read as no colour"]
    made = Surfaces([Material("none", WHITE)], has_materials=False)
    for colour in colours:
        made.add(0, tint=None if colour == WHITE else colour)
    how = "COLOR= in the head and " if is_said else ""
    return made, [f"{name}: {how}the two bytes behind each triangle are read as its colour ({count:,} different); --no-colours leaves "
                  "colours out"]


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
    surfaces, notes = _surfaces(blob, rows["attribute"], name)
    notes += [f"{name}: left out bytes after the last triangle: {after:,}"] if after else []
    return corners.reshape(-1, 3).tolist(), [f"{name}: triangle {face}" for face in range(count)], surfaces, notes


def _number(word, where):
    try:
        value = model_text.decimal(word)
    except ValueError:
        raise ToolError(f"{where}: {quoted(word)} is not a number") from None
    if not abs(value) <= COORDINATE_LIMIT:
        raise ToolError(f"{where}: coordinate {quoted(word)} is out of every range: it must be within "
                        f"{COORDINATE_LIMIT:,}")
    return value


def _words(line):
    """The words of a line, the first in lower case; one that begins with end may be two, as in end loop."""
    word, *rest = line.split() or [""]
    word = word.lower()
    if word == "end" and rest and word + rest[0].lower() in _SKIPPED:
        return [word + rest[0].lower(), *rest[1:]]
    return [word, *rest]


class _Text:
    """What a text says, line by line."""

    def __init__(self, name):
        self.name, self.points, self.places, self.begun = name, [], [], None
        self.is_over, self.after, self.unknown = False, 0, model_text.LeftOut()

    def line(self, line, where):
        """A line. Between facets stands what other programs wrote there, such as a colour."""
        word, *rest = _words(line)
        if word in _SKIPPED or word == "vertex":
            self.is_over = word == "endsolid"
        if word == "vertex":
            if len(rest) != 3:
                raise ToolError(f"{where}: vertex needs 3 numbers, found {len(rest)}")
            self.points.append([_number(each, where) for each in rest])
        elif word == "facet":
            self.begun = where
        elif word == "endloop":
            if len(self.points) != 3 * len(self.places) + 3:
                raise ToolError(f"{where}: a facet has three vertices; this one has {len(self.points) - 3 * len(self.places)}")
            self.places.append(self.begun or where)
            _refuse_many(self.name, len(self.places))
        elif word and word not in _SKIPPED and self.is_over:
            self.after += 1
        elif word and word not in _SKIPPED:
            self.unknown.add(word, where)

    def notes(self):
        """What was left out."""
        return self.unknown.notes(self.name, "left out statements that are not known:") + (
            [f"{self.name}: left out lines after the last endsolid: {self.after:,}"] if self.after else [])


def _text(blob, name, progress):
    made = _Text(name)
    for number, line in model_text.lines_of(blob):
        if progress and number % 4096 == 0:
            progress(f"{name}: line {number:,}")
        made.line(line, f"{name}:{number}")
    if len(made.points) != 3 * len(made.places):
        raise ToolError(f"{name}: the file ends within a facet: its last lines are missing")
    return made.points, made.places, None, made.notes()


def _is_text(blob):
    start = "".join(line for _, line in model_text.lines_of(blob[:_START])).lower()
    return re.match(r"\s*solid\b", start) and ("vertex" in start or "endsolid" in start or len(blob) < _HEAD)


def is_whole(start, size):
    """Whether a binary file of this many bytes, with this start, has the triangles that its header says, and no more."""
    count = int.from_bytes(start[80:_HEAD], "little")
    return count > 0 and size == _HEAD + count * _TRIANGLE.itemsize


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
        raise ToolError(f"{name}: there is no face in this file" + (
            "" if count == 0 else "; in a text each statement stands on a line of its own"))
    vertices = [(exact(x), exact(z), exact(y)) for x, y, z in points]
    faces = [[3 * face + 2, 3 * face + 1, 3 * face] for face in range(len(places))]
    return Mesh(vertices, faces, places, surfaces, surfaces.uvs if surfaces else []), [Usual(f"{name}: {_CONVENTION}"), *notes]
