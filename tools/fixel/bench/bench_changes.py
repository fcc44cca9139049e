# SPDX-License-Identifier: MIT
"""The bench's scenes: a scene file changed by name, so that one serves for several workloads and for variants of them; a head of 968
triangles, an egg whose lower half is narrower; the same scene with turned instances; and, for the bench's growth, a terrain of as many
faces as wanted, seen from above, so that all of them are in sight."""

import dataclasses
import functools
import itertools
import math
import pathlib
import random

from fixel.image.image import Face, Model, Object, POSES, SORTED
from fixel.image.image_placement import Key, Motion, Placement
from fixel.model import mesh
from fixel.model.quantity import TURN as WHOLE_TURN
from fixel.scene import keys, toml_scene, toml_table

# The plaza's textures, and what shows them: the first word or words of an object's name. What has no texture has its colour.
TEXTURES = [{"name": name, "pattern": name, "size": [32, 32], "levels": 4} for name in ("bricks", "stones", "planks", "crate")]
SHOWN_BY = {"paving": "stones", "columns": "stones", "feet": "stones", "stairs": "stones", "pedestals": "crate", "jambs": "bricks",
            "lintel": "bricks", "beams": "planks", "obelisks": "bricks", "trunks": "planks", "hedges": "planks",
            "fountain, step": "stones", "capitals": "stones"}
TEXELS_PER_UNIT = 12
LIGHT = {"levels": 32, "ambient": 0.3, "strength": 0.7, "direction": [0.5, -0.7, 0.5], "dark": "#000000"}
ROLL = 37           # degrees
HORIZON = {"degrees": [-40, -20, -8, -2, 0, 3, 10, 25, 50],
           "colours": ["#201008", "#382010", "#503018", "#684020", "#805028", "#c0d8f0", "#a0c0e8", "#80a8e0", "#6090d0", "#4070c0"]}
