# SPDX-License-Identifier: MIT
"""What the cuts of a tree left, as faces that the loader takes: with the vertices of their
neighbours, not too many, flat, and in spheres."""

from dataclasses import replace
from math import isqrt

from fixel.base.errors import ToolError
from fixel.image.image import FACE_VERTICES_MAX, PLANARITY_MAX, Face
from fixel.image.image_tree import NONE
from fixel.base.vectors import cross, dot, minus
from fixel.model.mesh import newell, unit_normal


def share(lines, part):
    """Puts the vertices of its lines into a part, and answers how many. From here on nothing cuts it: it has no lines."""
    ring, before = [], len(part.ring)
    for i, vertex in enumerate(part.ring):
        ring += [vertex, *lines.between(part.lines[i], vertex, part.ring[(i + 1) % before])]
    part.ring, part.lines = ring, None
    return len(ring) - before


def halve(lines, part, most=FACE_VERTICES_MAX):
    """Parts of at most so many vertices, by diagonals between their vertices."""
    count = len(part.ring)
    if count <= most:
        return [part]
    best = None
    for i, j, areas in _halves([lines.points[v] for v in part.ring], part.normal):
        if min(areas) > 0 and (best is None or (min(areas), -i, -j) > best[0]):
            best = (min(areas), -i, -j), i, j
    if best is None:
        raise ToolError(f"a face of object {part.group} is too thin for its {count} corners to be divided for a tree: "
                        "give it fewer in the model, or leave it out of the tree's layers")
    _, i, j = best
    pieces = []
    for ring in (part.ring[i:j + 1], part.ring[j:] + part.ring[:i + 1]):
        pieces += halve(lines, replace(part, ring=ring), most)
    return pieces


def _halves(points, normal):
    """Each diagonal of a ring, from vertex i to vertex j, with the areas of both halves: twice, and along the normal."""
    count = len(points)
    # The area of a ring is the sum over its edges of (a x b) . normal, which is b . (normal x a).
    turned = [cross(normal, point) for point in points]
    sums = [0]
    for i in range(count):
        sums.append(sums[i] + dot(points[(i + 1) % count], turned[i]))
    for i in range(count):
        for j in range(i + 2, min(count, i + count - 1)):
            area = sums[j] - sums[i] + dot(points[i], turned[j])
            yield i, j, (area, sums[count] - area)


def flat_face(lines, part):
    """The part as a face that the loader takes: its first vertex, and if need be its normal, is
    chosen so that the others lie near its plane."""
    points = [lines.points[v] for v in part.ring]
    area = newell(points)
    for normal in (part.normal, unit_normal(area) if area != (0, 0, 0) else part.normal):
        along = [dot(normal, point) for point in points]
        middle = (max(along) + min(along)) // 2
        first = min(range(len(points)), key=lambda i: (abs(along[i] - middle), i))
        if all(abs(value - along[first]) <= PLANARITY_MAX << 30 for value in along):
            return Face(normal, tuple(part.ring[first:] + part.ring[:first]), part.colour, part.mapped)
    raise ToolError(f"a face of object {part.group} is too far from flat to be cut for a tree: "
                    "triangulate it in the model")


def _box(points, corners):
    return [(min(axis), max(axis)) for axis in zip(*(points[corner] for corner in corners))]


def add_wholes(faces, wholes, points):
    """To each face that has another box than its whole face the corners of that, since light takes the middle of the box."""
    for face, whole in zip(faces, wholes):
        if _box(points, face.corners) != _box(points, whole):
            face.whole = whole


def add_spheres(nodes, faces, points):
    """To each node a sphere about its faces and the spheres below, from the last up. Its centre is
    that of the box about all faces from the node down."""
    below, boxes = [[] for _ in nodes], [[] for _ in nodes]
    for number in range(len(nodes) - 1, -1, -1):
        node = nodes[number]
        own = [points[c] for face in faces[node.first_face:node.first_face + node.face_count]
               for c in face.corners]
        ends = own + boxes[number]
        if ends:
            node.centre = tuple((min(axis) + max(axis)) // 2 for axis in zip(*ends))
        ways = [minus(point, node.centre) for point in own]
        node.radius = max([_root(max((dot(way, way) for way in ways), default=0))] +
                          [_root(dot(way, way)) + child.radius for child, way in
                           ((child, minus(child.centre, node.centre)) for child in below[number])])
        if node.parent != NONE:
            below[node.parent].append(node)
            boxes[node.parent] += [tuple(map(end, zip(*ends))) for end in (min, max) if ends]
    # One that is hardly smaller than that above it is not worth asking: it becomes the same.
    for node in nodes:
        if node.parent != NONE and 4 * node.radius > 3 * nodes[node.parent].radius:
            node.centre, node.radius = nodes[node.parent].centre, nodes[node.parent].radius


def _root(square):
    """The square root, upward."""
    return 1 + isqrt(square - 1) if square else 0
