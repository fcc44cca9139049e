# SPDX-License-Identifier: MIT
"""The path of a scene that has none: once about all of it, in sight all the time."""

from fractions import Fraction
import math

from fixel.image import image
from fixel.scene import path
from fixel.base.errors import ToolError

FRAMES = 60
RISE = 15           # degrees that the camera looks down
MARGIN = Fraction(21, 20)


def _spheres(scene):
    """(centre, radius) of each instance in 2^-32 of a world unit."""
    radii = [image.radius_of(model.vertices) for model in scene.models]
    scales = [1 << 16] * (len(scene.objects) - len(scene.placements)) + [placement.scale for placement in scene.placements]
    return [(tuple(c << 16 for c in item.centre), radii[item.model] * scale) for item, scale in zip(scene.objects, scales)]


def _ball(scene):
    """Middle and radius of a ball about all instances."""
    spheres = _spheres(scene)
    middle = tuple(Fraction(min(c[i] - r for c, r in spheres) + max(c[i] + r for c, r in spheres), 2 << 32) for i in range(3))
    about, unit = tuple(map(float, middle)), 1 << 32
    return middle, max(math.dist(about, (x / unit, y / unit, z / unit)) + radius / unit for (x, y, z), radius in spheres)


def about(scene, frames, name):
    """(poses, notes): a circle about a scene, which is whole but for its path."""
    middle, radius = _ball(scene)
    across = math.tan(scene.fov * math.pi / 2 ** 32)
    half = min(math.atan(across), math.atan(across * scene.height / scene.width))
    distance = Fraction(math.ceil(256 * radius / math.sin(half) * MARGIN), 256)
    rise = math.radians(RISE)
    flat, height = (Fraction(round(4096 * float(distance) * part), 4096) for part in (math.cos(rise), math.sin(rise)))
    poses = path.orbit(middle, flat, height, frames or FRAMES, Fraction(0), 1)
    if any(abs(c) > image.COORDINATE_MAX for pose in poses for c in pose[:3]):
        raise ToolError(f"{name}: the scene has no path, and a circle about all of it would leave -8191..8191: give it a "
                        "path")
    notes = [f"{name}: no path is given: a circle about the scene, in {len(poses)} frames"]
    if float(distance) + radius > scene.far / 65536:
        notes.append(f"{name}: the far plane cuts what is seen from there: view.far = {math.ceil(float(distance) + radius)} "
                     "would show all")
    return poses, notes
