# SPDX-License-Identifier: MIT
"""How far a mesh of fewer triangles is from the one that it was made of: the largest distance of the vertices of the one from
the triangles of the other, and of the middles of edges and triangles of the other from those of the one.

Each point is compared with all triangles that may be nearest. Points are taken by cells of a grid: no triangle outside a ball
about a cell can be nearest to a point in it."""

import numpy as np

CELLS_LEAST, CELLS_MOST = 6, 24     # along the longest side: a cell costs as much as some thousand triangles
POINTS_MAX = 16_384     # of a mesh: of more every second, third and so on is measured
_PAIRS = 1 << 20    # of points and triangles at a time


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


def largest(points, vertices, triangles):
    """The largest distance of the points from the triangles."""
    corners = [vertices[triangles[:, i]] for i in range(3)]
    low, high = np.minimum(np.minimum(*corners[:2]), corners[2]), np.maximum(np.maximum(*corners[:2]), corners[2])
    start = points.min(axis=0)
    count = min(max(int(len(triangles) ** 0.5 / 10), CELLS_LEAST), CELLS_MOST)
    side = max((points.max(axis=0) - start).max() / count, 1e-300)
    cells, inverse = np.unique(((points - start) // side).astype(int), axis=0, return_inverse=True)
    order = np.argsort(inverse.reshape(-1), kind="stable")
    ends = np.cumsum(np.bincount(inverse.reshape(-1), minlength=len(cells)))
    worst, half = 0.0, side * np.sqrt(3) / 2
    for cell, (first, end) in zip(cells, zip(np.concatenate([[0], ends[:-1]]), ends)):
        middle, own = start + (cell + 0.5) * side, points[order[first:end]]
        reach = 2 * half + np.sqrt(((corners[0] - middle) ** 2).sum(1).min())
        gap = np.maximum(np.maximum(low - middle, middle - high), 0)
        near = np.flatnonzero((gap * gap).sum(1) <= reach * reach)
        step = max(1, _PAIRS // max(1, len(near)))
        for begin in range(0, len(own), step):
            found = _squares(own[begin:begin + step, None], *(corner[near][None] for corner in corners)).min(axis=1)
            worst = max(worst, float(found.max()))
    return worst ** 0.5
