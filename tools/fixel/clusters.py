# SPDX-License-Identifier: MIT
"""Clusters of a sorted model's faces: runs of faces that lie together and look the same way, each with a
sphere and a cone (docs/formats.md, section 1.8)."""

from math import isqrt

import numpy as np

from fixel import image_beam
from fixel.image_cluster import APEX_MAX, CUTOFF_MAX, NO_CONE, Cluster, dot, is_behind, is_steep

FACES_MAX = 32      # of a cluster; one of a model with more faces has at least half as many

# Faces whose normals differ by a right angle are as far apart as faces in places that differ by this part
# of the model's size.
TURN_SHIFT = 3


def _places(vertices, faces):
    """For each face six integers: its place (the middle of its box, doubled) and its normal, in the same unit."""
    boxes = np.array([[min(axis) + max(axis) for axis in zip(*(vertices[c] for c in face.corners))] for face in faces])
    size = int((boxes.max(axis=0) - boxes.min(axis=0)).max())
    normals = np.array([[c * size >> 30 + TURN_SHIFT for c in face.normal] for face in faces])
    return np.hstack([boxes, normals]).astype(np.int64)


def _split(places):
    """Groups of 16 to 32 faces, each in the order of their numbers: halved again and again across the largest
    extent. Of faces at the same place the lower number comes first."""
    pending, groups = [np.arange(len(places))], []
    while pending:
        group = pending.pop()
        if len(group) <= FACES_MAX:
            groups.append(np.sort(group))
            continue
        own = places[group]
        across = int((own.max(axis=0) - own.min(axis=0)).argmax())
        order = group[np.lexsort((group, own[:, across]))]
        half = (len(order) + 1) // 2
        pending += [order[half:], order[:half]]
    return groups


def _sphere(points):
    centre = tuple((min(axis) + max(axis)) // 2 for axis in zip(*points))
    square = max(sum((a - b) ** 2 for a, b in zip(point, centre)) for point in points)
    return centre, 1 + isqrt(square - 1) if square else 0


def _cutoff(axis, normals):
    """The least that is_steep takes for all normals; None if there is none."""
    least = min(dot(normal, axis) >> 30 for normal in normals)
    if least <= 0:
        return None
    square = least * least
    cutoff = max(0, dot(axis, axis) - (square - (square >> 28) - 2) + (1 << 28) - 1 >> 28)
    while cutoff <= CUTOFF_MAX and not all(is_steep(axis, cutoff, normal) for normal in normals):
        cutoff += 1
    return cutoff if cutoff <= CUTOFF_MAX else None


def _apex(centre, axis, model, faces):
    """The last point of the line from the centre against the axis that sees no face's front."""
    back = min((dot(face.normal, model.vertices[face.corners[0]]) - dot(face.normal, centre) << 30) //
               dot(face.normal, axis) for face in faces)
    while True:
        apex = tuple(c + (a * back >> 30) for c, a in zip(centre, axis))
        if any(abs(c) > APEX_MAX for c in apex):
            return None
        if all(is_behind(apex, model, face) for face in faces):
            return apex
        back -= 1


def _cluster(model, faces):
    centre, radius = _sphere([model.vertices[corner] for face in faces for corner in face.corners])
    total = tuple(map(sum, zip(*(face.normal for face in faces))))
    if any(total):
        axis = image_beam.unit(total)
        cutoff = _cutoff(axis, [face.normal for face in faces])
        apex = _apex(centre, axis, model, faces) if cutoff is not None else None
        if apex is not None:
            return Cluster(centre, radius, axis, cutoff, apex, len(faces))
    return Cluster(centre, radius, NO_CONE, 0, (0, 0, 0), len(faces))


def divide(model):
    """Puts the model's faces into the order of its clusters, and gives it these."""
    faces = model.faces
    groups = [[faces[number] for number in group] for group in _split(_places(model.vertices, faces))]
    model.faces = [face for group in groups for face in group]
    model.clusters = [_cluster(model, group) for group in groups]
