# SPDX-License-Identifier: MIT
"""The surfaces of a scene image: what the loader asks of them (docs/formats.md, section 1.12)."""

from dataclasses import dataclass, field

from fixel.base.errors import ToolError
from fixel.image.fields import entry
from fixel.image.image_tables import Ranges
from fixel.image.image_tree import NORMAL_SQUARE_MAX_ERROR, TooLarge, fail

TABLE_MAX = 65535
TEXELS_MAX = 16 << 20           # bytes of all textures
LOG_MAX, LEVELS_MAX = 8, 9
TEXEL_MAX = 16383 << 16         # of a texture coordinate, in 16.16
BITS_8, BITS_4, RGB565 = 0, 1, 2    # formats
CLAMP, KEYED = 1, 2             # flags of a texture
DIVIDE_16, DIVIDE_8, DIVIDE_1, AFFINE = range(4)
LIT, BLENDED, ADDED, COLOURS = 1, 2, 4, 8   # flags of a surface
OPAQUE = 16

CORNERS_OF_SURFACE = 1 << 16    # that a surface's faces count

TEXTURE, SURFACE, MAPPED, MAP, NORMAL, CORNER = map(entry, ("textures", "surfaces", "mapped faces", "face map", "normals of corners",
                                                            "mapped corners"))
# Of a scene that has surfaces.
TABLES = ("textures", "texels", "surfaces", "mapped faces", "face map", "normals of corners", "blend table", "mapped corners")


@dataclass(frozen=True)
class Texture:
    """Palette indices, or colours of RGB565, of all levels, one after the other, row by row."""
    log_width: int
    log_height: int
    texels: bytes               # as the image has them
    colours: bytes = b""        # of a texture of 4 bits: 16 palette indices
    format: int = BITS_8
    flags: int = 0
    key: int = 0                # palette index
    levels: int = 1
    key_565: int = 0            # of RGB565


@dataclass(frozen=True)
class Surface:
    """What faces look like."""
    texture: int = 0            # counted from 1; 0: the face's own colour
    division: int = DIVIDE_16
    flags: int = 0
    opacity: int = OPAQUE
    sixteenths: int = 0         # BLENDED: what RGB565 frames show of the colour itself; 0: 8


@dataclass(frozen=True)
class Mapped:
    """How a surface lies on a face."""
    surface: int
    vertices: tuple             # numbers of three of the model's
    texels: tuple               # (u, v) at these, in 16.16; of COLOURS (red * 65536 + green * 256 + blue, 0)
    normals: tuple = (0, 0, 0)  # numbers of normals at these


@dataclass
class Surfaces:
    """The surfaces of a scene. What faces have of them stands with the faces: image.Face.mapped."""
    textures: list = field(default_factory=list)
    surfaces: list = field(default_factory=list)
    normals: list = field(default_factory=list)     # (x, y, z) in 2.30
    blend_first: int = 0        # palette index
    blend: list = field(default_factory=list)       # for each colour from that on 256 palette indices
    texture_names: list = field(default_factory=list, compare=False)    # of the textures, in turn; an image has none


def level_size(texture, level):
    """Width and height in texels."""
    least = 1 if texture.format == BITS_4 else 0
    return 1 << max(least, texture.log_width - level), 1 << max(0, texture.log_height - level)


def texel_bytes(texture):
    """Bytes of all levels."""
    texels = sum(width * height for width, height in (level_size(texture, i) for i in range(texture.levels)))
    return texels // 2 if texture.format == BITS_4 else 2 * texels if texture.format == RGB565 else texels


def free_key(values):
    """The first colour of RGB565 that no texel has."""
    taken = set(values)
    if len(taken - {None}) > 0xFFFF:
        raise ToolError("a texture with holes has a texel of each of the 65,536 colours of RGB565, and the holes need one: use a "
                        "smaller picture")
    return next(number for number in range(1 << 16) if number not in taken)


