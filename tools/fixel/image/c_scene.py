# SPDX-License-Identifier: MIT
"""A scene as one C header: constant tables in the layout of lib/include/fixel/scene.h, valid C11 and C++11.

The header says everything that a check of the scene would compute, so a program that draws the
scene links no check."""

import itertools

from fixel.image import c_names, c_setup, c_surfaces, c_text, image, image_beam, image_horizon, image_lines, image_models, memory_needed
from fixel.image.c_text import braces, comment, record, split64, table
from fixel.base.errors import ToolError
from fixel.base.table import count_of
from fixel.image.image_tree import SORTED

KINDS = {image.CONVEX: "FXL_MODEL_CONVEX", SORTED: "FXL_MODEL_SORTED"}
BEAM_KINDS = {image_beam.POINT: "FXL_BEAM_POINT", image_beam.DIRECTION: "FXL_BEAM_DIRECTION"}


class _Tables:
    """The scene's tables as text, and what a model says of its place in them."""

    def __init__(self, scene, name):
        self.scene, self.name, self.has_bounds = scene, name, image_models.has_keys(scene)
        self.vertices, self.faces, self.models, self.bounds, self.clusters = [], [], [], [], []
        self.indices = image_models.Indices()
        for model in scene.models:
            self._add(model)
        self.wholes = self.indices.wholes_if_any()

    def _add(self, model):
        first_bounds = len(self.bounds) if model.kind == SORTED else 0
        self.models.append(braces(len(self.vertices), len(model.vertices), len(self.faces), len(model.faces),
                                  KINDS[model.kind], 0, len(self.clusters) + 1 if model.clusters else 0,
                                  image.radius_of(model.vertices), first_bounds))
        self.clusters += map(_cluster, model.clusters)
        self.vertices += [braces(*vertex) for vertex in model.vertices]
        for face in model.faces:
            self.faces.append(braces(braces(*face.normal), len(face.corners), face.colour, braces(*self.indices.of(face))))
            if self.has_bounds and model.kind == SORTED:
                height, *box = image_models.key_of(model, face)
                self.bounds.append(braces(*split64(height), *box))

    def _table(self, kind, what, items, about):
        return table(kind, f"{self.name}_{what}", items, about)

    def text(self):
        """All tables that the scene has."""
        made = [
            self._table("fxl_point", "vertices", self.vertices,
                        "x, y, z in 16.16, relative to the centre of the instance."),
            self._table("fxl_face", "faces", self.faces,
                        "Normal in 2.30; count of vertices, colour; of a triangle the numbers of its vertices within the model, "
                        "clockwise as seen from the front; of another face the first one, and where it is among the indices, low "
                        "half first."),
            self._table("fxl_model", "models", self.models,
                        "First vertex, vertices, first face, faces, kind, reserved, first cluster, radius in "
                        "16.16, first face bounds."),
            self._table("fxl_instance", "instances",
                        [braces(braces(*item.centre), item.model, item.layer, 0) for item in self.scene.objects],
                        "Centre in 16.16, model, layer, recolour."),
        ]
        if self.indices.table:
            made.append(self._table("uint16_t", "indices", list(map(str, self.indices.table)),
                                    "Numbers of vertices within the model, clockwise as seen from the front."))
        if self.wholes:
            made.append(self._table("uint32_t", "wholes", list(map(str, self.wholes)),
                                    "Of each face: the first index of the whole face that it is a part of, times 32, and its count."))
        if self.bounds:
            made.append(self._table("fxl_face_bounds", "face_bounds", self.bounds,
                                    "Of the faces of sorted models: normal . first vertex, low and high word; "
                                    "minimum + maximum in x, y, z."))
        if self.scene.tree:
            made.append(self._table("fxl_bsp_node", "bsp_nodes", list(map(_node, self.scene.tree.nodes)),
                                    "Normal, distance (low and high word); front, back, parent; first face, "
                                    "faces, reserved; centre and radius of the sphere."))
        if self.clusters:
            made.append(self._table("fxl_cluster", "clusters", self.clusters,
                                    "Centre and radius of the sphere; axis, cutoff and apex of the cone; faces, "
                                    "reserved."))
        if self.scene.placements:
            made.append(self._table("fxl_placement", "placements", list(map(_placement, self.scene.placements)),
                                    "Of the last instances: the rows of the orientation in 2.30, scale in 16.16."))
        if self.scene.beams:
            made += [self._table("fxl_beam", "beams", list(map(_beam, self.scene.beams)),
                                 "Point or direction, kind, count of planes, reserved; each plane's normal "
                                 "and distance (low and high word)."),
                     self._table("uint8_t", "lit", list(map(str, self.scene.lit)),
                                 "For each colour, the one that it has in a beam.")]
        return made

    def record(self):
        """The fxl_scene."""
        name, scene = self.name, self.scene

        def rows(there, what, *more):
            return ", ".join(map(str, (f"{name}_{what}" if there else "NULL", *more)))
        entries = [
            ", ".join([f"{name}_vertices", f"{name}_indices" if self.indices.table else "NULL",
                       *(f"{name}_{what}" for what in ("faces", "models", "instances"))]),
            ", ".join(str(len(part)) for part in (self.vertices, self.indices.table, self.faces, self.models,
                                                  scene.objects)),
            f"{memory_needed.draw_list_needed(scene)} /* draw_list_needed */",
            rows(self.bounds, "face_bounds", len(self.bounds)),
            rows(scene.tree, "bsp_nodes", len(scene.tree.nodes) if scene.tree else 0,
                 scene.tree.object if scene.tree else 0),
            rows(scene.beams, "beams", len(scene.beams)),
            rows(scene.beams, "lit"),
            rows(self.clusters, "clusters", len(self.clusters), "&fxl_clusters" if self.clusters else "NULL"),
            rows(scene.placements, "placements", len(scene.objects) - len(scene.placements) if scene.placements else 0,
                 "&fxl_turned_instances" if scene.placements else "NULL"),
            "0 /* instance_capacity */",
            rows(self.wholes, "wholes"),
        ]
        return record("fxl_scene", f"{name}_scene", entries, "The scene, for fxl_renderer_init.")


