# SPDX-License-Identifier: MIT
"""Neighbours in one plane made into one convex face, where that is free: all corners lie exactly in one plane, and
every corner of the two faces stays a corner, so that the face covers the same pixels and its neighbours still share
whole edges with it."""

from fixel.image.image import FACE_VERTICES_MAX, Face
from fixel.base.vectors import cross, dot, minus
from fixel.model.mesh import newell, unit_normal


def _is_convex(outline, area):
    """Whether no corner turns inward, exactly."""
    return all(dot(cross(minus(b, a), minus(c, b)), area) >= 0 for a, b, c in
               zip(outline, outline[1:] + outline[:1], outline[2:] + outline[:2]))


def _joined(one, other, edge):
    """The outline of two faces without the edge from edge[0] to edge[1], which is one's; None where they touch at
    more than that edge."""
    start, end = one.index(edge[1]), other.index(edge[0])
    outline = one[start:] + one[:start] + (other[end:] + other[:end])[1:-1]
    return outline if len(set(outline)) == len(outline) else None


class _Merger:
    """The faces of a shape while they are merged."""

    def __init__(self, shape, kind_of):
        self.points = shape.vertices
        self.faces = {number: face.corners for number, face in enumerate(shape.faces)}
        self.sources = dict(enumerate(shape.sources))
        self.kinds = [kind_of(source) for source in shape.sources]
        self.into = {}      # a face that is gone: the one that has it
        self.areas = {number: newell([self.points[c] for c in corners]) for number, corners in self.faces.items()}

    def current(self, number):
        """The face that a face is part of now."""
        while number in self.into:
            number = self.into[number]
        return number

    def try_edge(self, first, second, edge):
        """Merges two faces that share an edge, if that is free."""
        one, other = self.current(first), self.current(second)
        if one == other or self.kinds[one] != self.kinds[other]:
            return
        corners, more = self.faces[one], self.faces[other]
        if len(corners) + len(more) - 2 > FACE_VERTICES_MAX:
            return
        area, anchor = self.areas[one], self.points[corners[0]]
        if dot(area, self.areas[other]) <= 0 or any(dot(area, minus(self.points[c], anchor)) for c in more):
            return
        outline = _joined(corners, more, edge)
        if outline is None or not _is_convex([self.points[c] for c in outline], area):
            return
        self.faces[one], self.areas[one] = outline, newell([self.points[c] for c in outline])
        self.into[other] = one
        del self.faces[other]


def coplanar(shape, kind_of, progress=None):
    """Merges faces of a shape in place; answers how many are gone. kind_of: of a source face, what the merged ones
    must have in common."""
    merger, edges = _Merger(shape, kind_of), {}
    for number, corners in merger.faces.items():
        for a, b in zip(corners, corners[1:] + corners[:1]):
            edges.setdefault((min(a, b), max(a, b)), []).append((number, a, b))
    for sharers in edges.values():
        if progress:
            progress("merging faces in one plane")
        if len(sharers) == 2 and sharers[0][1] == sharers[1][2]:
            (one, a, b), (other, *_) = sharers
            merger.try_edge(one, other, (a, b))
    gone = len(shape.faces) - len(merger.faces)
    kept = list(merger.faces)
    shape.faces = [Face(shape.faces[number].normal if len(shape.faces[number].corners) == len(merger.faces[number]) else
                        unit_normal(merger.areas[number]), merger.faces[number], 0) for number in kept]
    shape.sources = [merger.sources[number] for number in kept]
    return gone
