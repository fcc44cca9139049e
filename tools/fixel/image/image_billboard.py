# SPDX-License-Identifier: MIT
"""The billboards of a scene image: what the loader asks of them (docs/formats.md, section 1.13)."""

from dataclasses import dataclass, field

from fixel.image.fields import entry
from fixel.image.image_tables import Ranges
from fixel.image.image_tree import COORDINATE_MAX, SORTED, fail

PIXELS_MAX = 16 << 20       # bytes of all sprites
OPAQUE = 256                # the key of a sprite all of whose pixels are drawn
BITS = (1, 4, 8)

BOARD, MAP = map(entry, ("billboards", "billboard map"))
TABLES = ("billboards", "billboard map", "sprite pixels")


@dataclass(frozen=True)
class Board:
    """A sprite and its size in the world."""
    pixels: bytes       # as the image has them
    colours: bytes      # of 1 or 4 bits: 2 or 16 palette indices
    pixel_width: int
    pixel_height: int
    bits: int
    key: int            # the value that is not drawn, or OPAQUE
    width: int          # 16.16
    height: int
    anchor_x: int
    anchor_y: int


@dataclass
class Billboards:
    """The billboards of a scene; of each model 0, or the number of its billboard, counted from 1."""
    boards: list = field(default_factory=list)
    model_map: list = field(default_factory=list)


def tables(billboards):
    """Billboards, map and pixels as packed bytes, by name; nothing without billboards."""
    if billboards is None:
        return {}
    blob, placed = bytearray(), {}

    def place(table):
        """Where the bytes are: sprites of equal pixels share them."""
        if table not in placed:
            placed[table] = len(blob)
            blob.extend(table)
        return placed[table]

    boards = [BOARD.pack(place(one.pixels), place(one.colours) if one.colours else 0, one.pixel_width, one.pixel_height,
                         one.key, one.bits, 0, one.width, one.height, one.anchor_x, one.anchor_y)
              for one in billboards.boards]
    return dict(zip(TABLES, [boards, [MAP.pack(number) for number in billboards.model_map], bytes(blob)]))


# --- reading -------------------------------------------------------------------------------------

def _read_board(fields, number, ranges):
    at, colours, pixel_width, pixel_height, key, bits, reserved, *lengths = fields
    what = f"billboard {number}"
    if bits not in BITS or key > OPAQUE:
        fail("range", f"{what}: {bits} bits a pixel, or a key of {key}")
    if reserved or bits == 8 and colours:
        fail("reserved", f"{what}: a reserved field is not zero, or 8 bits have a place of colours")
    size, entries = (pixel_width * bits + 7) // 8 * pixel_height, 0 if bits == 8 else 1 << bits
    if at + size > len(ranges.blob) or entries and colours + entries > len(ranges.blob):
        fail("offset", f"{what} reaches outside the sprite pixels of the image")
    return Board(ranges.at(at, size), ranges.at(colours, entries) if entries else b"", pixel_width, pixel_height, bits,
                 key, *lengths)


def _check_board(board, number):
    """The library's check of a billboard."""
    sides = (board.width, board.anchor_x), (board.height, board.anchor_y)
    if not board.pixel_width or not board.pixel_height or \
            any(not 1 <= side <= COORDINATE_MAX or not 0 <= anchor <= side for side, anchor in sides):
        fail("range", f"billboard {number}: a side or an anchor is out of range")


def _reach(board):
    """The square of the distance of the farthest corner from the anchor."""
    return sum(max(side - anchor, anchor) ** 2 for side, anchor in
               ((board.width, board.anchor_x), (board.height, board.anchor_y)))


def read(found, models, radii):
    """The billboards of the tables of an image, None where there are none. found: {name of a table: its entries}; radii: of the models, as
    the image states them."""
    boards, model_map, pixels = (found[name] for name in TABLES)
    if not model_map:
        return None
    ranges = Ranges(pixels)
    made = Billboards([_read_board(fields, i, ranges) for i, fields in enumerate(boards)], list(model_map))
    for i, board in enumerate(made.boards):
        _check_board(board, i)
    for i, (number, model, radius) in enumerate(zip(made.model_map, models, radii)):
        if number > len(made.boards):
            fail("index", f"model {i}: billboard {number} of {len(made.boards)}")
        if number and (model.kind == SORTED or len(model.faces) != 1):
            fail("count", f"model {i} shows a billboard, and is not convex with one face")
        if number and _reach(made.boards[number - 1]) > radius ** 2:
            fail("radius", f"model {i}: a corner of its billboard is outside its radius")
    return made
