# SPDX-License-Identifier: MIT
"""Clusters of a sorted model's faces: runs of faces that lie together and look the same way, each with a
sphere and a cone (docs/formats.md, section 1.8)."""

import itertools
from math import isqrt

import numpy as np

from fixel.image import image_beam
from fixel.base.vectors import dot
from fixel.image.image_cluster import APEX_MAX, CUTOFF_MAX, Cluster, NO_CONE, is_steep

_TRIES = 64     # of places for an apex, each one unit farther back
FACES_MIN, FACES_MAX = 16, 32   # of a cluster; a model of fewer faces is one cluster


def _places(vertices, faces):
    """For each face six integers: its place (the middle of its box, doubled) and its normal."""
    points = np.array(vertices, dtype=np.int64)[[corner for face in faces for corner in face.corners]]
    starts = np.cumsum([0] + [len(face.corners) for face in faces[:-1]])
    boxes = np.minimum.reduceat(points, starts) + np.maximum.reduceat(points, starts)
    return np.hstack([boxes, np.array([face.normal for face in faces], dtype=np.int64)])


def _widths(places, size):
    """How far apart faces are, in each of the six numbers. Opposite normals are as far apart as the ends of the
    model; less different ones far less, by the fourth power: the two sides of a wall shall part, the slopes of a
    hill shall not."""
    extents = [int(extent) for extent in places.max(axis=0) - places.min(axis=0)]
    squares = [(extent >> 1) ** 2 >> 30 for extent in extents[3:]]
    return extents[:3] + [size * (square ** 2 >> 30) >> 30 for square in squares]


def _cut(values, is_normal):
    """Where to cut rising values in two: in the middle, or where normals leave a wide gap."""
    if is_normal:
        gaps = np.diff(values)[FACES_MIN - 1:len(values) - FACES_MIN]
        if gaps.max() >= 1 << 30:
            return FACES_MIN + int(gaps.argmax())
    return (len(values) + 1) // 2


def _split(places):
    """Groups of 16 to 32 faces, each in the order of their numbers: cut in two again and again across the largest
    width. Of faces at the same place the lower number comes first."""
    pending, groups = [np.arange(len(places))], []
    size = int((places.max(axis=0) - places.min(axis=0))[:3].max())
    while pending:
        group = pending.pop()
        if len(group) <= FACES_MAX:
            groups.append(np.sort(group))
            continue
        widths = _widths(places[group], size)
        across = widths.index(max(widths))
        order = group[np.lexsort((group, places[group, across]))]
        cut = _cut(places[order, across], across >= 3)
        pending += [order[cut:], order[:cut]]
    return groups


def _sphere(points):
    """Centre and radius of a sphere about points, which are below 2^30; the squares are below 3 * 2^62."""
    centre = (points.min(axis=0) + points.max(axis=0)) // 2
    square = max(map(int, ((points - centre) ** 2).sum(axis=1, dtype=np.uint64)))
    return tuple(map(int, centre)), 1 + isqrt(square - 1) if square else 0


def _cutoff(axis, normals):
    """The least that is_steep takes for all normals; None if there is none."""
    worst = min(normals, key=lambda normal: dot(normal, axis))
    least = dot(worst, axis) >> 30
    if least <= 0:
        return None
    square = least * least
    cutoff = max(0, dot(axis, axis) - (square - (square >> 28) - 2) + (1 << 28) - 1 >> 28)
    while cutoff <= CUTOFF_MAX and not is_steep(axis, cutoff, worst):
        cutoff += 1
    return cutoff if cutoff <= CUTOFF_MAX else None


def _apex(centre, axis, planes):
    """The last point of the line from the centre against the axis that sees no face's front. planes: normal and
    height of each face."""
    back = min((height - dot(normal, centre) << 30) // dot(normal, axis) for normal, height in planes)
    for tries in itertools.count():
        if tries == _TRIES:     # some face is nearly parallel to the axis: as far back as rounding can ask for
            back = min((height - dot(normal, centre) - sum(map(abs, normal)) << 30) // dot(normal, axis) for normal, height in planes)
        apex = tuple(c + (a * back >> 30) for c, a in zip(centre, axis))
        if any(abs(c) > APEX_MAX for c in apex):
            return None
        if all(dot(normal, apex) <= height for normal, height in planes):
            return apex
        back -= 1


def _cluster(model, faces):
    points = np.array([model.vertices[corner] for face in faces for corner in face.corners], dtype=np.int64)
    centre, radius = _sphere(points)
    total = tuple(map(sum, zip(*(face.normal for face in faces))))
    if any(total):
        axis = image_beam.unit(total)
        cutoff = _cutoff(axis, [face.normal for face in faces])
        planes = [(face.normal, dot(face.normal, model.vertices[face.corners[0]])) for face in faces]
        apex = _apex(centre, axis, planes) if cutoff is not None else None
        if apex is not None:
            return Cluster(centre, radius, axis, cutoff, apex, len(faces))
    return Cluster(centre, radius, NO_CONE, 0, (0, 0, 0), len(faces))


def divide(model):
    """Puts the model's faces into the order of its clusters, and gives it these."""
    faces = model.faces
    groups = [[faces[number] for number in group] for group in _split(_places(model.vertices, faces))]
    model.faces = [face for group in groups for face in group]
    model.clusters = [_cluster(model, group) for group in groups]
