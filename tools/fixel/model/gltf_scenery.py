# SPDX-License-Identifier: MIT
"""Cameras and lights (KHR_lights_punctual) of a glTF file. A light whose values make no sense is refused; a kind that is not known is
left out. A camera whose values make no sense has no perspective: only who asks for it learns of it."""

import math

import numpy as np

from fixel.base.errors import ToolError
from fixel.model.nodes import Camera, Light

_EXTENSION = "KHR_lights_punctual"
_KINDS = ("directional", "point", "spot")
_FLIP = np.diag([1.0, 1.0, -1.0, 1.0])
_GREY = (0.2126, 0.7152, 0.0722)    # what red, green and blue are of a brightness


def _placed(world):
    """A matrix of 3x4 from a node to the vertices as they are read: its z looks where the node's -z does, and axes have unit
    length."""
    made = (_FLIP @ world @ _FLIP)[:3]
    lengths = np.linalg.norm(made[:, :3], axis=0)
    return np.column_stack([made[:, :3] / np.where(lengths > 0, lengths, 1), made[:, 3]])


def _number(checked, table, key, default, where, least=0.0):
    value = table.get(key, default)
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not least <= value <= 1e12:
        checked.fail(where, f"{key} must be a number from {least:g} to 1e12: the file is damaged")
    return float(value)


def camera(checked, number, name, world):
    """The Camera at a node; None where it has none, or one without perspective."""
    node = checked.rows("nodes")[number]
    if "camera" not in node:
        return None
    chosen, entry = checked.entry("cameras", node, "camera", checked.label("node", number))
    table, where = entry.get("perspective"), checked.label("camera", chosen)
    if not isinstance(table, dict):
        return Camera(name, None, None, _placed(world))
    try:
        angle, near = (_number(checked, table, key, 0.0, where) for key in ("yfov", "znear"))
    except ToolError:
        angle, near = 0.0, 0.0
    return Camera(name, math.degrees(angle) if 0 < angle < math.pi else None, near, _placed(world))


def _entries(checked):
    """The lights at the top of the file."""
    extensions = checked.data.get("extensions")
    table = extensions.get(_EXTENSION) if isinstance(extensions, dict) else None
    rows = table.get("lights") if isinstance(table, dict) else None
    return rows if isinstance(rows, list) else []


def light(checked, number, name, world):
    """The Light at a node, or None."""
    extensions, where = checked.rows("nodes")[number].get("extensions"), checked.label("node", number)
    table = extensions.get(_EXTENSION) if isinstance(extensions, dict) else None
    if not isinstance(table, dict):
        return None
    rows, chosen = _entries(checked), checked.whole(table, "light", where)
    if chosen >= len(rows) or not isinstance(rows[chosen], dict):
        checked.fail(where, f"light {chosen} does not exist; there are {len(rows)}")
    entry, where = rows[chosen], f"light {chosen}"
    colour = entry.get("color", [1, 1, 1])
    if not isinstance(colour, list) or len(colour) != 3 or not all(isinstance(c, (int, float)) and 0 <= c <= 1e6 for c in colour):
        checked.fail(where, "color must be three numbers: the file is damaged")
    if entry.get("type") not in _KINDS:
        return None
    strength = _number(checked, entry, "intensity", 1.0, where) * sum(c * g for c, g in zip(colour, _GREY))
    reach = _number(checked, entry, "range", None, where)
    return Light(name, entry["type"], strength, reach, max(colour) - min(colour) > 0.02 * max(colour), _placed(world))
