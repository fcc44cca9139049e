# SPDX-License-Identifier: MIT
"""The parts of a model without a scene file: which nodes of a glTF file and which groups of an OBJ file become objects of their own,
where each stands, what it hangs on, and how it moves (docs/scenes.md, "Parts of a glTF file")."""

from dataclasses import dataclass, field
import difflib
import fnmatch
from fractions import Fraction

import numpy as np

from fixel.base.errors import ToolError
from fixel.base.reading import QUOTE_MAX, quoted, shortened
from fixel.image.image_placement import DEPTH_MAX
from fixel.model.mesh import UNIT, Mesh, newell, transform
from fixel.model.nodes import Node
from fixel.scene import tracks
from fixel.scene.look import NO_ANIMATION

NODES_MAX = 64      # of a file whose nodes all become objects
POSES_MAX = 1 << 21     # of all parts in all frames


@dataclass
class Part:
    """name: of its node or group, or None. groups: the nodes or groups whose faces it has, that of its own name first, none: all;
    without: those whose faces it has not. node: a nodes.Node or None. is_kept: --keep names it. parent: the Part that it hangs on, or None. pose: matrices
    of 3x4, one a frame, of what moves, as the board plays them."""
    name: str
    groups: list
    node: object = None
    is_kept: bool = False
    parent: object = None
    pose: object = None
    without: list = field(default_factory=list)

    @property
    def is_turned(self):
        """Whether a board turns it."""
        return self.is_kept or self.parent is not None or self.pose is not None

    @property
    def depth(self):
        """How many parts it hangs on, one after the other."""
        return 0 if self.parent is None else 1 + self.parent.depth


@dataclass
class Played:
    """The parts of a model, how many frames its animation takes, and what there is to say."""
    parts: list
    frames: int = 0
    notes: list = field(default_factory=list)
    uses: set = field(default_factory=set)      # kinds of scenery.left_out that are not left out
    poses: dict = field(default_factory=dict)   # of cameras that the animation moves, matrices of 3x4, one a frame


def _kept(nodes, patterns, name, kind="node"):
    """The names of the nodes that patterns name; of groups, likewise."""
    found = set()
    for pattern in filter(None, patterns.split(",")):
        fitting = {each for each in nodes if fnmatch.fnmatchcase(each, pattern)}
        if not fitting:
            near = difflib.get_close_matches(pattern[:QUOTE_MAX], list(nodes)[:1000], 1, 0)
            raise ToolError(f"{name}: --keep: no {kind} has a name like {quoted(pattern)}" +
                            (f"; the nearest is {quoted(near[0])}" if near else ""))
        found |= fitting
    return found


def _carriers(nodes, chosen):
    """{name of a node: the node, among the chosen ones, that it moves with}; None for what moves with none."""
    found = {None: None}
    for name, node in nodes.items():
        found[name] = name if name in chosen else found[node.parent]
    return found


def _owners(mesh, nodes, kept):
    """The names of the groups that have all faces, each once. What hangs on joints belongs to these where one of them moves, or a
    pattern names one; else to its own node, and no mesh is divided for nothing."""
    if any(nodes[name].bears and (nodes[name].poses is not None or name in kept) for name in mesh.groups):
        return [name for name in mesh.groups if not nodes[name].hangs]
    return [name for name in mesh.groups if not nodes[name].bears or mesh.numbers_of([name], nodes[name].bears)]


def _borne(nodes, names, groups):
    """The names of the nodes whose faces some groups have too, and that own these faces themselves."""
    return [each for each in dict.fromkeys(each for name in groups for each in nodes[name].bears) if each in names and each not in groups]


def _divided(mesh, nodes, kept, whole):
    """The Parts of a file, parents first. whole: whether what nothing moves and no pattern names stays in one part. What hangs on a
    node without faces that a pattern names is a part of it."""
    is_small = not whole and mesh.scenery.count <= NODES_MAX
    chosen = {name for name, node in nodes.items() if node.is_animated or name in kept}
    names = _owners(mesh, nodes, kept)
    if is_small:
        above, bare = _carriers(nodes, chosen), kept - set(mesh.groups)
        chosen |= {name for name in names if above[name] not in bare}
    carriers, found = _carriers(nodes, chosen), {}
    for name in names:
        key = carriers[name]
        if key is None and not whole:
            key = (nodes[name].mesh,)       # one part a mesh
        found.setdefault(key, []).append(name)
    parts = {}
    for key in [None, *(key for key in found if isinstance(key, tuple)), *nodes]:
        if key not in found:
            continue
        if not isinstance(key, str):
            parts[key] = Part(key and key[0], found[key], without=_borne(nodes, names, found[key]))
            continue
        above = nodes[key].parent
        while above is not None and (above not in parts or not parts[above].is_turned or parts[above].depth >= DEPTH_MAX):
            above = nodes[above].parent
        node = nodes[key]
        parts[key] = Part(key, [key, *(each for each in found[key] if each != key)], node, key in kept,
                          parts[above] if above is not None else None, without=_borne(nodes, names, found[key]))
        if node.poses is not None and parts[key].parent is None:
            parts[key].pose = True          # until it is played
    return list(parts.values())


