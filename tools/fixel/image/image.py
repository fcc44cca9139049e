# SPDX-License-Identifier: MIT
"""Scene images: written, read and checked as SPEC.md, section 3, and docs/formats.md, section 1, say."""

from dataclasses import dataclass, field
import zlib

from fixel.base import reading
from fixel.image import (image_beam, image_billboard, image_cluster, image_header, image_horizon, image_light, image_lines, image_models,
                         image_placement, image_surface, image_tables)
from fixel.base.errors import ToolError
from fixel.image.fields import HEAD, IMAGE_MAX, MAGIC, VERSION
from fixel.image.image_header import POSES, STRIDES
from fixel.image.image_models import (CONVEX, FACE_VERTICES_MAX, Face, Model, Object, PLACED_MAX, PLANARITY_MAX, check_coordinates,
                                      check_plane, check_planes, radius_of)
from fixel.image.image_tree import COORDINATE_MAX, NORMAL_SQUARE_MAX_ERROR, Node, RADIUS_MAX, SORTED, TooLarge, Tree, check_tree, fail

# What the tools name as image.X, of the modules that an image is made of.
__all__ = ["CONVEX", "COORDINATE_MAX", "FACE_VERTICES_MAX", "Face", "IMAGE_MAX", "KEYS", "Model", "NORMAL_SQUARE_MAX_ERROR",
           "Object", "PLACED_MAX", "PLANARITY_MAX", "POSES", "RADIUS_MAX", "SORTED", "STRIDES", "SceneImage", "TooLarge",
           "check_coordinates", "check_plane", "load", "pack", "radius_of", "unpack"]

GAIT_MAX, TURN_MAX = 256 << 16, 1 << 30
KEYS = {"forward": 1, "back": 2, "left": 4, "right": 8,
        "pitch_up": 16, "pitch_down": 32, "roll_left": 64, "roll_right": 128}


# place pixel-format: the target of a scene
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
    scale: int = 0                      # pixels a world unit in 16.16: the lens is orthographic; 0: it has an eye
    placements: list = field(default_factory=list)  # of the last objects
    motions: list = field(default_factory=list)     # of the last of those
    light: image_light.Light = None                 # at run time
    horizon: image_horizon.Horizon = None           # in the place of the background
    surfaces: image_surface.Surfaces = None
    billboards: image_billboard.Billboards = None
    depth_bits: int = 0         # of the depth buffer that the scene asks for: 0, 16 or 32
    pixel_bits: int = 8         # 8: the palette; 16: RGB565
    by_distance: bool = False   # though it has a tree
    dark: int = 0               # what light leaves in RGB565 frames
    layers: str = field(default="none", compare=False)  # those that are to have a tree, as a scene file says
    moving: tuple = field(default=(), compare=False)    # objects that a tree leaves out
    names: list = field(default_factory=list, compare=False)    # of the objects, in turn; None: it has none
    reserved: int = field(default=0, compare=False)     # last entries of the palette, which no face has
    size: int = field(default=0, compare=False)
    crc: int = field(default=0, compare=False)
    unknown: list = field(default_factory=list, compare=False)  # kinds of sections that these tools do not know

    @property
    def frames(self):
        return len(self.path) if self.path_kind == POSES else sum(n for _, n in self.path)


# place field: pack, unpack, check
def pack(image):
    """The bytes of an image. Checks the result, so that nothing is written
    that a loader would refuse."""
    tables = {"palette": [image_tables.PALETTE.pack(*entry) for entry in image.palette],
              "objects": [image_models.OBJECT.pack(*item.centre, item.model, item.layer, 0) for item in image.objects]}
    kind, entry = ("poses", image_tables.POSE) if image.path_kind == POSES else ("strides", image_tables.STRIDE)
    tables[kind] = [entry.pack(*one) for one in image.path]
    tables |= image_models.tables(image.models, image_models.has_keys(image)) | image_placement.tables(image.placements, image.motions)
    tables |= image_surface.tables(image.surfaces, image.models) | image_billboard.tables(image.billboards) | image_lines.tables(image.models)
    tables["nodes"] = [node.pack() for node in image.tree.nodes] if image.tree else []
    tables["beams"] = [beam.pack() for beam in image.beams]
    tables["lit"] = bytes(image.lit) if image.beams else b""
    tables |= image.light.tables() if image.light else {}
    tables["centre of the lens"] = [image_header.CENTRE.pack(*image.centre)] if image.centre else []
    tables["scale of the lens"] = [image_header.SCALE.pack(image.scale)] if image.scale else []
    tables |= image_horizon.tables(image.horizon)
    count, body = image_tables.pack(tables)
    size = HEAD.size + len(body)
    if size > IMAGE_MAX:
        raise TooLarge(f"size: the scene needs {size:,} bytes, and an image holds at most {IMAGE_MAX:,}; "
                       "use fewer or smaller models, models of fewer faces (--simplify), or a shorter path")
    values = {"magic": MAGIC, "version": VERSION, "section_count": count, "image_size": size, "crc": 0, "width": image.width,
              "height": image.height, "fov": image.fov, "near_z": image.near, "far_z": image.far, "inset": image.inset,
              "background": image.background, "target": image_header.target(image), "dark": image.dark, "start": image.start[:3],
              "start.yaw": image.start[3:], "acceleration": image.gait[:3], "turn": image.gait[3], "frame_count": image.frames,
              "bsp_instance": image.tree.object if image.tree else 0,
              "blend_first": image.surfaces.blend_first if image.surfaces and image.surfaces.blend else 0}
    crc = zlib.crc32(image_header.pack(values)[16:] + body)
    blob = image_header.pack({**values, "crc": crc}) + body
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


