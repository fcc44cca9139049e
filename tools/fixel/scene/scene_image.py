# SPDX-License-Identifier: MIT
"""The scene image that a command draws."""

import pathlib
import sys

from fixel.base import output, reading
from fixel.base.errors import ToolError, one_line
from fixel.image import image as images
from fixel.image.fields import IMAGE_MAX
from fixel.scene import making, target


def check_frames(scene, wanted, there):
    """Refuses more frames than a path has."""
    if wanted > there:
        raise ToolError(f"{scene}: path: {wanted} frames are asked for, and the path has {there}")


def retargeted(scene, folder, asked):
    """A copy of a scene image, in folder, that is drawn as something else."""
    image = pathlib.Path(folder) / "scene.fxls"
    output.write_file(image, target.rewritten(reading.read_whole(scene, IMAGE_MAX, "give a scene image"), asked, scene))
    return image


def make_scene_image(scene, folder, frames, screen=None, limits=None, asked=None, verbose=False):
    """The scene image of a .toml or a model, compiled into folder; an .fxls is one already, and is copied into folder where
    it is to be drawn as something else. asked: a target.Target. verbose: as that of making.build."""
    if pathlib.Path(scene).suffix == ".fxls":
        if screen:
            raise ToolError(f"{scene} is a scene image, which has its screen already: give the .toml or the model")
        if frames:
            check_frames(scene, frames, images.load(scene).frames)
        return retargeted(scene, folder, asked) if asked else pathlib.Path(scene)
    image = folder / "scene.fxls"
    for note in making.build(scene, image, frames, screen, limits=limits, asked=asked, verbose=verbose).notes:
        print(f"  {one_line(note)}", file=sys.stderr)
    return image
