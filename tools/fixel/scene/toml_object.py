# SPDX-License-Identifier: MIT
"""Objects of a scene file: which mesh, where, how large, how turned, in which
colours. Each becomes one or more instances of a coloured shape."""

from dataclasses import dataclass
from fractions import Fraction
import math

from fixel.image import image
from fixel.model import quantity, solids
from fixel.scene import keys, parts, toml_billboard, toml_images, toml_light, toml_lines, toml_model, toml_motion, toml_texture
from fixel.base.job import Quiet
from fixel.base.errors import ToolError
from fixel.model.convex import is_convex
from fixel.model.mesh import FACES_MAX, transform, two_sided
from fixel.base.reading import quoted
from fixel.scene.toml_table import Table
from fixel.model.quantity import matrix

INSTANCES_MAX = 65535
_PLAIN = (200, 192, 176)    # the colour of what has none
SORTED_NOTE = "not convex, so its faces are sorted far to near"


@dataclass
class Instance:
    """A model put somewhere: colours are still wishes, an int for a palette
    index and a tuple for red, green, blue."""
    shape: object
    colours: tuple
    kind: int
    centre: tuple
    layer: int
    moves: bool
    clusters: bool
    where: str
    name: str = None
    looks: tuple = ()       # a surfaces.Look or None for each face; none if no face has a surface
    board: object = None    # a toml_billboard.Wish
    lines: tuple = ()       # toml_lines.Wish
    life: object = None     # a toml_motion.Life, of what is turned; its centre is then without the rise


def _solid_options(table):
    options = {key: table[key] for key in keys.SOLID if key in table}
    return {key: float(value) if isinstance(value, Fraction) else value for key, value in options.items()}


