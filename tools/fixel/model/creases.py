# SPDX-License-Identifier: MIT
"""Which edges of a mesh do not show in smooth light (docs/scenes.md, "Edges that do not show").

A cylinder of 12 sides and a part with a chamfer both have edges that bend by 30 degrees. On the cylinder the surface bends on
by as much at the next edge; on the part a flat face ends there."""

import math

LIMIT = 40              # degrees: an edge that bends by more shows
ALWAYS = 20             # degrees: an edge that bends by no more does not show
PAIRS_MAX = 8           # faces of an edge that are all compared; of more each with the first
_FLAT = math.cos(math.radians(0.5))     # faces that bend by less are one flat face
_ALONG = 0.7            # the cosine between edges in one direction
_ALIKE = 2              # bends differ by this factor at most
_SLACK = 0.01           # degrees
_ROUNDING = 1e-6        # of a cosine
OFF = 0                 # the smoothing group of faces whose edges show


def _minus(one, other):
    return [a - b for a, b in zip(one, other)]


def _dot(one, other):
    return sum(a * b for a, b in zip(one, other))


def _pairs(outlines, sides):
    """(face, face, edge) of faces that share an edge. sides: of each face, which of two faces back to back it is."""
    edges = {}
    for number, (corners, side) in enumerate(zip(outlines, sides)):
        for a, b in zip(corners, (*corners[1:], corners[0])):
            edges.setdefault((a, b, side) if a < b else (b, a, side), []).append(number)
    for edge, faces in edges.items():
        for i, one in enumerate(faces[:-1] if len(faces) <= PAIRS_MAX else faces[:1]):
            for other in faces[i + 1:]:
                yield one, other, edge


class _Bends:
    """The edges about flat faces, which may be several faces of a mesh."""

    def __init__(self, points, outlines, units, pairs):
        self.points, self.outlines, self.units = points, outlines, units
        self.parents = list(range(len(outlines)))
        for one, other, _ in pairs:
            if _dot(units[one], units[other]) >= _FLAT:
                self.parents[self._root(one)] = self._root(other)
        self.sizes, self.about = {}, {}
        for number, corners in enumerate(outlines):
            root = self._root(number)
            self.sizes[root] = self.sizes.get(root, 0) + len(corners) - 2
        for one, other, edge in pairs:
            first, second = self._root(one), self._root(other)
            if first != second:
                way, bend = self._way(edge), self.bend(one, other, edge)
                self.about.setdefault(first, []).append((second, way, bend))
                self.about.setdefault(second, []).append((first, way, bend))

    def _root(self, number):
        while self.parents[number] != number:
            self.parents[number] = number = self.parents[self.parents[number]]
        return number

    def _way(self, edge):
        """The direction of an edge, of length 1."""
        way = _minus(self.points[edge[1]], self.points[edge[0]])
        length = math.sqrt(_dot(way, way)) or 1.0
        return [c / length for c in way]

    def bend(self, one, other, edge):
        """By how many degrees two faces bend at an edge: above 0 where they are convex there."""
        corners = self.outlines[other]
        middle = [sum(axis) / len(corners) for axis in zip(*(self.points[corner] for corner in corners))]
        angle = math.degrees(math.acos(max(-1.0, min(1.0, _dot(self.units[one], self.units[other])))))
        return math.copysign(angle, -_dot(self.units[one], _minus(middle, self.points[edge[0]])))

    def _along(self, root, beyond, way, bend):
        """Of a flat face, its edges in the direction of another one that bend the same way by about as much, with what lies beyond them."""
        return [(each, along, size) for each, along, size in self.about.get(root, ()) if each != beyond and size * bend > 0 and
                abs(bend) / _ALIKE <= abs(size) <= min(abs(bend) * _ALIKE, LIMIT + _SLACK) and abs(_dot(way, along)) >= _ALONG]

    def _is_round(self, root, beyond, way, bend):
        """Whether a surface bends on over a flat face: it is a lone triangle, all its edges bend the same way by at most LIMIT, or one goes on."""
        return self.sizes[root] == 1 or all(size * bend > 0 and abs(size) <= LIMIT + _SLACK for _, _, size in self.about.get(root, ())) or \
            bool(self._along(root, beyond, way, bend))

    def is_curve(self, one, other, edge):
        """Whether the surface bends on at both sides of an edge, or at one side over two faces."""
        first, second, way, bend = self._root(one), self._root(other), self._way(edge), self.bend(one, other, edge)
        are_round = [self._is_round(root, beyond, way, bend) for root, beyond in ((first, second), (second, first))]
        return all(are_round) or any(self._is_round(each, root, along, size) for root, beyond in ((first, second), (second, first))
                                     for each, along, size in self._along(root, beyond, way, bend))


def smooth_pairs(points, outlines, units, sides, degrees=None, groups=None):
    """{(face, face)}, the lower number first, of faces that meet at an edge that does not show. units: normals of length 1. sides: as those of
    _pairs. degrees: edges that bend by at most so many; None: by LIMIT and ALWAYS. groups: of each face its smoothing group, None where
    its file says nothing; where both of two faces have one, it decides alone."""
    found, open_ones = set(), []
    pairs = list(_pairs(outlines, sides))
    least, always = (math.cos(math.radians(each)) - _ROUNDING for each in ((LIMIT, ALWAYS) if degrees is None else (degrees, degrees)))
    for one, other, edge in pairs:
        if groups and OFF in (groups[one], groups[other]):
            continue
        if groups and groups[one] and groups[other]:
            if groups[one] == groups[other]:
                found.add((one, other))
            continue
        cosine = _dot(units[one], units[other])
        if cosine >= always:
            found.add((one, other))
        elif cosine >= least:
            open_ones.append((one, other, edge))
    if open_ones:
        bends = _Bends(points, outlines, units, pairs)
        for one, other, edge in open_ones:
            if bends.is_curve(one, other, edge):
                found.add((one, other))
    return found
