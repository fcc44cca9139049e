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
import re

from fixel.model import creases, model_text, obj_materials
from fixel.base.errors import ToolError
from fixel.base.notes import Usual
from fixel.model.mesh import FILE_FACES_MAX, Mesh, UNIT, without_unused
from fixel.base.reading import quoted
from fixel.model.sources import Sources

FILE_MAX = 64 << 20         # bytes
CORNERS_MAX = 4096          # of a face, which is cut into triangles
COORDINATE_LIMIT = Decimal(10) ** 9
_SIZES = {"v": 3, "vt": 1, "vn": 3}
# What statements do that are not read.
_DISPLAY = {"usemap": "an image on the faces behind it: name it by map_Kd of a material", "maplib": "a list of the images of usemap",
            "mg": "merges surfaces of free form", "lod": "a level of detail: faces of all levels are read", "bevel": "light on edges as on bevelled ones",
            "c_interp": "blends the colours of materials over a face", "d_interp": "blends opacity over a face",
            "shadow_obj": "another file, which casts the shadow", "trace_obj": "another file, which mirrors show",
            "usemtl": "the material of the faces behind it: no MTL file was read", "call": "reads another file: put its text in the place",
            "csh": "runs a program"}
_FREE = "statements of curves and surfaces of free form"
_SHAPES = {"p": "points", "l": "lines", **dict.fromkeys(("vp", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv",
                                                         "sp", "end", "con", "bzp", "bsp", "cdc", "cdp", "res", "ctech", "stech"), _FREE)}
_PLAIN = re.compile(r"(-?)([0-9]{1,8})(?:\.([0-9]{1,18}))?")    # a number that needs no rounding
GROUPS_MAX = 8              # names of one g
_PLACES = 18                # of UNIT
_UV_MAX = 1e6               # images across
NORMAL_MIN, NORMAL_MAX = 1e-9, 1e9      # the largest component of a direction lies between them
_LINES_A_WORD = 4096        # lines between two words about the progress


def _coordinate(words, where):
    """u and v, v downward as in an image. What cannot be used is 0, 0."""
    try:
        u, v = model_text.decimal(words[0]), model_text.decimal(words[1]) if len(words) > 1 else 0.0
    except ValueError:
        raise ToolError(f"{where}: {quoted(' '.join(words[:2]))} is not a texture coordinate") from None
    return (u, 1 - v) if abs(u) <= _UV_MAX and abs(v) <= _UV_MAX else (0.0, 0.0)


def _vertex(words, where):
    """x, y, z in units of 1/UNIT, z negated."""
    point = []
    for word in words[:3]:
        plain = _PLAIN.fullmatch(word)
        if plain:
            sign, whole, part = plain.groups("")
            value = int(whole + part) * 10 ** (_PLACES - len(part))
            point.append(-value if sign else value)
            continue
        if not model_text.is_decimal(word):
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
    """An index, from 1 or negative from the end, as a number from 0. One of a vt or vn that does not exist is None."""
    try:
        index = model_text.whole(text)
    except ValueError:
        raise ToolError(f"{where}: {quoted(text)} is not an index") from None
    count = counts[kind]
    number = index - 1 if index > 0 else count + index
    if index == 0 or not 0 <= number < count:
        if kind != "v":
            return None
        raise ToolError(f"{where}: {kind} {quoted(index)} does not exist; {count} stand above this line")
    return number


def _normal(words):
    """x, y, z of a vn, z negated; None for what is no direction: it is no fault."""
    try:
        x, y, z = map(model_text.decimal, words[:3])
    except ValueError:
        return None
    return (x, y, -z) if NORMAL_MIN < max(map(abs, (x, y, z))) < NORMAL_MAX else None


def _corner(word, counts, where):
    """Numbers of a vertex, of a texture coordinate and of a normal, None without; and whether a vt is named that does not
    exist."""
    parts = word.split("/")
    if len(parts) > 3 or not parts[0]:
        raise ToolError(f"{where}: {quoted(word)} is not a corner (v, v/vt, v//vn or v/vt/vn)")
    more = [_index(text, counts, kind, where) if text else None for text, kind in zip(parts[1:], ("vt", "vn"))]
    coordinate, normal = (more + [None, None])[:2]
    return _index(parts[0], counts, "v", where), coordinate, normal, coordinate is None and bool(more) and bool(parts[1])


def _face(rest, counts, where):
    """(numbers of a face's vertices, in the order of Fixel; those of its texture coordinates, None if a corner has none;
    those of its normals, likewise; whether a texture coordinate does not exist)."""
    if len(rest) > CORNERS_MAX:
        raise ToolError(f"{where}: a face of {len(rest):,} corners; the limit is {CORNERS_MAX:,}, so cut it in "
                        "the model")
    plain = "".join(rest)
    if plain.isascii() and plain.isdigit() and len(plain) < 10 * len(rest):     # vertices alone, counted from 1: most files
        numbers = [int(text) - 1 for text in reversed(rest)]
        if 0 <= min(numbers) and max(numbers) < counts["v"]:
            return numbers, None, None, False
    vertices, coordinates, normals, missing = zip(*[_corner(text, counts, where) for text in reversed(rest)])
    return list(vertices), None if None in coordinates else coordinates, None if None in normals else normals, any(missing)


