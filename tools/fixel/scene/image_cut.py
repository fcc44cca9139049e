# SPDX-License-Identifier: MIT
"""The part of a material's image that faces show: whether it is of one colour, or on a canvas whose sides are powers of two.

Many models take the colours of faces from points of a palette or of a gradient. Such a face needs no texture.
A part that has room on the canvas keeps its texels; one that has not is scaled. Texels that no face shows count for nothing
when it is: those of a neighbouring cell do not mix with the face's own. On the canvas they, and what surrounds the part, have the
colours of the nearest texels that are shown."""

import math
from dataclasses import dataclass

import numpy as np
from PIL import Image

from fixel.model import texture_image
from fixel.scene.texture import OPAQUE_FROM, SIDE_MAX

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


PADDING = 2             # texels about a part, where the canvas has room
CUT_MAX = 0.75          # of an image's texels: a larger rectangle is not cut out of an image whose sides are powers of two
ISLANDS_MAX = 16        # parts of an image that have a canvas each
_CELLS = 128            # of an image along each side, in which islands are looked for
_MASK_FACES = 4096      # faces whose texels are looked at one by one


def power_above(side):
    """The least power of two that is not less than a side."""
    return 1 << (side - 1).bit_length()


def _is_power(side):
    return side & (side - 1) == 0


@dataclass(frozen=True)
class Axis:
    """Where a part of an image lies on a canvas along one axis: texels first..end of the image become so many texels of the canvas, from
    start on. side: of the canvas."""
    first: int
    end: int
    start: int
    count: int
    side: int

    def place(self, texel):
        """A coordinate in texels of the image as a part of the canvas's side."""
        return (self.start + (texel - self.first) * self.count / (self.end - self.first)) / self.side


@dataclass(frozen=True)
class Cut:
    """Of a part of an image. clamps: along an axis there is no room for PADDING, so the texture must not repeat."""
    across: Axis
    down: Axis
    clamps: bool


def _axis(first, end, size):
    count = end - first
    if count + 2 * PADDING <= size:
        return Axis(first, end, PADDING, count, power_above(count + 2 * PADDING))
    count = min(count, size)
    return Axis(first, end, 0, count, power_above(count))


def _cut(ends, size):
    axes = [_axis(*each, size) for each in ends]
    return Cut(*axes, any(axis.start < PADDING for axis in axes))


def _area(cut):
    return cut.across.side * cut.down.side


