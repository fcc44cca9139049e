# SPDX-License-Identifier: MIT
"""The light of a scene file: baked into the colours of faces, or, with light.levels, made at run time."""

from fractions import Fraction
import math

from fixel.image import image_beam, image_light
from fixel.model import quantity
from fixel.scene import palette
from fixel.base.errors import ToolError
from fixel.image.image_header import FAR_MAX
from fixel.scene.toml_table import Table

# place key: a key of [light]
KEYS = {"direction", "ambient", "colour", "sky", "bake", "levels", "strength", "dark", "points", "fog"}
BAKED = ("colour", "sky", "bake")                   # keys of baked light alone
AT_RUN_TIME = ("strength", "dark", "points", "fog")    # keys of light at run time alone


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
    rows = light.rows("points") if "points" in light else []
    if len(rows) > image_light.POINTS_MAX:
        raise ToolError(f"{light.at('points')}: {len(rows)} point lights are more than {image_light.POINTS_MAX}")
    points = []
    for i, data in enumerate(rows):
        row = Table(data, f"{light.at('points')}[{i}]", {"position", "range", "strength"})
        reach = row.number("range", None, Fraction(1, 65536), quantity.COORDINATE_MAX, "world units")
        points.append((*map(quantity.q16, row.position("position")), quantity.q16(reach),
                       _q30(row.number("strength", 1, 0, 1))))
    return points


def _fog(light):
    if "fog" not in light:
        return 0, 0
    fog = light.table("fog", {"near", "far"})
    near, far = (quantity.q16(fog.number(key, None, 0, FAR_MAX >> 16, "world units")) for key in ("near", "far"))
    if near >= far:
        raise ToolError(f"{fog.where}: near = {near / 65536:g} is not below far = {far / 65536:g}")
    return near, far


def _baked(light, direction, ambient):
    for key in AT_RUN_TIME:
        if key in light:
            raise ToolError(f"{light.at(key)}: belongs to light at run time; give levels too, like levels = 16")
    return palette.Light([float(c) for c in direction], float(ambient),
                         palette.parse(light.data.get("colour", "white"), light.at("colour")),
                         palette.parse(light.data.get("sky", "white"), light.at("sky")), light.switch("bake", False))


def _run_time(light, direction, ambient):
    for key in BAKED:
        if key in light:
            raise ToolError(f"{light.at(key)}: belongs to light that the tool computes; leave out levels or {key}")
    levels = light.whole("levels", None, image_light.LEVELS_MIN, image_light.LEVELS_MAX)
    whole = math.lcm(*(c.denominator for c in direction))
    made = image_light.Light(_q30(ambient), _q30(light.number("strength", 1 - ambient, 0, 1)),
                             image_beam.unit([int(c * whole) for c in direction]), [], _points(light), _fog(light))
    return RunTime(made, palette.parse(light.data.get("dark", "black"), light.at("dark")), levels)


def read(top):
    """What lights a scene: it bakes a colour, or marks it as one for a ramp (RunTime)."""
    light = top.table("light", KEYS)
    direction = quantity.vector(light.data.get("direction", ["-0.4", "-1", "0.7"]), light.at("direction"))
    if not any(direction):
        raise ToolError(f"{light.at('direction')}: [0, 0, 0] is no direction")
    ambient = light.number("ambient", Fraction(2, 5), 0, 1)
    return (_run_time if "levels" in light else _baked)(light, direction, ambient)
