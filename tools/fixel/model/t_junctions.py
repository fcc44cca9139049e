# SPDX-License-Identifier: MIT
"""Vertices of faces that lie on an edge of another face, and are none of its corners: T-junctions.

Rounding puts such a vertex a little off the edge, so that the background shows between the faces. The edge is split at
the vertex, so that both sides have the same corners."""

import dataclasses

import numpy as np

from fixel.image.image import Face
from fixel.model import mesh

OFF_MIN = mesh.DENT_MAX     # 1/65536: how far off the edge rounding to 16.16 puts a vertex
OFF_PART = 1 << 16          # of the model's extent, as decimals of five digits do; farther off, many faces would no longer be flat
LONG_MAX = 1 << 14          # edges of many cells of the grid, among which vertices are looked for; a model with more is left as it is
PAIRS_MAX = 1 << 27         # of an edge and a vertex that is looked at: likewise
_CELLS_MAX = 64             # of the grid, that a short edge takes
_CELLS_ACROSS = 1 << 20     # of the grid: so the number of a cell is an integer of 64 bits
_AT_A_TIME = 1 << 20        # pairs


def _open_edges(outlines):
    """[(face, place of the edge's first corner)] of the edges without a partner."""
    balance = {}
    for corners in outlines:
        for a, b in zip(corners, corners[1:] + corners[:1]):
            balance[a, b] = balance.get((a, b), 0) + 1
            balance[b, a] = balance.get((b, a), 0) - 1
    return [(number, place) for number, corners in enumerate(outlines)
            for place, (a, b) in enumerate(zip(corners, corners[1:] + corners[:1])) if balance[a, b] > 0]


