# SPDX-License-Identifier: MIT
"""Changes of a scene file by name, for the bench: one file serves for several workloads, and for variants of them."""

import pathlib

from fixel.bench import bench_head
from fixel.scene import toml_scene, toml_table

# The plaza's textures, and what shows them: the first word or words of an object's name. What has no texture has its colour.
TEXTURES = [{"name": name, "pattern": name, "size": [32, 32], "levels": 4} for name in ("bricks", "stones", "planks", "crate")]
SHOWN_BY = {"paving": "stones", "columns": "stones", "feet": "stones", "stairs": "stones", "pedestals": "crate", "jambs": "bricks",
            "lintel": "bricks", "beams": "planks", "obelisks": "bricks", "trunks": "planks", "hedges": "planks",
            "fountain, step": "stones", "capitals": "stones"}
TEXELS_PER_UNIT = 12
LIGHT = {"levels": 32, "ambient": 0.3, "strength": 0.7, "direction": [0.5, -0.7, 0.5], "dark": "#000000"}
ROLL = 37           # degrees
SCREENS = {"240x135": (240, 135), "480x320": (480, 320), "320x64": (320, 64), "32x64": (32, 64), "32x32": (32, 32)}
# Lights at the eye, of a model 3 units away: within its range, behind the model, and of too small a range.
POINTS = {"a point": [(0, 8)], "four points": [(0, 8)] * 4, "a point behind": [(6, 8)], "a point far away": [(0, 0.5)]}


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
    _of_view(centre=[data["screen"]["width"] / 2 + 0.5, data["screen"]["height"] / 2 + 0.5])(data)


# Of a workload's `with`, in its order. SCREENS change the screen, with the same field of view.
CHANGES = {"textured": _textured, "lit": _lit, "depth": _of_view(visibility="depth"), "rgb565": _of_view(pixels="rgb565"),
           "affine": _of_objects(division="affine"), "divided": _of_objects(division=1),
           "128x32": _of_textures(size=[128, 32]), "32x128": _of_textures(size=[32, 128]),
           "256x256": _of_textures(size=[256, 256]), "levels": _of_textures(levels=4), "clamp": _of_textures(wrap="clamp"),
           "4 bits": _of_textures(bits=4), "16 bits": _of_textures(bits=16), "key": _of_textures(pattern="grille"),
           "stipple": _of_objects(opacity=8), "rolled": _rolled, "half a pixel": _half_a_pixel,
           "plain": _plain, "smooth": _of_objects(smooth=True), **{name: _points(places) for name, places in POINTS.items()}}


def has_textures(path):
    """Whether a scene file has any."""
    return "textures" in toml_table.read(path)


def compile_file(path, names, folder):
    """The scene of a file, changed. folder: for the models that are generated."""
    data = toml_table.read(path)
    for name in names:
        CHANGES.get(name, lambda _: None)(data)
    here = pathlib.Path(path).parent
    if any(row.get("obj") == bench_head.NAME for row in data["objects"]):
        here = pathlib.Path(folder)
        bench_head.write(here)
    screen = next((SCREENS[name] for name in names if name in SCREENS), None)
    compiled, _ = toml_scene.compile_data(data, pathlib.Path(path).name, str(here), screen=screen)
    return compiled
