# SPDX-License-Identifier: MIT
"""The nodes of a glTF file by name, with their animation (docs/scenes.md, "Parts of a glTF file").

A node has its own name, or its mesh's, or "node" and its number. Of several of one name the second gets _2, and so on."""

import functools

import numpy as np

from fixel.model import gltf_motion, gltf_scenery
from fixel.model.mesh import UNIT
from fixel.model.nodes import FRAMES_MAX, RATE, Node, Scenery
from fixel.base.reading import shortened

_FLIP = np.diag([1.0, 1.0, -1.0, 1.0])     # z is negated
_MOVES_MAX = 1 << 22    # matrices of nodes, one a frame
_LEAST = 1e-6           # of the largest size of a matrix: a smaller one is none


def _turns(matrix):
    """1 of a matrix of 4x4 that has a size along each axis, -1 of one that mirrors, 0 of one without a size along some axis."""
    sizes = np.linalg.svd(matrix[:3, :3], compute_uv=False)
    return 0 if not sizes[2] > _LEAST * sizes[0] else 1 if np.linalg.det(matrix[:3, :3] / sizes[0]) > 0 else -1


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
        self.skins, self.are_rigid = {}, False

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
        if "skin" in entry:
            self.stays.add(number)

    def groups(self):
        """{name: its faces} of those that have some."""
        return {self.names[number]: self.ranges[number] for number in self.names if number in self.ranges}

    def bind(self, number, joints):
        """What hangs on joints at a node: see gltf_skins.rigid. A node without faces has nothing that hangs."""
        if number in self.ranges:
            self.skins[number] = joints

    def hang(self, move):
        """Gives the faces of rigid skins to their joints, once all nodes are known; are_rigid says whether all were. move: takes faces to their place by a matrix
        of 3x4, and answers their vertices there."""
        self.are_rigid = bool(self.skins)
        for number, joints in self.skins.items():
            if joints is None or not all(self._is_free(joint, matrix) for joint, (matrix, _) in joints.items()):
                self.are_rigid = False
                continue
            (first, _), mesh = self.ranges.pop(number)[0], self.meshes.pop(number)
            for joint, (matrix, faces) in joints.items():
                faces = [first + face for face in faces]
                vertices = move(faces, (_FLIP @ self.worlds[joint] @ matrix @ _FLIP)[:3]) + self.boxes.get(joint, [])
                self.ranges[joint] = self.ranges.get(joint, []) + _runs(faces)
                self.meshes.setdefault(joint, mesh)
                self.boxes[joint] = [tuple(end(axis) for axis in zip(*vertices)) for end in (min, max)]

    def _is_free(self, joint, matrix):
        """Whether a joint is a node of the scene that stays nowhere, and does not mirror."""
        return joint in self.names and joint not in self.stays and _turns(self.worlds[joint] @ matrix) > 0

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
                       self._all(gltf_scenery.camera), self._all(gltf_scenery.light))

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
        return self._nodes(moves), moves.count, moves.notes()

    def _nodes(self, moves):
        """{name: Node}. moves: None where nothing is played."""
        meshes, found = self._mesh_names(), {}
        for number, name in self.names.items():
            above = self.parents[number]
            poses = functools.partial(moves.poses, number) if moves and moves.is_moved(number) else None
            found[name] = Node(name, None if above is None else self.names[above], self._pivot(number),
                               meshes.get(self.meshes.get(number)), poses is not None and moves.is_target(number), poses)
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
        return number in self.animation.channels and not self._is_fixed(number)

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
        return _turns(self.nodes.worlds[number]) != 0

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
            if len(self.known) * self.count > _MOVES_MAX:
                self.nodes.checked.fail(self.animation.where, f"it moves more nodes in {self.count:,} frames than the limit of {_MOVES_MAX:,} "
                                        "places together; give it fewer nodes, or a shorter animation")
            own = self.animation.local(each, self.nodes.checked.rows("nodes")[each], self.count) if self.is_target(each) else \
                self.nodes.locals[each]
            self.known[each] = made = made @ own
        return made

    def poses(self, number):
        """Of each frame the matrix that takes what was read to its place."""
        back = np.linalg.inv(self.nodes.worlds[number])
        return (_FLIP @ (self.world(number) @ back) @ _FLIP)[:, :3, :]
