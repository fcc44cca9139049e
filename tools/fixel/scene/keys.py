# SPDX-License-Identifier: MIT
"""The keys of scene files, of each table: what value a key may have, and what it is where it is not said. The readers of scenes take their
ranges and defaults from here, docs/scenes.md its columns of values and defaults (`fixel formats`), and the tests of refusals and the
fuzzer their values. What a key means says docs/scenes.md."""

from fractions import Fraction

from fixel.image import image, image_beam, image_billboard, image_header, image_horizon, image_light, image_lines, image_placement, image_surface
from fixel.model import simplify, solids
from fixel.model.mesh import FILE_FACES_MAX
from fixel.model.quantity import COORDINATE_MAX
from fixel.scene import palette, parts, surfaces, texture
from fixel.scene.toml_table import Degrees, Key, MANY, Number, OneOf, REQUIRED, Read, Several, Sub, SWITCH, Text, Whole

FRAMES_MAX = 1_000_000      # of a path
REACH = 2 * COORDINATE_MAX  # world units from one end of the world to the other
SMALL = Fraction(1, 256)
ZEROS = (Fraction(0),) * 3

ANY, ANGLE = Number(), Degrees()
COLOUR = Read(palette.parse, "a colour", ("red", "#123456"), ("crimsn", "#12345", 3, []))
COLOURS = Several(COLOUR, (1, 255))
NAME, FILE, NAMES = Text("a name"), Text("a file"), Several(Text("a name"), (1, MANY), lone=True)
VECTOR = Several(ANY, 3, "[x, y, z]")
POSITION = Several(Number(-COORDINATE_MAX, COORDINATE_MAX, "world units"), 3, "[x, y, z]")
TURN = Several(ANGLE, 3, "[yaw, pitch, roll]", lone=True)
PATTERN = OneOf(tuple(texture.PATTERNS))
LEVELS = Whole(1, image_surface.LEVELS_MAX)
TEXEL_BITS = OneOf((8, 4, 16))
ANGLES = {"yaw": Key(ANGLE, Fraction(0)), "pitch": Key(ANGLE, Fraction(0)), "roll": Key(ANGLE, Fraction(0))}


def rows(keys, most=MANY):
    """A list of tables."""
    return Several(Sub(keys), (1, most))


# place key: its row: the kind of its value, its default; the module that reads its table stands above it
# toml_scene.py, and path.py
SCREEN = {"width": Key(Whole(1, image_header.SCREEN_MAX), 320), "height": Key(Whole(1, image_header.SCREEN_MAX), 240)}
# place pixel-format: pixels of [view]
VIEW = {
    "fov": Key(Degrees(10, 150, "degrees"), Fraction(75)),
    "focal": Key(Number(Fraction(1, 1000), 10000, "pixels")),
    "scale": Key(Number(Fraction(1, 16), 4096, "pixels a world unit"), None, "none: the lens has an eye"),
    "centre": Key(Several(Number(-4096, 4096, "pixels"), 2, "[x, y]"), None, "the middle of the screen"),
    "near": Key(Number(SMALL, 32767, "world units"), Fraction(1, 4)),
    "far": Key(Number(SMALL, 32767, "world units"), Fraction(256)),
    "inset": Key(Number(0, 1, "world units"), Fraction(0)),
    "depth": Key(OneOf(tuple(image_header.DEPTHS)), 0),
    "pixels": Key(OneOf(("palette", "rgb565")), "palette"),
    "order": Key(OneOf(("distance", "tree")), None, "by the tree if there is one"),
    "visibility": Key(OneOf(("default", "depth")), "default")}
GLOW = {"strength": Key(Number(0, 16), Fraction(3, 2)), "colour": Key(COLOUR, (255, 240, 200), '`"#fff0c8"`')}
PALETTE = {
    "reserve": Key(Whole(0, palette.ENTRIES - 1), None, "the number of `palette.colours`"),
    "colours": Key(COLOURS, ()),
    "blend": Key(Whole(1, 16), 8)}
HORIZON = {
    "degrees": Key(Several(Number(-90, 90, "degrees"), (1, image_horizon.LEVELS_MAX)), REQUIRED),
    "colours": Key(Several(COLOUR, (2, image_horizon.LEVELS_MAX + 1)), REQUIRED)}
