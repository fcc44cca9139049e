# SPDX-License-Identifier: MIT
"""Paths: key frames into one pose a frame; and the path of a scene that has none, once about all of it, in sight all the time.

A pose at a key is exactly the key's; between keys each channel follows a
monotone cubic (Fritsch and Butland's harmonic mean of slopes) or a straight
line. A monotone cubic never leaves the range of its keys, so poses need no
range check of their own, and a camera that is to stand still stands still."""

import math
from dataclasses import dataclass
from fractions import Fraction

from fixel.base.errors import ToolError
from fixel.image import image
from fixel.model.quantity import angle, q16, shown


@dataclass
class Key:
    position: tuple             # Fractions
    frames: int                 # up to the next key; of the last, how long it holds
    yaw: Fraction = Fraction(0)     # degrees
    pitch: Fraction = Fraction(0)
    roll: Fraction = Fraction(0)
    target: tuple = None        # what it looks at, or None


def aim(eye, target, where):
    """Yaw and pitch in degrees that look from a point at another."""
    x, y, z = (float(t) - float(e) for t, e in zip(target, eye))
    if x == y == z == 0:
        raise ToolError(f"{where}: look_at is where the eye is; move one of them")
    return math.degrees(math.atan2(x, z)), math.degrees(math.atan2(y, math.hypot(x, z)))


def _resolve(keys, where):
    """Turns look_at into angles; a yaw next to one that was looked up goes the
    short way round."""
    for i, key in enumerate(keys):
        if key.target is not None:
            yaw, pitch = aim(key.position, key.target, f"{where} {i}")
            key.yaw, key.pitch = Fraction(yaw), Fraction(pitch)
        if i and (key.target is not None or keys[i - 1].target is not None):
            key.yaw += 360 * round((keys[i - 1].yaw - key.yaw) / 360)


def _slopes(values, steps):
    """Slope a frame at each key, for a monotone cubic."""
    secants = [(b - a) / n for a, b, n in zip(values, values[1:], steps)]
    slopes = [secants[0]]
    for left, right, n, m in zip(secants, secants[1:], steps, steps[1:]):
        if left * right <= 0:
            slopes.append(0.0)
        else:
            near, far = 2 * m + n, m + 2 * n
            slopes.append((near + far) / (near / left + far / right))
    return slopes + [secants[-1]]


def _between(a, b, slope_a, slope_b, steps, u, smooth):
    if not smooth:
        return a + (b - a) * u
    v = 1 - u
    return (a * v * v * (1 + 2 * u) + slope_a * steps * u * v * v
            + b * u * u * (1 + 2 * v) - slope_b * steps * u * u * v)


def _channels(keys, steps):
    """Each channel's values at the keys and slopes; those of the targets are
    None where there is nothing to look at."""
    columns = [[float(k.position[i]) for k in keys] for i in range(3)]
    columns += [[float(k.yaw) for k in keys], [float(k.pitch) for k in keys],
                [float(k.roll) for k in keys]]
    return [(values, _slopes(values, steps)) for values in columns]


def _target(keys, i, u, smooth):
    """Where to look between keys i and i + 1, both of which look at something."""
    v = u * u * (3 - 2 * u) if smooth else u
    return [float(a) + (float(b) - float(a)) * v
            for a, b in zip(keys[i].target, keys[i + 1].target)]


def _pose(position, yaw, pitch, roll):
    return (*(q16(c) for c in position), angle(yaw), angle(pitch), angle(roll))


def _inner(keys, channels, i, step, smooth, where):
    """The pose some steps after key i."""
    n = keys[i].frames
    u = step / n
    values = [_between(v[i], v[i + 1], s[i], s[i + 1], n, u, smooth) for v, s in channels]
    if keys[i].target is not None and keys[i + 1].target is not None:
        values[3:5] = aim(values[:3], _target(keys, i, u, smooth), f"{where} {i}, {step} frames on")
    return _pose(values[:3], *values[3:])


def poses(keys, smooth, where):
    """One pose a frame; all in the image's integers."""
    _resolve(keys, where)
    result = []
    channels = _channels(keys, [k.frames for k in keys[:-1]]) if len(keys) > 1 else []
    for i, key in enumerate(keys):
        exact = _pose(key.position, key.yaw, key.pitch, key.roll)
        if i + 1 == len(keys):
            return result + [exact] * key.frames
        result.append(exact)
        result += [_inner(keys, channels, i, step, smooth, where)
                   for step in range(1, key.frames)]
    return result


def orbit(centre, radius, height, frames, start, turns):
    """Poses on a circle, all looking at the centre. start is the yaw of the
    first frame in degrees."""
    result = []
    for i in range(frames):
        yaw = start + 360 * turns * Fraction(i, frames)
        turn = math.radians(float(yaw % 360))
        eye = (centre[0] - radius * Fraction(math.sin(turn)), centre[1] + height,
               centre[2] - radius * Fraction(math.cos(turn)))
        pitch = Fraction(-math.degrees(math.atan2(float(height), float(radius))))
        result.append(_pose(eye, yaw, pitch, Fraction(0)))
    return result


def describe(pose):
    """A pose for people."""
    x, y, z, yaw, pitch, roll = pose
    place = ", ".join(shown(Fraction(c, 65536)) for c in (x, y, z))
    turns = ", ".join(f"{a * 360 / 2**32:.3f}" for a in (yaw, pitch, roll))
    return f"({place}) turned ({turns}) degrees"


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
    poses = orbit(middle, flat, height, frames or FRAMES, Fraction(0), 1)
    if any(abs(c) > image.COORDINATE_MAX for pose in poses for c in pose[:3]):
        raise ToolError(f"{name}: the scene has no path, and a circle about all of it would leave -8191..8191: give it a "
                        "path")
    notes = [f"{name}: no path is given: a circle about the scene, in {len(poses)} frames"]
    if float(distance) + radius > scene.far / 65536:
        notes.append(f"{name}: the far plane cuts what is seen from there: view.far = {math.ceil(float(distance) + radius)} "
                     "would show all")
    return poses, notes