def _refuse_many_faces(name, count):
    if count > FILE_FACES_MAX:
        raise ToolError(f"{name}: at least {count:,} faces; the limit is {FILE_FACES_MAX:,} faces of a file, also for --simplify: give the "
                        "model fewer in another program first")


def _smoothing(words):
    """The smoothing group that an s names: a number or "on", creases.OFF, or None for what is neither."""
    word = words[0].lower() if words else ""
    return creases.OFF if word in ("off", "null") or word.isdigit() and not word.strip("0") else word.lstrip("0") if word.isdigit() or word == "on" else None


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

    def __init__(self, name, path, sources):
        self.name = name
        self.vertices, self.coordinates, self.faces, self.lines = [], [], [], []
        self.directions, self.normals = [], []      # of vn; of faces
        self.counts = {"v": 0, "vt": 0, "vn": 0}
        self.ignored, self.unknown, self.left_out = (model_text.LeftOut() for _ in range(3))
        self.smoothing, self.group = [], None       # of each face; of the next one
        self.materials, self.groups, self.colours = obj_materials.Materials(path, name, sources), _Groups(), obj_materials.Colours(name)

    def _add_face(self, rest, where):
        if len(rest) < 3:
            self.left_out.add("faces of fewer than three corners", where)
            return
        vertices, numbers, normals, bare = _face(rest, self.counts, where)
        found = normals and [self.directions[number] for number in normals]
        self.normals.append(None if found and None in found else found)
        self.faces.append(vertices)
        self.lines.append(where)
        self.smoothing.append(self.group)
        _refuse_many_faces(self.name, len(self.faces))
        self.materials.add(numbers and [self.coordinates[number] for number in numbers], bare)

    def _add_numbers(self, word, rest, where):
        if len(rest) < _SIZES[word]:
            raise ToolError(f"{where}: {word} needs {_SIZES[word]} numbers, found {len(rest)}")
        self.counts[word] += 1
        if word == "v":
            self.vertices.append(_vertex(rest, where))
            self.colours.add(rest[3:], where)
        elif word == "vt":
            self.coordinates.append(_coordinate(rest, where))
        else:
            self.directions.append(_normal(rest))

    def line(self, line, where):
        """A statement."""
        word, *rest = line.split("#", 1)[0].split() or [""]
        if word in _SIZES:
            self._add_numbers(word, rest, where)
        elif word in ("f", "fo"):
            self._add_face(rest, where)
        elif word == "mtllib":
            self.materials.library(model_text.words_of(line)[1:], where)
        elif word == "usemtl":
            self.materials.use(line.split()[1:], where)
        elif word == "s":
            self.group = _smoothing(rest)
        elif word in ("o", "g"):
            self.groups.begin(word, model_text.words_of(line)[1:], len(self.faces))
        elif word:
            (self.ignored if word in _DISPLAY else self.left_out if word in _SHAPES else self.unknown).add(_SHAPES.get(word, word), where)
        else:
            self.colours.comment(line)

    def _refuse_without_faces(self):
        there = list(self.left_out.counts) or ["vertices"] * bool(self.vertices)
        if self.unknown.counts or not there:
            raise ToolError(f"{self.name}: there is no face in this file" + ("; is this an OBJ file?" if self.unknown.counts else ""))
        raise ToolError(f"{self.name}: there is no face in this file, only {' and '.join(there)}: open it in Blender, make a mesh of faces "
                        "of it, and export it again")

    def result(self):
        """(mesh, notes) of the whole file."""
        name = self.name
        if not self.faces:
            self._refuse_without_faces()
        surfaces, more = self.materials.result()
        tints, said = self.colours.tint(surfaces, self.faces, self.materials.are_known)
        notes = [Usual(f"{name}: right-handed and counter-clockwise, as OBJ is: z was negated and every outline reversed"), *said]
        vertices, faces, unused = without_unused(self.vertices, self.faces)
        if not (self.materials.are_known or tints) and self.materials.used:
            self.ignored.counts["usemtl"] = self.materials.used
        notes += self.ignored.notes(name, "ignored", meanings=_DISPLAY) + self.left_out.notes(name, "left out") + \
            self.unknown.notes(name, "left out statements that are not known:")
        if unused:
            notes.append(f"{name}: left out vertices that no face has: {unused:,}")
        groups = self.groups.result(len(faces))
        return Mesh(vertices, faces, self.lines, surfaces if self.materials.are_known or tints else None, surfaces.uvs, groups,
                    self.normals if any(self.normals) else [], smoothing=self.smoothing if any(each is not None for each in self.smoothing) else []), \
            notes + more


def read(path, name=None, progress=None, sources=None):
    """(mesh, notes). The name stands in messages. sources: those of the scene."""
    name, sources = name or str(path), sources or Sources()
    blob = sources.read(path, FILE_MAX, "simplify the model")
    # Most files have a face a line: one with too many is refused before anything of it is parsed.
    _refuse_many_faces(name, blob.count(b"\nf "))
    parser = _Parser(name, path, sources)
    for number, line in model_text.statements(blob):
        if progress and number % _LINES_A_WORD == 0:
            progress(f"{name}: line {number:,}")
        parser.line(line, f"{name}:{number}")
    return parser.result()
