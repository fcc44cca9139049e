# SPDX-License-Identifier: MIT
"""Images of a model's materials as textures of its faces."""

import collections
import dataclasses
import functools
import math

import numpy as np

from fixel.image import image_surface
from fixel.model import quantity
from fixel.scene import image_cut, keys, texture
from fixel.base.errors import ToolError
from fixel.model.surface import product
from fixel.scene.surfaces import Paint
from fixel.scene.toml_table import Table

PLAIN_MAX = 128     # colours of images in RGB565 that faces have of the palette
TINTED_MAX = 64     # textures that are an image times the colours of vertices: more are left without


def _sides(image, size, bits):
    """Texels of the picture of an image: the least powers of two that hold its sides, or the largest that may be."""
    least = 2 if bits == 4 else 1       # of a row
    return max(least, min(size, image_cut.power_above(image.width))), min(size, image_cut.power_above(image.height))


def _scaled(image, width, height):
    """An image's pixels, scaled by a box filter; many materials may ask for the same."""
    key = width, height
    if key not in image.pictures:
        image.pictures[key] = image.scaled(width, height).reshape(-1, 4)
    return image.pictures[key]


def _of_565(pixels):
    """The nearest colours of RGB565, which texels of 16 bits keep: fewer colours, and so less work."""
    most = np.array([31, 63, 31])
    values = (pixels.astype(int) * most * 2 + 255) // 510
    return values * 255 // most


