# SPDX-License-Identifier: MIT
"""Lines and points of a scene file's objects: edges of a mesh, polylines and points over it, and the faces on which they lie."""

import bisect
from dataclasses import replace
from typing import NamedTuple

from fixel.base.errors import ToolError
from fixel.base.vectors import cross, dot, minus
from fixel.image.image_models import PLANARITY_MAX
from fixel.model.mesh import FACES_MAX, Mesh, UNIT, transform
from fixel.model.quantity import sine_cosine

TESTS_MAX = 1 << 22     # of a segment against a face, in an object: a few seconds
REACH = 2 << 30         # how far outside its edge, times the edge's length, a point may lie that is on a face


class Wish(NamedTuple):
    """A line whose colour is still a wish: vertices and faces as those of image_lines.Line."""
    start: int
    end: int
    faces: tuple
    colour: tuple
    width: int


def wanted(table):
    """Whether an object has lines or points."""
    return any(key in table for key in ("edges", "lines", "points"))


def _edges(row, shape):
    """A line for each edge in which faces meet at the angle or more, and for each that one face has alone."""
    faces_of = {}
    for number, face in enumerate(shape.faces, 1):
        for i, corner in enumerate(face.corners):
            edge = tuple(sorted((face.corners[i - 1], corner)))
            faces_of.setdefault(edge, []).append(number)
    least = int(sine_cosine(row["angle"])[1] * (1 << 60))    # of the product of two normals of 2.30
    made = []
    for (start, end), faces in sorted(faces_of.items()):
        normals = [shape.faces[number - 1].normal for number in faces[:2]]
        if len(faces) == 1 or row["angle"] == 0 or dot(*normals) <= least:
            made.append(Wish(start, end, (*faces[:2], 0)[:2], row["colour"], row["width"]))
    return made


class _Faces:
    """The faces of a shape, to be asked which of them hold points."""

    def __init__(self, shape, where):
        self.shape, self.where, self.tests = shape, where, 0
        self.outlines = [[shape.vertices[corner] for corner in face.corners] for face in shape.faces]
        self.order = sorted(range(len(shape.faces)), key=lambda number: min(x for x, _, _ in self.outlines[number]))
        self.lows = [min(x for x, _, _ in self.outlines[number]) for number in self.order]

    def _holds(self, number, point):
        """Whether a point lies on a face, to within the planarity that a face's own vertices have."""
        normal, outline = self.shape.faces[number].normal, self.outlines[number]
        if abs(dot(normal, minus(point, outline[0]))) > PLANARITY_MAX << 30:
            return False
        for i, corner in enumerate(outline):
            before = outline[i - 1]
            edge = minus(corner, before)
            # As seen from the front the inside lies to the right of an edge.
            if dot(cross(edge, minus(point, before)), normal) < -max(map(abs, edge)) * REACH:
                return False
        return True

    def of(self, points):
        """The first two faces that hold all points, counted from 1, or 0."""
        found = []
        for number in self.order[:bisect.bisect_right(self.lows, min(x for x, _, _ in points) + PLANARITY_MAX)]:
            self.tests += 1
            if self.tests > TESTS_MAX:
                raise ToolError(f"{self.where}: to find the faces on which its lines lie takes more than {TESTS_MAX:,} tests: say "
                                "on_faces = false, or give fewer points or a model of fewer faces (simplify)")
            if all(self._holds(number, point) for point in points):
                found.append(number + 1)
        return (*sorted(found)[:2], 0, 0)[:2]


def _colours(row, count):
    if "colours" not in row:
        return [row["colour"]] * count
    row.refuse(("colour",), "colours are given; keep one")
    given = row["colours"]
    return [given[i % len(given)] for i in range(count)]


class _Maker:
    """Adds what the rows of an object ask for to a shape."""

    def __init__(self, shape, rows, origin, where):
        self.vertices, self.rows, self.origin = list(shape.vertices), rows, origin
        self.numbers = {vertex: number for number, vertex in reversed(list(enumerate(shape.vertices)))}
        self.faces, self.lines = _Faces(shape, where), []

    def _number(self, point):
        if point not in self.numbers:
            self.numbers[point] = len(self.vertices)
            self.vertices.append(point)
        return self.numbers[point]

    def _points(self, points):
        """The points of a row, turned and scaled as the mesh's."""
        exact = Mesh([minus([int(c * UNIT) for c in point], self.origin) for point in points], [])
        return transform(exact, self.rows)

    def _add(self, row, start, end, colour):
        faces = self.faces.of({start, end}) if row["on_faces"] else (0, 0)
        self.lines.append(Wish(self._number(start), self._number(end), faces, colour, row["width"]))

    def polyline(self, row):
        points = self._points(row["at"])
        if row["closed"]:
            points = [*points, points[0]]
        for start, end, colour in zip(points, points[1:], _colours(row, len(points) - 1)):
            if start == end:
                raise ToolError(f"{row.where}: two points that follow each other are the same, to within 1/65536 unit: leave one out, "
                                "the last where closed is true, or say points")
            self._add(row, start, end, colour)

    def points(self, row):
        points = self._points(row["at"])
        for point, colour in zip(points, _colours(row, len(points))):
            self._add(row, point, point, colour)


def with_lines(table, shape, rows, origin):
    """(the shape with the vertices of its lines, the lines as Wishes). rows: the matrix of the mesh's turn and scale; origin: the point of
    the mesh that it leaves in its place."""
    maker = _Maker(shape, rows, origin, table.where)
    if "edges" in table:
        maker.lines += _edges(table["edges"], shape)
    for row in table.rows("lines"):
        maker.polyline(row)
    for row in table.rows("points"):
        maker.points(row)
    if len(maker.vertices) > FACES_MAX:
        raise ToolError(f"{table.where}: its {len(shape.vertices):,} vertices and the points of its lines are more than the limit of {FACES_MAX:,}: "
                        "give fewer points or a model of fewer vertices (simplify)")
    made = replace(shape, vertices=maker.vertices)
    return made, tuple(maker.lines)