class Objects:
    """Compiles the objects of one scene. files: a toml_model.Files. notes are told to the user, once each. at_once: see
    toml_texture.Wish."""

    def __init__(self, name, files, light, notes, progress=None, textures=None, billboards=None, at_once=False):
        self.name, self.light, self.at_once = name, light, at_once
        self.notes, self.progress = notes, progress or Quiet()
        self.files, self.shapes, self.coloured, self.surfaces = files, {}, {}, {}
        self.textures, self.looks, self.plain_look = textures or {}, {}, None
        self.billboards, self.boards = billboards or {}, {}
        self.solids, self.shared, self.divided, self.images = {}, {}, {}, {}
        self.simplified = {}            # a simplified.Record of each model
        self.count = self.placed = 0    # objects, and their vertices

    def mesh(self, table):
        """(mesh, name, identity) of an object's solid or file."""
        source = table.only_one("obj", "model", "solid")
        if source == "solid":
            table.refuse(keys.MODEL.keys(), "means nothing for a solid")
            name, options = table["solid"], _solid_options(table)
            identity = (name, *sorted(options.items()))
            if identity not in self.solids:
                self.solids[identity] = solids.make(name, options, table.where)
            return self.solids[identity], table.where, identity
        table.refuse(keys.SOLID, "means nothing for a file")
        self.files[table[source]], name, notes = toml_model.read(table, source, self.files, self.progress)
        self.notes += notes
        if "simplify" in table:
            self.progress.stage(f"simplifying {name}")
            count, whole = table["simplify"], name
            name = self.files.fewer(name, count)
            if name is whole:
                self.notes.append(f"{name}: simplify: it has no more than {count:,} triangles, and stays as it is")
        if table["vertex_colours"] == "none":
            name = self.files.plain(name)
        chosen, by_node = toml_model.groups_of(table), table["anchor"] == "node"
        if chosen is None:
            return self.files[name], name, (name,)
        return self.files.part(name, chosen, by_node), name, (name, chosen.names, chosen.without, by_node)

    def _record(self, table, found):
        """Keeps what there is to say of an object whose model has fewer faces, and of its instances."""
        mesh, name, _ = self.mesh(table)
        if name not in self.files.results or not found:
            return
        scale = toml_model.fit(table, mesh) if "fit" in table else table["scale"]
        record = self.simplified.setdefault(name, toml_model.Simplified(name, self.files.results[name], table["simplify"]))
        record.scale = max(record.scale, float(max(scale)))
        radii = {}
        for each in found:
            made, moved = each.shape
            if (id(made), moved) not in radii:
                radii[id(made), moved] = max(math.dist(vertex, moved) for vertex in made.vertices)
            record.balls.append(None if each.life else (each.centre, radii[id(made), moved]))

    def _pivot(self, table, name, rows):
        """The point about which an object's node turns, in 16.16; None unless the node is its anchor."""
        if table["anchor"] != "node":
            return None
        chosen = toml_model.groups_of(table) if "solid" not in table else None
        pivot = self.files.pivot(name, chosen) if chosen else None
        if pivot is None:
            raise ToolError(f'{table.at("anchor")}: "node" needs a group of an OBJ file, or one that is a node of a glTF file')
        return transform(pivot, rows)[0]

    def _look_of(self, table):
        """What an object says of its surfaces; one that says nothing has the same as all others that do not."""
        says = not keys.SURFACE.keys().isdisjoint(table.data)
        if says or self.plain_look is None:
            look = toml_texture.Wish(table, self.textures, not isinstance(self.light, toml_light.RunTime),
                                     lambda: self.mesh(table)[0], self.images, self.at_once)
            self.plain_look = self.plain_look if says else look
            self.notes += [f"{table.where}: {note}" for note in look.images.notes] if look.images else []
            return look
        return self.plain_look

    @staticmethod
    def _quaternion(table):
        """The object's quaternion, or None: it takes the place of its rotation."""
        quaternion = table["quaternion"]
        if quaternion:
            table.refuse(("rotation",), "quaternion is there, too, and both say how the mesh is turned: leave one of them away")
            if not any(quaternion):
                raise ToolError(f'{table.at("quaternion")}: four zeros are no turn; [1, 0, 0, 0] turns nothing')
        return quaternion

    def _shape(self, table, scale, rotation, look):
        """The shape, whether it is convex, and where its corners are on its textures, computed once for each mesh, size,
        turn and texture."""
        mesh, name, identity = self.mesh(table)
        inside = table["inside"]
        rotation = tuple(a % 360 if a else a for a in rotation)
        sides = self._sides(table, mesh)
        scale = toml_model.fit(table, mesh) if "fit" in table else scale
        quaternion = self._quaternion(table)
        turned = matrix(scale, rotation, quaternion)
        wanted = toml_model.wishes(table, name) if "solid" not in table else (False, False)
        wanted = wanted[0], wanted[1] and not look.wanted()     # a merged face has no texture coordinates
        is_middle = table["anchor"] == "middle"
        key = (identity, scale, rotation, quaternion, inside, sides, wanted, is_middle, look.key)
        if key not in self.shapes:
            self.progress.stage(table.where)
            mesh = toml_model.near_origin(mesh) if is_middle else mesh
            pivot = self._pivot(table, name, turned)
            made = toml_model.make(mesh, turned, name, inside, wanted, self.progress, "solid" not in table)
            self.notes += made.notes
            made.middle = pivot or made.middle
            made = self._of_material(made, mesh, name) if sides == "file" else \
                self._with_sides(made, sides, name, "solid" not in table)
            convex, coordinates = is_convex(made.vertices, made.faces), None
            if look.wanted():
                made, coordinates = toml_texture.shape_of(look, mesh, turned, made, scale, inside)
            self.shapes[key] = (made, convex, coordinates)
        return self.shapes[key]

    def _with_lines(self, table, made, scale, rotation):
        """The shape with the vertices of an object's lines, and these."""
        mesh, _, _ = self.mesh(table)
        scale = toml_model.fit(table, mesh) if "fit" in table else scale
        is_moved = table["anchor"] == "middle" and toml_model.near_origin(mesh) is not mesh
        origin = mesh.middle if is_moved else (0, 0, 0)
        return toml_lines.with_lines(table, made, matrix(scale, rotation), origin)

    @staticmethod
    def _sides(table, mesh):
        """False, True, "open": both sides only where the mesh is open, or "file": as the materials of a glTF file say."""
        value = table["two_sided"]
        if value == "file" and mesh.scenery is None:
            raise ToolError(f'{table.at("two_sided")}: "file" is for a glTF file, whose materials say so (doubleSided)')
        return value

    def _of_material(self, made, mesh, name):
        """The shape, with faces for the backs that the materials say may be seen."""
        wanted, is_open = mesh.surfaces.with_backs(made.open_edges > 0), made.open_edges > 0
        backs = sum(source in wanted for source in made.sources)
        fits = len(made.faces) + backs <= FACES_MAX
        if is_open:
            why = "" if fits else f"; all backs would be more than {FACES_MAX:,} faces"
            self.notes.append(f"{name}: {made.open_edges} edges are not shared by two faces: the model is open; its materials "
                              f"(doubleSided) show {backs if fits else 0:,} of {len(made.faces):,} faces from both sides" + why)
        return two_sided(made, wanted) if backs and fits else made

    def _with_sides(self, made, sides, name, told):
        """The shape, with faces for both sides where they are wanted; told: says that the mesh is open."""
        fits = 2 * len(made.faces) <= FACES_MAX
        if sides is True and not fits:
            raise ToolError(f"{name}: two_sided: twice {len(made.faces):,} faces are more than the limit of "
                            f"{FACES_MAX:,}; give the model fewer faces: simplify = {FACES_MAX // 2}")
        both = sides is True or (sides == "open" and made.open_edges > 0 and fits)
        if made.open_edges and told:
            why = "two_sided = true in a scene file shows both sides" if fits else \
                f"both sides would be more than {FACES_MAX:,} faces"
            self.notes.append(f"{name}: {made.open_edges} edges are not shared by two faces: the model is open, and "
                              "its faces show from " + ("both sides" if both else f"their fronts only ({why})"))
        return two_sided(made) if both else made

    def _kind(self, table, convex):
        """Convex or sorted; checked where it is stated."""
        stated = table["kind"]
        if stated == "convex" and not convex:
            raise ToolError(f"{table.at('kind')}: this model is not convex (some vertices stand "
                            "out in front of some face); leave kind away or say \"sorted\"")
        if not stated and not convex:
            self.notes.append(f"{table.where}: {SORTED_NOTE}")
        return image.CONVEX if convex and stated != "sorted" else image.SORTED

    def _wish(self, table, look):
        """What colours an object's faces wish for, as a key of self.coloured. With textures: their mean colours."""
        if "colour_index" in table:
            return "index", table["colour_index"] - 1, table["colour_next"], table["colour_step"]
        table.refuse(("colour_step", "colour_next"), "needs colour_index")
        if "colours" in table:
            bases = table["colours"]
            if table["solid"] == "island":
                mesh, _, identity = self.mesh(table)
                colours = self._shared((identity, bases), lambda: solids.by_height(mesh, bases))
            else:
                colours = self._shared((bases, look.images), lambda: bases, look)
        elif look.images and "colour" not in table:
            colours = look.images.colours
        elif "colour" not in table and "solid" not in table and self.mesh(table)[0].surfaces:
            mesh, name, identity = self.mesh(table)
            colours = self._shared((identity, None), lambda: self._of_file(mesh.surfaces, name, identity))
        else:
            own = table.get("colour", _PLAIN)
            bases = (own,) if "colour" in table else tuple(p.picture.mean if p else own for p in look.paints)
            colours = self._shared((bases, look.images), lambda: bases, look)
        return "shaded" if table["shade"] else "plain", colours

    def _shared(self, key, make, look=None):
        """The toml_images.Colours of a wish; the same object for the same wish. Under an image a face's own colour is
        hardly ever seen: it takes no shade, so that few entries are its."""
        if key not in self.shared:
            covered = (look.images.covered,) if look and look.images else ()
            self.shared[key] = toml_images.Colours(make(), *covered)
        return self.shared[key]

    def _of_file(self, surfaces, name, identity):
        """The colours of a file's faces; the same object for the same file and group."""
        if identity not in self.surfaces:
            self.surfaces[identity] = tuple(surfaces.colours())
            clear = sum(surfaces.materials[number].opacity < 1 for number in surfaces.of_face)
            if clear:
                self.notes.append(f"{name}: faces that are partly transparent are drawn opaque: {clear:,}")
        return self.surfaces[identity]

    def _colours(self, made, wish, copy, clusters):
        """What colour each face of a shape wishes for; the same object for the same wish."""
        key = id(made), wish, copy if wish[0] == "index" and wish[2] else 0, clusters
        if key in self.coloured:
            return self.coloured[key]
        if wish[0] == "index":
            _, first, then, step = wish
            colours = tuple(1 + (first + copy * then + source * step) % 255 for source in made.sources)
        elif wish[0] == "plain":
            bases = wish[1].bases
            colours = tuple(bases[s % len(bases)] for s in made.sources)
        else:
            bases, covered = wish[1].bases, wish[1].covered
            colours = tuple(bases[s % len(bases)] if covered[s % len(covered)] else
                            self.light.bake(bases[s % len(bases)], face.normal)
                            for s, face in zip(made.sources, made.faces))
        self.coloured[key] = colours
        return colours

    def _looks(self, made, coordinates, look, shaded, where):
        """The looks of a shape's faces; the same object for the same wish."""
        if coordinates is None:
            return ()
        changes = look.lit if isinstance(self.light, toml_light.RunTime) else shaded
        key = id(made), look.key, changes
        if key not in self.looks:
            self.looks[key] = look.looks(made, coordinates, self.light.bake if changes else toml_texture.keep, where,
                                         getattr(self.light, "bakes_all", False))
        return self.looks[key]

    def _count_placed(self, vertices, where):
        self.placed += vertices
        if self.placed > image.PLACED_MAX:
            raise ToolError(f"{where}: the objects have more than the limit of {image.PLACED_MAX:,} vertices together; "
                            "use fewer copies or smaller models")

    def _places(self, table):
        """(position, extra yaw) of every instance, in order."""
        count = toml_motion.count(table)
        room = INSTANCES_MAX - self.count
        if count > room:
            raise ToolError(f"{table.where}: {count:,} copies are more than the limit allows: a scene has at most "
                            f"{INSTANCES_MAX:,} objects, and {INSTANCES_MAX - room:,} stand before these")
        self.count += count
        return toml_motion.places(table)

    def instances(self, data, number):
        """All instances of the object that stands number-th in the file."""
        name = data.get("name") if isinstance(data, dict) else None
        where = f"{self.name}: object {number}" + (f" ({quoted(name)})" if name else "")
        has_billboard = isinstance(data, dict) and "billboard" in data
        table = Table(data, where, keys.SPRITE if has_billboard else keys.OBJECT)
        name = table["name"]
        if has_billboard:
            return self._billboards(table, name)
        if sum(key in table for key in ("colour", "colours", "colour_index")) > 1:
            raise ToolError(f"{where}: colour, colours and colour_index exclude each other")
        if table["solid"] == "none" and not any(key in table for key in ("lines", "points")):
            raise ToolError(f'{where}: solid = "none" has no faces: give it lines or points')
        scale, rotation, anchor = table["scale"], table["rotation"], table["anchor"]
        look = self._look_of(table)
        layer, moves, clusters, wish = table["layer"], table["moves"], table["clusters"], self._wish(table, look)
        places = self._places(table)
        life, turned, division = toml_motion.read(table), toml_motion.ring_is_turned(table), table["parts"]
        if division and (life or turned):
            raise ToolError(f"{table.at('parts')}: what turns or moves is not divided; leave parts away")
        if toml_lines.wanted(table) and (division or clusters):
            raise ToolError(f"{table.where}: edges, lines and points name faces of the model; leave {'parts' if division else 'clusters'} away")
        shaped, coloured, result = {}, {}, []   # by yaw, and where copies differ by number too
        for i, (position, yaw) in enumerate(places):
            baked = 0 if turned else yaw
            place = where + (f", copy {i}" if i else "")
            if baked not in shaped:
                made, convex, coordinates = self._shape(table, scale, (rotation[0] + baked, *rotation[1:]), look)
                moved = made.middle if anchor != "origin" else (0, 0, 0)
                fitting = None if division or life or turned or toml_lines.wanted(table) else parts.fitting(made, place)
                kind, lines = self._kind(table, convex), ()
                if toml_lines.wanted(table):
                    made, lines = self._with_lines(table, made, scale, (rotation[0] + baked, *rotation[1:]))
                shaped[baked] = made, moved, kind, coordinates, _ends(made, moved), fitting, lines
            made, moved, kind, coordinates, ends, fitting, lines = shaped[baked]
            key = baked, i if "colour_next" in table else 0
            if key not in coloured:
                coloured[key] = (self._colours(made, wish, i, clusters),
                                 self._looks(made, coordinates, look, wish[0] == "shaded", place))
            colours, looks = coloured[key]
            self._count_placed(len(made.vertices), place)
            if clusters and kind != image.SORTED:
                raise ToolError(f"{table.at('clusters')}: the faces of a convex model have no clusters; leave clusters "
                                "away or say kind = \"sorted\"")
            rise = made.half_height if anchor == "base" else 0
            if life or turned:
                own = (life or toml_motion.Life()).on_ring(yaw if turned else 0, rise)
                result.append(Instance((made, moved), colours, kind, position, layer, True, clusters, place, name, looks,
                                        lines=lines, life=own))
                continue
            centre = _centre(position, rise, ends, place)
            result.append(Instance((made, moved), colours, kind, centre, layer, moves, clusters, place, name, looks, lines=lines))
            if division or fitting:
                result += self._parts_of(result.pop(), division or fitting, table,
                                         INSTANCES_MAX - self.count + len(places) - len(result))
        self.count += len(result) - len(places)
        if "simplify" in table:
            self._record(table, result)
        return result

    def _parts_of(self, whole, division, table, room):
        """The instances of an object's parts, which are made once for each shape and colouring. room: how many more the
        scene may have."""
        key = id(whole.shape[0]), whole.shape[1], id(whole.colours), id(whole.looks), division
        if key not in self.divided:
            self.divided[key] = parts.split(whole, division, table["kind"] == "sorted")
            if len(whole.colours) > FACES_MAX:
                self.notes.append(f"{whole.where}: a model has at most {FACES_MAX:,} faces and vertices: its {len(whole.colours):,} "
                                  f"faces became {len(self.divided[key])} objects")
        divided = self.divided[key]
        if len(divided) > room:
            raise ToolError(f"{table.at('parts')}: the parts of all copies are more than the limit of {INSTANCES_MAX:,} "
                            "objects of a scene; use fewer parts or copies")
        return [part.placed(whole) for part in divided]

    def _billboards(self, table, name):
        """All instances of an object that shows a billboard. The colour of its face is the picture's mean."""
        wish = toml_billboard.of_object(table, self.billboards)
        layer, moves, life = table["layer"], table["moves"], toml_motion.read(table)
        if toml_motion.ring_is_turned(table):
            raise ToolError(f"{table.at('ring')}: turned means nothing for a billboard, which looks at the eye")
        places = self._places(table)
        if wish not in self.boards:
            self.boards[wish] = toml_billboard.shape_of(wish), (wish.picture.mean,)
        made, colours = self.boards[wish]
        result = []
        for i, (position, _) in enumerate(places):
            place = table.where + (f", copy {i}" if i else "")
            self._count_placed(len(made.vertices), place)
            centre = position if life else _centre(position, 0, _ends(made, (0, 0, 0)), place)
            result.append(Instance((made, (0, 0, 0)), colours, image.CONVEX, centre, layer, bool(life) or moves, False, place,
                                    name, board=wish, life=life.on_ring(0, 0) if life else None))
        return result


def _ends(made, moved):
    """The least and greatest x, y and z of a shape about the point that is placed."""
    return [(min(axis) - c, max(axis) - c) for axis, c in zip(zip(*made.vertices), moved)]


def _centre(position, rise, ends, where):
    """The object's centre in 16.16, with every vertex inside the world."""
    centre = [quantity.q16(value) for value in position]
    for i, value in enumerate(centre):
        if abs(value) > image.COORDINATE_MAX:
            quantity.in_range(position[i], -8191, 8191, f"{where}: position[{i}]", "world units")
    centre[1] += rise
    for name, middle, along in zip("xyz", centre, ends):
        for end in along:
            if abs(middle + end) > image.COORDINATE_MAX:
                quantity.in_range(Fraction(middle + end, 65536), -8191, 8191, f"{where}: a vertex, at {name}",
                                  "world units")
    return tuple(centre)
