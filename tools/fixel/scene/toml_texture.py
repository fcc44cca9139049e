# SPDX-License-Identifier: MIT
"""The textures of a scene file, and what its objects make of them."""

from fractions import Fraction
import functools

from fixel.image import image_surface
from fixel.scene import corner_normals, surfaces, texture, texture_size, toml_images
from fixel.base.errors import ToolError
from fixel.base.reading import quoted, shortened
from fixel.scene.surfaces import Look, Paint

BY_PATH = "path"        # a size
DIRECTIONS_MAX = 16     # in which the textured faces of an object look, if the tool's light changes their colours
_LEVEL_COLOURS = 32     # of a texture of 8 bits with levels, where its own are not more


def _size(row, is_sides, expected):
    """The size of a texture's row; None where it is not said."""
    if row["size"] is not None and isinstance(row["size"], tuple) != is_sides:
        raise ToolError(f"{row.at('size')}: expected {expected}, found {quoted(row.data['size'])}")
    return row["size"]


def _file_side(row):
    """The most texels of a side of a file's picture. "path" was made a number (sizes_of_path) or is the most."""
    value = _size(row, False, f'a number, or "{BY_PATH}"')
    return texture.SIDE_MAX if value in (None, BY_PATH) else value


def by_path(data):
    """The names of the textures of a scene file whose size is to be what the path shows."""
    rows = data.get("textures")
    return [row["name"] for row in rows if isinstance(row, dict) and row.get("size") == BY_PATH and "file" in row
            and isinstance(row.get("name"), str)] if isinstance(rows, list) else []


def check_by_path(top, names):
    """Refuses a size by the path for a texture whose texels an object counts."""
    for number, item in enumerate(top["objects"] if names else ()):
        own = item if isinstance(item, dict) else {}
        used = [own["texture"]] if "texture" in own else own.get("textures", [])
        found = next((name for name in names if isinstance(used, list) and name in used), None)
        key = next((key for key in ("texels_per_unit", "texel_offset") if key in own), None)
        if found and key:
            raise ToolError(f"{top.where}: object {number}: {key} counts texels, and the texture {quoted(found)} has a size by the "
                            "path: give its size as a number")


def sizes_of_path(data, scene, names):
    """The scene file with sizes as numbers: what the path shows of the textures of a compiled scene."""
    sides = {}
    for number, needed in texture_size.needed(scene).items():
        name = scene.surfaces.texture_names[number - 1]
        sides[name] = max(sides.get(name, 1), *needed)
    rows = [{**row, "size": sides.get(row["name"], 1)} if isinstance(row, dict) and row.get("name") in names else row
            for row in data["textures"]]
    notes = [f"texture {quoted(name)}: the path shows no more than {sides[name]} texels a side" for name in names if name in sides]
    return {**data, "textures": rows}, notes


def _pattern(row, pictures):
    return pictures.pattern(row, row["pattern"], *(_size(row, True, "[width, height]") or (32, 32)))


def _on_floors(top):
    """The names of the textures that floors of a scene file show."""
    objects = top.data.get("objects")
    rows = [row for row in objects if isinstance(row, dict) and row.get("solid") == "floor"] if isinstance(objects, list) else []
    lists = [row.get("textures", [row.get("texture")]) for row in rows]
    return {name for names in lists if isinstance(names, list) for name in names if isinstance(name, str)}


def _paint(row, pictures, on_floors):
    """(name, Paint) of an entry of textures. on_floors: the names of those that have levels if nothing is said."""
    name, bits = row["name"], row["bits"]
    if row.only_one("file", "pattern") == "file":
        row.refuse(("colours",), "belongs to a pattern; a file has its own")
        picture = pictures.file(row, toml_images.most_colours(row, "most_colours", texture.COLOURS_MAX), side=_file_side(row))
    else:
        row.refuse(("most_colours",), "belongs to a file; a pattern has its own colours")
        picture = _pattern(row, pictures)
    levels = row.get("levels", image_surface.LEVELS_MAX if name in on_floors else 1)
    if levels > 1:
        most = {4: 16 - picture.has_clear, 8: max(len(picture.colours), _LEVEL_COLOURS), 16: texture.EVERY_COLOUR}[bits]
        picture = pictures.levels(picture, levels, most, 2 if bits == 4 else 1)
    if bits == 4 and (len(picture.colours) + picture.has_clear > 16 or picture.width < 2):
        raise ToolError(f"{row.where}: {len(picture.colours)} colours and a width of {picture.width}; a texture of 4 bits has "
                        "at most 16 colours, one of which is what is not drawn, and is at least 2 wide")
    clamp = row["wrap"] == "clamp"
    return name, Paint(picture, bits, clamp, name, name if row["size"] == BY_PATH else "")


