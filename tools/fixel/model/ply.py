# SPDX-License-Identifier: MIT
"""Reading PLY. y is upward, as in OBJ, and outlines run counter-clockwise.

The header's counts are checked against the file's size and the limits of the other formats before a table is read
(ply_tables.py); afterwards every number of a table is. So a refusal names the line, the vertex or the face."""

import functools
import os

import numpy as np

from fixel.base.errors import ToolError
from fixel.base.notes import Usual
from fixel.base.reading import quoted, shortened
from fixel.model import model_text, ply_tables
from fixel.model.mesh import FILE_FACES_MAX, Mesh, without_unused
from fixel.model.obj import CORNERS_MAX, NORMAL_MAX, NORMAL_MIN
from fixel.model.sources import Sources, find_named
from fixel.model.stl import COORDINATE_LIMIT, exact
from fixel.model.surface import GREY, MEAN_NOTE, Material, Surfaces, WHITE, mean_tint

FILE_MAX = 64 << 20         # bytes
_UV_MAX = 1e6               # images across
_INDICES = ("vertex_indices", "vertex_index")
_STRIPS = "tristrips"
_COORDINATES = (("texture_u", "texture_v"), ("u", "v"), ("s", "t"), ("texture_s", "texture_t"), ("tx", "ty"))
_CHANNELS = (("red", "green", "blue"), ("diffuse_red", "diffuse_green", "diffuse_blue"), ("r", "g", "b"))
_ALPHA = ("alpha", "a")
_NORMAL = ("nx", "ny", "nz")
_CONVENTION = "right-handed and counter-clockwise, as PLY is: z was negated and every outline reversed"
# What is read of each table.
_READ = {"vertex": {"x", "y", "z", *_NORMAL, *_ALPHA, *(each for names in (*_COORDINATES, *_CHANNELS) for each in names)},
         "face": {*_INDICES, "texcoord", "texnumber", *_ALPHA, *(each for names in _CHANNELS for each in names)},
         _STRIPS: set(_INDICES)}


def _check_counts(header, name):
    """Refuses a file with too many faces or none."""
    faces = header.rows("face")
    if faces > FILE_FACES_MAX:
        raise ToolError(f"{name}: {faces:,} faces are more than the limit of {FILE_FACES_MAX:,}; a scene image has room for "
                        "fewer, so simplify the model")
    if not faces and not header.rows(_STRIPS):
        raise ToolError(f"{name}: the file has no faces: open it in MeshLab, make faces of its points, and save it again")


def _tables(header, name):
    """({element: its table} of a file, notes)."""
    try:
        found, more = ply_tables.tables(header, name) if not header.end else ply_tables.binary_tables(header)
    except ply_tables.Damaged as error:
        raise ToolError(f"{name}: this PLY file cannot be read ({shortened(str(error))}): it is damaged; save it again, or as "
                        "text") from None
    kind = "bytes" if header.end else "words"
    return found, _left_out(header, name) + ([f"{name}: left out what stands behind the end: {more:,} {kind}"] if more else [])


def _left_out(header, name):
    """At most one note about the tables and properties that are not read."""
    left_out = model_text.LeftOut()
    for element in header.elements:
        known = _READ.get(element.name)
        if known is None and element.rows:
            left_out.add(f"element {element.name}", None)
        elif known and element.rows:
            for key in [key for key, *_ in element.properties if key not in known]:
                left_out.add(f"{key} of {element.name}", None)
    return left_out.notes(name, "left out", False)


def _with_strips(tables, name):
    """({element: its table} with triangle strips as faces, notes)."""
    strips = tables.pop(_STRIPS, {})
    lists = next((strips[key] for key in _INDICES if key in strips), None)
    if lists is None:
        return tables, []
    if "face" in tables:
        return tables, [f"{name}: left out triangle strips beside the faces: {len(lists):,}"]
    made = triangles(lists)
    if len(made) > FILE_FACES_MAX:
        raise ToolError(f"{name}: {len(made):,} triangles of strips are more than the limit of {FILE_FACES_MAX:,}; a scene image has "
                        "room for fewer, so simplify the model")
    return {**tables, "face": {_INDICES[0]: made}}, []


def _column(table, key, name):
    """The numbers of a property, one for each row; None where the table has none."""
    if key not in table:
        return None
    found = table[key]
    if not isinstance(found, np.ndarray) or found.ndim != 1:
        raise ToolError(f"{name}: {quoted(key)} is a list in each row, and must be a number")
    return found


def _lists(table, key):
    """The list of each row of a property; None where the table has none."""
    return [np.atleast_1d(each).tolist() for each in table[key]] if key in table else None


