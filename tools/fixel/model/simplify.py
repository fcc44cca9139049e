# SPDX-License-Identifier: MIT
"""Models of fewer faces. Borders of materials and groups, and seams of texture coordinates, stay where they are, no group goes, and no
edge opens: a result in which one does is refused.

meshoptimizer does it, by node. It takes a vertex for each position, material, group and texture coordinate, finds by equal
positions which of them lie on a seam, and collapses both sides of a seam together. Its WebAssembly gives the same bytes on every
machine: the packages of Python are built for one machine each, and their floats differ."""

import pathlib
import shutil
import subprocess
from dataclasses import dataclass, replace

import numpy as np

from fixel.base import children, interpreter
from fixel.base.errors import ToolError
from fixel.model import t_junctions
from fixel.model.mesh import Mesh, UNIT, newell
from fixel.model.surface import Surfaces, WHITE
from fixel.model.triangles import triangulate

FACES_MIN = 4
PROGRAM = pathlib.Path(__file__).with_suffix(".mjs")
_MODULE = pathlib.Path("node_modules", "meshoptimizer", "meshopt_simplifier.js")
_AREA_MIN, _SHAPE = 1e-7, 0.1    # of a face; how far the surface of a group may move, of its extent
_HEAP = 1024                # MiB of node's own memory
_NORMAL, _COORDINATE, _COLOUR = 0.3, 1.0, 0.5   # weights beside a position, whose extent is 1


@dataclass(frozen=True)
class Result:
    """A mesh of fewer faces, and how many the other one had, as triangles. deviation: how far the surface moved at most, in
    units of the file."""
    mesh: Mesh
    before: int
    deviation: float


@dataclass
class _Triangles:
    """A mesh as triangles whose corners are wedges: a position with a material, a group and texture coordinates. corners:
    (count, 3) wedges; places: of each wedge its vertex; keys: (vertex, material, groups, coordinates); tints: of each
    triangle."""
    corners: np.ndarray
    places: np.ndarray
    keys: list
    tints: list


def _cut(mesh):
    """For each triangle of the mesh (its face, which three corners of it)."""
    found = []
    for number, face in enumerate(mesh.faces):
        if len(face) == 3:
            found.append((number, (0, 1, 2)))
            continue
        points = [mesh.vertices[corner] for corner in face]
        triangles, _ = triangulate(list(range(len(face))), points, newell(points))
        found += [(number, three) for three in triangles]
    return found


def _groups_of(mesh):
    """For each face the names of its groups."""
    names = [()] * len(mesh.faces)
    for name, runs in mesh.groups.items():
        for first, end in runs:
            names[first:end] = [(*each, name) for each in names[first:end]]
    return names


def _welded(mesh):
    """(positions of extent 1 about the middle, of each vertex the first one there): floats of 32 bits, as meshoptimizer has
    them."""
    ends = [(min(axis), max(axis)) for axis in zip(*mesh.vertices)]
    twice, extent = [low + high for low, high in ends], max(1, *(high - low for low, high in ends))
    # Whole numbers up to here, so that a mesh that was moved is simplified to the same.
    points = np.array([[2 * c - m for c, m in zip(vertex, twice)] for vertex in mesh.vertices], dtype=float)
    points = (points / (2 * extent)).astype(np.float32)
    _, first, inverse = np.unique(points, axis=0, return_index=True, return_inverse=True)
    return points, first[inverse.reshape(-1)]


def _triangles(mesh, vertex_of):
    surfaces, groups, numbers = mesh.surfaces, _groups_of(mesh), {}
    uvs, corners, tints = (surfaces.uvs if surfaces else mesh.uvs) or [None] * len(mesh.faces), [], []
    for face, three in _cut(mesh):
        material, own, outline = surfaces.of_face[face] if surfaces else 0, uvs[face], mesh.faces[face]
        keys = [(int(vertex_of[outline[i]]), material, groups[face], tuple(map(float, own[i])) if own else None) for i in three]
        if len({key[0] for key in keys}) == 3:
            corners.append([numbers.setdefault(key, len(numbers)) for key in keys])
            tints.append(surfaces.tints[face] if surfaces else None)
    keys = list(numbers)
    return _Triangles(np.array(corners, dtype=np.int64).reshape(-1, 3), np.array([key[0] for key in keys], dtype=np.int64), keys, tints)


