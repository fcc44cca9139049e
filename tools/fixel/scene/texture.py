# SPDX-License-Identifier: MIT
"""Textures: pictures of a few colours, from a file or from a pattern of the project's own."""

from dataclasses import dataclass
import functools

import numpy as np

from fixel.base import reading
from fixel.model import texture_image
from fixel.scene import palette
from fixel.base.errors import ToolError
from fixel.base.reading import Beside, quoted

SIDE_MAX = 256
SIDES = tuple(1 << i for i in range(9))    # texels that a texture may be wide or high
COLOURS_MAX = 255           # of a texture of palette entries
EVERY_COLOUR = 1 << 24      # room for the colours of a texture of RGB565: none is merged
CLEAR = None                # the colour of what is not drawn
OPAQUE_FROM = 128           # of 255: what is more clear is not drawn
DISTINCT_MAX = 2048         # colours of a picture's file, before they are merged
_CLEAR_CODE = -1
_CHUNK = 1024               # colours at a time


@dataclass(eq=False)        # equal only if the same
class Picture:
    """A texture before it has palette entries. levels: of each, the largest first, rows of numbers of its colours; CLEAR
    where it is clear."""
    levels: list
    colours: list

    @property
    def width(self):
        """Texels of the largest level."""
        return len(self.levels[0][0])

    @property
    def height(self):
        """Texels of the largest level."""
        return len(self.levels[0])

    @functools.cached_property
    def has_clear(self):
        """Whether something of it is not drawn."""
        return any(number is CLEAR for level in self.levels for row in level for number in row)

    @functools.cached_property
    def mean(self):
        """The mean colour of what is drawn."""
        counts = [0] * len(self.colours)
        for row in self.levels[0]:
            for number in row:
                if number is not CLEAR:
                    counts[number] += 1
        total = max(1, sum(counts))
        return tuple(round(sum(n * c[k] for n, c in zip(counts, self.colours)) / total) for k in range(3))


def _nearest_side(number):
    """The side of a texture that is nearest to a picture's, by ratio."""
    below = 1 << number.bit_length() - 1
    return min(SIDE_MAX, below if number * number <= 2 * below * below else 2 * below)


def codes_of(pixels, clear):
    """An image's colours, rows of (red, green, blue, ...), as one number each: 65536 red + 256 green + blue, or
    _CLEAR_CODE."""
    return np.where(clear, _CLEAR_CODE, pixels[..., :3].astype(np.int32) @ np.array((65536, 256, 1), dtype=np.int32))


def coarser(codes):
    """The codes with so few bits of red, green and blue that there are at most DISTINCT_MAX colours; at least 4 bits are
    kept."""
    for dropped in range(5):
        kept, middle = (0xFF >> dropped << dropped) * 0x010101, ((1 << dropped) >> 1) * 0x010101    # of what was dropped
        found = np.where(codes == _CLEAR_CODE, _CLEAR_CODE, (codes & kept) + middle)
        if len(np.unique(found)) <= DISTINCT_MAX:
            break
    return found


def _colour(code):
    return code >> 16, code >> 8 & 255, code & 255


def _nearest(colours, kept):
    """{colour: the first of the kept ones that is nearest}."""
    some, near = np.array(list(colours), dtype=np.int32), []
    for start in range(0, len(some), _CHUNK):
        away = some[start:start + _CHUNK, None] - np.array(kept, dtype=np.int32)
        near += (away * away).sum(axis=2).argmin(axis=1).tolist()
    return {colour: kept[number] for colour, number in zip(colours, near)}


def _merged(weights, most, kept):
    """{colour: the one that stands for it}: of at most so many colours, those that are kept among them."""
    known = set(kept)
    others = {colour: weight for colour, weight in weights.items() if colour not in known}
    room = most - len(kept)
    if len(others) <= room:
        return {colour: colour for colour in others}
    return palette.median_cut(others, room) if room > 0 else _nearest(others, kept)


def from_codes(levels, most, kept=()):
    """A Picture of levels of codes, with at most so many colours: those that are kept, and others merged."""
    kept = list(dict.fromkeys(kept))
    every = np.concatenate([level.ravel() for level in levels])
    codes, counts = np.unique(every[every != _CLEAR_CODE], return_counts=True)
    found = [_colour(code) for code in codes.tolist()]
    merged = _merged(dict(zip(found, counts.tolist())), most, kept)
    colours = kept + sorted(set(merged.values()) - set(kept))
    places = {colour: number for number, colour in enumerate(colours)}
    numbers = np.array([places[merged.get(colour, colour)] for colour in found] + [CLEAR], dtype=object)
    return Picture([numbers[np.where(level == _CLEAR_CODE, len(found), np.searchsorted(codes, level))].tolist()
                    for level in levels], colours)


