# SPDX-License-Identifier: MIT
"""Reading Wavefront OBJ: v, vt, vn and f in every index form.

OBJ is right-handed and its outlines run counter-clockwise; Fixel is
left-handed and clockwise. Negating z changes the handedness and leaves what is
seen from the front as it was: what looked along -z with x to the right now
looks along +z with x to the right. So an outline is still counter-clockwise,
and its corners are taken in reverse."""

from decimal import Decimal, InvalidOperation
import io

from fixel import reading
from fixel.errors import ToolError
from fixel.mesh import FACES_MAX, UNIT, Mesh
from fixel.reading import quoted

FILE_MAX = 64 << 20         # bytes
CORNERS_MAX = 4096          # of a face, which is cut into triangles
COORDINATE_LIMIT = Decimal(10) ** 9
_SIZES = {"v": 3, "vt": 1, "vn": 3}
_IGNORED = {"g", "o", "s", "usemtl", "mtllib", "usemap", "maplib", "l", "p", "vp", "cstype", "mg", "lod",
            "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj"}
_LINES_A_WORD = 4096        # lines between two words about the progress


def _vertex(words, where):
    """x, y, z in units of 1/UNIT, z negated. What follows (w, colour) is not needed."""
    point = []
    for word in words[:3]:
        try:
            value = Decimal(word)
        except InvalidOperation:
            raise ToolError(f"{where}: {quoted(word)} is not a number") from None
        # copy_abs: abs rounds, and fails where the exponent is larger than it can be after that.
        if not value.is_finite() or value.copy_abs() > COORDINATE_LIMIT:
            raise ToolError(f"{where}: coordinate {quoted(word)} is out of every range: it must be within "
                            f"{COORDINATE_LIMIT:,}")
        point.append(int((value * UNIT).to_integral_value()))
    return point[0], point[1], -point[2]


def _index(text, counts, kind, where):
    """An index, from 1 or negative from the end, as a number from 0."""
    try:
        index = int(text)
    except ValueError:
        raise ToolError(f"{where}: {quoted(text)} is not an index") from None
    count = counts[kind]
    number = index - 1 if index > 0 else count + index
    if index == 0 or not 0 <= number < count:
        raise ToolError(f"{where}: {kind} {quoted(index)} does not exist; {count} stand above this line")
    return number


def _corner(word, counts, where):
    parts = word.split("/")
    if len(parts) > 3 or not parts[0]:
        raise ToolError(f"{where}: {quoted(word)} is not a corner (v, v/vt, v//vn or v/vt/vn)")
    for text, kind in zip(parts[1:], ("vt", "vn")):
        if text:
            _index(text, counts, kind, where)
    return _index(parts[0], counts, "v", where)


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
    """The corners of a face, in the order of Fixel."""
    if len(rest) < 3:
        raise ToolError(f"{where}: a face needs three corners, found {len(rest)}")
    if len(rest) > CORNERS_MAX:
        raise ToolError(f"{where}: a face of {len(rest):,} corners; the limit is {CORNERS_MAX:,}, so cut it in "
                        "the model")
    return [_corner(text, counts, where) for text in reversed(rest)]


def _refuse_many_faces(name, count):
    if count > FACES_MAX:
        raise ToolError(f"{name}: more than {FACES_MAX:,} faces; a model has at most so many, so simplify it or "
                        "split it into several files")


def _without_unused(vertices, faces):
    """Only those vertices that faces use, and how many were dropped."""
    used = {corner for face in faces for corner in face}
    if len(used) == len(vertices):
        return vertices, faces, 0
    numbers = {old: new for new, old in enumerate(sorted(used))}
    return ([vertices[old] for old in numbers], [[numbers[corner] for corner in face] for face in faces],
            len(vertices) - len(used))


def _parse(blob, name, progress):
    """Vertices, faces, the line of each face, and how many statements of each kind were ignored."""
    vertices, faces, lines = [], [], []
    counts, ignored = {"v": 0, "vt": 0, "vn": 0}, {}
    for number, (word, *rest) in _lines(blob):
        where = f"{name}:{number}"
        if progress and number % _LINES_A_WORD == 0:
            progress(f"{name}: line {number:,}")
        if word in _SIZES:
            if len(rest) < _SIZES[word]:
                raise ToolError(f"{where}: {word} needs {_SIZES[word]} numbers, found {len(rest)}")
            counts[word] += 1
            if word == "v":
                vertices.append(_vertex(rest, where))
        elif word == "f":
            faces.append(_face(rest, counts, where))
            lines.append(where)
            _refuse_many_faces(name, len(faces))
        elif word in _IGNORED:
            ignored[word] = ignored.get(word, 0) + 1
        else:
            raise ToolError(f"{where}: unknown statement {quoted(word)}; is this an OBJ file?")
    return vertices, faces, lines, ignored


def read(path, name=None, progress=None):
    """(mesh, notes). The name stands in messages."""
    name = name or str(path)
    blob = reading.read_whole(path, FILE_MAX, "simplify the model")
    # Most files have a face a line: one with too many is refused before anything of it is parsed.
    _refuse_many_faces(name, blob.count(b"\nf "))
    vertices, faces, lines, ignored = _parse(blob, name, progress)
    if not faces:
        raise ToolError(f"{name}: there is no face in this file")
    vertices, faces, unused = _without_unused(vertices, faces)
    notes = [f"{name}: right-handed and counter-clockwise, as OBJ is: z was negated and every "
             "outline reversed"]
    if ignored:
        notes.append(f"{name}: ignored " + ", ".join(f"{n} x {w}" for w, n in ignored.items()))
    if unused:
        notes.append(f"{name}: left out vertices that no face has: {unused:,}")
    return Mesh(vertices, faces, lines), notes
