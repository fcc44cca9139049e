# SPDX-License-Identifier: MIT
"""What an object of a scene file says of its model file: which file, how large, what is mended and merged."""

from fractions import Fraction
import math
import os

from fixel import merge, model_file
from fixel.errors import ToolError
from fixel.mesh import UNIT, rounding_error, shape
from fixel.reading import quoted

KEYS = {"obj", "model", "fit", "mend", "merge"}
FIT_MAX = 16382


def read(table, key, folder, files, progress):
    """(mesh, name, notes) of an object's file; files: those that were read already, by name."""
    name = table.text(key)
    if key == "obj" and model_file.is_model(name) and model_file.suffix_of(name) != ".obj":
        raise ToolError(f"{table.at('obj')}: {quoted(name)} is no OBJ file; say model = instead of obj =")
    if name in files:
        return files[name], name, []
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        raise ToolError(f"{table.at(key)}: there is no file {quoted(name)}; the path is taken from the scene file's folder")
    reader = model_file.READERS[".obj"] if key == "obj" else model_file.read
    mesh, notes = reader(path, name, progress)
    return mesh, name, notes


def short(value):
    """A positive Fraction with sixteen significant bits: they do, and make the same numbers everywhere."""
    bits = 16 - math.frexp(value)[1]
    return Fraction(round(value * Fraction(2) ** bits)) / Fraction(2) ** bits


def fit(table, mesh):
    """The scale that makes the model's largest extent so many units."""
    wanted = table.number("fit", None, Fraction(1, 1000), FIT_MAX, "world units")
    if "scale" in table:
        raise ToolError(f"{table.where}: both fit and scale are given; keep one")
    extent = max(max(axis) - min(axis) for axis in zip(*mesh.vertices))
    if extent == 0:
        raise ToolError(f"{table.at('fit')}: the model has no extent: all its vertices are one point")
    return (short(wanted * UNIT / extent),) * 3


def wishes(table, name):
    """(mend, merge) of an object with a file."""
    default = model_file.holds_triangles(name)
    return table.switch("mend", default), table.switch("merge", default)


def make(mesh, rows, name, inside, wanted, progress):
    """The shape of a file's mesh (mesh.shape), with a note that says how far rounding moved it. wanted: see wishes."""
    mends, merges = wanted
    made = shape(mesh, rows, name, inside, progress, mends)
    if merges:
        gone = merge.coplanar(made, mesh.surfaces.kind_of if mesh.surfaces else lambda source: 0, progress)
        if gone:
            made.notes.append(f"{name}: {gone:,} faces merged with neighbours in their plane; {len(made.faces):,} are left")
    if mends or merges:
        made.notes.append(f"{name}: {len(mesh.vertices):,} vertices welded to {len(made.vertices):,}; rounded to 16.16, a "
                          f"coordinate is at most {rounding_error(mesh, rows):.2f}/65536 unit off")
    return made
