# SPDX-License-Identifier: MIT
"""Turned instances for the bench: a scene whose instances all turn, each in its own way, or have a placement that turns
nothing."""

import dataclasses

from fixel.image.image_placement import Key, Motion, Placement
from fixel.model.quantity import TURN as WHOLE_TURN

ONE = 65536                     # 16.16
NONE = Placement((1 << 30, 0, 0, 0, 1 << 30, 0, 0, 0, 1 << 30), ONE)
YAW, PITCH = (range(-3, 4), range(-2, 3))       # steps a frame, in 256ths of a turn; instances take them in turn


def _spin(number, centre):
    """The motion of an instance that stays in its place. It starts at an angle of its own."""
    start = number * 0x9E3779B9 % WHOLE_TURN
    steps = [each[number % len(each)] * WHOLE_TURN // 256 % WHOLE_TURN for each in (YAW, PITCH)]
    return Motion([Key(0, centre, (start, 0, 0), ONE)], (steps[0], steps[1], 0))


def turned(scene, how):
    """The scene with a placement for each instance. how: "still", all placements are those of FXL_PLACEMENT_NONE and the picture is
    the scene's; "turning", the instances turn from frame to frame."""
    motions = [_spin(number, item.centre) for number, item in enumerate(scene.objects)] if how == "turning" else []
    return dataclasses.replace(scene, placements=[NONE] * len(scene.objects), motions=motions)
