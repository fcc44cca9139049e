# SPDX-License-Identifier: MIT
"""A scene for a bare model file: the model in the middle, the camera about it."""

from dataclasses import dataclass, replace
from fractions import Fraction
import math
import os

import numpy as np

from fixel.model import model_file
from fixel.scene import toml_model, toml_scene
from fixel.base.errors import ToolError
from fixel.model.mesh import UNIT
from fixel.base.reading import shortened

WIDTH, HEIGHT, FOV = 320, 240, 60
MARGIN = 0.9        # how much of the screen the model may fill
RISE = 15           # degrees that the camera looks down
FRAMES = 60
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


def _centred(mesh):
    """The mesh about its origin, if it is farther from there than it is large: the scale could not hold both."""
    low, high = ([end(axis) for axis in zip(*mesh.vertices)] for end in (min, max))
    middle = [(a + b) // 2 for a, b in zip(low, high)]
    if max(map(abs, middle)) <= max(b - a for a, b in zip(low, high)):
        return mesh
    return replace(mesh, vertices=[tuple(c - m for c, m in zip(vertex, middle)) for vertex in mesh.vertices])


def scene_data(mesh, name, frames=None, screen=None, framing=WALK):
    """The scene as a TOML file would say it. screen: width and height, not the usual ones."""
    radius = framing.radius
    width, height = screen or (WIDTH, HEIGHT)
    points = np.array(mesh.vertices, dtype=float) / UNIT
    points -= (points.min(axis=0) + points.max(axis=0)) / 2
    size = float(np.sqrt((points ** 2).sum(axis=1)).max())
    if not 1e-9 < size < 1e9:
        raise ToolError(f"{shortened(name)}: the model's radius of {size:g} cannot be framed")
    scale = toml_model.short(radius / size)
    distance = max(_distance(points * float(scale), framing.start, frames or FRAMES, width, height),
                   radius * 1.1)
    distance = Fraction(math.ceil(distance * 64), 64)
    flat = Fraction(round(distance * 4096 * Fraction(math.cos(math.radians(RISE)))), 4096)
    rise = Fraction(round(distance * 4096 * Fraction(math.sin(math.radians(RISE)))), 4096)
    return {
        "screen": {"width": width, "height": height},
        "view": {"fov": FOV, "near": max(Fraction(3, 10), (distance - radius) * Fraction(9, 10)),
                 "far": (distance + radius) * Fraction(11, 10)},
        "background": "#1b2a38",
        "light": {"direction": list(framing.light), "ambient": Fraction(1, 3),
                  "colour": "#fff2dc", "sky": "#c4d4ff"},
        "objects": [{"name": name, "model": name, "scale": scale, "anchor": "middle", "two_sided": "open",
                     **({} if mesh.surfaces else {"colour": "#e8a860"})}],
        "path": {"orbit": {"radius": flat, "height": rise, "start": framing.start,
                           "frames": frames or FRAMES}},
    }


def compile_model(path, frames=None, progress=None, screen=None, framing=WALK):
    """A bare model file -> (SceneImage, notes)."""
    folder, name = os.path.split(path)
    files = toml_model.Files(folder)
    file = files.file(name)
    mesh, read_notes = model_file.reader_of(name)(path, str(file), progress, files.sources)
    mesh = _centred(mesh)
    files[file] = mesh
    data = scene_data(mesh, name, frames, screen, framing)
    scene, notes = toml_scene.compile_data(data, str(file), folder, frames, progress, files=files)
    scene.names = []    # the file's name, which says nothing to a program
    return scene, read_notes + notes + [f"{file}: framed by default: scaled by "
                           f"{float(data['objects'][0]['scale']):.6g}, turned once in "
                           f"{len(scene.path)} frames"]