def picture(image, colour, size, most, levels, bits):
    """The texture.Picture of an image that is multiplied by a colour, scaled by a box filter to powers of two."""
    key = colour, size, most, levels, bits
    if key not in image.pictures:
        least = 2 if bits == 4 else 1
        width, height = _sides(image, size, bits)
        scaled = _scaled(image, width, height)
        scaled = np.column_stack([(scaled[:, :3] * np.array(colour) + 127) // 255, scaled[:, 3]])
        if bits == 16:
            scaled = np.column_stack([_of_565(scaled[:, :3]), scaled[:, 3]])
        codes = texture.codes_of(scaled, scaled[:, 3] < texture.OPAQUE_FROM).reshape(height, width)
        is_565 = bits == 16
        own = most if levels == 1 or is_565 else max(1, 3 * most // 4)   # the others are for the smaller levels
        made = texture.from_codes([codes if is_565 else texture.coarser(codes)], own)
        image.pictures[key] = texture.with_levels(made, levels, most, least) if levels > 1 else made
    return image.pictures[key]


def most_colours(row, key, most_of_4):
    """How many colours a texture may have, by the key of its row. most_of_4: of 4 bits a texel, whose 16 have what is not drawn."""
    if row["bits"] == 16:
        row.refuse((key,), "belongs to 4 and 8 bits; texels of RGB565 keep every colour")
        return texture.EVERY_COLOUR
    most = row.get(key, 15 if row["bits"] == 4 else 32)
    return quantity.in_range(most, 1, most_of_4 if row["bits"] == 4 else texture.COLOURS_MAX, row.at(key))


def _row(table):
    """(largest side, colours of a texture, levels, bits) of an object's images; None where it has none."""
    row = table["images"]
    if row is False:
        return None
    row = Table({}, table.at("images"), keys.IMAGES) if row is True else row
    return row["size"], most_colours(row, "colours", 15), row["levels"], row["bits"]


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
    table.refuse(("texture", "textures", "mapping", "texels_per_unit", "tiles", "opacity"),
                 "the materials' images and their opacity are the file's; keep one or the other")
    mesh = mesh_of() if "solid" not in table else None
    surfaces = mesh.surfaces if mesh else None
    if surfaces is None or not has_looks(surfaces):
        raise ToolError(": ".join([f"{table.at('images')}: the model has no material with an image that can be read, and none that is "
                                   "transparent", *(mesh.unread[:1] if mesh else [])]))
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
    """Of each face what it has of an image: (image, whether it clamps, what multiplies it), None without an image; and notes."""
    materials, of_face = surfaces.materials, surfaces.of_face
    shows = [uvs is not None and materials[number].image is not None for number, uvs in zip(of_face, surfaces.uvs)]
    count = len({(number, tint) for number, tint, is_shown in zip(of_face, surfaces.tints, shows) if is_shown and tint is not None})
    keeps = count <= TINTED_MAX
    found = [(materials[number].image, materials[number].clamp, product(materials[number].colour, tint) if tint and keeps else materials[number].colour)
             if is_shown else None for number, tint, is_shown in zip(of_face, surfaces.tints, shows)]
    return found, [] if keeps else [
        f"colours of vertices are left out on faces that show an image: with it they would be {count:,} textures, and "
        f"the limit is {TINTED_MAX}"]


def _grouped(keys):
    """{key: its faces}."""
    found = {}
    for face, key in enumerate(keys):
        if key is not None:
            found.setdefault(key, []).append(face)
    return found


class _Parts:
    """What faces show of the images of their materials. colours: of faces that show one colour; others have a paint, and
    uvs on its picture."""

    def __init__(self, surfaces, row):
        self.surfaces, self.row = surfaces, row
        self.paints, self.colours, self.uvs = [None] * len(surfaces.of_face), {}, list(surfaces.uvs)

    def _paint(self, image, colour, clamp, faces):
        """Gives faces a picture of a whole image, or of a canvas."""
        name = self.surfaces.materials[self.surfaces.of_face[faces[0]]].name
        paint = Paint(picture(image, colour, *self.row), self.row[3], clamp, name)
        for face in faces:
            self.paints[face] = paint

    def add(self, image, clamp, colour, faces):
        """The faces on an image that a colour multiplies."""
        image, kept = image.whole(), image
        own = [self.surfaces.uvs[face] for face in faces]
        found = image_cut.colours(image, own, clamp)
        self.colours.update((face, product(plain, colour)) for face, plain in zip(faces, found) if plain is not None)
        others = [face for face, plain in zip(faces, found) if plain is None]
        if not others:
            return
        outlines = image_cut.Outlines(image, [self.surfaces.uvs[face] for face in others], clamp)
        cuts = image_cut.cuts(outlines, self.row[0])
        if cuts is None:
            self._paint(kept, colour, clamp, others)
        for cut, numbers in cuts or ():
            self._paint(image_cut.canvas(outlines, cut, numbers), colour, clamp or cut.clamps, [others[number] for number in numbers])
            for number in numbers:
                self.uvs[others[number]] = image_cut.within(outlines, cut, number)

    def swatches(self):
        """Leaves the PLAIN_MAX colours that most faces have to the palette, which all share. In RGB565 each of the others becomes a
        texel of one picture; texels of 4 and 8 bits are entries of the palette themselves."""
        if self.row[3] != 16:
            return
        ranks = [colour for colour, _ in collections.Counter(self.colours.values()).most_common()]
        rest = {colour: place for place, colour in enumerate(ranks[PLAIN_MAX:PLAIN_MAX + texture.SIDE_MAX ** 2])}
        if not rest:
            return
        side = image_cut.power_above(math.isqrt(len(rest) - 1) + 1)
        texels = np.resize(np.array([[*colour, 255] for colour in rest], dtype=np.uint8), (side, side, 4))
        codes = texture.codes_of(np.column_stack([_of_565(texels.reshape(-1, 4)[:, :3]), texels.reshape(-1, 4)[:, 3]]), False)
        paint = Paint(texture.from_codes([codes.reshape(side, side)], texture.EVERY_COLOUR), 16, False, "colours")
        for face in [face for face, colour in self.colours.items() if colour in rest]:
            row, column = divmod(rest[self.colours.pop(face)], side)
            self.paints[face] = paint
            self.uvs[face] = [((column + 0.5) / side, (row + 0.5) / side)] * len(self.uvs[face])


def _images(surfaces, row):
    keys, notes = _tinted(surfaces)
    parts = _Parts(surfaces, row)
    for key, faces in _grouped(keys).items():
        parts.add(*key, faces)
    parts.swatches()
    opacities = [max(1, round(16 * material.opacity)) for material in surfaces.materials]
    own = [parts.colours[face] if face in parts.colours else surfaces.own_colour(face) for face in range(len(keys))]
    paints = tuple(parts.paints) if any(parts.paints) else (None,)
    opacities = tuple(opacities[number] for number in surfaces.of_face)
    return Images(paints, opacities if set(opacities) != {image_surface.OPAQUE} else (image_surface.OPAQUE,), tuple(own),
                  tuple(parts.uvs), notes)
