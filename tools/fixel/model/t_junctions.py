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
PAIRS_MAX = 1 << 25         # of an edge and a vertex that is looked at; a model with more is left as it is
SPLITS_MAX = 1 << 20        # vertices on edges of faces: likewise
_PAIRS_EACH = 64            # for an edge or a vertex, from which the grid is too coarse and the vertices are halved instead
_LEAF = 8                   # vertices that are halved no more
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
        self.origin, self.looked, self.hits = self.points.min(axis=0), 0, 0     # pairs, and edges at boxes, that were looked at; vertices on edges

    def _on(self, starts, ends, points):
        """(where along each edge its point lies, 0..1; whether it lies on the edge and is none of its ends)."""
        way, apart = ends - starts, points - starts
        square = (way * way).sum(axis=1)
        along = (apart * way).sum(axis=1) / square
        across = np.cross(apart, way)
        margin = 2 * self.off / np.sqrt(square)     # an end of the edge itself, or what rounding made of it
        return along, (along > margin) & (along < 1 - margin) & ((across * across).sum(axis=1) <= self.off * self.off * square)

    def _beside(self, low, high):
        """(the axis along which an edge has fewest vertices beside it, the first and the one behind the last in its order) of boxes."""
        begins, ends = (np.column_stack([np.searchsorted(values, side[:, axis], which) for axis, values in enumerate(self.sorted)])
                        for side, which in ((low, "left"), (high, "right")))
        axes = (ends - begins).argmin(axis=1)
        rows = np.arange(len(low))
        return axes, begins[rows, axes], ends[rows, axes]

    def _of_long(self, low, high):
        """Pairs of an edge and a vertex beside it along one axis, an edge at a time."""
        axes, begins, ends = self._beside(low, high)
        if (ends - begins).sum() > _PAIRS_EACH * (len(low) + len(self.points)):
            raise _Dense
        for edge, (axis, begin, end) in enumerate(zip(axes, begins, ends)):
            yield np.full(end - begin, edge), self.orders[axis][begin:end]

    def _meets(self, starts, ends, low, high):
        """Whether each edge meets its box, which is widened by the distance at which a vertex counts as on the edge."""
        way, near, far = ends - starts, low - 2 * self.off - starts, high + 2 * self.off - starts
        with np.errstate(divide="ignore", invalid="ignore"):
            one, other = near / way, far / way
        still = way == 0
        first = np.where(still, np.where((near <= 0) & (far >= 0), -np.inf, np.inf), np.minimum(one, other)).max(axis=1)
        last = np.where(still, np.inf, np.maximum(one, other)).min(axis=1)
        return np.maximum(first, 0) <= np.minimum(last, 1)

    def _of_halves(self, starts, ends):
        """Pairs of an edge and a vertex, in parts: the vertices are halved along the longest side of their box, and an edge goes on to the
        halves whose boxes it meets."""
        order, parts = np.arange(len(self.points)), [(0, len(self.points), np.arange(len(starts)))]
        while parts:
            begin, end, edges = parts.pop()
            self.looked += len(edges)
            points = self.points[order[begin:end]]
            low, high = points.min(axis=0), points.max(axis=0)
            edges = edges[self._meets(starts[edges], ends[edges], low, high)]
            if not len(edges):
                continue
            if end - begin <= _LEAF or len(edges) <= 2:
                yield np.repeat(edges, end - begin), np.tile(order[begin:end], len(edges))
                continue
            axis, middle = np.argmax(high - low), (end - begin) // 2
            order[begin:end] = order[begin:end][np.argpartition(points[:, axis], middle)]
            parts += [(begin, begin + middle, edges), (begin + middle, end, edges)]

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
        if len(sums) and sums[-1] > _PAIRS_EACH * (len(low) + len(self.points)):
            raise _Dense
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
        result = {}
        for some, look in ((np.flatnonzero(is_short), lambda low, high: self._of_short(low, high, size)), (np.flatnonzero(~is_short), self._of_long)):
            for edges, places in self._pairs(look, starts, ends, low, high, some):
                self._add(result, starts, ends, edges, places)
        return {edge: [number for _, number in sorted(each)] for edge, each in result.items()}

    def _pairs(self, look, starts, ends, low, high, some):
        """Pairs of some edges and the vertices that may lie on them, in parts. look: how vertices are looked for where few are near."""
        if not len(some):
            return
        try:
            for edges, places in look(low[some], high[some]):
                yield some[edges], places
        except _Dense:      # before the first pair
            for edges, places in self._of_halves(starts[some], ends[some]):
                yield some[edges], places

    def _add(self, result, starts, ends, edges, places):
        """Adds to the result what lies on edges of pairs."""
        self.looked += len(edges)
        if self.looked > PAIRS_MAX:
            raise _TooMany
        along, found = self._on(starts[edges], ends[edges], self.points[places])
        self.hits += np.count_nonzero(found)
        if self.hits > SPLITS_MAX:
            raise _TooMany
        for edge, where, place in zip(edges[found].tolist(), along[found].tolist(), places[found].tolist()):
            result.setdefault(edge, set()).add((where, int(self.numbers[place])))


class _Dense(Exception):
    """Too many vertices are near the edges for a way of looking for them."""


class _TooMany(Exception):
    """There are more edges or vertices than are looked at."""


def _split(corners, inserted):
    """What a face's corners have, with more behind some of them. inserted: {place of a corner: what those behind it have}."""
    return [each for place, corner in enumerate(corners) for each in (corner, *inserted.get(place, ()))]


def _inserted(outlines, vertices, edges):
    """{number of a face: {place of a corner: the vertices that lie on the edge behind it}}."""
    extent, corners = max(max(axis) - min(axis) for axis in zip(*vertices)), [outlines[number] for number, _ in edges]
    pairs = [(each[place], each[(place + 1) % len(each)]) for (_, place), each in zip(edges, corners)]
    different = {pair: number for number, pair in enumerate(dict.fromkeys(pairs))}     # many faces may have one edge
    near = _Near({corner for pair in pairs for corner in pair}, vertices, max(OFF_MIN, extent // OFF_PART))
    on_edges, inserted = near.found(*(np.array([vertices[corner] for corner in side], dtype=float) for side in zip(*different))), {}
    found = {edge: on_edges[different[pair]] for edge, pair in enumerate(pairs) if different[pair] in on_edges}
    if sum(map(len, found.values())) > SPLITS_MAX:
        raise _TooMany
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
