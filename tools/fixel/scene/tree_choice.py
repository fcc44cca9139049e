# SPDX-License-Identifier: MIT
"""Which plane cuts the faces of a tree's node: one that splits few and leaves as many on either
side. Planes of faces, and planes across an axis between objects, which need not split anything."""

import numpy as np

from fixel.image.image_tree import PLANARITY_MAX

ON = (PLANARITY_MAX - 1) << 30
ONE = 1 << 30

# A split makes a face more in every frame; ill balance costs a little in some.
SPLIT_COST = 6

COST_MAX = 1 << 40
HEIGHTS_AT_ONCE = 1 << 18   # 2 MB

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


def _costs(points, parts, planes):
    """What each plane would cost that divides the parts; for the others COST_MAX. Heights are below 2^62, so 64 bits hold
    them exactly."""
    vertices = np.array([points[v] for part in parts for v in part.ring], dtype=np.int64)
    starts = np.cumsum([0] + [len(part.ring) for part in parts[:-1]])
    normals = np.array([normal for normal, _ in planes], dtype=np.int64).T
    distances = np.array([distance for _, distance in planes], dtype=np.int64)
    costs, step = [], max(1, HEIGHTS_AT_ONCE // len(vertices))
    for first in range(0, len(planes), step):
        heights = vertices @ normals[:, first:first + step] - distances[first:first + step]
        front = np.minimum.reduceat(heights, starts) >= -ON
        back = np.maximum.reduceat(heights, starts) <= ON
        on, split = np.sum(front & back, axis=0), np.sum(~front & ~back, axis=0)
        ahead, behind = np.sum(front & ~back, axis=0), np.sum(back & ~front, axis=0)
        divides = (on > 0) | (split > 0) | ((ahead > 0) & (behind > 0))
        costs.append(np.where(divides, SPLIT_COST * split + np.abs(ahead - behind), COST_MAX))
    return np.concatenate(costs)


def choose(points, parts):
    """(normal, distance) of the plane for these faces: of those that cost the same the first."""
    of_faces = _of_faces(points, parts)
    planes = of_faces + _across(points, parts)
    costs = _costs(points, parts, planes)
    costs[len(of_faces):] += 1      # a node with nothing on it is one more to walk past
    best = int(np.argmin(costs))
    assert costs[best] < COST_MAX, "a face lies on its own plane"
    return planes[best]
