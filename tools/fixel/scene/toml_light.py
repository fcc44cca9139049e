# SPDX-License-Identifier: MIT
"""The light of a scene file: baked into the colours of faces, or, with light.levels, made at run time."""

from fractions import Fraction
import math

from fixel.image import image_beam, image_light
from fixel.model import quantity
from fixel.scene import keys, palette
from fixel.base.errors import ToolError



class RunTime:
    """Light at run time. It leaves a colour as it is, and marks it as one that the light changes."""

    def __init__(self, image, dark, levels):
        self.image, self.dark, self.levels = image, dark, levels

    @staticmethod
    def bake(colour, _normal):
        return (*colour, 1)


def _q30(value):
    """A Fraction of 0..1 in 2.30."""
    return int(value * image_light.ONE + Fraction(1, 2))


def _points(light):
    return [(*map(quantity.q16, row["position"]), quantity.q16(row["range"]), _q30(row["strength"])) for row in light.rows("points")]


def _fog(light):
    if "fog" not in light:
        return 0, 0
    fog = light["fog"]
    near, far = quantity.q16(fog["near"]), quantity.q16(fog["far"])
    if near >= far:
        raise ToolError(f"{fog.where}: near = {near / 65536:g} is not below far = {far / 65536:g}")
    return near, far


def _baked(light, direction, ambient):
    light.refuse(keys.AT_RUN_TIME, "belongs to light at run time; give levels too, like levels = 16")
    return palette.Light([float(c) for c in direction], float(ambient), light["colour"], light["sky"], light["bake"])


def _run_time(light, direction, ambient):
    light.refuse(keys.BAKED, "belongs to light that the tool computes; leave out levels or {key}")
    whole = math.lcm(*(c.denominator for c in direction))
    made = image_light.Light(_q30(ambient), _q30(light.get("strength", 1 - ambient)),
                             image_beam.unit([int(c * whole) for c in direction]), [], _points(light), _fog(light))
    return RunTime(made, light["dark"], light["levels"])


def read(top):
    """What lights a scene: it bakes a colour, or marks it as one for a ramp (RunTime)."""
    light = top.table("light")
    direction, ambient = light["direction"], light["ambient"]
    if not any(direction):
        raise ToolError(f"{light.at('direction')}: [0, 0, 0] is no direction")
    return (_run_time if "levels" in light else _baked)(light, direction, ambient)
