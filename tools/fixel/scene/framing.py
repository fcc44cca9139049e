# SPDX-License-Identifier: MIT
"""A scene for a bare model file: the model in the middle, the camera about it."""

from dataclasses import dataclass, replace
from fractions import Fraction
import math
import os
import re

import numpy as np

from fixel.image import image
from fixel.model import creases, model_file
from fixel.scene import keys, model_parts, model_scenery, texture_size, toml_images, toml_model, toml_scene, toml_table
from fixel.base.errors import ToolError
from fixel.base.vectors import dot
from fixel.model.mesh import UNIT, newell, open_edges
from fixel.model.surface import MEAN_NOTE, MISSING_NOTE, TINT_NOTE
from fixel.base.notes import Usual
from fixel.base.reading import quoted, shortened
from fixel.scene.look import NO_ANIMATION, PLAIN
from fixel.scene.corner_normals import OWN_COSINE

WIDTH, HEIGHT, FOV = 320, 240, 60
MARGIN = 0.9        # how much of the screen the model may fill
RISE = 15           # degrees that the camera looks down
FRAMES = 60
LEVELS = 4          # of a texture
RAMP = 32           # levels of light at run time
SURFACES_MAX = 65_535   # faces of an image that may be smooth or have a texture
_FLAT = 1 - 1e-6    # the cosine between normals from which an edge is flat
_EYES = 24          # of a circle from which fronts are looked for
SIZE_MAX = 2e9      # of a model's radius: coordinates of a file are within 10^9
REACH_MAX = 4       # radii from the middle: as far as parts that move are followed
KEYS_MAX = 1 << 18  # of all parts: a quarter of a million take more than half of the largest image
YAWS_MAX = 120      # directions that are tried; between them a model reaches 0.04 % farther


@dataclass(frozen=True)
class Framing:
    """Where a model stands, and what it is seen by."""
    radius: int     # world units from the model's middle to its farthest vertex
    start: int      # yaw of the first frame in degrees
    light: tuple    # the way that the light travels


# Most models face +z in their file, which is -z here: the light falls on that side.
_LIGHT = (Fraction(8, 10), -1, Fraction(4, 10))
# A scene image: the front, from a corner.
WALK = Framing(4, 30, _LIGHT)
# A C header. An eye at (0, 2, -8) that looks ahead and down sees the whole model, and the side of
# it that the light falls on.
PROGRAM = Framing(2, 30, _LIGHT)


def _distance(points, start, frames, width, height):
    """How far the camera must stand from the middle so that every vertex is
    inside the screen in every frame. Per vertex, with sideways x, upward y and
    onward z about the middle: |x| <= slope * (distance + z)."""
    slope_x = MARGIN * math.tan(math.radians(FOV / 2))
    slope_y = slope_x * height / width
    rise, needed = math.radians(RISE), 0.0
    for i in range(min(frames, YAWS_MAX)):
        yaw = math.radians(start) + 2 * math.pi * i / min(frames, YAWS_MAX)
        x = points[:, 0] * math.cos(yaw) - points[:, 2] * math.sin(yaw)
        level = points[:, 0] * math.sin(yaw) + points[:, 2] * math.cos(yaw)
        y = points[:, 1] * math.cos(rise) + level * math.sin(rise)
        z = level * math.cos(rise) - points[:, 1] * math.sin(rise)
        needed = max(needed, (abs(x) / slope_x - z).max(), (abs(y) / slope_y - z).max())
    return needed


_BAKED = {"colour": "#fff2dc", "sky": "#c4d4ff"}


def _is_smooth(mesh, degrees):
    """Whether two faces of a mesh meet at an edge that does not show, and is not flat. degrees: as those of creases.smooth_pairs."""
    points = (np.array(mesh.vertices, dtype=float) / UNIT).tolist()     # of lists: an array for each face takes five times as long
    places, outlines, units, groups = {}, [], [], []
    numbers = [places.setdefault(vertex, len(places)) for vertex in mesh.vertices]
    for number, face in enumerate(mesh.faces):
        normal = newell([points[corner] for corner in face])
        length = math.sqrt(dot(normal, normal))
        if length > 0:
            outlines.append([numbers[corner] for corner in face])
            units.append([c / length for c in normal])
            groups.append(mesh.smoothing[number] if mesh.smoothing and degrees is None else None)
    where = (np.array(list(places), dtype=float) / UNIT).tolist()
    return any(dot(units[one], units[other]) < _FLAT for one, other in creases.smooth_pairs(where, outlines, units, [False] * len(units), degrees, groups))


