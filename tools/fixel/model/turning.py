# SPDX-License-Identifier: MIT
"""Rotations of a scene file's objects, as Fractions."""

from fractions import Fraction
import math


_ONE = 1 << 52


def _sine_cosine(angle):
    """Sine and cosine of degrees in 2^-52; exact at quarter turns."""
    angle %= 360
    if angle % 90 == 0:
        quarter = int(angle // 90)
        return (0, _ONE, 0, -_ONE)[quarter], (_ONE, 0, -_ONE, 0)[quarter]
    radians = math.radians(float(angle))
    return round(math.sin(radians) * _ONE), round(math.cos(radians) * _ONE)


def sine_cosine(angle):
    """Sine and cosine of degrees; exact at quarter turns."""
    return tuple(Fraction(value, _ONE) for value in _sine_cosine(angle))


def matrix(scale, rotation):
    """Scale, then turn: an object turned by yaw, pitch and roll looks where a
    camera turned so would look. Its columns are the camera's rows (SPEC.md,
    section 1)."""
    (sy, cy), (sp, cp), (sr, cr) = map(_sine_cosine, rotation)
    # Integers in 2^-156 up to the last step: a Fraction takes ten times as long.
    right = (cr * cy * _ONE - sr * sp * sy, sr * cp * _ONE, -cr * sy * _ONE - sr * sp * cy)
    up = (-sr * cy * _ONE - cr * sp * sy, cr * cp * _ONE, sr * sy * _ONE - cr * sp * cy)
    forward = (cp * sy * _ONE, sp * _ONE * _ONE, cp * cy * _ONE)
    factors = [s.as_integer_ratio() for s in scale]
    return [[Fraction(axis[row] * above, below * _ONE ** 3) for axis, (above, below) in zip((right, up, forward), factors)]
            for row in range(3)]
