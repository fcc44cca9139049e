# SPDX-License-Identifier: MIT
"""Reading Wavefront OBJ: v, vt, vn and f in every index form, and materials (mtl.py).

The project has a reader of its own for OBJ, because a refusal names the file's line, and coordinates stay exact:
readers for all formats keep neither.

OBJ is right-handed and its outlines run counter-clockwise; Fixel is
left-handed and clockwise. Negating z changes the handedness and leaves what is
seen from the front as it was: what looked along -z with x to the right now
looks along +z with x to the right. So an outline is still counter-clockwise,
and its corners are taken in reverse."""

from decimal import Decimal, InvalidOperation
import io
import os
import re

from fixel.model import mtl, number_text
from fixel.base.errors import ToolError
from fixel.model.mesh import FILE_FACES_MAX, UNIT, Mesh, without_unused
from fixel.base.reading import quoted
from fixel.model.sources import Sources
from fixel.model.surface import Material, Surfaces

FILE_MAX = 64 << 20         # bytes
CORNERS_MAX = 4096          # of a face, which is cut into triangles
COORDINATE_LIMIT = Decimal(10) ** 9
_SIZES = {"v": 3, "vt": 1, "vn": 3}
_IGNORED = {"s", "usemap", "maplib", "l", "p", "vp", "cstype", "mg", "lod",
            "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"}
_PLAIN = re.compile(r"(-?)([0-9]{1,8})(?:\.([0-9]{1,18}))?")    # a number that needs no rounding
GROUPS_MAX = 8              # names of one g
_PLACES = 18                # of UNIT
_UV_MAX = 1e6               # images across
_LINES_A_WORD = 4096        # lines between two words about the progress


def _coordinate(words, where):
    """u and v, v downward as in an image. What cannot be used is 0, 0."""
    try:
        u, v = number_text.decimal(words[0]), number_text.decimal(words[1]) if len(words) > 1 else 0.0
    except ValueError:
        raise ToolError(f"{where}: {quoted(' '.join(words[:2]))} is not a texture coordinate") from None
    return (u, 1 - v) if abs(u) <= _UV_MAX and abs(v) <= _UV_MAX else (0.0, 0.0)


def _vertex(words, where):
    """x, y, z in units of 1/UNIT, z negated. What follows (w, colour) is not needed."""
    point = []
    for word in words[:3]:
        plain = _PLAIN.fullmatch(word)
        if plain:
            sign, whole, part = plain.groups("")
            value = int(whole + part) * 10 ** (_PLACES - len(part))
            point.append(-value if sign else value)
            continue
        if not number_text.is_decimal(word):
            raise ToolError(f"{where}: {quoted(word)} is not a number")
        try:
            value = Decimal(word)
        except InvalidOperation:    # an exponent of very many digits
            raise ToolError(f"{where}: {quoted(word)} is not a number") from None
        # copy_abs: abs rounds, and fails where the exponent is larger than it can be after that.
        if value.copy_abs() > COORDINATE_LIMIT:
            raise ToolError(f"{where}: coordinate {quoted(word)} is out of every range: it must be within "
                            f"{COORDINATE_LIMIT:,}")
        point.append(int((value * UNIT).to_integral_value()))
    return point[0], point[1], -point[2]


def _index(text, counts, kind, where):
    """An index, from 1 or negative from the end, as a number from 0."""
    try:
        index = number_text.whole(text)
    except ValueError:
        raise ToolError(f"{where}: {quoted(text)} is not an index") from None
    count = counts[kind]
    number = index - 1 if index > 0 else count + index
    if index == 0 or not 0 <= number < count:
        raise ToolError(f"{where}: {kind} {quoted(index)} does not exist; {count} stand above this line")
    return number


def _corner(word, counts, where):
    """Numbers of a vertex and of a texture coordinate, None without."""
    parts = word.split("/")
    if len(parts) > 3 or not parts[0]:
        raise ToolError(f"{where}: {quoted(word)} is not a corner (v, v/vt, v//vn or v/vt/vn)")
    more = [_index(text, counts, kind, where) if text else None for text, kind in zip(parts[1:], ("vt", "vn"))]
    return _index(parts[0], counts, "v", where), more[0] if more else None


def _lines(blob):
    """(line number, words), continued lines joined and comments cut."""
    held = []
    for number, line in enumerate(io.TextIOWrapper(io.BytesIO(blob), "utf-8-sig", "replace"), 1):
        line = line.split("#", 1)[0].rstrip()
        if line.endswith("\\"):
            held.append(line[:-1])
            continue
        if held:
            line, held = " ".join([*held, line]), []
        words = line.split()
        if words:
            yield number, words


def _face(rest, counts, where):
    """(numbers of a face's vertices, in the order of Fixel; those of its texture coordinates, None if a corner has none)."""
    if len(rest) < 3:
        raise ToolError(f"{where}: a face needs three corners, found {len(rest)}")
    if len(rest) > CORNERS_MAX:
        raise ToolError(f"{where}: a face of {len(rest):,} corners; the limit is {CORNERS_MAX:,}, so cut it in "
                        "the model")
    plain = "".join(rest)
    if plain.isascii() and plain.isdigit() and len(plain) < 10 * len(rest):     # vertices alone, counted from 1: most files
        numbers = [int(text) - 1 for text in reversed(rest)]
        if 0 <= min(numbers) and max(numbers) < counts["v"]:
            return numbers, None
    vertices, coordinates = zip(*[_corner(text, counts, where) for text in reversed(rest)])
    return list(vertices), None if None in coordinates else coordinates


