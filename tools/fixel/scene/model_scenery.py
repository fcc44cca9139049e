# SPDX-License-Identifier: MIT
"""The lights of a glTF file as the light of a scene, and one of its cameras as the path (docs/scenes.md, "Lights and cameras of
a glTF file")."""

import fnmatch
from fractions import Fraction
import math

import numpy as np

from fixel.base.errors import ToolError
from fixel.base.reading import quoted, shortened
from fixel.image.image_light import POINTS_MAX
from fixel.model.quantity import COORDINATE_MAX
from fixel.scene import tracks

BEYOND = 1.5        # times the way to the farthest point of the model: the range of a light that names none
_NEAR_MIN = Fraction(1, 64)


def _exact(numbers, denominator=4096):
    return [Fraction(round(float(number) * denominator), denominator) for number in numbers]


def _within(place):
    """A place that a light may have: the nearest to the middle on the line to it, if it is outside the world."""
    return place * min(1.0, COORDINATE_MAX / max(np.abs(place).max(), 1e-9))


def light_keys(lights, place, radius, ambient):
    """(keys of [light], notes) of Lights. place: what makes world units of a point of the model. radius: of the model in
    world units, about the middle of the world."""
    suns = sorted((each for each in lights if each.kind == "directional"), key=lambda each: -each.strength)
    lamps = sorted((each for each in lights if each.kind != "directional"), key=lambda each: -each.strength)
    keys, notes = {"strength": 0}, []
    if suns and suns[0].strength > 0:
        direction = _exact(suns[0].matrix[:, 2], 1 << 16)
        keys = {"direction": direction, "strength": 1 - ambient}
    points = []
    for lamp in [lamp for lamp in lamps[:POINTS_MAX] if lamp.strength > 0]:
        at = _within(place(lamp.matrix[:, 3]))
        reach = place.scale * lamp.range if lamp.range else BEYOND * (float(np.linalg.norm(at)) + radius)
        points.append({"position": _exact(at), "range": Fraction(max(1, round(min(reach, COORDINATE_MAX) * 4096)), 4096),
                       "strength": Fraction(max(1, round(lamp.strength / lamps[0].strength * 4096)), 4096)})
    keys |= {"points": points} if points else {}
    for what, found in (("more directional lights than one: the brightest is taken", suns[1:]),
                        (f"more point lights than {POINTS_MAX}: the brightest are taken", lamps[POINTS_MAX:])):
        if found:
            notes.append(f"left out {what} (first: {shortened(found[0].name)})")
    for what, found in (("spot lights shine to all sides", [each for each in lights if each.kind == "spot"]),
                        ("lights have no colour", [each for each in lights if each.is_coloured])):
        if found:
            notes.append(f"{what}: {len(found):,} (first: {shortened(found[0].name)})")
    return keys, notes


def chosen(cameras, pattern, name):
    """The Camera whose name fits a pattern."""
    found = [camera for camera in cameras if fnmatch.fnmatchcase(camera.name, pattern)]
    if not found:
        there = shortened(", ".join(camera.name for camera in cameras)) or "none"
        raise ToolError(f"{name}: --camera: no camera has a name like {quoted(pattern)}; the file's: {there}")
    if found[0].angle is None and found[0].half is None:
        raise ToolError(f"{name}: --camera: {quoted(found[0].name)} has no perspective (without an angle of view), and is not orthographic with a "
                        "width; take another one")
    return found[0]


def camera_keys(camera, poses, place, screen, frames, reach):
    """(keys of [view], the path) of a Camera. poses: matrices of 3x4, one a frame, that move it, or None. place: as for
    lights. reach: of the model in world units, from the middle of the world."""
    width, height = screen
    if poses is None:
        seen = camera.matrix[None]
    else:
        moved = np.concatenate([poses[:, :, :3] @ camera.matrix[:, :3], poses[:, :, :3] @ camera.matrix[:, 3:] + poses[:, :, 3:]], axis=2)
        seen = moved[np.arange(frames) % len(moved)]
    turns, _, _ = tracks.similar(seen[:, :, :3])
    places, keys, frame = np.array([place(point) for point in seen[:, :, 3]]), [], 0
    for row in tracks.keys(places, turns, np.ones(len(places))):
        turn = row.get("turn", [0, 0, 0])
        keys.append({"position": row.get("offset", [0, 0, 0]), "yaw": turn[0], "pitch": turn[1], "roll": turn[2], "frames": row.get("frames", 1)})
        frame += keys[-1]["frames"]
    keys[-1]["frames"] += frames - frame
    if camera.half is not None:
        lens = {"scale": min(max(*_exact([width / (2 * camera.half * place.scale)]), Fraction(1, 16)), 4096)}
    else:
        slope = math.tan(math.radians(camera.angle / 2)) * width / height
        lens = {"fov": Fraction(min(max(round(2 * math.degrees(math.atan(slope)) * 100), 1000), 15000), 100)}
    near = max(_NEAR_MIN if camera.half is None else Fraction(1, 256), *_exact([camera.near * place.scale]))
    far = max(near * 2, *_exact([(float(np.sqrt((places ** 2).sum(axis=1)).max()) + reach) * 1.1]))
    return {**lens, "near": near, "far": far}, {"interpolation": "linear", "keys": keys}