BEAM = {
    "direction": Key(VECTOR, None, "one of"), "position": Key(POSITION, None, "these two"),
    "window": Key(Several(POSITION, (3, image_beam.PLANES_MAX - 1)), REQUIRED)}
PATH_KEY = {"position": Key(POSITION, REQUIRED), **ANGLES, "look_at": Key(POSITION), "frames": Key(Whole(1, FRAMES_MAX), 1)}
STEP = {"keys": Key(Several(OneOf(tuple(image.KEYS)), (0, MANY)), REQUIRED), "frames": Key(Whole(1, 65535), 1)}
ORBIT = {
    "centre": Key(POSITION, ZEROS), "radius": Key(Number(SMALL, REACH, "world units"), REQUIRED),
    "height": Key(Number(-REACH, REACH, "world units"), Fraction(0)), "frames": Key(Whole(1, FRAMES_MAX), 60),
    "start": Key(ANGLE, Fraction(0)), "turns": Key(Number(-100, 100), Fraction(1))}
START = {"position": Key(POSITION, ZEROS), **ANGLES}
STEP_SPEED = Number(0, 256, "units a step")
GAIT = {
    "acceleration": Key(STEP_SPEED, Fraction("0.05")), "friction": Key(STEP_SPEED, Fraction("0.02")),
    "speed_max": Key(STEP_SPEED, Fraction("0.4")), "turn": Key(Degrees(0, 90, "degrees a step"), Fraction(3))}
PATH = {
    "keys": Key(rows(PATH_KEY), None, "one of"), "orbit": Key(Sub(ORBIT), None, "these"), "steps": Key(rows(STEP), None, "three"),
    "interpolation": Key(OneOf(("smooth", "linear")), "smooth"), "start": Key(Sub(START)), "gait": Key(Sub(GAIT))}

# toml_light.py
BAKED = ("colour", "sky", "bake")                       # keys of light that the tool computes alone
AT_RUN_TIME = ("strength", "dark", "points", "fog")     # keys of light at run time alone
# place light: a new setting: its key
POINT = {
    "position": Key(POSITION, REQUIRED), "range": Key(Number(Fraction(1, 65536), COORDINATE_MAX, "world units"), REQUIRED),
    "strength": Key(Number(0, 1), Fraction(1))}
FOG_END = Key(Number(0, image_header.FAR_MAX >> 16, "world units"), REQUIRED)
FOG = {"near": FOG_END, "far": FOG_END}
LIGHT = {
    "direction": Key(VECTOR, (Fraction(-2, 5), Fraction(-1), Fraction(7, 10)), "`[-0.4, -1, 0.7]`"),
    "ambient": Key(Number(0, 1), Fraction(2, 5), "0.4"),
    "colour": Key(COLOUR, (255, 255, 255), '`"white"`'), "sky": Key(COLOUR, (255, 255, 255), '`"white"`'), "bake": Key(SWITCH, False),
    "levels": Key(Whole(image_light.LEVELS_MIN, image_light.LEVELS_MAX), None, "light that the tool computes"),
    "strength": Key(Number(0, 1), None, "1 − `ambient`"),
    "dark": Key(COLOUR, (0, 0, 0), '`"black"`'),
    "points": Key(rows(POINT, image_light.POINTS_MAX)), "fog": Key(Sub(FOG))}

# toml_motion.py
RING = {
    "count": Key(Whole(1, 1000), REQUIRED), "radius": Key(Number(0, REACH, "world units"), REQUIRED),
    "start": Key(ANGLE, Fraction(0)), "turn": Key(SWITCH, True), "turned": Key(SWITCH, False)}
REPEAT = {"count": Key(Several(Whole(1, 1000), 3, "[nx, ny, nz]"), REQUIRED), "step": Key(Several(ANY, 3, "[dx, dy, dz]"), REQUIRED)}
PLACES = {
    "position": Key(POSITION, ZEROS), "positions": Key(Several(POSITION, (1, MANY))), "ring": Key(Sub(RING)), "repeat": Key(Sub(REPEAT))}
