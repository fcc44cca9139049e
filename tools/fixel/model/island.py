# SPDX-License-Identifier: MIT
"""The solid "island": a height field of triangles that sinks into the sea at its border."""

from fixel.model.mesh import UNIT, Mesh

OCTAVES = 4
COARSEST = 3        # hills across the island, about


def _hash(x, z, seed):
    """A number of 0..1 for a point of a lattice: it looks random, and is the same on every machine."""
    value = (x * 0x9E3779B1 ^ z * 0x85EBCA77 ^ seed * 0xC2B2AE3D) & 0xFFFFFFFF
    value = (value ^ value >> 15) * 0x2C1B3C6D & 0xFFFFFFFF
    value = (value ^ value >> 12) * 0x297A2D39 & 0xFFFFFFFF
    return (value ^ value >> 15) / 0xFFFFFFFF


def _noise(x, z, seed):
    """Smooth between the points of the lattice."""
    i, j = int(x // 1), int(z // 1)
    u, v = x - i, z - j
    u, v = u * u * (3 - 2 * u), v * v * (3 - 2 * v)
    near = _hash(i, j, seed) * (1 - u) + _hash(i + 1, j, seed) * u
    far = _hash(i, j + 1, seed) * (1 - u) + _hash(i + 1, j + 1, seed) * u
    return near * (1 - v) + far * v


def _height(x, z, seed):
    """At a point of the unit square: the sum of octaves, each half as high and twice as fine as the one before. Squared,
    so that peaks are steeper than valleys, and less towards the border."""
    total = sum(_noise(COARSEST * 2 ** n * x, COARSEST * 2 ** n * z, seed + n) / 2 ** n for n in range(OCTAVES))
    inland = max(0.0, 1 - 4 * ((x - 0.5) ** 2 + (z - 0.5) ** 2))
    return total * total * inland * (2 - inland)


def heights(cells, seed, sea):
    """Rows of heights from 0, the sea, to 1. sea: the part of the range of heights that lies in the sea."""
    across, along = cells
    rows = [[_height(i / across, j / along, seed) for i in range(across + 1)] for j in range(along + 1)]
    top = max(map(max, rows))
    return [[max(0.0, (height / top - sea) / (1 - sea)) if top else 0.0 for height in row] for row in rows]


def make(cells=(16, 16), seed=1, sea=0.3):
    """Two triangles a cell, without those that lie in the sea. In the unit cube: the sea at the bottom, the highest point
    at the top."""
    rows, (across, along) = heights(cells, seed, sea), cells
    points = [(i / across - 0.5, rows[j][i] - 0.5, j / along - 0.5) for j in range(along + 1) for i in range(across + 1)]
    faces = []
    for j in range(along):
        for i in range(across):
            a = j * (across + 1) + i
            b, c, d = a + across + 1, a + across + 2, a + 1
            # The diagonal that joins the more equal heights: ridges and shores are straighter.
            if abs(points[a][1] - points[c][1]) <= abs(points[b][1] - points[d][1]):
                faces += [[a, b, c], [a, c, d]]
            else:
                faces += [[a, b, d], [b, c, d]]
    faces = [face for face in faces if any(points[corner][1] > -0.5 for corner in face)]
    return Mesh([tuple(round(round(c, 12) * UNIT) for c in point) for point in points], faces)


def by_height(mesh, colours):
    """A colour for each face: from the first to the last one, for equal ranges of the face's mean height."""
    made = []
    for face in mesh.faces:
        height = sum(mesh.vertices[corner][1] for corner in face) / len(face) / UNIT + 0.5
        made.append(colours[min(int(height * len(colours)), len(colours) - 1)])
    return tuple(made)
