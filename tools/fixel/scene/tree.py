# SPDX-License-Identifier: MIT
"""A tree over the faces of a layer (docs/extras/bsp.md): objects merged into one model, their
faces cut by splitting planes, and what the cuts made of edges given to all who have them.

Everything is decided in integers on rounded vertices, as in fixel.model.mesh. A face is a ring of
vertices and of lines: a line is an edge of the scene or of a cut, with the ends that it had at
first. A new vertex is where a line, from its first ends, meets a plane; it is rounded once and
belongs to the line, so whoever has the line finds the same vertices on it."""

from dataclasses import dataclass, replace

from fixel.image import image_beam
from fixel.scene import tree_choice, tree_faces
from fixel.base.errors import ToolError
from fixel.image.image import (CONVEX, FACE_VERTICES_MAX, SORTED, Model, Object, check_coordinates)
from fixel.image.image_surface import Mapped
from fixel.image.image_tree import DEPTH_MAX, NODES_MAX, NONE, Node, Tree
from fixel.image.image_tree import PLANARITY_MAX as NEAR
from fixel.base.vectors import dot, minus
from fixel.model.mesh import FACES_MAX
from fixel.base.reading import quoted

# A vertex closer to a plane than this lies on it: in units of 2^-46. It exceeds what a face may
# be off its plane (4) and a rounded vertex off its line (0.87).
ON = (NEAR - 1) << 30


@dataclass(slots=True)
class Part:
    """A face of the scene, or what the cuts left of it."""
    normal: tuple
    colour: int
    source: int         # the scene's face
    group: int          # the scene's object
    ring: list          # vertices; line i goes from vertex i to the next
    lines: list | None = None   # None once nothing cuts it any more
    mapped: Mapped | None = None    # the surface of the scene's face, by vertices of it whole


@dataclass
class Counts:
    """What building did, for people."""
    faces_in: int = 0
    faces_out: int = 0
    splits: int = 0
    nodes: int = 0
    depth: int = 0
    vertices_in: int = 0
    vertices_out: int = 0
    shared: int = 0     # vertices given to faces across an edge
    halved: int = 0     # faces cut in two because they had too many

    def text(self):
        return (f"{self.faces_in:,} faces in, {self.faces_out:,} out: {self.splits:,} splits, "
                f"{self.halved:,} more for their vertices; {self.nodes:,} nodes, "
                f"{self.depth} deep; {self.vertices_in:,} vertices in, {self.vertices_out:,} out, "
                f"{self.shared:,} put into edges")


def round_div(a, b):
    """a / b to nearest, halves upward, b > 0."""
    return (2 * a + b) // (2 * b)


class Lines:
    """Lines, the vertices on them, and vertices by their place."""

    def __init__(self):
        self.points, self.numbers = [], {}
        self.ends, self.by_ends, self.cuts = [], {}, {}
        self.on, self.places = {}, {}   # of lines that were cut: the new vertices; where each vertex is on the way

    def vertex(self, point):
        number = self.numbers.setdefault(point, len(self.points))
        if number == len(self.points):
            self.points.append(point)
        return number

    def edge(self, a, b):
        """The line of an edge of the scene, whichever way it goes."""
        key = (min(a, b), max(a, b))
        if key not in self.by_ends:
            self.by_ends[key] = self.line(key)
        return self.by_ends[key]

    def line(self, ends):
        self.ends.append(ends)
        return len(self.ends) - 1

    def crossing(self, line, number, plane):
        """The vertex where a line meets the plane of node `number`: once for both."""
        key = (line, number)
        if key not in self.cuts:
            a, b = (self.points[end] for end in self.ends[line])
            above, below = height(plane, a), height(plane, b)
            if above < below:
                a, b, above, below = b, a, below, above
            point = tuple(p + round_div((q - p) * above, above - below) for p, q in zip(a, b))
            self.cuts[key] = self.vertex(point)
            self.on.setdefault(line, {*self.ends[line]}).add(self.cuts[key])
        return self.cuts[key]

    def between(self, line, a, b):
        """The line's vertices from a to b, both left out, in the order of the way. Nothing is put on a line after this."""
        if line not in self.on:
            return []
        if line not in self.places:
            first, last = (self.points[end] for end in self.ends[line])
            way = minus(last, first)
            order = sorted(self.on[line], key=lambda v: (dot(minus(self.points[v], first), way), v))
            self.places[line] = order, {vertex: place for place, vertex in enumerate(order)}
        order, places = self.places[line]
        i, j = places[a], places[b]
        return order[i + 1:j] if i < j else order[j + 1:i][::-1]


