# SPDX-License-Identifier: MIT
"""Scene images: written, read and checked as SPEC.md, section 3, and docs/formats.md, section 1, say."""

from dataclasses import dataclass, field
from math import isqrt
import struct
import zlib

from fixel import image_beam, image_cluster, image_keys, image_lens, image_light, image_surface, image_turn, reading
from fixel.errors import ToolError
from fixel.image_tree import (NODE, NODES_MAX, NORMAL_SQUARE_MAX_ERROR, SORTED, Node, Tree,
                              check_tree, fail)

MAGIC = b"FXLS"
VERSION, VERSION_MORE, VERSION_CLUSTERS, VERSION_TURNS, VERSION_LIGHT = 2, 3, 4, 5, 6
HEADER_SIZE = 160
LIT_HEADER_SIZE = HEADER_SIZE + image_beam.LIT_HEADER.size               # of a scene with beams
CLUSTER_HEADER_SIZE = LIT_HEADER_SIZE + image_cluster.HEADER.size        # of a scene with clusters
TURN_HEADER_SIZE = CLUSTER_HEADER_SIZE + image_turn.HEADER.size          # of a scene with turned objects
LIGHT_HEADER_SIZE = TURN_HEADER_SIZE + image_light.HEADER.size           # of a scene with light at run time
SURFACE_HEADER_SIZE = LIGHT_HEADER_SIZE + image_surface.HEADER.size      # of a scene with surfaces
IMAGE_MAX = 16 << 20

COORDINATE_MAX = 8191 << 16
RADIUS_MAX = 28375 << 16        # no vertex can be farther from its origin
GAIT_MAX, TURN_MAX = 256 << 16, 1 << 30
FACE_VERTICES_MAX = 24
PLANARITY_MAX = 4
PLACED_MAX = 4_000_000          # vertices of the models of all instances

CONVEX = 0
POSES, STRIDES = 0, 1

KEYS = {"forward": 1, "back": 2, "left": 4, "right": 8,
        "pitch_up": 16, "pitch_down": 32, "roll_left": 64, "roll_right": 128}

_HEAD = struct.Struct("<4sHHII HHI 3i BBH 3i3I 3iI 14I I 2I 2I I")
_PALETTE = struct.Struct("<3B")
_VERTEX = struct.Struct("<3i")
_CORNER = struct.Struct("<H")
_FACE = struct.Struct("<3iIBBH")
_MODEL = struct.Struct("<4IBBHiI")
_OBJECT = struct.Struct("<3iHBB")
_POSE = struct.Struct("<3i3I")
_STRIDE = struct.Struct("<HH")
assert _HEAD.size == HEADER_SIZE


@dataclass
class Face:
    normal: tuple       # 2.30
    corners: tuple      # numbers of vertices within the model, clockwise from the front
    colour: int
    mapped: image_surface.Mapped = None     # its surface


@dataclass
class Model:
    vertices: list      # (x, y, z) in 16.16, relative to the object's centre
    faces: list
    kind: int = CONVEX
    clusters: list = field(default_factory=list)    # over all faces, or none


@dataclass
class Object:
    centre: tuple       # 16.16
    model: int
    layer: int = 0


@dataclass
class SceneImage:
    """Everything an image holds, in the image's own integers."""
    width: int
    height: int
    fov: int
    near: int
    far: int
    inset: int
    background: int
    palette: list                       # 256 x (red, green, blue)
    models: list
    objects: list
    path_kind: int
    path: list                          # (x, y, z, yaw, pitch, roll) or (keys, frames)
    start: tuple = (0, 0, 0, 0, 0, 0)
    gait: tuple = (0, 0, 0, 0)          # acceleration, friction, top speed, turn
    tree: Tree = None
    beams: list = field(default_factory=list)
    lit: bytes = bytes(range(256))      # for each colour, the one that it has in a beam
    centre: tuple = None                # (x, y) of the lens in 16.16; None: the middle of the screen
    turns: list = field(default_factory=list)       # of the last objects
    motions: list = field(default_factory=list)     # of the last of those
    light: image_light.Light = None                 # at run time
    surfaces: image_surface.Surfaces = None
    moving: tuple = field(default=(), compare=False)    # objects that a tree leaves out
    names: list = field(default_factory=list, compare=False)    # of the objects, in turn; None: it has none
    reserved: int = field(default=0, compare=False)     # last entries of the palette, which no face has
    size: int = field(default=0, compare=False)
    crc: int = field(default=0, compare=False)

    @property
    def frames(self):
        return len(self.path) if self.path_kind == POSES else sum(n for _, n in self.path)


