# SPDX-License-Identifier: MIT
"""Reading Wavefront OBJ: v, vt, vn and f in every index form.

OBJ is right-handed and its outlines run counter-clockwise; Fixel is
left-handed and clockwise. Negating z changes the handedness and leaves what is
seen from the front as it was: what looked along -z with x to the right now
looks along +z with x to the right. So an outline is still counter-clockwise,
and its corners are taken in reverse."""

from decimal import Decimal, InvalidOperation

from fixel.errors import ToolError
from fixel.mesh import UNIT, Mesh

COORDINATE_LIMIT = Decimal(10) ** 9
_SIZES = {"v": 3, "vt": 1, "vn": 3}
_IGNORED = {"g", "o", "s", "usemtl", "mtllib", "usemap", "maplib", "l", "p", "vp", "cstype"}


def _vertex(words, where):
    """x, y, z in units of 1/UNIT, z negated. What follows (w, colour) is not needed."""
    point = []
    for word in words[:3]:
        try:
            value = Decimal(word)
        except InvalidOperation:
            raise ToolError(f'{where}: "{word}" is not a number') from None
        if not value.is_finite() or abs(value) > COORDINATE_LIMIT:
            raise ToolError(f"{where}: coordinate {word} is out of every range")
        point.append(int((value * UNIT).to_integral_value()))
    return point[0], point[1], -point[2]


def _index(text, counts, kind, where):
    """An index, from 1 or negative from the end, as a number from 0."""
    try:
        index = int(text)
    except ValueError:
        raise ToolError(f'{where}: "{text}" is not an index') from None
    count = counts[kind]
    number = index - 1 if index > 0 else count + index
    if index == 0 or not 0 <= number < count:
        raise ToolError(f"{where}: {kind} {index} does not exist; {count} stand above this line")
    return number


def _corner(word, counts, where):
    parts = word.split("/")
    if len(parts) > 3 or not parts[0]:
        raise ToolError(f'{where}: "{word}" is not a corner (v, v/vt, v//vn or v/vt/vn)')
    for text, kind in zip(parts[1:], ("vt", "vn")):
        if text:
            _index(text, counts, kind, where)
    return _index(parts[0], counts, "v", where)


def _lines(path):
    """(line number, words), continued lines joined and comments cut."""
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            held = ""
            for number, line in enumerate(file, 1):
                line = held + line.split("#", 1)[0].rstrip()
                if line.endswith("\\"):
                    held = line[:-1] + " "
                    continue
                held = ""
                words = line.split()
                if words:
                    yield number, words
    except OSError as error:
        raise ToolError(f"{path}: cannot be read ({error.strerror})") from error


def read(path, name=None):
    """(mesh, notes). The name stands in messages."""
    name = name or str(path)
    vertices, faces, lines = [], [], []
    counts, ignored = {"v": 0, "vt": 0, "vn": 0}, {}
    for number, (word, *rest) in _lines(path):
        where = f"{name}:{number}"
        if word in _SIZES:
            if len(rest) < _SIZES[word]:
                raise ToolError(f"{where}: {word} needs {_SIZES[word]} numbers, found {len(rest)}")
            counts[word] += 1
            if word == "v":
                vertices.append(_vertex(rest, where))
        elif word == "f":
            if len(rest) < 3:
                raise ToolError(f"{where}: a face needs three corners, found {len(rest)}")
            faces.append([_corner(text, counts, where) for text in reversed(rest)])
            lines.append(number)
        elif word in _IGNORED:
            ignored[word] = ignored.get(word, 0) + 1
        else:
            raise ToolError(f'{where}: unknown statement "{word}"; is this an OBJ file?')
    if not faces:
        raise ToolError(f"{name}: there is no face in this file")
    notes = [f"{name}: right-handed and counter-clockwise, as OBJ is: z was negated and every "
             "outline reversed"]
    if ignored:
        notes.append(f"{name}: ignored " + ", ".join(f"{n} x {w}" for w, n in ignored.items()))
    return Mesh(vertices, faces, [f"{name}:{line}" for line in lines]), notes
