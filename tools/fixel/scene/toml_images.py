# SPDX-License-Identifier: MIT
"""Images of a model's materials as textures of its faces."""

import dataclasses
import functools

import numpy as np

from fixel.image import image_surface
from fixel.scene import texture
from fixel.base.errors import ToolError
from fixel.model.surface import product
from fixel.scene.surfaces import Paint
from fixel.scene.toml_table import Table

KEYS = {"images"}
_ROW_KEYS = {"size", "colours", "levels", "bits"}
TINTED_MAX = 64     # textures that are an image times the colours of vertices: more are left without


def _power(side, most):
    """The largest power of two that is not more than an image's side and than this."""
    return min(most, 1 << side.bit_length() - 1)


def _scaled(image, width, height):
    """An image's pixels, scaled by a box filter; many materials may ask for the same."""
    key = width, height
    if key not in image.pictures:
        image.pictures[key] = image.scaled(width, height).reshape(-1, 4)
    return image.pictures[key]


def picture(image, colour, size, most, levels, bits):
    """The texture.Picture of an image that is multiplied by a colour, scaled by a box filter to powers of two."""
    key = colour, size, most, levels, bits
    if key not in image.pictures:
        least = 2 if bits == 4 else 1       # texels of a row
        width, height = max(least, _power(image.width, size)), _power(image.height, size)
        scaled = _scaled(image, width, height)
        scaled = np.column_stack([(scaled[:, :3] * np.array(colour) + 127) // 255, scaled[:, 3]])
        codes = texture.codes_of(scaled, scaled[:, 3] < texture.OPAQUE_FROM).reshape(height, width)
        is_565 = bits == 16
        own = most if levels == 1 or is_565 else max(1, 3 * most // 4)   # the others are for the smaller levels
        made = texture.from_codes([codes if is_565 else texture.coarser(codes)], own)
        image.pictures[key] = texture.with_levels(made, levels, most, least) if levels > 1 else made
    return image.pictures[key]


def texel_bits(row):
    """Bits of a texel: 16 of RGB565, 8 or 4 of palette entries."""
    bits = row.whole("bits", 8, 4, 16)
    if bits not in (4, 8, 16):
        raise ToolError(f"{row.at('bits')}: 4, 8 or 16, found {bits}")
    return bits


def _most(row, bits):
    """How many colours a texture may have. Of 16 one is what is not drawn."""
    if bits == 16 and "colours" in row:
        raise ToolError(f"{row.at('colours')}: belongs to 4 and 8 bits; texels of RGB565 keep every colour")
    return texture.EVERY_COLOUR if bits == 16 else row.whole("colours", 15 if bits == 4 else 32, 1,
                                                             15 if bits == 4 else texture.COLOURS_MAX)


def _row(table):
    """(largest side, colours of a texture, levels, bits) of an object's images; None where it has none."""
    value = table.data.get("images", False)
    if isinstance(value, bool):
        value = {} if value else None
    if value is None:
        return None
    row = Table(value, table.at("images"), _ROW_KEYS)
    size = row.whole("size", 64, 1, texture.SIDE_MAX)
    if not texture.is_side(size):
        raise ToolError(f"{row.at('size')}: {size} is not a power of two from 1 to {texture.SIDE_MAX}")
    bits = texel_bits(row)
    return size, _most(row, bits), row.whole("levels", 1, 1, image_surface.LEVELS_MAX), bits


@dataclasses.dataclass(eq=False)    # equal only if the same: a file may have 65,535 faces, and as many objects
class Colours:
    """What colours the faces of a mesh wish for, each in turn; and whether an image covers them."""
    bases: tuple
    covered: tuple = (False,)


@dataclasses.dataclass(eq=False)
class Images:
    """What images make of the faces of a file: of each face its Paint or None, its opacity in 16ths, and its
    colour without an image. notes: what there is to say."""
    paints: tuple
    opacities: tuple
    materials: tuple
    notes: list

    @functools.cached_property
    def colours(self):
        """Of each face, the mean colour of its image, or that of its material."""
        means = {paint: paint.picture.mean for paint in dict.fromkeys(self.paints) if paint}
        return Colours(tuple(means[paint] if paint else colour for paint, colour in zip(self.paints, self.materials)),
                       self.covered)

    @functools.cached_property
    def covered(self):
        """Of each face, whether an image covers it."""
        return tuple(paint is not None for paint in self.paints)

    @functools.cached_property
    def is_opaque(self):
        """Whether no face is transparent."""
        return all(opacity == image_surface.OPAQUE for opacity in self.opacities)


def has_looks(surfaces):
    """Whether a material of a model has an image, or is partly transparent."""
    return any(material.image or material.opacity < 1 for material in surfaces.materials)


def read(table, mesh_of, known):
    """The Images of the faces of an object's file, by its materials; None unless it asks for images. mesh_of: answers the
    object's mesh. known: those that were made before."""
    row = _row(table)
    if row is None:
        return None
    for key in ("texture", "textures", "mapping", "texels_per_unit", "tiles", "opacity"):
        if key in table:
            raise ToolError(f"{table.at(key)}: the materials' images and their opacity are the file's; keep one or the other")
    surfaces = mesh_of().surfaces if "solid" not in table else None
    if surfaces is None or not has_looks(surfaces):
        raise ToolError(f"{table.at('images')}: the model has no material with an image, and none that is transparent")
    key = id(surfaces), row
    if key not in known:
        known[key] = _images(surfaces, row)
    return known[key]


def _tinted(surfaces):
    """Of each face (number of its material, what its image is multiplied by), None without an image; and notes."""
    pairs = [None if uvs is None or surfaces.materials[number].image is None else (number, tint)
             for number, uvs, tint in zip(surfaces.of_face, surfaces.uvs, surfaces.tints)]
    with_tint = {pair for pair in pairs if pair and pair[1] is not None}
    if len(with_tint) <= TINTED_MAX:
        return pairs, []
    return [pair and (pair[0], None) for pair in pairs], [
        f"colours of vertices are left out on faces that show an image: with it they would be {len(with_tint):,} textures, and "
        f"the limit is {TINTED_MAX}"]


def _paint(material, tint, row):
    colour = material.colour if tint is None else product(material.colour, tint)
    return Paint(picture(material.image, colour, *row), row[3], False, material.name)


def _images(surfaces, row):
    pairs, notes = _tinted(surfaces)
    made = {pair: _paint(surfaces.materials[pair[0]], pair[1], row) for pair in dict.fromkeys(pairs) if pair}
    opacities = [max(1, round(16 * material.opacity)) for material in surfaces.materials]
    return Images(tuple(pair and made[pair] for pair in pairs), tuple(opacities[number] for number in surfaces.of_face),
                  tuple(map(surfaces.own_colour, range(len(pairs)))), notes)
