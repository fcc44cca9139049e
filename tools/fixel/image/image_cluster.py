# SPDX-License-Identifier: MIT
"""The clusters of a scene image: what the loader asks of them (docs/formats.md, section 1.8)."""

from dataclasses import dataclass

from fixel.base.vectors import dot
from fixel.image.fields import entry
from fixel.image.image_tree import NORMAL_SQUARE_MAX_ERROR, RADIUS_MAX, SORTED, fail

APEX_MAX = 2 * (8191 << 16)     # of a coordinate, in 16.16
CUTOFF_MAX = (1 << 32) - 1
NO_CONE = (0, 0, 0)
CLUSTER = entry("clusters")
assert CLUSTER.size == 48


@dataclass
class Cluster:
    """A run of faces of a sorted model, with a sphere about them and a cone that sees none of them."""
    centre: tuple       # 16.16, relative to the object's centre
    radius: int         # 16.16
    axis: tuple         # 2.30, of the cone; NO_CONE if it has none
    cutoff: int         # 0.32: the square of the cosine between the axis and the cone's border
    apex: tuple         # 16.16, relative to the object's centre
    face_count: int

    def pack(self):
        return CLUSTER.pack(*self.centre, self.radius, *self.axis, self.cutoff, *self.apex, self.face_count, 0)


def _unpack(fields, number):
    if fields[12]:
        fail("reserved", f"cluster {number}: a reserved field is not zero")
    return Cluster(tuple(fields[:3]), fields[3], tuple(fields[4:7]), fields[7], tuple(fields[8:11]), fields[11])


def is_steep(axis, cutoff, normal):
    """Whether a face of this normal, seen from anywhere in the cone, shows no front if the apex does not see
    its front: the face's normal and any way from the eye to the apex are at most a right angle apart."""
    along = dot(normal, axis) >> 30
    rest = dot(axis, axis) - (cutoff << 28)
    return along >= 0 and along * along >= rest + (rest >> 28) + 1


def is_behind(apex, model, face):
    """Whether an eye at the apex does not see the face's front; the facing test, exactly."""
    return dot(face.normal, apex) <= dot(face.normal, model.vertices[face.corners[0]])


def _check_sphere(cluster, points, what):
    if not 0 <= cluster.radius <= RADIUS_MAX:
        fail("range", f"{what}: a radius of {cluster.radius / 65536:.6g} is outside 0..28375")
    if any(not min(axis) <= c <= max(axis) for c, axis in zip(cluster.centre, zip(*points))):
        fail("range", f"{what}: its centre is outside the bounding box of its faces")
    for point in points:
        if sum((a - b) ** 2 for a, b in zip(point, cluster.centre)) > cluster.radius ** 2:
            fail("radius", f"a face of {what} reaches out of its sphere")


def _check_cone(cluster, model, faces, what):
    if cluster.axis == NO_CONE:
        if cluster.cutoff or cluster.apex != (0, 0, 0):
            fail("reserved", f"{what} has no cone, but an apex or a cutoff")
        return
    if abs(dot(cluster.axis, cluster.axis) - (1 << 60)) > NORMAL_SQUARE_MAX_ERROR:
        fail("normal", f"the axis of {what} is not of unit length")
    if any(abs(c) > APEX_MAX for c in cluster.apex):
        fail("range", f"the apex of {what} is farther than {2 * 8191} from the object's centre")
    for face in faces:
        if not is_behind(cluster.apex, model, face) or not is_steep(cluster.axis, cluster.cutoff, face.normal):
            fail("cluster", f"an eye in the cone of {what} may see a face's front")


def check_cluster(cluster, model, first, what):
    """What the loader asks of a cluster whose first face is this one of its model's."""
    faces = model.faces[first:first + cluster.face_count]
    if not cluster.face_count or len(faces) < cluster.face_count:
        fail("count", f"{what} has {cluster.face_count} faces, and {len(faces)} are left of its model")
    _check_sphere(cluster, [model.vertices[c] for c in {corner for face in faces for corner in face.corners}], what)
    _check_cone(cluster, model, faces, what)


def check_models(models, firsts, count):
    """What the models say of the table of clusters: firsts are 0, or 1 + the number of a model's first."""
    for i, (model, first) in enumerate(zip(models, firsts)):
        if first and (not count or model.kind != SORTED):
            fail("reserved", f"model {i} has no clusters, but gives their place")


def read(models, firsts, table):
    """Gives the models their clusters, in turn."""
    check_models(models, firsts, len(table))
    next_one = 0
    for i, (model, first) in enumerate(zip(models, firsts)):
        if not first:
            continue
        if first != next_one + 1:
            fail("index", f"model {i}: its clusters do not follow those of the model before")
        face = 0
        while face < len(model.faces):
            what = f"cluster {next_one}"
            if next_one == len(table):
                fail("index", f"model {i}: the last {len(model.faces) - face} faces are in no cluster")
            cluster = _unpack(table[next_one], next_one)
            check_cluster(cluster, model, face, what)
            model.clusters.append(cluster)
            face, next_one = face + cluster.face_count, next_one + 1
    if next_one != len(table):
        fail("count", f"{len(table)} clusters, but the models have {next_one}")
