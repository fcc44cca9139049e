# SPDX-License-Identifier: MIT
"""Whether a model is convex: no vertex stands out from the plane of a face by more than a face may be off flat."""

import numpy as np

from fixel.image.image import PLANARITY_MAX

_LEAF = 64          # vertices in a box
_CHUNK = 1024       # faces at a time
_TRIED = 16         # faces that are looked at before all others


def _leaves(points):
    """The points in boxes of at most _LEAF that are near each other: halves of halves, along the longest side."""
    pending, made = [points], []
    while pending:
        group = pending.pop()
        if len(group) <= _LEAF:
            made.append(group)
            continue
        axis = np.argmax(group.max(axis=0) - group.min(axis=0))
        order, half = np.argpartition(group[:, axis], len(group) // 2), len(group) // 2
        pending += [group[order[:half]], group[order[half:]]]
    return made


def _is_behind(normals, heights, leaves, boxes):
    """Whether every point is behind every plane, or out in front by PLANARITY_MAX. Only the points of those boxes
    are looked at that reach farther."""
    centres, halves = boxes
    for first in range(0, len(normals), _CHUNK):
        chunk = slice(first, first + _CHUNK)
        reach = normals[chunk] @ centres.T + np.abs(normals[chunk]) @ halves.T - heights[chunk, None]
        far = reach > PLANARITY_MAX
        for number in np.flatnonzero(far.any(axis=0)):
            faces = np.flatnonzero(far[:, number]) + first
            if (normals[faces] @ leaves[number].T - heights[faces, None]).max() > PLANARITY_MAX:
                return False
    return True


def is_convex(vertices, faces):
    """Whether no vertex stands out in front of the faces' planes, or none behind them: faces that look the same
    way then never hide each other. Doubles suffice: coordinates have 31 bits, and whole units are compared."""
    if not faces:
        return True
    points = np.array(vertices, dtype=float)
    normals = np.array([face.normal for face in faces], dtype=float) / 2 ** 30
    heights = np.sum(normals * points[[face.corners[0] for face in faces]], axis=1)
    planes = slice(None, None, max(1, len(faces) // _TRIED))
    reach = normals[planes] @ points.T - heights[planes, None]
    if reach.max() > PLANARITY_MAX and reach.min() < -PLANARITY_MAX:    # most models show it in a few planes
        return False
    if len(faces) > _LEAF:      # a plane that many faces share is looked at once; a few are looked at faster
        normals, heights = np.split(np.unique(np.column_stack([normals, heights]), axis=0), [3], axis=1)
        heights = heights[:, 0]
    leaves = _leaves(points)
    low, high = (np.array([end(leaf, axis=0) for leaf in leaves]) for end in (np.min, np.max))
    boxes = (low + high) / 2, (high - low) / 2
    return _is_behind(normals, heights, leaves, boxes) or _is_behind(-normals, -heights, leaves, boxes)
