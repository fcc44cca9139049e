# SPDX-License-Identifier: MIT
"""From a scene file to a scene image. docs/scenes.md describes the file."""

import collections
from fractions import Fraction
import math
import os

from fixel.image import image, image_beam, image_header
from fixel.model import clusters, quantity
from fixel.model.surface import MEAN_NOTE
from fixel.scene import palette, target, texture, toml_billboard, toml_light, toml_model, toml_motion, toml_table, toml_texture
from fixel.scene import path as walk
from fixel.base.job import Quiet
from fixel.base.errors import ToolError
from fixel.image.image import Face, Model, Object, SceneImage
from fixel.base.reading import quoted, shortened
from fixel.scene.surfaces import Records
from fixel.scene.toml_object import Objects, SORTED_NOTE
from fixel.scene.toml_table import Table

FRAMES_MAX = 1_000_000      # of a path
POSES_MAX = 32_768          # of keys or an orbit
# place key: a key of the file, [view], [palette], [path] or [[beams]]
TOP_KEYS = {"screen", "view", "background", "light", "glow", "objects", "beams", "path", "palette",
            "textures", "billboards", "tree"}
_VIEW_KEYS = {"fov", "focal", "near", "far", "inset", "centre", "visibility", "pixels", "order", "depth"}
_PALETTE_KEYS = {"reserve", "colours", "blend"}


def _centre(view, width, height, fov, inset):
    """The lens's centre in the image's integers; None for the middle of the screen."""
    if "centre" not in view:
        return None
    numbers = view.need("centre")
    if not isinstance(numbers, list) or len(numbers) != 2:
        raise ToolError(f"{view.at('centre')}: expected [x, y] in pixels, from the upper left corner of the screen")
    centre = tuple(quantity.q16(quantity.in_range(quantity.fraction(number, view.at("centre")), -4096, 4096,
                                                  view.at("centre"), "pixels")) for number in numbers)
    if centre == image_header.middle(width, height):
        return None
    try:
        image_header.check_centre(width, height, fov, inset, centre)
    except ToolError as error:
        raise ToolError(f"{view.at('centre')}: {error}") from error
    return centre


def _lens(top):
    """width, height, fov, near, far, inset, centre in the image's integers."""
    screen = top.table("screen", {"width", "height"})
    width = screen.whole("width", 320, 1, image_header.SCREEN_MAX)
    height = screen.whole("height", 240, 1, image_header.SCREEN_MAX)
    view = top.table("view", _VIEW_KEYS)
    if "focal" in view and "fov" in view:
        raise ToolError(f"{view.where}: both fov and focal are given; keep one")
    if "focal" in view:
        focal = view.number("focal", None, Fraction(1, 1000), 10000, "pixels")
        turns = Fraction(math.atan2(width / 2, float(focal)) / math.pi)
        fov = 360 * turns
        quantity.in_range(fov, 10, 150, f"{view.at('focal')}: the field of view that it gives",
                          "degrees")
    else:
        fov = quantity.in_range(view.degrees("fov", 75), 10, 150, view.at("fov"), "degrees")
    # 10 and 150 degrees are no whole binary angles; the range ends just inside.
    fov = min(max(quantity.angle(fov), image_header.FOV_MIN), image_header.FOV_MAX)
    near = view.number("near", Fraction(1, 4), Fraction(1, 256), 32767, "world units")
    far = view.number("far", 256, Fraction(1, 256), 32767, "world units")
    inset = view.number("inset", 0, 0, 1, "world units")
    near, far, inset = quantity.q16(near), quantity.q16(far), quantity.q16(inset)
    if near + 2 * inset >= far:
        raise ToolError(f"{view.where}: near + 2 inset = {(near + 2 * inset) / 65536:g} is not "
                        f"below far = {far / 65536:g}")
    return width, height, fov, near, far, inset, _centre(view, width, height, fov, inset)