def _aligned(blob):
    return blob + b"\0" * (-len(blob) % 4)


def radius_of(vertices):
    """The least radius about the origin that holds every vertex, in 16.16."""
    square = max((x * x + y * y + z * z for x, y, z in vertices), default=0)
    return 1 + isqrt(square - 1) if square else 0


def _model_tables(image):
    """Vertices, corners, faces and models as packed bytes, the keys of sorted models' faces, and the clusters."""
    vertices, corners, faces, models, keys, clusters = [], [], [], [], [], []
    for model in image.models:
        models.append(_MODEL.pack(len(vertices), len(model.vertices), len(faces),
                                  len(model.faces), model.kind, 0, 1 + len(clusters) if model.clusters else 0,
                                  radius_of(model.vertices),
                                  len(keys) if model.kind == SORTED else 0))
        vertices += [_VERTEX.pack(*vertex) for vertex in model.vertices]
        for face in model.faces:
            faces.append(_FACE.pack(*face.normal, len(corners), len(face.corners),
                                    face.colour, 0))
            corners += [_CORNER.pack(corner) for corner in face.corners]
        if model.kind == SORTED:
            keys += [image_keys.KEY.pack(*image_keys.key_of(model, face)) for face in model.faces]
        clusters += [cluster.pack() for cluster in model.clusters]
    return [vertices, corners, faces, models], keys, clusters


def _kind(nodes, beams, clusters, turns, light, surfaces):
    """The version of an image, and the size of its header."""
    if light or surfaces:
        return VERSION_LIGHT, SURFACE_HEADER_SIZE if surfaces else LIGHT_HEADER_SIZE
    if turns:
        return VERSION_TURNS, TURN_HEADER_SIZE
    if clusters:
        return VERSION_CLUSTERS, CLUSTER_HEADER_SIZE
    return VERSION_MORE if nodes or beams else VERSION, LIT_HEADER_SIZE if beams else HEADER_SIZE


def pack(image):
    """The bytes of an image. Checks the result, so that nothing is written
    that a loader would refuse."""
    path_entry = _POSE if image.path_kind == POSES else _STRIDE
    model_tables, keys, clusters = _model_tables(image)
    nodes = [node.pack() for node in image.tree.nodes] if image.tree else []
    beams = [beam.pack() for beam in image.beams]
    turns, motions, motion_keys = image_turn.tables(image.turns, image.motions)
    light = image.light.tables() if image.light else [[], [], []]
    surfaces = image_surface.tables(image.surfaces, image.models)
    version, header_size = _kind(nodes, beams, clusters, turns, light[0], image.surfaces)
    body, where = image_lens.CENTRE.pack(*image.centre) if image.centre else b"", []

    def place(table):
        """Puts a table at the end of the body; its offset and count, both 0 for no table."""
        nonlocal body
        offset = header_size + len(body) if table else 0
        body += _aligned(b"".join(table))
        return [offset, len(table)]

    for table in [[_PALETTE.pack(*entry) for entry in image.palette], *model_tables,
                  [_OBJECT.pack(*item.centre, item.model, item.layer, 0) for item in image.objects],
                  [path_entry.pack(*entry) for entry in image.path]]:
        where += place(table)
    where_more = place(keys) + place(nodes)
    more = image_beam.LIT_HEADER.pack(*place(beams), place([bytes(image.lit)] if beams else [])[0], 0)
    more += image_cluster.HEADER.pack(*place(clusters))
    more += image_turn.HEADER.pack(*place(turns), *place(motions), *place(motion_keys))
    more += image_light.HEADER.pack(*(number for table in light for number in place(table)))
    more += image_surface.HEADER.pack(*(number for table in surfaces for number in place(table)),
                                      image.surfaces.blend_first if image.surfaces else 0, 0)
    more = more[:header_size - HEADER_SIZE]
    size = header_size + len(body)
    if size > IMAGE_MAX:
        fail("size", f"the scene needs {size:,} bytes, and an image holds at most {IMAGE_MAX:,}; "
             "use fewer or smaller models or a shorter path")

    def head(crc):
        return _HEAD.pack(MAGIC, version, header_size, size, crc, image.width, image.height,
                          image.fov, image.near, image.far, image.inset, image.background,
                          image.path_kind, int(image.centre is not None), *image.start, *image.gait, *where, image.frames,
                          *where_more, image.tree.object if nodes else 0)

    blob = head(zlib.crc32(head(0)[16:] + more + body)) + more + body
    unpack(blob)
    return blob