def _kept_groups(mesh, patterns, name):
    """The Parts of an OBJ file: a part for each group that a pattern names, and one of all other faces. A face of several such groups
    belongs to that which begins first, and of those to that which ends first."""
    order = {each: number for number, each in enumerate(mesh.groups)}
    kept, found, owners = _kept(mesh.groups, patterns, name, "group"), [], {}
    for group in sorted(kept, key=lambda each: (mesh.groups[each][0], order[each])):
        numbers = mesh.numbers_of([group])
        before = list(dict.fromkeys(owners[number] for number in numbers if number in owners))
        if any(number not in owners for number in numbers):
            owners |= {number: group for number in numbers if number not in owners}
            found.append(Part(group, [group], Node(group, pivot=mesh.part(group, without=before).middle), True, without=before))
    names = [part.name for part in found]
    rest = mesh.part(without=names)
    return ([Part(None, [], Node(name, pivot=rest.middle), without=names)] if rest.faces else []) + found


def _inverse(pose):
    """Of matrices of 3x4 that are a turn, a scale and a move."""
    linear = np.linalg.inv(pose[:, :, :3])
    return np.concatenate([linear, -(linear @ pose[:, :, 3:])], axis=2)


def _product(one, other):
    return np.concatenate([one[:, :, :3] @ other[:, :, :3], one[:, :, :3] @ other[:, :, 3:] + one[:, :, 3:]], axis=2)


def _with_size(poses, others):
    """Matrices of 3x4, and others in the frames in which they have no size."""
    sizes = np.linalg.svd(poses[:, :, :3], compute_uv=False)
    return np.where((sizes[:, 2] > tracks.SIZE_MIN * sizes[:, 0])[:, None, None], poses, others)


def _play(parts, frames, name):
    """Gives parts their poses, relative to nothing; and notes. A part's pose in its parent becomes a turn with one scale, also where the
    parent is stretched: what hangs on it stays with what is shown of it."""
    stretched, still, own = [], np.repeat(np.eye(4)[None, :3], frames, axis=0), {}
    for part in parts:
        if not part.is_turned:
            continue
        wanted = part.node.poses() if part.node.poses is not None else still
        above = part.parent.pose if part.parent is not None else still
        own[id(part)] = wanted
        relative = _product(_inverse(_with_size(own[id(part.parent)], above) if part.parent is not None else still), wanted)
        turns, sizes, off = tracks.similar(relative[:, :, :3])
        if off > tracks.STRETCH_MAX:
            stretched.append(part.name)
        pivot = np.array([c / UNIT for c in part.node.pivot])
        linear = turns * sizes[:, None, None]
        move = relative[:, :, :3] @ pivot + relative[:, :, 3] - linear @ pivot      # the pivot is where it should be
        part.pose = _product(above, np.concatenate([linear, move[:, :, None]], axis=2))
    return [f"{name}: nodes that are stretched in one direction as they move have one size in all: {len(stretched):,} (first: "
            f"{shortened(stretched[0])})"] if stretched else []


def divide(mesh, name, look):
    """The Played of a file. look: a look.Look."""
    scenery = mesh.scenery
    if scenery is None:
        for option, value in (("--animation", look.animation), ("--camera", look.camera)):
            if value and value != NO_ANIMATION:
                raise ToolError(f"{name}: {option} is for a glTF file; this file has none")
        if look.keep and not mesh.groups:
            raise ToolError(f"{name}: --keep is for the nodes of a glTF file, and for o and g of an OBJ file; this file has none")
    if look.whole or (scenery is None and not look.keep):
        return Played([Part(None, [])])
    if scenery is None:
        parts = _kept_groups(mesh, look.keep, name)
        return Played(parts, 0, _play(parts, 1, name))
    is_still = look.animation == NO_ANIMATION
    nodes, frames, notes = (scenery.nodes, 0, []) if is_still else scenery.play(look.animation or None)
    if look.animation and not is_still and not frames and not notes:
        there = shortened(", ".join(scenery.animations)) or "none"
        raise ToolError(f"{name}: --animation: no animation that moves a node has a name like {quoted(look.animation)}; the file's: {there}")
    parts = _divided(mesh, nodes, _kept(nodes, look.keep, name), look.depth == 0)
    turned = sum(part.is_turned for part in parts)
    if frames * turned > POSES_MAX:
        notes = [*notes, f"{name}: the animation moves {turned:,} parts in {frames:,} frames: more than the limit of {POSES_MAX:,} places; "
                 "the model stands still: give it fewer nodes, or a shorter animation"]
        nodes, frames = scenery.nodes, 0
        parts = _divided(mesh, nodes, _kept(nodes, look.keep, name), look.depth == 0)
    bare = sorted(_kept(nodes, look.keep, name) - {part.name for part in parts})
    if bare:
        notes = [*notes, f"{name}: nodes that --keep names and that have no faces are no objects: {len(bare):,} (first: {shortened(bare[0])})"]
    uses = {"animations"} if frames else set()
    notes = notes + _play(parts, max(frames, 1), name)
    if frames:
        moving = sum(part.is_turned for part in parts)
        notes.append(f"{name}: the animation takes {frames:,} frames and moves {moving:,} of {len(parts):,} parts" if moving else
                     f"{name}: the animation moves nothing that has faces")
    poses = {camera.name: nodes[camera.name].poses() for camera in scenery.cameras if nodes[camera.name].poses is not None}
    return Played(parts, frames, notes, uses, poses)