def _halved(codes, least):
    """A level half as wide and as high, at least so wide: the mean of the texels; clear where half of them are."""
    height, width = codes.shape
    wide, high = (1, 2)[width > least], (1, 2)[height > 1]
    parts = codes.reshape(height // high, high, width // wide, wide).swapaxes(1, 2).reshape(height // high, width // wide, -1)
    seen = parts != _CLEAR_CODE
    count = np.maximum(1, seen.sum(axis=2))
    means = [(2 * ((parts >> shift & 255) * seen).sum(axis=2) + count) // (2 * count) << shift for shift in (16, 8, 0)]
    return np.where(2 * seen.sum(axis=2) > wide * high, sum(means), _CLEAR_CODE).astype(np.int32)


def levels_of(codes, count, least=1):
    """The codes of a picture, and of smaller pictures of it: so many levels, or as many as there are. least: the least
    width of a level."""
    levels = [codes]
    while len(levels) < min(count, max(codes.shape).bit_length()):
        levels.append(_halved(levels[-1], least))
    return levels


def with_levels(picture, levels, most, least):
    """The picture with so many levels, and at most so many colours: its own ones, and others for the smaller levels.
    least: the least width of a level."""
    numbers = np.array([[-1 if n is CLEAR else n for n in row] for row in picture.levels[0]], dtype=np.int32)
    own = np.array([red << 16 | green << 8 | blue for red, green, blue in picture.colours] + [_CLEAR_CODE], dtype=np.int32)
    return from_codes(levels_of(own[numbers], levels, least), most, picture.colours)


def from_pixels(pixels, name, most, any_side=False, key=None, side=SIDE_MAX):
    """The picture of an image file, with at most so many colours. What is more clear than not becomes CLEAR, and so do
    pixels of the colour key. any_side: its sides need not be powers of two; else they are made such, of
    at most so many texels."""
    height, width = pixels.shape[:2]
    if any_side and max(width, height) > SIDE_MAX:
        raise ToolError(f"{name}: a picture of {width} x {height}; a side is at most {SIDE_MAX}, so scale it")
    wanted = min(side, _nearest_side(width)), min(side, _nearest_side(height))
    if not any_side and wanted != (width, height):
        pixels = texture_image.Texture(name, pixels).scaled(*wanted)
    codes = codes_of(pixels, pixels[..., 3] < OPAQUE_FROM)
    if key:
        codes[codes == (key[0] << 16 | key[1] << 8 | key[2])] = _CLEAR_CODE
    return from_codes([codes if most == EVERY_COLOUR else coarser(codes)], most)


# --- patterns ------------------------------------------------------------------------------------
# Each answers the number of the colour at a texel, or CLEAR. They repeat without a seam.

def _hash(x, y, seed):
    """A number of 0..255 that looks random, the same on every machine."""
    value = (x * 0x9E3779B1 ^ y * 0x85EBCA77 ^ seed * 0xC2B2AE3D) & 0xFFFFFFFF
    value = (value ^ value >> 15) * 0x2C1B3C6D & 0xFFFFFFFF
    value = (value ^ value >> 12) * 0x297A2D39 & 0xFFFFFFFF
    return (value ^ value >> 15) & 255


def _checker(x, y, width, height):
    return (2 * x // width + 2 * y // height) % 2


def _bricks(x, y, width, height):
    """Four courses, each half a brick on from the one below: three shades of brick, and the joint."""
    course = max(2, height // 4)
    row, length = y // course, max(2, width // 2)
    along = (x + (row % 2) * length // 2) % width
    joint = max(1, course // 8)
    if y % course < joint or along % length < joint:
        return 3
    shade = _hash(along // length, row, 1) % 3
    return shade if _hash(x, y, 2) > 40 else (shade + 1) % 3


def _planks(x, y, width, height):
    """Four boards along the picture's height: three shades with some grain, and the gap."""
    board = max(2, width // 4)
    number, across = x // board, x % board
    if across == 0 or (y + _hash(number, 0, 3) * height // 256) % height == 0:
        return 3
    grain = _hash(number * 64 + across, y // max(1, height // 8), 4)
    return (_hash(number, 1, 5) + (grain < 60)) % 3


def _crate(x, y, width, height):
    """A frame and a diagonal over boards: two shades of board, the frame, its shadow."""
    frame = max(1, width // 8)
    column, row = min(x, width - 1 - x), min(y, height - 1 - y)
    edge = min(column, row)
    if edge < frame:
        return 3 if edge in (0, frame - 1) else 2
    if abs(x * height - y * width) < frame * height // 2 + height:
        return 3 if abs(x * height - y * width) > frame * height // 2 - height else 2
    return 3 if x % max(2, width // 4) == 0 else _hash(x // max(1, width // 4), y, 6) % 4 // 3


def _grille(x, y, width, height):
    """Two bars each way, one lighter than the other side, and holes."""
    period_x, period_y = max(2, width // 2), max(2, height // 2)
    bar_x, bar_y = max(1, period_x // 4), max(1, period_y // 4)
    column, row = x % period_x, y % period_y
    if column >= bar_x and row >= bar_y:
        return CLEAR
    return 0 if column == 0 or row == 0 else 1


def _tree(x, y, width, height):
    """A fir: three tiers of two shades, the left lighter, over a trunk; the rest is a hole."""
    across = abs(2 * x + 1 - width)             # of the width: 0 in the middle
    if 8 * y >= 7 * height:
        return 2 if 6 * across < width else CLEAR
    tier = 8 * y * 3 // (7 * height)            # 0 at the top
    within = 8 * y * 3 - tier * 7 * height      # of 7 * height: 0 at the tier's top
    reach = (3 + 3 * tier) * 7 * height + (5 + 2 * tier) * within
    if across * 14 * 7 * height > width * reach:
        return CLEAR
    return 0 if 2 * x + _hash(x, y, 9) * width // 512 < width + width // 4 else 1


def _stones(x, y, width, height):
    """Grains of three shades, four texels wide at most."""
    return (_hash(x // 2, y // 2, 7) + _hash(x, y, 8)) // 2 * 3 // 256


# The patterns by name, and their default colours.
PATTERNS = {
    "checker": (_checker, ("#e8e0d0", "#404858")),
    "bricks": (_bricks, ("#a8523c", "#984834", "#b45e48", "#c8bca8")),
    "planks": (_planks, ("#a87848", "#9c6c40", "#b48452", "#5c3c20")),
    "crate": (_crate, ("#b88850", "#a87844", "#d0a468", "#6c4824")),
    "grille": (_grille, ("#b0b8c4", "#586070")),
    "tree": (_tree, ("#3c8c48", "#286838", "#684830")),
    "stones": (_stones, ("#8c8c88", "#989890", "#80807c")),
}


def pattern(name, width, height, colours):
    """A pattern's picture. colours: as many as the pattern has by default."""
    made, _ = PATTERNS[name]
    return Picture([[[made(x, y, width, height) for x in range(width)] for y in range(height)]], list(colours))


def pattern_colours(row, name):
    """The colours that a row of a scene file gives a pattern, or the pattern's own."""
    if "colours" not in row:
        return [palette.parse(colour, name) for colour in PATTERNS[name][1]]
    given = row["colours"]
    check_colours(given, name, row.at("colours"))
    return given


# --- the pictures of a scene -------------------------------------------------------------------

class Pictures:
    """Makes the pictures of one scene, each once."""

    def __init__(self, folder):
        self.folder, self.made, self.files, self.notes = folder, {}, {}, []     # pictures; the pixels of files; what to say of these

    def _once(self, key, make):
        """A picture that is made once."""
        if key not in self.made:
            self.made[key] = make()
        return self.made[key]

    def pattern(self, row, name, width, height):
        """The picture of a pattern that a row of a scene file names."""
        colours = pattern_colours(row, name)
        return self._once((name, width, height, tuple(colours)), lambda: pattern(name, width, height, colours))

    def file(self, row, most, any_side=False, key=None, side=SIDE_MAX):
        """The picture of the file that a row of a scene file names (from_pixels)."""
        name = row["file"]
        file = Beside(self.folder, name)
        if not file.exists():
            raise ToolError(f"{row.at('file')}: there is no file {quoted(name)}; the path is taken from the scene file's folder")
        real = reading.identity(file)
        if real not in self.files:
            opened = texture_image.read(file, file)
            self.files[real] = opened.pixels
            self.notes += opened.notes
        return self._once((real, most, any_side, key, side), lambda: from_pixels(self.files[real], file, most, any_side, key, side))

    def levels(self, picture, levels, most, least):
        """The same with smaller pictures of it (with_levels)."""
        return self._once((id(picture), levels, most, least), lambda: with_levels(picture, levels, most, least))


# --- files ---------------------------------------------------------------------------------------

def check_colours(given, name, where):
    """Refuses a list of colours of another length than the pattern's."""
    wanted = len(PATTERNS[name][1])
    if len(given) != wanted:
        raise ToolError(f"{where}: {len(given)} colours; the pattern {quoted(name)} has {wanted}")
