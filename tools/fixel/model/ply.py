# SPDX-License-Identifier: MIT
"""Reading PLY. y is upward, as in OBJ, and outlines run counter-clockwise.

trimesh reads the tables of a text, ply_binary those of a binary file. Before that, the header's counts are checked against
the file's size and the limits of the other formats; afterwards every number of a table is. So a refusal names the vertex or the face."""

import io
import os
import re
import warnings

import numpy as np

from fixel.base.errors import ToolError
from fixel.base.reading import quoted, shortened
from fixel.model import named_file, ply_binary
from fixel.model.mesh import FILE_FACES_MAX, Mesh, without_unused
from fixel.model.obj import CORNERS_MAX, NORMAL_MAX, NORMAL_MIN
from fixel.model.sources import Sources
from fixel.model.stl import COORDINATE_LIMIT, exact
from fixel.model.surface import GREY, MEAN_NOTE, WHITE, Material, Surfaces, mean_tint

FILE_MAX = 64 << 20         # bytes
HEADER_MAX = 1 << 16        # bytes
IMAGES_MAX = 64             # named by one file
_UV_MAX = 1e6               # images across
_INDICES = ("vertex_indices", "vertex_index")
_COORDINATES = (("texture_u", "texture_v"), ("u", "v"), ("s", "t"))
_ELEMENTS = (b"vertex", b"face")
_CHANNELS = ("red", "green", "blue")
_CONVENTION = "right-handed and counter-clockwise, as PLY is: z was negated and every outline reversed"


def _header(blob, name):
    """({element: how many}, names of images) of a file."""
    end = blob.find(b"end_header", 0, HEADER_MAX)
    if not blob.startswith(b"ply") or end < 0:
        raise ToolError(f"{name}: a PLY file begins with ply and has end_header within {HEADER_MAX:,} bytes: it is damaged, or no "
                        "PLY file")
    text = blob[:end].decode("utf-8", "replace")
    counts = {element: int(count) for element, count in re.findall(r"^element\s+(\S+)\s+([0-9]{1,18})\s*$", text, re.MULTILINE)}
    for element, count in counts.items():
        if count > len(blob):
            raise ToolError(f"{name}: the header promises {count:,} of {quoted(element)}, and the file has {len(blob):,} bytes: it is "
                            "damaged")
    if counts.get("face", 0) > FILE_FACES_MAX:
        raise ToolError(f"{name}: {counts['face']:,} faces are more than the limit of {FILE_FACES_MAX:,}; a scene image has room for "
                        "fewer, so simplify the model")
    if not counts.get("face"):
        what = "triangle strips, which are not read" if counts.get("tristrips") else "no faces"
        raise ToolError(f"{name}: the file has {what}: open it in MeshLab, make faces of its points or strips, and save it again")
    images = [image.strip() for image in re.findall(r"^comment\s+texturefile\s+(.+)$", text, re.MULTILINE | re.IGNORECASE)]
    return counts, images[:IMAGES_MAX]


def _vertices_and_faces(blob):
    """(a text file without elements of other kinds, such as edges, for which trimesh wants other packages; how many rows stand
    behind the last one). A row is a line."""
    head, _, body = blob.partition(b"end_header")
    lines, rows, kept, is_kept = [], [line for line in body.splitlines() if line.strip()], [], True
    at = 0
    for line in head.splitlines():
        words = line.split()
        if words[:1] == [b"element"] and len(words) == 3:
            is_kept, count = words[1] in _ELEMENTS, int(words[2])
            kept += rows[at:at + count] if is_kept else []
            at += count
        if is_kept or words[:1] != [b"property"] and words[:1] != [b"element"]:
            lines.append(line)
    return b"\n".join([*lines, b"end_header", *kept, b""]), max(0, len(rows) - at)


