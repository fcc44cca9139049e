# SPDX-License-Identifier: MIT
"""The billboards of a scene as text of C: constant tables in the layout of lib/include/fixel/billboards.h."""

from fixel.image import image_billboard
from fixel.image.c_text import braces, record, table

INCLUDE = "fixel/billboards.h"


def _pieces(boards, name):
    """Tables of pixels and of colours, each once; {bytes: its name}."""
    made, names = [], {}
    for board in boards:
        for blob in (board.pixels, board.colours):
            if blob and blob not in names:
                names[blob] = f"{name}_sprite_bytes_{len(names)}"
                made.append(table("uint8_t", names[blob], [str(byte) for byte in blob]))
    return made, names


def _sprite(board, names):
    key = "FXL_SPRITE_OPAQUE" if board.key == image_billboard.OPAQUE else board.key
    return braces(names[board.pixels], names[board.colours] if board.colours else "NULL", board.pixel_width,
                  board.pixel_height, board.bits, key)


def text(scene, name):
    """The tables and the record of a scene's billboards; nothing without."""
    if scene.billboards is None:
        return []
    boards = scene.billboards.boards
    made, names = _pieces(boards, name)
    sides = [braces(f"&{name}_sprites[{i}]", board.width, board.height, board.anchor_x, board.anchor_y)
             for i, board in enumerate(boards)]
    return [*made,
            table("fxl_sprite", f"{name}_sprites", [_sprite(board, names) for board in boards],
                  "Pixels, colours, width, height, bits, key."),
            table("fxl_billboard", f"{name}_boards", sides, "Sprite; width, height and anchor in 16.16."),
            table("uint16_t", f"{name}_billboard_map", [str(number) for number in scene.billboards.model_map],
                  "For each model its billboard, counted from 1; 0: none."),
            record("fxl_billboard_set", f"{name}_billboards", [f"{name}_boards, {len(boards)}, {name}_billboard_map"],
                   "For fxl_attach_billboards.")]
