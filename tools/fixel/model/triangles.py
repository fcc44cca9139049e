# SPDX-License-Identifier: MIT
"""Polygons cut into triangles, by mapbox-earcut. What it answers is checked in integers."""

import mapbox_earcut
import numpy as np

# Earcut adds products of two coordinates as doubles of 53 bits, so it misjudges less than this part of the largest
# product: by so much twice a triangle's area may look the wrong way.
_MISJUDGED = 1 << 50
_LONG = 200         # corners of an outline that is looked at before earcut has it
_SURELY = 1 << 40   # an area of more than this part of the largest product has the sign that doubles say
_AXES = ((1, 2), (2, 0), (0, 1))    # what is left without x, y, z


def _flattened(outline, area):
    """The outline seen along the axis that its area faces most, relative to its first point, so that it runs the
    way in which areas are positive."""
    axis = max(range(3), key=lambda i: abs(area[i]))
    u, v = _AXES[axis] if area[axis] > 0 else _AXES[axis][::-1]
    first = outline[0]
    return [(point[u] - first[u], point[v] - first[v]) for point in outline]


def _double_area(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _with_left_out(triangles, count):
    """Earcut leaves out corners on a straight line, which neighbours may have: triangles that have them too."""
    used = sorted({corner for triangle in triangles for corner in triangle})
    following = dict(zip(used, used[1:] + used[:1]))
    pending, made = list(reversed(triangles)), []
    while pending:
        triangle = pending.pop()
        for i, a in enumerate(triangle):
            b, c = triangle[(i + 1) % 3], triangle[(i + 2) % 3]
            if following.get(a) == b and (b - a) % count > 1:
                line = [(a + step) % count for step in range((b - a) % count + 1)]
                pending += [(one, other, c) for one, other in zip(line, line[1:])]
                break
        else:
            made.append(triangle)
    return made


def _fan(count):
    return [(0, i, i + 1) for i in range(1, count - 1)]


def _crosses_itself(flat):
    """Whether two edges surely cross. Earcut takes cubic time for such outlines."""
    starts = np.array(flat, dtype=float)
    ways = np.roll(starts, -1, axis=0) - starts
    least = np.abs(starts).max() ** 2 / _SURELY
    for number in range(len(flat) - 2):
        others = slice(number + 2, len(flat) - (number == 0))
        apart, way = starts[others] - starts[number], ways[number]
        # Twice the areas that the ends of each edge make with the other one.
        here = way[0] * apart[:, 1] - way[1] * apart[:, 0]
        there = here + way[0] * ways[others, 1] - way[1] * ways[others, 0]
        first = ways[others, 0] * apart[:, 1] - ways[others, 1] * apart[:, 0]
        last = first - (ways[others, 0] * way[1] - ways[others, 1] * way[0])
        apart_enough = np.minimum(np.minimum(abs(here), abs(there)), np.minimum(abs(first), abs(last))) > least
        if (apart_enough & (here * there < 0) & (first * last < 0)).any():
            return True
    return False


def triangulate(corners, points, area):
    """Triangles that make up a polygon, and whether its outline is sound; one that crosses itself becomes a fan.
    area: along the normal that points to the front."""
    flat = _flattened([points[corner] for corner in corners], area)
    if len(flat) > _LONG and _crosses_itself(flat):
        return [tuple(corners[i] for i in three) for three in _fan(len(flat))], False
    found = mapbox_earcut.triangulate_float64(np.array(flat, dtype=float), np.array([len(flat)], dtype=np.uint32))
    # Three numbers in rising order go round as the outline does.
    triangles = _with_left_out([tuple(sorted(three)) for three in found.reshape(-1, 3).tolist()], len(flat))
    areas = [_double_area(*(flat[i] for i in triangle)) for triangle in triangles]
    whole = sum(_double_area(flat[0], a, b) for a, b in zip(flat[1:], flat[2:]))
    slack = max(abs(c) for point in flat for c in point) ** 2 // _MISJUDGED
    sound = sum(areas) == whole and min(areas, default=0) >= -slack
    if not sound:
        triangles = _fan(len(flat))
    return [tuple(corners[i] for i in triangle) for triangle in triangles], sound
