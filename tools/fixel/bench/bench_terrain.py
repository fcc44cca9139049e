# SPDX-License-Identifier: MIT
"""A terrain of as many faces as wanted, seen from above, so that all of them are in sight: for the bench's growth."""

import dataclasses
import math

from fixel.model import mesh
from fixel.image.image import POSES, SORTED, Face, Model, Object

ONE = 65536                     # 16.16
WIDTH, DEPTH = 16, 12           # units; the eye sees a little more
EYE = (0, 17 * ONE // 2, 0, 0, 3 << 30, 0)      # 8.5 units up, looking down by a quarter turn


def sides(cells):
    """Columns and rows of so many cells, as nearly square as they come."""
    wanted = math.sqrt(cells * WIDTH / DEPTH)
    columns = min((number for number in range(1, cells + 1) if cells % number == 0),
                  key=lambda number: abs(math.log(number / wanted)))
    return columns, cells // columns


def terrain(scene, faces, patch=None):
    """The scene with a terrain of triangles instead of its instances: one model, or a model for each patch of
    patch x patch cells."""
    columns, rows = sides(faces // 2)
    across, along = (patch, patch) if patch else (columns, rows)
    if faces % 2 or columns % across or rows % along:
        raise ValueError(f"{faces} triangles are no terrain of patches of {across} by {along} cells")
    models, objects = [], []
    for row in range(0, rows, along):
        for column in range(0, columns, across):
            objects.append(_add(models, (columns, rows), range(column, column + across + 1), range(row, row + along + 1)))
    return dataclasses.replace(scene, models=models, objects=objects, path_kind=POSES, path=[EYE], start=EYE)


def _add(models, size, columns, rows):
    """Adds the model of these lines of the grid; the instance of it."""
    points = [_point(size, column, row) for row in rows for column in columns]
    low, high = points[0], points[-1]
    centre = ((low[0] + high[0]) // 2, 0, (low[2] + high[2]) // 2)
    vertices = [mesh.minus(point, centre) for point in points]
    width, faces = len(columns), []
    for row in range(len(rows) - 1):
        for column in range(width - 1):
            here = row * width + column
            for corners in ((here, here + width, here + width + 1), (here, here + width + 1, here + 1)):
                normal = mesh.unit_normal(mesh.newell([vertices[corner] for corner in corners]))
                faces.append(Face(normal, corners, 1 + len(faces) % 255))
    models.append(Model(vertices, faces, SORTED))
    return Object(centre, len(models) - 1)


def _point(size, column, row):
    """A corner of the grid: slopes are below a quarter, so that every face is turned to the eye."""
    columns, rows = size
    x, z = column * WIDTH * ONE // columns, row * DEPTH * ONE // rows
    height = (5 * column + 3 * row) % 8 * min(WIDTH * ONE // columns, DEPTH * ONE // rows) // 32
    return x - WIDTH * ONE // 2, height, z - DEPTH * ONE // 2
