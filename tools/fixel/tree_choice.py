# SPDX-License-Identifier: MIT
"""Which plane cuts the faces of a tree's node: one that splits few and leaves as many on either
side. Planes of faces, and planes across an axis between objects, which need not split anything."""

import numpy as np

from fixel.image_tree import PLANARITY_MAX

ON = (PLANARITY_MAX - 1) << 30
ONE = 1 << 30

# A split makes a face more in every frame; ill balance costs a little in some.
SPLIT_COST = 6

# So many planes of faces, and so many across each axis, are tried.
FACES_TRIED, ACROSS_TRIED = 40, 24


def _even(items, count):
    """At most count of the items, spread evenly."""
    return items if len(items) <= count else [items[i * len(items) // count] for i in range(count)]


def _of_faces(points, parts):
    """The planes of some faces, each once. A face's own height is the middle of its vertices'."""
    found = {}
    for part in _even(parts, 4 * FACES_TRIED):
        heights = [sum(n * c for n, c in zip(part.normal, points[v])) for v in part.ring]
        plane = part.normal, (min(heights) + max(heights)) // 2
        # The same plane seen from behind divides in the same way.
        key = max(plane, (tuple(-n for n in plane[0]), -plane[1]))
        found.setdefault(key, plane)
    return _even(list(found.values()), FACES_TRIED)


def _across(points, parts):
    """Planes across the axes: in the gaps between objects, where there are any."""
    groups = {}
    for part in parts:
        groups.setdefault(part.group, []).extend(part.ring)
    if len(groups) < 2:
        return []
    planes = []
    for axis in range(3):
        ends = sorted((min(points[v][axis] for v in ring), max(points[v][axis] for v in ring))
                      for ring in groups.values())
        places, reach = [], ends[0][1]
        for low, high in ends[1:]:
            if low >= reach:
                places.append((low + reach) // 2)
            reach = max(reach, high)
        normal = tuple(ONE if i == axis else 0 for i in range(3))
        planes += [(normal, place * ONE) for place in _even(places, ACROSS_TRIED)]
    return planes


def choose(points, parts):
    """(normal, distance) of the plane for these faces. Heights are below 2^62, so 64 bits hold
    them exactly."""
    vertices = np.array([points[v] for part in parts for v in part.ring], dtype=np.int64)
    starts = np.cumsum([0] + [len(part.ring) for part in parts[:-1]])
    best, best_cost = None, None
    candidates = [(plane, True) for plane in _of_faces(points, parts)] + \
        [(plane, False) for plane in _across(points, parts)]
    for plane, of_face in candidates:
        heights = vertices @ np.array(plane[0], dtype=np.int64) - plane[1]
        low, high = np.minimum.reduceat(heights, starts), np.maximum.reduceat(heights, starts)
        front, back = low >= -ON, high <= ON
        on, split = np.sum(front & back), np.sum(~front & ~back)
        ahead, behind = np.sum(front & ~back), np.sum(back & ~front)
        if not on and not split and not (ahead and behind):
            continue        # divides nothing
        # A node with nothing on it is one more to walk past.
        cost = SPLIT_COST * split + abs(int(ahead) - int(behind)) + (0 if of_face else 1)
        if best_cost is None or cost < best_cost:
            best, best_cost = plane, cost
    return best