def _placement(placement):
    return braces(braces(*(braces(*placement.rows[i:i + 3]) for i in (0, 3, 6))), placement.scale)


def _hex(angle):
    return f"0x{angle:08X}u"


def _motion(motion, first_key):
    return braces(*map(_hex, motion.steps), braces(*motion.axis), *map(_hex, motion.spin), motion.radius,
                  *map(_hex, motion.circle), braces(*motion.extent), *motion.scales, first_key, len(motion.keys),
                  motion.parent, motion.repeats, 0)


def _key(key):
    return braces(key.frame, braces(*key.centre), *map(_hex, key.angles), key.scale)


def _motions(scene, name):
    """The motions, for fxl_motion_begin, and how much memory they want."""
    if not scene.motions:
        return []
    keys = [key for motion in scene.motions for key in motion.keys]
    firsts = itertools.accumulate((len(motion.keys) for motion in scene.motions), initial=0)
    return [
        table("fxl_motion", f"{name}_motions", list(map(_motion, scene.motions, firsts)),
              "Steps of yaw, pitch and roll; axis, start and step of the spin; radius, start and step of the circle; "
              "extent; least and largest scale; first key, keys, parent, whether it repeats, reserved."),
        table("fxl_motion_key", f"{name}_motion_keys", list(map(_key, keys)),
              "Frame, centre, yaw, pitch, roll, scale."),
        "\n".join([*comment(f"For fxl_motion_begin with {name}_motion: a copy of the scene has as many instances and placements."),
                   f"#define {name.upper()}_INSTANCES  {len(scene.objects)}",
                   f"#define {name.upper()}_PLACEMENTS {len(scene.placements)}", ""]),
        record("fxl_motion_set", f"{name}_motion", [f"{name}_motions, {len(scene.motions)}, {name}_motion_keys, {len(keys)}"],
               "For fxl_motion_begin.")]


