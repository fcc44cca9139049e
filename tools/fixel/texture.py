# SPDX-License-Identifier: MIT
"""Textures: pictures of a few colours, from a file or from a pattern of the project's own."""

from dataclasses import dataclass

from fixel import palette, reading, texture_image
from fixel.errors import ToolError
from fixel.reading import quoted

SIDE_MAX = 256
FILE_MAX = 4 << 20          # bytes of a picture's file
COLOURS_MAX = 255           # of a texture
CLEAR = None                # the colour of what is not drawn


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

    def has_clear(self):
        """Whether something of it is not drawn."""
        return any(number is CLEAR for level in self.levels for row in level for number in row)

    def mean(self):
        """The mean colour of what is drawn."""
        counts = [0] * len(self.colours)
        for row in self.levels[0]:
            for number in row:
                if number is not CLEAR:
                    counts[number] += 1
        total = max(1, sum(counts))
        return tuple(round(sum(n * c[k] for n, c in zip(counts, self.colours)) / total) for k in range(3))

    def rows(self):
        """The largest level as rows of (red, green, blue) or CLEAR."""
        return [[CLEAR if n is CLEAR else self.colours[n] for n in row] for row in self.levels[0]]


def is_side(number):
    """Whether a texture may be so wide or high."""
    return 1 <= number <= SIDE_MAX and number & (number - 1) == 0


def _weights(levels):
    weights = {}
    for level in levels:
        for row in level:
            for pixel in row:
                if pixel is not CLEAR:
                    weights[pixel] = weights.get(pixel, 0) + 1
    return weights


def from_pixels(levels, most, kept=()):
    """A Picture of levels of rows of (red, green, blue) or CLEAR, with at most so many colours: those that are kept,
    and others merged."""
    kept = list(dict.fromkeys(kept))
    others = {colour: n for colour, n in _weights(levels).items() if colour not in kept}
    room = most - len(kept)
    if len(others) <= room:
        merged = {c: c for c in others}
    elif room > 0:
        merged = palette.median_cut(others, room)
    else:
        merged = {c: min(kept, key=lambda one, of=c: sum((a - b) ** 2 for a, b in zip(one, of))) for c in others}
    colours = kept + sorted(set(merged.values()) - set(kept))
    numbers = {colour: colours.index(mean) for colour, mean in merged.items()} | \
        {colour: number for number, colour in enumerate(kept)}
    return Picture([[[CLEAR if p is CLEAR else numbers[p] for p in row] for row in level] for level in levels], colours)


def _halved(rows, least):
    """A level half as wide and as high, at least so wide: the mean of the texels; CLEAR where half of them are."""
    wide, high = (1, 2)[len(rows[0]) > least], (1, 2)[len(rows) > 1]
    result = []
    for y in range(0, len(rows), high):
        row = []
        for x in range(0, len(rows[0]), wide):
            found = [rows[y + j][x + i] for j in range(high) for i in range(wide)]
            seen = [p for p in found if p is not CLEAR]
            row.append(tuple((2 * sum(axis) + len(seen)) // (2 * len(seen)) for axis in zip(*seen))
                       if 2 * len(seen) > len(found) else CLEAR)
        result.append(row)
    return result


def levels_of(rows, count, least=1):
    """Rows of (red, green, blue) or CLEAR, and smaller pictures of them: so many levels, or as many as there are. least: the
    least width of a level."""
    levels = [rows]
    while len(levels) < min(count, max(len(rows), len(rows[0])).bit_length()):
        levels.append(_halved(levels[-1], least))
    return levels


def with_levels(picture, count, most, least):
    """The picture with so many levels, and at most so many colours: its own ones, and others for the smaller levels.
    least: the least width of a level."""
    return from_pixels(levels_of(picture.rows(), count, least), most, picture.colours)


def read(path, name, most, any_side=False, key=None):
    """The picture of an image file, with at most so many colours. What is more clear than not becomes CLEAR, and so do
    pixels of the colour key. any_side: its sides need not be powers of two."""
    blob = reading.read_whole(path, FILE_MAX, "use a smaller picture: a texture has at most 256 x 256 texels")
    rows = texture_image.decode(blob, name).pixels
    height, width = rows.shape[:2]
    if any_side and max(width, height) > SIDE_MAX:
        raise ToolError(f"{name}: a picture of {width} x {height}; a side is at most {SIDE_MAX}, so scale it")
    if not any_side and not (is_side(width) and is_side(height)):
        raise ToolError(f"{name}: a picture of {width} x {height}; the sides of a texture are powers of "
                        f"two up to {SIDE_MAX}, so scale it")
    data = rows.tobytes()
    pixels = [tuple(data[i:i + 3]) if data[i + 3] >= 128 and tuple(data[i:i + 3]) != key else CLEAR
              for i in range(0, len(data), 4)]
    return from_pixels([[pixels[i:i + width] for i in range(0, width * height, width)]], most)


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
    given = row.rows("colours") if "colours" in row else list(PATTERNS[name][1])
    check_colours(given, name, row.at("colours"))
    return [palette.parse(colour, f"{row.at('colours')}[{i}]") for i, colour in enumerate(given)]


# --- files ---------------------------------------------------------------------------------------

def check_colours(given, name, where):
    """Refuses a list of colours of another length than the pattern's."""
    wanted = len(PATTERNS[name][1])
    if len(given) != wanted:
        raise ToolError(f"{where}: {len(given)} colours; the pattern {quoted(name)} has {wanted}")