def _tables(blob, name):
    """({element: its table} of a file, notes)."""
    try:
        if ply_binary.is_binary(blob):
            found, more = ply_binary.tables(blob)
            return found, [f"{name}: left out what stands behind the end: {more:,} bytes"] if more else []
        from trimesh.exchange import ply       # half a second, which other formats need not take
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            own, more = _vertices_and_faces(blob)
            made = ply.load_ply(io.BytesIO(own), skip_materials=True, fix_texture=False)
        return {element: each.get("data") for element, each in made["metadata"]["_ply_raw"].items()}, \
            [f"{name}: left out what stands behind the end: {more:,} lines"] if more else []
    except MemoryError:
        raise
    except Exception as error:      # trimesh raises anything for a damaged file
        raise ToolError(f"{name}: this PLY file cannot be read ({shortened(str(error)) or type(error).__name__}): it is damaged; save it "
                        "again, or as text") from None


def _names(table):
    """The properties of a table."""
    return () if table is None else tuple(table) if isinstance(table, dict) else table.dtype.names or ()


def _column(table, key, count, name):
    """The numbers of a property, one for each row; None where the table has none."""
    if key not in _names(table):
        return None
    try:
        found = np.asarray(table[key])
        found = (found.astype(float) if found.dtype == object else found).reshape(-1)
    except (TypeError, ValueError):
        found = ()
    if len(found) != count:
        raise ToolError(f"{name}: the numbers of {quoted(key)} are not there for all {count:,} rows: the file is damaged")
    return found


def _lists(table, key, name):
    """The list of each row of a property; None where the table has none."""
    if key not in _names(table):
        return None
    return [np.atleast_1d(each).tolist() for each in table[key]]


def _vertices(table, count, name):
    """x, y, z of each vertex in units of 1/UNIT, z negated."""
    columns = [_column(table, axis, count, name) for axis in "xyz"]
    if any(column is None for column in columns):
        raise ToolError(f"{name}: the vertices have no x, y and z")
    points = np.column_stack(columns).astype(float)
    wrong = np.argwhere(~(np.abs(points) <= COORDINATE_LIMIT))
    if len(wrong):
        vertex, axis = wrong[0]
        raise ToolError(f"{name}: vertex {vertex}: {'xyz'[axis]} is {points[vertex, axis]:g}; it must be within {COORDINATE_LIMIT:,}")
    return [(exact(x), exact(y), -exact(z)) for x, y, z in points.tolist()]


def _faces(table, counts, name):
    """The corners of each face, in the order of the file."""
    key = next((each for each in _INDICES if each in _names(table)), None)
    faces = _lists(table, key, name) if key else None
    if faces is None or len(faces) != counts["face"]:
        raise ToolError(f"{name}: the faces have no {quoted(_INDICES[0])}")
    for number, face in enumerate(faces):
        if not 3 <= len(face) <= CORNERS_MAX:
            raise ToolError(f"{name}: face {number} has {len(face):,} corners; it must be from 3 to {CORNERS_MAX:,}")
        if not all(0 <= corner < counts["vertex"] for corner in face):
            raise ToolError(f"{name}: face {number} has a vertex that does not exist; there are {counts['vertex']:,}")
    return [[int(corner) for corner in face] for face in faces]


def _colours(table, count, name):
    """red, green, blue of 0..255 of each row, and whether any is partly transparent; None where the table has none."""
    columns = [_column(table, channel, count, name) for channel in _CHANNELS]
    if any(column is None for column in columns):
        return None, False
    kind, values = columns[0].dtype, np.nan_to_num(np.column_stack(columns).astype(float))
    alpha = _column(table, "alpha", count, name)
    most = 65535 if kind.kind in "iu" and kind.itemsize > 1 and values.max() > 255 else \
        1 if kind.kind == "f" and values.max() <= 1 else 255
    values = np.clip(values * (255 / most), 0, 255).round().astype(int)
    return list(map(tuple, values.tolist())), alpha is not None and bool((alpha.astype(float) < most).any())


def _coordinates(tables, faces, counts, name):
    """For each face (u, v) of each corner, v downward; None where the file has none."""
    own = _lists(tables["face"], "texcoord", name)
    if own is not None and len(own) == len(faces):
        found = [list(zip(each[::2], each[1::2])) if len(each) == 2 * len(face) else None for each, face in zip(own, faces)]
    else:
        pair = next((names for names in _COORDINATES if all(each in _names(tables["vertex"]) for each in names)), None)
        if pair is None:
            return None
        at = list(zip(*[_column(tables["vertex"], each, counts["vertex"], name).astype(float).tolist() for each in pair]))
        found = [[at[corner] for corner in face] for face in faces]
    return [each and [(u, 1 - v) if abs(u) <= _UV_MAX and abs(v) <= _UV_MAX else (0.0, 0.0) for u, v in each] for each in found]