# place field: a field of the header: who uses it in the tools
# place pixel-format: pixels of [view]
# rgb565 3.5
def _target(top, scene):
    """How the scene asks to be drawn: pixels, depth buffer and order. visibility = "depth" means depth = 16."""
    view = top.table("view", _VIEW_KEYS)
    scene.pixel_bits = 16 if view.choice("pixels", "palette", ["palette", "rgb565"]) == "rgb565" else 8
    scene.depth_bits = view.data.get("depth", 0)
    if type(scene.depth_bits) is not int or scene.depth_bits not in image_header.DEPTHS:
        raise ToolError(f"{view.at('depth')}: expected 0, 16 or 32, the bits of a pixel's depth, found {quoted(scene.depth_bits)}")
    if view.choice("visibility", "default", ["default", "depth"]) == "depth":
        if "depth" in view:
            raise ToolError(f'{view.at("visibility")}: "depth" is depth = 16; give only one of visibility and depth')
        scene.depth_bits = 16
    order = view.choice("order", None, ["distance", "tree"]) if "order" in view else None
    if order == "tree" and _layers(top) == "none":
        raise ToolError(f'{view.at("order")}: "tree" needs a tree; give tree = "all" at the top of the file')
    scene.by_distance = order == "distance"


def _is_565(top):
    """Whether frames are of RGB565, which need no shades of light in the palette."""
    return top.table("view", _VIEW_KEYS).data.get("pixels") == "rgb565"


def _layers(top):
    """The layers that are to have a tree, as text (tree.layers_of), or "none"."""
    layers = top.data.get("tree", "none")
    if not isinstance(layers, str):
        raise ToolError(f'{top.at("tree")}: expected a string like "5", "2,4,5", "all", "most" or "none", found {quoted(layers)}')
    return layers


