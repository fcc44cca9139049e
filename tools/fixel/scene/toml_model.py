# SPDX-License-Identifier: MIT
"""What an object of a scene file says of its model file: which file, how large, what is mended and merged; and what there is to say of one
that was given fewer faces: how many, and how far the surface moved, in world units and in pixels."""

import copy
import difflib
import itertools
import math
from dataclasses import dataclass, field, replace
from fractions import Fraction

from fixel.base import reading
from fixel.base.errors import ToolError
from fixel.base.notes import Usual
from fixel.base.reading import Beside, QUOTE_MAX, quoted
from fixel.image import image
from fixel.model import merge, model_file, simplify, suffixes, t_junctions
from fixel.model.mesh import Mesh, UNIT, rounding_error, shape
from fixel.model.sources import Sources

NEAR_MAX = 1000     # names of groups among which the nearest is looked for


class Files:
    """The meshes of a scene's model files. A file is one however its name is spelled, so it is read once. Its key is its
    name, or the Beside that stands for it in messages."""

    def __init__(self, folder):
        self.folder, self.sources = folder, Sources()
        self.by_name, self.by_path, self.meshes, self.parts, self.moved = {}, {}, {}, {}, {}
        self.simpler, self.results = {}, {}     # keys of meshes of fewer faces; what made them, a simplify.Result
        self.plain_ones = {}                    # keys of meshes without colours

    def file(self, name):
        """The Beside of a name: the same one for all names of a file that is read in the same way."""
        if name not in self.by_name:
            file = Beside(self.folder, name)
            real = reading.identity(file)
            reader = model_file.READERS.get(suffixes.suffix_of(file), model_file.READERS[".obj"])
            self.by_name[name] = self.by_path.setdefault((real, reader), file)
        return self.by_name[name]

    def _key(self, name):
        return name if isinstance(name, Beside) else self.file(name)

    def __contains__(self, name):
        return self._key(name) in self.meshes

    def __getitem__(self, name):
        return self.meshes[self._key(name)]

    def __setitem__(self, name, mesh):
        self.meshes[self._key(name)] = mesh

    def part(self, name, chosen, by_node=False):
        """The mesh of some groups of a file that was read. chosen: a Groups. by_node: about the origin of the whole file."""
        key = self._key(name), chosen.names, chosen.without, by_node
        if key not in self.parts:
            mesh = self._about_origin(name) if by_node else self[name]
            for group in (*chosen.names, *chosen.without):
                _check_group(mesh, key[0], group, chosen.where)
            self.parts[key] = mesh.part(*chosen.names, without=chosen.without)
            if not self.parts[key].faces:
                raise ToolError(f"{chosen.where}: no face of {key[0]} is left")
        return self.parts[key]

    def pivot(self, name, chosen):
        """The mesh of one point: that about which the first of some nodes of a glTF file turns, None where it has no such node; the
        middle of the faces of groups of another file."""
        mesh = self._about_origin(name)
        if mesh.scenery is None:
            return Mesh([self.part(name, chosen, True).middle], [])
        node = mesh.scenery.nodes.get(chosen.names[0]) if chosen.names else None
        return node and Mesh([node.pivot], [])

    def _about_origin(self, name):
        key = self._key(name)
        if key not in self.moved:
            self.moved[key] = near_origin(self[name])
        return self.moved[key]

    def fewer(self, name, count):
        """The key of the mesh of a file that was read, with at most so many faces; of the file itself where it has no more."""
        file = self._key(name)
        if (file, count) not in self.simpler:
            result = simplify.simplified(self[file], count, file)
            key = copy.copy(file) if result else file
            self.simpler[file, count] = key
            if result:
                self.meshes[key], self.results[key] = result.mesh, result
        return self.simpler[file, count]

    def plain(self, name):
        """The key of the mesh of a file that was read, without the colours of its faces and vertices; of the file itself where it
        has none."""
        file = self._key(name)
        if file not in self.plain_ones:
            surfaces = self[file].surfaces
            key = copy.copy(file) if surfaces and surfaces.has_tints() else file
            self.plain_ones[file] = key
            if key is not file:
                self.meshes[key] = replace(self[file], surfaces=surfaces.without_tints())
                self.results |= {key: self.results[file]} if file in self.results else {}
        return self.plain_ones[file]

    def values(self):
        """The mesh of each file."""
        return self.meshes.values()


@dataclass(frozen=True)
class Groups:
    """Which faces of a file an object has: those of some groups, all where none is named, but for those of others. where: for
    messages."""
    names: tuple
    without: tuple
    where: str


def groups_of(table):
    """The Groups of an object; None where it says nothing of them."""
    if "group" not in table and "without" not in table:
        return None
    return Groups(table["group"], table["without"], table.at("group" if "group" in table else "without"))


def _check_group(mesh, file, group, where):
    if not mesh.groups:
        raise ToolError(f"{where}: {file} has no groups; o and g of an OBJ file name them, and the nodes of a glTF file")
    if group not in mesh.groups and not (mesh.scenery and group in mesh.scenery.nodes):
        names = list(itertools.islice(mesh.groups, NEAR_MAX))
        near = difflib.get_close_matches(group[:QUOTE_MAX], names, 1, 0) or names
        raise ToolError(f"{where}: {file} has no group {quoted(group)}; the nearest name is {quoted(near[0])}")