def _normals(table, faces, counts, name):
    """The normals of each face's corners, in the order of its outline, z negated; None for a face with one that is no direction; []
    where the file has none."""
    columns = [_column(table, axis, counts["vertex"], name) for axis in ("nx", "ny", "nz")]
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
        file, said = named_file.find(folder, image) if image else (None, "")
        if said:
            notes.append(f"{name}: {said}")
        if image and file is None:
            notes.append(f"{name}: there is no image {quoted(image)}: the faces have their colours alone. The path is taken from the "
                         "model's folder")
        materials.append(Material(image or "none", WHITE, image=file and sources.image_of_file(file, f"{name}: {file}")))
    return materials, notes


def _tints(of_vertices, of_faces, faces):
    """What each face is multiplied by; None for white."""
    found = of_faces or [mean_tint([of_vertices[corner] for corner in face]) for face in faces]
    return [None if tint == WHITE else tint for tint in found]


def _surfaces(tables, faces, uvs, images, counts, where):
    """(the surface.Surfaces of a file, None where it has neither colours nor an image; notes). where: (folder, name,
    sources)."""
    folder, name, sources = where
    of_vertices, is_clear = _colours(tables["vertex"], counts["vertex"], name)
    of_faces, more = _colours(tables["face"], len(faces), name)
    materials, notes = _materials(images if uvs else [], folder, name, sources)
    is_coloured = bool(of_vertices or of_faces)
    if not is_coloured and not any(material.image for material in materials):
        return None, notes
    if of_vertices and not of_faces:
        notes.append(f"{name}: {MEAN_NOTE}")
    if is_clear or more:
        notes.append(f"{name}: left out alpha of the colours: every face is opaque")
    numbers = _column(tables["face"], "texnumber", len(faces), name)
    numbers = [int(each) if 0 <= each < len(materials) else 0 for each in numbers.tolist()] if numbers is not None else [0] * len(faces)
    if not is_coloured:     # where an image is missing
        materials = [each if each.image else Material(each.name, GREY) for each in materials]
    tints = _tints(of_vertices, of_faces, faces) if is_coloured else [None] * len(faces)
    made = Surfaces(materials, numbers, uvs or [None] * len(faces), tints)
    if of_vertices and not of_faces:    # outlines are turned round once they are read
        made.give_corners([[of_vertices[corner] for corner in reversed(face)] for face in faces])
    return made, notes


def read(path, name=None, progress=None, sources=None):
    """(mesh, notes). The name stands in messages. sources: those of the scene."""
    name, sources = name or str(path), sources or Sources()
    blob = bytes(sources.read(path, FILE_MAX, "simplify the model"))
    counts, images = _header(blob, name)
    if progress:
        progress(f"{name}: {counts['face']:,} faces")
    found, more = _tables(blob, name)
    tables = {"vertex": None, "face": None, **found}
    vertices = _vertices(tables["vertex"], counts.get("vertex", 0), name)
    faces = _faces(tables["face"], counts, name)
    uvs = _coordinates(tables, faces, counts, name)
    uvs = uvs and [each and each[::-1] for each in uvs]
    normals = _normals(tables["vertex"], faces, counts, name)
    surfaces, notes = _surfaces(tables, faces, uvs, images, counts, (os.path.dirname(path), name, sources))
    vertices, outlines, unused = without_unused(vertices, [face[::-1] for face in faces])
    if unused:
        notes.append(f"{name}: left out vertices that no face has: {unused:,}")
    places = [f"{name}: face {number}" for number in range(len(faces))]
    return Mesh(vertices, outlines, places, surfaces, uvs or [], normals=normals), [f"{name}: {_CONVENTION}", *more, *notes]
