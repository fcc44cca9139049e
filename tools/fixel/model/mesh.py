# SPDX-License-Identifier: MIT
"""Meshes: turned, scaled, rounded to 16.16, and cut into faces that the
library takes: flat, convex, of 3 to 24 vertices, with exact normals. Neighbours that disagree about the front are turned until they agree.

Everything is done in integers on the rounded vertices, so that what is decided
here holds for the numbers that the library sees."""

import collections
from dataclasses import dataclass, field, replace
from functools import cached_property
from math import isqrt, lcm

from fixel.base.errors import ToolError
from fixel.base.vectors import cross, dot, minus
from fixel.image.image import COORDINATE_MAX, FACE_VERTICES_MAX, Face, PLANARITY_MAX
from fixel.model.triangles import triangulate

FACES_MAX = 65535       # of a model
FACES_A_WORD = 256      # between two words about the progress
FILE_FACES_MAX = 1 << 20    # of a file: more than a scene image has room for

# A mesh's coordinates are integers in 1/UNIT: decimals of OBJ files stay exact.
UNIT = 10 ** 18

# How far, in 1/65536, a corner of a polygon may fall inside the line of its
# neighbours: what rounding can do to corners on one line.
DENT_MAX = 2


@dataclass
class Mesh:
    """What a file or a solid gives: outlines clockwise as seen from the front."""
    vertices: list
    faces: list
    places: list = field(default_factory=list)  # where each face stands, for messages
    surfaces: object = None     # a surface.Surfaces; None: the file says nothing of colours
    uvs: list = field(default_factory=list)     # as those of surface.Surfaces, where there is none
    groups: dict = field(default_factory=dict)  # {name: [(first face, behind the last)]}
    normals: list = field(default_factory=list)     # for each face those of its corners, or None; [] where the file has none
    scenery: object = None      # a nodes.Scenery of a file that has nodes
    smoothing: list = field(default_factory=list)   # for each face its smoothing group, creases.OFF or None; [] where the file has none
    unread: list = field(default_factory=list)      # what is wrong with each image of the file that cannot be read

    @cached_property
    def extent(self):
        """The length of the longest side of the box about its vertices."""
        return max(max(axis) - min(axis) for axis in zip(*self.vertices))

    @cached_property
    def middle(self):
        """The middle of the box about its vertices; that of none is the origin."""
        return tuple((min(axis) + max(axis)) // 2 for axis in zip(*self.vertices or [(0, 0, 0)]))

    def numbers_of(self, groups, without=()):
        """The numbers of the faces of some groups, of all faces where none is named, but for those of other groups."""
        def of(names):
            return {number for name in names for first, end in self.groups.get(name, ()) for number in range(first, end)}
        return sorted((of(groups) if groups else set(range(len(self.faces)))) - of(without))

    def part(self, *groups, without=()):
        """The mesh of the faces of some groups: see numbers_of."""
        numbers = self.numbers_of(groups, without)
        vertices, faces, _ = without_unused(self.vertices, [self.faces[number] for number in numbers])
        return Mesh(vertices, faces, [self.places[number] for number in numbers],
                    self.surfaces and self.surfaces.part(numbers, self.scenery is not None),
                    [self.uvs[number] for number in numbers] if self.uvs else [],
                    normals=[self.normals[number] for number in numbers] if self.normals else [], scenery=self.scenery,
                    smoothing=[self.smoothing[number] for number in numbers] if self.smoothing else [], unread=self.unread)


def without_unused(vertices, faces):
    """Only those vertices that faces use, and how many were dropped."""
    used = {corner for face in faces for corner in face}
    if len(used) == len(vertices):
        return vertices, faces, 0
    numbers = {old: new for new, old in enumerate(sorted(used))}
    return ([vertices[old] for old in numbers], [[numbers[corner] for corner in face] for face in faces],
            len(vertices) - len(used))


@dataclass
class Shape:
    """A mesh as the library takes it. sources[i] is the number of the mesh's
    face that face i came from; middle is the middle of the bounding box."""
    vertices: list
    faces: list
    sources: list
    notes: list
    middle: tuple = (0, 0, 0)
    half_height: int = 0
    open_edges: int = 0
    normals: list = None    # for each face those of its corners in 2.30, or None; None: they are not known
    smoothing: list = None  # for each face its smoothing group, as those of Mesh; None: there are none


def newell(points):
    """Twice the area, along the normal that points to the front: exact."""
    x, y, z = points[0]
    one, two, three = points[1]
    one, two, three = one - x, two - y, three - z
    u = v = w = 0
    # One loop without calls: every face comes here several times.
    for a, b, c in points[2:]:
        a, b, c = a - x, b - y, c - z
        u, v, w = u + two * c - three * b, v + three * a - one * c, w + one * b - two * a
        one, two, three = a, b, c
    return u, v, w


def unit_normal(area):
    """An integer vector at unit length in 2.30, each component to nearest."""
    x, y, z = area
    square = x * x + y * y + z * z
    # Two more bits than needed, so that one rounding remains. Written out: every face comes here.
    u = (isqrt((x * x << 64) // square) + 2) >> 2
    v = (isqrt((y * y << 64) // square) + 2) >> 2
    w = (isqrt((z * z << 64) // square) + 2) >> 2
    return (u if x >= 0 else -u, v if y >= 0 else -v, w if z >= 0 else -w)


def transform(mesh, matrix):
    """The mesh's vertices times a 3x3 matrix of Fractions, as 16.16."""
    common = lcm(*(entry.denominator for row in matrix for entry in row))
    rows = [[int(entry * common) << 17 for entry in row] for row in matrix]
    half = common * UNIT
    whole = 2 * half
    return [tuple((r[0] * x + r[1] * y + r[2] * z + half) // whole for r in rows)
            for x, y, z in mesh.vertices]


def rounding_error(mesh, matrix):
    """The farthest that transform moves a coordinate, in units of 1/65536: a float of 0..1/2."""
    common = lcm(*(entry.denominator for row in matrix for entry in row))
    rows = [[int(entry * common) << 16 for entry in row] for row in matrix]
    whole = common * UNIT
    worst = max(min(left, whole - left) for r in rows for x, y, z in mesh.vertices
                for left in [(r[0] * x + r[1] * y + r[2] * z) % whole])
    return worst / whole


def _merge(points):
    """Distinct points, and for each old number the new one."""
    numbers = {}
    renamed = [numbers.setdefault(point, len(numbers)) for point in points]
    return list(numbers), renamed


def _outline(corners):
    """Corners without those that repeat the one before."""
    return [c for i, c in enumerate(corners) if c != corners[i - 1]]


def is_flat(points, normal):
    first = points[0]
    return all(abs(dot(normal, minus(p, first))) <= PLANARITY_MAX << 30 for p in points)


def is_convex_outline(points, area):
    """Whether every corner lies on the inner side of every edge's line, but
    for DENT_MAX."""
    if len(points) == 4 and all(dot(cross(minus(b, a), minus(c, b)), area) >= 0 for a, b, c in
                                zip(points, points[1:] + points[:1], points[2:] + points[:2])):
        return True     # of four corners no edge has others than its neighbours
    square = dot(area, area)
    for i, b in enumerate(points):
        edge = minus(b, points[i - 1])
        limit = DENT_MAX * DENT_MAX * dot(edge, edge) * square
        for p in points:
            side = dot(cross(edge, minus(p, b)), area)
            if side < 0 and side * side > limit:
                return False
    return True


class _Counts:
    """What happened to faces, told as one note a kind."""

    def __init__(self):
        self.found = {}

    def add(self, text, place):
        number, first = self.found.get(text, (0, place))
        self.found[text] = number + 1, first

    def notes(self, name):
        return [f"{name}: {number} face{'s' if number > 1 else ''} {text}"
                + (f" (first: {place})" if place else "")
                for text, (number, place) in self.found.items()]


def _pieces(corners, points, place, counts):
    """A face of the mesh as pairs (corners, normal) that the library takes."""
    if len(corners) == 3 and len(set(corners)) == 3:    # most faces of most files
        area = newell([points[c] for c in corners])
        if area != (0, 0, 0):
            return [(tuple(corners), unit_normal(area))]
    corners = _outline(corners)
    if len(corners) < 3:
        counts.add("without area dropped", place)
        return []
    outline = [points[c] for c in corners]
    area = newell(outline)
    if area == (0, 0, 0):
        counts.add("without area dropped", place)
        return []
    normal = unit_normal(area)
    if len(corners) == 3:
        return [(tuple(corners), normal)]
    if len(corners) > FACE_VERTICES_MAX:
        counts.add(f"of more than {FACE_VERTICES_MAX} vertices triangulated", place)
    elif len(set(corners)) < len(corners) or not is_convex_outline(outline, area):
        counts.add("with concave outlines triangulated", place)
    elif not is_flat(outline, normal):
        counts.add("that are not flat triangulated", place)
    else:
        return [(tuple(corners), normal)]
    triangles, sound = triangulate(corners, points, area)
    if not sound:
        counts.add("whose outlines cross themselves cut into fans", place)
    pieces = [(t, newell([points[c] for c in t])) for t in triangles]
    return [(t, unit_normal(a)) for t, a in pieces if a != (0, 0, 0)]


def pieces(corners, points):
    """Corners of an outline as pairs (corners, normal) that the library takes."""
    return _pieces(corners, points, "", _Counts())


def open_edges(outlines):
    """How many edges are not shared by two faces that agree on the front. outlines: the corners of each face."""
    balance = collections.Counter([edge for corners in outlines for edge in zip(corners, corners[1:] + corners[:1])])
    # Of an edge that runs as often one way as the other, none is left. One without a partner stands there once.
    return sum(1 for (a, b), times in balance.items() if times != balance.get((b, a), 0) and (a < b or (b, a) not in balance))


def _volume(vertices, faces):
    """Six times the volume within; positive where fronts look outward."""
    return sum(dot(vertices[face.corners[0]], newell([vertices[c] for c in face.corners]))
               for face in faces)


def turned(face):
    """A face that looks the other way."""
    return Face(tuple(-n for n in face.normal), face.corners[::-1], face.colour)


def two_sided(made, wanted=None):
    """The shape with each face once more, seen from behind; or only those faces that came from these of the mesh."""
    numbers = [number for number, source in enumerate(made.sources) if wanted is None or source in wanted]
    return replace(made, faces=made.faces + [turned(made.faces[number]) for number in numbers],
                   sources=made.sources + [made.sources[number] for number in numbers])


def _check_size(points, name):
    """Refuses what no place in the world has room for."""
    ends = [(min(axis), max(axis)) for axis in zip(*points)]
    if all(-2 * COORDINATE_MAX <= low and high <= 2 * COORDINATE_MAX for low, high in ends):
        return
    if all(high - low <= 2 * COORDINATE_MAX for low, high in ends):
        far = max(max(-low, high) for low, high in ends) / 65536
        raise ToolError(f"{name}: the model lies up to {far:.6g} units from its own origin, more than twice the world "
                        "(-8191..8191): move it to the origin in the model, or make scale smaller")
    raise ToolError(f"{name}: with this scale the model is larger than the world "
                    "(-8191..8191); make scale smaller")


def _mend(result, name):
    """Turns faces that disagree with their neighbours about the front."""
    wrong = faces_to_turn(result.faces)
    if wrong:
        result.faces = [turned(face) if number in wrong else face for number, face in enumerate(result.faces)]
        result.notes.append(f"{name}: {len(wrong):,} faces were turned round: they faced the other way than their "
                            "neighbours")


def shape(mesh, matrix, name, inside=False, progress=None, mends=False):
    """The mesh, transformed, as the library takes it; vertices still relative
    to the mesh's origin. inside: turn every face inward. mends: turn faces that
    disagree with their neighbours first."""
    points, renamed = _merge(transform(mesh, matrix))
    _check_size(points, name)
    counts, faces, sources = _Counts(), [], []
    for number, corners in enumerate(mesh.faces):
        if progress and number % FACES_A_WORD == 0:
            progress(f"{name}: face {number} of {len(mesh.faces)}")
        place = mesh.places[number] if mesh.places else ""
        for outline, normal in _pieces([renamed[c] for c in corners], points, place, counts):
            faces.append(Face(normal, outline, 0))
            sources.append(number)
        if len(faces) > FILE_FACES_MAX:
            raise ToolError(f"{place or name}: the model has more than {FILE_FACES_MAX:,} faces with those that its faces "
                            "are cut into; simplify it or split it into several files")
    if mesh.faces and not faces:
        raise ToolError(f"{name}: no face with any area is left; is scale too small?")
    result = _used(points, faces, sources, counts.notes(name))
    if mends:
        _mend(result, name)
    result.open_edges = open_edges([face.corners for face in result.faces])
    if not result.open_edges and _volume(result.vertices, result.faces) < 0:
        result.faces = [turned(face) for face in result.faces]
        result.notes.append(f"{name}: the model was inside out (every front looked inward): "
                            "its faces were turned round")
    if inside:
        result.faces = [turned(face) for face in result.faces]
    return result


def _used(points, faces, sources, notes):
    """The shape with only those vertices that faces use."""
    order = {}
    for face in faces:
        face.corners = tuple([order.setdefault(c, len(order)) for c in face.corners])
    vertices = [points[c] for c in order]
    low = [min(axis) for axis in zip(*vertices or [(0, 0, 0)])]
    high = [max(axis) for axis in zip(*vertices or [(0, 0, 0)])]
    middle = tuple((a + b) // 2 for a, b in zip(low, high))
    return Shape(vertices, faces, sources, notes, middle, middle[1] - low[1])


def _edges(faces):
    """{(low, high): [(face, whether it runs from low to high)]}."""
    found = {}
    for number, face in enumerate(faces):
        for a, b in zip(face.corners, face.corners[1:] + face.corners[:1]):
            found.setdefault((min(a, b), max(a, b)), []).append((number, a < b))
    return found


def _agree(faces):
    """Whether no two faces run along an edge in the same direction."""
    ways = [way for face in faces for way in zip(face.corners, face.corners[1:] + face.corners[:1])]
    return len(set(ways)) == len(ways)


def faces_to_turn(faces):
    """Numbers of the faces to be turned round so that all neighbours agree; a set. Neighbours are two faces that
    share an edge no third face has. Of each connected part the smaller half is turned. A part that cannot agree, such
    as a Moebius band, is left as it is."""
    if _agree(faces):
        return set()
    pairs = {}
    for both in _edges(faces).values():
        if len(both) == 2 and both[0][0] != both[1][0]:
            (one, up), (other, down) = both
            pairs.setdefault(one, []).append((other, up == down))
            pairs.setdefault(other, []).append((one, up == down))
    turned, result = {}, set()
    for start in range(len(faces)):
        if start in turned:
            continue
        turned[start], part, sound = False, [start], True
        for number in part:
            for neighbour, differs in pairs.get(number, []):
                wanted = turned[number] != differs
                if neighbour not in turned:
                    turned[neighbour] = wanted
                    part.append(neighbour)
                sound = sound and turned[neighbour] == wanted
        chosen = [number for number in part if turned[number]]
        if 2 * len(chosen) > len(part):
            chosen = [number for number in part if not turned[number]]
        if sound:
            result.update(chosen)
    return result
