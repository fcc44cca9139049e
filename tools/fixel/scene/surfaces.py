# SPDX-License-Identifier: MIT
"""How surfaces lie on faces, and the records of a scene image that say so.

A face's texture coordinates must be affine over it (docs/formats.md, section 1.12): a face of a file whose
coordinates are not is cut into triangles."""

from dataclasses import dataclass, field, replace
from fractions import Fraction
import functools
from math import ceil, floor, lcm

from fixel.image import image_surface
from fixel.scene import palette
from fixel.base.errors import ToolError
from fixel.image.image import Face
from fixel.image.image_surface import Mapped, Surface, Surfaces, Texture
from fixel.base.vectors import cross, dot, minus
from fixel.model.mesh import UNIT, newell, transform

BEND_MAX = Fraction(1, 64)      # texels: what a corner may be off the affine map of three others
EDGE_ROUNDING = Fraction(1, 128)    # texels: so far beyond an edge of a texture a coordinate is on it
_NEARLY = 1e-3                      # texels: what floats of them are off, and more
DIVISIONS = {16: image_surface.DIVIDE_16, 8: image_surface.DIVIDE_8, 1: image_surface.DIVIDE_1,
             "affine": image_surface.AFFINE}
# Texels that a coordinate may be off between two divisions (SPEC.md, section 9.2).
_BETWEEN = {image_surface.DIVIDE_16: Fraction(3, 10), image_surface.DIVIDE_8: Fraction(3, 40), image_surface.DIVIDE_1: Fraction(0),
            image_surface.AFFINE: Fraction(3, 10)}


@dataclass(frozen=True)
class Paint:
    """A texture as a scene asks for it, without its colours. Equal only if the same picture is. own: the name of one that is stored
    by itself, as its size is being measured."""
    picture: object         # texture.Picture
    bits: int
    clamp: bool
    name: str = field(default="", compare=False)    # for a program that is exported
    own: str = ""


@dataclass(frozen=True)
class Look:
    """What a face looks like, and where three of its corners are on the texture. colours: those that the picture's
    become on this face, as red, green, blue; none without a texture. normals: at these corners, in 2.30, of what is lit."""
    paint: Paint
    colours: tuple
    division: int
    flags: int
    opacity: int
    corners: tuple
    texels: tuple
    normals: tuple = ()

    @property
    def is_565(self):
        """Whether its texels are of RGB565: the palette has not their colours."""
        return self.paint is not None and self.paint.bits == 16


# --- coordinates ---------------------------------------------------------------------------------

def box_axes(normal):
    """(index, sign) of the axes along u and along v of a face, as one who looks at its front sees them: of the three
    planes of a box the one that the face is nearest to."""
    axis = max(range(3), key=lambda i: (abs(normal[i]), -i))
    front = 1 if normal[axis] > 0 else -1
    if axis == 0:
        return (2, front), (1, -1)
    if axis == 1:
        return (0, 1), (2, -front)
    return (0, -front), (1, -1)


def box_coordinates(mesh, scale, inside, per_unit, offset):
    """For each face of a mesh (u, v) in texels of each corner, by planes of a box about the mesh before it turns.
    per_unit: texels a world unit."""
    common = lcm(*(Fraction(s).denominator for s in scale))
    sizes = [int(s * common) for s in scale]
    points = [tuple(c * s for c, s in zip(vertex, sizes)) for vertex in mesh.vertices]  # in 1/(UNIT common)
    # Integers up to the last step: a Fraction takes ten times as long.
    texel, (left, above) = Fraction(per_unit) / (UNIT * common), map(Fraction, offset)
    whole = lcm(texel.denominator, left.denominator, above.denominator)
    step, left, above = int(texel * whole), int(left * whole), int(above * whole)
    result = []
    for face in mesh.faces:
        outline = [points[c] for c in face]
        (i, along), (j, down) = box_axes([n * (-1 if inside else 1) for n in newell(outline)])
        result.append([(Fraction(along * step * p[i] + left, whole), Fraction(down * step * p[j] + above, whole))
                       for p in outline])
    return result


