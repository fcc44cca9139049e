# SPDX-License-Identifier: MIT
"""Normals at the corners of faces, for light that is smooth."""

from dataclasses import replace
import math

import numpy as np

from fixel.image.image import Face
from fixel.model import creases
from fixel.model.mesh import FACES_MAX, newell, unit_normal
from fixel.scene import surfaces


def _backs(faces):
    """For each face whether it is the back of one before it."""
    seen = set()
    for face in faces:
        corners = frozenset(face.corners)
        yield corners in seen
        seen.add(corners)


class _Creases:
    """The normals at the vertices of a shape. At a vertex, faces that meet at an edge that does not show have one normal, and so have
    those that meet one of them so."""

    def __init__(self, made, backs, degrees):
        self.faces, self.backs, self.at, self.found = made.faces, backs, {}, {}
        self.areas = [newell([made.vertices[c] for c in face.corners]) for face in made.faces]
        units = [tuple(c / (1 << 30) for c in face.normal) for face in made.faces]
        points = [[c / 65536 for c in vertex] for vertex in made.vertices]
        self.smooth = creases.smooth_pairs(points, [face.corners for face in made.faces], units, backs, degrees, made.smoothing)
        for number, (face, back) in enumerate(zip(made.faces, backs)):
            for i, c in enumerate(face.corners):
                self.at.setdefault((c, back), []).append((number, face.corners[i - 1], face.corners[(i + 1) % len(face.corners)]))

    def _pairs(self, place):
        """Pairs of faces that meet at an edge of a vertex."""
        edges = {}
        for number, before, behind in self.at[place]:
            edges.setdefault(before, []).append(number)
            edges.setdefault(behind, []).append(number)
        for faces in edges.values():
            for i, one in enumerate(faces[:-1] if len(faces) <= creases.PAIRS_MAX else faces[:1]):
                for other in faces[i + 1:]:
                    yield one, other

    def _normals(self, place):
        """{face: its normal at a vertex}."""
        joined = {number: [number] for number, _, _ in self.at[place]}
        for one, other in self._pairs(place):
            if joined[one] is not joined[other] and (one, other) in self.smooth:
                more = joined[other]
                joined[one] += more
                for each in more:
                    joined[each] = joined[one]
        return {number: normal for faces in {id(each): each for each in joined.values()}.values()
                for number, normal in zip(faces, self._mean(faces))}

    def _mean(self, faces):
        """The normals of faces that have one, by area; those of their own where it is none, or all are equal."""
        own = [self.faces[number].normal for number in faces]
        total = tuple(map(sum, zip(*[self.areas[number] for number in faces])))
        return [unit_normal(total)] * len(faces) if any(total) and own.count(own[0]) < len(own) else own

    def of(self, number, corner):
        """The normal of a face at one of its vertices."""
        place = corner, self.backs[number]
        if place not in self.found:
            self.found[place] = self._normals(place)
        return self.found[place][number]


ALL, BY_SHAPE = "all", "by shape"


def smooth_normals(made, degrees=ALL):
    """For each face of a shape the normals of its corners, in 2.30: at each vertex the mean of those of its faces, by
    area. Fronts and backs have means of their own. degrees: an edge that bends more shows; ALL: none does, BY_SHAPE: as
    creases.smooth_pairs decides."""
    if degrees != ALL:
        found = _Creases(made, list(_backs(made.faces)), None if degrees == BY_SHAPE else degrees)
        return [[found.of(number, c) for c in face.corners] for number, face in enumerate(made.faces)]
    totals, backs = {}, list(_backs(made.faces))
    for face, back in zip(made.faces, backs):
        area = newell([made.vertices[c] for c in face.corners])
        for c in face.corners:
            totals[c, back] = tuple(p + q for p, q in zip(totals.get((c, back), (0, 0, 0)), area))
    normals = {key: unit_normal(total) if any(total) else None for key, total in totals.items()}
    return [[normals[c, back] or face.normal for c in face.corners] for face, back in zip(made.faces, backs)]


OWN_COSINE = math.cos(math.radians(1))      # of normals of a file that are a face's own


def file_normals(mesh, rows, made):
    """For each face of a shape the normals of its corners in 2.30 as the file of the mesh has them, on the side to which the face
    looks; None where it has none. A face whose normals are all within a degree of its own has its own. rows: the matrix of
    the shape."""
    turn = np.linalg.inv(np.array([[float(c) for c in row] for row in rows])).T
    given = [normals or [(0.0, 0.0, 0.0)] * len(face) for normals, face in zip(mesh.normals, mesh.faces)]
    return [_turned(found, turn, face.normal) for found, face in zip(surfaces.source_coordinates(mesh, rows, made, given), made.faces)]


def _turned(normals, turn, own):
    """The normals of a face's corners after a turn; None if one of them is none."""
    found = np.array([[float(c) for c in normal] for normal in normals]) @ turn.T
    lengths = np.linalg.norm(found, axis=1)
    if not (lengths > 1e-12).all():
        return None
    found /= lengths[:, None]
    towards = found @ [c / (1 << 30) for c in own]
    if towards.sum() < 0:
        found, towards = -found, -towards
    if (towards > OWN_COSINE).all():
        return [own] * len(normals)
    return [unit_normal([round(c * (1 << 30)) for c in normal]) for normal in found.tolist()]


# --- faces whose light is not linear ---------------------------------------------------------------

SAME_SQUARE = 2e-6 * (1 << 60)      # of the difference of normals that are one
SIDE_SHARE = 256                    # opposite sides of a parallelogram are one, but for a share of the longest


def _are_one(one, other):
    """Whether two normals are one, but for their rounding."""
    return one == other or sum((a - b) ** 2 for a, b in zip(one, other)) < SAME_SQUARE


def _is_linear(points, normals):
    """Whether the light of three corners gives that of every other one, whatever the light is: where all normals are one, and on a
    parallelogram with one normal along each of two sides, as of a cylinder. Light ends at 0 and at 1, so it is not linear where
    normals are."""
    a, b, c, d = normals[:4]
    if len(points) == 4 and (_are_one(a, b) and _are_one(c, d) or _are_one(b, c) and _are_one(a, d)):
        largest = max(abs(one[axis] - other[axis]) for axis in range(3) for one, other in zip(points, points[1:]))
        off = max(abs(p - q + r - s) for p, q, r, s in zip(*points))
        return off * SIDE_SHARE <= largest or _are_one(a, c)
    return all(_are_one(a, each) for each in normals[1:])


def cut(made, coordinates, normals, wanted):
    """(shape, coordinates): faces whose light is not linear, and whose source is wanted, are triangles. normals: of each face's corners,
    which the shape then has; coordinates: likewise, on a texture."""
    faces, sources, more, given = [], [], [], []
    for number, (face, found) in enumerate(zip(made.faces, normals)):
        points = [made.vertices[c] for c in face.corners]
        is_whole = len(points) == 3 or not wanted(made.sources[number]) or _is_linear(points, found)
        for piece in [range(len(points))] if is_whole else surfaces.triangles(points):
            faces.append(face if is_whole else Face(face.normal, tuple(face.corners[i] for i in piece), face.colour))
            sources.append(made.sources[number])
            more.append([coordinates[number][i] for i in piece])
            given.append([found[i] for i in piece])
    if len(faces) > FACES_MAX:
        return replace(made, normals=normals), coordinates
    return replace(made, faces=faces, sources=sources, normals=given), more
