# SPDX-License-Identifier: MIT
# place field: the field
"""The fields of a scene image, stated once (docs/formats.md, section 1).

The tools pack and read an image by this table. `fixel formats` writes of it what the library knows of an image
(lib/scene/scene_sections.h, lib/paint/surface_sections.h) and the tables of docs/formats.md.
"""

import re
import struct
from dataclasses import dataclass
from functools import cached_property

MAGIC = b"FXLS"
VERSION = 9         # CONTRIBUTING.md says when it rises
IMAGE_MAX = 16 << 20
CORNERS_MAX = 3 * 65_535
WORDS = {"B": "u8", "H": "u16", "i": "i32", "I": "u32", "q": "i64", "s": "u8"}
ENTRY = struct.Struct("<HBBII")     # of the table of sections: kind, is_needed, reserved, offset, count


@dataclass(frozen=True)
class Field:
    """Numbers of one type: format is one of struct, as "3i"; member is the first that holds them in the record of C."""
    format: str
    member: str
    words: str

    @property
    def size(self):
        """In bytes."""
        return struct.calcsize("<" + self.format)

    @property
    def type(self):
        """As docs/formats.md has it: i32 × 3."""
        count, letter = re.fullmatch(r"(\d*)(.)", self.format).groups()
        return WORDS[letter] + (f" × {count}" if count else "")


@dataclass(frozen=True)
class Section:
    """A kind of table: `least` to `most` entries. needed: a reader that does not know it must not draw the scene without.
    limit: the name of `most` in C. record: that of an entry in C. room: whose records they are."""
    name: str
    what: str               # what a fault of the library names
    fields: tuple
    most: int
    least: int = 1
    needed: bool = True
    limit: str = ""
    record: str = ""
    room: str = "scene"
    repeats: int = 1        # how often an entry has the fields from `again` on
    again: int = 0
    note: str = ""          # behind the entry's fields in docs/formats.md
    documented: str = ""    # its name there, where that is another

    @cached_property
    def entry(self):
        """The Struct of an entry."""
        formats = [field.format for field in self.fields]
        return struct.Struct("<" + "".join(formats[:self.again] + formats[self.again:] * self.repeats))

    @property
    def title(self):
        """Its name in documents."""
        return self.documented or self.name

    @property
    def enum(self):
        """Its name in C."""
        return "SECTION_" + self.title.upper().replace(" ", "_")


# place pixel-format: target in the image's header
HEADER = (
    Field("4s", "magic", "magic: the bytes `F X L S`"),
    Field("H", "version", f"version, {VERSION}"),
    Field("H", "section_count", "number of sections"),
    Field("I", "image_size", "image size in bytes, a multiple of four, ≤ 16 MiB"),
    Field("I", "crc", "CRC-32 (IEEE 802.3, as zlib's crc32) of bytes 16 .. image size − 1"),
    Field("H", "width", "width"),
    Field("H", "height", "height"),
    Field("I", "fov", "field of view, binary angle"),
    Field("i", "near_z", "near (16.16)"),
    Field("i", "far_z", "far (16.16)"),
    Field("i", "inset", "inset (16.16)"),
    Field("B", "background", "background colour"),
    Field("B", "target", "what the scene asks for: depth buffer (0 none, 1 of 16 bits, 2 of 32), + 4 for RGB565, "
                         "+ 8 to be drawn by distance though it has a tree"),
    Field("H", "dark", "what light leaves in RGB565 frames, a colour of RGB565"),
    Field("3i", "start", "start pose: position"),
    Field("3I", "start.yaw", "yaw, pitch, roll of the start pose"),
    Field("3i", "acceleration", "motion limits: acceleration, friction, top speed"),
    Field("I", "turn", "motion limits: turn"),
    Field("I", "frame_count", "frames of the path: the number of poses, or the sum of the segments' frames"),
    Field("I", "bsp_instance", "number of the BSP instance, over whose faces the tree is; 0 if there is no tree"),
    Field("I", "blend_first", "first colour of the blend table; 0 if there is none"),
)
HEAD = struct.Struct("<" + "".join(field.format for field in HEADER))

