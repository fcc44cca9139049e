# SPDX-License-Identifier: MIT
"""From a scene file to a scene image. docs/scenes.md describes the file."""

import collections
import functools
from fractions import Fraction
import math
import operator
import os

from fixel.image import image, image_beam, image_header, image_horizon, image_lines
from fixel.model import clusters, quantity
from fixel.model.surface import MEAN_NOTE
from fixel.scene import keys, palette, target, texture, toml_billboard, toml_light, toml_model, toml_motion, toml_table, toml_texture
from fixel.scene import path as walk
from fixel.base.job import Quiet
from fixel.base.errors import ToolError
from fixel.image.image import Face, Model, Object, SceneImage
from fixel.base.reading import shortened
from fixel.scene.surfaces import Records
from fixel.scene.toml_object import Objects, SORTED_NOTE
from fixel.scene.toml_table import Table

POSES_MAX = 32_768          # of keys or an orbit


def _centre(view, width, height, fov, inset):
    """The lens's centre in the image's integers; None for the middle of the screen."""
    if "centre" not in view:
        return None
    centre = tuple(map(quantity.q16, view["centre"]))
    if centre == image_header.middle(width, height):
        return None
    try:
        image_header.check_centre(width, height, fov, inset, centre)
    except ToolError as error:
        raise ToolError(f"{view.at('centre')}: {error}") from error
    return centre


def _scale(view):
    """The scale of an orthographic lens in the image's integers; 0: the lens has an eye."""
    if "scale" not in view:
        return 0
    for key in ("fov", "focal"):
        if key in view:
            raise ToolError(f"{view.where}: scale and {key} do not go together: an orthographic lens has no eye; keep one")
    if view["inset"]:
        raise ToolError(f"{view.at('inset')}: an orthographic lens has no inset; leave it out")
    return quantity.q16(view["scale"])


def _lens(top):
    """width, height, fov, near, far, inset, scale, centre in the image's integers."""
    screen, view = top.table("screen"), top.table("view")
    width, height = screen["width"], screen["height"]
    if "focal" in view and "fov" in view:
        raise ToolError(f"{view.where}: both fov and focal are given; keep one")
    if "focal" in view:
        turns = Fraction(math.atan2(width / 2, float(view["focal"])) / math.pi)
        fov = 360 * turns
        quantity.in_range(fov, 10, 150, f"{view.at('focal')}: the field of view that it gives",
                          "degrees")
    else:
        fov = view["fov"]
    # 10 and 150 degrees are no whole binary angles; the range ends just inside.
    fov = min(max(quantity.angle(fov), image_header.FOV_MIN), image_header.FOV_MAX)
    near, far, inset = (quantity.q16(view[key]) for key in ("near", "far", "inset"))
    if near + 2 * inset >= far:
        raise ToolError(f"{view.where}: near + 2 inset = {(near + 2 * inset) / 65536:g} is not "
                        f"below far = {far / 65536:g}")
    return width, height, fov, near, far, inset, _scale(view), _centre(view, width, height, fov, inset)


# place field: a field of the header: who uses it in the tools
# place pixel-format: pixels of [view]
# rgb565 3.5
def _target(top, scene):
    """How the scene asks to be drawn: pixels, depth buffer and order. visibility = "depth" means depth = 16."""
    view = top.table("view")
    scene.pixel_bits = 16 if _is_565(top) else 8
    if view["visibility"] == "depth" and "depth" in view:
        raise ToolError(f'{view.at("visibility")}: "depth" is depth = 16; give only one of visibility and depth')
    scene.depth_bits = _depth_bits(top)
    if view["order"] == "tree" and top["tree"] == "none":
        raise ToolError(f'{view.at("order")}: "tree" needs a tree; give tree = "all" at the top of the file')
    if scene.scale and top["tree"] != "none" and view["order"] != "distance":
        raise ToolError(f'{view.at("scale")}: an orthographic lens and the order by tree do not go together; give order = "distance"')
    scene.by_distance = view["order"] == "distance"


def _is_565(top):
    """Whether frames are of RGB565, which need no shades of light in the palette."""
    return top.table("view")["pixels"] == "rgb565"


def _depth_bits(top):
    view = top.table("view")
    return 16 if view["visibility"] == "depth" else view["depth"]


