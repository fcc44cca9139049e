# SPDX-License-Identifier: MIT
"""Reading glTF 2.0, as .gltf and .glb: triangles of all nodes of the scene, base colours, base textures, texture
coordinates, colours of vertices.

The project has a reader of its own. Readers for all formats trust their files: they allocate what a header promises,
leave out what they do not understand, and name neither node nor accessor. host_tests/tools/test_gltf.py compares this
one with trimesh."""

import math

import numpy as np

from fixel.model import gltf_check, gltf_skins
from fixel.base.errors import ToolError
from fixel.base.notes import Usual
from fixel.model.gltf_material import srgb
from fixel.model.gltf_material import Materials
from fixel.model.gltf_nodes import Nodes
from fixel.model.mesh import FILE_FACES_MAX, Mesh
from fixel.model.sources import Sources
from fixel.model.stl import COORDINATE_LIMIT, exact
from fixel.model.surface import MEAN_NOTE, Surfaces, TINT_NOTE, WHITE

_CONVENTION = ("right-handed and counter-clockwise, as glTF is: z was negated and every outline reversed")
# Of a place, a coordinate or a colour: the whole ones normalised, or as they are (KHR_mesh_quantization).
_PARTS = (gltf_check.FLOAT, 5120, 5121, 5122, 5123)
_TRIANGLES, _STRIP, _FAN = 4, 5, 6
_MODES = range(7)
READ_MAX = 8 << 20          # vertices and indices of the parts of all nodes: nodes may share a mesh
PARTS_MAX = 65_535          # of all nodes, which may share them


# --- nodes ------------------------------------------------------------------------

def _rotation(values, where, checked):
    """The matrix of a quaternion x, y, z, w."""
    length = math.sqrt(sum(each * each for each in values))
    if not 0.5 < length < 2:
        checked.fail(where, "rotation is not of unit length: the file is damaged")
    x, y, z, w = (each / length for each in values)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def _matrix(checked, node, where):
    """A node's matrix of 4x4, from itself to its parent."""
    if "matrix" in node:
        matrix = np.array(gltf_check.numbers(checked, node, "matrix", 16, where)).reshape(4, 4).T
        if (matrix[3] != (0, 0, 0, 1)).any():
            checked.fail(where, "the last row of matrix is not 0, 0, 0, 1: the file is damaged")
        return matrix
    matrix = np.eye(4)
    if "rotation" in node:
        matrix[:3, :3] = _rotation(gltf_check.numbers(checked, node, "rotation", 4, where), where, checked)
    if "scale" in node:
        matrix[:3, :3] *= gltf_check.numbers(checked, node, "scale", 3, where)
    if "translation" in node:
        matrix[:3, 3] = gltf_check.numbers(checked, node, "translation", 3, where)
    return matrix


# --- parts ------------------------------------------------------------------------

def _triangles(checked, part, count, where):
    """Numbers of vertices, three a row; None for a part that has no faces."""
    mode = checked.whole(part, "mode", where, _TRIANGLES, max(_MODES))
    if mode < _TRIANGLES:
        return None
    order = checked.accessor(part["indices"], where, ("SCALAR",), gltf_check.UNSIGNED)[:, 0] if "indices" in part \
        else np.arange(count)
    if len(order) and order.max() >= count:
        checked.fail(where, f"indices name vertex {order.max():,} of {count:,}: the file is damaged")
    if mode == _TRIANGLES:
        whole = len(order) // 3 * 3
        if len(order) > whole:
            checked.left_out.add("last corners, which are no triangle", where)
        return order[:whole].reshape(-1, 3)
    if mode == _FAN:
        return np.column_stack([np.repeat(order[:1], max(len(order) - 2, 0)), order[1:-1], order[2:]])
    strip = np.column_stack([order[:-2], order[1:-1], order[2:]])
    strip[1::2, :2] = strip[1::2, 1::-1]    # every second one runs the other way
    return strip


def _positions(checked, part, where):
    number = part["attributes"].get("POSITION")
    if number is None:
        checked.fail(where, "it has no POSITION: the file is damaged")
    points = checked.accessor(number, where, ("VEC3",), _PARTS)
    if "bufferView" not in checked.rows("accessors")[number]:
        gltf_check.refuse_compressed(checked, part, where)
    return points