def _relative(part):
    """The pose of a part in its parent's model."""
    return part.pose if part.parent is None else _product(_inverse(part.parent.pose), part.pose)


def _motion(part, scale):
    """The keys turn, size, parent and motion of a part that is turned."""
    relative, pivot = _relative(part), np.array([c / UNIT for c in part.node.pivot])
    linear = relative[:, :, :3]
    turns, sizes, _ = tracks.similar(linear)
    offsets = (linear @ pivot + relative[:, :, 3] - pivot) * float(scale)
    rows = tracks.keys(offsets, turns, sizes)
    found = {"parent": part.parent.name} if part.parent is not None else {}
    if len(rows) == 1 and not rows[0]:
        return found | {"size": 1}
    return found | {"motion": {"keys": rows}}


def _rows(scale):
    return [[scale if i == j else Fraction(0) for j in range(3)] for i in range(3)]


def leave_out_small(played, mesh, name, scale):
    """Leaves out the parts none of whose faces has an area at a scale, unless that are all of them, or others hang on them; notes."""
    if len(played.parts) < 2:
        return []
    points = transform(mesh, _rows(scale))

    def has_area(part):
        return any(newell([points[corner] for corner in mesh.faces[number]]) != (0, 0, 0)
                   for number in mesh.numbers_of(part.groups, part.without))
    small, kept = [], []
    for part in reversed(played.parts):     # those that hang on others come after them
        is_needed = any(other.parent is part for other in kept)
        (kept if is_needed or has_area(part) else small).append(part)
    if not small or not kept:
        return []
    played.parts = kept[::-1]
    first = small[-1].name or small[-1].groups[0]
    return [f"{name}: left out parts that are too small to have an area, or have the scale 0: {len(small):,} (first: {shortened(first)})"]


def objects(played, mesh, name, scale, thing):
    """The objects of a scene. thing: the keys that all have."""
    if len(played.parts) == 1 and not played.parts[0].is_turned:
        part, = played.parts
        return [{"name": part.name or name, "model": name, "scale": scale, "anchor": "middle", **thing}]
    rows = _rows(scale)
    placed = transform(mesh, rows)
    middle = [(min(axis) + max(axis)) // 2 for axis in zip(*placed)]
    found = []
    for part in played.parts:
        node = part.node or mesh.scenery.nodes[part.groups[0]]
        chosen = {key: names if len(names) > 1 else names[0] for key, names in (("group", part.groups), ("without", part.without)) if names}
        own = transform(Mesh([node.pivot], []), rows)[0]
        above = middle if part.parent is None else transform(Mesh([part.parent.node.pivot], []), rows)[0]
        found.append({"name": part.name or name, "model": name, **chosen, "scale": scale, "anchor": "node",
                      "position": [Fraction(a - b, 65536) for a, b in zip(own, above)], **thing,
                      **(_motion(part, scale) if part.is_turned else {})})
    return found


def moved_points(played, mesh):
    """Points that moving parts reach, in the mesh's units: the corners of their boxes in some frames."""
    found = []
    for part in played.parts:
        if part.pose is None:
            continue
        used = {corner for number in mesh.numbers_of(part.groups, part.without) for corner in mesh.faces[number]}
        points = np.array([mesh.vertices[corner] for corner in used], dtype=float) / UNIT
        low, high = points.min(axis=0), points.max(axis=0)
        corners = np.array([[(low, high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)])
        some = part.pose[::max(1, len(part.pose) // 60)]
        found.append((corners @ some[:, :, :3].transpose(0, 2, 1) + some[:, None, :, 3]).reshape(-1, 3))
    return np.concatenate(found) if found else np.zeros((0, 3))
