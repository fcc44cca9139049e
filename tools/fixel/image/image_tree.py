# SPDX-License-Identifier: MIT
"""The tree of a scene image: its nodes, and what the loader asks of them (docs/formats.md, section 1)."""

from dataclasses import dataclass

from fixel.base.errors import ToolError
from fixel.image.fields import entry

PLANARITY_MAX, DEPTH_MAX, NODES_MAX = 8, 1023, 65535
NORMAL_SQUARE_MAX_ERROR = 1 << 32
SORTED = 1
NONE = 0xFFFF                   # no node
NODE = entry("nodes")
COORDINATE_MAX = 8191 << 16
RADIUS_MAX = 28375 << 16


class TooLarge(ToolError):
    """A scene is more than an image holds."""


def fail(status, text):
    raise ToolError(f"{status}: {text}")


@dataclass
class Node:
    """Of a tree: a plane relative to the object's centre, what is on it, in front and behind."""
    normal: tuple       # 2.30
    distance: int       # 18.46
    front: int          # numbers of nodes, or NONE
    back: int
    parent: int
    first_face: int     # within the model
    face_count: int
    centre: tuple = (0, 0, 0)   # 16.16, of a sphere about all faces in front, behind and on it
    radius: int = 0

    def pack(self):
        return NODE.pack(*self.normal, self.distance, self.front, self.back, self.parent,
                         self.first_face, self.face_count, 0, *self.centre, self.radius)

    @staticmethod
    def unpack(fields):
        if fields[9]:
            fail("reserved", "a reserved field of a node is not zero")
        return Node(tuple(fields[:3]), *fields[3:9], tuple(fields[10:13]), fields[13])


@dataclass
class Tree:
    nodes: list         # root, front, back
    object: int         # whose faces it is over


def _check_owner(tree, models, objects, still):
    if tree.object >= len(objects):
        fail("index", f"the BSP instance is {tree.object} of {len(objects)}")
    if tree.object >= still:
        fail("bsp", f"the BSP instance {tree.object} is turned")
    number = objects[tree.object].model
    if models[number].kind != SORTED:
        fail("reserved", f"the BSP instance {tree.object} has a model that is not sorted")
    if models[number].clusters:
        fail("bsp", f"the model of the BSP instance {tree.object} has clusters")
    for i, item in enumerate(objects):
        if item.model == number and i != tree.object:
            fail("bsp", f"instance {i} has the model of the BSP instance {tree.object}")
        if item.layer == objects[tree.object].layer and models[item.model].kind == SORTED and \
                i != tree.object:
            fail("bsp", f"instance {i} is on the layer of the BSP instance, and its model is not convex")
    return models[number]


def _check_links(nodes):
    """The order of listing, which leaves no node out and reaches none twice."""
    numbers, pending = 0, [(0, NONE, 0)]
    while pending:
        number, parent, depth = pending.pop()
        if number == NONE and parent != NONE:
            continue
        if number != numbers or number >= len(nodes) or nodes[number].parent != parent or \
                depth > DEPTH_MAX:
            fail("bsp", f"BSP node {number} is not where its parent says, or is too deep")
        numbers += 1
        pending += [(nodes[number].back, number, depth + 1),
                    (nodes[number].front, number, depth + 1)]
    if numbers != len(nodes):
        fail("bsp", f"node {numbers} has no parent")


def _check_sphere(i, node, tree, model, origin):
    """It lies in the world, holds the node's faces, and lies within the sphere above."""
    if any(abs(a + b) > COORDINATE_MAX for a, b in zip(node.centre, origin)) or \
            not 0 <= node.radius <= RADIUS_MAX:
        fail("range", f"the sphere of node {i} is out of range")
    for face in model.faces[node.first_face:node.first_face + node.face_count]:
        for corner in face.corners:
            if sum((a - b) ** 2 for a, b in zip(model.vertices[corner], node.centre)) > \
                    node.radius ** 2:
                fail("radius", f"a face of node {i} reaches out of the node's sphere")
    if node.parent < i:
        above = tree.nodes[node.parent]
        if above.radius < node.radius or (above.radius - node.radius) ** 2 < \
                sum((a - b) ** 2 for a, b in zip(above.centre, node.centre)):
            fail("radius", f"the sphere of node {i} reaches out of that above it")


def check_tree(tree, models, objects, still):
    """What the loader asks of a tree, with the loader's integers. still: so many objects are not
    turned."""
    model, first = _check_owner(tree, models, objects, still), 0
    for i, node in enumerate(tree.nodes):
        if abs(sum(c * c for c in node.normal) - (1 << 60)) > NORMAL_SQUARE_MAX_ERROR:
            fail("normal", f"the normal of node {i} is not of unit length")
        if abs(node.distance) > 1 << 61:
            fail("range", f"the distance of node {i} is beyond 32768 units")
        if node.first_face != first or first + node.face_count > len(model.faces):
            fail("index", f"node {i}: its faces do not follow those before, or are not all there")
        for face in model.faces[first:first + node.face_count]:
            for corner in face.corners:
                height = sum(n * c for n, c in zip(node.normal, model.vertices[corner]))
                if abs(height - node.distance) > PLANARITY_MAX << 30:
                    fail("planarity", f"a face of node {i} lies off its plane")
        first += node.face_count
        _check_sphere(i, node, tree, model, objects[tree.object].centre)
    if first != len(model.faces):
        fail("count", f"the nodes have {first} of the {len(model.faces)} faces")
    _check_links(tree.nodes)