def share_corners(mapped, surfaces):
    """[(surface, its first corner)], [(number of one of these, three corners counted from its first)] for each mapped face, and the
    corners, each once: ((u, v), vertex, normal). The surfaces keep their numbers. A surface like it goes on behind them where faces
    of a surface would count more than CORNERS_OF_SURFACE corners."""
    placed, faces, corners, known = {(number, 0): number for number in range(len(surfaces))}, [], [], {}
    first = 0
    for one in mapped:
        own = list(zip(one.texels, one.vertices, one.normals))
        if len(corners) + len(set(own).difference(known)) > first + CORNERS_OF_SURFACE:
            first, known = len(corners), {}
        for corner in own:
            if corner not in known:
                known[corner] = len(corners) - first
                corners.append(corner)
        faces.append((placed.setdefault((one.surface, first), len(placed)), tuple(map(known.__getitem__, own))))
    return [(surfaces[number], begin) for number, begin in placed], faces, corners


def tables(surfaces, models):
    """Textures, texels, surfaces, mapped faces, face map, normals, blend table and corners as packed bytes, by name; nothing without
    surfaces."""
    if surfaces is None:
        return {}
    blob, placed, textures, numbers, face_map = bytearray(), {}, [], {}, []

    def place(table):
        """Where the bytes are: textures of equal texels share them."""
        if table not in placed:
            placed[table] = len(blob)
            blob.extend(table)
        return placed[table]

    for one in surfaces.textures:
        textures.append(TEXTURE.pack(place(one.texels), place(one.colours) if one.colours else 0, one.log_width,
                                     one.log_height, one.format, one.flags, one.key, one.levels, one.key_565))
    for face in (face for model in models for face in model.faces):
        face_map.append(MAP.pack(numbers.setdefault(face.mapped, len(numbers) + 1) if face.mapped else 0))
    for many, what in ((numbers, "faces with surfaces that lie differently"), (surfaces.normals, "normals of smooth corners")):
        if len(many) > TABLE_MAX:
            raise TooLarge(f"count: {len(many):,} {what} are more than {TABLE_MAX:,}; use smaller models")
    placed, mapped, corners = share_corners(numbers, surfaces.surfaces)
    return dict(zip(TABLES, [
        textures, bytes(blob),
        [SURFACE.pack(one.texture, one.division, one.flags, one.opacity, one.sixteenths, 0, 0, first) for one, first in placed],
        [MAPPED.pack(surface, *numbers) for surface, numbers in mapped], face_map, [NORMAL.pack(*normal) for normal in surfaces.normals],
        [bytes(row) for row in surfaces.blend], [CORNER.pack(*texel, vertex, normal) for texel, vertex, normal in corners]]))


# --- reading -------------------------------------------------------------------------------------

def _read_texture(fields, number, texels):
    at, colours, log_width, log_height, kind, flags, key, levels, key_565 = fields
    what = f"texture {number}"
    if max(log_width, log_height) > LOG_MAX or not 1 <= levels <= LEVELS_MAX:
        fail("range", f"{what}: its size or its number of levels is out of range")
    made = Texture(log_width, log_height, b"", b"", kind, flags, key, levels)
    size = texel_bytes(made)
    if at + size > len(texels.blob) or kind == BITS_4 and colours + 16 > len(texels.blob):
        fail("offset", f"{what} reaches outside the texels of the image")
    if kind != BITS_4 and colours:
        fail("reserved", f"{what} has no texels of 4 bits, but a place of colours")
    return Texture(log_width, log_height, texels.at(at, size), texels.at(colours, 16) if kind == BITS_4 else b"",
                   kind, flags, key, levels, key_565), at


def _check_texture(texture, at, number, pixel_bits):
    """The library's check of a texture. at: the place of its texels."""
    what = f"texture {number}"
    if texture.format == RGB565 and pixel_bits == 8:
        fail("reserved", f"{what} has texels of RGB565, and the image asks for frames of a palette")
    unused = texture.key if texture.format == RGB565 else texture.key_565
    if texture.format > RGB565 or texture.flags > CLAMP | KEYED or unused:
        fail("reserved", f"{what}: a flag, a format or the key of another format is not what it may be")
    if texture.format == BITS_4 and not texture.log_width or \
            texture.levels > max(texture.log_width, texture.log_height) + 1:
        fail("range", f"{what}: it is too narrow, or has too many levels")
    if texture.format == RGB565 and at % 2:
        fail("alignment", f"{what} has texels of RGB565 at an odd place")