def height(plane, point):
    """How far in front of a plane (normal, distance) a point lies: exact."""
    return dot(plane[0], point) - plane[1]


def side(value):
    return (value > ON) - (value < -ON)


def _turn(sides, heights, here, there):
    """Where a ring goes from one side of a plane to the other: (i, None) between vertices i and
    i + 1, or (i, i) at vertex i, which lies on the plane."""
    count = len(sides)
    for i in range(count):
        if sides[i] != here:
            continue
        j = i + 1
        while sides[j % count] == 0:
            j += 1
        if sides[j % count] == there:
            if j == i + 1:
                return i, None
            best = min(range(i + 1, j), key=lambda k: (abs(heights[k % count]), k)) % count
            return best, best
    raise AssertionError("no turn")


# bsp 2.4
def cut(lines, part, number, plane):
    """Both parts of a face that lies on both sides of a node's plane."""
    heights = [height(plane, lines.points[v]) for v in part.ring]
    sides = [side(h) for h in heights]
    count, marks = len(sides), []
    for here, there in ((1, -1), (-1, 1)):
        i, at = _turn(sides, heights, here, there)
        marks.append((i, part.ring[at]) if at is not None
                     else (i, lines.crossing(part.lines[i], number, plane)))
    (leave, out), (enter, back) = marks
    across = lines.line((out, back))
    halves = []
    for (start, begin), (stop, end) in ((marks[1], marks[0]), (marks[0], marks[1])):
        ring, own, i = [begin], [part.lines[start]], start
        while True:
            i = (i + 1) % count
            ring.append(part.ring[i])
            own.append(part.lines[i])
            if i == stop:
                break
        if ring[-1] == end:
            own[-1] = across
        else:
            ring.append(end)
            own.append(across)
        halves.append(_whole(replace(part, ring=ring, lines=own)))
    return halves


def _whole(part):
    """The part without vertices that repeat the one before: a crossing may be rounded onto an end."""
    keep = [i for i, v in enumerate(part.ring) if v != part.ring[(i + 1) % len(part.ring)]]
    part.ring = [part.ring[i] for i in keep]
    part.lines = [part.lines[i] for i in keep]
    return part


class Builder:
    """The tree of a list of parts, depth first, without recursion."""

    def __init__(self, lines, parts, progress):
        self.lines, self.progress = lines, progress
        self.nodes, self.held = [], []
        self.counts = Counts(faces_in=len(parts), vertices_in=len(lines.points))
        self.pending = [(parts, NONE, 0, 0)]
        self.total, self.done = len(parts), 0

    def build(self):
        while self.pending:
            parts, parent, which, depth = self.pending.pop()
            self._node(parts, parent, which, depth)
        self.counts.nodes = len(self.nodes)
        return self.nodes, self.held

    def _node(self, parts, parent, which, depth):
        number = len(self.nodes)
        if number == NODES_MAX or depth > DEPTH_MAX:
            raise ToolError(f"the tree needs more than {NODES_MAX:,} nodes, or nodes more than "
                            f"{DEPTH_MAX:,} deep: give its layer fewer faces")
        if self.progress:
            self.progress(f"tree: {self.done} of about {self.total} faces, {number} nodes, "
                          f"{self.counts.splits} splits")
        plane = tree_choice.choose(self.lines.points, parts)
        self.nodes.append(Node(*plane, NONE, NONE, parent, 0, 0))
        if parent != NONE:
            setattr(self.nodes[parent], "front" if which > 0 else "back", number)
        self.counts.depth = max(self.counts.depth, depth)
        on, front, back = self._divide(parts, number, plane)
        self.held.append(on)
        self.done += len(on)
        if back:
            self.pending.append((back, number, -1, depth + 1))
        if front:
            self.pending.append((front, number, 1, depth + 1))

    def _divide(self, parts, number, plane):
        on, front, back = [], [], []
        for part in parts:
            sides = {side(height(plane, self.lines.points[v])) for v in part.ring}
            if sides == {0}:
                on.append(part)
            elif -1 not in sides:
                front.append(part)
            elif 1 not in sides:
                back.append(part)
            else:
                for half, others in zip(cut(self.lines, part, number, plane), (front, back)):
                    if len(half.ring) >= 3:
                        others.append(half)
                        self.total += 1
                self.counts.splits += 1
                self.total -= 1
                _check_size("faces", self.total)
        return on, front, back