SCREENS = {"240x135": (240, 135), "480x320": (480, 320), "320x64": (320, 64), "32x64": (32, 64), "32x32": (32, 32)}
# Lights at the eye, of a model 3 units away: within its range, behind the model, and of too small a range.
POINTS = {"a point": [(0, 8)], "four points": [(0, 8)] * 4, "a point behind": [(6, 8)], "a point far away": [(0, 0.5)]}
HEAD = "head.obj"
SIDES, RINGS = 22, 23       # 2 x 22 x 22 triangles
HEAD_WIDTH, HEAD_HEIGHT, HEAD_DEPTH = 0.82, 1.2, 1.15
SPHERE = "coloured_sphere.obj"
SPHERE_SIDES, SPHERE_RINGS = 24, 16     # 2 x 24 x 15 triangles
TRIANGLES, FOCAL, TEXELS = 2000, 160, 64    # of a side of their texture, which has a texel a pixel
ONE = 65536                     # 16.16
NONE = Placement((1 << 30, 0, 0, 0, 1 << 30, 0, 0, 0, 1 << 30), ONE)
YAW, PITCH = (range(-3, 4), range(-2, 3))       # steps a frame, in 256ths of a turn; instances take them in turn
TERRAIN_WIDTH, TERRAIN_DEPTH = 16, 12       # units; the eye sees a little more
EYE = (0, 17 * ONE // 2, 0, 0, 3 << 30, 0)      # 8.5 units up, looking down by a quarter turn


def texture_of(name):
    """The texture that an object of this name shows; None for its colour."""
    return next((texture for start, texture in SHOWN_BY.items() if name.startswith(start)), None)


def _of_view(**keys):
    return lambda data: data.update(view={**data.get("view", {}), **keys})


def _of_textures(**keys):
    def change(data):
        data["textures"] = [{**row, **keys} for row in data["textures"]]
    return change


def _of_objects(**keys):
    def change(data):
        data["objects"] = [{**row, **keys} for row in data["objects"]]
    return change


def _textured(data):
    """Textures on most of what stands on the plaza's ground, and a depth buffer."""
    data["textures"] = TEXTURES
    _of_view(visibility="depth")(data)
    for thing in data["objects"]:
        texture = texture_of(thing.get("name", ""))
        if texture:
            thing.update(texture=texture, texels_per_unit=TEXELS_PER_UNIT)


def _lit(data):
    data["light"] = LIGHT
    for thing in data["objects"]:
        thing.pop("shade", None)
        thing["lit"] = True


def _plain(data):
    """No textures."""
    del data["textures"]
    for thing in data["objects"]:
        for key in ("texture", "texels_per_unit", "division"):
            thing.pop(key, None)


def _points(places):
    def change(data):
        data["light"]["points"] = [{"position": [0, 0, depth], "range": far, "strength": 0.2} for depth, far in places]
    return change


def _rolled(data):
    for key in data["path"]["keys"]:
        key["roll"] = key.get("roll", 0) + ROLL


def _half_a_pixel(data):
    _of_view(inset=0, centre=[data["screen"]["width"] / 2 + 0.5, data["screen"]["height"] / 2 + 0.5])(data)


def _horizon(data):
    """A horizon, and entries of the palette for it."""
    data["horizon"] = HORIZON
    for thing in data["objects"]:
        for key in ("colour_step", "colour_next"):
            thing.pop(key, None)


def _without_lines(data):
    """No lines and points, and no objects that have nothing else."""
    data["objects"] = [{key: value for key, value in thing.items() if key not in keys.LINES} for thing in data["objects"] if thing.get("solid") != "none"]


# Of a workload's `with`, in its order. SCREENS change the screen, with the same field of view.
CHANGES = {"textured": _textured, "lit": _lit, "depth": _of_view(visibility="depth"), "rgb565": _of_view(pixels="rgb565"),
           "affine": _of_objects(division="affine"), "divided": _of_objects(division=1),
           "128x32": _of_textures(size=[128, 32]), "32x128": _of_textures(size=[32, 128]),
           "256x256": _of_textures(size=[256, 256]), "levels": _of_textures(levels=4), "clamp": _of_textures(wrap="clamp"),
           "4 bits": _of_textures(bits=4), "16 bits": _of_textures(bits=16), "key": _of_textures(pattern="grille"),
           "stipple": _of_objects(opacity=8), "added": _of_objects(blend="add"), "rolled": _rolled, "half a pixel": _half_a_pixel,
           "plain": _plain, "horizon": _horizon, "without lines": _without_lines, "smooth": _of_objects(smooth=True), **{name: _points(places) for name, places in POINTS.items()}}


def _read(workload):
    """The tables of a workload's scene. A file of several scenes has what they share, and for each a table of its name."""
    data = toml_table.read(workload["scene"])
    own = data.get(workload.get("name"))
    if own is None:
        return data
    data = {**{key: value for key, value in data.items() if key in keys.TOP}, **own}
    data["path"] = {"keys": _walk(**data.pop("walk"))}
    for thing in data["objects"]:
        if "scattered" in thing:
            thing["positions"] = _scattered(*thing.pop("scattered"))
    return data


def _walk(frames, radius, height, yaw, pitch):
    """The keys of a circle about the middle, one a frame."""
    radius, height, yaw, pitch = map(float, (radius, height, yaw, pitch))
    angles = [math.tau * frame / frames for frame in range(frames)]
    return [{"position": [round(radius * math.sin(angle), 4), height, round(radius * math.cos(angle), 4)],
             "yaw": yaw + math.degrees(angle), "pitch": pitch} for angle in angles]


def has_textures(workload):
    """Whether the scene of a workload has any."""
    return "textures" in _read(workload)


def is_rgb565(workload):
    """Whether the scene of a workload asks for pixels of RGB565, and so is drawn to nothing else."""
    return _read(workload)["view"].get("pixels") == "rgb565"


def compile_file(workload, names, folder):
    """The scene of a workload, changed. folder: for the models that are generated."""
    path, data = workload["scene"], _read(workload)
    for name in names:
        CHANGES.get(name, lambda _: None)(data)
    here = pathlib.Path(path).parent
    for model in {row.get("obj") for row in data["objects"]} & MODELS.keys():
        here = pathlib.Path(folder)
        MODELS[model](here)
    screen = next((SCREENS[name] for name in names if name in SCREENS), None)
    compiled, _ = toml_scene.compile_data(data, pathlib.Path(path).name, str(here), screen=screen)
    return compiled


def _scattered(count, low, high):
    """So many places between two corners."""
    chance = random.Random(1)
    return [[round(chance.uniform(*map(float, each)), 3) for each in zip(low, high)] for _ in range(count)]


def _write(folder, name, points, faces):
    """Writes a model of triangles into a folder. faces: numbers of points, from 1."""
    lines = ["v " + " ".join(f"{value:.4f}" for value in point) for point in points]
    lines += [f"f {a} {b} {c}" for a, b, c in faces]
    (pathlib.Path(folder) / name).write_text("\n".join(lines) + "\n", encoding="ascii")


# --- a head -----------------------------------------------------------------------

def _corner_of_head(ring, side):
    """A corner, in 10,000ths of a unit."""
    down, around = math.pi * ring / RINGS, math.tau * side / SIDES
    wide = math.sin(down) * (HEAD_WIDTH - 0.22 * max(0, down - math.pi / 2))
    return tuple(round(10000 * value) for value in
                 (wide * math.sin(around), HEAD_HEIGHT * math.cos(down), -HEAD_DEPTH * wide * math.cos(around)))


def _number_in_head(ring, side):
    """A corner's number in the file; the tops are alone in their rings."""
    return 1 if ring == 0 else 2 + (RINGS - 1) * SIDES if ring == RINGS else 2 + (ring - 1) * SIDES + side % SIDES


def _faces_of_head():
    for ring in range(RINGS):
        for side in range(SIDES):
            upper, right = _number_in_head(ring, side), _number_in_head(ring, side + 1)
            lower_right, lower = _number_in_head(ring + 1, side + 1), _number_in_head(ring + 1, side)
            if ring > 0:
                yield upper, right, lower_right
            if ring < RINGS - 1:
                yield upper, lower_right, lower


def write_head(folder):
    """Writes the model into a folder."""
    points = [_corner_of_head(0, 0), *[_corner_of_head(ring, side) for ring in range(1, RINGS) for side in range(SIDES)], _corner_of_head(RINGS, 0)]
    _write(folder, HEAD, [[value / 10000 for value in point] for point in points], _faces_of_head())


# --- a sphere with a colour at each vertex ------------------------------------------

def _vertex_of_sphere(ring, side):
    """A place and a colour of the sphere of radius 1."""
    down, around = math.pi * ring / SPHERE_RINGS, math.tau * side / SPHERE_SIDES
    x, y, z = math.sin(down) * math.cos(around), math.cos(down), math.sin(down) * math.sin(around)
    return x, y, z, (1 + math.sin(3 * x)) / 2, (1 + math.cos(5 * y)) / 2, (1 + z) / 2


def _faces_of_sphere():
    for ring in range(SPHERE_RINGS):
        for side in range(SPHERE_SIDES):
            upper, right = [1 + ring * SPHERE_SIDES + each % SPHERE_SIDES for each in (side, side + 1)]
            lower, lower_right = upper + SPHERE_SIDES, right + SPHERE_SIDES
            if ring > 0:
                yield upper, right, lower_right
            if ring < SPHERE_RINGS - 1:
                yield upper, lower_right, lower


def write_sphere(folder):
    """Writes the model into a folder."""
    _write(folder, SPHERE, [_vertex_of_sphere(ring, side) for ring in range(SPHERE_RINGS + 1) for side in range(SPHERE_SIDES)], _faces_of_sphere())


# --- a ball, and grounds ------------------------------------------------------------------

def _divided(faces):
    """Triangles on the sphere of radius 1, each divided into four."""
    def between(a, b):
        middle = [x + y for x, y in zip(a, b)]
        return tuple(round(each / math.hypot(*middle), 9) for each in middle)
    for a, b, c in faces:
        ab, bc, ca = between(a, b), between(b, c), between(c, a)
        yield from ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))


