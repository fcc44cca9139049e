# SPDX-License-Identifier: MIT
"""Rotations of a scene file's objects, as Fractions."""

from fractions import Fraction
import math


def sine_cosine(angle):
    """Sine and cosine of degrees; exact at quarter turns."""
    angle %= 360
    if angle % 90 == 0:
        quarter = int(angle // 90)
        return Fraction((0, 1, 0, -1)[quarter]), Fraction((1, 0, -1, 0)[quarter])
    radians = math.radians(float(angle))
    return (Fraction(round(math.sin(radians) * 2 ** 52), 2 ** 52),
            Fraction(round(math.cos(radians) * 2 ** 52), 2 ** 52))


def matrix(scale, rotation):
    """Scale, then turn: an object turned by yaw, pitch and roll looks where a
    camera turned so would look. Its columns are the camera's rows (SPEC.md,
    section 1)."""
    (sy, cy), (sp, cp), (sr, cr) = (sine_cosine(a) for a in rotation)
    right = (cr * cy - sr * sp * sy, sr * cp, -cr * sy - sr * sp * cy)
    up = (-sr * cy - cr * sp * sy, cr * cp, sr * sy - cr * sp * cy)
    forward = (cp * sy, sp, cp * cy)
    return [[axis[row] * s for axis, s in zip((right, up, forward), scale)] for row in range(3)]
