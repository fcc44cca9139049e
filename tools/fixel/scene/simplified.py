# SPDX-License-Identifier: MIT
"""What there is to say of objects whose models were given fewer faces: how many, and how far the surface moved, in world units
and in pixels."""

import math
from dataclasses import dataclass, field

from fixel.image import image

_UNIT = 65536


@dataclass
class Record:
    """A model that was simplified. result: a simplify.Result; asked: faces; scale: the most world units a unit of the file;
    balls: (centre, radius) of its instances in 1/65536, None for one that turns or moves."""
    name: str
    result: object
    asked: int
    scale: float = 0.0
    balls: list = field(default_factory=list)


def _nearest(scene, balls):
    """The least distance of a pose from a ball, in world units; None where that is not known."""
    if scene.path_kind != image.POSES or None in balls:
        return None
    least = min(math.dist(pose[:3], centre) - radius for pose in scene.path for centre, radius in balls)
    return max(least, scene.near) / _UNIT


def _short(number):
    """A number with two or three digits that say something."""
    return f"{number:,.0f}" if number >= 100 else f"{number:.3g}"


def note(scene, record):
    """One sentence; two where the model has more faces than were asked for."""
    result = record.result
    moved, nearest, left = result.deviation * record.scale, _nearest(scene, record.balls), len(result.mesh.faces)
    text = f"{record.name}: simplify: {result.before:,} triangles became {left:,}; the surface moved by at most " \
        f"{_short(moved)} units"
    if nearest is not None:
        focal = scene.width / 2 / math.tan(scene.fov * math.pi / 2 ** 32)
        text += f", {_short(moved * focal / nearest)} pixels at the nearest pose"
    if left > record.asked:
        text += f"; {record.asked:,} cannot be had without losing a group, or moving borders of materials or groups, or seams of texture coordinates"
    return text
