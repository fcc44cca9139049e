# SPDX-License-Identifier: MIT
"""The surfaces and billboards of a scene as text of C: constant tables in the layout of lib/include/fixel/surfaces.h and billboards.h."""

import collections
import itertools
import struct

from fixel.image import image_billboard, image_surface
from fixel.image.c_text import braces, record, table

INCLUDE = "fixel/surfaces.h"
FORMATS = {image_surface.BITS_8: "FXL_TEXTURE_8", image_surface.BITS_4: "FXL_TEXTURE_4", image_surface.RGB565: "FXL_TEXTURE_565"}


def _numbers(blob):
    return [str(byte) for byte in blob]


def _pieces(textures, name):
    """Tables of texels and of colours, each once; {(whether they are of RGB565, bytes): its name}."""
    made, names, numbers = [], {}, collections.Counter()
    for texture in textures:
        is_565 = texture.format == image_surface.RGB565
        for blob, what in (((is_565, texture.texels), "texels"), ((False, texture.colours), "texel_colours")):
            if blob[1] and blob not in names:
                names[blob] = f"{name}_{what}_{numbers[what]}"
                numbers[what] += 1
                made.append(table("uint16_t", names[blob], texels_565(struct.unpack(f"<{len(blob[1]) // 2}H", blob[1]))) if blob[0] else
                            table("uint8_t", names[blob], _numbers(blob[1])))
    return made, names


def texels_565(values):
    """Texels of RGB565 as the numbers of a table."""
    return [f"0x{value:04X}" for value in values]


def as_bytes(name):
    """The address of a table of texels of RGB565 as fxl_texture has it."""
    return f"FXL_CAST(const uint8_t *, FXL_CAST(const void *, {name}))"


def _texture(texture, names):
    colours = names[False, texture.colours] if texture.colours else "NULL"
    is_565 = texture.format == image_surface.RGB565
    texels = names[is_565, texture.texels]
    return braces(as_bytes(texels) if is_565 else texels, colours, texture.log_width, texture.log_height, FORMATS[texture.format],
                  texture.flags, texture.key, texture.levels, texture.key_565)


def _tables(scene, name, names):
    """[(table's name or NULL, the table or None, rows)] in the order of fxl_surface_set's first members."""
    surfaces, numbers = scene.surfaces, {}
    faces = [face.mapped for model in scene.models for face in model.faces]
    face_map = ["0" if each is None else str(numbers.setdefault(each, len(numbers) + 1)) for each in faces]
    placed, mapped, corners = image_surface.share_corners(numbers, surfaces.surfaces)
    rows = [("textures", "fxl_texture", [_texture(each, names) for each in surfaces.textures],
             "Texels, colours, log2 of width and of height, format, flags, key, levels, key of RGB565."),
            ("looks", "fxl_surface", [braces(each.texture, each.division, each.flags, each.opacity, each.sixteenths, braces(0, 0), first)
                                      for each, first in placed], "Texture, division, flags, opacity, sixteenths, reserved, first corner."),
            ("mapped_faces", "fxl_mapped_face", [braces(surface, braces(*each)) for surface, each in mapped], "Surface, corners."),
            ("face_map", "uint16_t", face_map, "For each face its mapped face, counted from 1; 0: none."),
            ("corners", "fxl_corner", [braces(braces(*texel), *rest) for texel, *rest in corners], "Texel u, v in 16.16; vertex, normal."),
            ("normals", "fxl_direction", [braces(*each) for each in surfaces.normals], "Of corners, in 2.30."),
            ("blend", "uint8_t", _numbers(itertools.chain(*surfaces.blend)),
             "What a blended colour shows over each other: 256 for each.")]
    return [(f"{name}_{what}" if items else "NULL", table(kind, f"{name}_{what}", items, about) if items else None, len(items))
            for what, kind, items, about in rows]


def text(scene, name):
    """The tables and the record of a scene's surfaces; nothing without."""
    if scene.surfaces is None:
        return []
    pieces, names = _pieces(scene.surfaces.textures, name)
    (textures, *_), (looks, *_), (mapped, *_), (face_map, *_), (corners, *_), (normals, *_), (blend, *_) = tables = _tables(scene, name, names)
    counts = [tables[i][2] for i in (0, 1, 2, 4, 5)]
    entries = [", ".join([textures, looks, mapped, face_map, corners, normals]), ", ".join(map(str, counts)),
               f"{blend}, {scene.surfaces.blend_first}, {len(scene.surfaces.blend)}"]
    return [*pieces, *(made for _, made, _ in tables if made),
            record("fxl_surface_set", f"{name}_surfaces", entries, "For fxl_attach_surfaces.")]


BILLBOARDS_INCLUDE = "fixel/billboards.h"


def _sprite_pieces(boards, name):
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


def billboards_text(scene, name):
    """The tables and the record of a scene's billboards; nothing without."""
    if scene.billboards is None:
        return []
    boards = scene.billboards.boards
    made, names = _sprite_pieces(boards, name)
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
