# SPDX-License-Identifier: MIT
"""The nodes of a glTF file by name, with their animation (docs/scenes.md, "Parts of a glTF file"), its cameras, and its lights
(KHR_lights_punctual).

A node has its own name, or its mesh's, or "node" and its number. Of several of one name the second gets _2, and so on. A light whose
values make no sense is refused; a kind that is not known is left out. A camera whose values make no sense has no perspective: only who
asks for it learns of it."""

import functools
import math

import numpy as np

from fixel.base.errors import ToolError
from fixel.base.reading import shortened
from fixel.model import gltf_motion, gltf_skins
from fixel.model.mesh import UNIT
from fixel.model.nodes import Camera, FRAMES_MAX, Light, Node, RATE, Scenery

_FLIP = np.diag([1.0, 1.0, -1.0, 1.0])     # z is negated
_MOVES_MAX = 1 << 22    # matrices of nodes, one a frame
_LEAST = 1e-6           # of the largest size of a matrix: a smaller one is none


class _Names:
    """Gives names, each once."""

    def __init__(self):
        self.taken, self.next = set(), {}

    def unique(self, name):
        """This name, or one like it that was not given before."""
        tried = name
        while tried in self.taken:
            self.next[name] = self.next.get(name, 1) + 1
            tried = f"{name}_{self.next[name]}"
        self.taken.add(tried)
        return tried


def _name_of(table, otherwise):
    name = table.get("name")
    return name if isinstance(name, str) and name.strip() else otherwise