def _head(blob):
    """The header's fields, checked up to its reserved ones."""
    if len(blob) < HEADER_SIZE:
        fail("size", f"{len(blob)} bytes are fewer than a header's {HEADER_SIZE}")
    fields = _HEAD.unpack_from(blob)
    magic, version, header_size, size, crc = fields[:5]
    if magic != MAGIC:
        fail("magic", "this is not a scene image (it does not begin with FXLS)")
    sizes = {VERSION: [HEADER_SIZE], VERSION_MORE: [HEADER_SIZE, LIT_HEADER_SIZE],
             VERSION_CLUSTERS: [CLUSTER_HEADER_SIZE], VERSION_TURNS: [TURN_HEADER_SIZE],
             VERSION_LIGHT: [LIGHT_HEADER_SIZE, SURFACE_HEADER_SIZE]}
    if version not in sizes:
        fail("version", f"a scene image of version {version}; this tool knows versions {VERSION} "
             f"to {VERSION_LIGHT}")
    if header_size not in sizes[version]:
        fail("size", f"a header of {header_size} bytes is not one of version {version}")
    if size % 4 or not header_size <= size <= IMAGE_MAX or size > len(blob):
        fail("size", f"the image says that it has {size} bytes; there are {len(blob)}")
    if zlib.crc32(blob[16:size]) != crc:
        fail("crc", "the checksum does not match: the image is damaged")
    if fields[13] > 1 or version == VERSION and any(fields[41:]) or fields[12] not in (POSES, STRIDES):
        fail("reserved", "a reserved field of the header is not zero, or the kind of the path is unknown")
    if header_size == SURFACE_HEADER_SIZE:
        *_, blend, first, reserved = image_surface.HEADER.unpack_from(blob, LIGHT_HEADER_SIZE)
        if reserved or not blend and first:
            fail("reserved", "a reserved field of the header is not zero")
    if version == VERSION_MORE and header_size == HEADER_SIZE and not any(fields[41:]):
        fail("version", f"version {VERSION_MORE} of a scene image without a BSP tree or beams")
    if size - header_size < fields[13] * image_lens.CENTRE.size:
        fail("size", "the image ends before the centre of its lens")
    return fields


def check_coordinates(point, what):
    if any(abs(c) > COORDINATE_MAX for c in point):
        fail("range", f"{what} ({', '.join(f'{c / 65536:.6g}' for c in point)}) "
             "leaves -8191..8191")


def _check_gait(gait):
    if any(not 0 <= value <= GAIT_MAX for value in gait[:3]) or not 0 <= gait[3] <= TURN_MAX:
        fail("range", "the motion limits are out of range (0..256 units a step, at most 1/4 turn a step)")


