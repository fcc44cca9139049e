# SPDX-License-Identifier: MIT
"""Images of a model's materials as textures of its faces."""

import collections
import dataclasses
import functools

import numpy as np

from fixel.image import image_surface
from fixel.scene import image_parts, texture
from fixel.base.errors import ToolError
from fixel.model.surface import product
from fixel.scene.surfaces import Paint
from fixel.scene.toml_table import Table

KEYS = {"images"}
_ROW_KEYS = {"size", "colours", "levels", "bits"}
PLAIN_MAX = 128     # colours of an image that faces have instead of a texture
TINTED_MAX = 64     # textures that are an image times the colours of vertices: more are left without


def _power(side, most):
    """The largest power of two that is not more than an image's side and than this."""
    return min(most, 1 << side.bit_length() - 1)


def _power_above(side, most):
    """The least power of two that is not less than a part's side, or this if that is less."""
    return min(most, 1 << (side - 1).bit_length())


def _sides(image, part, size, bits):
    """Texels of the picture of an image, or of a part of it, which is not made smaller than it need be."""
    least = 2 if bits == 4 else 1       # of a row
    if part is None:
        return max(least, _power(image.width, size)), _power(image.height, size)
    left, top, right, bottom = part
    return max(least, _power_above(right - left, size)), _power_above(bottom - top, size)


def _scaled(image, width, height, part):
    """An image's pixels, scaled by a box filter; many materials may ask for the same."""
    key = width, height, part
    if key not in image.pictures:
        image.pictures[key] = image.scaled(width, height, part).reshape(-1, 4)
    return image.pictures[key]


def _of_565(pixels):
    """The nearest colours of RGB565, which texels of 16 bits keep: fewer colours, and so less work."""
    most = np.array([31, 63, 31])
    values = (pixels.astype(int) * most * 2 + 255) // 510
    return values * 255 // most


def picture(image, colour, size, most, levels, bits, part=None):
    """The texture.Picture of an image, or of a part of it, that is multiplied by a colour, scaled by a box filter to
    powers of two."""
    key = colour, size, most, levels, bits, part
    if key not in image.pictures:
        least = 2 if bits == 4 else 1
        width, height = _sides(image, part, size, bits)
        scaled = _scaled(image, width, height, part)
        scaled = np.column_stack([(scaled[:, :3] * np.array(colour) + 127) // 255, scaled[:, 3]])
        if bits == 16:
            scaled = np.column_stack([_of_565(scaled[:, :3]), scaled[:, 3]])
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
    """What images make of the faces of a file: of each face its Paint or None, its opacity in 16ths, its
    colour without a texture, and its coordinates. notes: what there is to say."""
    paints: tuple
    opacities: tuple
    materials: tuple
    uvs: tuple
    notes: list

    @functools.cached_property
    def colours(self):
        """Of each face, the mean colour of its image, or that of its material."""
        means = {paint: paint.picture.mean for paint in dict.fromkeys(self.paints) if paint}
        paints = self.paints if len(self.paints) > 1 else self.paints * len(self.materials)
        return Colours(tuple(means[paint] if paint else colour for paint, colour in zip(paints, self.materials)), self.covered)

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
    return _known(surfaces, row, known)


def _known(surfaces, row, known):
    """The Images of surfaces, made once."""
    key = id(surfaces), row
    if key not in known:
        known[key] = _part(_known(surfaces.whole[0], row, known), surfaces.whole[1]) if surfaces.whole else _images(surfaces, row)
    return known[key]


def _part(images, faces):
    """The Images of some faces."""
    def of(values):
        return tuple(values[face] for face in faces) if len(values) > 1 else values
    return Images(of(images.paints), of(images.opacities), of(images.materials), of(images.uvs), images.notes)


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


def _grouped(pairs):
    """{pair: its faces}."""
    found = {}
    for face, pair in enumerate(pairs):
        if pair is not None:
            found.setdefault(pair, []).append(face)
    return found


def _most_frequent(colours):
    """The colours of faces, None for those that PLAIN_MAX others have on more faces: all share one palette."""
    counts = collections.Counter(colour for colour in colours if colour is not None)
    kept = dict(counts.most_common(PLAIN_MAX))
    return [colour if colour in kept else None for colour in colours]


class _Parts:
    """What faces show of the images of their materials. colours: of faces that show one colour; others have a paint, and
    uvs on its picture."""

    def __init__(self, surfaces, row):
        self.surfaces, self.row = surfaces, row
        self.paints, self.colours, self.uvs = [None] * len(surfaces.of_face), {}, list(surfaces.uvs)

    def add(self, pair, faces):
        """The faces of a material and of a colour that multiplies its image."""
        surfaces, (number, tint) = self.surfaces, pair
        material = surfaces.materials[number]
        colour = material.colour if tint is None else product(material.colour, tint)
        if material.clamp:
            paint = Paint(picture(material.image, colour, *self.row), self.row[3], True, material.name)
            for face in faces:
                self.paints[face] = paint
            return
        found = _most_frequent(image_parts.colours(material.image, [surfaces.uvs[face] for face in faces]))
        self.colours.update((face, product(plain, colour)) for face, plain in zip(faces, found) if plain is not None)
        others = [face for face, plain in zip(faces, found) if plain is None]
        if not others:
            return
        part = image_parts.rectangle(material.image, [surfaces.uvs[face] for face in others])
        paint = Paint(picture(material.image, colour, *self.row, part), self.row[3], False, material.name)
        for face in others:
            self.paints[face] = paint
            if part:
                self.uvs[face] = image_parts.within(surfaces.uvs[face], material.image, part)


def _images(surfaces, row):
    pairs, notes = _tinted(surfaces)
    parts = _Parts(surfaces, row)
    for pair, faces in _grouped(pairs).items():
        parts.add(pair, faces)
    opacities = [max(1, round(16 * material.opacity)) for material in surfaces.materials]
    own = [parts.colours[face] if face in parts.colours else surfaces.own_colour(face) for face in range(len(pairs))]
    paints = tuple(parts.paints) if any(parts.paints) else (None,)
    opacities = tuple(opacities[number] for number in surfaces.of_face)
    return Images(paints, opacities if set(opacities) != {image_surface.OPAQUE} else (image_surface.OPAQUE,), tuple(own),
                  tuple(parts.uvs), notes)