class Nodes:
    """Collects the nodes of a file, parents first."""

    def __init__(self, checked):
        self.checked, self.parents, self.worlds, self.names, self.ranges = checked, {}, {}, {}, {}
        self.locals, self.meshes, self.stays, self.boxes, self.given = {}, {}, set(), {}, _Names()
        self.skins, self.still, self.bears, self.frozen, self.shared = {}, [], {}, set(), 0

    def add(self, number, parent, own, world, faces, vertices):
        """A node that was read. own, world: its matrix in its parent and in the file. faces: (first, behind the last);
        vertices: those that they brought."""
        entry = self.checked.rows("nodes")[number]
        mesh = self.checked.rows("meshes")[entry["mesh"]] if "mesh" in entry else {}
        name = _name_of(entry, _name_of(mesh, f"node_{number}"))
        self.names[number] = self.given.unique(name)
        self.parents[number], self.locals[number], self.worlds[number] = parent, own, world
        if faces[0] < faces[1]:
            self.ranges[number] = [faces]
            self.meshes[number] = entry["mesh"]
            self.boxes[number] = [tuple(end(axis) for axis in zip(*vertices)) for end in (min, max)]
        if "mesh" in entry and "skin" in entry:
            self.stays.add(number)      # the joints place its faces, not the node

    def groups(self):
        """{name: its faces} of those that have some."""
        return {self.names[number]: self.ranges[number] for number in self.names if number in self.ranges}

    def bind(self, number, joints):
        """Of a node with a skin, the number of the node on which each of its faces hangs; None where the skin is damaged. A node without
        faces has nothing that hangs."""
        if number in self.ranges:
            self.skins[number] = joints

    def hang(self, box_of):
        """Gives the faces of skins to their joints, once all nodes are known: the groups of joints have them too. What shares joints with a
        skin that is damaged stands as still as this one, which hangs on the node above all its joints. box_of: answers the box about some
        faces."""
        joints = {number: self._joints(number) for number in self.skins}
        self.still = [number for number, found in self.skins.items() if found is None or joints[number] & set(self.skins)]
        tops = self._tops(joints, self.still)
        roots = {self.chain(joint)[0] for number, top in tops.items() if top is None for joint in joints[number]}
        for number in self.names:       # parents first
            if number in roots or number in tops.values() or self.parents[number] in self.frozen:
                self.frozen.add(number)
        for number, found in self.skins.items():
            first, end = self.ranges[number][0]
            if number in tops:
                found = [tops[number]] * (end - first)
            if None not in found and not set(found) & set(self.skins):
                self._give(number, first, np.array(found), box_of)

    def _joints(self, number):
        """The numbers of the joints of a node with a skin that stand in the scene."""
        try:
            return set(gltf_skins.joints_of(self.checked, self.checked.rows("nodes")[number], "")) & set(self.names)
        except ToolError:
            return set()

    def _tops(self, joints, still):
        """{number of a node with a skin that is to stand still: the node above all its joints, or None}. joints: of each node with a
        skin; still: those that are damaged."""
        tops = {number: self._above(joints[number]) for number in still}
        more = [number for number in joints if number not in tops and
                any(self._is_under(each, top) for each in joints[number] for top in tops.values())]
        return self._tops(joints, [*still, *more]) if more else tops

    def chain(self, number):
        """A node and those above it, the first one first."""
        found = []
        while number is not None:
            found.append(number)
            number = self.parents[number]
        return found[::-1]

    def _is_under(self, number, top):
        return top is None or top in self.chain(number)

    def _above(self, numbers):
        """The last node that is above some nodes, or one of them; None without one."""
        chains = [self.chain(number) for number in numbers]
        same = [column[0] for column in zip(*chains) if len(set(column)) == 1]
        return same[-1] if same else None

    def _give(self, number, first, joints, box_of):
        """Gives the faces of a node to joints. first: its first face; joints: the number of a node of each face."""
        for joint in np.unique(joints).tolist():
            faces = (first + np.flatnonzero(joints == joint)).tolist()
            box = box_of(faces) + self.boxes.get(joint, [])
            self.ranges[joint] = self.ranges.get(joint, []) + _runs(faces)
            self.meshes.setdefault(joint, self.meshes[number])
            self.boxes[joint] = [tuple(end(axis) for axis in zip(*box)) for end in (min, max)]
            self.bears.setdefault(joint, []).append(number)

    def skins_note(self):
        """{"skins": what there is to say of skins that stay in the pose in which they were bound}; {} without one."""
        return {"skins": f"{self.checked.name}: left out skins ({len(self.still):,}; first: {shortened(self.names[self.still[0]])}) that are damaged, have "
                f"more than {4 * gltf_skins.SETS_MAX} joints a vertex, or joints that are outside of the scene or have a skin themselves: what hangs on "
                "their skeletons stands still, in the pose in which it was bound"} if self.still else {}

    def _pivot(self, number):
        """The node's origin; the middle of its faces where the origin lies farther from there than they are large."""
        x, y, z = self.worlds[number][:3, 3]
        origin = tuple(round(float(c) * UNIT) for c in (x, y, -z))
        if number not in self.boxes:
            return origin
        low, high = self.boxes[number]
        middle = tuple((a + b) // 2 for a, b in zip(low, high))
        largest = max(b - a for a, b in zip(low, high))
        return origin if all(abs(o - m) <= largest for o, m in zip(origin, middle)) else middle

    def _mesh_names(self):
        """{number of a mesh: a name that no other has}."""
        names, rows = _Names(), self.checked.rows("meshes")
        return {number: names.unique(_name_of(rows[number], f"mesh_{number}")) for number in dict.fromkeys(self.meshes.values())}

    def scenery(self, left_out):
        """The Scenery of the nodes. left_out: as there."""
        return Scenery(self._nodes(None), len(self.names), left_out, gltf_motion.names(self.checked), self._play,
                       self._all(camera), self._all(light))

    def _all(self, read):
        """What is read of each node that has it."""
        found = (read(self.checked, number, name, self.worlds[number]) for number, name in self.names.items())
        return [each for each in found if each is not None]

    def _play(self, wanted):
        """The nodes with an animation, how many frames it takes, and notes."""
        animation = gltf_motion.chosen(self.checked, wanted)
        if animation is None:
            return self._nodes(None), 0, []
        moves = _Moves(self, animation)
        if moves.places > _MOVES_MAX:
            return self._nodes(None), 0, [f"{animation.where}: it moves more nodes in {moves.count:,} frames than the limit of {_MOVES_MAX:,} places "
                                          "together: the model stands still; give it fewer nodes, or a shorter animation"]
        return self._nodes(moves), moves.count, moves.notes()

    def _nodes(self, moves):
        """{name: Node}. moves: None where nothing is played."""
        meshes, found = self._mesh_names(), {}
        hanging = {number for numbers in self.bears.values() for number in numbers}
        for number, name in self.names.items():
            above = self.parents[number]
            poses = functools.partial(moves.poses, number) if moves and moves.is_moved(number) else None
            found[name] = Node(name, None if above is None else self.names[above], self._pivot(number),
                               meshes.get(self.meshes.get(number)), poses is not None and moves.is_target(number), poses,
                               tuple(self.names[each] for each in self.bears.get(number, ())), number in hanging)
        return found


def _runs(faces):
    """[(first, behind the last)] of rising numbers of faces."""
    runs = []
    for face in faces:
        if runs and runs[-1][1] == face:
            runs[-1] = runs[-1][0], face + 1
        else:
            runs.append((face, face + 1))
    return runs


class _Moves:
    """The nodes of a file in each frame of an animation."""

    def __init__(self, nodes, animation):
        self.nodes, self.animation, self.known = nodes, animation, {}

    @functools.cached_property
    def count(self):
        return self.animation.frames

    def is_target(self, number):
        return number in self.animation.channels and not self._is_fixed(number) and number not in self.nodes.frozen

    def _is_fixed(self, number):
        """Whether a node has a matrix, which glTF does not let an animation move."""
        return "matrix" in self.nodes.checked.rows("nodes")[number]

    def is_moved(self, number):
        if number in self.nodes.stays or not self._has_size(number):
            return False
        while number is not None and not self.is_target(number):
            number = self.nodes.parents[number]
        return number is not None

    def _has_size(self, number):
        sizes = np.linalg.svd(self.nodes.worlds[number][:3, :3], compute_uv=False)
        return sizes[2] > _LEAST * sizes[0]

    @property
    def places(self):
        """How many matrices there are at most: of the nodes that move and are asked for, and of those above them, one a frame."""
        asked = [number for number in self.nodes.names if number in self.nodes.ranges or "camera" in self.nodes.checked.rows("nodes")[number]]
        return self.count * len({each for number in asked if self.is_moved(number) for each in self.nodes.chain(number)})

    def notes(self):
        """What there is to say where the animation is played."""
        checked, animation = self.nodes.checked, self.animation
        others = len(checked.rows("animations")) - 1
        there = [name for name in gltf_motion.names(checked) if name != animation.name]
        found = [f"{checked.name}: left out other animations ({others:,}); --animation NAME plays another one" +
                 (f": {shortened(', '.join(there))}" if there else "")] if others else []
        if animation.others:
            found.append(f"{checked.name}: {shortened(animation.name)}: left out tracks that move no node ({animation.others:,}), such as those of "
                         "other shapes (morph targets)")
        if round(animation.seconds * RATE) > FRAMES_MAX:
            found.append(f"{checked.name}: {shortened(animation.name)}: left out what comes after {FRAMES_MAX:,} frames")
        fixed = [self.nodes.names[number] for number in animation.channels if number in self.nodes.names and self._is_fixed(number)]
        if self.nodes.shared and any(self.is_moved(number) for number in self.nodes.bears):
            found.append(f"{checked.name}: faces that hang on several joints move with the one on which they hang the most: {self.nodes.shared:,}; "
                         "nothing bends, as on the PlayStation, and --animation none shows the model without")
        if fixed:
            found.append(f"{checked.name}: nodes with a matrix stay where they stand, though the animation would move them: {len(fixed):,} "
                         f"(first: {shortened(fixed[0])}); save them with translation, rotation and scale")
        small = [self.nodes.names[number] for number in animation.channels if number in self.nodes.names and not self._has_size(number)]
        if small:
            found.append(f"{checked.name}: nodes that have no size where they stand without the animation stay there: {len(small):,} "
                         f"(first: {shortened(small[0])})")
        return found

    def world(self, number):
        """Matrices of 4x4 of a node in the file, one a frame; one matrix for what does not move."""
        chain = []
        while number is not None and number not in self.known:
            chain.append(number)
            number = self.nodes.parents[number]
        made = np.eye(4) if number is None else self.known[number]
        for each in reversed(chain):
            own = self.animation.local(each, self.nodes.checked.rows("nodes")[each], self.count) if self.is_target(each) else \
                self.nodes.locals[each]
            self.known[each] = made = made @ own
        return made

    def poses(self, number):
        """Of each frame the matrix that takes what was read to its place."""
        back = np.linalg.inv(self.nodes.worlds[number])
        return (_FLIP @ (self.world(number) @ back) @ _FLIP)[:, :3, :]


_EXTENSION = "KHR_lights_punctual"
_KINDS = ("directional", "point", "spot")
_GREY = (0.2126, 0.7152, 0.0722)    # what red, green and blue are of a brightness


def _placed(world):
    """A matrix of 3x4 from a node to the vertices as they are read: its z looks where the node's -z does, and axes have unit
    length."""
    made = (_FLIP @ world @ _FLIP)[:3]
    lengths = np.linalg.norm(made[:, :3], axis=0)
    return np.column_stack([made[:, :3] / np.where(lengths > 0, lengths, 1), made[:, 3]])


def _number(checked, table, key, default, where, least=0.0):
    value = table.get(key, default)
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not least <= value <= 1e12:
        checked.fail(where, f"{key} must be a number from {least:g} to 1e12: the file is damaged")
    return float(value)


def camera(checked, number, name, world):
    """The Camera at a node; None where it has none."""
    node = checked.rows("nodes")[number]
    if "camera" not in node:
        return None
    chosen, entry = checked.entry("cameras", node, "camera", checked.label("node", number))
    table, where = entry.get("perspective"), checked.label("camera", chosen)
    if not isinstance(table, dict):
        flat = entry.get("orthographic")
        try:
            half, near = (_number(checked, flat, key, 0.0, where) for key in ("xmag", "znear")) if isinstance(flat, dict) else (0.0, None)
        except ToolError:
            half, near = 0.0, None
        return Camera(name, None, near, _placed(world), half or None)
    try:
        angle, near = (_number(checked, table, key, 0.0, where) for key in ("yfov", "znear"))
    except ToolError:
        angle, near = 0.0, 0.0
    return Camera(name, math.degrees(angle) if 0 < angle < math.pi else None, near, _placed(world))


def _entries(checked):
    """The lights at the top of the file."""
    extensions = checked.data.get("extensions")
    table = extensions.get(_EXTENSION) if isinstance(extensions, dict) else None
    rows = table.get("lights") if isinstance(table, dict) else None
    return rows if isinstance(rows, list) else []


def light(checked, number, name, world):
    """The Light at a node, or None."""
    extensions, where = checked.rows("nodes")[number].get("extensions"), checked.label("node", number)
    table = extensions.get(_EXTENSION) if isinstance(extensions, dict) else None
    if not isinstance(table, dict):
        return None
    rows, chosen = _entries(checked), checked.whole(table, "light", where)
    if chosen >= len(rows) or not isinstance(rows[chosen], dict):
        checked.fail(where, f"light {chosen} does not exist; there are {len(rows)}")
    entry, where = rows[chosen], f"light {chosen}"
    colour = entry.get("color", [1, 1, 1])
    if not isinstance(colour, list) or len(colour) != 3 or not all(isinstance(c, (int, float)) and 0 <= c <= 1e6 for c in colour):
        checked.fail(where, "color must be three numbers: the file is damaged")
    if entry.get("type") not in _KINDS:
        return None
    strength = _number(checked, entry, "intensity", 1.0, where) * sum(c * g for c, g in zip(colour, _GREY))
    reach = _number(checked, entry, "range", None, where)
    return Light(name, entry["type"], strength, reach, max(colour) - min(colour) > 0.02 * max(colour), _placed(world))