def _faces(table, name):
    """(the corners of each face in the order of the file, the table of those faces, notes)."""
    key = next((each for each in _INDICES if each in table), None)
    if key is None:
        raise ToolError(f"{name}: the faces have no {quoted(_INDICES[0])}")
    faces = _lists(table, key)
    kept = [number for number, face in enumerate(faces) if len(face) >= 3]
    if len(kept) == len(faces):
        return faces, table, []
    if not kept:
        raise ToolError(f"{name}: there is no face of three corners in this file")
    return [faces[number] for number in kept], {key: [column[number] for number in kept] if isinstance(column, list) else column[kept]
                                                for key, column in table.items()}, \
        [f"{name}: left out faces of fewer than three corners: {len(faces) - len(kept):,}"]


def _checked(faces, count, name):
    """The faces with whole numbers for corners, of which there are so many vertices."""
    for number, face in enumerate(faces):
        if len(face) > CORNERS_MAX:
            raise ToolError(f"{name}: face {number} has {len(face):,} corners; it must be from 3 to {CORNERS_MAX:,}")
        if not all(0 <= corner < count and corner == int(corner) for corner in face):
            raise ToolError(f"{name}: face {number} has a vertex that does not exist; there are {count:,}")
    return [[int(corner) for corner in face] for face in faces]


def _vertices(table, faces, name):
    """x, y, z of each vertex in units of 1/UNIT, z negated. One that no face has may be no number, as in scans."""
    columns = [_column(table, axis, name) for axis in "xyz"]
    if any(column is None for column in columns):
        raise ToolError(f"{name}: the vertices have no x, y and z")
    points = np.column_stack(columns).astype(float)
    is_used = np.zeros(len(points), dtype=bool)
    is_used[[corner for face in faces for corner in face]] = True
    wrong = np.argwhere(~(np.abs(points) <= COORDINATE_LIMIT) & is_used[:, None])
    if len(wrong):
        vertex, axis = wrong[0]
        raise ToolError(f"{name}: vertex {vertex}: {'xyz'[axis]} is {points[vertex, axis]:g}; it must be within {COORDINATE_LIMIT:,}")
    points[~is_used] = 0
    return [(exact(x), exact(y), -exact(z)) for x, y, z in points.tolist()]


def _colours(table, name):
    """red, green, blue of 0..255 of each row, and whether any is partly transparent; None where the table has none."""
    channels = next((names for names in _CHANNELS if all(each in table for each in names)), None)
    if channels is None:
        return None, False
    columns = [_column(table, channel, name) for channel in channels]
    kind, values = columns[0].dtype, np.nan_to_num(np.column_stack(columns).astype(float))
    alpha = next((_column(table, each, name) for each in _ALPHA if each in table), None)
    most = 65535 if kind.kind in "iu" and kind.itemsize > 1 and values.max() > 255 else \
        1 if kind.kind == "f" and values.max() <= 1 else 255
    values = np.clip(values * (255 / most), 0, 255).round().astype(int)
    return list(map(tuple, values.tolist())), alpha is not None and bool((alpha.astype(float) < most).any())


def _coordinates(tables, faces, name):
    """For each face (u, v) of each corner, v downward; None where the file has none."""
    own = _lists(tables["face"], "texcoord")
    if own is not None:
        found = [list(zip(each[::2], each[1::2])) if len(each) == 2 * len(face) else None for each, face in zip(own, faces)]
    else:
        pair = next((names for names in _COORDINATES if all(each in tables["vertex"] for each in names)), None)
        if pair is None:
            return None
        at = list(zip(*[_column(tables["vertex"], each, name).astype(float).tolist() for each in pair]))
        found = [[at[corner] for corner in face] for face in faces]
    return [each and [(u, 1 - v) if abs(u) <= _UV_MAX and abs(v) <= _UV_MAX else (0.0, 0.0) for u, v in each] for each in found]


def _normals(table, faces, name):
    """The normals of each face's corners, in the order of its outline, z negated; None for a face with one that is no direction; []
    where the file has none."""
    columns = [_column(table, axis, name) for axis in _NORMAL]
    if any(column is None for column in columns):
        return []
    rows = np.column_stack(columns).astype(float) * (1, 1, -1)
    largest = np.abs(rows).max(axis=1)
    good = (largest > NORMAL_MIN) & (largest < NORMAL_MAX)      # false for NaN
    found = [tuple(row) if fits else None for row, fits in zip(rows.tolist(), good.tolist())]
    of_faces = [[found[corner] for corner in reversed(face)] for face in faces]
    return [None if None in each else each for each in of_faces] if good.any() else []