def read(table, key, files, progress):
    """(mesh, its Beside, notes) of an object's file; files: a Files with those that were read already."""
    name = table[key]
    if key == "obj" and suffixes.is_model(name) and suffixes.suffix_of(name) != ".obj":
        raise ToolError(f"{table.at('obj')}: {quoted(name)} is no OBJ file; say model = instead of obj =")
    file, where = files.file(name), f"{table.at(key)}: {quoted(name)}"
    if key == "model" and not suffixes.is_model(name):
        model_file.refuse_by_all(file, where)
    suffixes.refuse_other(name, where)
    if file in files:
        return files[file], file, []
    if not file.exists():
        raise ToolError(f"{table.at(key)}: there is no file {quoted(name)}; the path is taken from the scene file's folder")
    reader = model_file.READERS[".obj"] if key == "obj" else model_file.reader_of(name)
    progress.stage(f"reading {file}")
    known = len(files.sources.unread)
    mesh, notes = reader(file, None, progress, files.sources)
    mesh.unread = files.sources.unread[known:]
    return mesh, file, notes


def near_origin(mesh):
    """The mesh about its origin, if it is eight times farther from there than it is large: the scale could hardly hold both. For
    what is placed by its middle."""
    low, high = ([end(axis) for axis in zip(*mesh.vertices)] for end in (min, max))
    middle = [(a + b) // 2 for a, b in zip(low, high)]
    if max(map(abs, middle)) <= 8 * max(b - a for a, b in zip(low, high)):
        return mesh
    way = [-m for m in middle]
    return replace(mesh, vertices=[tuple(c + w for c, w in zip(vertex, way)) for vertex in mesh.vertices],
                   scenery=mesh.scenery and mesh.scenery.moved(way, UNIT))


def short(value):
    """A positive Fraction with sixteen significant bits: they do, and make the same numbers everywhere."""
    bits = 16 - math.frexp(value)[1]
    return Fraction(round(value * Fraction(2) ** bits)) / Fraction(2) ** bits


def fit(table, mesh):
    """The scale that makes the model's largest extent so many units."""
    if "scale" in table:
        raise ToolError(f"{table.where}: both fit and scale are given; keep one")
    if mesh.extent == 0:
        raise ToolError(f"{table.at('fit')}: the model has no extent: all its vertices are one point")
    return (short(table["fit"] * UNIT / mesh.extent),) * 3


def wishes(table, name):
    """(mend, merge) of an object with a file."""
    default = suffixes.holds_triangles(name)
    return table.get("mend", default), table.get("merge", default)


def make(mesh, rows, name, inside, wanted, progress, splits=True):
    """The shape of a file's mesh (mesh.shape), with a note that says how far rounding moved it. wanted: see wishes. splits:
    whether edges are split at T-junctions."""
    mends, merges = wanted
    made = shape(mesh, rows, name, inside, progress, mends)
    if splits:
        t_junctions.mend(made, name)
    if merges:
        gone = merge.coplanar(made, mesh.surfaces.kind_of if mesh.surfaces else lambda source: 0, progress)
        if gone:
            made.notes.append(f"{name}: {gone:,} faces merged with neighbours in their plane; {len(made.faces):,} are left")
    if mends or merges:
        made.notes.append(Usual(f"{name}: {len(mesh.vertices):,} vertices welded to {len(made.vertices):,}; rounded to 16.16, a "
                                f"coordinate is at most {rounding_error(mesh, rows):.2f}/65536 unit off"))
    return made


_UNIT = 65536


@dataclass
class Simplified:
    """A model that was simplified. result: a simplify.Result; asked: faces; scale: the most world units a unit of the file;
    balls: (centre, radius) of its instances in 1/65536, None for one that turns or moves."""
    name: str
    result: object
    asked: int
    scale: float = 0.0
    balls: list = field(default_factory=list)


def _nearest(scene, balls):
    """The least distance of a pose from a ball, in world units; None where that is not known."""
    if scene.path_kind != image.POSES or None in balls:
        return None
    least = min(math.dist(pose[:3], centre) - radius for pose in scene.path for centre, radius in balls)
    return max(least, scene.near) / _UNIT


def _short(number):
    """A number with two or three digits that say something."""
    return f"{number:,.0f}" if number >= 100 else f"{number:.3g}"


def simplified_note(scene, record):
    """One sentence; two where the model has more faces than were asked for."""
    result = record.result
    moved, nearest, left = result.deviation * record.scale, _nearest(scene, record.balls), len(result.mesh.faces)
    text = f"{record.name}: simplify: {result.before:,} triangles became {left:,}; the surface moved by at most " \
        f"{_short(moved)} units"
    if nearest is not None:
        focal = scene.width / 2 / math.tan(scene.fov * math.pi / 2 ** 32)
        text += f", {_short(moved * focal / nearest)} pixels at the nearest pose"
    if left > record.asked:
        text += f"; {record.asked:,} cannot be had without losing a group, or moving borders of materials or groups, or seams of texture coordinates"
    return text