def check_plane(normal, points, what):
    """A face's normal and planarity, with the loader's integers."""
    if abs(sum(c * c for c in normal) - (1 << 60)) > NORMAL_SQUARE_MAX_ERROR:
        fail("normal", f"the normal of {what} is not of unit length")
    first = points[0]
    for point in points:
        height = sum(n * (a - b) for n, a, b in zip(normal, point, first))
        if abs(height) > PLANARITY_MAX << 30:
            fail("planarity", f"a vertex of {what} lies {height / 2**46:.3g} units off its plane")


def _tables(blob, fields):
    """The tables as lists of tuples, after their offsets and counts; empty where there are none."""
    limits = [("palette", _PALETTE, 256, 256), ("vertices", _VERTEX, 1, 1_000_000),
              ("corners", _CORNER, 1, 4_000_000), ("faces", _FACE, 1, 1_000_000),
              ("models", _MODEL, 1, 65_535), ("objects", _OBJECT, 1, 65_535),
              ("path", _POSE if fields[12] == POSES else _STRIDE, 1, 1_000_000),
              ("keys", image_keys.KEY, 1, 1_000_000), ("nodes", NODE, 1, NODES_MAX),
              ("beams", image_beam.BEAM, 1, image_beam.BEAMS_MAX), ("lit", image_beam.LIT, 1, 1),
              ("clusters", image_cluster.CLUSTER, 1, image_cluster.CLUSTERS_MAX),
              ("turns", image_turn.TURN, 1, 65_535), ("motions", image_turn.MOTION, 1, 65_535),
              ("motion keys", image_turn.KEY, 1, image_turn.KEYS_MAX), ("light", image_light.BASE, 1, 1),
              ("point lights", image_light.POINT, 1, image_light.POINTS_MAX),
              ("levels", image_light.LEVEL, 1, image_light.LEVELS_MAX), *image_surface.TABLES]
    optional = {"keys", "nodes", "beams", "lit", "clusters", "turns", "motions", "motion keys", "light", "point lights",
                "levels", *(name for name, *_ in image_surface.TABLES)}
    beams, lit, clusters, turns, light, surfaces = (0, 0), (0, 0), (0, 0), (0,) * 6, (0,) * 6, (0,) * 14
    if fields[2] != HEADER_SIZE:
        *beams, lit, reserved = image_beam.LIT_HEADER.unpack_from(blob, HEADER_SIZE)
        if reserved:
            fail("reserved", "a reserved field of the header is not zero")
        lit = lit, min(beams[1], 1)
        optional -= {"beams", "lit"}
    if fields[2] >= CLUSTER_HEADER_SIZE:
        clusters = image_cluster.HEADER.unpack_from(blob, LIT_HEADER_SIZE)
        optional = optional - {"clusters"} | {"beams", "lit"}
    if fields[2] >= TURN_HEADER_SIZE:
        turns = image_turn.HEADER.unpack_from(blob, CLUSTER_HEADER_SIZE)
        optional = optional - {"turns"} | {"clusters"}
    if fields[2] >= LIGHT_HEADER_SIZE:
        light = image_light.HEADER.unpack_from(blob, TURN_HEADER_SIZE)
        optional = optional - {"light", "levels"} | {"turns"}
    if fields[2] == SURFACE_HEADER_SIZE:
        *surfaces, _, _ = image_surface.HEADER.unpack_from(blob, LIGHT_HEADER_SIZE)
        optional = optional - image_surface.NEEDED | {"light"} | ({"levels"} if not light[1] else set())
    places = [*(fields[i:i + 2] for i in range(24, 38, 2)), fields[39:41], fields[41:43], beams, lit, clusters,
              turns[:2], turns[2:4], turns[4:], light[:2], light[2:4], light[4:], *zip(surfaces[::2], surfaces[1::2])]
    size, tables = fields[3], []
    for (offset, count), (name, entry, low, high) in zip(places, limits):
        if name in optional and not count:
            if offset:
                fail("count", f"the header gives an offset of {name}, but a count of 0")
            tables.append([])
            continue
        if not low <= count <= high:
            fail("count", f"{count} {name} are outside {low}..{high}")
        if offset % 4:
            fail("alignment", f"the table of {name} begins at {offset}, not a multiple of four")
        if offset < fields[2] or offset + count * entry.size > size:
            fail("offset", f"the table of {name} reaches outside the image")
        tables.append(list(entry.iter_unpack(blob[offset:offset + count * entry.size])))
    for name, held in (("vertices", tables[1]), ("corners", tables[2])):
        if len(held) < 3:
            fail("count", f"{len(held)} {name} are fewer than 3")
    if len(tables[12]) > len(tables[5]) or len(tables[13]) > len(tables[12]):
        fail("count", f"{len(tables[5])} objects, {len(tables[12])} turns and {len(tables[13])} motions do not go together")
    if not tables[15] and (tables[16] or tables[17]):
        fail("count", "there are point lights or levels, but no light")
    if tables[22] and len(tables[22]) != len(tables[3]):
        fail("count", f"{len(tables[22])} entries of the face map for {len(tables[3])} faces")
    return tables


