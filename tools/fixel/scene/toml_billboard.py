# SPDX-License-Identifier: MIT
"""The billboards of a scene file: pictures that objects show instead of a mesh, and what an image keeps of them."""

from dataclasses import dataclass

from fixel.image import image_billboard
from fixel.model import quantity
from fixel.scene import palette, texture, toml_motion
from fixel.base.errors import ToolError
from fixel.image.image_billboard import Billboards, Board
from fixel.model.mesh import Shape, unit_normal
from fixel.image.image import Face
from fixel.base.reading import quoted, shortened
from fixel.scene.toml_table import Table

# place key: a key of [[billboards]]
# What an object with a billboard may say.
OBJECT_KEYS = {"name", "billboard", "position", "positions", "repeat", "ring", "layer", "moves", *toml_motion.KEYS}
_ROW_KEYS = {"name", "file", "pattern", "pixels", "colours", "most_colours", "bits", "key", "size", "anchor"}
BOARDS_MAX = 256        # of a scene file
_COLOURS = {1: 2, 4: 16, 8: 255}


@dataclass(frozen=True)
class Wish:
    """A billboard as a scene asks for it, without palette entries. Equal only if the same picture is."""
    picture: object         # texture.Picture
    bits: int
    width: int              # 16.16
    height: int
    anchor_x: int
    anchor_y: int


def _key(row):
    """The colour of a picture that is not drawn; None: it says so itself."""
    return palette.parse(row.data["key"], row.at("key")) if "key" in row else None


def _most(row, bits):
    """How many colours a picture may have, beside what is not drawn."""
    return row.whole("most_colours", 32 if bits == 8 else _COLOURS[bits] - 1, 1, _COLOURS[bits])


def _picture(row, pictures, bits):
    if row.only_one("file", "pattern") == "pattern":
        for key in ("most_colours", "key"):
            if key in row:
                raise ToolError(f"{row.at(key)}: belongs to a file")
        name = row.choice("pattern", None, list(texture.PATTERNS))
        sides = row.wholes("pixels", 2, texture.SIDE_MAX) if "pixels" in row else (32, 32)
        return pictures.pattern(row, name, *sides)
    for key in ("pixels", "colours"):
        if key in row:
            raise ToolError(f"{row.at(key)}: belongs to a pattern; a file has its own")
    return pictures.file(row, _most(row, bits), any_side=True, key=_key(row))


def _pair(row, name, default, low, most):
    values = row.rows(name) if name in row else default
    if len(values) != 2:
        raise ToolError(f"{row.at(name)}: expected two numbers of world units")
    return tuple(quantity.q16(quantity.in_range(quantity.fraction(value, row.at(name)), low, high, row.at(name), "world units"))
                 for value, high in zip(values, most))


def _wish(data, where, pictures):
    """(name, Wish) of an entry of billboards."""
    row = Table(data, where, _ROW_KEYS)
    name, bits = row.text("name"), row.whole("bits", 8, 1, 8)
    if bits not in image_billboard.BITS:
        raise ToolError(f"{row.at('bits')}: 1, 4 or 8, found {bits}")
    picture = _picture(row, pictures, bits)
    if len(picture.colours) + picture.has_clear > 1 << bits:
        raise ToolError(f"{row.where}: {len(picture.colours)} colours{' and what is not drawn' if picture.has_clear else ''} "
                        f"do not go into {bits} bits a pixel")
    if not picture.colours:
        raise ToolError(f"{row.where}: nothing of the picture is drawn")
    row.need("size")
    width, height = _pair(row, "size", None, quantity.fraction("1/256", ""), (8191, 8191))
    sides = (quantity.fraction(f"{width}/65536", ""), quantity.fraction(f"{height}/65536", ""))
    anchor = _pair(row, "anchor", [sides[0] / 2, 0], 0, sides)
    return name, Wish(picture, bits, width, height, *anchor)


def read(top, pictures):
    """The billboards of a scene by name. pictures: the scene's texture.Pictures."""
    return top.named("billboards", "billboard", BOARDS_MAX, lambda data, where: _wish(data, where, pictures))


def of_object(table, known):
    """The billboard that an object names."""
    name = table.text("billboard")
    if name not in known:
        there = shortened(", ".join(sorted(known))) or "none"
        raise ToolError(f"{table.at('billboard')}: there is no billboard {quoted(name)}; the scene's billboards: {there}")
    return known[name]


def shape_of(wish):
    """The face that stands for a billboard where none are drawn: it looks to -z."""
    left, bottom = -wish.anchor_x, -wish.anchor_y
    right, top = left + wish.width, bottom + wish.height
    vertices = [(left, bottom, 0), (left, top, 0), (right, top, 0), (right, bottom, 0)]
    normal = unit_normal((0, 0, -1))
    return Shape(vertices, [Face(normal, (0, 1, 2, 3), 0)], [0], [])


# --- records -------------------------------------------------------------------------------------

def _packed(rows, bits):
    """Rows of values, the leftmost in the highest bits; each row begins at a whole byte."""
    result = bytearray()
    for row in rows:
        padded = row + [0] * (-len(row) % (8 // bits))
        for i in range(0, len(padded), 8 // bits):
            byte = 0
            for value in padded[i:i + 8 // bits]:
                byte = byte << bits | value
            result.append(byte)
    return bytes(result)


def _board(wish, indices):
    """The record. What is clear has the value 0 of 8 bits, the background's, which no colour has; else the first value
    that no colour has."""
    picture = wish.picture
    entries = [indices[colour] for colour in picture.colours]
    values = entries if wish.bits == 8 else range(len(entries))
    clear = 0 if wish.bits == 8 else len(entries)
    rows = [[clear if number is texture.CLEAR else values[number] for number in row] for row in picture.levels[0]]
    colours = b"" if wish.bits == 8 else bytes((entries + [0] * 16)[:1 << wish.bits])
    return Board(_packed(rows, wish.bits), colours, picture.width, picture.height, wish.bits,
                 clear if picture.has_clear else image_billboard.OPAQUE, wish.width, wish.height, wish.anchor_x,
                 wish.anchor_y)


def result(wishes, indices):
    """The billboards of an image; None without. wishes: of each model a Wish or None."""
    numbers, made = {}, Billboards()
    for wish in wishes:
        if wish is not None and wish not in numbers:
            made.boards.append(_board(wish, indices))
            numbers[wish] = len(made.boards)
        made.model_map.append(numbers.get(wish, 0))
    return made if made.boards else None
