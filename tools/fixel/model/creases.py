# SPDX-License-Identifier: MIT
"""Which edges of a mesh do not show in smooth light (docs/scenes.md, "Edges that do not show").

A cylinder of 12 sides and a part with a chamfer both have edges that bend by 30 degrees. On the cylinder the surface bends on
by as much at the next edge; on the part a flat face ends there."""

import bisect
import math

from fixel.base.vectors import dot, minus

LIMIT = 40              # degrees: an edge that bends by more shows
ALWAYS = 20             # degrees: an edge that bends by no more does not show
PAIRS_MAX = 8           # faces of an edge that are all compared; of more each with the first
_FLAT = math.cos(math.radians(0.5))     # faces that bend by less are one flat face
_ALONG = 0.7            # the cosine between edges in one direction
_ALIKE = 2              # bends differ by this factor at most
_SLACK = 0.01           # degrees
_ROUNDING = 1e-6        # of a cosine
OFF = 0                 # the smoothing group of faces whose edges show


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


def _bend_of(edge):
    return edge[0]


class _Bends:
    """The edges about flat faces, which may be several faces of a mesh."""

    def __init__(self, points, outlines, units, pairs):
        self.points, self.outlines, self.units = points, outlines, units
        self.parents = list(range(len(outlines)))
        for one, other, _ in pairs:
            if dot(units[one], units[other]) >= _FLAT:
                self.parents[self._root(one)] = self._root(other)
        self.sizes, self.about, self.ends, self.rounds, self.looked = {}, {}, {}, {}, 0     # looked: edges beside another one that were looked at
        for number, corners in enumerate(outlines):
            root = self._root(number)
            self.sizes[root] = self.sizes.get(root, 0) + len(corners) - 2
        for one, other, edge in pairs:
            first, second = self._root(one), self._root(other)
            if first != second:
                way, bend = self._way(edge), self.bend(one, other, edge)
                self.about.setdefault(first, {}).setdefault(second, []).append((bend, way))
                self.about.setdefault(second, {}).setdefault(first, []).append((bend, way))
        for others in self.about.values():
            for edges in others.values():
                edges.sort(key=_bend_of)

    def _root(self, number):
        while self.parents[number] != number:
            self.parents[number] = number = self.parents[self.parents[number]]
        return number

    def _way(self, edge):
        """The direction of an edge, of length 1."""
        way = minus(self.points[edge[1]], self.points[edge[0]])
        length = math.sqrt(dot(way, way)) or 1.0
        return [c / length for c in way]

    def bend(self, one, other, edge):
        """By how many degrees two faces bend at an edge: above 0 where they are convex there."""
        corners = self.outlines[other]
        middle = [sum(axis) / len(corners) for axis in zip(*(self.points[corner] for corner in corners))]
        angle = math.degrees(math.acos(max(-1.0, min(1.0, dot(self.units[one], self.units[other])))))
        return math.copysign(angle, -dot(self.units[one], minus(middle, self.points[edge[0]])))

    def _goes_on(self, others, beyond, way, bend):
        """Whether one of the edges of a flat face, {what lies beyond: its edges}, goes in the direction of another one and bends the same
        way by about as much."""
        least, most = abs(bend) / _ALIKE, min(abs(bend) * _ALIKE, LIMIT + _SLACK)
        low, high = (least, most) if bend > 0 else (-most, -least)
        for each, edges in others.items():
            self.looked += 1
            if each == beyond or bend == 0:
                continue
            for size, along in edges[bisect.bisect_left(edges, low, key=_bend_of):bisect.bisect_right(edges, high, key=_bend_of)]:
                self.looked += 1
                if abs(dot(way, along)) >= _ALONG:
                    return True
        return False

    def _all_bend_so(self, root, bend):
        """Whether all edges of a flat face bend the same way as another one by at most LIMIT: of a face with many edges it is asked often."""
        if root not in self.ends:
            sides = self.about.get(root, {}).values()
            self.ends[root] = (min(edges[0][0] for edges in sides), max(edges[-1][0] for edges in sides)) if sides else None
        if self.ends[root] is None:
            return True
        least, most = self.ends[root]
        return least * bend > 0 and most * bend > 0 and max(abs(least), abs(most)) <= LIMIT + _SLACK

    def _is_round(self, root, beyond, way, bend):
        """Whether a surface bends on over a flat face: it is a lone triangle, all its edges bend the same way by at most LIMIT, or one goes on."""
        return self.sizes[root] == 1 or self._all_bend_so(root, bend) or self._goes_on(self.about.get(root, {}), beyond, way, bend)

    def _round_edges(self, root):
        """{what lies beyond: the edges} of a flat face beyond which the surface bends on."""
        if root not in self.rounds:
            found = {each: [(size, along) for size, along in edges if self._is_round(each, root, along, size)]
                     for each, edges in self.about.get(root, {}).items()}
            self.rounds[root] = {each: edges for each, edges in found.items() if edges}
        return self.rounds[root]

    def is_curve(self, one, other, edge):
        """Whether the surface bends on at both sides of an edge, or at one side over two faces."""
        first, second, way, bend = self._root(one), self._root(other), self._way(edge), self.bend(one, other, edge)
        sides = (first, second), (second, first)
        return all(self._is_round(root, beyond, way, bend) for root, beyond in sides) or \
            any(self._goes_on(self._round_edges(root), beyond, way, bend) for root, beyond in sides)


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
        cosine = dot(units[one], units[other])
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
