# SPDX-License-Identifier: MIT
"""An image as a texture of 16 bits a texel, as text of C: lib/include/fixel/extra/rgb565.h."""

import os

from fixel import c_scene, image_surface, texture, texture_image
from fixel.c_text import braces, comment, table
from fixel.errors import ToolError

OPAQUE_FROM = 128   # of 255: what is more clear is not drawn


def value(red, green, blue):
    """FXL_RGB565."""
    return red >> 3 << 11 | green >> 2 << 5 | blue >> 3


def rows_of(file, size):
    """An image file's rows of (red, green, blue) or CLEAR. size: (width, height) to scale it to, or None."""
    name = c_scene.printable(os.path.basename(file))
    opened = texture_image.read(file, name)
    if size is None and not (texture.is_side(opened.width) and texture.is_side(opened.height)):
        raise ToolError(f"{name}: an image of {opened.width} x {opened.height}; the sides of a texture are powers of two from "
                        f"1 to {texture.SIDE_MAX}: let --size scale it, like --size 64x64")
    pixels = opened.scaled(*size) if size else opened.pixels
    return [[tuple(map(int, pixel[:3])) if pixel[3] >= OPAQUE_FROM else texture.CLEAR for pixel in row] for row in pixels]


def key_of(levels):
    """A value that no texel has which is drawn; None where all are drawn."""
    every = [pixel for rows in levels for row in rows for pixel in row]
    if texture.CLEAR not in every:
        return None
    taken = {value(*pixel) for pixel in every if pixel is not texture.CLEAR}
    return next((key for key in range(1 << 16) if key not in taken), None)


def header(file, name, size=None, levels=1, clamp=False):
    """(the text of a header with the table of an image file's texels and its fxl_texture, texels)."""
    c_scene.check_name(name)
    made = texture.levels_of(rows_of(file, size), levels)
    key = key_of(made)
    texels = [key if pixel is texture.CLEAR else value(*pixel) for rows in made for row in rows for pixel in row]
    flags = (image_surface.CLAMP if clamp else 0) | (image_surface.KEYED if key is not None else 0)
    wide, high = len(made[0][0]), len(made[0])
    guard = f"{name.upper()}_TEXTURE_H"
    about = f"{wide} x {high} texels of RGB565" + (f" and {len(made) - 1} smaller pictures" if len(made) > 1 else "") + \
        (f"; those of 0x{key:04X} are not drawn" if key is not None else "")
    record = braces(f"FXL_CAST(const uint8_t *, FXL_CAST(const void *, {name}_texels))", "NULL", wide.bit_length() - 1,
                    high.bit_length() - 1, "FXL_TEXTURE_565", flags, 0, len(made), key or 0)
    return "\n".join([
        *comment(f"Written by tools/scene.py from {c_scene.printable(os.path.basename(file))}."),
        f"#ifndef {guard}", f"#define {guard}", "", "#include <fixel/extra/rgb565.h>", "",
        table("uint16_t", f"{name}_texels", [f"0x{texel:04X}" for texel in texels], about),
        f"static const fxl_texture {name}_texture =\n    {record};", "", "#endif", ""]), len(texels)