def _has_own_normals(mesh):
    """(whether a face has normals of the file that are not its own, whether all faces have some)."""
    points, are_all = np.array(mesh.vertices, dtype=float).tolist(), True
    for face, normals in zip(mesh.faces, mesh.normals):
        if normals is None:
            are_all = False
            continue
        own = newell([points[corner] for corner in face])
        length = math.sqrt(dot(own, own))
        cosines = [dot(own, normal) / (length * math.sqrt(dot(normal, normal))) for normal in normals] if length else []
        if cosines and abs(sum(cosines)) > 0 and min(math.copysign(each, each * sum(cosines)) for each in cosines) < OWN_COSINE:
            return True, are_all
    return False, are_all


def _smoothness(mesh, look):
    """The value of smooth of a model's object: "file", degrees, or 0. A file whose normals are all those of its faces is flat; of one
    without normals and smoothing groups the shape decides."""
    if not look.smooth:
        return 0
    if look.normals and mesh.normals:
        bent, are_all = _has_own_normals(mesh)
        if bent or are_all:
            return "file" if bent else 0
    degrees = None if look.normals else look.smooth
    return ("file" if look.normals else look.smooth) if _is_smooth(mesh, degrees) else 0


@dataclass(frozen=True)
class Place:
    """Where points of a model are in the world: the middle of the model in the file's units, and world units of one of those."""
    middle: object
    scale: float

    def __call__(self, point):
        return (point - self.middle) * self.scale


AMBIENT = Fraction(1, 3)


def _without_image(mesh, name, look, read_notes):
    """What there is to say of a mesh whose faces have texture coordinates, and whose file names no material and no image; each image that
    a file names can be read."""
    if not look.texels or mesh.surfaces or not any(mesh.uvs) or any(note.endswith(MISSING_NOTE) for note in read_notes):
        return []
    return [f"{name}: there are texture coordinates, and no image is named: all faces have one colour. Name the image in the file (OBJ: mtllib, "
            "usemtl, and map_Kd in the MTL file; PLY: comment TextureFile), or in a scene file (texture, and mapping = \"file\")"]


def _look_of(mesh, look, moves, place, radius):
    """(the keys of the object, those of the light, notes) by which a mesh looks so. Light of the tool's own stays where every
    face has one colour, nothing moves, and the file has no lights."""
    if (look.texels or look.smooth) and len(mesh.faces) > SURFACES_MAX:
        return {}, _BAKED, [f"{len(mesh.faces):,} faces are more than the {SURFACES_MAX:,} that may be smooth or have a texture: all "
                            f"are flat; --simplify {SURFACES_MAX} has both"]
    unlit = bool(mesh.surfaces) and mesh.surfaces.are_unlit()
    images = look.texels and mesh.surfaces and toml_images.has_looks(mesh.surfaces)
    smooth = not unlit and _smoothness(mesh, look)
    thing = {"images": {"size": look.texels, "bits": look.bits, "levels": LEVELS}} if images else {}
    thing |= {"smooth": smooth} if smooth else {}
    thing |= {"vertex_colours": True} if look.pixels == "rgb565" and mesh.surfaces and mesh.surfaces.have_corners() else {}
    if unlit:
        return {**thing, "shade": False}, _BAKED, []
    some = [f"{mesh.surfaces.materials[number].name}" for number in sorted(set(mesh.surfaces.of_face))
            if mesh.surfaces.materials[number].is_unlit] if mesh.surfaces else []
    notes = [f"materials that light does not change are lit as the others are: {len(some):,} (first: {shortened(some[0])})"] if some else []
    if look.baked:
        if moves:
            raise ToolError("--bake-light: the animation moves parts of the model, whose light changes as they turn: leave --bake-light out")
        return thing, {**_BAKED, "bake": True} if images else _BAKED, notes
    lights = mesh.scenery.lights if not look.whole and mesh.scenery else []
    if any(light.strength > 0 for light in lights):
        keys, more = model_scenery.light_keys(lights, place, radius, AMBIENT)
        return thing, {"levels": RAMP, **keys}, notes + more
    return thing, {"levels": RAMP} if thing or moves else _BAKED, notes


def _turns_its_back(mesh, points, distance):
    """Whether a circle about a mesh sees the front of no face. points: its vertices about the middle of the circle."""
    corners = np.array([face[:3] for face in mesh.faces])
    first, second, third = (points[corners[:, place]] for place in range(3))
    normals, rise = np.cross(second - first, third - first), math.radians(RISE)
    for yaw in np.linspace(0, 2 * math.pi, _EYES, endpoint=False):
        eye = distance * np.array([math.cos(rise) * math.sin(yaw), math.sin(rise), math.cos(rise) * math.cos(yaw)])
        if (((eye - first) * normals).sum(axis=1) > 0).any():
            return False
    return True


