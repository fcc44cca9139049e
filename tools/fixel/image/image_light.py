# SPDX-License-Identifier: MIT
"""The light of a scene image, at run time: what the loader asks of it (docs/formats.md, section 1.11)."""

from dataclasses import dataclass, field

from fixel.image.fields import entry
from fixel.image.image_header import FAR_MAX
from fixel.image.image_tree import COORDINATE_MAX, NORMAL_SQUARE_MAX_ERROR, fail

POINTS_MAX = 4
LEVELS_MIN, LEVELS_MAX = 2, 64
ONE = 1 << 30
BASE = entry("light")
POINT = entry("point lights")
assert (BASE.size, POINT.size) == (28, 20)


@dataclass
class Light:
    """Everything in the image's own integers."""
    ambient: int                    # 2.30
    strength: int                   # 2.30, of the directional light
    direction: tuple                # 2.30
    ramp: list                      # for each level 256 entries of the palette
    points: list = field(default_factory=list)      # (x, y, z, range in 16.16, strength in 2.30)
    fog: tuple = (0, 0)             # near, far in 16.16; zeros: none

    def tables(self):
        """Light, point lights and ramp as packed bytes, by name."""
        return {"light": [BASE.pack(self.ambient, self.strength, *self.direction, *self.fog)],
                "point lights": [POINT.pack(*point) for point in self.points], "levels": [bytes(level) for level in self.ramp]}


def _check(light):
    """The library's fxl_light_check."""
    if not LEVELS_MIN <= len(light.ramp) <= LEVELS_MAX:
        fail("count", f"a ramp of {len(light.ramp)} levels; it has {LEVELS_MIN} to {LEVELS_MAX}")
    if not 0 <= light.ambient <= ONE or not 0 <= light.strength <= ONE:
        fail("range", "the light's ambient part or strength is outside 0..1")
    near, far = light.fog
    if (near or far) and not 0 <= near < far <= FAR_MAX:
        fail("range", f"fog from {near / 65536:.6g} to {far / 65536:.6g} is not 0 <= near < far <= {FAR_MAX >> 16}")
    for i, (*place, reach, strength) in enumerate(light.points):
        if any(abs(c) > COORDINATE_MAX for c in place) or not 1 <= reach <= COORDINATE_MAX or not 0 <= strength <= ONE:
            fail("range", f"point light {i}: its position, range or strength is out of range")
    if light.strength and abs(sum(c * c for c in light.direction) - (1 << 60)) > NORMAL_SQUARE_MAX_ERROR:
        fail("normal", "the direction of the light is not of unit length")


def read(base, points, ramp):
    """The light of the tables of an image; None where there is none."""
    if not base:
        return None
    ambient, strength, *direction, near, far = base[0]
    light = Light(ambient, strength, tuple(direction), [list(level) for level in ramp], list(points), (near, far))
    _check(light)
    return light