class _Reader:
    """Collects the faces of all nodes."""

    def __init__(self, checked, progress):
        self.checked, self.progress = checked, progress
        self.materials, self.numbers = Materials(checked), {}
        self.vertices, self.faces, self.places, self.surfaces, self.normals, self.corners = [], [], [], Surfaces(), [], []
        self.left_out = self.parts = self.read = 0  # parts; values of vertices and indices, each time that they are used
        self.joints, self.shared = [], 0    # of each face the node of the joint on which it hangs, or None; faces that hang on others too

    def _add_material(self, material):
        """The number of a material."""
        if id(material) not in self.numbers:
            self.numbers[id(material)] = len(self.surfaces.materials)
            self.surfaces.materials.append(material)
        return self.numbers[id(material)]

    def _of_vertices(self, attributes, key, kinds, count, where):
        """An attribute of the vertices, None if there is none."""
        if key not in attributes:
            return None
        values = self.checked.accessor(attributes[key], where, kinds, _PARTS, is_part=key == "COLOR_0").astype(float)
        if len(values) != count:
            self.checked.fail(where, f"{key} has {len(values):,} values for {count:,} vertices: the file is damaged")
        wrong = np.argwhere(~np.isfinite(values))
        if len(wrong):
            row, column = wrong[0]
            self.checked.fail(where, f"{key} of vertex {row} has the value {values[row, column]:g}; it must be finite")
        return values

    def _coordinates(self, attributes, read, triangles, count, where):
        """(material, coordinates of each vertex on its image or None)."""
        material = read.material
        values = self._of_vertices(attributes, f"TEXCOORD_{read.coordinates}", ("VEC2",), count, where) if material.image else None
        if values is None and material.image and triangles.size:
            self.materials.left_out.add("images on faces without coordinates for them", where)
        if values is None or not triangles.size:
            return material, None
        values, used = np.where(np.abs(values) <= 1e6, values, 0.0), np.unique(triangles)
        material, moved = self.materials.wrapped(read, values[used], where)
        values = values.astype(float)
        values[used] = np.where(np.abs(moved) <= 1e6, moved, 0.0)
        return material, values

    def part(self, part, matrix, where, hung=None):
        """A primitive of a mesh at a node. hung: the gltf_skins.Part of one that hangs on joints, which place it instead of the matrix."""
        checked = self.checked
        self._count_part(where)
        attributes = part.get("attributes")
        if not isinstance(attributes, dict):
            checked.fail(where, "it has no attributes: the file is damaged")
        points = _positions(checked, part, where)
        triangles = _triangles(checked, part, len(points), where)
        self._count_values(len(points) + (0 if triangles is None else triangles.size), where)
        if triangles is None:
            self.left_out += 1
            return
        if len(self.faces) + len(triangles) > FILE_FACES_MAX:
            checked.fail(where, f"the model has more than {FILE_FACES_MAX:,} faces; a scene image has room for fewer, so simplify "
                         "it")
        read = self.materials.get(part, where)
        if not read.material.opacity:
            self.materials.left_out.add("faces of materials that are wholly clear", where)
            return
        material, uvs = self._coordinates(attributes, read, triangles, len(points), where)
        tints = self._of_vertices(attributes, "COLOR_0", ("VEC3", "VEC4"), len(points), where)
        if tints is not None and material.is_clear and (tints[np.unique(triangles), 3:] < 1).any():
            self.materials.left_out.add("alpha of the vertices' colours", where)
        mirrored = np.repeat(np.linalg.det(matrix[:3, :3]) < 0, len(triangles))
        if hung:
            places, alone = hung.owners(triangles)
            self.shared += int((~alone).sum())
            mirrored = hung.mirrors(places)
        self.joints += [hung.nodes[place] for place in places.tolist()] if hung else [None] * len(triangles)
        outlines = np.where(mirrored[:, None], triangles, triangles[:, ::-1])
        self._add(self._placed(points, matrix, where, hung), triangles, outlines, material, uvs, tints, where)
        self._add_normals(attributes, outlines, matrix, len(points), where, hung)

    def _add_normals(self, attributes, outlines, matrix, count, where, hung):
        """The normals of the corners of faces that were added. Those that are no directions are left out."""
        try:
            values = self.checked.accessor(attributes["NORMAL"], where, ("VEC3",), _PARTS).astype(float) \
                if "NORMAL" in attributes and self.checked.count(attributes["NORMAL"], "") == count else np.zeros((0, 3))
        except ToolError:
            values = np.zeros((0, 3))
        if len(values) != count or abs(np.linalg.det(matrix[:3, :3])) < 1e-30:
            self.normals += [None] * len(outlines)
            return
        with np.errstate(all="ignore"):
            # Normals go by the inverse of the matrix, transposed; z is negated.
            turned = (hung.directions(values) if hung else values @ np.linalg.inv(matrix[:3, :3])) * (1, 1, -1)
            lengths = np.linalg.norm(turned, axis=1, keepdims=True)
            turned = np.where(np.isfinite(lengths) & (lengths > 0), turned / lengths, np.nan)
        of_faces = turned[outlines]
        known = np.isfinite(of_faces).all(axis=(1, 2)).tolist()
        self.normals += [list(map(tuple, three)) if good else None for three, good in zip(of_faces.tolist(), known)]

    def box(self, faces):
        """The least and the largest coordinates of some faces."""
        vertices = [self.vertices[corner] for face in faces for corner in self.faces[face]]
        return [tuple(end(axis) for axis in zip(*vertices)) for end in (min, max)]

    def _count_part(self, where):
        self.parts += 1
        if self.parts > PARTS_MAX:
            self.checked.fail(where, f"the nodes have more than the limit of {PARTS_MAX:,} primitives together; join them, or "
                              "use fewer nodes")

    def _count_values(self, values, where):
        self.read += values
        if self.read > READ_MAX:
            self.checked.fail(where, f"the nodes read more than the limit of {READ_MAX:,} vertices and indices together; "
                              "simplify the model, or give each mesh vertices of its own")

    def _placed(self, points, matrix, where, hung):
        """The vertices in the scene."""
        with np.errstate(over="ignore", invalid="ignore"):
            placed = hung.points(points.astype(float)) if hung else points @ matrix[:3, :3].T + matrix[:3, 3]
        wrong = np.argwhere(~(np.abs(placed) <= COORDINATE_LIMIT))
        if len(wrong):
            row, axis = wrong[0]
            self.checked.fail(where, f"{'xyz'[axis]} of vertex {row} is {placed[row, axis]:g}; it must be within "
                              f"{COORDINATE_LIMIT:,}")
        return placed

    def _add(self, points, triangles, outlines, material, uvs, tints, where):
        used, corners = np.unique(outlines, return_inverse=True)
        corners = (corners.reshape(-1, 3) + len(self.vertices)).tolist()
        self.vertices += [(exact(x), exact(y), -exact(z)) for x, y, z in points[used].tolist()]
        number = self._add_material(material)
        if self.progress:
            self.progress(f"{self.checked.name}: {where}")
        around = None if uvs is None else uvs[outlines].tolist()
        if tints is not None:
            self.corners += [None] * (len(self.faces) - len(self.corners))
            self.corners += [[tuple(map(srgb, tints[corner, :3])) for corner in three] for three in outlines.tolist()]
        for face, (three, outline) in enumerate(zip(triangles.tolist(), corners)):
            self.faces.append(outline)
            self.places.append(f"{self.checked.name}: {where}, triangle {face}")
            tint = None if tints is None else tuple(srgb(part) for part in tints[three, :3].mean(axis=0))
            self.surfaces.add(number, around and around[face], None if tint == WHITE else tint)


