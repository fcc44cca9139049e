# SPDX-License-Identifier: MIT
"""A scene with textures and a depth buffer, for the bench: objects of a scene file get patterns by their names."""

import pathlib

from fixel.scene import toml_scene, toml_table

# The textures, and what shows them: the first word or words of an object's name. What has no texture has its colour.
TEXTURES = [{"name": name, "pattern": name, "size": [32, 32], "levels": 4} for name in ("bricks", "stones", "planks", "crate")]
SHOWN_BY = {"paving": "stones", "columns": "stones", "feet": "stones", "stairs": "stones", "pedestals": "crate", "jambs": "bricks",
            "lintel": "bricks", "beams": "planks", "obelisks": "bricks", "trunks": "planks", "hedges": "planks",
            "fountain, step": "stones", "capitals": "stones"}
TEXELS_PER_UNIT = 12


def texture_of(name):
    """The texture that an object of this name shows; None for its colour."""
    return next((texture for start, texture in SHOWN_BY.items() if name.startswith(start)), None)


def compile_file(path):
    """The scene of a file, with textures and a depth buffer."""
    data = toml_table.read(path)
    data["textures"] = TEXTURES
    data["view"] = {**data.get("view", {}), "visibility": "depth"}
    for thing in data["objects"]:
        texture = texture_of(thing.get("name", ""))
        if texture:
            thing.update(texture=texture, texels_per_unit=TEXELS_PER_UNIT)
    compiled, _ = toml_scene.compile_data(data, pathlib.Path(path).name, str(pathlib.Path(path).parent))
    return compiled
