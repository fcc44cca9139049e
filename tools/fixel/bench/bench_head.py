# SPDX-License-Identifier: MIT
"""A head of 968 triangles, for the bench: an egg whose lower half is narrower."""

import math
import pathlib

NAME = "head.obj"
SIDES, RINGS = 22, 23       # 2 x 22 x 22 triangles
WIDTH, HEIGHT, DEPTH = 0.82, 1.2, 1.15


def _point(ring, side):
    """A corner, in 10,000ths of a unit."""
    down, around = math.pi * ring / RINGS, math.tau * side / SIDES
    wide = math.sin(down) * (WIDTH - 0.22 * max(0, down - math.pi / 2))
    return tuple(round(10000 * value) for value in
                 (wide * math.sin(around), HEIGHT * math.cos(down), -DEPTH * wide * math.cos(around)))


def _number(ring, side):
    """A corner's number in the file; the tops are alone in their rings."""
    return 1 if ring == 0 else 2 + (RINGS - 1) * SIDES if ring == RINGS else 2 + (ring - 1) * SIDES + side % SIDES


def _faces():
    for ring in range(RINGS):
        for side in range(SIDES):
            upper, right = _number(ring, side), _number(ring, side + 1)
            lower_right, lower = _number(ring + 1, side + 1), _number(ring + 1, side)
            if ring > 0:
                yield upper, right, lower_right
            if ring < RINGS - 1:
                yield upper, lower_right, lower


def write(folder):
    """Writes the model into a folder."""
    points = [_point(0, 0), *[_point(ring, side) for ring in range(1, RINGS) for side in range(SIDES)], _point(RINGS, 0)]
    lines = ["v " + " ".join(f"{value / 10000:.4f}" for value in point) for point in points]
    lines += [f"f {a} {b} {c}" for a, b, c in _faces()]
    (pathlib.Path(folder) / NAME).write_text("\n".join(lines) + "\n", encoding="ascii")
