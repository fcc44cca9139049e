# SPDX-License-Identifier: MIT
"""Faces so close to each other that a depth buffer may not tell them apart."""

import dataclasses

import numpy

UNIT = 65536
PARALLEL = 1e-3     # of the components of unit normals
MARGIN = 1 / 256    # world units: faces that overlap by less only touch


@dataclasses.dataclass(frozen=True)
class Pair:
    gap: float      # between the planes, in world units
    one: tuple      # object, face of its model
    other: tuple


def resolution(near, far, bits=16):
    """The least difference of two distances, as a share of the distance, that a buffer surely resolves."""
    octaves = 1
    while near << octaves < far + (far >> 8) + 1:
        octaves += 1
    mantissa = max(m for m in range(16) if octaves << m < 65536)
    return (1 + 1 / 32) * 2.0**-mantissa if bits == 16 else 2.0**-(mantissa + 5)


def placed_faces(scene):
    """((object, face), unit normal, corners in world units), of objects that do not turn."""
    for number, thing in enumerate(scene.objects[:len(scene.objects) - len(scene.placements)]):
        model = scene.models[thing.model]
        vertices = (numpy.array(model.vertices, dtype=float) + numpy.array(thing.centre, dtype=float)) / UNIT
        for index, face in enumerate(model.faces):
            normal = numpy.array(face.normal, dtype=float)
            yield (number, index), normal / numpy.linalg.norm(normal), vertices[list(face.corners)]


def flattened(normal, corners):
    """The corners in two coordinates of their plane."""
    across = numpy.cross(normal, numpy.eye(3)[numpy.argmin(numpy.abs(normal))])
    across /= numpy.linalg.norm(across)
    return corners @ numpy.array([across, numpy.cross(normal, across)]).T


def overlap(one, other):
    """Whether two convex outlines in a plane share more than their borders."""
    for outline in (one, other):
        for start, end in zip(outline, numpy.roll(outline, -1, axis=0)):
            side = numpy.array([start[1] - end[1], end[0] - start[0]])
            length = numpy.linalg.norm(side)
            if length == 0:
                continue
            a, b = one @ side / length, other @ side / length
            if min(a.max(), b.max()) - max(a.min(), b.min()) < MARGIN:
                return False
    return True


def pairs_of_group(group, limit):
    """The pairs among faces that are parallel: (place, distance of the plane, outline), by distance."""
    group.sort(key=lambda face: face[1])
    distances = numpy.array([face[1] for face in group])
    low = numpy.array([face[2].min(axis=0) for face in group])
    high = numpy.array([face[2].max(axis=0) for face in group])
    for i, (place, distance, outline) in enumerate(group):
        end = numpy.searchsorted(distances, distance + limit, side="left")
        meet = (numpy.minimum(high[i], high[i + 1:end]) - numpy.maximum(low[i], low[i + 1:end]) >= MARGIN).all(axis=1)
        for j in i + 1 + numpy.flatnonzero(meet):
            if overlap(outline, group[j][2]):
                yield Pair(float(distances[j] - distance), place, group[j][0])


def find(scene, bits=16):
    """Pairs of parallel faces, turned the same way and over each other, that lie closer than a depth buffer of
    so many bits resolves at the far plane."""
    limit = resolution(scene.near, scene.far, bits) * scene.far / UNIT
    groups = {}
    for place, normal, corners in placed_faces(scene):
        key = tuple(numpy.round(normal / PARALLEL).astype(int))
        groups.setdefault(key, []).append((place, float(normal @ corners.mean(axis=0)), normal, corners))
    return [pair for group in groups.values() if len(group) > 1
            for pair in pairs_of_group([(place, distance, flattened(group[0][2], corners))
                                        for place, distance, _, corners in group], limit)]


def note(scene, bits=16):
    """A sentence about such faces; None where there are none."""
    pairs = find(scene, bits)
    if not pairs:
        return None
    least = min(pairs, key=lambda pair: pair.gap)
    places = " and ".join(f"face {face} of object {number}" for number, face in (least.one, least.other))
    limit = resolution(scene.near, scene.far, bits) * scene.far / UNIT
    return (f"{len(pairs)} pairs of parallel faces lie closer than the depth buffer resolves at the far plane ({limit:.4f} "
            f"units): far away either may be seen; the closest are {places}, {least.gap:.4f} units apart")