def _draws_at_once(top, asked):
    """Whether u, v and light of small triangles may be functions of the screen (SPEC.md, section 9.1.1), by what the scene says.
    asked: the target.Target in the place of that."""
    is_565 = asked.pixels == "rgb565" if asked and asked.pixels else _is_565(top)
    depth_bits = int(asked.depth) if asked and asked.depth else _depth_bits(top)
    return is_565 and depth_bits == 16 and not top["beams"] and "scale" not in top.table("view")


def _on_screen(lens, screen):
    """The lens on a screen of another width and height, with the same field of view. As the focal length, the centre's
    distance from the middle grows with the width."""
    width, height, scale, centre = *lens[:2], *lens[-2:]
    if centre:
        before, after = image_header.middle(width, height), image_header.middle(*screen)
        centre = tuple(at + (value - old) * screen[0] // width for value, old, at in zip(centre, before, after))
        centre = None if centre == after else centre
    return (*screen, *lens[2:-2], scale * screen[0] // width, centre)


def _check_poses(count, where):
    """Refuses more poses than the limit."""
    if count > POSES_MAX:
        raise ToolError(f"{where}: {count:,} frames are more than the limit of {POSES_MAX:,} that are computed; steps may "
                        f"have up to {keys.FRAMES_MAX:,}")


def _key(key):
    if "look_at" in key and ("yaw" in key or "pitch" in key):
        raise ToolError(f"{key.where}: look_at decides yaw and pitch; remove one or the other")
    return walk.Key(*(key[name] for name in ("position", "frames", "yaw", "pitch", "roll", "look_at")))


def _gait(gait):
    return (*(quantity.q16(gait[key]) for key in ("acceleration", "friction", "speed_max")), quantity.angle(gait["turn"]))


def _strides(table):
    return [(functools.reduce(operator.or_, (image.KEYS[name] for name in step["keys"]), 0), step["frames"]) for step in table["steps"]]


def _start(start):
    return (*map(quantity.q16, start["position"]), *(quantity.angle(start[key]) for key in ("yaw", "pitch", "roll")))


def _orbit(table, frames):
    orbit = table["orbit"]
    count = frames or orbit["frames"]
    _check_poses(count, table.at("orbit"))
    poses = walk.orbit(orbit["centre"], orbit["radius"], orbit["height"], count, orbit["start"], orbit["turns"])
    for i, pose in enumerate(poses):
        if any(abs(c) > image.COORDINATE_MAX for c in pose[:3]):
            raise ToolError(f"{table.at('orbit')}: frame {i} leaves -8191..8191")
    return poses


def _shortened(strides, frames):
    result, left = [], frames
    for held, count in strides:
        if left:
            result.append((held, min(count, left)))
            left -= result[-1][1]
    return result


def _path(top, frames):
    """(kind, entries, start, gait); no more than frames of them where asked. Without a path there are no entries: see
    path.about."""
    if "path" not in top:
        return image.POSES, [], (0,) * 6, _gait(Table({}, top.at("path"), keys.GAIT))
    table = top["path"]
    style = table.only_one("keys", "steps", "orbit")
    gait = _gait(table.table("gait"))
    if style != "keys" and "interpolation" in table:
        raise ToolError(f"{table.at('interpolation')}: belongs to keys")
    if style == "steps":
        strides = _strides(table)
        total, kind, entries, start = sum(n for _, n in strides), image.STRIDES, strides, \
            _start(table.table("start"))
    else:
        if "start" in table:
            raise ToolError(f"{table.at('start')}: belongs to steps; {style} say where they begin")
        if style == "keys":
            stops = [_key(key) for key in table["keys"]]
            _check_poses(sum(key.frames for key in stops), table.at("keys"))
            entries = walk.poses(stops, table["interpolation"] == "smooth", f"{table.where}: key")
        else:
            entries = _orbit(table, frames)
        total, kind, start = len(entries), image.POSES, entries[0]
    if total > keys.FRAMES_MAX:
        raise ToolError(f"{table.where}: {total:,} frames are more than {keys.FRAMES_MAX:,}")
    if frames and frames > total:
        raise ToolError(f"{table.where}: {frames} frames are asked for, and the path has {total}")
    if frames:
        entries = entries[:frames] if kind == image.POSES else _shortened(entries, frames)
    return kind, entries, start, gait


def _beams(top):
    """The beams of a scene, and what becomes of a colour in one: a function, or None."""
    glow = top.table("glow")
    strength, tint = float(glow["strength"]), glow["colour"]
    if "beams" not in top:
        return [], None
    beams = []
    for beam in top["beams"]:
        window = [tuple(map(quantity.q16, corner)) for corner in beam.need("window")]
        if beam.only_one("position", "direction") == "position":
            kind = image_beam.POINT
            source = tuple(map(quantity.q16, beam["position"]))
        else:
            kind = image_beam.DIRECTION
            way = beam["direction"]
            whole = math.lcm(*(c.denominator for c in way))
            if not any(way):
                raise ToolError(f"{beam.at('direction')}: [0, 0, 0] is no direction")
            source = image_beam.unit([int(c * whole) for c in way])
        beams.append(image_beam.through_window(kind, source, window, beam.where))
    return beams, lambda colour: palette.lit(colour, strength, tint)


def _reserved(top):
    """The colours of the palette entries that no face gets; those without a colour of their own are black."""
    table = top.table("palette")
    given = table["colours"]
    count = table.get("reserve", len(given))
    if len(given) > count:
        raise ToolError(f"{table.at('colours')}: {len(given)} colours are more than reserve = {count}")
    return [*given, *[(0, 0, 0)] * (count - len(given))]


def _horizon(top):
    """The horizon, whose colours are still wishes; None: there is none."""
    if "horizon" not in top:
        return None
    table = top["horizon"]
    if "scale" in top.table("view"):
        raise ToolError(f"{table.where}: an orthographic lens and a horizon do not go together: all its rays have one elevation; leave out one")
    degrees, colours = table["degrees"], table["colours"]
    if len(colours) != len(degrees) + 1:
        raise ToolError(f"{table.at('colours')}: {len(colours)} colours for {len(degrees)} elevations; give one more than elevations, from "
                        "the ground up")
    if any(low > high for low, high in zip(degrees, degrees[1:])):
        raise ToolError(f"{table.at('degrees')}: an elevation is below the one before it; give them ascending")
    return image_horizon.Horizon(tuple(round(quantity.sine_cosine(each)[0] * image_horizon.ONE) for each in degrees), tuple(colours))


def _texel_colours(instances):
    looks = (look for looks in {id(p.looks): p.looks for p in instances}.values() for look in looks if look and not look.is_565)
    return {c for colours in {id(look.colours): look.colours for look in looks}.values() for c in colours}


LEVEL_FACES = 64    # faces that a colour of the horizon counts as, where colours are merged: a choice


def _count_colours(instances, lit, horizon):
    wanted, times = {}, collections.Counter(id(instance.colours) for instance in instances)
    for colours in {id(instance.colours): instance.colours for instance in instances}.values():
        for colour in colours:
            wanted[colour] = wanted.get(colour, 0) + times[id(colours)]
    for colour in _texel_colours(instances):
        wanted[colour] = wanted.get(colour, 0) + 1
    for colour in {line.colour for lines in {instance.lines for instance in instances} for line in lines}:
        wanted[colour] = wanted.get(colour, 0) + 1
    for colour in {c for board in {instance.board for instance in instances if instance.board} for c in board.picture.colours}:
        wanted[colour] = wanted.get(colour, 0) + 1
    if lit:
        for colour in [c for c in wanted if not isinstance(c, int)]:
            wanted[lit(colour)] = wanted.get(lit(colour), 0) + 1
    for colour in set(horizon.colours if horizon else ()):
        wanted[colour] = wanted.get(colour, 0) + LEVEL_FACES
    return wanted


def _lit_table(instances, indices, lit):
    """For each colour of the palette, the one that it has in a beam."""
    table = list(range(256))
    of_faces = {c for colours in {id(p.colours): p.colours for p in instances}.values() for c in colours}
    for colour in of_faces | _texel_colours(instances):
        if lit and not isinstance(colour, int):
            table[indices[colour]] = indices[lit(colour)]
    return bytes(table)


# place light: a new setting: what reads [light]
def _palette(background, instances, reserved, light, lit, horizon):
    """Palette, index of each wanted colour, number of colours that were merged or 0, and for each entry the one that it
    is in a beam. The ramp of light at run time goes into the light."""
    at_run_time = isinstance(light, toml_light.RunTime)
    wanted = _count_colours(instances, None if at_run_time else lit, horizon)
    if at_run_time:
        colours, indices, merged, light.image.ramp, in_beam = palette.allocate_lit(background, wanted, reserved, light, lit)
        return colours, indices, merged, in_beam
    colours, indices, merged = palette.allocate(background, wanted, reserved)
    return colours, indices, merged, _lit_table(instances, indices, lit)


def _merged_text(merged, room, is_565, at_run_time):
    """What there is to say of colours that were merged, and what would help."""
    if not is_565:
        helps = 'RGB565 (pixels = "rgb565" under [view], or no --palette of a model by itself) needs none for light and for images'
    elif not at_run_time:
        helps = "light at run time (levels under [light]) needs one for a colour, whatever way its faces look"
    else:
        helps = "texels of RGB565 (bits = 16 of images or textures) need none"
    return f"{merged:,} colours were merged into the {room} for which the palette has entries; {helps}"


def _models(instances, indices, records):
    """Models, objects, and of each model its billboard or None; equal models are made once. An object's position in
    the list is its number in the order of drawing. records: a surfaces.Records."""
    numbers, models, objects, boards = {}, [], [], []
    for item in instances:
        made, moved = item.shape
        key = (id(made), moved, id(item.colours), id(item.looks), item.kind, item.clusters, item.board, item.lines)
        if key not in numbers:
            colours = tuple(indices[c] for c in item.colours)
            vertices = tuple(tuple(a - b for a, b in zip(v, moved)) for v in made.vertices)
            mapped = map(records.mapped, item.looks or (None,) * len(colours), item.colours, (f.corners for f in made.faces))
            faces = tuple((f.normal, f.corners, c, m) for f, c, m in zip(made.faces, colours, mapped))
            # Meshes from different sources may come out the same.
            lines = [image_lines.Line(*line)._replace(colour=indices[line.colour]) for line in item.lines]
            content = (vertices, faces, item.kind, item.clusters, item.board, tuple(lines))
            if content not in numbers:
                if len(vertices) > 65535 or len(faces) > 65535:
                    raise ToolError(f"{item.where}: {len(vertices)} vertices and {len(faces)} "
                                    "faces; a model has at most 65535 of each, so split it")
                numbers[content] = len(models)
                models.append(Model(list(vertices), [Face(*f) for f in faces], item.kind, lines=lines))
                boards.append(item.board)
                if item.clusters:
                    clusters.divide(models[-1])
            numbers[key] = numbers[content]
        objects.append(Object(item.centre, numbers[key], item.layer))
    return models, objects, boards


RAMP = 16           # levels of light at run time, where the tool's own cannot be baked


def _lit_at_run_time(data, where):
    """(the scene with light at run time, what to say of it). where: the object whose textures need it."""
    light = dict(data.get("light", {}))
    gone = [f"light.{key}" for key in keys.BAKED if light.pop(key, None) is not None]
    note = f"{where}: its textured faces look in more than {toml_texture.DIRECTIONS_MAX} directions: light.levels = {RAMP} is " \
        "taken, so the scene's light is made at run time"
    return {**data, "light": {**light, "levels": RAMP}}, note + (f", without {' and '.join(gone)}" if gone else "")


def compile_data(data, name, folder, frames=None, progress=None, screen=None, files=None, asked=None):
    """A scene as a dictionary of TOML's shape -> (SceneImage, notes). See _compile_data. Textures that the tool's light
    cannot be baked into get light at run time."""
    how = name, folder, frames, progress, screen, files or toml_model.Files(folder), asked
    names = toml_texture.by_path(data)
    if not names:
        return _compile_lit(data, how)
    toml_texture.check_by_path(Table(data, name, keys.TOP), names)
    scene, _ = _compile_lit(data, how)
    data, more = toml_texture.sizes_of_path(data, scene, names)
    scene, notes = _compile_lit(data, how)
    return scene, [*(f"{name}: {note}" for note in more), *notes]


def _compile_lit(data, how):
    """See compile_data; sizes of textures are numbers. how: what _compile_data takes besides."""
    try:
        return _compile_data(data, *how)
    except toml_texture.ManyDirections as found:
        changed, note = _lit_at_run_time(data, found)
    scene, notes = _compile_data(changed, *how)
    return scene, [note, *notes]


def _check_lines(scene, name):
    """Refuses what does not go with lines (docs/extras/combinations.md)."""
    other, key = ("beams", "beams") if scene.beams else ("a tree", "tree") if scene.layers != "none" else (None, None)
    if other and any(model.lines for model in scene.models):
        raise ToolError(f"{name}: lines and {other} do not go together: leave out edges, lines and points, or {key}")


def _compile_data(data, name, folder, frames, progress, screen, files, asked):
    """A scene as a dictionary of TOML's shape -> (SceneImage, notes). screen:
    width and height instead of the scene's, seen with the same field of view.
    files: a toml_model.Files with what was read already. progress: a job.Report. asked: what the scene is drawn as
    (target.Target), which only what it is made of depends on here; None: as it says."""
    progress = progress or Quiet()
    top = Table(data, name, keys.TOP)
    lens = _lens(top)
    if screen:
        lens = _on_screen(lens, screen)
    notes = []
    background = top["background"]
    kind, entries, start, gait = _path(top, frames)
    beams, lit = _beams(top)
    reserved, horizon = _reserved(top), _horizon(top)
    light = toml_light.read(top)
    pictures = texture.Pictures(folder)
    objects = Objects(name, files, light, notes, progress, toml_texture.read(top, pictures),
                      toml_billboard.read(top, pictures), _draws_at_once(top, asked))
    instances = []
    for number, item in enumerate(top["objects"]):
        progress(f"{name}: object {number}")
        instances += objects.instances(item, number)
    progress.stage(f"{name}: the palette and the models")
    instances, placements, motions = toml_motion.settle(instances)
    try:
        colours, indices, merged, in_beam = _palette(background, instances, reserved, light, lit, horizon)
    except ToolError as error:
        raise ToolError(f"{name}: {error}") from error
    if merged and not (_is_565(top) and len(_count_colours(instances, None, horizon)) < palette.ENTRIES - len(reserved)):
        notes.append(f"{name}: {_merged_text(merged, palette.ENTRIES - 1 - len(reserved), _is_565(top), isinstance(light, toml_light.RunTime))}")
    records = Records(indices)
    models, placed, boards = _models(instances, indices, records)
    scene = SceneImage(*lens[:-2], 0, colours, models, placed, kind, entries, start, gait)
    scene.scale, scene.centre = lens[-2:]
    scene.horizon = horizon and horizon._replace(colours=tuple(indices[colour] for colour in horizon.colours))
    _target(top, scene)
    scene.layers = top["tree"]
    scene.beams, scene.placements, scene.motions, scene.surfaces = beams, placements, motions, records.result(
        colours, top.table("palette")["blend"], light.image.ramp if isinstance(light, toml_light.RunTime) else [], in_beam)
    if scene.scale and beams and scene.surfaces:
        raise ToolError(f"{name}: view.scale: an orthographic lens and surfaces and beams do not go together; leave out the beams or the textures")
    scene.billboards = toml_billboard.result(boards, indices)
    scene.lit = in_beam
    scene.light = light.image if isinstance(light, toml_light.RunTime) else None
    scene.dark = palette.rgb565(light.dark) if scene.light else 0
    scene.reserved = len(reserved)
    if not entries:
        _check_poses(frames or walk.FRAMES, name)
        scene.path, more = walk.about(scene, frames, name)
        scene.start = scene.path[0]
        notes += more
    notes += pictures.notes + [toml_model.simplified_note(scene, record) for record in objects.simplified.values()]
    _check_lines(scene, name)
    scene.names = [item.name for item in instances]
    scene.moving = tuple(i for i, item in enumerate(instances) if item.moves)
    if target.has_colours(scene):   # the reader of the file spoke of means
        notes = [note for note in notes if not note.endswith(MEAN_NOTE)]
    if scene.depth_bits:    # whatever the order, the nearest face is seen
        notes = [note for note in notes if not note.endswith(SORTED_NOTE)]
    return scene, list(dict.fromkeys(notes))


def compile_file(path, frames=None, progress=None, screen=None, asked=None):
    """A scene file -> (SceneImage, notes). See _compile_data."""
    folder, data = os.path.dirname(path), toml_table.read(path)
    return compile_data(data, shortened(os.path.basename(path)), folder, frames, progress, screen, asked=asked)
