# SPDX-License-Identifier: MIT
"""How far a mesh of fewer triangles is from the one that it was made of: the largest distance of the vertices of the one from
the triangles of the other, and of the middles of edges and triangles of the other from those of the one.

Each point is compared with all triangles that may be nearest: those whose middles are in cells of a grid about the point's own,
in ever more of them until no other triangle can be nearer."""

import numpy as np

CELLS_LEAST, CELLS_MOST = 4, 40     # along the longest side
POINTS_MAX = 8192       # of a mesh: of more every second, third and so on is measured
_PAIRS = 1 << 17    # of points and triangles at a time


def _middles(vertices, triangles):
    """Middles of edges and of triangles."""
    one, two, three = (vertices[triangles[:, i]] for i in range(3))
    return np.concatenate([(one + two) / 2, (two + three) / 2, (three + one) / 2, (one + two + three) / 3])


def _some(points):
    return points[::-(-len(points) // POINTS_MAX)]


def between(before, after):
    """The largest distance of two meshes, (vertices, triangles) each."""
    vertices, triangles = before
    return max(largest(_some(vertices[np.unique(triangles)]), *after), largest(_some(_middles(*after)), *before))


def _dot(one, other):
    return np.einsum("...i,...i->...", one, other)


def _to_segment(apart, way):
    """Squared distances of points, of which apart says how far from the start, from segments that go this way."""
    part = np.clip(_dot(apart, way) / np.maximum(_dot(way, way), 1e-300), 0, 1)
    rest = apart - part[..., None] * way
    return _dot(rest, rest)


def _squares(points, a, b, c):
    """Squared distances of points, (n, 1, 3), from triangles with these corners, (1, m, 3)."""
    normal = np.cross(b - a, c - a)
    square = _dot(normal, normal)
    inside, beside = np.broadcast_to(square > 0, (len(points), a.shape[1])), np.inf
    for start, end in ((a, b), (b, c), (c, a)):
        apart, way = points - start, end - start
        inside = inside & (_dot(apart, np.cross(normal, way)) >= 0)     # the inner side of the edge
        beside = np.minimum(beside, _to_segment(apart, way))
    height = _dot(points - a, normal)
    return np.where(inside, height * height / np.maximum(square, 1e-300), beside)


class _Grid:
    """Triangles by the cell of a grid that their middle is in. reach: how far a corner is from its triangle's middle at most."""

    def __init__(self, vertices, triangles, points):
        self.corners = [vertices[triangles[:, i]] for i in range(3)]
        middles = sum(self.corners) / 3
        self.reach = max(float(np.sqrt(_dot(corner - middles, corner - middles).max())) for corner in self.corners)
        self.count = min(max(int(len(triangles) ** 0.5 / 5), CELLS_LEAST), CELLS_MOST)
        self.start = np.minimum(points.min(axis=0), middles.min(axis=0))
        extent = (np.maximum(points.max(axis=0), middles.max(axis=0)) - self.start).max()
        self.side = max(extent / self.count * (1 + 1e-9), 1e-300)
        keys = self._key(self.cells(middles))
        self.order = np.argsort(keys, kind="stable")
        self.keys = keys[self.order]

    def cells(self, points):
        """The cell of each point."""
        return np.minimum(((points - self.start) / self.side).astype(np.int64), self.count - 1)

    def _key(self, cells):
        return (cells[..., 0] * self.count + cells[..., 1]) * self.count + cells[..., 2]

    def around(self, cell, steps):
        """The triangles whose middles are in a cell or at most so many cells from it."""
        low, high = np.maximum(cell - steps, 0), np.minimum(cell + steps, self.count - 1)
        x, y = (each.ravel() for each in np.meshgrid(*(np.arange(low[i], high[i] + 1) for i in range(2)), indexing="ij"))
        first = np.searchsorted(self.keys, self._key(np.stack([x, y, np.full(len(x), low[2])], axis=1)), "left")
        end = np.searchsorted(self.keys, self._key(np.stack([x, y, np.full(len(x), high[2])], axis=1)), "right")
        return self.order[np.concatenate([np.arange(a, b) for a, b in zip(first, end)])]

    def distances(self, points, near):
        """Of each point, the distance from the nearest of some triangles."""
        corners = [corner[near][None] for corner in self.corners]
        step = max(1, _PAIRS // len(near))
        return np.sqrt(np.concatenate([_squares(points[first:first + step, None], *corners).min(axis=1)
                                       for first in range(0, len(points), step)]))


def largest(points, vertices, triangles):
    """The largest distance of the points from the triangles."""
    grid = _Grid(vertices, triangles, points)
    cells, inverse = np.unique(grid.cells(points), axis=0, return_inverse=True)
    order, worst = np.argsort(inverse.reshape(-1), kind="stable"), 0.0
    ends = np.cumsum(np.bincount(inverse.reshape(-1), minlength=len(cells)))
    for cell, own in zip(cells, np.split(order, ends[:-1])):
        steps = 1 + int(grid.reach / grid.side)
        while len(own):
            near = grid.around(cell, steps)
            found = grid.distances(points[own], near) if len(near) else np.full(len(own), np.inf)
            # A triangle that was not looked at has its middle farther away than steps cells.
            is_sure = (found <= steps * grid.side - grid.reach) | (steps >= grid.count)
            worst = max(worst, float(found[is_sure].max(initial=0)))
            own, steps = own[~is_sure], 2 * steps
    return worst