def _materials(images, folder, name, sources):
    """The Material of each image that a file names, white without one; and notes."""
    materials, notes = [], []
    for image in images or [None]:
        file, said = find_named(folder, image) if image else (None, "")
        if said:
            notes.append(f"{name}: {said}")
        found = sources.image(functools.partial(sources.image_named, file, image, name), notes) if image else None
        materials.append(Material(image or "none", WHITE, image=found))
    return materials, notes


def _tints(of_vertices, of_faces, faces):
    """What each face is multiplied by; None for white."""
    found = of_faces or [mean_tint([of_vertices[corner] for corner in face]) for face in faces]
    return [None if tint == WHITE else tint for tint in found]


def _numbers_of_images(table, faces, images, name):
    """The number of the image of each face."""
    numbers = _column(table, "texnumber", name)
    return [0] * len(faces) if numbers is None else [int(each) if 0 <= each < len(images) else 0 for each in numbers.tolist()]


def _surfaces(tables, faces, uvs, images, where):
    """(the surface.Surfaces of a file, None where it has neither colours nor an image; notes). where: (folder, name,
    sources)."""
    folder, name, sources = where
    of_vertices, is_clear = _colours(tables["vertex"], name)
    of_faces, more = _colours(tables["face"], name)
    materials, notes = _materials(images if uvs else [], folder, name, sources)
    is_coloured = bool(of_vertices or of_faces)
    if images and not uvs:
        notes.append(f"{name}: left out the image {quoted(images[0])}: neither vertices nor faces have coordinates on it")
    if not is_coloured and not any(material.image for material in materials):
        return None, notes
    if of_vertices:
        notes.append(f"{name}: " + ("left out the colours of the vertices: the faces have colours" if of_faces else MEAN_NOTE))
    if is_clear or more:
        notes.append(f"{name}: left out alpha of the colours: every face is opaque")
    if not is_coloured:     # where an image is missing
        materials = [each if each.image else Material(each.name, GREY) for each in materials]
    tints = _tints(of_vertices, of_faces, faces) if is_coloured else [None] * len(faces)
    made = Surfaces(materials, _numbers_of_images(tables["face"], faces, materials, name), uvs or [None] * len(faces), tints,
                    has_materials=any(material.image for material in materials))
    if of_vertices and not of_faces:    # outlines are turned round once they are read
        made.give_corners([[of_vertices[corner] for corner in reversed(face)] for face in faces])
    return made, notes


def read(path, name=None, progress=None, sources=None):
    """(mesh, notes). The name stands in messages. sources: those of the scene."""
    name, sources = name or str(path), sources or Sources()
    header = ply_tables.read(bytes(sources.read(path, FILE_MAX, "simplify the model")), name)
    _check_counts(header, name)
    if progress:
        progress(f"{name}: {header.rows('face') or header.rows('vertex'):,} " + ("faces" if header.rows("face") else "vertices"))
    found, notes = _tables(header, name)
    found, more = _with_strips(found, name)
    tables = {"vertex": {}, "face": {}, **found}
    faces, tables["face"], few = _faces(tables["face"], name)
    faces = _checked(faces, header.rows("vertex"), name)
    vertices = _vertices(tables["vertex"], faces, name)
    uvs = _coordinates(tables, faces, name)
    uvs = uvs and [each and each[::-1] for each in uvs]
    normals = _normals(tables["vertex"], faces, name)
    surfaces, said = _surfaces(tables, faces, uvs, header.images, (os.path.dirname(path), name, sources))
    vertices, outlines, unused = without_unused(vertices, [face[::-1] for face in faces])
    if unused:
        said.append(f"{name}: left out vertices that no face has: {unused:,}")
    places = [f"{name}: face {number}" for number in range(len(faces))]
    return Mesh(vertices, outlines, places, surfaces, uvs or [], normals=normals), \
        [Usual(f"{name}: {_CONVENTION}"), *notes, *more, *few, *said]


_BREAK = -1         # stands between two strips of a list


def triangles(strips):
    """The triangles of lists of vertices, an array of three columns. Of a strip every second triangle is turned round; one that names a
    vertex twice only goes on to the next."""
    found = [_of_one(np.atleast_1d(np.asarray(strip, dtype=float))) for strip in strips]
    return np.concatenate(found) if found else np.zeros((0, 3))


def _of_one(strip):
    if len(strip) < 3:
        return np.zeros((0, 3))
    places = np.arange(len(strip))
    begun = np.maximum.accumulate(np.where(strip == _BREAK, places + 1, 0))      # of the strip that a vertex belongs to
    three = np.column_stack([strip[:-2], strip[1:-1], strip[2:]])
    is_odd = (places - begun)[:-2] % 2 == 1
    three[is_odd] = three[is_odd][:, [1, 0, 2]]
    a, b, c = three.T
    return three[(three != _BREAK).all(axis=1) & (a != b) & (b != c) & (c != a)]
