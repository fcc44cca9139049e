# SPDX-License-Identifier: MIT
"""Vertices of faces that lie on an edge of another face, and are none of its corners: T-junctions.

Rounding puts such a vertex a little off the edge, so that the background shows between the faces. The edge is split at
the vertex, so that both sides have the same corners."""

import numpy as np

from fixel.image.image import Face
from fixel.model import mesh

OFF_MAX = mesh.DENT_MAX     # 1/65536: how far off the edge rounding puts a vertex
EDGES_MAX = 1 << 14         # without a partner, among which vertices are looked for; a model with more is left as it is


def _open_edges(faces):
    """[(face, place of the edge's first corner)] of the edges without a partner."""
    balance = {}
    for face in faces:
        for a, b in zip(face.corners, face.corners[1:] + face.corners[:1]):
            balance[a, b] = balance.get((a, b), 0) + 1
            balance[b, a] = balance.get((b, a), 0) - 1
    return [(number, place) for number, face in enumerate(faces)
            for place, (a, b) in enumerate(zip(face.corners, face.corners[1:] + face.corners[:1])) if balance[a, b] > 0]


class _Near:
    """The vertices at the ends of open edges, by each axis."""

    def __init__(self, numbers, vertices):
        self.numbers = np.array(sorted(numbers))
        self.points = np.array([vertices[number] for number in self.numbers], dtype=float)
        self.orders = [np.argsort(self.points[:, axis], kind="stable") for axis in range(3)]
        self.sorted = [self.points[order, axis] for axis, order in enumerate(self.orders)]

    def between(self, one, other):
        """The vertices that lie on the way from one point to another, in order."""
        ends = [(np.searchsorted(values, min(a, b) - OFF_MAX), np.searchsorted(values, max(a, b) + OFF_MAX, "right"))
                for values, a, b in zip(self.sorted, one, other)]
        axis = min(range(3), key=lambda i: ends[i][1] - ends[i][0])
        some = self.orders[axis][ends[axis][0]:ends[axis][1]]
        way = np.array(other, dtype=float) - one
        square = way @ way
        apart = self.points[some] - one
        along = apart @ way / square
        off = np.cross(apart, way)
        margin = 2 * OFF_MAX / square ** 0.5    # an end of the edge itself, or what rounding made of it
        found = (along > margin) & (along < 1 - margin) & ((off * off).sum(axis=1) <= OFF_MAX * OFF_MAX * square)
        return [int(number) for _, number in sorted(zip(along[found].tolist(), self.numbers[some[found]].tolist()))]


def _split(face, inserted):
    """A face's corners with vertices behind some of them. inserted: {place of a corner: vertices}."""
    corners = []
    for place, corner in enumerate(face.corners):
        corners += [corner, *inserted.get(place, ())]
    return corners


def mend(shape, name):
    """Splits the edges of a shape on which vertices of other faces lie, and says so in its notes."""
    edges = _open_edges(shape.faces) if shape.open_edges else []
    if not edges or len(edges) > EDGES_MAX:
        return
    ends = {corner for number, place in edges for corners in [shape.faces[number].corners]
            for corner in (corners[place], corners[(place + 1) % len(corners)])}
    near, inserted, splits = _Near(ends, shape.vertices), {}, 0
    for number, place in edges:
        corners = shape.faces[number].corners
        a, b = corners[place], corners[(place + 1) % len(corners)]
        found = [each for each in near.between(shape.vertices[a], shape.vertices[b]) if each not in corners]
        if found:
            inserted.setdefault(number, {})[place] = found
            splits += 1
    if not inserted:
        return
    faces, sources = [], []
    for number, (face, source) in enumerate(zip(shape.faces, shape.sources)):
        made = [face] if number not in inserted else [
            Face(normal, outline, face.colour) for outline, normal in mesh.pieces(_split(face, inserted[number]), shape.vertices)]
        faces += made
        sources += [source] * len(made)
    shape.faces, shape.sources = faces, sources
    shape.open_edges = mesh.open_edges([face.corners for face in faces])
    shape.notes.append(f"{name}: {splits:,} edges had vertices of other faces on them (T-junctions), and were split there: else the "
                       "background may show between the faces")
