# SPDX-License-Identifier: MIT
"""An image as a texture of 16 bits a texel, as text of C: docs/extras/rgb565.md."""

import os

import numpy as np

from fixel.image import c_names, c_scene, c_surfaces, c_text, image_surface
from fixel.model import texture_image
from fixel.scene import texture
from fixel.image.c_text import record, table
from fixel.base.errors import ToolError


def codes_of(file, size):
    """(an image file's codes (texture.codes_of), notes). size: (width, height) to scale it to, or None."""
    name = c_scene.printable(os.path.basename(file))
    opened = texture_image.read(file, name)
    if size is None and not {opened.width, opened.height} <= set(texture.SIDES):
        raise ToolError(f"{name}: an image of {opened.width} x {opened.height}; the sides of a texture are powers of two from "
                        f"1 to {texture.SIDE_MAX}: let --size scale it, like --size 64x64")
    pixels = opened.scaled(*size) if size else opened.pixels
    return texture.codes_of(pixels, pixels[..., 3] < texture.OPAQUE_FROM), opened.notes


def texels_of(levels):
    """(the texels of all levels by FXL_RGB565, the value of those that are not drawn or None)."""
    codes = np.concatenate([level.ravel() for level in levels])
    values, clear = codes >> 19 << 11 | (codes >> 10 & 63) << 5 | codes >> 3 & 31, codes < 0
    if not clear.any():
        return values.tolist(), None
    key = image_surface.free_key(values[~clear].tolist())
    return [key if is_clear else value for value, is_clear in zip(values.tolist(), clear.tolist())], key


def header(file, name, size=None, levels=1, clamp=False):
    """(the text of a header with the table of an image file's texels and its fxl_texture, texels, notes)."""
    c_names.check_name(name)
    codes, notes = codes_of(file, size)
    made = texture.levels_of(codes, levels)
    texels, key = texels_of(made)
    flags = (image_surface.CLAMP if clamp else 0) | (image_surface.KEYED if key is not None else 0)
    high, wide = made[0].shape
    about = f"{wide} x {high} texels of RGB565" + (f" and {len(made) - 1} smaller pictures" if len(made) > 1 else "") + \
        (f"; those of 0x{key:04X} are not drawn" if key is not None else "")
    members = [c_surfaces.as_bytes(f"{name}_texels"), "NULL", wide.bit_length() - 1,
               high.bit_length() - 1, "FXL_TEXTURE_565", flags, 0, len(made), key or 0]
    return c_text.header(f"Written by tools/scene.py from {c_scene.printable(os.path.basename(file))}.",
                         f"{name.upper()}_TEXTURE_H", ["fixel/surfaces.h"],
                         [table("uint16_t", f"{name}_texels", c_surfaces.texels_565(texels), about),
                          record("fxl_texture", f"{name}_texture", [", ".join(map(str, members))])]), len(texels), notes
