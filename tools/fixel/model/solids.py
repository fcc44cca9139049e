# SPDX-License-Identifier: MIT
"""The built-in solids. Each fits the unit cube about the origin: height and diameter 1, middle (0, 0, 0). Outlines run clockwise as seen from
outside. The solid "island" is a height field of triangles that sinks into the sea at its border."""

import math

from fixel.base.errors import ToolError
from fixel.base.vectors import cross, dot, minus
from fixel.model.mesh import Mesh, UNIT

SIDES_MAX = 64


def _mesh(points, faces):
    # Twelve decimals: what trigonometry leaves behind half a unit goes away.
    vertices = [tuple(round(round(c, 12) * UNIT) for c in point) for point in points]
    return Mesh(vertices, [list(face) for face in faces])


def _ring(sides, radius, y):
    """Corners about the y axis, clockwise from above, a flat side in front.
    Four sides make the unit square; others lie on the circle."""
    radius *= math.sqrt(2) if sides == 4 else 1
    turns = [(i + 0.5) * 2 * math.pi / sides + math.pi for i in range(sides)]
    return [(radius * math.sin(t), y, radius * math.cos(t)) for t in turns]


def _walls(lower, upper, sides):
    """Quads from the ring that begins at lower to the one at upper."""
    return [(lower + i, lower + (i + 1) % sides, upper + (i + 1) % sides, upper + i)
            for i in range(sides)]


def box():
    h = 0.5
    points = [(-h, -h, -h), (h, -h, -h), (h, h, -h), (-h, h, -h),
              (-h, -h, h), (h, -h, h), (h, h, h), (-h, h, h)]
    faces = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 4, 7, 3), (1, 2, 6, 5), (3, 7, 6, 2), (0, 1, 5, 4)]
    return _mesh(points, faces)


def pyramid(sides=4):
    points = _ring(sides, 0.5, -0.5) + [(0, 0.5, 0)]
    faces = [(i, (i + 1) % sides, sides) for i in range(sides)]
    return _mesh(points, faces + [tuple(range(sides))[::-1]])


def prism(sides=6, taper=1.0):
    points = _ring(sides, 0.5, -0.5) + _ring(sides, 0.5 * taper, 0.5)
    caps = [tuple(range(sides, 2 * sides)), tuple(range(sides))[::-1]]
    return _mesh(points, _walls(0, sides, sides) + caps)


def band(sides=16, taper=1.0):
    points = _ring(sides, 0.5, -0.5) + _ring(sides, 0.5 * taper, 0.5)
    return _mesh(points, _walls(0, sides, sides))


def sphere(sides=12, rings=6):
    """Quads between parallels, triangles at the poles."""
    points = []
    for k in range(1, rings):
        latitude = math.pi * k / rings - math.pi / 2
        points += [(0.5 * math.cos(latitude) * math.sin(2 * math.pi * i / sides),
                    0.5 * math.sin(latitude),
                    0.5 * math.cos(latitude) * math.cos(2 * math.pi * i / sides))
                   for i in range(sides)]
    south, north = len(points), len(points) + 1
    points += [(0, -0.5, 0), (0, 0.5, 0)]
    last = (rings - 2) * sides
    faces = [(south, (i + 1) % sides, i) for i in range(sides)]
    for k in range(rings - 2):
        faces += _walls(k * sides, (k + 1) * sides, sides)
    faces += [(last + i, last + (i + 1) % sides, north) for i in range(sides)]
    return _mesh(points, faces)


def _hull(points):
    """The faces of a convex solid, each the points on one supporting plane,
    clockwise as seen from outside."""
    found = {}
    for a in range(len(points)):
        for b in range(len(points)):
            for c in range(len(points)):
                if len({a, b, c}) < 3:
                    continue
                normal = cross(minus(points[b], points[a]), minus(points[c], points[a]))
                sides = [dot(normal, minus(p, points[a])) for p in points]
                if dot(normal, normal) > 1e-9 and max(sides) < 1e-9:
                    on = [i for i, s in enumerate(sides) if s > -1e-9]
                    found.setdefault(tuple(on), normal)
    return [_clockwise(points, on, normal) for on, normal in sorted(found.items())]


