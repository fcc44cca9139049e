# SPDX-License-Identifier: MIT
"""Scene images: written, read and checked as SPEC.md, section 3, and docs/formats.md, section 1, say."""

from dataclasses import dataclass, field
import zlib

from fixel.base import reading
from fixel.image import (image_beam, image_billboard, image_cluster, image_header, image_keys, image_lens,
                         image_light, image_models, image_surface, image_tables, image_turn)
from fixel.base.errors import ToolError
from fixel.image.image_header import HEADER_SIZE, IMAGE_MAX, POSES, STRIDES
from fixel.image.image_models import (CONVEX, FACE_VERTICES_MAX, PLACED_MAX, PLANARITY_MAX, Face, Model, Object,
                                check_coordinates, check_plane, check_planes, radius_of)
from fixel.image.image_tree import COORDINATE_MAX, NORMAL_SQUARE_MAX_ERROR, RADIUS_MAX, SORTED, Node, Tree, check_tree, fail

# What the tools name as image.X, of the modules that an image is made of.
__all__ = ["CONVEX", "COORDINATE_MAX", "FACE_VERTICES_MAX", "Face", "IMAGE_MAX", "KEYS", "Model", "NORMAL_SQUARE_MAX_ERROR",
           "Object", "PLACED_MAX", "PLANARITY_MAX", "POSES", "RADIUS_MAX", "SORTED", "STRIDES", "SceneImage",
           "check_coordinates", "check_plane", "load", "pack", "radius_of", "unpack"]

GAIT_MAX, TURN_MAX = 256 << 16, 1 << 30
KEYS = {"forward": 1, "back": 2, "left": 4, "right": 8,
        "pitch_up": 16, "pitch_down": 32, "roll_left": 64, "roll_right": 128}


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
    billboards: image_billboard.Billboards = None
    visibility: int = image_header.BY_DEFAULT
    layers: str = field(default="none", compare=False)  # those that are to have a tree, as a scene file says
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


def pack(image):
    """The bytes of an image. Checks the result, so that nothing is written
    that a loader would refuse."""
    path_entry = image_tables.POSE if image.path_kind == POSES else image_tables.STRIDE
    model_tables, keys, clusters = image_models.tables(image.models)
    nodes = [node.pack() for node in image.tree.nodes] if image.tree else []
    beams = [beam.pack() for beam in image.beams]
    turns, motions, motion_keys = image_turn.tables(image.turns, image.motions)
    light = image.light.tables() if image.light else [[], [], []]
    surfaces = image_surface.tables(image.surfaces, image.models)
    version, header_size = image_header.kind_of(nodes, beams, clusters, turns, light[0], image.surfaces,
                                                image.billboards)
    body, where = image_lens.CENTRE.pack(*image.centre) if image.centre else b"", []

    def place(table, size=1):
        """Puts a table at the end of the body: packed entries, or all of them in one, each of this size. Answers its offset
        and count, both 0 for none."""
        nonlocal body
        offset = header_size + len(body) if table else 0
        body += _aligned(table if isinstance(table, bytes) else b"".join(table))
        return [offset, len(table) // size]

    for table in [[image_tables.PALETTE.pack(*entry) for entry in image.palette], *model_tables,
                  [image_models.OBJECT.pack(*item.centre, item.model, item.layer, 0) for item in image.objects],
                  [path_entry.pack(*entry) for entry in image.path]]:
        where += place(table, image_models.CORNER.size if isinstance(table, bytes) else 1)
    where_more = place(keys) + place(nodes)
    more = image_beam.LIT_HEADER.pack(*place(beams), place([bytes(image.lit)] if beams else [])[0], 0)
    more += image_cluster.HEADER.pack(*place(clusters))
    more += image_turn.HEADER.pack(*place(turns), *place(motions), *place(motion_keys))
    more += image_light.HEADER.pack(*(number for table in light for number in place(table)))
    more += image_surface.HEADER.pack(*(number for table in surfaces for number in place(table)),
                                      image.surfaces.blend_first if image.surfaces else 0, 0)
    more += image_billboard.HEADER.pack(*(number for table in image_billboard.tables(image.billboards)
                                          for number in place(table)))
    more = more[:header_size - HEADER_SIZE]
    size = header_size + len(body)
    if size > IMAGE_MAX:
        fail("size", f"the scene needs {size:,} bytes, and an image holds at most {IMAGE_MAX:,}; "
             "use fewer or smaller models or a shorter path")

    def head(crc):
        return image_header.HEAD.pack(image_header.MAGIC, version, header_size, size, crc, image.width, image.height,
                          image.fov, image.near, image.far, image.inset, image.background,
                          image.path_kind, int(image.centre is not None) | image.visibility << 8, *image.start, *image.gait, *where, image.frames,
                          *where_more, image.tree.object if nodes else 0)

    blob = head(zlib.crc32(head(0)[16:] + more + body)) + more + body
    unpack(blob)
    return blob


def _check_gait(gait):
    if any(not 0 <= value <= GAIT_MAX for value in gait[:3]) or not 0 <= gait[3] <= TURN_MAX:
        fail("range", "the motion limits are out of range (0..256 units a step, at most 1/4 turn a step)")


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
    if not image_header.has_centre(fields):
        return None
    width, height, fov, inset = fields[5], fields[6], fields[7], fields[10]
    centre = image_lens.CENTRE.unpack_from(blob, fields[2])
    image_lens.check_centre(width, height, fov, inset, centre)
    if centre == image_lens.middle(width, height):
        fail("reserved", "the image gives the middle of the screen as the centre of its lens")
    return centre


def unpack(blob):
    """The scene of an image; ToolError names what is wrong, as the loader would."""
    fields = image_header.read(blob)
    width, height, fov, near, far, inset, background, kind = *fields[5:11], *fields[11:13]
    image_lens.check(width, height, fov, near, far, inset)
    centre = _centre(blob, fields)
    start, gait = fields[14:20], fields[20:24]
    check_coordinates(start[:3], "the start")
    _check_gait(gait)
    palette, vertices, corners, faces, models, objects, path, keys, nodes, beams, lit, clusters, turns, motions, \
        motion_keys, light, points, ramp, *looks = image_tables.read(blob, fields)
    image_models.check_faces(faces, corners)
    models, extras = image_models.read_models(models, vertices, corners, faces)
    objects = image_models.read_objects(objects, models)
    image_models.check_extents(objects[:len(objects) - len(turns)], models)
    image_models.check_vertices(models)
    image_models.check_radii(models, extras)
    for i, model in enumerate(models):
        check_planes(model, i)
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
    surfaces = image_surface.read(looks[:len(image_surface.TABLES)], image_header.blend_first(blob, fields), models)
    billboards = image_billboard.read(looks[len(image_surface.TABLES):], models, [radius for radius, *_ in extras])
    return SceneImage(width, height, fov, near, far, inset, background, palette, models, objects,
                      kind, path, start, gait, tree, beams, lit, centre, turns, motions, light, surfaces, billboards,
                      image_header.visibility(fields), size=fields[3], crc=fields[4])


def load(path):
    """The scene of an image file, which may be longer than the image in it."""
    blob = reading.read_start(path, IMAGE_MAX)
    try:
        return unpack(blob)
    except ToolError as error:
        raise ToolError(f"{path}: {error}") from error