def _read_surface(fields, number, textures, corners, blend, pixel_bits):
    texture, division, flags, opacity, sixteenths, *reserved, first_corner = fields
    if texture > textures or first_corner > corners:
        fail("index", f"surface {number}: texture {texture} of {textures}, or first corner {first_corner} of {corners}")
    if not 1 <= opacity <= OPAQUE:
        fail("range", f"surface {number}: an opacity of {opacity} is outside 1..{OPAQUE}")
    if sixteenths > OPAQUE:
        fail("range", f"surface {number}: {sixteenths} sixteenths of a colour are more than the colour")
    if flags & BLENDED and not blend and pixel_bits == 8:
        fail("argument", f"surface {number} is blended, and there is no blend table")
    if flags & ADDED and pixel_bits == 8:
        fail("reserved", f"surface {number} is added to what is beneath, and the image asks for frames of a palette")
    if flags & COLOURS and pixel_bits == 8:
        fail("reserved", f"surface {number} has colours at corners, and the image asks for frames of a palette")
    if flags & COLOURS and texture:
        fail("reserved", f"surface {number} has colours at corners, and a texture")
    if division > AFFINE or flags > LIT | BLENDED | ADDED | COLOURS or flags & BLENDED and flags & ADDED or any(reserved) or \
            sixteenths and not flags & BLENDED:
        fail("reserved", f"surface {number}: a flag or a reserved field is not what it may be")
    return Surface(texture, division, flags, opacity, sixteenths)


def _on_one_line(a, b, c):
    p, q = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
    return all(p[i - 1] * q[i] == p[i] * q[i - 1] for i in range(3))


def _read_mapped(fields, number, surfaces, corners, model):
    """The record of a face of a model. surfaces: a Surfaces; corners: for each surface those from its first one on."""
    surface, *numbers = fields
    what = f"mapped face {number}"
    if surface >= len(surfaces.surfaces) or max(numbers) >= len(corners[surface]):
        fail("index", f"{what}: its surface or a corner does not exist")
    us, vs, vertices, normals = zip(*map(corners[surface].__getitem__, numbers))
    if max(vertices) >= len(model.vertices):
        fail("index", f"{what}: a vertex does not exist")
    if surfaces.surfaces[surface].flags & LIT and max(normals) >= len(surfaces.normals):
        fail("index", f"{what}: a normal does not exist")
    if surfaces.surfaces[surface].flags & COLOURS:
        if any(not 0 <= u < 1 << 24 for u in us) or any(vs):
            fail("range", f"{what}: a colour at a corner is not one of 24 bits")
    elif any(abs(c) > TEXEL_MAX for c in us + vs):
        fail("range", f"{what}: a texture coordinate leaves -16383..16383")
    if _on_one_line(*map(model.vertices.__getitem__, vertices)):
        fail("degenerate", f"{what}: its vertices are on one line")
    return Mapped(surface, vertices, tuple(zip(us, vs)), normals)


def read(found, blend_first, models, pixel_bits=8):
    """The surfaces of the tables of an image, None where there are none; gives the faces theirs. found: {name of a table: its
    entries}. pixel_bits: of the frames that the image asks for."""
    textures, texels, surfaces, mapped, face_map, normals, blend, corners = (found[name] for name in TABLES)
    if not face_map:
        return None
    ranges = Ranges(texels)
    placed = [_read_texture(fields, i, ranges) for i, fields in enumerate(textures)]
    if blend_first > 255 or len(blend) > 256 - blend_first:
        fail("count", f"a blend table of {len(blend)} colours from {blend_first} on")
    for i, (texture, at) in enumerate(placed):
        _check_texture(texture, at, i, pixel_bits)
    made = Surfaces([texture for texture, _ in placed],
                    [_read_surface(fields, i, len(placed), len(corners), blend, pixel_bits) for i, fields in enumerate(surfaces)], normals,
                    blend_first, [list(row) for row in blend])
    for i, normal in enumerate(normals):
        if abs(sum(c * c for c in normal) - (1 << 60)) > NORMAL_SQUARE_MAX_ERROR:
            fail("normal", f"normal {i} of a corner is not of unit length")
    tails = {first: corners[first:] for first in {fields[-1] for fields in surfaces}}
    of_surfaces = [tails[fields[-1]] for fields in surfaces]
    faces = ((model, face) for model in models for face in model.faces)
    for i, (number, (model, face)) in enumerate(zip(face_map, faces)):
        if number > len(mapped):
            fail("index", f"face {i}: mapped face {number} of {len(mapped)}")
        if number:
            face.mapped = _read_mapped(mapped[number - 1], number - 1, made, of_surfaces, model)
    return made