def _over_one_denominator(values):
    """(numerators, denominator) of Fractions."""
    common = lcm(*[value.denominator for value in values])
    return [value.numerator * (common // value.denominator) for value in values], common


def _tiled_axis(values, side):
    """The coordinates of a face's corners along one axis, moved and stretched to 0..side."""
    numbers, _ = _over_one_denominator(values)
    low, high, side = min(numbers), max(numbers), Fraction(side)
    if high == low:
        return [Fraction(0)] * len(values)
    return [Fraction((number - low) * side.numerator, (high - low) * side.denominator) for number in numbers]


def tiled(coordinates, size):
    """The same, moved and stretched so that a face's bounding rectangle is so many texels."""
    return [list(zip(*(_tiled_axis(axis, side) for axis, side in zip(zip(*face), size)))) for face in coordinates]


# --- faces ---------------------------------------------------------------------------------------

@functools.lru_cache(1 << 14)      # a face comes here twice
def _best_corners(points):
    """Three corners of an outline, in rising order, whose triangle is the largest; of several the first. points: a
    tuple."""
    if len(points) == 3:
        return 0, 1, 2
    largest, best = -1, None
    for i, (x, y, z) in enumerate(points[:-2]):
        edges = [(a - x, b - y, c - z) for a, b, c in points[i + 1:]]
        for j, (p, q, r) in enumerate(edges[:-1], i + 1):
            for k, (a, b, c) in enumerate(edges[j - i:], j + 1):
                u, v, w = q * c - r * b, r * a - p * c, p * b - q * a
                square = u * u + v * v + w * w
                if square > largest:
                    largest, best = square, (i, j, k)
    return best


def _is_affine(points, coordinates, three):
    """Whether every corner's coordinates are those that three of them give it."""
    first, one, two = (points[i] for i in three)
    e, f = minus(one, first), minus(two, first)
    ee, ef, ff = dot(e, e), dot(e, f), dot(f, f)
    whole = ee * ff - ef * ef
    axes = [_over_one_denominator(axis) for axis in zip(*coordinates)]
    for number, point in enumerate(points):
        if number in three:
            continue
        pe, pf = dot(minus(point, first), e), dot(minus(point, first), f)
        s, t = pe * ff - pf * ef, pf * ee - pe * ef     # of whole
        for values, common in axes:
            a, b, c = (values[i] for i in three)
            bend = (a - values[number]) * whole + s * (b - a) + t * (c - a)
            if abs(bend) * BEND_MAX.denominator > BEND_MAX.numerator * whole * common:
                return False
    return True


def source_coordinates(mesh, rows, made, coordinates):
    """For each face of a shape the coordinates of its corners, from those of the mesh's face that it came from."""
    points, result, last = transform(mesh, rows), [], None
    for face, source in zip(made.faces, made.sources):
        if source != last:      # the pieces of a face stand together
            known, last = {points[c]: uv for c, uv in reversed(list(zip(mesh.faces[source], coordinates[source])))}, source
            outline = [points[c] for c in mesh.faces[source]]
        for c in face.corners:
            if made.vertices[c] not in known:
                known[made.vertices[c]] = _on_outline(made.vertices[c], outline, known)
        result.append([known[made.vertices[c]] for c in face.corners])
    return result


def _on_outline(point, outline, known):
    """The coordinates at a vertex that lies on an edge of a face's outline (t_junctions.py), between those of its ends."""
    def off(edge):
        way, apart = minus(edge[1], edge[0]), minus(point, edge[0])
        square, across = dot(way, way), cross(apart, way)
        along = Fraction(dot(apart, way), square) if square else Fraction(-1)
        return (not 0 <= along <= 1, Fraction(dot(across, across), square) if square else Fraction(0)), along
    (_, along), edge = min(((off(edge), edge) for edge in zip(outline, outline[1:] + outline[:1])), key=lambda found: found[0])
    return tuple(a + (b - a) * along for a, b in zip(known[edge[0]], known[edge[1]]))


def triangles(outline):
    """The triangles of a convex outline, by the numbers of its corners, without those that have no area."""
    pieces = [(0, i, i + 1) for i in range(1, len(outline) - 1)]
    return [p for p in pieces if any(cross(minus(outline[p[1]], outline[0]), minus(outline[p[2]], outline[0])))]


def spread(mesh, rows, made, coordinates):
    """(shape, coordinates of each face's corners): a shape whose coordinates are affine over each face. made: the shape
    of the mesh and of the matrix. coordinates: for each face of the mesh, of each corner; None where it has none."""
    faces, sources, result = [], [], []
    for face, source, found in zip(made.faces, made.sources, source_coordinates(mesh, rows, made, coordinates)):
        outline = tuple(made.vertices[c] for c in face.corners)
        is_whole = len(outline) == 3 or _is_affine(outline, found, _best_corners(outline))
        for piece in [range(len(outline))] if is_whole else triangles(outline):
            faces.append(Face(face.normal, tuple(face.corners[i] for i in piece), face.colour))
            sources.append(source)
            result.append([found[i] for i in piece])
    return replace(made, faces=faces, sources=sources), result


def _q16(value):
    """A Fraction in 16.16, to nearest."""
    return ((value.numerator << 17) + value.denominator) // (2 * value.denominator)


@functools.cache
def edge_margin(side, levels, division):
    """side: the longer one of the texture. Texels that the coordinates of a face keep from an edge of a texture that repeats, so that no pixel shows its opposite side:
    what SPEC.md, section 9.2, allows between two divisions, what steps round (docs/accuracy.md, section 5.2, for three repetitions
    in 16 columns), and 1/256 texel of the smallest level."""
    return _BETWEEN[division] + Fraction(12 * side, 1 << 16) + Fraction(1 << levels - 1, 256)


def _kept_ends(values, side, margin):
    """The (least, largest) that a face's coordinates along an axis are held within. A coordinate that ends at an edge of the
    texture, or at most EDGE_ROUNDING beyond it, keeps the margin from it; None where none does."""
    near = list(map(float, values))     # a Fraction takes ten times as long
    if all(float(margin) + _NEARLY < place % side < side - float(EDGE_ROUNDING) - _NEARLY for place in (min(near), -max(near))):
        return None
    low, high = min(values), max(values)
    start, end = side * floor((low + EDGE_ROUNDING) / side), side * ceil((high - EDGE_ROUNDING) / side)
    if low >= start + margin and high <= end - margin:
        return None
    if end <= start:            # all lie on one edge: they show the texels before it, if there are any
        least = largest = start - margin if start > 0 else start + margin
    else:
        least, largest = max(low, start + margin), min(high, end - margin)
        if least > largest:     # all lie within the margin of one edge
            least = largest = least if low < start + margin else largest
    return least, largest


def within_edges(points, coordinates, three, sides, margin):
    """The coordinates of a face on a texture that repeats, without those nearer to its edges than a margin: each is held within
    what _kept_ends says, so that faces that share a corner agree; where that is not affine over the face, all are stretched."""
    axes = list(zip(*coordinates))
    ends = [_kept_ends(values, side, margin) if side > 1 else None for values, side in zip(axes, sides)]
    if ends == [None, None]:
        return coordinates
    held = [values if kept is None else [min(max(value, kept[0]), kept[1]) for value in values] for values, kept in zip(axes, ends)]
    result = list(zip(*held))
    if len(points) == 3 or _is_affine(points, result, three):
        return result
    return list(zip(*(values if kept is None else _stretched(values, *kept) for values, kept in zip(axes, ends))))


def _stretched(values, least, largest):
    """The same from the least to the largest of these."""
    low, high = min(values), max(values)
    return [least + (value - low) * Fraction(largest - least) / (high - low) if high > low else least for value in values]


def place(points, coordinates, paint, where, division=image_surface.DIVIDE_16):
    """(corners, texels in 16.16) of a face. A texture that repeats is moved by whole widths and heights to where its
    least coordinates are small, and its edges stay on their sides (within_edges). A paint without a picture has no texels."""
    three = _best_corners(tuple(points))
    if paint.picture is None:
        return three, ((0, 0),) * 3
    moved = (0, 0)
    if not paint.clamp:
        sides = paint.picture.width, paint.picture.height
        margin = edge_margin(max(sides), len(paint.picture.levels), division)
        coordinates = within_edges(points, coordinates, three, sides, margin)
        moved = [min(axis) // side * side for axis, side in zip(zip(*coordinates), sides)]
    texels = tuple([(_q16(u) - (moved[0] << 16), _q16(v) - (moved[1] << 16)) for u, v in map(coordinates.__getitem__, three)])
    if any(abs(c) > image_surface.TEXEL_MAX for texel in texels for c in texel):
        raise ToolError(f"{where}: a face is more than 16383 texels long; give fewer texels_per_unit, or divide the face")
    return three, texels


# --- records -------------------------------------------------------------------------------------

def _pack_4(numbers):
    flat = [number for row in numbers for number in row]
    return bytes(low | high << 4 for low, high in zip(flat[::2], flat[1::2]))


def _texels_565(values):
    """(the bytes of texels of RGB565, their key). values: None is what is not drawn."""
    key = image_surface.free_key(values) if None in values else 0
    return b"".join((key if value is None else value).to_bytes(2, "little") for value in values), key


def _texture(paint, entries):
    """The record of a paint. entries: of each of its colours the palette index, or, of a paint of 16 bits, the colour of
    RGB565. What is clear has index 0, the background's, which no colour has."""
    picture = paint.picture
    flags = (image_surface.CLAMP if paint.clamp else 0) | (image_surface.KEYED if picture.has_clear else 0)
    sides, count = (picture.width.bit_length() - 1, picture.height.bit_length() - 1), len(picture.levels)
    if paint.bits == 16:
        texels, key = _texels_565([None if n is None else entries[n] for level in picture.levels for row in level for n in row])
        return Texture(*sides, texels, b"", image_surface.RGB565, flags, 0, count, key)
    if paint.bits == 4:
        clear = len(entries)        # the first number that no colour has
        texels = b"".join(_pack_4([[clear if n is None else n for n in row] for row in level]) for level in picture.levels)
        return Texture(*sides, texels, bytes((list(entries) + [0] * 16)[:16]), image_surface.BITS_4, flags, 0, count)
    texels = bytes(0 if n is None else entries[n] for level in picture.levels for row in level for n in row)
    return Texture(*sides, texels, b"", image_surface.BITS_8, flags, 0, count)


# place stipple: a blend: the table that the tools make
def blend_table(colours, sixteenths, blended):
    """For each of these entries of the palette 256 others: what it shows over each, as fxl_blend_make_table has it."""
    nearest = palette.Nearest(colours)
    rows = [nearest.of_all([palette.between(under, colours[number], sixteenths, 16) for under in colours])
            for number in blended]
    return [[number if beneath == number else shown for beneath, shown in enumerate(row)] for number, row in zip(blended, rows)]


class Records:
    """Collects the textures and surfaces of a scene. indices: the palette index of each colour."""

    def __init__(self, indices):
        self.indices = indices
        self.textures, self.by_texels, self.surfaces, self.normals = {}, {}, {}, {}
        self.known = {}     # (paint, id of its colours): number of a texture, the colours
        self.made, self.blended = Surfaces(), set()     # colours, and whether light changes them

    def _texture(self, look):
        """The number of a look's texture, counted from 1; 0 without one."""
        if look.paint is None:
            return 0
        same = look.paint, id(look.colours)     # most faces of a paint share one object
        if same not in self.known:
            entries = tuple(palette.rgb565(colour[:3]) if look.is_565 else self.indices[colour] for colour in look.colours)
            key = look.paint, entries
            if key not in self.textures:
                self.textures[key] = self._stored(look.paint, entries)
            self.known[same] = self.textures[key], look.colours     # which keeps the id its own
        return self.known[same][0]

    def _stored(self, paint, entries):
        """The number of the texture of a paint, which is that of one with the same texels if there is one."""
        made = _texture(paint, entries)
        if (made, paint.own) not in self.by_texels:
            self.made.textures.append(made)
            self.made.texture_names.append(paint.name)
            self.by_texels[made, paint.own] = len(self.made.textures)
        return self.by_texels[made, paint.own]

    def mapped(self, look, own, corners):
        """The record of a face of this colour and these corners; None without a look."""
        if look is None:
            return None
        if look.flags & image_surface.BLENDED and not look.is_565:     # which no table blends
            self.blended.update((colour, bool(look.flags & image_surface.LIT)) for colour in look.colours or (own,))
        surface = Surface(self._texture(look), look.division, look.flags, look.opacity)
        if surface not in self.surfaces:
            self.surfaces[surface] = len(self.made.surfaces)
            self.made.surfaces.append(surface)
        return Mapped(self.surfaces[surface], tuple(corners[i] for i in look.corners), look.texels,
                      tuple(map(self._normal, look.normals)) if look.normals else (0, 0, 0))

    def _normal(self, normal):
        """The number of a corner's normal."""
        if normal not in self.normals:
            self.normals[normal] = len(self.made.normals)
            self.made.normals.append(normal)
        return self.normals[normal]

    def result(self, colours, sixteenths, ramp, in_beam):
        """The surfaces; None if no face has one. colours: of the palette; sixteenths: what a blended colour shows of
        itself; ramp: the levels of light, none if there is no light; in_beam: what each entry of the palette is in a
        beam. What light and beams make of a blended colour is blended too."""
        blended = {self.indices[colour] for colour, _ in self.blended}
        blended |= {level[self.indices[colour]] for colour, is_lit in self.blended if is_lit for level in ramp}
        blended |= {in_beam[number] for number in blended}
        if blended:
            first, end = min(blended), max(blended) + 1
            self.made.blend_first = first
            self.made.blend = blend_table(colours, sixteenths, range(first, end))
        self.made.surfaces = [replace(one, sixteenths=sixteenths) if one.flags & image_surface.BLENDED else one
                              for one in self.made.surfaces]
        return self.made if self.made.surfaces else None
