# SPDX-License-Identifier: MIT
"""The scene image that a command draws."""

import pathlib
import sys

from fixel.base.errors import ToolError, one_line
from fixel.image import image as images
from fixel.scene import making


def check_frames(scene, wanted, there):
    """Refuses more frames than a path has."""
    if wanted > there:
        raise ToolError(f"{scene}: path: {wanted} frames are asked for, and the path has {there}")


def make_scene_image(scene, folder, frames, screen=None, limits=None):
    """The scene image of a .toml or a model, compiled into folder; an .fxls is one already."""
    if pathlib.Path(scene).suffix == ".fxls":
        if screen:
            raise ToolError(f"{scene} is a scene image, which has its screen already: give the .toml or the model")
        if frames:
            check_frames(scene, frames, images.load(scene).frames)
        return pathlib.Path(scene)
    image = folder / "scene.fxls"
    for note in making.build(scene, image, frames, screen, limits=limits).notes:
        print(f"  {one_line(note)}", file=sys.stderr)
    return image
