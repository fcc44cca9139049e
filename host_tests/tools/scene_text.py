# SPDX-License-Identifier: MIT
"""Scene files of a test: their text, compiled."""

from fixel.image import image
from fixel.scene import toml_scene

PATH = "[path]\nkeys = [{ position = [0, 0, 0] }]\n"


def build(folder, text):
    """The scene of a text, with a path of one pose; its image holds all of it."""
    file = folder / "scene.toml"
    file.write_text(text + PATH)
    scene, _ = toml_scene.compile_file(str(file))
    assert image.unpack(image.pack(scene)) == scene
    return scene
