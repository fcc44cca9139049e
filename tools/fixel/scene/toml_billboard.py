# SPDX-License-Identifier: MIT
"""The billboards of a scene file: pictures that objects show instead of a mesh, and what an image keeps of them."""

from dataclasses import dataclass
from fractions import Fraction

from fixel.image import image_billboard
from fixel.model import quantity
from fixel.scene import texture
from fixel.base.errors import ToolError
from fixel.image.image_billboard import Billboards, Board
from fixel.model.mesh import Shape, unit_normal
from fixel.image.image import Face
from fixel.base.reading import quoted, shortened

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


def _picture(row, pictures, bits):
    if row.only_one("file", "pattern") == "pattern":
        row.refuse(("most_colours", "key"), "belongs to a file")
        return pictures.pattern(row, row["pattern"], *row["pixels"])
    row.refuse(("pixels", "colours"), "belongs to a pattern; a file has its own")
    most = row.get("most_colours", 32 if bits == 8 else _COLOURS[bits] - 1)
    quantity.in_range(most, 1, _COLOURS[bits], row.at("most_colours"))
    return pictures.file(row, most, any_side=True, key=row["key"])


def _wish(row, pictures):
    """(name, Wish) of an entry of billboards."""
    name, bits = row["name"], row["bits"]
    picture = _picture(row, pictures, bits)
    if len(picture.colours) + picture.has_clear > 1 << bits:
        raise ToolError(f"{row.where}: {len(picture.colours)} colours{' and what is not drawn' if picture.has_clear else ''} "
                        f"do not go into {bits} bits a pixel")
    if not picture.colours:
        raise ToolError(f"{row.where}: nothing of the picture is drawn")
    width, height = sides = tuple(map(quantity.q16, row["size"]))
    anchor = tuple(map(quantity.q16, row.get("anchor", (Fraction(width, 2 << 16), 0))))
    for at, side in zip(anchor, sides):
        quantity.in_range(Fraction(at, 1 << 16), 0, Fraction(side, 1 << 16), row.at("anchor"), "world units")
    return name, Wish(picture, bits, width, height, *anchor)


def read(top, pictures):
    """The billboards of a scene by name. pictures: the scene's texture.Pictures."""
    return top.named("billboards", "billboard", lambda row: _wish(row, pictures))


def of_object(table, known):
    """The billboard that an object names."""
    name = table["billboard"]
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