def write_ball(folder):
    """Writes a ball of 20 x 4^4 triangles into a folder: an icosahedron whose faces are divided four times."""
    golden = (1 + math.sqrt(5)) / 2
    long = math.hypot(1, golden)
    corners = [tuple((place[-turn:] + place[:-turn])) for turn in range(3) for a in (-1, 1) for b in (-golden, golden)
               for place in [(0, a / long, b / long)]]
    faces = [(a, b, c) if _determinant(a, b, c) > 0 else (a, c, b) for a, b, c in itertools.combinations(corners, 3)
             if max(math.dist(a, b), math.dist(b, c), math.dist(c, a)) < 2.01 / long]
    for _ in range(4):
        faces = list(_divided(faces))
    numbers = {}
    faces = [[numbers.setdefault(corner, 1 + len(numbers)) for corner in face] for face in faces]
    _write(folder, "ball.obj", numbers, faces)


def _determinant(a, b, c):
    return sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))


def write_ground(folder, name, cells, size, height):
    """Writes a ground about the middle, of cells x cells squares of two triangles each, into a folder. height: of x, z and a number
    of chance from -1 to 1."""
    chance, row = random.Random(1), cells + 1
    places = [((line / cells - 0.5) * size[0], (0.5 - column / cells) * size[1]) for line in range(row) for column in range(row)]
    faces = [(first, *corners) for line in range(cells) for column in range(cells) for first in [1 + line * row + column]
             for corners in ((first + row, first + row + 1), (first + row + 1, first + 1))]
    _write(folder, name, [(x, height(x, z, chance.uniform(-1, 1)), z) for x, z in places], faces)