SIZE = Key(Number(SMALL, 256), Fraction(1))
SPIN = {"axis": Key(VECTOR), "degrees": Key(ANGLE), "start": Key(ANGLE, Fraction(0)), **ANGLES}
MOTION_KEY = {"frames": Key(Whole(1, image_placement.FRAME_MAX), 1), "offset": Key(VECTOR, ZEROS), "turn": Key(TURN, ZEROS), "size": SIZE}
MOTION = {
    "circle": Key(Number(0, REACH, "world units"), None, "one of"), "by": Key(VECTOR, None, "these"),
    "keys": Key(rows(MOTION_KEY), None, "three"),
    "degrees": Key(ANGLE), "start": Key(ANGLE, Fraction(0)), "facing": Key(SWITCH, False),
    "frames": Key(Whole(1, image_placement.FRAME_MAX // 2)), "back": Key(SWITCH, False), "repeats": Key(SWITCH, True)}
TURNED = {"turn": Key(TURN, ZEROS), "size": SIZE, "spin": Key(Sub(SPIN)), "motion": Key(Sub(MOTION)), "parent": Key(NAME)}

# toml_model.py
SOURCE = "one of `solid`, `model`, `obj`"
MODEL = {
    "obj": Key(FILE, None, SOURCE), "model": Key(FILE, None, SOURCE), "group": Key(NAMES, (), "the whole file"), "without": Key(NAMES, ()),
    "fit": Key(Number(Fraction(1, 1000), REACH, "world units")), "simplify": Key(Whole(simplify.FACES_MIN, FILE_FACES_MAX), None, "its own"),
    "mend": Key(SWITCH, None, "true for glTF, STL and PLY"), "merge": Key(SWITCH, None, "true for glTF, STL and PLY")}

# toml_images.py
IMAGES = {
    "size": Key(OneOf(texture.SIDES), 64), "colours": Key(Whole(1, texture.COLOURS_MAX), None, "32, or 15 of 4 bits"), "levels": Key(LEVELS, 1),
    "bits": Key(TEXEL_BITS, 8)}

# toml_texture.py
TEXTURE = {
    "name": Key(NAME, REQUIRED), "file": Key(FILE, None, "one of"), "pattern": Key(PATTERN, None, "these two"),
    "size": Key(OneOf((*texture.SIDES, "path"), Several(OneOf(texture.SIDES), 2, "[width, height]")), None, "`[32, 32]`; of a file 256"),
    "colours": Key(COLOURS, None, "of its own"), "most_colours": Key(Whole(1, texture.COLOURS_MAX), None, "32, or 15 of 4 bits"),
    "bits": Key(TEXEL_BITS, 8), "wrap": Key(OneOf(("repeat", "clamp")), "repeat"),
    "levels": Key(LEVELS, None, f"{image_surface.LEVELS_MAX} if a `floor` shows it, else 1")}
TEXELS_MAX = 16384          # a world unit
SURFACE = {
    "texture": Key(NAME), "textures": Key(Several(NAME, (1, MANY))), "mapping": Key(OneOf(("box", "file")), "box"),
    "tiles": Key(Several(Number(SMALL, 1024), 2, "[across, down]"), (Fraction(1),) * 2), "texels_per_unit": Key(Number(Fraction(1, 1024), TEXELS_MAX, "texels")),
    "texel_offset": Key(Several(ANY, 2, "[u, v]"), (Fraction(0),) * 2), "division": Key(OneOf(tuple(surfaces.DIVISIONS)), 0, "16"),
    "opacity": Key(Whole(1, 16), 16), "blend": Key(OneOf((True, False, "add")), False),
    "lit": Key(SWITCH, None, "true for textures under such light"), "smooth": Key(OneOf((True, False, "file"), Degrees(1, 180, "degrees")), False),
    "vertex_colours": Key(OneOf((True, False, "none")), False, "false: each face has the mean of its corners' colours"),
    "images": Key(OneOf((True, False), Sub(IMAGES)), False)}

# toml_billboard.py
BILLBOARD = {
    "name": Key(NAME, REQUIRED), "file": Key(FILE, None, "one of"), "pattern": Key(PATTERN, None, "these two"),
    "pixels": Key(Several(Whole(1, texture.SIDE_MAX), 2, "[width, height]"), (32, 32)), "colours": Key(COLOURS, None, "of its own"),
    "key": Key(COLOUR), "most_colours": Key(Whole(1, texture.COLOURS_MAX), None, "32, 15 of 4 bits or 1 of 1 bit"),
    "bits": Key(OneOf(tuple(sorted(image_billboard.BITS, reverse=True))), 8),
    "size": Key(Several(Number(SMALL, COORDINATE_MAX, "world units"), 2, "[width, height]"), REQUIRED),
    "anchor": Key(Several(Number(0, COORDINATE_MAX, "world units"), 2, "[x, y]"), None, "the middle of the lower side")}

# toml_lines.py
LINE_POINTS_MAX = 4096      # of a polyline
STROKE = {"colour": Key(COLOUR, (255, 255, 255), '`"white"`'), "width": Key(Whole(1, image_lines.WIDTH_MAX), 1)}
EDGES = {**STROKE, "angle": Key(Degrees(0, 180, "degrees"), Fraction(1))}
MARK = {**STROKE, "colours": Key(Several(COLOUR, (1, LINE_POINTS_MAX)), None, "`colour` for all"), "on_faces": Key(SWITCH, True)}
POLYLINE = {"at": Key(Several(VECTOR, (2, LINE_POINTS_MAX)), REQUIRED), "closed": Key(SWITCH, False), **MARK}
DOTS = {"at": Key(Several(VECTOR, (1, LINE_POINTS_MAX)), REQUIRED), **MARK}
LINES = {"edges": Key(Sub(EDGES)), "lines": Key(rows(POLYLINE)), "points": Key(rows(DOTS))}

# toml_object.py
QUATERNION_MAX = 1 << 30    # as fxl_orientation_from_quaternion takes it
SCALE_MAX = 1 << 30     # such as of a model in metres whose sides are nanometres
SOLID = {
    "sides": Key(Whole(3, solids.SIDES_MAX)), "rings": Key(Whole(2, solids.SIDES_MAX)), "taper": Key(Number(Fraction(1, 100), 10)),
    "cells": Key(Several(Whole(1, 200), 2, "[across, along]")), "seed": Key(Whole(0, 65535)), "sea": Key(Number(0, Fraction(9, 10)))}
ANY_OBJECT = {"name": Key(NAME), **PLACES, "layer": Key(Whole(0, 255), 0), "moves": Key(SWITCH, False), **TURNED}
OBJECT = {
    **ANY_OBJECT, "solid": Key(OneOf(tuple(solids.SOLIDS)), None, SOURCE), **SOLID, **MODEL, **SURFACE, **LINES,
    "scale": Key(Several(Number(0, SCALE_MAX, above=True), 3, "[x, y, z]", lone=True, fills=True), (Fraction(1),) * 3),
    "rotation": Key(TURN, ZEROS), "quaternion": Key(Several(Number(-QUATERNION_MAX, QUATERNION_MAX), 4, "[w, x, y, z]")), "anchor": Key(OneOf(("origin", "base", "middle", "node")), "origin"),
    "colour": Key(COLOUR, None, "those of the model's materials, else `\"#c8c0b0\"`"), "colours": Key(Several(COLOUR, (1, MANY))),
    "shade": Key(SWITCH, True), "colour_index": Key(Whole(1, 255)), "colour_step": Key(Whole(0, 254), 0), "colour_next": Key(Whole(0, 254), 0),
    "kind": Key(OneOf(("convex", "sorted")), None, "the tool tests the model"),
    "two_sided": Key(OneOf((True, False, "open", "file")), False), "inside": Key(SWITCH, False), "clusters": Key(SWITCH, False),
    "parts": Key(Several(Whole(1, parts.MOST), 2, "[across, along]"))}
SPRITE = {**ANY_OBJECT, "billboard": Key(NAME)}     # an object that shows a billboard

TOP = {
    "background": Key(COLOUR, (16, 24, 32), '`"#101820"`'), "tree": Key(Text("layers"), "none"),
    "screen": Key(Sub(SCREEN)), "view": Key(Sub(VIEW)), "light": Key(Sub(LIGHT)), "glow": Key(Sub(GLOW)), "palette": Key(Sub(PALETTE)), "horizon": Key(Sub(HORIZON)),
    "textures": Key(rows(TEXTURE, 256)), "billboards": Key(rows(BILLBOARD, 256)), "beams": Key(rows(BEAM, image_beam.BEAMS_MAX)),
    "objects": Key(Several(Read(lambda value, where: value, "a table", ({"solid": "box"},), ()), (1, MANY)), REQUIRED),
    "path": Key(Sub(PATH), None, "a circle about all of the scene, in 60 frames")}