def read(top, pictures):
    """The textures of a scene by name. pictures: the scene's texture.Pictures."""
    on_floors = _on_floors(top)
    return top.named("textures", "texture", lambda row: _paint(row, pictures, on_floors))


class ManyDirections(Exception):
    """The textured faces of an object look in more directions than the tool bakes light for."""


class _Key(tuple):
    """A tuple, perhaps a long one, whose hash is computed once."""

    def __new__(cls, *values):
        return super().__new__(cls, values)

    def __hash__(self):
        if not hasattr(self, "hash"):
            self.hash = super().__hash__()
        return self.hash


class Wish:
    """What an object says of its surfaces. paints: for each face of the mesh in turn; None: its colour alone.
    light: the scene's; baked: whether the tool computes it. opacities: as paints. images: a toml_images.Images or None.
    mesh_of: answers the object's mesh. known_images: those made before. at_once: whether the scene's target lets small
    triangles be functions of the screen (SPEC.md, section 9.1.1)."""

    def __init__(self, table, known, baked, mesh_of, known_images, at_once):
        if "texture" in table and "textures" in table:
            raise ToolError(f"{table.where}: both texture and textures are given; keep one")
        names = (table["texture"],) if "texture" in table else table.rows("textures")
        self.images = images = toml_images.read(table, mesh_of, known_images)
        self.paints = images.paints if images else tuple(self._known(name, table, known) for name in names) or (None,)
        self.division = surfaces.DIVISIONS[table["division"]] if "division" in table else 0     # where nothing is said
        self.opacities = images.opacities if images else (table["opacity"],)
        self.mixes = {False: 0, True: image_surface.BLENDED, "add": image_surface.ADDED}[table["blend"]]
        self.smooth, self.crease = self._smoothness(table)
        self.at_once = at_once and not self.mixes and self.division in (image_surface.DIVIDE_16, image_surface.AFFINE)
        self.by_normals = table["smooth"] == "file"
        self.lit = table.get("lit", not baked and table["shade"] and
                             (self.smooth or self.paints != (None,) or table["vertex_colours"] is True))
        self._check_light(table, baked)
        self.per_unit, self.tiles = self._scale(table)
        self.own = {}
        self.corner_colours = self._corner_colours(table, mesh_of)
        self.by_file = images is not None or self._goes_by_file(table)
        self.offset = table["texel_offset"]
        if self.paints == (None,):
            table.refuse(("mapping", "texels_per_unit", "tiles", "texel_offset", *(() if self.corner_colours else ("division",))),
                         "means nothing without a texture")

    def _check_light(self, table, baked):
        if baked and (self.lit or self.smooth):
            raise ToolError(f"{table.at('lit' if self.lit else 'smooth')}: the tool computes this scene's light; give "
                            "[light] levels for light at run time")
        if self.smooth and not self.lit:
            raise ToolError(f"{table.at('smooth')}: means nothing for what is not lit")
        if not table["shade"] and self.lit:
            raise ToolError(f"{table.at('lit')}: shade = false says that light changes no colour")

    @staticmethod
    def _corner_colours(table, mesh_of):
        """The surface.Surfaces whose faces have colours at their corners; None unless the object asks for them."""
        if table["vertex_colours"] == "none" and "solid" in table:
            raise ToolError(f'{table.at("vertex_colours")}: "none" means nothing for a solid, which has none')
        if table["vertex_colours"] is not True:
            return None
        for key in ("solid", "colour", "colours", "colour_index", "texture", "textures"):
            if key in table:
                raise ToolError(f"{table.at('vertex_colours')}: the colours are those of the model's file; leave {key} out")
        surfaces = mesh_of().surfaces
        if not surfaces or not surfaces.corners:
            raise ToolError(f"{table.at('vertex_colours')}: the model has no face whose corners have colours of their own")
        return surfaces

    @staticmethod
    def _smoothness(table):
        """(whether the object is smooth, the degrees of corner_normals.smooth_normals)."""
        value = table["smooth"]
        if value == "file":
            if "solid" in table:
                raise ToolError(f'{table.at("smooth")}: "file" means nothing for a solid')
            return True, corner_normals.BY_SHAPE
        return (value, corner_normals.ALL) if isinstance(value, bool) else (True, value)

    @staticmethod
    def _known(name, table, known):
        if name == "":
            return None
        if name not in known:
            there = shortened(", ".join(sorted(known))) or "none"
            raise ToolError(f"{table.where}: there is no texture {quoted(name)}; the scene's textures: {there}")
        return known[name]

    @staticmethod
    def _goes_by_file(table):
        """Whether the texture coordinates are those of the model's file."""
        by_file = table["mapping"] == "file"
        if by_file:
            table.refuse(("texels_per_unit", "tiles"), 'belongs to mapping = "box"; a file has its own coordinates')
        return by_file

    @staticmethod
    def _scale(table):
        if "texels_per_unit" in table and "tiles" in table:
            raise ToolError(f"{table.where}: both texels_per_unit and tiles are given; keep one")
        return (table["texels_per_unit"], None) if "texels_per_unit" in table else (None, table["tiles"])

    @functools.cached_property
    def key(self):
        """Equal for wishes that give a shape the same surfaces."""
        return _Key(self.images or (self.paints, self.opacities), self.division, self.per_unit, self.tiles, self.offset,
                    self.mixes, self.lit, self.smooth, self.crease, self.by_normals, self.by_file, id(self.corner_colours))

    def wanted(self):
        """Whether any face has a surface."""
        return self._has_plain_look() or self.paints != (None,)

    def _has_plain_look(self):
        """Whether a face without a texture has a surface."""
        is_opaque = self.images.is_opaque if self.images else self.opacities == (image_surface.OPAQUE,)
        return not is_opaque or bool(self.mixes) or self.lit or self.corner_colours is not None

    def colours_at(self, source):
        """The colours at the corners of a face of the mesh; None where it has one colour, or an image."""
        return None if self.corner_colours is None or self.paint_of(source) else self.corner_colours.colours_at(source)

    def _flags(self):
        return (image_surface.LIT if self.lit else 0) | self.mixes

    def paint_of(self, source):
        """Of a face of the mesh."""
        return self.paints[source % len(self.paints)]

    def cuts(self, source):
        """Whether a face of the mesh becomes triangles if its light is not linear: among edges that show, and where small
        triangles with its texture are functions of the screen."""
        paint = self.paint_of(source)
        return self.crease != corner_normals.ALL or (
            self.at_once and paint is not None and not paint.clamp and paint.bits != 4 and not paint.picture.has_clear and
            self.opacities[source % len(self.opacities)] == image_surface.OPAQUE)

    def coordinates(self, mesh, scale, inside):
        """For each face of a mesh the coordinates of its corners in texels; of one with colours at its corners these, as parts
        of 256."""
        found = self._coordinates(mesh, scale, inside)
        if self.corner_colours is None:
            return found
        return [[tuple(Fraction(part, 256) for part in colour) for colour in own] if own else each
                for own, each in zip(map(self.colours_at, range(len(mesh.faces))), found)]

    def _coordinates(self, mesh, scale, inside):
        if self.by_file:
            return self._of_file(mesh)
        found = surfaces.box_coordinates(mesh, scale, inside, self.per_unit or Fraction(1), self.offset)
        if self.tiles is None:
            return found
        result = []
        for number, face in enumerate(found):
            paint = self.paint_of(number)
            size = (paint.picture.width, paint.picture.height) if paint else (1, 1)
            fitted, = surfaces.tiled([face], [side * tiles for side, tiles in zip(size, self.tiles)])
            result.append([tuple(c + o for c, o in zip(corner, self.offset)) for corner in fitted])
        return result

    def _of_file(self, mesh):
        """Those of the model's file, which are 1 across a texture."""
        found = self.images.uvs if self.images else mesh.uvs or (mesh.surfaces.uvs if mesh.surfaces else [])
        result = []
        for number, corners in enumerate(mesh.faces):
            paint = self.paint_of(number)
            size = (paint.picture.width, paint.picture.height) if paint else (0, 0)
            known = found[number] if number < len(found) else None
            if known is None and paint:
                raise ToolError(f"{mesh.places[number] if mesh.places else 'the model'}: this face has no texture "
                                "coordinates (vt); say mapping = \"box\", or give it some")
            result.append([tuple(Fraction(c) * side + o for c, side, o in zip(uv, size, self.offset)) for uv in known]
                          if known else [(Fraction(0),) * 2] * len(corners))
        return result

    def normals(self, made):
        """For each face of a shape the normals of its corners."""
        if made.normals and None not in made.normals:
            return made.normals
        found = corner_normals.smooth_normals(made, self.crease) if self.smooth else [[face.normal] * len(face.corners) for face in made.faces]
        return [given or own for given, own in zip(made.normals, found)] if made.normals else found

    def looks(self, made, coordinates, bake, where, bakes_all=False):
        """The look of each face of a shape; bake: what becomes of a colour on a face with this normal. bakes_all: in
        DIRECTIONS_MAX levels where faces look in more directions."""
        lit = self.normals(made)
        painted = {(paint, face.normal) for face, paint in zip(made.faces, map(self.paint_of, made.sources)) if paint}
        directions, stands_for = {normal for _, normal in painted}, {}
        if bake is not keep and not self.lit and len(directions) > DIRECTIONS_MAX:
            if not bakes_all:
                raise ManyDirections(where)
            stands_for = _levels_of(directions, bake)

        @functools.lru_cache(None)      # one object for all faces that are lit the same
        def of_direction(paint, normal):
            return tuple(bake(colour, normal) for colour in paint.picture.colours)

        def baked(paint, normal):
            return of_direction(paint, stands_for.get(normal, normal))
        return tuple(self._colours_look(made, number, coordinates[number], lit[number], keep if self.lit else bake)
                     if self.colours_at(made.sources[number]) else
                     self._look(made, number, coordinates[number], lit[number], bake is not keep and baked, where)
                     for number in range(len(made.faces)))

    def _colours_look(self, made, number, coordinates, normals, bake):
        """The look of a face with colours at its corners. coordinates: these, as parts of 256."""
        face = made.faces[number]
        opacity = self.opacities[made.sources[number] % len(self.opacities)]
        corners, _ = surfaces.place([made.vertices[c] for c in face.corners], coordinates, _NO_PAINT, "")
        colours = [bake(tuple(min(max(round(256 * part), 0), 255) for part in coordinates[i]), face.normal) for i in corners]
        return Look(None, (), self.division, self._flags() | image_surface.COLOURS, opacity, corners,
                    tuple((red << 16 | green << 8 | blue, 0) for red, green, blue in (colour[:3] for colour in colours)),
                    tuple(normals[i] for i in corners) if self.lit else ())

    def _look(self, made, number, coordinates, normals, baked, where):
        face, paint = made.faces[number], self.paint_of(made.sources[number])
        opacity = self.opacities[made.sources[number] % len(self.opacities)]
        points = [made.vertices[c] for c in face.corners]
        if paint is None and self._is_flat(face, normals, opacity):
            return None
        corners, texels = surfaces.place(points, coordinates, paint or _NO_PAINT, where, self.division)
        own = tuple(normals[i] for i in corners) if self.lit else ()
        if paint is None:
            return Look(None, (), 0, self._flags(), opacity, corners, ((0, 0),) * 3, own)
        # Light at run time marks colours, whatever way the face looks.
        colours = baked(paint, None if self.lit else face.normal) if baked else self._own_of(paint)
        # What is one texel all over the face needs no division, which rounds.
        division = image_surface.AFFINE if len(set(texels)) == 1 else self.division
        return Look(paint, colours, division, self._flags(), opacity, corners, texels, own)

    def _is_flat(self, face, normals, opacity):
        """Whether a face without a texture looks like one without a surface: it is opaque, and not lit, or, among edges that
        show, its light is that of its own normal."""
        if self.mixes or opacity != image_surface.OPAQUE:
            return False
        return not self.lit or (self.crease != corner_normals.ALL and all(normal == face.normal for normal in normals))

    def _own_of(self, paint):
        """The colours of a paint; the same object for the same paint."""
        return self.own.setdefault(paint, tuple(paint.picture.colours))