# --- triangles of one size -----------------------------------------------------------

def _triangle(radius, chance):
    """Three (place on the screen from its middle, in pixels), and how far they are from the eye."""
    x, y, away, turn = chance.uniform(-150, 150), chance.uniform(-110, 110), chance.uniform(1, 30), chance.uniform(0, math.tau)
    return [(x + radius * math.cos(turn + corner * math.tau / 3), y + radius * math.sin(turn + corner * math.tau / 3))
            for corner in range(3)], away


def write_triangles(folder, radius):
    """Writes triangles with equal sides that share no corner and face the eye, with all that a corner may have, into a folder."""
    chance, lines = random.Random(1), []
    for _ in range(TRIANGLES):
        corners, away = _triangle(radius, chance)
        for x, y in corners:
            lines.append(" ".join(["v", *(f"{value:.6f}" for value in (x * away / FOCAL, y * away / FOCAL, -away)),
                                   *(f"{chance.random():.3f}" for _ in range(3))]))
            lines.append(f"vt {x / TEXELS:.6f} {y / TEXELS:.6f}")
            lines.append(f"vn {chance.uniform(-0.5, 0.5):.3f} {chance.uniform(-0.5, 0.5):.3f} 1")
    lines += ["f " + " ".join("/".join([str(corner)] * 3) for corner in range(first, first + 3)) for first in range(1, 3 * TRIANGLES, 3)]
    (pathlib.Path(folder) / "triangles.obj").write_text("\n".join(lines) + "\n", encoding="ascii")


def triangles(scene, keys, radius, folder):
    """The scene of such triangles, whose corners are so many pixels from their middles. scene: its tables but for the object, whose
    keys are given by themselves."""
    write_triangles(folder, radius)
    data = {**scene, "objects": [{"name": "triangles", "obj": "triangles.obj", "kind": "sorted", **keys}]}
    return toml_scene.compile_data(data, "triangles", str(folder))[0]


