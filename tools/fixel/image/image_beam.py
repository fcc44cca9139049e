# SPDX-License-Identifier: MIT
"""The beams of a scene image: their planes from windows, and what the loader asks of them
(docs/extras/beams.md; docs/formats.md, section 1)."""

from dataclasses import dataclass
from math import isqrt

from fixel.base.errors import ToolError
from fixel.base.vectors import cross, dot, minus
from fixel.image.fields import entry
from fixel.image.image_tree import fail

BEAMS_MAX, PLANES_MAX = 4, 8
FACE_VERTICES_MAX = 24
COORDINATE_MAX = 8191 << 16
NORMAL_SQUARE_MAX_ERROR = 1 << 32
POINT, DIRECTION = 0, 1
BEAM = entry("beams")
assert BEAM.size == 176


@dataclass
class Beam:
    kind: int
    source: tuple       # a point in 16.16, or a direction in 2.30
    planes: list        # (normal x, y, z in 2.30, distance in 18.46)

    def pack(self):
        padded = self.planes + [(0, 0, 0, 0)] * (PLANES_MAX - len(self.planes))
        return BEAM.pack(*self.source, self.kind, len(self.planes), 0,
                         *(number for plane in padded for number in plane))


def unpack(fields, number):
    *source, kind, count, reserved = fields[:6]
    planes = [tuple(fields[i:i + 4]) for i in range(6, len(fields), 4)]
    if kind not in (POINT, DIRECTION) or reserved:
        fail("reserved", f"beam {number}: unknown kind or reserved field not zero")
    if not 1 <= count <= PLANES_MAX:
        fail("count", f"beam {number}: {count} planes are outside 1..{PLANES_MAX}")
    if any(any(plane) for plane in planes[count:]):
        fail("reserved", f"beam {number}: a plane that it has not is not zero")
    return Beam(kind, tuple(source), planes[:count])


def _is_unit(vector):
    return abs(sum(c * c for c in vector) - (1 << 60)) <= NORMAL_SQUARE_MAX_ERROR


def fits(beams, face_vertices):
    """Whether every part of a face of so many vertices is one that a clipper may cut."""
    planes = [len(beam.planes) for beam in beams]
    return face_vertices + sum(planes) + sum(planes[1:]) <= FACE_VERTICES_MAX


def check(beams, models):
    for i, beam in enumerate(beams):
        if beam.kind == DIRECTION and not _is_unit(beam.source):
            fail("normal", f"the direction of beam {i} is not of unit length")
        if beam.kind == POINT and any(abs(c) > COORDINATE_MAX for c in beam.source):
            fail("range", f"the light of beam {i} leaves -8191..8191")
        for *normal, distance in beam.planes:
            if not _is_unit(normal):
                fail("normal", f"a plane of beam {i} has no normal of unit length")
            if abs(distance) >= 1 << 61:
                fail("range", f"a plane of beam {i} is too far away")
    for i, model in enumerate(models):
        most = max((len(face.corners) for face in model.faces), default=0)
        if beams and not fits(beams, most):
            fail("capacity", f"model {i} has a face of {most} vertices, too many to be split by "
                  f"beams of {', '.join(str(len(beam.planes)) for beam in beams)} planes")


def unit(vector):
    """An integer vector to unit length in 2.30, each component rounded once."""
    square = dot(vector, vector)

    def component(c):
        twice = isqrt((c * c << 62) // square)
        return (twice + 1 >> 1) * (1 if c >= 0 else -1)
    return tuple(component(c) for c in vector)


def _plane(normal, through, inside, where):
    """Through a corner, turned so that what is inside lies there, exactly."""
    sides = [dot(normal, minus(point, through)) for point in inside]
    if not any(sides) or min(sides) < 0 < max(sides):
        raise ToolError(f"{where}: the window is not convex, or the light lies in the plane of "
                        "the window or of one of its sides")
    if max(sides) <= 0:
        normal = tuple(-c for c in normal)
    rounded = unit(normal)
    return (*rounded, dot(rounded, through))


def through_window(kind, source, window, where):
    """The beam that falls through a window (corners in 16.16) from a point (16.16) or along a
    direction (2.30): a plane for each side, then the window's own."""
    planes = []
    for corner, following in zip(window, window[1:] + window[:1]):
        way = source if kind == DIRECTION else minus(corner, source)
        side = minus(following, corner)
        planes.append(_plane(cross(way, side), corner, window, where))
    normal = cross(minus(window[1], window[0]), minus(window[2], window[0]))
    behind = tuple(a + b for a, b in zip(window[0], source)) if kind == DIRECTION else \
        tuple(2 * a - b for a, b in zip(window[0], source))
    planes.append(_plane(normal, window[0], [behind], where))
    return Beam(kind, tuple(source), planes)
