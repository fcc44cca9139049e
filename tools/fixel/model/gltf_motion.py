# SPDX-License-Identifier: MIT
"""Animations of glTF: where a node is in each frame. Nothing is checked before it is asked for: a file whose animation is
damaged is still a model."""

import fnmatch

import numpy as np

from fixel.model import gltf_check
from fixel.base.reading import quoted
from fixel.model.nodes import FRAMES_MAX, RATE

_WIDTHS = {"translation": ("VEC3",), "rotation": ("VEC4",), "scale": ("VEC3",)}
_VALUES = (gltf_check.FLOAT, 5120, 5121, 5122, 5123)
_STEP, _LINEAR, _CUBIC = "STEP", "LINEAR", "CUBICSPLINE"
STEPS_MAX = 1 << 20         # values of a track


def _slerp(one, other, part):
    """Unit quaternions between two, the short way; part: a column of 0..1."""
    cosine = (one * other).sum(axis=1, keepdims=True)
    other, cosine = np.where(cosine < 0, -other, other), np.minimum(np.abs(cosine), 1.0)
    angle = np.arccos(cosine)
    sine = np.where(angle < 1e-4, 1.0, np.sin(angle))
    p = np.where(angle < 1e-4, 1 - part, np.sin((1 - part) * angle) / sine)
    q = np.where(angle < 1e-4, part, np.sin(part * angle) / sine)
    return p * one + q * other


def between(times, values, mode, at, turns):
    """The values of a track at some times. values: of a cubic track three rows a time: the tangent before, the value, the
    tangent after. turns: whether they are quaternions."""
    cubic = mode == _CUBIC
    points = values[1::3] if cubic else values
    at = np.clip(at, times[0], times[-1])
    first = np.clip(np.searchsorted(times, at, "right") - 1, 0, max(len(times) - 2, 0))
    if len(times) == 1:
        return np.repeat(points, len(at), axis=0)
    step = (times[first + 1] - times[first])[:, None]
    part = np.where(step > 0, (at - times[first])[:, None] / np.where(step > 0, step, 1), 1)    # of two values at one time the second
    one, other = points[first], points[first + 1]
    if mode == _STEP:
        return np.where(part < 1, one, other)
    if not cubic:
        return _slerp(one, other, part) if turns else one + (other - one) * part
    after, before = values[2::3][first] * step, values[0::3][first + 1] * step
    square, cube = part ** 2, part ** 3
    return (2 * cube - 3 * square + 1) * one + (cube - 2 * square + part) * after + (3 * square - 2 * cube) * other + (cube - square) * before


class Animation:
    """An animation of a file. channels: {node: {path: (where, sampler)}}."""

    def __init__(self, checked, number):
        self.checked, self.where, self.tracks = checked, checked.label("animation", number), {}
        entry, self.name = checked.rows("animations")[number], names(checked)[number]
        samplers, self.channels, self.others = entry.get("samplers"), {}, 0
        for channel in entry.get("channels") if isinstance(entry.get("channels"), list) else []:
            target = channel.get("target") if isinstance(channel, dict) else None
            if not isinstance(target, dict) or not isinstance(target.get("node"), int) or target.get("path") not in list(_WIDTHS):
                self.others += 1
                continue
            sampler = channel.get("sampler")
            if not isinstance(samplers, list) or not isinstance(sampler, int) or not 0 <= sampler < len(samplers) \
                    or not isinstance(samplers[sampler], dict):
                checked.fail(self.where, "a channel has no sampler: the file is damaged")
            self.channels.setdefault(target["node"], {})[target["path"]] = samplers[sampler]

    def _track(self, node, path):
        """(times, values, mode) of a channel."""
        key = node, path
        if key not in self.tracks:
            checked, sampler = self.checked, self.channels[node][path]
            where, mode = f"{self.where}: {path} of node {node}", sampler.get("interpolation", _LINEAR)
            if mode not in (_STEP, _LINEAR, _CUBIC):
                checked.fail(where, f"the interpolation {quoted(mode)} does not exist: the file is damaged")
            times = checked.accessor(sampler.get("input"), where, ("SCALAR",), (gltf_check.FLOAT,))[:, 0]
            values = checked.accessor(sampler.get("output"), where, _WIDTHS[path], _VALUES).astype(float)
            if not len(times) or len(values) != len(times) * (3 if mode == _CUBIC else 1) or not np.isfinite(times).all() \
                    or not np.isfinite(values).all() or (np.diff(times) < 0).any() or len(times) > STEPS_MAX:
                checked.fail(where, "its times fall, or are not as many as its values: the file is damaged; save its animations anew, or "
                             "without this one")
            self.tracks[key] = times, values, mode
        return self.tracks[key]

    @property
    def seconds(self):
        """When its last track ends."""
        return max((float(self._track(node, path)[0][-1]) for node, paths in self.channels.items() for path in paths), default=0.0)

    @property
    def frames(self):
        """How many it takes; at least one."""
        return max(1, min(round(self.seconds * RATE), FRAMES_MAX))

    def local(self, number, node, count):
        """Matrices of 4x4 of a node in its parent, one a frame. node: its entry, which says what does not move."""
        at, paths = np.arange(count) / RATE, self.channels[number]

        def values(path, still):
            if path not in paths:
                return np.repeat([node.get(path, still)], count, axis=0).astype(float)
            return between(*self._track(number, path), at, path == "rotation")
        made = np.repeat([np.eye(4)], count, axis=0)
        turn = values("rotation", [0, 0, 0, 1])
        x, y, z, w = (turn / np.maximum(np.linalg.norm(turn, axis=1, keepdims=True), 1e-9)).T
        rows = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                         [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                         [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
        made[:, :3, :3] = rows.transpose(2, 0, 1) * values("scale", [1, 1, 1])[:, None, :]
        made[:, :3, 3] = values("translation", [0, 0, 0])
        return made


def names(checked):
    """Those of the animations of a file."""
    return [entry["name"] if isinstance(entry.get("name"), str) else f"animation {number}" for number, entry in
            enumerate(checked.rows("animations"))]


def chosen(checked, name):
    """The Animation that is played: the first that moves a node, or the first of this name; None without one."""
    for number in range(len(checked.rows("animations"))):
        found = Animation(checked, number)
        if found.channels and (name is None or fnmatch.fnmatchcase(found.name, name)):
            return found
    return None