# The models that are generated, by the files that scenes name: functions that write them into a folder.
MODELS = {HEAD: write_head, SPHERE: write_sphere, "triangles.obj": functools.partial(write_triangles, radius=2.2),
          "ball.obj": write_ball,
          "rough.obj": functools.partial(write_ground, name="rough.obj", cells=90, size=(16, 12), height=lambda x, z, chance: 0.071 * (1 + chance)),
          "hills.obj": functools.partial(write_ground, name="hills.obj", cells=64, size=(32, 32), height=lambda x, z, chance:
                                         0.78 * math.cos(math.tau * x / 16) * math.sin(math.tau * (16 - z) / 14) + 0.075 * chance)}


# --- turned instances --------------------------------------------------------------

def _spin(number, centre):
    """The motion of an instance that stays in its place. It starts at an angle of its own."""
    start = number * 0x9E3779B9 % WHOLE_TURN
    steps = [each[number % len(each)] * WHOLE_TURN // 256 % WHOLE_TURN for each in (YAW, PITCH)]
    return Motion([Key(0, centre, (start, 0, 0), ONE)], (steps[0], steps[1], 0))


def turned(scene, how):
    """The scene with a placement for each instance. how: "still", all placements are those of FXL_PLACEMENT_NONE and the picture is
    the scene's; "turning", the instances turn from frame to frame."""
    motions = [_spin(number, item.centre) for number, item in enumerate(scene.objects)] if how == "turning" else []
    return dataclasses.replace(scene, placements=[NONE] * len(scene.objects), motions=motions)


# --- a terrain ---------------------------------------------------------------------

def sides(cells):
    """Columns and rows of so many cells, as nearly square as they come."""
    wanted = math.sqrt(cells * TERRAIN_WIDTH / TERRAIN_DEPTH)
    columns = min((number for number in range(1, cells + 1) if cells % number == 0),
                  key=lambda number: abs(math.log(number / wanted)))
    return columns, cells // columns


def terrain(scene, faces, patch=None):
    """The scene with a terrain of triangles instead of its instances: one model, or a model for each patch of
    patch x patch cells."""
    columns, rows = sides(faces // 2)
    across, along = (patch, patch) if patch else (columns, rows)
    if faces % 2 or columns % across or rows % along:
        raise ValueError(f"{faces} triangles are no terrain of patches of {across} by {along} cells")
    models, objects = [], []
    for row in range(0, rows, along):
        for column in range(0, columns, across):
            objects.append(_add_patch(models, (columns, rows), range(column, column + across + 1), range(row, row + along + 1)))
    return dataclasses.replace(scene, models=models, objects=objects, path_kind=POSES, path=[EYE], start=EYE)


def _add_patch(models, size, columns, rows):
    """Adds the model of these lines of the grid; the instance of it."""
    points = [_corner_of_terrain(size, column, row) for row in rows for column in columns]
    low, high = points[0], points[-1]
    centre = ((low[0] + high[0]) // 2, 0, (low[2] + high[2]) // 2)
    vertices = [mesh.minus(point, centre) for point in points]
    width, faces = len(columns), []
    for row in range(len(rows) - 1):
        for column in range(width - 1):
            here = row * width + column
            for corners in ((here, here + width, here + width + 1), (here, here + width + 1, here + 1)):
                normal = mesh.unit_normal(mesh.newell([vertices[corner] for corner in corners]))
                faces.append(Face(normal, corners, 1 + len(faces) % 255))
    models.append(Model(vertices, faces, SORTED))
    return Object(centre, len(models) - 1)


def _corner_of_terrain(size, column, row):
    """A corner of the grid: slopes are below a quarter, so that every face is turned to the eye."""
    columns, rows = size
    x, z = column * TERRAIN_WIDTH * ONE // columns, row * TERRAIN_DEPTH * ONE // rows
    height = (5 * column + 3 * row) % 8 * min(TERRAIN_WIDTH * ONE // columns, TERRAIN_DEPTH * ONE // rows) // 32
    return x - TERRAIN_WIDTH * ONE // 2, height, z - TERRAIN_DEPTH * ONE // 2