def _check_faces(faces, corners):
    for i, (*_, first, count, _, reserved) in enumerate(faces):
        if reserved:
            fail("reserved", f"face {i}: a reserved field is not zero")
        if not 3 <= count <= FACE_VERTICES_MAX:
            fail("count", f"face {i}: {count} vertices are outside 3..{FACE_VERTICES_MAX}")
        if first + count > len(corners):
            fail("index", f"face {i} reaches past the table of indices")


def _read_models(models, vertices, corners, faces):
    result, extras, vertex, face = [], [], 0, 0
    for i, (first_vertex, vertex_count, first_face, face_count, kind, reserved, first_cluster, radius,
            first_key) in enumerate(models):
        if kind not in (CONVEX, SORTED) or reserved:
            fail("reserved", f"model {i}: unknown kind or reserved field not zero")
        if not 0 <= radius <= RADIUS_MAX:
            fail("range", f"model {i}: a radius of {radius / 65536:.6g} is outside 0..28375")
        if not 3 <= vertex_count <= 65535 or not 1 <= face_count <= 65535:
            fail("count", f"model {i}: {vertex_count} vertices, {face_count} faces")
        if (first_vertex, first_face) != (vertex, face):
            fail("index", f"model {i} does not begin where the one before it ends")
        vertex, face = vertex + vertex_count, face + face_count
        if vertex > len(vertices) or face > len(faces):
            fail("index", f"model {i} reaches past the vertices or the faces")
        own = []
        for number, (*normal, first, count, colour, _) in \
                enumerate(faces[first_face:first_face + face_count], first_face):
            outline = tuple(corner for corner, in corners[first:first + count])
            if max(outline) >= vertex_count:
                fail("index", f"face {number}: vertex {max(outline)} of {vertex_count}")
            own.append(Face(tuple(normal), outline, colour))
        result.append(Model(vertices[first_vertex:first_vertex + vertex_count], own, kind))
        extras.append((radius, first_key, first_cluster))
    if (vertex, face) != (len(vertices), len(faces)):
        fail("count", f"{len(vertices)} vertices and {len(faces)} faces, but the models have {vertex} and {face}")
    return result, extras


def _check_vertices(models):
    """A model may have no instance: its vertices lie within twice the range."""
    for i, model in enumerate(models):
        if any(abs(c) > 2 * COORDINATE_MAX for vertex in model.vertices for c in vertex):
            fail("range", f"a vertex of model {i} is farther than {2 * 8191} from its origin")


def _check_radii(models, extras):
    for i, (model, (radius, *_)) in enumerate(zip(models, extras)):
        if radius_of(model.vertices) > radius:
            fail("radius", f"a vertex of model {i} lies farther from its origin than "
                 f"{radius / 65536:.6g}, the model's radius")


def _read_objects(objects, models):
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


def _check_extents(objects, models):
    """Every vertex of every object; a model's bounding box stands for all."""
    boxes = {}
    for i, item in enumerate(objects):
        if item.model not in boxes:
            axes = list(zip(*models[item.model].vertices))
            boxes[item.model] = [[min(a) for a in axes], [max(a) for a in axes]]
        for end in boxes[item.model]:
            check_coordinates([c + e for c, e in zip(item.centre, end)], f"a vertex of instance {i}")


