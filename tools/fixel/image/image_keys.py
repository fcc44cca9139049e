# SPDX-License-Identifier: MIT
"""The keys of a scene image: what ordering asks of a sorted model's faces (docs/formats.md, section 1)."""

import itertools

import numpy as np

from fixel.image.fields import entry
from fixel.image.image_tree import SORTED, fail

AT_ONCE = 64        # faces: of fewer, one after the other is faster
KEY = entry("keys")


def points_of(model):
    """The points of all corners of a model's faces, one face after the other, as 64-bit integers; of each face where its
    points begin, and how many there are."""
    sizes = np.array([len(face.corners) for face in model.faces], dtype=np.int64)
    corners = np.fromiter(itertools.chain.from_iterable(face.corners for face in model.faces), np.int64, int(sizes.sum()))
    return np.array(model.vertices, dtype=np.int64)[corners], np.cumsum(sizes) - sizes, sizes


def keys_of(model):
    """key_of of all faces. Their normals are of unit length, so 64 bits hold the heights."""
    if len(model.faces) < AT_ONCE:
        return [key_of(model, face) for face in model.faces]
    points, starts, _ = points_of(model)
    normals = np.array([face.normal for face in model.faces], dtype=np.int64)
    heights = (normals * points[starts]).sum(axis=1)
    ends = np.minimum.reduceat(points, starts) + np.maximum.reduceat(points, starts)
    return list(zip(heights.tolist(), *ends.T.tolist()))


def key_of(model, face):
    """A face's height over the model's origin, and minimum + maximum of its box."""
    xs, ys, zs = zip(*[model.vertices[corner] for corner in face.corners])
    u, v, w = face.normal
    return (u * xs[0] + v * ys[0] + w * zs[0], min(xs) + max(xs), min(ys) + max(ys), min(zs) + max(zs))


def check(models, first_keys, keys):
    """The keys of sorted models, in turn: what the faces say. An image may have none at all."""
    first = 0
    for i, (model, first_key) in enumerate(zip(models, first_keys)):
        has = keys and model.kind == SORTED
        wanted = keys_of(model) if has else []
        if not wanted and first_key:
            fail("reserved", f"model {i} has no face bounds, but gives their place")
        if wanted and (first_key != first or first + len(wanted) > len(keys)):
            fail("index", f"model {i}: its face bounds do not follow those of the model before, or some are missing")
        if wanted != keys[first:first + len(wanted)]:
            fail("face bounds", f"model {i}: the bounds of a face differ from those of its vertices and its normal")
        first += len(wanted)
    if first != len(keys):
        fail("count", f"{len(keys)} face bounds, but the sorted models have {first} faces")