def _open_edges(triangles):
    """The edges, by the vertices of their ends, that have not as many triangles one way as the other."""
    ways = np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)])
    ends, count = np.sort(ways, axis=1), np.where(ways[:, 0] < ways[:, 1], 1, -1)
    edges, inverse = np.unique(ends, axis=0, return_inverse=True)
    sums = np.zeros(len(edges), dtype=np.int64)
    np.add.at(sums, inverse.reshape(-1), count)
    return edges[sums != 0]


def has_new_open_edges(before, after):
    """Whether triangles, (count, 3) vertices, have an open edge whose ends were not ends of open edges of those before."""
    old = _open_edges(before)
    return not np.isin(_open_edges(after), old).all()


def _mean_tints(made):
    """Of each wedge the mean of its triangles' colours; white without one."""
    values = np.array([tint or WHITE for tint in made.tints], dtype=float)
    sums, counts = np.zeros((len(made.keys), 3)), np.zeros(len(made.keys))
    for i in range(3):
        np.add.at(sums, made.corners[:, i], values)
        np.add.at(counts, made.corners[:, i], 1)
    return sums / np.maximum(counts, 1)[:, None]


def _normals(points, triangles):
    """Of each vertex the mean normal of its triangles, by area."""
    one, two, three = (points[triangles[:, i]].astype(float) for i in range(3))
    areas, sums = np.cross(two - one, three - one), np.zeros((len(points), 3))
    for i in range(3):
        np.add.at(sums, triangles[:, i], areas)
    return sums / np.maximum(np.sqrt((sums * sums).sum(axis=1)), 1e-30)[:, None]


