# SPDX-License-Identifier: MIT
"""Which texels of a material's image faces show, and whether they are of one colour.

Many models take the colours of faces from points of a palette or of a gradient. Such a face needs no texture, and the
texels beside its own must not mix with it, as they would in an image that is scaled (image_cut.py)."""

import math

import numpy as np

from fixel.scene.texture import OPAQUE_FROM

SPREAD_MAX = 4              # of 255 from the least to the largest: all lie within 2 of one colour
_TEXELS_MAX = 1 << 22       # of a face that is looked at texel by texel
_BUDGET = 1 << 28           # texels of all faces of an image that seem to have one colour; faces beyond keep their texture
ROUNDING = 1 / 128         # texels: files have six digits of a coordinate, which are 1/256 of 8192 texels
_AREA_MIN = 1e-6            # square texels: of a triangle that is no line


def texels_between(low, high):
    """The texels between two coordinates, as (first, behind the last)."""
    first = math.floor(low + ROUNDING)
    return first, max(math.ceil(high - ROUNDING), first + 1)


def touched(three, columns, rows):
    """Which texels a triangle touches, of those that lie in its box. columns, rows: of their left and upper edges."""
    area = (three[1][0] - three[0][0]) * (three[2][1] - three[0][1]) - (three[1][1] - three[0][1]) * (three[2][0] - three[0][0])
    if abs(area) < _AREA_MIN:
        return np.ones((len(rows), len(columns)), dtype=bool)
    found = np.ones((len(rows), len(columns)), dtype=bool)
    for (x, y), (other_x, other_y) in zip(three, (*three[1:], three[0])):
        # How far a texel's corners are on the inner side of the edge: the farthest counts.
        along, down = (other_x - x) * math.copysign(1, area), (other_y - y) * math.copysign(1, area)
        farthest = along * (rows[:, None] + (along > 0) - y) - down * (columns[None, :] + (down < 0) - x)
        found &= farthest > ROUNDING * math.hypot(along, down)
    return found


class _Finder:
    """Finds faces of one colour on an image."""

    def __init__(self, image, clamp):
        self.pixels, self.clamp, self.known, self.left = image.pixels, clamp, {}, _BUDGET

    def _triangle(self, three):
        """(least, largest) red, green, blue, alpha of the texels that a triangle touches; None if there are too many."""
        height, width = self.pixels.shape[:2]
        (left, right), (top, bottom) = (texels_between(min(axis), max(axis)) for axis in zip(*three))
        count = (right - left) * (bottom - top)
        if count > min(_TEXELS_MAX, self.left):
            return None
        self.left -= count
        columns, rows = np.arange(left, right), np.arange(top, bottom)
        seen = (np.clip(rows, 0, height - 1), np.clip(columns, 0, width - 1)) if self.clamp else (rows % height, columns % width)
        found = self.pixels[np.ix_(*seen)]
        inside = found[touched(three, columns, rows)] if count > 1 else found.reshape(-1, 4)
        inside = inside if len(inside) else found.reshape(-1, 4)
        return inside.min(axis=0).astype(int), inside.max(axis=0).astype(int)

    def colour(self, outline):
        """The colour of an outline of (u, v), red, green, blue; None where it shows more than one, or something clear."""
        key = tuple(map(tuple, outline))
        if key not in self.known:
            self.known[key] = self._colour(key)
        return self.known[key]

    def _colour(self, outline):
        height, width = self.pixels.shape[:2]
        corners = [(u * width, v * height) for u, v in outline]
        low, high = np.full(4, 255), np.zeros(4, dtype=int)
        for one, other in zip(corners[1:], corners[2:]):
            ends = self._triangle((corners[0], one, other))
            if ends is None:
                return None
            low, high = np.minimum(low, ends[0]), np.maximum(high, ends[1])
            if (high - low).max() > SPREAD_MAX or low[3] < OPAQUE_FROM:
                return None
        return tuple(((low + high + 1) // 2)[:3].tolist())


def colours(image, outlines, clamp=False):
    """Of each outline on an image its colour, None where it shows more than one. clamp: beyond its edges the image shows them; else it
    repeats."""
    finder, looks = _Finder(image, clamp), image.spreads(outlines, clamp)
    return [finder.colour(outline) if spread <= SPREAD_MAX else None for outline, spread in zip(outlines, looks)]