def _light(scene, name):
    """The light, for fxl_attach_light, and its ramp."""
    light = scene.light
    if light is None:
        return []
    points = [braces(braces(*place), reach, strength) for *place, reach, strength in light.points]
    entries = [f"{light.ambient}, {light.strength}, {braces(*light.direction)}", braces(*points or ["{{0, 0, 0}, 0, 0}"]),
               ", ".join(map(str, [len(points), *light.fog, f"{name}_ramp", len(light.ramp), f"0x{scene.dark:04X}"]))]
    return [table("uint8_t", f"{name}_ramp", [str(entry) for level in light.ramp for entry in level],
                  "For each level from dark to full, 256 entries: the colour of each colour."),
            record("fxl_light_settings", f"{name}_light", entries,
                   "For fxl_attach_light: ambient, strength and direction in 2.30; point lights; their "
                   "count, fog's near and far in 16.16, ramp, levels, dark.")]


def _node(node):
    return braces(braces(*node.normal), *split64(node.distance), node.front, node.back, node.parent,
                  node.first_face, node.face_count, 0, braces(*node.centre), node.radius)


def _cluster(cluster):
    return braces(braces(*cluster.centre), cluster.radius, braces(*cluster.axis), f"{cluster.cutoff}u",
                  braces(*cluster.apex), cluster.face_count, 0)


def _beam(beam):
    planes = beam.planes + [(0, 0, 0, 0)] * (image_beam.PLANES_MAX - len(beam.planes))
    return braces(braces(*beam.source), BEAM_KINDS[beam.kind], len(beam.planes), 0,
                  braces(*(braces(braces(*normal), *split64(distance)) for *normal, distance in planes)))


def _pose(pose):
    position, angles = pose[:3], pose[3:]
    return ", ".join([braces(*position), *map(_hex, angles)])


def _palette(scene, name):
    used = max((i for i, entry in enumerate(scene.palette) if any(entry)), default=0) + 1
    about = "Red, green, blue of each colour" + (f"; those from {used} on are black." if used < 256 else ".")
    return table("uint8_t", f"{name}_palette", [braces(*entry) for entry in scene.palette[:used]],
                 about, (256, 3))


def _reserved(scene, name):
    """Where the entries begin that the scene keeps for its program."""
    first = len(scene.palette) - scene.reserved
    return ["\n".join([*comment(f"The palette's entries from here on are the program's: {scene.reserved} of them, "
                                "which no face has."), f"#define {name.upper()}_RESERVED {first}", ""])] if scene.reserved else []


def _signed(value):
    """A number as an expression of C that nothing about it takes apart."""
    return f"({value})" if value < 0 else str(value)


def _view(scene, name, frames):
    """The lens, the first pose, and the path if it was asked for."""
    config = ", ".join(map(str, (scene.width, scene.height, f"{scene.fov}u", scene.near, scene.far, scene.inset,
                                 scene.background, f"&{c_setup.target(scene)}, NULL, {c_setup.palette_565(scene, name)}, NULL, 0, NULL, 0")))
    first = scene.path[0] if scene.path_kind == image.POSES else scene.start
    made = [record("fxl_config", f"{name}_config", [config],
                   "The scene's own view, for fxl_renderer_init: width, height, field of view, near, far, inset, "
                   "background, target, palette of RGB565; and neither order, depth buffer nor tree."),
            record("fxl_pose", f"{name}_start", [_pose(first)], "The scene's first pose: x, y, z in 16.16, yaw, pitch, roll.")]
    if scene.scale:
        made.append("\n".join([*comment("The scene's lens is orthographic. After fxl_renderer_init call "
                                        f"fxl_renderer_set_orthographic(&renderer, {name.upper()}_SCALE)."),
                               f"#define {name.upper()}_SCALE {scene.scale}", ""]))
    if scene.centre:
        made.append("\n".join([*comment("The scene's lens is off-centre. After fxl_renderer_init call "
                                        f"fxl_renderer_set_centre(&renderer, {name.upper()}_CENTRE_X, "
                                        f"{name.upper()}_CENTRE_Y)."),
                               f"#define {name.upper()}_CENTRE_X {_signed(scene.centre[0])}",
                               f"#define {name.upper()}_CENTRE_Y {_signed(scene.centre[1])}", ""]))
    if frames:
        made += [f"#define {name.upper()}_FRAMES {len(scene.path)}\n",
                 table("fxl_pose", f"{name}_path", [braces(_pose(pose)) for pose in scene.path],
                       "The scene's path, a pose for each frame.")]
    return made