def _levels_of(normals, bake):
    """{normal: the one whose light stands for its own}: of at most DIRECTIONS_MAX levels of light, evenly spaced, the normal that
    is nearest to the level."""
    light = {normal: sum(bake((255, 255, 255), normal)) for normal in normals}
    low, step = min(light.values()), max(1, max(light.values()) - min(light.values())) / (DIRECTIONS_MAX - 1)
    levels = {normal: round((value - low) / step) for normal, value in light.items()}
    nearest = {}
    for normal in sorted(normals):
        off = abs(light[normal] - low - levels[normal] * step)
        if levels[normal] not in nearest or off < nearest[levels[normal]][0]:
            nearest[levels[normal]] = off, normal
    return {normal: nearest[level][1] for normal, level in levels.items()}


def keep(colour, _normal):
    """What a light that is not there makes of a colour."""
    return colour


_NO_PAINT = Paint(None, 8, True)


def shape_of(wish, mesh, rows, made, scale, inside):
    """(shape, coordinates) with the wish's surfaces."""
    made, coordinates = surfaces.spread(mesh, rows, made, wish.coordinates(mesh, scale, inside))
    if wish.by_normals and mesh.normals:
        made.normals = corner_normals.file_normals(mesh, rows, made)
    if wish.by_normals and mesh.smoothing:
        made.smoothing = [mesh.smoothing[source] for source in made.sources]
    if wish.smooth and any(map(wish.cuts, made.sources)):
        made, coordinates = corner_normals.cut(made, coordinates, wish.normals(made), wish.cuts)
    return made, coordinates


