# SPDX-License-Identifier: MIT
"""Which part of a material's image faces show: of one colour, or a rectangle that is cut out for a texture.

Many models take the colours of faces from points of a palette or of a gradient. Such a face needs no texture, and the
texels beside its own must not mix with it, as they would in an image that is scaled."""

import math

import numpy as np

from fixel.scene.texture import OPAQUE_FROM

SPREAD_MAX = 4              # of 255 from the least to the largest: all lie within 2 of one colour
PADDING = 2                 # texels of an image about a rectangle
CUT_MAX = 0.75              # of an image's texels: a larger rectangle is not cut out
_TEXELS_MAX = 1 << 20       # of a face that is looked at texel by texel
_BUDGET = 1 << 26           # texels of all faces together; faces beyond keep their texture
_ROUNDING = 1e-6            # texels


def _range(low, high):
    """The texels between two coordinates, as (first, behind the last)."""
    first = math.floor(low + _ROUNDING)
    return first, max(math.ceil(high - _ROUNDING), first + 1)


def _touched(three, columns, rows):
    """Which texels a triangle touches, of those that lie in its box. columns, rows: of their left and upper edges."""
    area = (three[1][0] - three[0][0]) * (three[2][1] - three[0][1]) - (three[1][1] - three[0][1]) * (three[2][0] - three[0][0])
    if abs(area) < _ROUNDING:
        return np.ones((len(rows), len(columns)), dtype=bool)
    found = np.ones((len(rows), len(columns)), dtype=bool)
    for (x, y), (other_x, other_y) in zip(three, (*three[1:], three[0])):
        # How far a texel's corners are on the inner side of the edge: the farthest counts.
        along, down = (other_x - x) * math.copysign(1, area), (other_y - y) * math.copysign(1, area)
        farthest = along * (rows[:, None] + (along > 0) - y) - down * (columns[None, :] + (down < 0) - x)
        found &= farthest > _ROUNDING
    return found


class _Finder:
    """Finds faces of one colour on an image."""

    def __init__(self, image):
        self.pixels, self.known, self.left = image.pixels, {}, _BUDGET

    def _triangle(self, three):
        """(least, largest) red, green, blue, alpha of the texels that a triangle touches; None if there are too many."""
        height, width = self.pixels.shape[:2]
        (left, right), (top, bottom) = (_range(min(axis), max(axis)) for axis in zip(*three))
        count = (right - left) * (bottom - top)
        if count > min(_TEXELS_MAX, self.left):
            return None
        self.left -= count
        columns, rows = np.arange(left, right), np.arange(top, bottom)
        found = self.pixels[np.ix_(rows % height, columns % width)]
        inside = found[_touched(three, columns, rows)] if count > 1 else found.reshape(-1, 4)
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


def colours(image, outlines):
    """Of each outline on an image its colour, None where it shows more than one."""
    finder, looks = _Finder(image), image.spreads(outlines)
    return [finder.colour(outline) if spread <= SPREAD_MAX else None for outline, spread in zip(outlines, looks)]


def rectangle(image, outlines):
    """(left, top, right, bottom) in texels of the part of an image that outlines show, with padding; None where it is
    nearly all of it, or an outline shows the image more than once."""
    ends, sides = [[math.inf, -math.inf], [math.inf, -math.inf]], (image.width, image.height)
    for outline in outlines:
        for axis, side, values in zip(ends, sides, zip(*outline)):
            moved = math.floor(min(values) + _ROUNDING / side)
            axis[0], axis[1] = min(axis[0], min(values) - moved), max(axis[1], max(values) - moved)
    if any(high > 1 + _ROUNDING / side for (_, high), side in zip(ends, sides)):
        return None
    (left, right), (top, bottom) = (_range(low * side, high * side) for (low, high), side in zip(ends, sides))
    left, top = max(0, left - PADDING), max(0, top - PADDING)
    right, bottom = min(image.width, right + PADDING), min(image.height, bottom + PADDING)
    is_small = (right - left) * (bottom - top) <= CUT_MAX * image.width * image.height
    return (left, top, right, bottom) if is_small else None


def within(outline, image, part):
    """An outline's coordinates on a rectangle of an image, 1 across it."""
    left, top, right, bottom = part
    moved = [math.floor(min(values) + _ROUNDING / side) for values, side in zip(zip(*outline), (image.width, image.height))]
    return [(((u - moved[0]) * image.width - left) / (right - left), ((v - moved[1]) * image.height - top) / (bottom - top))
            for u, v in outline]