def _sides(mesh, played, points, distance):
    """(the value of two_sided, notes). Parts of a closed model may be open where they were cut off: they show their fronts alone."""
    if mesh.scenery:
        if _turns_its_back(mesh, points, distance):
            return "open", ["the circle sees no face from its front: all faces show from both sides"]
        return "file", []
    return _open_sides(mesh, played), []


def _open_sides(mesh, played):
    if len(played.parts) == 1:
        return "open"
    numbers = {}
    for vertex in mesh.vertices:
        numbers.setdefault(vertex, len(numbers))
    return "open" if open_edges([[numbers[mesh.vertices[corner]] for corner in face] for face in mesh.faces]) else False


def scene_data(mesh, name, frames=None, screen=None, framing=WALK, look=PLAIN, played=None):
    """(the scene as a TOML file would say it, notes). screen: width and height, not the usual ones. look: a look.Look. played:
    a model_parts.Played; None: the whole model in one part."""
    played = played or model_parts.Played([model_parts.Part(None, [])])
    radius = framing.radius
    width, height = screen or (WIDTH, HEIGHT)
    points = np.array(mesh.vertices, dtype=float) / UNIT
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    points -= middle
    size = float(np.sqrt((points ** 2).sum(axis=1)).max())
    least = radius / keys.SCALE_MAX
    if not least < size < SIZE_MAX:
        raise ToolError(f"{shortened(name)}: the model's radius of {size:g} is outside {least:g}..{SIZE_MAX:g}: scale the model in the program that "
                        "made it, such as to a radius of 1")
    scale = toml_model.short(radius / size)
    played.notes += model_parts.leave_out_small(played, mesh, shortened(name), scale)
    moved, reach = (model_parts.moved_points(played, mesh) - middle) * float(scale), Fraction(radius)
    if len(moved):
        farthest = float(np.sqrt((moved ** 2).sum(axis=1)).max())
        reach = max(reach, Fraction(math.ceil(min(farthest, REACH_MAX * radius) * 64), 64))
        moved *= min(1.0, REACH_MAX * radius / max(farthest, 1e-9))
    distance = max(_distance(np.concatenate([points * float(scale), moved]), framing.start, frames or FRAMES, width, height),
                   reach * 1.1)
    distance = Fraction(math.ceil(distance * 64), 64)
    flat = Fraction(round(distance * 4096 * Fraction(math.cos(math.radians(RISE)))), 4096)
    rise = Fraction(round(distance * 4096 * Fraction(math.sin(math.radians(RISE)))), 4096)
    place = Place(middle, float(scale))
    thing, light, notes = _look_of(mesh, look, any(part.pose is not None for part in played.parts), place, radius)
    played.uses |= {"lights"} if "strength" in light else set()
    sides, more_notes = _sides(mesh, played, points * float(scale), float(distance))
    view = ({"pixels": "rgb565"} if look.pixels == "rgb565" else {}) | ({"depth": look.depth} if look.depth else {})
    seen = {"fov": FOV, "near": max(Fraction(3, 10), (distance - reach) * Fraction(9, 10)), "far": (distance + reach) * Fraction(11, 10)}
    path = {"orbit": {"radius": flat, "height": rise, "start": framing.start, "frames": frames or FRAMES}}
    if look.camera:
        camera = model_scenery.chosen(mesh.scenery.cameras if mesh.scenery else [], look.camera, shortened(name))
        seen, path = model_scenery.camera_keys(camera, played.poses.get(camera.name), place, (width, height),
                                               frames or played.frames or FRAMES, float(reach))
        played.uses.add("cameras")
        if camera.half is not None and camera.near == 0:
            notes.append(f"camera {quoted(camera.name)}: its znear is 0, and near is the least that a lens has")
    more = ({"simplify": look.simplify} if look.simplify else {}) | ({} if look.colours else {"vertex_colours": "none"})
    return {
        "screen": {"width": width, "height": height},
        "view": {**seen, **view},
        "background": "#1b2a38",
        "light": {"direction": list(framing.light), "ambient": AMBIENT, **light},
        "objects": model_parts.objects(played, mesh, name, scale, {"two_sided": sides, **thing, **more,
                                                                   **({} if mesh.surfaces else {"colour": "#e8a860"})}),
        "path": path,
    }, [f"{shortened(name)}: {note}" for note in notes + more_notes]