def _centre(head, tables):
    """The centre of a lens that is off-centre; else None."""
    if not tables["centre of the lens"]:
        return None
    (centre,) = tables["centre of the lens"]
    image_header.check_centre(head.width, head.height, head.fov, head.inset, centre)
    if centre == image_header.middle(head.width, head.height):
        fail("reserved", "the image gives the middle of the screen as the centre of its lens")
    return centre


def _scale(head, tables):
    """The scale of an orthographic lens; 0: the lens has an eye."""
    if not tables["scale of the lens"]:
        return 0
    ((scale,),) = tables["scale of the lens"]
    image_header.check_scale(scale, head.inset)
    return scale


def _tree(head, nodes, models, objects, unturned):
    """The BSP tree; None where there is none."""
    if not nodes:
        return None
    tree = Tree([Node.unpack(node) for node in nodes], head.bsp_instance)
    check_tree(tree, models, objects, unturned)
    return tree


def unpack(blob):
    """The scene of an image; ToolError names what is wrong, as the loader would."""
    head = image_header.read(blob)
    tables, unknown = image_tables.read(blob, head)
    image_header.check_lens(head.width, head.height, head.fov, head.near_z, head.far_z, head.inset)
    centre = _centre(head, tables)
    check_coordinates(head.start, "the start")
    gait = (*head.acceleration, head.turn)
    _check_gait(gait)
    image_models.check_faces(tables["faces"], tables["corners"], tables["wholes"])
    models, extras = image_models.read_models(tables["models"], tables["vertices"], tables["corners"], tables["faces"],
                                              tables["wholes"])
    objects = image_models.read_objects(tables["objects"], models)
    unturned = len(objects) - len(tables["placements"])
    image_models.check_extents(objects[:unturned], models)
    image_models.check_vertices(models)
    image_models.check_radii(models, extras)
    for i, model in enumerate(models):
        check_planes(model, i)
    image_models.check_keys(models, [first for _, first, _ in extras], tables["keys"])
    radii = [extras[item.model][0] for item in objects]
    placements = image_placement.read_placements(tables["placements"], objects, radii)
    image_cluster.read(models, [first for *_, first in extras], tables["clusters"])
    tree = _tree(head, tables["nodes"], models, objects, unturned)
    beams = [image_beam.unpack(beam, i) for i, beam in enumerate(tables["beams"])]
    lit = bytes(tables["lit"][0]) if tables["lit"] else bytes(range(256))
    image_beam.check(beams, models)
    motions = image_placement.read_motions(tables["motions"], tables["motion keys"], radii)
    light = image_light.read(tables["light"], tables["point lights"], tables["levels"])
    kind = POSES if tables["poses"] else STRIDES
    path = tables["poses"] or tables["strides"]
    _check_path(kind, path, head.frame_count)
    pixel_bits = 16 if head.target & image_header.RGB565 else 8
    surfaces = image_surface.read(tables, head.blend_first, models, pixel_bits)
    billboards = image_billboard.read(tables, models, [radius for radius, *_ in extras])
    image_lines.read(tables, models)
    return SceneImage(head.width, head.height, head.fov, head.near_z, head.far_z, head.inset, head.background,
                      tables["palette"], models, objects, kind, path, (*head.start, *head.start_yaw), gait, tree, beams, lit,
                      centre, _scale(head, tables), placements, motions, light, image_horizon.read(tables), surfaces, billboards, image_header.DEPTHS[head.target % image_header.RGB565],
                      pixel_bits, bool(head.target & image_header.BY_DISTANCE), head.dark,
                      size=head.image_size, crc=head.crc, unknown=unknown)


def load(path):
    """The scene of an image file, which may be longer than the image in it."""
    blob = reading.read_start(path, IMAGE_MAX)
    try:
        return unpack(blob)
    except ToolError as error:
        raise ToolError(f"{path}: {error}") from error