def _on_screen(lens, screen):
    """The lens on a screen of another width and height, with the same field of view. As the focal length, the centre's
    distance from the middle grows with the width."""
    width, height, centre = *lens[:2], lens[-1]
    if centre:
        before, after = image_header.middle(width, height), image_header.middle(*screen)
        centre = tuple(at + (value - old) * screen[0] // width for value, old, at in zip(centre, before, after))
        centre = None if centre == after else centre
    return (*screen, *lens[2:-1], centre)


def _check_poses(count, where):
    """Refuses more poses than the limit."""
    if count > POSES_MAX:
        raise ToolError(f"{where}: {count:,} frames are more than the limit of {POSES_MAX:,} that are computed; steps may "
                        f"have up to {FRAMES_MAX:,}")


def _key(data, where):
    key = Table(data, where, {"position", "yaw", "pitch", "roll", "look_at", "frames"})
    if "look_at" in key and ("yaw" in key or "pitch" in key):
        raise ToolError(f"{where}: look_at decides yaw and pitch; remove one or the other")
    return walk.Key(key.position("position"), key.whole("frames", 1, 1, FRAMES_MAX),
                    key.degrees("yaw"), key.degrees("pitch"), key.degrees("roll"),
                    key.position("look_at") if "look_at" in key else None)


def _gait(table):
    gait = table.table("gait", {"acceleration", "friction", "speed_max", "turn"})
    numbers = [quantity.q16(gait.number(key, default, 0, 256, "units a step")) for key, default in
               (("acceleration", "0.05"), ("friction", "0.02"), ("speed_max", "0.4"))]
    turn = quantity.in_range(gait.degrees("turn", 3), 0, 90, gait.at("turn"), "degrees a step")
    return (*numbers, quantity.angle(turn))


def _strides(table):
    strides = []
    for i, data in enumerate(table.rows("steps")):
        step = Table(data, f"{table.at('steps')}[{i}]", {"keys", "frames"})
        bits = 0
        keys = step.need("keys")
        if not isinstance(keys, list):
            raise ToolError(f"{step.at('keys')}: expected a list like [\"forward\", \"left\"]")
        for name in keys:
            step_key = Table({"key": name}, step.at("keys"), {"key"})
            bits |= image.KEYS[step_key.choice("key", None, list(image.KEYS))]
        strides.append((bits, step.whole("frames", 1, 1, 65535)))
    return strides


def _start(table):
    start = table.table("start", {"position", "yaw", "pitch", "roll"})
    position = start.position("position") if "position" in start else (Fraction(0),) * 3
    return (*(quantity.q16(c) for c in position),
            *(quantity.angle(start.degrees(key)) for key in ("yaw", "pitch", "roll")))


def _orbit(table, frames):
    orbit = table.table("orbit", {"centre", "radius", "height", "frames", "start", "turns"})
    centre = orbit.position("centre") if "centre" in orbit else (Fraction(0),) * 3
    radius = orbit.number("radius", None, Fraction(1, 256), 16382, "world units")
    height = orbit.number("height", 0, -16382, 16382, "world units")
    count = frames or orbit.whole("frames", 60, 1, FRAMES_MAX)
    _check_poses(count, table.at("orbit"))
    poses = walk.orbit(centre, radius, height, count, orbit.degrees("start"),
                       orbit.number("turns", 1, -100, 100))
    for i, pose in enumerate(poses):
        if any(abs(c) > image.COORDINATE_MAX for c in pose[:3]):
            raise ToolError(f"{table.at('orbit')}: frame {i} leaves -8191..8191")
    return poses


def _shortened(strides, frames):
    result, left = [], frames
    for keys, count in strides:
        if left:
            result.append((keys, min(count, left)))
            left -= result[-1][1]
    return result


def _path(top, frames):
    """(kind, entries, start, gait); no more than frames of them where asked. Without a path there are no entries: see
    path.about."""
    if "path" not in top:
        return image.POSES, [], (0,) * 6, _gait(Table({}, top.at("path"), set()))
    table = top.table("path", {"keys", "steps", "orbit", "start", "gait", "interpolation"})
    style = table.only_one("keys", "steps", "orbit")
    gait = _gait(table)
    if style != "keys" and "interpolation" in table:
        raise ToolError(f"{table.at('interpolation')}: belongs to keys")
    if style == "steps":
        strides = _strides(table)
        total, kind, entries, start = sum(n for _, n in strides), image.STRIDES, strides, \
            _start(table)
    else:
        if "start" in table:
            raise ToolError(f"{table.at('start')}: belongs to steps; {style} say where they begin")
        if style == "keys":
            keys = [_key(data, f"{table.at('keys')}[{i}]")
                    for i, data in enumerate(table.rows("keys"))]
            smooth = table.choice("interpolation", "smooth", ["smooth", "linear"]) == "smooth"
            _check_poses(sum(key.frames for key in keys), table.at("keys"))
            entries = walk.poses(keys, smooth, f"{table.where}: key")
        else:
            entries = _orbit(table, frames)
        total, kind, start = len(entries), image.POSES, entries[0]
    if total > FRAMES_MAX:
        raise ToolError(f"{table.where}: {total:,} frames are more than {FRAMES_MAX:,}")
    if frames and frames > total:
        raise ToolError(f"{table.where}: {frames} frames are asked for, and the path has {total}")
    if frames:
        entries = entries[:frames] if kind == image.POSES else _shortened(entries, frames)
    return kind, entries, start, gait


def _beams(top):
    """The beams of a scene, and what becomes of a colour in one: a function, or None."""
    if "beams" not in top:
        return [], None
    rows = top.rows("beams")
    if len(rows) > image_beam.BEAMS_MAX:
        raise ToolError(f"{top.at('beams')}: {len(rows)} beams are more than "
                        f"{image_beam.BEAMS_MAX}")
    beams = []
    for i, data in enumerate(rows):
        beam = Table(data, f"{top.at('beams')}[{i}]", {"window", "position", "direction"})
        corners = beam.rows("window")
        if not 3 <= len(corners) < image_beam.PLANES_MAX:
            raise ToolError(f"{beam.at('window')}: {len(corners)} corners are outside "
                            f"3..{image_beam.PLANES_MAX - 1}")
        window = [tuple(quantity.q16(c) for c in quantity.position(corner, beam.at("window")))
                  for corner in corners]
        if beam.only_one("position", "direction") == "position":
            kind = image_beam.POINT
            source = tuple(quantity.q16(c) for c in beam.position("position"))
        else:
            kind = image_beam.DIRECTION
            way = quantity.vector(beam.need("direction"), beam.at("direction"))
            whole = math.lcm(*(c.denominator for c in way))
            if not any(way):
                raise ToolError(f"{beam.at('direction')}: [0, 0, 0] is no direction")
            source = image_beam.unit([int(c * whole) for c in way])
        beams.append(image_beam.through_window(kind, source, window, beam.where))
    glow = top.table("glow", {"strength", "colour"})
    strength = float(glow.number("strength", Fraction(3, 2), 0, 16))
    tint = palette.parse(glow.data.get("colour", "#fff0c8"), glow.at("colour"))
    return beams, lambda colour: palette.lit(colour, strength, tint)


def _reserved(top):
    """The colours of the palette entries that no face gets; those without a colour of their own are black."""
    table = top.table("palette", _PALETTE_KEYS)
    given = table.rows("colours") if "colours" in table else []
    if len(given) >= palette.ENTRIES:
        raise ToolError(f"{table.at('colours')}: {len(given)} colours are more than {palette.ENTRIES - 1}")
    count = table.whole("reserve", len(given), 0, palette.ENTRIES - 1)
    if len(given) > count:
        raise ToolError(f"{table.at('colours')}: {len(given)} colours are more than reserve = {count}")
    colours = [palette.parse(colour, f"{table.at('colours')}[{i}]") for i, colour in enumerate(given)]
    return colours + [(0, 0, 0)] * (count - len(colours))


def _blend(top):
    """Sixteenths that a blended colour shows of itself."""
    return top.table("palette", _PALETTE_KEYS).whole("blend", 8, 1, 16)


def _texel_colours(instances):
    looks = (look for looks in {id(p.looks): p.looks for p in instances}.values() for look in looks if look and not look.is_565)
    return {c for colours in {id(look.colours): look.colours for look in looks}.values() for c in colours}


def _count_colours(instances, lit):
    wanted, times = {}, collections.Counter(id(instance.colours) for instance in instances)
    for colours in {id(instance.colours): instance.colours for instance in instances}.values():
        for colour in colours:
            wanted[colour] = wanted.get(colour, 0) + times[id(colours)]
    for colour in _texel_colours(instances):
        wanted[colour] = wanted.get(colour, 0) + 1
    for colour in {c for board in {instance.board for instance in instances if instance.board} for c in board.picture.colours}:
        wanted[colour] = wanted.get(colour, 0) + 1
    if lit:
        for colour in [c for c in wanted if not isinstance(c, int)]:
            wanted[lit(colour)] = wanted.get(lit(colour), 0) + 1
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
def _palette(background, instances, reserved, light, lit):
    """Palette, index of each wanted colour, number of colours that were merged or 0, and for each entry the one that it
    is in a beam. The ramp of light at run time goes into the light."""
    at_run_time = isinstance(light, toml_light.RunTime)
    wanted = _count_colours(instances, None if at_run_time else lit)
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
        key = (id(made), moved, id(item.colours), id(item.looks), item.kind, item.clusters, item.board)
        if key not in numbers:
            colours = tuple(indices[c] for c in item.colours)
            vertices = tuple(tuple(a - b for a, b in zip(v, moved)) for v in made.vertices)
            mapped = map(records.mapped, item.looks or (None,) * len(colours), item.colours, (f.corners for f in made.faces))
            faces = tuple((f.normal, f.corners, c, m) for f, c, m in zip(made.faces, colours, mapped))
            # Meshes from different sources may come out the same.
            content = (vertices, faces, item.kind, item.clusters, item.board)
            if content not in numbers:
                if len(vertices) > 65535 or len(faces) > 65535:
                    raise ToolError(f"{item.where}: {len(vertices)} vertices and {len(faces)} "
                                    "faces; a model has at most 65535 of each, so split it")
                numbers[content] = len(models)
                models.append(Model(list(vertices), [Face(*f) for f in faces], item.kind))
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
    gone = [f"light.{key}" for key in toml_light.BAKED if light.pop(key, None) is not None]
    note = f"{where}: its textured faces look in more than {toml_texture.DIRECTIONS_MAX} directions: light.levels = {RAMP} is " \
        "taken, so the scene's light is made at run time"
    return {**data, "light": {**light, "levels": RAMP}}, note + (f", without {' and '.join(gone)}" if gone else "")


def compile_data(data, name, folder, frames=None, progress=None, screen=None, files=None):
    """A scene as a dictionary of TOML's shape -> (SceneImage, notes). See _compile_data. Textures that the tool's light
    cannot be baked into get light at run time."""
    files = files or toml_model.Files(folder)
    names = toml_texture.by_path(data)
    if not names:
        return _compile_lit(data, name, folder, frames, progress, screen, files)
    toml_texture.check_by_path(Table(data, name, TOP_KEYS), names)
    scene, _ = _compile_lit(data, name, folder, frames, progress, screen, files)
    data, more = toml_texture.sizes_of_path(data, scene, names)
    scene, notes = _compile_lit(data, name, folder, frames, progress, screen, files)
    return scene, [*(f"{name}: {note}" for note in more), *notes]


def _compile_lit(data, name, folder, frames, progress, screen, files):
    """See compile_data; sizes of textures are numbers."""
    try:
        return _compile_data(data, name, folder, frames, progress, screen, files)
    except toml_texture.ManyDirections as found:
        changed, note = _lit_at_run_time(data, found)
    scene, notes = _compile_data(changed, name, folder, frames, progress, screen, files)
    return scene, [note, *notes]


def _compile_data(data, name, folder, frames, progress, screen, files):
    """A scene as a dictionary of TOML's shape -> (SceneImage, notes). screen:
    width and height instead of the scene's, seen with the same field of view.
    files: a toml_model.Files with what was read already. progress: a job.Report."""
    progress = progress or Quiet()
    top = Table(data, name, TOP_KEYS)
    lens = _lens(top)
    if screen:
        lens = _on_screen(lens, screen)
    notes = []
    background = palette.parse(data.get("background", "#101820"), top.at("background"))
    kind, entries, start, gait = _path(top, frames)
    beams, lit = _beams(top)
    reserved = _reserved(top)
    light = toml_light.read(top)
    pictures = texture.Pictures(folder)
    objects = Objects(name, files, light, notes, progress, toml_texture.read(top, pictures),
                      toml_billboard.read(top, pictures))
    instances = []
    for number, item in enumerate(top.rows("objects")):
        progress(f"{name}: object {number}")
        instances += objects.instances(item, number)
    progress.stage(f"{name}: the palette and the models")
    instances, placements, motions = toml_motion.settle(instances)
    try:
        colours, indices, merged, in_beam = _palette(background, instances, reserved, light, lit)
    except ToolError as error:
        raise ToolError(f"{name}: {error}") from error
    if merged and not (_is_565(top) and len(_count_colours(instances, None)) < palette.ENTRIES - len(reserved)):
        notes.append(f"{name}: {_merged_text(merged, palette.ENTRIES - 1 - len(reserved), _is_565(top), isinstance(light, toml_light.RunTime))}")
    records = Records(indices)
    models, placed, boards = _models(instances, indices, records)
    scene = SceneImage(*lens[:-1], 0, colours, models, placed, kind, entries, start, gait)
    scene.centre = lens[-1]
    _target(top, scene)
    scene.layers = _layers(top)
    scene.beams, scene.placements, scene.motions, scene.surfaces = beams, placements, motions, records.result(
        colours, _blend(top), light.image.ramp if isinstance(light, toml_light.RunTime) else [], in_beam)
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
    scene.names = [item.name for item in instances]
    scene.moving = tuple(i for i, item in enumerate(instances) if item.moves)
    if target.has_colours(scene):   # the reader of the file spoke of means
        notes = [note for note in notes if not note.endswith(MEAN_NOTE)]
    if scene.depth_bits:    # whatever the order, the nearest face is seen
        notes = [note for note in notes if not note.endswith(SORTED_NOTE)]
    return scene, list(dict.fromkeys(notes))


def compile_file(path, frames=None, progress=None, screen=None):
    """A scene file -> (SceneImage, notes)."""
    folder, data = os.path.dirname(path), toml_table.read(path)
    return compile_data(data, shortened(os.path.basename(path)), folder, frames, progress, screen)