def _by_meshoptimizer(made, points, count, name, error=1.0):
    """The corners that are left. error: how far the surface may move, of the model's extent; then more are left."""
    coordinates = np.array([key[3] or (0.0, 0.0) for key in made.keys])
    attributes = np.column_stack([_normals(points, made.places[made.corners])[made.places], coordinates, _mean_tints(made) / 255])
    weights = [_NORMAL] * 3 + [_COORDINATE] * 2 + [_COLOUR] * 3
    data = points[made.places].astype("<f4").tobytes() + attributes.astype("<f4").tobytes() + made.corners.astype("<u4").tobytes()
    command = ["node", "--disable-wasm-trap-handler", f"--max-old-space-size={_HEAP}", PROGRAM, _module(name).as_uri(), len(made.keys),
               attributes.shape[1], made.corners.size, 3 * count, error, *weights]
    with children.start(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        out, said = process.communicate(data)
    if process.returncode:
        last = said.decode("utf-8", "replace").strip().splitlines()
        raise ToolError(f"{name}: simplify: node could not make fewer faces ({next((line for line in last if 'rror' in line), 'no reason given')[:200]}): "
                        "it needs node 20.15 or later, and memory (--memory-limit)")
    return np.frombuffer(out, dtype="<u4").astype(np.int64).reshape(-1, 3)


def _without_loss(made, points, left, count, name):
    """The corners that are left, where groups that have lost all faces, or all but some without area, are simplified by themselves, no
    farther than they keep their shape."""
    groups = [made.keys[wedge][2] for wedge in made.corners[:, 0].tolist()]
    one, two, three = (points[made.places[left[:, i]]].astype(float) for i in range(3))
    areas = np.sqrt((np.cross(two - one, three - one) ** 2).sum(axis=1))
    there = {made.keys[wedge][2] for wedge, area in zip(left[:, 0].tolist(), areas.tolist()) if area > _AREA_MIN}
    lost = sorted(set(groups) - there)
    if not lost:
        return left
    found = [left[[made.keys[wedge][2] in there for wedge in left[:, 0].tolist()]]]
    for group in lost:
        numbers = np.array([number for number, each in enumerate(groups) if each == group])
        corners = made.corners[numbers]
        extent = float(np.ptp(points[made.places[corners.reshape(-1)]], axis=0).max())
        own = replace(made, corners=corners, tints=[made.tints[number] for number in numbers.tolist()])
        wanted = max(FACES_MIN, count * len(numbers) // len(made.corners))
        found.append(_by_meshoptimizer(own, points, wanted, name, _SHAPE * extent))
    return np.concatenate(found)


def module():
    """Where meshoptimizer is; None if it is not, or node is not. Of an installed package's user it is in the folder of work."""
    folder = pathlib.Path.cwd() if interpreter.INSTALLED.exists() else interpreter.TOOLS.parent / ".node"
    return folder / _MODULE if (folder / _MODULE).exists() and shutil.which("node") else None


def _module(name):
    found = module()
    if found is None:
        way = "npm install meshoptimizer in this folder" if interpreter.INSTALLED.exists() else "tools/setup.sh simplify"
        raise ToolError(f"{name}: simplify: this needs node with meshoptimizer: {way} sets it up")
    return found


def simplified(mesh, count, name):
    """The Result with at most so many triangles, or as few as the borders and seams let it have; None where the mesh has no
    more than so many."""
    points, vertex_of = _welded(mesh)
    made = _triangles(mesh, vertex_of)
    if len(made.corners) <= count:
        return None
    whole, mesh = len(made.corners), t_junctions.split(mesh, vertex_of)
    made = _triangles(mesh, vertex_of)
    before = made.places[made.corners]
    left = _without_loss(made, points, _by_meshoptimizer(made, points, count, name), count, name)
    after = made.places[left]
    if not len(after):
        raise ToolError(f"{name}: simplify: no face is left; give more than {count:,}")
    if has_new_open_edges(before, after):
        raise ToolError(f"{name}: simplify: edges that are closed would open; give more faces than {count:,}")
    exact = np.array(mesh.vertices, dtype=float) / UNIT
    return Result(_of_wedges(mesh, made, left), whole, between((exact, before), (exact, after)))


def _runs(names):
    """{name: [(first face, behind the last)]} of faces with these names."""
    runs = {}
    for number, each in enumerate(names):
        for name in each:
            own = runs.setdefault(name, [])
            if own and own[-1][1] == number:
                own[-1] = own[-1][0], number + 1
            else:
                own.append((number, number + 1))
    return runs


def _of_wedges(mesh, made, left):
    """The Mesh of the triangles that meshoptimizer has left. Faces stand in the order of their groups and materials."""
    rows = sorted(left.tolist(), key=lambda three: (made.keys[three[0]][2], made.keys[three[0]][1]))
    keys, order, place = [[made.keys[wedge] for wedge in three] for three in rows], {}, "a face of the simplified model"
    faces = [[order.setdefault(key[0], len(order)) for key in three] for three in keys]
    tints = [None] * len(rows)
    if any(tint is not None for tint in made.tints):
        means = np.rint(_mean_tints(made)[np.array(rows)].mean(axis=1)).astype(int)
        tints = [None if tint == WHITE else tint for tint in map(tuple, means.tolist())]
    uvs = [[key[3] for key in three] if all(key[3] is not None for key in three) else None for three in keys]
    surfaces = Surfaces(mesh.surfaces.materials, [three[0][1] for three in keys], uvs, tints) if mesh.surfaces else None
    return replace(mesh, vertices=[mesh.vertices[vertex] for vertex in order], faces=faces, places=[place] * len(faces), surfaces=surfaces, uvs=uvs,
                   groups=_runs([three[0][2] for three in keys]) if mesh.groups else {}, normals=[], smoothing=[])


CELLS_LEAST, CELLS_MOST = 4, 40     # along the longest side
POINTS_MAX = 8192       # of a mesh: of more every second, third and so on is measured
_PAIRS = 1 << 17    # of points and triangles at a time


def _middles(vertices, triangles):
    """Middles of edges and of triangles."""
    one, two, three = (vertices[triangles[:, i]] for i in range(3))
    return np.concatenate([(one + two) / 2, (two + three) / 2, (three + one) / 2, (one + two + three) / 3])


def _some(points):
    return points[::-(-len(points) // POINTS_MAX)]


def between(before, after):
    """The largest distance of two meshes, (vertices, triangles) each."""
    vertices, triangles = before
    return max(largest(_some(vertices[np.unique(triangles)]), *after), largest(_some(_middles(*after)), *before))


def _dot(one, other):
    return np.einsum("...i,...i->...", one, other)


def _to_segment(apart, way):
    """Squared distances of points, of which apart says how far from the start, from segments that go this way."""
    part = np.clip(_dot(apart, way) / np.maximum(_dot(way, way), 1e-300), 0, 1)
    rest = apart - part[..., None] * way
    return _dot(rest, rest)


def _squares(points, a, b, c):
    """Squared distances of points, (n, 1, 3), from triangles with these corners, (1, m, 3)."""
    normal = np.cross(b - a, c - a)
    square = _dot(normal, normal)
    inside, beside = np.broadcast_to(square > 0, (len(points), a.shape[1])), np.inf
    for start, end in ((a, b), (b, c), (c, a)):
        apart, way = points - start, end - start
        inside = inside & (_dot(apart, np.cross(normal, way)) >= 0)     # the inner side of the edge
        beside = np.minimum(beside, _to_segment(apart, way))
    height = _dot(points - a, normal)
    return np.where(inside, height * height / np.maximum(square, 1e-300), beside)


class _Grid:
    """Triangles by the cell of a grid that their middle is in. reach: how far a corner is from its triangle's middle at most."""

    def __init__(self, vertices, triangles, points):
        self.corners = [vertices[triangles[:, i]] for i in range(3)]
        middles = sum(self.corners) / 3
        self.reach = max(float(np.sqrt(_dot(corner - middles, corner - middles).max())) for corner in self.corners)
        self.count = min(max(int(len(triangles) ** 0.5 / 5), CELLS_LEAST), CELLS_MOST)
        self.start = np.minimum(points.min(axis=0), middles.min(axis=0))
        extent = (np.maximum(points.max(axis=0), middles.max(axis=0)) - self.start).max()
        self.side = max(extent / self.count * (1 + 1e-9), 1e-300)
        keys = self._key(self.cells(middles))
        self.order = np.argsort(keys, kind="stable")
        self.keys = keys[self.order]

    def cells(self, points):
        """The cell of each point."""
        return np.minimum(((points - self.start) / self.side).astype(np.int64), self.count - 1)

    def _key(self, cells):
        return (cells[..., 0] * self.count + cells[..., 1]) * self.count + cells[..., 2]

    def around(self, cell, steps):
        """The triangles whose middles are in a cell or at most so many cells from it."""
        low, high = np.maximum(cell - steps, 0), np.minimum(cell + steps, self.count - 1)
        x, y = (each.ravel() for each in np.meshgrid(*(np.arange(low[i], high[i] + 1) for i in range(2)), indexing="ij"))
        first = np.searchsorted(self.keys, self._key(np.stack([x, y, np.full(len(x), low[2])], axis=1)), "left")
        end = np.searchsorted(self.keys, self._key(np.stack([x, y, np.full(len(x), high[2])], axis=1)), "right")
        return self.order[np.concatenate([np.arange(a, b) for a, b in zip(first, end)])]

    def distances(self, points, near):
        """Of each point, the distance from the nearest of some triangles."""
        corners = [corner[near][None] for corner in self.corners]
        step = max(1, _PAIRS // len(near))
        return np.sqrt(np.concatenate([_squares(points[first:first + step, None], *corners).min(axis=1)
                                       for first in range(0, len(points), step)]))


def largest(points, vertices, triangles):
    """The largest distance of the points from the triangles."""
    grid = _Grid(vertices, triangles, points)
    cells, inverse = np.unique(grid.cells(points), axis=0, return_inverse=True)
    order, worst = np.argsort(inverse.reshape(-1), kind="stable"), 0.0
    ends = np.cumsum(np.bincount(inverse.reshape(-1), minlength=len(cells)))
    for cell, own in zip(cells, np.split(order, ends[:-1])):
        steps = 1 + int(grid.reach / grid.side)
        while len(own):
            near = grid.around(cell, steps)
            found = grid.distances(points[own], near) if len(near) else np.full(len(own), np.inf)
            # A triangle that was not looked at has its middle farther away than steps cells.
            is_sure = (found <= steps * grid.side - grid.reach) | (steps >= grid.count)
            worst = max(worst, float(found[is_sure].max(initial=0)))
            own, steps = own[~is_sure], 2 * steps
    return worst