def printable(text):
    """A file's name within a comment."""
    return "".join(letter if letter.isprintable() and letter != "\\" else "?" for letter in text)


def _memory(scene, name):
    """Three sizes of the renderer's memory, what each holds, and the bound of what that costs. host_tests/tools/test_export_setup.py
    measures it."""
    capital, sizes = name.upper(), []
    for ending, size in memory_needed.SIZES.items():
        units = size(scene)
        vertices, words = memory_needed.divided(scene, units)
        sizes.append((units, f"{capital}_MEMORY{ending}, {memory_needed.UNIT * units:,} bytes", vertices, memory_needed.WORD * words))
    fast, moderate, least = sizes
    return "\n".join([
        *comment(f"uint64_t of memory for fxl_renderer_init. A frame has the same pixels with each of the three. {fast[1]}: any "
                 f"vertex of a model and any polygon of a frame is computed once. {moderate[1]}: {count_of(moderate[2], 'vertex')} and "
                 f"{moderate[3]:,} bytes of polygons are kept. {least[1]}, below which fxl_renderer_init answers FXL_E_CAPACITY: none "
                 "are. What is not kept is computed again for each face and, in bands, once before the bands and in each of N bands: at "
                 "most N + 1 times the instructions of fxl_render. make predict says how many times for the scene."),
        f"#define {capital}_MEMORY       {moderate[0]}",
        f"#define {capital}_MEMORY_LEAST {least[0]}",
        f"#define {capital}_MEMORY_FAST  {fast[0]}", ""])


def _capacity(scene, name):
    """Refuses a build of the library that cannot draw a face of the scene."""
    most = max(len(face.corners) for model in scene.models for face in model.faces)
    return "\n".join([f"#if FXL_FACE_VERTICES_MAX < {most}",
                      f'#error "{name} has a face of {most} vertices: FXL_POLYGON_CAPACITY must be at least '
                      f'{most + 8}"', "#endif", ""])


def header(scene, name, source, frames=False):
    """The text of a header. source: the name of the file that the scene comes from. frames: with the
    scene's path as poses."""
    c_names.check_name(name)
    if frames and scene.path_kind != image.POSES:
        raise ToolError(f"{source}: the path is keys that a player holds down, not poses, and only poses "
                        "can be exported: leave out --frames")
    tables = _Tables(scene, name)
    holds = ", ".join([count_of(len(tables.vertices), "vertex"), count_of(len(tables.faces), "face"),
                       count_of(len(tables.models), "model"), count_of(len(scene.objects), "instance")])
    includes = ["fixel.h", *([c_surfaces.INCLUDE] if scene.surfaces else []),
                *([c_surfaces.BILLBOARDS_INCLUDE] if scene.billboards else []), *([image_lines.INCLUDE] if any(model.lines for model in scene.models) else []),
                *([image_horizon.INCLUDE] if scene.horizon else []), c_setup.INCLUDE]
    return c_text.header(
        f"Written by tools/scene.py from {printable(source)}: {holds}. The tool has checked the scene, so no program need "
        "call fxl_scene_check.", f"{name.upper()}_SCENE_H", includes,
        [_memory(scene, name), _capacity(scene, name), *tables.text(), tables.record(),
         *c_names.text(scene, name), *_motions(scene, name), *_light(scene, name), *c_surfaces.text(scene, name),
         *c_surfaces.billboards_text(scene, name), *image_lines.text(scene, name), *image_horizon.text(scene, name), *_view(scene, name, frames), _palette(scene, name), *_reserved(scene, name),
         *c_setup.text(scene, name, frames)])