def _renumbered(mapped, numbers):
    """The record of a face with other numbers of its vertices; None without a surface."""
    return mapped and replace(mapped, vertices=tuple(numbers[vertex] for vertex in mapped.vertices))


def parts_of(scene, members, origin, lines):
    """The faces of the objects as parts; vertices relative to origin."""
    parts = []
    for group in members:
        item = scene.objects[group]
        model = scene.models[item.model]
        numbers = [lines.vertex(tuple(v + c - o for v, c, o in zip(vertex, item.centre, origin)))
                   for vertex in model.vertices]
        _check_size("vertices", len(lines.points))
        for face in model.faces:
            ring = [numbers[corner] for corner in face.corners]
            own = [lines.edge(a, b) for a, b in zip(ring, ring[1:] + ring[:1])]
            parts.append(Part(face.normal, face.colour, len(parts), group, ring, own, _renumbered(face.mapped, numbers)))
    return parts


def _middle(scene, members):
    low, high = [1 << 40] * 3, [-(1 << 40)] * 3
    for group in members:
        item = scene.objects[group]
        for vertex in scene.models[item.model].vertices:
            for axis in range(3):
                value = vertex[axis] + item.centre[axis]
                low[axis], high[axis] = min(low[axis], value), max(high[axis], value)
    return tuple((a + b) // 2 for a, b in zip(low, high))


def _check_size(kind, count):
    """A model has at most so many faces, and so many vertices."""
    if count > FACES_MAX:
        raise ToolError(f"the tree would have {count:,} {kind} or more, and a model has at most {FACES_MAX:,}: "
                        "give its layers fewer faces, or name fewer layers")


def grow(parts, lines, progress=None, most=FACE_VERTICES_MAX):
    """Nodes, faces of at most so many vertices, for each face the number of the part that it came from, and counts."""
    builder = Builder(lines, parts, progress)
    nodes, held = builder.build()
    faces, sources, counts = [], [], builder.counts
    for part in (part for group in held for part in group):
        counts.shared += tree_faces.share(lines, part)
    # Of n corners that are too many, at least (n - 2) / (most - 2) faces are made, rounded up.
    _check_size("faces", sum(max(1, (len(part.ring) + most - 5) // (most - 2)) for group in held for part in group))
    for node, group in zip(nodes, held):
        node.first_face = len(faces)
        pieces = [piece for part in group for piece in tree_faces.halve(lines, part, most)]
        counts.halved += len(pieces) - len(group)
        faces += [tree_faces.flat_face(lines, piece) for piece in pieces]
        sources += [piece.source for piece in pieces]
        node.face_count = len(faces) - node.first_face
    counts.faces_out = len(faces)
    tree_faces.add_spheres(nodes, faces, lines.points)
    return nodes, faces, sources, counts


def layers_of(text, scene):
    """The layers that "all", "5" or "2,4,5" names; "most": the one with the most faces."""
    faces = {}
    for item in scene.objects:
        faces[item.layer] = faces.get(item.layer, 0) + len(scene.models[item.model].faces)
    if text == "all":
        return set(faces)
    if text == "most":
        return {max(faces, key=lambda layer: (faces[layer], layer))}
    wanted = {int(part) for part in text.split(",") if part.isascii() and part.isdigit() and len(part) < 4}
    if not wanted or len(wanted) != len(text.split(",")) or not wanted <= set(faces):
        raise ToolError(f"the layers of the tree are {quoted(text)}; they must be like 5, 2,4,5, all, most or none, and "
                        f"of {', '.join(map(str, sorted(faces)))}")
    return wanted


def _shows_billboard(scene, item):
    return scene.billboards is not None and scene.billboards.model_map[item.model] != 0


def _members(scene, layers, moving):
    """The objects that the tree is made of, in the order of layers: of faces in one plane the last
    is drawn last."""
    members = sorted((item.layer, i) for i, item in enumerate(scene.objects)
                     if item.layer in layers and i not in moving and not _shows_billboard(scene, item))
    if not members:
        raise ToolError("nothing on the layers of the tree stands still")
    for i in moving:
        item = scene.objects[i]
        if _shows_billboard(scene, item):
            continue
        if item.layer in layers and item.layer != max(layers):
            raise ToolError(f"object {i} moves on a layer of the tree that is not its last")
        if item.layer in layers and scene.models[item.model].kind != CONVEX:
            raise ToolError(f"object {i} moves on the tree's layer, and is not convex")
    return [i for _, i in members]


def _most(beams):
    """How many vertices a face may have that beams are to cut."""
    return max((count for count in range(3, FACE_VERTICES_MAX + 1)
                if not beams or image_beam.fits(beams, count)), default=3)


def plant(scene, layers, moving=(), progress=None):
    """Merges the objects of some layers, but for those that may move, into one with a tree, on the
    last of them; answers the counts. Billboards of these layers go to the last, where the tree has a
    place for each. The others stay as they are; the new object is the last that
    is not turned. The parts of a face that was cut share its surface, which lies as on the whole, and its light: its
    vertices stay in the model."""
    members = _members(scene, layers, moving)
    for item in scene.objects:
        if item.layer in layers and _shows_billboard(scene, item):
            item.layer = max(layers)
    _check_size("faces", sum(len(scene.models[scene.objects[group].model].faces) for group in members))
    origin, lines = _middle(scene, members), Lines()
    parts = parts_of(scene, members, origin, lines)
    wholes = [tuple(part.ring) for part in parts]
    nodes, faces, sources, counts = grow(parts, lines, progress, _most(scene.beams))
    if scene.light:
        tree_faces.add_wholes(faces, [wholes[source] for source in sources], lines.points)
    used = {}
    for face in faces:
        face.corners = tuple(used.setdefault(corner, len(used)) for corner in face.corners)
    for face in faces:
        if face.mapped:
            face.mapped = _renumbered(face.mapped, {vertex: used.setdefault(vertex, len(used)) for vertex in face.mapped.vertices})
        face.whole = tuple(used.setdefault(corner, len(used)) for corner in face.whole)
    vertices = [lines.points[number] for number in used]
    counts.vertices_out = len(vertices)
    _check_size("vertices", len(vertices))
    _check_size("faces", len(faces))
    for vertex in vertices:
        check_coordinates([v + o for v, o in zip(vertex, origin)], "a vertex of the tree")
    _put(scene, members, Model(vertices, faces, SORTED), Object(origin, 0, max(layers)))
    scene.tree = Tree(nodes, len(scene.objects) - len(scene.placements) - 1)
    return counts


def _put(scene, members, model, item):
    """Takes the members out of a scene, and the models that no object has any more; puts the new
    model at the end, and its object after those that are not turned."""
    taken = set(members)
    scene.names = [name for i, name in enumerate(scene.names) if i not in taken]
    scene.objects = [o for i, o in enumerate(scene.objects) if i not in taken]
    kept = sorted({o.model for o in scene.objects})
    new = {old: number for number, old in enumerate(kept)}
    scene.models = [scene.models[old] for old in kept] + [model]
    if scene.billboards is not None:
        scene.billboards.model_map = [scene.billboards.model_map[old] for old in kept] + [0]
    scene.objects = [Object(o.centre, new[o.model], o.layer) for o in scene.objects]
    item.model = len(kept)
    scene.objects.insert(len(scene.objects) - len(scene.placements), item)
    scene.names.insert(len(scene.names) - len(scene.placements), None)
