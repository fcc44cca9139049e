# SPDX-License-Identifier: MIT
"""Matrices, one a frame, as the key frames of a scene file's motion: offset, turn and size. A key that lies between its
neighbours as the board would put it is left out."""

from fractions import Fraction
import math

import numpy as np

STRETCH_MAX = 0.01      # of its size: what a matrix may be off a turn with one scale
SIZE_MIN, SIZE_MAX = 1 / 256, 256
_OFFSET, _DEGREES, _SIZE = 1 / 4096, 0.05, 1e-4     # units, degrees, a part: what a key may be off that is left out


def similar(linear):
    """(turns, sizes, the worst stretch): the nearest turn with one scale of each 3x3 matrix."""
    u, sizes, v = np.linalg.svd(linear)
    u[:, :, 2] *= np.sign(np.linalg.det(u @ v))[:, None]
    turns, mean = u @ v, np.maximum(sizes.mean(axis=1), 1e-12)
    off = np.abs(linear - turns * mean[:, None, None]).max(axis=(1, 2)) / mean
    return turns, np.clip(mean, SIZE_MIN, SIZE_MAX), float(off[mean > SIZE_MIN].max(initial=0.0))


def _angles(turn, before):
    """Yaw, pitch and roll of a turn in degrees (SPEC.md, section 1), of those that say it the nearest to these."""
    right, up, ahead = turn.T
    if abs(ahead[1]) > 1 - 1e-12:       # straight up or down: yaw and roll are about one axis
        around, sign = math.degrees(math.atan2(-right[2], right[0])), math.copysign(1, ahead[1])
        ways = [(around - sign * before[2], 90 * sign, before[2])]
    else:
        yaw, pitch, roll = math.atan2(ahead[0], ahead[2]), math.asin(ahead[1]), math.atan2(right[1], up[1])
        ways = [tuple(map(math.degrees, (yaw, pitch, roll))), tuple(map(math.degrees, (yaw + math.pi, math.pi - pitch, roll + math.pi)))]
    near = [tuple(a + 360 * round((b - a) / 360) for a, b in zip(way, before)) for way in ways]
    return min(near, key=lambda way: sum((a - b) ** 2 for a, b in zip(way, before)))


def angles(turns):
    """Yaw, pitch and roll of each turn in degrees, without jumps."""
    found, last = [], (0.0, 0.0, 0.0)
    for turn in turns:
        last = _angles(turn, last)
        found.append(last)
    return np.array(found)


def _needed(values, most):
    """The rows of a table, in order, between which all others lie on straight lines, but for so much. The first and the last
    are among them."""
    kept, first, end = [0], 0, len(values) - 1

    def fits(last):
        part = (np.arange(first, last + 1) - first)[:, None] / (last - first)
        return (np.abs(values[first] + (values[last] - values[first]) * part - values[first:last + 1]) <= most).all()
    while first < end:
        good, step = first + 1, 1
        while good < end and fits(min(good + step, end)):
            good, step = min(good + step, end), 2 * step
        bad = min(good + step, end + 1)     # the last that fits lies between
        while bad - good > 1:
            middle = (good + bad) // 2
            good, bad = (middle, bad) if fits(middle) else (good, middle)
        kept.append(good)
        first = good
    return kept


def _exact(numbers, denominator):
    return [Fraction(round(float(number) * denominator), denominator) for number in numbers]


def keys(offsets, turns, sizes):
    """The rows of motion.keys: offsets in units, turns as matrices, sizes, one a frame."""
    degrees = angles(turns)
    table = np.column_stack([offsets, degrees, sizes])
    kept = _needed(table, np.array([_OFFSET] * 3 + [_DEGREES] * 3 + [_SIZE]))
    rows = []
    for place, frame in enumerate(kept):
        row, frames = {}, kept[place + 1] - frame if place + 1 < len(kept) else 1
        offset, turn, size = _exact(offsets[frame], 65536), _exact(degrees[frame], 1000), _exact([sizes[frame]], 65536)[0]
        row |= {"frames": frames} if frames != 1 else {}
        row |= {"offset": offset} if any(offset) else {}
        row |= {"turn": turn} if any(turn) else {}
        rows.append(row | ({"size": size} if size != 1 else {}))
    return rows