def _check_path(kind, path, frames):
    for i, entry in enumerate(path):
        if kind == POSES:
            check_coordinates(entry[:3], f"pose {i}")
        elif entry[0] & ~0xFF:
            fail("reserved", f"path segment {i}: unknown keys {entry[0]:#x}")
        elif entry[1] < 1:
            fail("count", f"path segment {i}: 0 frames")
    total = len(path) if kind == POSES else sum(n for _, n in path)
    if total != frames or not 1 <= frames <= 1_000_000:
        fail("count", f"the path has {total} frames, the header says {frames}")


def _centre(blob, fields):
    """The centre of a lens that is off-centre, behind the header; else None."""
    if not fields[13]:
        return None
    width, height, fov, inset = fields[5], fields[6], fields[7], fields[10]
    centre = image_lens.CENTRE.unpack_from(blob, fields[2])
    image_lens.check_centre(width, height, fov, inset, centre)
    if centre == image_lens.middle(width, height):
        fail("reserved", "the image gives the middle of the screen as the centre of its lens")
    return centre


def _blend_first(blob, fields):
    """The first colour of the blend table; 0 without one."""
    return image_surface.HEADER.unpack_from(blob, LIGHT_HEADER_SIZE)[-2] if fields[2] == SURFACE_HEADER_SIZE else 0


def unpack(blob):
    """The scene of an image; ToolError names what is wrong, as the loader would."""
    fields = _head(blob)
    width, height, fov, near, far, inset, background, kind = *fields[5:11], *fields[11:13]
    image_lens.check(width, height, fov, near, far, inset)
    centre = _centre(blob, fields)
    start, gait = fields[14:20], fields[20:24]
    check_coordinates(start[:3], "the start")
    _check_gait(gait)
    palette, vertices, corners, faces, models, objects, path, keys, nodes, beams, lit, clusters, turns, motions, \
        motion_keys, light, points, ramp, *surfaces = _tables(blob, fields)
    _check_faces(faces, corners)
    models, extras = _read_models(models, vertices, corners, faces)
    objects = _read_objects(objects, models)
    _check_extents(objects[:len(objects) - len(turns)], models)
    _check_vertices(models)
    _check_radii(models, extras)
    for i, model in enumerate(models):
        for j, face in enumerate(model.faces):
            check_plane(face.normal, [model.vertices[c] for c in face.corners],
                        f"face {j} of model {i}")
    image_keys.check(models, [first for _, first, _ in extras], keys)
    radii = [extras[item.model][0] for item in objects]
    turns = image_turn.read_turns(turns, objects, radii)
    image_cluster.read(models, [first for *_, first in extras], clusters)
    tree = None
    if nodes:
        tree = Tree([Node.unpack(node) for node in nodes], fields[43])
        check_tree(tree, models, objects, len(objects) - len(turns))
    elif fields[43]:
        fail("count", "the header names a BSP instance, but there is no BSP tree")
    beams = [image_beam.unpack(beam, i) for i, beam in enumerate(beams)]
    lit = bytes(lit[0]) if lit else bytes(range(256))
    image_beam.check(beams, models)
    motions = image_turn.read_motions(motions, motion_keys, radii)
    light = image_light.read(light, points, ramp)
    _check_path(kind, path, fields[38])
    surfaces = image_surface.read(surfaces, _blend_first(blob, fields), models)
    return SceneImage(width, height, fov, near, far, inset, background, palette, models, objects,
                      kind, path, start, gait, tree, beams, lit, centre, turns, motions, light, surfaces,
                      size=fields[3], crc=fields[4])


def load(path):
    """The scene of an image file, which may be longer than the image in it."""
    blob = reading.read_start(path, IMAGE_MAX)
    try:
        return unpack(blob)
    except ToolError as error:
        raise ToolError(f"{path}: {error}") from error
