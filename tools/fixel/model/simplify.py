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
from fixel.model import deviation, t_junctions
from fixel.model.mesh import UNIT, Mesh, newell
from fixel.model.surface import WHITE, Surfaces
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
    return Result(_of_wedges(mesh, made, left), whole, deviation.between((exact, before), (exact, after)))


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