def _refuse_many_faces(name, count):
    if count > FILE_FACES_MAX:
        raise ToolError(f"{name}: more than {FILE_FACES_MAX:,} faces; a scene image has room for fewer, so simplify the model")


class _Materials:
    """What usemtl and mtllib of a file say."""

    def __init__(self, folder, name, sources):
        self.reader, self.name = mtl.Reader(folder, sources), name
        self.surfaces, self.numbers, self.current = Surfaces(), {}, None
        self.missing, self.unknown, self.used = None, 0, 0

    def library(self, words, where):
        """mtllib: the names of files, or one name with blanks."""
        names = words if any(self.reader.exists(word) for word in words) else [" ".join(words)]
        for each in names:
            if self.reader.exists(each):
                self.reader.read(each)
            else:
                self.missing = self.missing or f"{where}: there is no {quoted(each)}"

    def use(self, words):
        """usemtl: the material of the faces from here on."""
        self.current = " ".join(words)
        self.used += 1

    def add(self, coordinates):
        """One more face with these texture coordinates, None where a corner has none."""
        material = self.reader.materials.get(self.current)
        self.unknown += material is None and self.current is not None
        key = id(material)
        if key not in self.numbers:
            self.numbers[key] = len(self.surfaces.materials)
            self.surfaces.materials.append(material or Material("none"))
        self.surfaces.add(self.numbers[key], coordinates)

    def result(self):
        """The surfaces, None where the file has no material; and notes."""
        notes = [f"{self.missing}: its materials are left out"] if self.missing else []
        if self.unknown and self.reader.materials:
            notes.append(f"{self.name}: faces whose material no mtllib has: {self.unknown:,}")
        return self.surfaces if self.reader.materials else None, notes


class _Groups:
    """The faces under each name of o and g, as runs."""

    def __init__(self):
        self.runs, self.open = {}, {"o": ((), 0), "g": ((), 0)}

    def begin(self, word, rest, face):
        """A statement o or g, of the faces from here on. The name of an o may have blanks; a g has several names."""
        self._end(word, face)
        names = [" ".join(rest)] if word == "o" and rest else rest[:GROUPS_MAX]
        self.open[word] = tuple(dict.fromkeys(names)), face

    def _end(self, word, face):
        names, first = self.open[word]
        for name in names if first < face else ():
            self.runs.setdefault(name, []).append((first, face))

    def result(self, count):
        """{name: [(first face, behind the last)]} of a file of so many faces."""
        for word in self.open:
            self._end(word, count)
        return self.runs


class _Parser:
    """What a file says, line by line."""

    def __init__(self, name, folder, sources):
        self.name = name
        self.vertices, self.coordinates, self.faces, self.lines = [], [], [], []
        self.counts, self.ignored = {"v": 0, "vt": 0, "vn": 0}, {}
        self.materials, self.groups = _Materials(folder, name, sources), _Groups()

    def _add_face(self, rest, where):
        vertices, numbers = _face(rest, self.counts, where)
        self.faces.append(vertices)
        self.lines.append(where)
        _refuse_many_faces(self.name, len(self.faces))
        self.materials.add(numbers and [self.coordinates[number] for number in numbers])

    def _add_numbers(self, word, rest, where):
        if len(rest) < _SIZES[word]:
            raise ToolError(f"{where}: {word} needs {_SIZES[word]} numbers, found {len(rest)}")
        self.counts[word] += 1
        if word == "v":
            self.vertices.append(_vertex(rest, where))
        elif word == "vt":
            self.coordinates.append(_coordinate(rest, where))

    def line(self, word, rest, where):
        """A statement."""
        if word in _SIZES:
            self._add_numbers(word, rest, where)
        elif word == "f":
            self._add_face(rest, where)
        elif word == "mtllib":
            self.materials.library(rest, where)
        elif word == "usemtl":
            self.materials.use(rest)
        elif word in ("o", "g"):
            self.groups.begin(word, rest, len(self.faces))
        elif word in _IGNORED:
            self.ignored[word] = self.ignored.get(word, 0) + 1
        else:
            raise ToolError(f"{where}: unknown statement {quoted(word)}; is this an OBJ file?")


def read(path, name=None, progress=None, sources=None):
    """(mesh, notes). The name stands in messages. sources: those of the scene."""
    name, sources = name or str(path), sources or Sources()
    blob = sources.read(path, FILE_MAX, "simplify the model")
    # Most files have a face a line: one with too many is refused before anything of it is parsed.
    _refuse_many_faces(name, blob.count(b"\nf "))
    parser = _Parser(name, os.path.dirname(path), sources)
    for number, (word, *rest) in _lines(blob):
        if progress and number % _LINES_A_WORD == 0:
            progress(f"{name}: line {number:,}")
        parser.line(word, rest, f"{name}:{number}")
    if not parser.faces:
        raise ToolError(f"{name}: there is no face in this file")
    vertices, faces, unused = without_unused(parser.vertices, parser.faces)
    notes = [f"{name}: right-handed and counter-clockwise, as OBJ is: z was negated and every "
             "outline reversed"]
    surfaces, more = parser.materials.result()
    if not surfaces and parser.materials.used:
        parser.ignored["usemtl"] = parser.materials.used
    if parser.ignored:
        notes.append(f"{name}: ignored " + ", ".join(f"{n} x {w}" for w, n in parser.ignored.items()))
    if unused:
        notes.append(f"{name}: left out vertices that no face has: {unused:,}")
    groups = parser.groups.result(len(faces))
    return Mesh(vertices, faces, parser.lines, surfaces, parser.materials.surfaces.uvs, groups), notes + more