def _side_of_path(scene):
    """The most texels of a side of a texture that the path of a scene shows; 0 without textures."""
    return max((max(sides) for sides in texture_size.needed(scene).values()), default=0)


def _needs_no_depth(scene):
    """Whether a scene is one convex model: nothing of it hides anything of it."""
    return len(scene.objects) == 1 and scene.models[0].kind == image.CONVEX


def _without_colours(files, key, name):
    """(the key of the mesh without the colours of its faces and vertices, notes)."""
    plain = files.plain(key)
    said = "the colours that faces and vertices have in the file are left out" if plain is not key else \
        "the file has no colours of faces or vertices; those of its materials and images stay"
    return plain, [f"{name}: --no-colours: {said}"]


def compile_model(path, frames=None, progress=None, screen=None, framing=WALK, look=PLAIN, write=None):
    """A bare model file -> (SceneImage, notes). look: a look.Look. write: where the scene file is to stand that gives the
    same frames; it is then scene.text."""
    folder, name = os.path.split(path)
    files = toml_model.Files(folder)
    file = files.file(name)
    mesh, read_notes = model_file.reader_of(name)(path, str(file), progress, files.sources)
    mesh = toml_model.near_origin(mesh)
    files[file] = mesh
    key = files.fewer(file, look.simplify) if look.simplify else file
    if not look.colours:
        key, said = _without_colours(files, key, shortened(name))
        read_notes = [note for note in read_notes if not note.endswith((MEAN_NOTE, TINT_NOTE))] + said
    mesh = files[key]
    played = model_parts.divide(mesh, shortened(name), look)
    data, more = scene_data(mesh, name, frames, screen, framing, look, played)
    keys = sum(len(thing.get("motion", {}).get("keys", ())) for thing in data["objects"])
    if keys > KEYS_MAX:
        played = model_parts.divide(mesh, shortened(name), replace(look, animation=NO_ANIMATION))
        data, more = scene_data(mesh, name, frames, screen, framing, look, played)
        more.append(f"{shortened(name)}: the animation needs {keys:,} key frames, which are more than the limit of {KEYS_MAX:,}: the model stands "
                    "still; give it fewer joints, or a shorter animation")
    scene, notes = toml_scene.compile_data(data, str(file), folder, frames, progress, files=files)
    side, shown = 0 if look.is_fixed else _side_of_path(scene), [thing for thing in data["objects"] if "images" in thing]
    if shown and 0 < side < look.texels:
        for thing in shown:
            thing["images"] = {**thing["images"], "size": side}
        scene, notes = toml_scene.compile_data(data, str(file), folder, frames, progress, files=files)
    told = {mesh.scenery.left_out.get(kind) for kind in played.uses}
    if any(thing.get("vertex_colours") is True for thing in data["objects"]):
        read_notes = [note for note in read_notes if not note.endswith(MEAN_NOTE)]
    more += [] if files.sources.unread else _without_image(mesh, shortened(name), look, read_notes)
    read_notes, more, notes = [note for note in read_notes if note not in told], played.notes + more, _first_of_a_kind(notes)
    if scene.depth_bits and _needs_no_depth(scene):
        scene.depth_bits = 0
        del data["view"]["depth"]
    scene.names = [None if each == name else each for each in scene.names]  # the file's name says nothing to a program
    scene.names = scene.names if any(scene.names) else []
    scene.text = _text_of(data, path, write) if write else None
    return scene, read_notes + more + notes + [
        Usual(f"{file}: framed by default: scaled by {float(data['objects'][0]['scale']):.6g}, " +
              (f"seen by {shortened(look.camera)} for" if look.camera else "turned once in") + f" {len(scene.path)} frames")]


def _first_of_a_kind(notes):
    """Of notes that differ in numbers and names alone, as those of many parts do, the first, and how many there are."""
    found = {}
    for note in notes:
        found.setdefault(re.sub(r'\("[^"]*"\)|[0-9][0-9,.]*', "", note), []).append(note)
    return [type(same[0])(same[0] + (f" (the same holds for {len(same):,} parts)" if len(same) > 1 else "")) for same in found.values()]


def _text_of(data, path, write):
    """The scene file of a model that is to stand at a place."""
    model = os.path.relpath(path, os.path.dirname(write) or ".")
    return toml_table.text({**data, "objects": [{**thing, "model": model} for thing in data["objects"]]})