def _parts(checked, mesh, where):
    parts = mesh.get("primitives")
    if not isinstance(parts, list) or not all(isinstance(part, dict) for part in parts):
        checked.fail(where, "primitives must be a list of objects: the file is damaged")
    return parts


def read(path, name=None, progress=None, sources=None):
    """(mesh, notes). The name stands in messages. sources: those of the scene."""
    name = name or str(path)
    sources = sources or Sources()
    checked = gltf_check.open_file(path, name, sources)
    reader, matrices, known = _Reader(checked, progress), {None: np.eye(4)}, Nodes(checked)
    nodes, order, owns = checked.rows("nodes"), list(gltf_check.walk(checked)), {}
    for number, parent in order:
        owns[number] = _matrix(checked, nodes[number], checked.label("node", number))
        matrices[number] = matrices[parent] @ owns[number]
    for number, parent in order:
        node, where = nodes[number], checked.label("node", number)
        faces, vertices, is_skinned = len(reader.faces), len(reader.vertices), "mesh" in node and "skin" in node
        if "mesh" in node:
            chosen, mesh = checked.entry("meshes", node, "mesh", where)
            parts = _parts(checked, mesh, checked.label("mesh", chosen))
            # The joints place what hangs on them. What is damaged stays where its vertices are.
            matrix, hung = (np.eye(4), gltf_skins.read(checked, node, parts, matrices, where)) if is_skinned else (matrices[number], None)
            for i, part in enumerate(parts):
                reader.part(part, matrix, f"{where}: {checked.label('mesh', chosen)}, primitive {i}", hung and hung[i])
        known.add(number, parent, owns[number], matrices[number], (faces, len(reader.faces)), reader.vertices[vertices:])
        if is_skinned:
            known.bind(number, reader.joints[faces:] if hung is not None else None)
    known.hang(reader.box)
    known.shared = reader.shared
    if not reader.faces:
        left_out = reader.materials.left_out.notes(name, "left out:")
        why = f"it has {reader.left_out:,} primitives of points and lines, which have none" if reader.left_out else \
            "no node of the scene has a mesh of triangles"
        raise ToolError(left_out[0] if left_out else f"{name}: there is no face in this file: {why}")
    notes = [Usual(f"{name}: {_CONVENTION}")]
    reader.surfaces.give_corners(reader.corners + [None] * (len(reader.faces) - len(reader.corners)))
    if reader.surfaces.have_corners():
        notes.append(f"{name}: {MEAN_NOTE}")
    if reader.surfaces.have_tinted_images():
        notes.append(f"{name}: {TINT_NOTE}")
    if reader.left_out:
        notes.append(f"{name}: left out points and lines: {reader.left_out:,} primitives")
    left_out, more = gltf_check.notes(checked)
    left_out |= known.skins_note()
    notes += checked.notes + checked.left_out.notes(name, "left out:") + reader.materials.left_out.notes(name, "left out of materials:") + [*left_out.values()] + more
    return Mesh(reader.vertices, reader.faces, reader.places, reader.surfaces, groups=known.groups(),
                normals=reader.normals if any(reader.normals) else [], scenery=known.scenery(left_out)), notes
