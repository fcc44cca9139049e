# SPDX-License-Identifier: MIT
"""The models and objects of a scene image: their records, packed, read and checked, and their keys: what ordering asks of a sorted model's
faces (docs/formats.md, section 1)."""

import itertools
import struct
from dataclasses import dataclass, field
from math import isqrt

import numpy as np

from fixel.image import image_surface
from fixel.image.fields import entry
from fixel.image.image_tree import COORDINATE_MAX, NORMAL_SQUARE_MAX_ERROR, RADIUS_MAX, SORTED, fail

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


def check_keys(models, first_keys, keys):
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


CONVEX = 0
FACE_VERTICES_MAX = 24
PLANARITY_MAX = 4
PLACED_MAX = 4_000_000          # vertices of the models of all instances

VERTEX, FACE, MODEL, OBJECT = map(entry, ("vertices", "faces", "models", "objects"))


@dataclass(slots=True)
class Face:
    normal: tuple       # 2.30
    corners: tuple      # numbers of vertices within the model, clockwise from the front
    colour: int
    mapped: image_surface.Mapped = None     # its surface
    whole: tuple = ()   # of a part of a face that was cut: the corners of the whole face, which light takes


@dataclass
class Model:
    vertices: list      # (x, y, z) in 16.16, relative to the object's centre
    faces: list
    kind: int = CONVEX
    clusters: list = field(default_factory=list)    # over all faces, or none
    lines: list = field(default_factory=list)       # image_lines.Line


@dataclass
class Object:
    centre: tuple       # 16.16
    model: int
    layer: int = 0


def radius_of(vertices):
    """The least radius about the origin that holds every vertex, in 16.16."""
    square = max((x * x + y * y + z * z for x, y, z in vertices), default=0)
    return 1 + isqrt(square - 1) if square else 0


def has_keys(scene):
    """Whether the faces of sorted models have keys: a renderer that does what the scene asks for sorts them, or finds them by clusters.
    With a depth buffer it does neither, unless a surface is mixed with what is beneath."""
    surfaces = scene.surfaces.surfaces if scene.surfaces else ()
    is_mixed = any(one.flags & (image_surface.BLENDED | image_surface.ADDED) for one in surfaces)
    return not scene.depth_bits or is_mixed or any(model.clusters for model in scene.models)


class Indices:
    """The indices of faces that are no triangles, and of faces that were cut."""

    def __init__(self):
        self.table, self.wholes, self._cut = [], [], {}

    def of(self, face):
        """What the record of the next face has: a triangle its own indices."""
        own = face.corners
        if len(own) != 3:
            first = self._add(own)
            own = (own[0], first & 0xFFFF, first >> 16)
        self.wholes.append(32 * self._of_whole(face.whole) + len(face.whole) if face.whole else 0)
        return own

    def _of_whole(self, whole):
        """Where the indices of a whole face begin: its parts come one behind the other."""
        if self._cut.get("corners") != whole:
            self._cut = {"corners": whole, "first": self._add(whole)}
        return self._cut["first"]

    def _add(self, corners):
        self.table += corners
        return len(self.table) - len(corners)

    def wholes_if_any(self):
        """Of each face the whole one; empty where no face was cut."""
        return self.wholes if any(self.wholes) else []


def tables(models_of_scene, with_keys=True):
    """Vertices, corners, faces and models as packed bytes, the keys of sorted models' faces, and the clusters, by name."""
    vertices, indices, faces, models, keys, clusters = [], Indices(), [], [], [], []
    for model in models_of_scene:
        models.append(MODEL.pack(len(vertices), len(model.vertices), len(faces),
                                 len(model.faces), model.kind, 0, 1 + len(clusters) if model.clusters else 0,
                                 radius_of(model.vertices),
                                 len(keys) if model.kind == SORTED else 0))
        vertices += [VERTEX.pack(*vertex) for vertex in model.vertices]
        for face in model.faces:
            faces.append(FACE.pack(*face.normal, len(face.corners), face.colour, *indices.of(face)))
        if with_keys and model.kind == SORTED:
            keys += [KEY.pack(*key) for key in keys_of(model)]
        clusters += [cluster.pack() for cluster in model.clusters]
    wholes = indices.wholes_if_any()
    return {"vertices": vertices, "corners": struct.pack(f"<{len(indices.table)}H", *indices.table), "faces": faces, "models": models,
            "keys": keys, "clusters": clusters, "wholes": struct.pack(f"<{len(wholes)}I", *wholes)}


def check_coordinates(point, what):
    if max(point) > COORDINATE_MAX or min(point) < -COORDINATE_MAX:
        fail("range", f"{what} ({', '.join(f'{c / 65536:.6g}' for c in point)}) "
             "leaves -8191..8191")


def check_plane(normal, points, what):
    """A face's normal and planarity, with the loader's integers."""
    u, v, w = normal
    if abs(u * u + v * v + w * w - (1 << 60)) > NORMAL_SQUARE_MAX_ERROR:
        fail("normal", f"the normal of {what} is not of unit length")
    x, y, z = points[0]
    for a, b, c in points:
        height = u * (a - x) + v * (b - y) + w * (c - z)
        if abs(height) > PLANARITY_MAX << 30:
            fail("planarity", f"a vertex of {what} lies {height / 2**46:.3g} units off its plane")