def _clockwise(points, on, normal):
    middle = [sum(points[i][k] for i in on) / len(on) for k in range(3)]
    u = minus(points[on[0]], middle)
    v = cross(normal, u)
    length = math.sqrt(dot(normal, normal))
    return sorted(on, key=lambda i: round(math.atan2(
        dot(minus(points[i], middle), v) / length, dot(minus(points[i], middle), u)), 9)
        % (2 * math.pi))


def _regular(points):
    """A regular solid whose circumscribed sphere has diameter 1."""
    radius = math.sqrt(dot(points[0], points[0]))
    points = [[0.5 * c / radius for c in point] for point in points]
    return _mesh(points, _hull(points))


def tetrahedron():
    return _regular([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)])


def octahedron():
    return _regular([(s * (i == 0), s * (i == 1), s * (i == 2)) for i in range(3)
                     for s in (-1, 1)])


def icosahedron():
    g = (1 + math.sqrt(5)) / 2
    return _regular([p for s in (-1, 1) for t in (-g, g)
                     for p in ((0, s, t), (s, t, 0), (t, 0, s))])


def dodecahedron():
    g = (1 + math.sqrt(5)) / 2
    cube = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    return _regular(cube + [p for s in (-1 / g, 1 / g) for t in (-g, g)
                            for p in ((0, s, t), (s, t, 0), (t, 0, s))])


def tile():
    """A unit square in the plane y = 0 that faces up."""
    return floor((1, 1))


def disc(sides=24):
    """A polygon in the plane y = 0 that faces up."""
    return _mesh(_ring(sides, 0.5, 0), [tuple(range(sides))])


def floor(cells=(8, 8)):
    """A unit square of cells that faces up, numbered to and fro, so that two
    colours in turn make a chequered floor."""
    across, along = cells
    points = [(i / across - 0.5, 0, j / along - 0.5) for j in range(along + 1)
              for i in range(across + 1)]
    faces = []
    for j in range(along):
        row = range(across) if j % 2 == 0 else reversed(range(across))
        for i in row:
            a = j * (across + 1) + i
            faces.append((a, a + across + 1, a + across + 2, a + 1))
    return _mesh(points, faces)


def torus(sides=20, rings=10):
    """A ring of so many sides; its tube has so many sides, and a quarter of the width."""
    points = []
    for i in range(sides):
        along = 2 * math.pi * i / sides
        for k in range(rings):
            about = 2 * math.pi * (k + 0.5) / rings
            radius = 0.375 + 0.125 * math.cos(about)
            points.append((radius * math.sin(along), 0.5 * math.sin(about), radius * math.cos(along)))
    faces = [(rings * i + k, rings * ((i + 1) % sides) + k, rings * ((i + 1) % sides) + (k + 1) % rings,
              rings * i + (k + 1) % rings) for i in range(sides) for k in range(rings)]
    return _mesh(points, faces)


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


def island(cells=(16, 16), seed=1, sea=0.3):
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


def cylinder(sides=16):
    return prism(sides)


def cone(sides=12):
    return pyramid(sides)


def none():
    """No face: what lines and points alone are of."""
    return Mesh([], [])


# The solids by name, and what each may be told beside its size.
SOLIDS = {
    "box": (box, ()), "pyramid": (pyramid, ("sides",)), "prism": (prism, ("sides", "taper")),
    "cylinder": (cylinder, ("sides",)), "cone": (cone, ("sides",)),
    "band": (band, ("sides", "taper")), "sphere": (sphere, ("sides", "rings")),
    "tetrahedron": (tetrahedron, ()), "octahedron": (octahedron, ()),
    "icosahedron": (icosahedron, ()), "dodecahedron": (dodecahedron, ()),
    "tile": (tile, ()), "disc": (disc, ("sides",)), "floor": (floor, ("cells",)),
    "torus": (torus, ("sides", "rings")), "island": (island, ("cells", "seed", "sea")), "none": (none, ()),
}


def make(name, options, where):
    """The mesh of a solid; options as parsed numbers."""
    maker, allowed = SOLIDS[name]
    for key in options:
        if key not in allowed:
            takes = f"takes {', '.join(allowed)}" if allowed else "takes no such key"
            raise ToolError(f'{where}: {key} means nothing for a {name}, which {takes}')
    return maker(**options)