class _Near:
    """The vertices at the ends of open edges, by each axis and by the cells of a grid."""

    def __init__(self, numbers, vertices, off):
        self.numbers, self.off = np.array(sorted(numbers)), off
        self.points = np.array([vertices[number] for number in self.numbers], dtype=float)
        self.orders = [np.argsort(self.points[:, axis], kind="stable") for axis in range(3)]
        self.sorted = [self.points[order, axis] for axis, order in enumerate(self.orders)]
        self.origin = self.points.min(axis=0)

    def _on(self, starts, ends, points):
        """(where along each edge its point lies, 0..1; whether it lies on the edge and is none of its ends)."""
        way, apart = ends - starts, points - starts
        square = (way * way).sum(axis=1)
        along = (apart * way).sum(axis=1) / square
        across = np.cross(apart, way)
        margin = 2 * self.off / np.sqrt(square)     # an end of the edge itself, or what rounding made of it
        return along, (along > margin) & (along < 1 - margin) & ((across * across).sum(axis=1) <= self.off * self.off * square)

    def _of_long(self, one, other):
        """Places of the vertices that may lie on one edge: those of the axis that has fewest beside it."""
        ends = [(np.searchsorted(values, min(a, b) - self.off), np.searchsorted(values, max(a, b) + self.off, "right"))
                for values, a, b in zip(self.sorted, one, other)]
        axis = min(range(3), key=lambda i: ends[i][1] - ends[i][0])
        return self.orders[axis][ends[axis][0]:ends[axis][1]]

    def _cells(self, points, size):
        return np.floor((points - self.origin) / size).astype(np.int64) + 1     # from 0, as edges reach off beyond the points

    def _of_short(self, low, high, size):
        """Pairs of an edge and a vertex in a cell of its box, in parts: (numbers of edges, places of vertices)."""
        def keys(cells):
            return (cells[:, 0] * across[1] + cells[:, 1]) * across[2] + cells[:, 2]
        first, last = self._cells(low, size), self._cells(high, size)
        across = np.maximum(last.max(axis=0), self._cells(self.points, size).max(axis=0)) + 2
        of_points = keys(self._cells(self.points, size))
        order = np.argsort(of_points, kind="stable")
        in_order, spans = of_points[order], last - first + 1
        counts = spans.prod(axis=1)
        edges = np.repeat(np.arange(len(low)), counts)
        step = np.arange(len(edges)) - np.repeat(np.cumsum(counts) - counts, counts)
        wide = spans[edges]
        cells = first[edges] + np.column_stack([step // (wide[:, 1] * wide[:, 2]), step // wide[:, 2] % wide[:, 1], step % wide[:, 2]])
        begins, ends = (np.searchsorted(in_order, keys(cells), side) for side in ("left", "right"))
        there = np.flatnonzero(ends > begins)
        edges, begins, counts = edges[there], begins[there], (ends - begins)[there]
        sums = np.cumsum(counts)
        if len(sums) and sums[-1] > PAIRS_MAX:
            raise _TooMany
        at = 0
        while at < len(sums):
            until = max(at + 1, int(np.searchsorted(sums, (sums[at - 1] if at else 0) + _AT_A_TIME, "right")))
            some = counts[at:until]
            inside = np.arange(some.sum()) - np.repeat(np.cumsum(some) - some, some)
            yield np.repeat(edges[at:until], some), order[np.repeat(begins[at:until], some) + inside]
            at = until

    def found(self, starts, ends):
        """{number of an edge: the vertices that lie on it, in order}. starts, ends: arrays of points."""
        low, high = np.minimum(starts, ends) - self.off, np.maximum(starts, ends) + self.off
        sides = (high - low).max(axis=1)
        size = max(np.median(sides), sides.max() / _CELLS_ACROSS, np.ptp(self.points, axis=0).max() / _CELLS_ACROSS)
        is_short = (self._cells(high, size) - self._cells(low, size) + 1).prod(axis=1) <= _CELLS_MAX
        short, long = np.flatnonzero(is_short), np.flatnonzero(~is_short)
        if len(long) > LONG_MAX:
            raise _TooMany
        result = {}
        for edges, places in self._of_short(low[short], high[short], size) if len(short) else ():
            self._add(result, starts, ends, short[edges], places)
        for edge in long:
            places = self._of_long(starts[edge], ends[edge])
            self._add(result, starts, ends, np.full(len(places), edge), places)
        return {edge: [number for _, number in sorted(each)] for edge, each in result.items()}

    def _add(self, result, starts, ends, edges, places):
        """Adds to the result what lies on edges of pairs."""
        along, found = self._on(starts[edges], ends[edges], self.points[places])
        for edge, where, place in zip(edges[found].tolist(), along[found].tolist(), places[found].tolist()):
            result.setdefault(edge, set()).add((where, int(self.numbers[place])))


class _TooMany(Exception):
    """There are more edges or vertices than are looked at."""


def _split(corners, inserted):
    """What a face's corners have, with more behind some of them. inserted: {place of a corner: what those behind it have}."""
    return [each for place, corner in enumerate(corners) for each in (corner, *inserted.get(place, ()))]


def _inserted(outlines, vertices, edges):
    """{number of a face: {place of a corner: the vertices that lie on the edge behind it}}."""
    extent, corners = max(max(axis) - min(axis) for axis in zip(*vertices)), [outlines[number] for number, _ in edges]
    pairs = [(each[place], each[(place + 1) % len(each)]) for (_, place), each in zip(edges, corners)]
    near = _Near({corner for pair in pairs for corner in pair}, vertices, max(OFF_MIN, extent // OFF_PART))
    found, inserted = near.found(*(np.array([vertices[corner] for corner in side], dtype=float) for side in zip(*pairs))), {}
    for edge in sorted(found):
        number, place = edges[edge]
        kept = [corner for corner in found[edge] if corner not in corners[edge]]
        if kept:
            inserted.setdefault(number, {})[place] = kept
    return inserted


def mend(shape, name):
    """Splits the edges of a shape on which vertices of other faces lie, and says so in its notes."""
    outlines = [face.corners for face in shape.faces]
    edges = _open_edges(outlines) if shape.open_edges else []
    if not edges:
        return
    try:
        inserted = _inserted(outlines, shape.vertices, edges)
    except _TooMany:
        shape.notes.append(f"{name}: {len(edges):,} edges have no partner, too many to look for vertices of other faces on them (T-junctions): the "
                           "background may show between the faces; weld the vertices in the model, or split it")
        return
    if not inserted:
        return
    splits = sum(map(len, inserted.values()))
    faces, sources = [], []
    for number, (face, source) in enumerate(zip(shape.faces, shape.sources)):
        made = [face] if number not in inserted else [
            Face(normal, outline, face.colour) for outline, normal in mesh.pieces(_split(face.corners, inserted[number]), shape.vertices)]
        faces += made
        sources += [source] * len(made)
    shape.faces, shape.sources = faces, sources
    shape.open_edges = mesh.open_edges([face.corners for face in faces])
    shape.notes.append(f"{name}: {splits:,} edges had vertices of other faces on them (T-junctions), and were split there: else the "
                       "background may show between the faces")


def _coordinates(own, corners, inserted, vertices):
    """The texture coordinates of a face's corners, and of vertices on its edges, which lie between them."""
    more = {}
    for place, numbers in inserted.items():
        other = (place + 1) % len(corners)
        start, end = (np.array(vertices[corners[i]], dtype=float) for i in (place, other))
        parts = [float((vertices[number] - start) @ (end - start) / ((end - start) @ (end - start))) for number in numbers]
        more[place] = [tuple(float(a) + part * (float(b) - float(a)) for a, b in zip(own[place], own[other])) for part in parts]
    return _split(own, more)


def split(whole, vertex_of):
    """A Mesh of which faces have corners where vertices of others lie on their edges, so that both sides of an edge are simplified
    alike. vertex_of: of each vertex the first one at its place."""
    outlines = [[int(vertex_of[corner]) for corner in face] for face in whole.faces]
    edges = _open_edges(outlines)
    try:
        inserted = _inserted(outlines, whole.vertices, edges) if edges else {}
    except _TooMany:
        return whole
    if not inserted:
        return whole
    faces, uvs = list(whole.faces), list((whole.surfaces.uvs if whole.surfaces else whole.uvs) or [None] * len(whole.faces))
    for number, own in inserted.items():
        uvs[number] = uvs[number] and _coordinates(uvs[number], faces[number], own, whole.vertices)
        faces[number] = _split(faces[number], own)
    return dataclasses.replace(whole, faces=faces, uvs=whole.uvs and uvs,
                               surfaces=whole.surfaces and dataclasses.replace(whole.surfaces, uvs=uvs))