def _are_sound(model):
    """Whether check_plane holds for every face; vertices are within twice the range."""
    normals = np.array([face.normal for face in model.faces], dtype=np.int64)
    if (np.abs((normals.astype(float) ** 2).sum(axis=1) - (1 << 60)) > 1 << 40).any():   # or 64 bits would not hold the squares
        return False
    points, starts, sizes = points_of(model)
    heights = (np.repeat(normals, sizes, axis=0) * (points - np.repeat(points[starts], sizes, axis=0))).sum(axis=1)
    return bool((np.abs((normals ** 2).sum(axis=1) - (1 << 60)) <= NORMAL_SQUARE_MAX_ERROR).all() and
                (np.abs(heights) <= PLANARITY_MAX << 30).all())


def check_planes(model, number):
    """check_plane of each face of a model."""
    if len(model.faces) < AT_ONCE or not _are_sound(model):
        for i, face in enumerate(model.faces):
            check_plane(face.normal, [model.vertices[c] for c in face.corners], f"face {i} of model {number}")


def check_faces(faces, corners, wholes):
    for i, (*_, count, _, vertex, low, high) in enumerate(faces):
        first = low + (high << 16)
        whole = wholes[i] if wholes else 0
        for number in (count, whole % 32 if whole else 3):
            if not 3 <= number <= FACE_VERTICES_MAX:
                fail("count", f"face {i}: {number} vertices are outside 3..{FACE_VERTICES_MAX}")
        if (count != 3 and first + count > len(corners)) or whole // 32 + whole % 32 > len(corners):
            fail("index", f"face {i} reaches past the table of indices")
        if count != 3 and corners[first] != vertex:
            fail("index", f"face {i}: its first vertex is {vertex}, and {corners[first]} in the table of indices")


def outlines(record, whole, corners):
    """The corners of a face and of the whole face, of its record and its entry of the whole faces."""
    *_, count, _, vertex, low, high = record
    own = (vertex, low, high) if count == 3 else corners[low + (high << 16):low + (high << 16) + count]
    return own, corners[whole // 32:whole // 32 + whole % 32] if whole else ()


def read_models(models, vertices, corners, faces, wholes):
    result, extras, vertex, face = [], [], 0, 0
    for i, (first_vertex, vertex_count, first_face, face_count, kind, reserved, first_cluster, radius,
            first_key) in enumerate(models):
        if kind not in (CONVEX, SORTED) or reserved:
            fail("reserved", f"model {i}: unknown kind or reserved field not zero")
        if not 0 <= radius <= RADIUS_MAX:
            fail("range", f"model {i}: a radius of {radius / 65536:.6g} is outside 0..28375")
        if not (3 if face_count else 1) <= vertex_count <= 65535 or face_count > 65535 or (not face_count and kind != CONVEX):
            fail("count", f"model {i}: {vertex_count} vertices, {face_count} faces")
        if (first_vertex, first_face) != (vertex, face):
            fail("index", f"model {i} does not begin where the one before it ends")
        vertex, face = vertex + vertex_count, face + face_count
        if vertex > len(vertices) or face > len(faces):
            fail("index", f"model {i} reaches past the vertices or the faces")
        own = []
        for number, record in enumerate(faces[first_face:first_face + face_count], first_face):
            outline, whole = outlines(record, wholes[number] if wholes else 0, corners)
            if max(outline + whole) >= vertex_count:
                fail("index", f"face {number}: vertex {max(outline + whole)} of {vertex_count}")
            own.append(Face(record[:3], outline, record[4], whole=whole))
        result.append(Model(vertices[first_vertex:first_vertex + vertex_count], own, kind))
        extras.append((radius, first_key, first_cluster))
    if (vertex, face) != (len(vertices), len(faces)):
        fail("count", f"{len(vertices)} vertices and {len(faces)} faces, but the models have {vertex} and {face}")
    return result, extras


def check_vertices(models):
    """A model may have no instance: its vertices lie within twice the range."""
    for i, model in enumerate(models):
        if any(abs(c) > 2 * COORDINATE_MAX for vertex in model.vertices for c in vertex):
            fail("range", f"a vertex of model {i} is farther than {2 * 8191} from its origin")


def check_radii(models, extras):
    for i, (model, (radius, *_)) in enumerate(zip(models, extras)):
        if radius_of(model.vertices) > radius:
            fail("radius", f"a vertex of model {i} lies farther from its origin than "
                 f"{radius / 65536:.6g}, the model's radius")


def read_objects(objects, models):
    result, placed = [], 0
    for i, (*centre, model, layer, reserved) in enumerate(objects):
        if reserved:
            fail("reserved", f"instance {i}: a reserved field is not zero")
        if model >= len(models):
            fail("index", f"instance {i}: model {model} of {len(models)}")
        check_coordinates(centre, f"the centre of instance {i}")
        placed += len(models[model].vertices)
        if placed > PLACED_MAX:
            fail("count", f"instance {i}: the instances' models have more than {PLACED_MAX:,} vertices together")
        result.append(Object(tuple(centre), model, layer))
    return result


def check_extents(objects, models):
    """Every vertex of every object; a model's bounding box stands for all."""
    boxes = {}
    for i, item in enumerate(objects):
        if item.model not in boxes:
            axes = list(zip(*models[item.model].vertices))
            boxes[item.model] = [[min(a) for a in axes], [max(a) for a in axes]]
        for end in boxes[item.model]:
            check_coordinates([c + e for c, e in zip(item.centre, end)], f"a vertex of instance {i}")