# place light: a new setting: the section of light
SECTIONS = (
    Section("palette", "palette table", (Field("3B", "", "red, green, blue"),), 256, 256),
    Section("vertices", "vertex table", (Field("3i", "x", "x, y, z (16.16, relative to the centre of the instance)"),),
            1_000_000, limit="FXL_SCENE_VERTICES_MAX", record="fxl_point"),
    Section("corners", "index table", (Field("H", "", "number of a vertex within the model"),),
            4_000_000, limit="FXL_SCENE_INDICES_MAX", documented="indices"),
    Section("faces", "face table", (
        Field("3i", "normal", "normal (2.30)"),
        Field("B", "count", "count"), Field("B", "material", "colour"),
        Field("3H", "indices", "the indices of a triangle; of another face its first one, then the number of that, low half first")),
            1_000_000, limit="FXL_SCENE_FACES_MAX", record="fxl_face"),
    Section("models", "model table", (
        Field("4I", "first_vertex", "first vertex, vertex count, first face, face count"),
        Field("B", "kind", "kind (0 convex, 1 sorted)"), Field("B", "reserved", "reserved"),
        Field("H", "first_cluster", "first cluster, counted from 1 (0: none)"), Field("i", "radius", "radius (16.16)"),
        Field("I", "first_face_bounds", "first face bounds")),
            65_535, limit="FXL_SCENE_MODELS_MAX", record="fxl_model"),
    Section("objects", "instance table", (
        Field("3i", "centre", "centre (16.16)"), Field("H", "model", "model"), Field("B", "layer", "layer"),
        Field("B", "recolour", "recolour (0)")),
            65_535, limit="FXL_SCENE_INSTANCES_MAX", record="fxl_instance", documented="instances"),
    Section("poses", "path table", (Field("3i", "position", "position"), Field("3I", "yaw", "yaw, pitch, roll")),
            1_000_000, limit="FXL_SCENE_PATH_MAX", record="fxl_pose"),
    Section("strides", "path table", (Field("H", "keys", "keys"), Field("H", "frames", "frames (≥ 1)")),
            1_000_000, limit="FXL_SCENE_PATH_MAX", record="fxl_path_segment", documented="segments"),
    Section("keys", "face bounds table", (
        Field("q", "height_low", "height (18.46), low word first"), Field("3i", "box_x", "box (16.16)")),
            1_000_000, needed=False, limit="FXL_SCENE_FACES_MAX", record="fxl_face_bounds", documented="face bounds"),
    Section("nodes", "BSP node table", (
        Field("3i", "normal", "normal (2.30)"), Field("q", "distance_low", "distance (18.46), low word first"),
        Field("5H", "front", "front, back, parent (65,535: none), first face, face count"),
        Field("H", "reserved", "reserved"), Field("3i", "centre", "centre (16.16)"), Field("i", "radius", "radius (16.16)")),
            65_535, limit="FXL_BSP_NODES_MAX", record="fxl_bsp_node", documented="BSP nodes"),
    Section("beams", "beam table", (
        Field("3i", "from", "light (16.16), or direction (2.30)"), Field("B", "kind", "kind (0 point, 1 direction)"),
        Field("B", "plane_count", "planes"), Field("H", "reserved", "reserved"),
        Field("3i", "planes", "normal (2.30) of a plane"),
        Field("q", "planes[0].distance_low", "distance of a plane (18.46), low word first")),
            4, limit="FXL_BEAMS_MAX", record="fxl_beam", repeats=8, again=4,
            note="the last two fields for each of eight planes; a plane that the beam does not have is 0"),
    Section("lit", "lit table", (Field("256B", "", "for each palette entry the colour that is drawn instead of it where it is lit"),),
            1, documented="lit colours"),
    Section("clusters", "cluster table", (
        Field("3i", "centre", "centre (16.16)"), Field("i", "radius", "radius (16.16)"), Field("3i", "axis", "axis (2.30)"),
        Field("I", "cutoff", "cutoff (0.32)"), Field("3i", "apex", "apex (16.16)"), Field("H", "face_count", "face count"),
        Field("H", "reserved", "reserved")),
            65_535, limit="FXL_SCENE_CLUSTERS_MAX", record="fxl_cluster"),
    Section("placements", "placement table", (
        Field("9i", "", "orientation (2.30), row by row"), Field("i", "scale", "scale (16.16)")),
            65_535, limit="FXL_SCENE_INSTANCES_MAX", record="fxl_placement"),
    Section("motions", "motion table", (
        Field("3I", "yaw_step", "steps of yaw, pitch, roll"), Field("3i", "axis", "axis"),
        Field("2I", "spin", "spin, its step"), Field("i", "radius", "radius (16.16)"),
        Field("2I", "circle", "circle, its step"), Field("3i", "extent", "extent (16.16)"),
        Field("2i", "scale_low", "least scale, largest scale (16.16)"), Field("2I", "first_key", "first key, key count"),
        Field("H", "parent", "parent, counted from 1 (0: none)"), Field("B", "repeats", "repeats (0, 1)"),
        Field("B", "reserved", "reserved")),
            65_535, limit="FXL_SCENE_INSTANCES_MAX", record="fxl_motion"),
    Section("motion keys", "motion key table", (
        Field("I", "frame", "frame"), Field("3i", "centre", "centre (16.16)"), Field("3I", "yaw", "yaw, pitch, roll"),
        Field("i", "scale", "scale (16.16)")),
            1_000_000, limit="FXL_MOTION_KEYS_MAX", record="fxl_motion_key", documented="keys of motions"),
    Section("light", "light table", (
        Field("2i", "ambient", "ambient, strength (2.30)"), Field("3i", "direction", "direction (2.30)"),
        Field("2i", "fog_near", "fog near, fog far (16.16)")),
            1, record="fxl_light_base"),
    Section("point lights", "point light table", (
        Field("3i", "position", "position (16.16)"), Field("i", "range", "range (16.16)"),
        Field("i", "strength", "strength (2.30)")),
            4, limit="FXL_LIGHT_POINTS_MAX", record="fxl_point_light"),
    Section("levels", "ramp", (Field("256B", "", "of a level: for each palette entry the one that is drawn instead of it"),),
            64, 2, limit="FXL_LIGHT_LEVELS_MAX", documented="ramp"),
    Section("textures", "texture table", (
        Field("I", "texels", "place of the first texel, counted from the first byte of the texels"),
        Field("I", "colours", "place of the 16 colours, counted so (0 but for 4 bits a texel)"),
        Field("2B", "log_width", "log2 of the width, of the height"),
        Field("B", "format", "format (0: 8 bits a texel, 1: 4 bits, 2: RGB565, a u16 a texel)"),
        Field("B", "flags", "flags (1 clamped, 2 keyed)"), Field("2B", "key", "key (0 for RGB565), levels"),
        Field("H", "key_565", "key of a texture of RGB565 (0 for others)")),
            65_535, limit="FXL_SCENE_TABLE_MAX", record="fxl_scene_texture"),
    Section("texels", "texel table", (Field("B", "", "the texels of all levels of a texture, or 16 colours"),), IMAGE_MAX,
            limit="FXL_SCENE_IMAGE_MAX"),
    Section("surfaces", "surface table", (
        Field("H", "texture", "texture, counted from 1 (0: the face's own colour)"),
        Field("B", "division", "division (0 every 16 columns, 1 every 8, 2 each, 3 affine)"),
        Field("B", "flags", "flags (1 lit, 2 blended, 4 added; not both of these two; 8 colours at corners)"), Field("B", "opacity", "opacity (1..16)"),
        Field("B", "sixteenths", "what a blended colour shows of itself in RGB565, in sixteenths (1..16; 0: 8)"),
        Field("2B", "reserved", "reserved"), Field("I", "first_corner", "corner from which its faces count theirs")),
            65_535, limit="FXL_SCENE_TABLE_MAX", record="fxl_surface", room="paint"),
    Section("mapped faces", "mapped face table", (
        Field("H", "surface", "surface"), Field("3H", "corners", "three corners, counted from the surface's first one")),
            65_535, limit="FXL_SCENE_TABLE_MAX", record="fxl_mapped_face", room="paint"),
    Section("mapped corners", "corner table", (
        Field("2i", "texel", "u, v (16.16); of colours at corners 65536 red + 256 green + blue, and 0"),
        Field("H", "vertex", "number of a vertex within the model"), Field("H", "normal", "normal (0 where the surface is not lit)")),
            CORNERS_MAX, limit="FXL_SCENE_CORNERS_MAX", record="fxl_corner", room="paint", documented="corners"),
    Section("face map", "face map", (Field("H", "", "mapped face, counted from 1; 0: the face has no surface"),),
            1_000_000, limit="FXL_SCENE_FACES_MAX"),
    Section("normals of corners", "corner normal table", (Field("3i", "x", "normal (2.30)"),), 65_535,
            limit="FXL_SCENE_TABLE_MAX", record="fxl_direction"),
    Section("blend table", "blend table", (Field("256B", "", "of a colour: for each palette entry what the colour shows over it"),), 256),
    Section("billboards", "billboard table", (
        Field("I", "pixels", "place of the first pixel, counted from the first byte of the sprite pixels"),
        Field("I", "colours", "place of the 2 or 16 colours, counted so (0 for 8 bits a pixel)"),
        Field("2H", "pixel_width", "width, height in pixels"), Field("H", "key", "key (256: all pixels are drawn)"),
        Field("B", "bits", "bits a pixel (1, 4, 8)"), Field("B", "reserved", "reserved"),
        Field("4i", "width", "width, height, anchor x, anchor y (16.16)")),
            65_535, limit="FXL_SCENE_TABLE_MAX", record="fxl_scene_billboard"),
    Section("billboard map", "billboard map", (Field("H", "", "billboard, counted from 1; 0: the model shows its faces"),),
            65_535, limit="FXL_SCENE_MODELS_MAX"),
    Section("sprite pixels", "sprite pixels", (
        Field("B", "", "the pixels of a sprite, row by row, the leftmost in the highest bits, each row from a whole byte on; "
                       "or its colours"),), IMAGE_MAX, limit="FXL_SCENE_IMAGE_MAX"),
    Section("centre of the lens", "lens centre", (
        Field("2i", "x", "x, y in 16.16 pixels from the upper left corner of the screen, y down"),), 1, record="fxl_image_centre", documented="lens centre"),
    Section("wholes", "whole face table", (
        Field("I", "", "32 × number of the first index of the whole face that the face is a part of, + its count (3..24); "
                       "0: it is no part"),),
            1_000_000, limit="FXL_SCENE_FACES_MAX", documented="whole faces"),
    Section("scale of the lens", "lens scale", (Field("i", "scale", "pixels a world unit (16.16): the lens is orthographic"),), 1,
            record="fxl_image_scale", documented="lens scale"),
    Section("lines", "line table", (
        Field("2H", "from", "the vertices of both ends within the model; of a point the same one twice"),
        Field("2H", "faces", "two faces of the model on which the line lies, counted from 1 (0: none)"),
        Field("B", "colour", "colour"), Field("B", "width", "width in pixels (1..16)"), Field("H", "reserved", "reserved")),
            1_000_000, limit="FXL_SCENE_FACES_MAX", record="fxl_line"),
    Section("line map", "line map", (Field("I", "", "number of the first line of a model; behind those of all models the number of lines"),),
            65_536, 2),
    Section("horizon", "horizon", (Field("i", "", "sine of an elevation (2.30), ascending"),), 64, limit="FXL_HORIZON_MAX", documented="horizon sines"),
    Section("horizon colours", "horizon colours", (Field("B", "", "colour of a level, that of the nadir first; one more than sines"),), 65, 2),
)
KINDS = {section.name: number for number, section in enumerate(SECTIONS, 1)}
ALWAYS = ("palette", "vertices", "models", "objects")
# Sections that go together: where one of the first list is, each of the second must be.
TOGETHER = (
    (("beams", "lit"), ("beams", "lit")),
    (("motions", "motion keys"), ("placements", "motions", "motion keys")),
    (("light", "point lights", "levels"), ("light", "levels")),
    (("textures", "texels", "surfaces", "mapped faces", "face map", "normals of corners", "blend table",
      "mapped corners"),
     ("surfaces", "mapped faces", "face map", "mapped corners")),
    (("billboards", "billboard map", "sprite pixels"), ("billboards", "billboard map", "sprite pixels")),
    (("lines", "line map"), ("lines", "line map")),
    (("horizon", "horizon colours"), ("horizon", "horizon colours")),
)


def entry(name):
    """The Struct of an entry of a section."""
    return SECTIONS[KINDS[name] - 1].entry