class Outlines:
    """The outlines of faces on an image, in its texels, each moved by whole images to where its least coordinates are small. clamp: none
    is moved, and beyond its edges the image shows them."""

    def __init__(self, image, outlines, clamp):
        sides = image.width, image.height
        self.image, self.clamp, self.found, self.boxes = image, clamp, [], []
        for outline in outlines:
            axes = [[value * side for value in values] for values, side in zip(zip(*outline), sides)]
            moved = [0 if clamp else math.floor(min(axis) / side + ROUNDING / side) * side for axis, side in zip(axes, sides)]
            axes = [[value - way for value in axis] for axis, way in zip(axes, moved)]
            ends = [texels_between(min(axis), max(axis)) for axis in axes]
            self.found.append(list(zip(*axes)))
            self.boxes.append([(min(max(low, 0), side - 1), max(min(high, side), 1)) for (low, high), side in zip(ends, sides)] if clamp else ends)

    def ends(self, numbers):
        """Of some outlines ((left, right), (top, bottom)) of the texels that they lie on."""
        return [(min(self.boxes[n][axis][0] for n in numbers), max(self.boxes[n][axis][1] for n in numbers)) for axis in range(2)]

    def islands(self):
        """The numbers of the outlines, those together whose rectangles touch; all together if one lies beyond the image."""
        every = list(range(len(self.boxes)))
        sides = self.image.width, self.image.height
        if any(high > side for box in self.boxes for (_, high), side in zip(box, sides)):
            return [every]
        cells = [tuple((low * _CELLS // side, -(-high * _CELLS // side)) for (low, high), side in zip(box, sides)) for box in self.boxes]
        labels = _labels(cells)
        found = {}
        for number, ((left, _), (top, _)) in zip(every, cells):
            found.setdefault(labels[top, left], []).append(number)
        return list(found.values())

    def shown(self, numbers, ends):
        """Which texels of a part outlines show; None where there are too many to look at each."""
        (left, right), (top, bottom) = ends
        if len(numbers) > _MASK_FACES:
            return None
        found = np.zeros((bottom - top, right - left), dtype=bool)
        for number in numbers:
            (low, high), (above, below) = self.boxes[number]
            columns, rows, outline = np.arange(low, high), np.arange(above, below), self.found[number]
            own = found[above - top:below - top, low - left:high - left]
            for one, other in zip(outline[1:], outline[2:]):
                own |= touched((outline[0], one, other), columns, rows)
            if self.clamp:      # what lies beyond shows the border
                own[[0, -1]] = own[:, [0, -1]] = True
        return None if found.all() else found


def _labels(cells):
    """For each cell that a rectangle covers the number of the group of touching cells that it is in. Row by row: a run of
    covered cells joins the groups that it touches in the row above."""
    covered, labels, count = np.zeros((_CELLS, _CELLS), dtype=bool), np.zeros((_CELLS, _CELLS), dtype=int), 0
    for (left, right), (top, bottom) in cells:
        covered[top:bottom, left:right] = True
    rows, edges = np.nonzero(np.diff(covered, axis=1, prepend=False, append=False))
    for row, left, right in zip(rows[::2].tolist(), edges[::2].tolist(), edges[1::2].tolist()):
        above = set(labels[row - 1, max(left - 1, 0):right + 1].tolist()) if row else ()
        count += 1
        labels[row, left:right] = count
        for other in filter(None, above):
            labels[labels == other] = count
    return labels


def cuts(outlines, size):
    """[(Cut, the numbers of its outlines)] of an image, of at most so many texels a side; None where a texture has all of the image: one
    that repeats it, or shows nearly all of one whose sides are powers of two."""
    image, every = outlines.image, list(range(len(outlines.boxes)))
    ends, sides = outlines.ends(every), (image.width, image.height)
    repeats = any(high > side for (_, high), side in zip(ends, sides))
    are_powers = _is_power(image.width) and _is_power(image.height)
    if repeats and (are_powers or any(high - low > size for low, high in ends)):
        return None
    islands = outlines.islands()
    parts = [_cut(outlines.ends(numbers), SIDE_MAX) for numbers in islands]
    if 1 < len(islands) <= ISLANDS_MAX and sum(map(_area, parts)) <= _area(_cut(ends, SIDE_MAX)):
        return [(_cut(outlines.ends(numbers), size), numbers) for numbers in islands]
    (left, right), (top, bottom) = ends
    if are_powers and (right - left) * (bottom - top) > CUT_MAX * image.width * image.height:
        return None
    return [(_cut(ends, size), every)]


def _scaled(pixels, shown, width, height):
    """Pixels in another size, and which of them are known: each the mean of the shown ones that it covers."""
    if (height, width) == pixels.shape[:2]:
        return pixels, np.ones((height, width), dtype=bool) if shown is None else shown
    if shown is None:
        return texture_image.Texture("", pixels).scaled(width, height), np.ones((height, width), dtype=bool)

    def mean(values):
        return np.asarray(Image.fromarray(values.astype(np.float32)).resize((width, height), Image.Resampling.BOX))
    alpha = pixels[..., 3] * shown
    weight, opaque = mean(shown), mean(alpha)
    colour = [mean(pixels[..., i] * alpha.astype(np.float32)) / np.maximum(opaque, 1e-6) for i in range(3)]
    found = np.stack([*colour, opaque / np.maximum(weight, 1e-6)], axis=2)
    return np.clip(np.rint(found), 0, 255).astype(np.uint8), weight > 1e-3


def _filled(pixels, known):
    """Pixels in which those that are not known have the colour of one that is near: steps of half the length each time find it."""
    if known.all():
        return pixels
    height, width = known.shape
    rows, columns = np.indices(known.shape)
    near, far = np.where(known, rows * width + columns, -1), np.where(known, 0, 1 << 30)
    step = power_above(max(height, width)) // 2
    while step:
        for down in (-step, 0, step):
            for across in (-step, 0, step):
                other = near[np.clip(rows + down, 0, height - 1), np.clip(columns + across, 0, width - 1)]
                away = np.where(other < 0, 1 << 30, (rows - other // width) ** 2 + (columns - other % width) ** 2)
                near, far = np.where(away < far, other, near), np.minimum(away, far)
        step //= 2
    return pixels.reshape(-1, 4)[near]


def canvas(outlines, cut, numbers):
    """The canvas of a cut, a texture_image.Texture."""
    image, (across, down) = outlines.image, (cut.across, cut.down)
    columns, rows = np.arange(across.first, across.end) % image.width, np.arange(down.first, down.end) % image.height
    shown = outlines.shown(numbers, ((across.first, across.end), (down.first, down.end)))
    part, known = _scaled(image.pixels[np.ix_(rows, columns)], shown, across.count, down.count)
    pixels, all_known = np.zeros((down.side, across.side, 4), dtype=np.uint8), np.zeros((down.side, across.side), dtype=bool)
    place = slice(down.start, down.start + down.count), slice(across.start, across.start + across.count)
    pixels[place], all_known[place] = part, known
    return texture_image.Texture(image.name, _filled(pixels, all_known))


def within(outlines, cut, number):
    """The coordinates of an outline's corners on a canvas, 1 across it."""
    return [(cut.across.place(x), cut.down.place(y)) for x, y in outlines.found[number]]
