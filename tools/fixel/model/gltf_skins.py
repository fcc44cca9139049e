# SPDX-License-Identifier: MIT
"""Skins of glTF: where the vertices of a mesh stand that hang on joints, and on which joint each face hangs the most.

The vertices stand as glTF has it without an animation: each is the mean, by its weights, of where its joints place it. In an
animation each face moves with one joint, as on the PlayStation: a board turns and scales instances, and bends nothing."""

from dataclasses import dataclass

import numpy as np

from fixel.base.errors import ToolError
from fixel.model import gltf_check

SETS_MAX = 4        # of joints of a vertex, four each
WHOLE = 0.999       # of a vertex's weights: of a joint on which it hangs alone
_AT_ONCE = 1 << 14  # vertices or faces
_TIE = 1e-6         # of a corner's weight: joints whose weights of a face differ by no more are equal


@dataclass
class Part:
    """A primitive that hangs on joints. nodes: the number of each joint's node. matrices: of 4x4, from the mesh to where each
    joint places it. joints, weights: a row a vertex, whose weights are 1 together."""
    nodes: object
    matrices: object
    joints: object
    weights: object

    def _blended(self, first):
        """The matrices of 3x4 of _AT_ONCE vertices."""
        rows = slice(first, first + _AT_ONCE)
        return np.einsum("vk,vkij->vij", self.weights[rows], self.matrices[self.joints[rows], :3])

    def points(self, points):
        """The vertices where their joints place them."""
        placed = [(blended[:, :, :3] @ points[first:first + _AT_ONCE, :, None])[:, :, 0] + blended[:, :, 3]
                  for first in range(0, len(points), _AT_ONCE) for blended in (self._blended(first),)]
        return np.concatenate(placed) if placed else points

    def directions(self, values):
        """The normals of the vertices, of any length: by the cofactors of the matrices, which are there for flat ones too."""
        turned = []
        for first in range(0, len(values), _AT_ONCE):
            a, b, c = self._blended(first)[:, :, :3].transpose(2, 0, 1)
            cofactors = np.stack([np.cross(b, c), np.cross(c, a), np.cross(a, b)], axis=2)
            side = np.sign((a * cofactors[:, :, 0]).sum(axis=1))[:, None]
            turned.append(side * (cofactors @ values[first:first + _AT_ONCE, :, None])[:, :, 0])
        return np.concatenate(turned) if turned else values

    def owners(self, triangles):
        """(the place of each face's joint, whether each face hangs on it alone). A face hangs on the joint with the largest sum of its
        corners' weights, and of equal ones on the first."""
        found, alone = [], []
        for first in range(0, len(triangles), _AT_ONCE):
            some = triangles[first:first + _AT_ONCE]
            joints, weights = (table[some].reshape(len(some), -1) for table in (self.joints, self.weights))
            sums = np.array([(weights * (joints == column[:, None])).sum(axis=1) for column in joints.T]).T
            most = sums.max(axis=1, keepdims=True)
            found.append(np.where(sums >= most - _TIE, joints, len(self.nodes)).min(axis=1))
            alone.append(most[:, 0] >= WHOLE * weights.sum(axis=1))
        return (np.concatenate(found), np.concatenate(alone)) if found else (np.zeros(0, int), np.zeros(0, bool))

    def mirrors(self, places):
        """Of places of joints, whether each mirrors the mesh."""
        return (np.linalg.det(self.matrices[:, :3, :3]) < 0)[places]


def joints_of(checked, node, where):
    """The numbers of the nodes of a node's joints, as they are written."""
    _, skin = checked.entry("skins", node, "skin", where)
    joints = skin.get("joints")
    if not isinstance(joints, list) or not joints or not all(isinstance(each, int) and not isinstance(each, bool) for each in joints):
        checked.fail(where, "joints must be a list of numbers of nodes: the file is damaged")
    return joints


def _binds(checked, node, count, where):
    """The matrices of 4x4 from the mesh to each joint."""
    _, skin = checked.entry("skins", node, "skin", where)
    if "inverseBindMatrices" not in skin:
        return np.repeat(np.eye(4)[None], count, axis=0)
    rows = checked.accessor(skin["inverseBindMatrices"], where, ("MAT4",), (gltf_check.FLOAT,))
    if len(rows) < count or not np.isfinite(rows).all():
        checked.fail(where, "inverseBindMatrices has fewer than joints: the file is damaged")
    found = rows[:count].reshape(-1, 4, 4).transpose(0, 2, 1)
    if (np.abs(np.linalg.det(found[:, :3, :3])) < 1e-12).any():
        checked.fail(where, "inverseBindMatrices has one without a size: the file is damaged")
    return found


def _weights(checked, attributes, joint_count, where):
    """(joints, weights) of the vertices of a primitive, a row each."""
    sets = [number for number in range(SETS_MAX) if f"JOINTS_{number}" in attributes and f"WEIGHTS_{number}" in attributes]
    if not sets or f"JOINTS_{SETS_MAX}" in attributes:
        checked.fail(where, "its vertices name no joints, or too many")
    joints, weights = ([checked.accessor(attributes[f"{key}_{number}"], where, ("VEC4",), components) for number in sets]
                       for key, components in (("JOINTS", (5121, 5123)), ("WEIGHTS", (gltf_check.FLOAT, 5121, 5123))))
    if {len(rows) for rows in joints + weights} != {checked.count(attributes.get("POSITION"), where)}:
        checked.fail(where, "it has not as many joints and weights as vertices: the file is damaged")
    joints, weights = np.hstack(joints).astype(int), np.hstack(weights).astype(float)
    if not (np.isfinite(weights).all() and (weights >= 0).all() and (joints[weights > 0] < joint_count).all()):
        checked.fail(where, "its vertices name joints that the skin has not, or weights below 0: the file is damaged")
    sums = weights.sum(axis=1, keepdims=True)
    weights[:, 0] += sums[:, 0] == 0        # a vertex without weights hangs on its first joint
    return np.minimum(joints, joint_count - 1), weights / np.where(sums > 0, sums, 1)


def read(checked, node, parts, worlds, where):
    """The Part of each primitive of a node with a skin; None where one of them is damaged, or a joint stands outside of the scene: such
    a mesh is shown in the pose in which it was bound. worlds: {number of a node: its matrix of 4x4 in the scene}."""
    try:
        nodes = joints_of(checked, node, where)
        binds = _binds(checked, node, len(nodes), where)
        if not all(each in worlds for each in nodes):
            return None
        matrices = np.array([worlds[each] for each in nodes]) @ binds
        return [Part(nodes, matrices, *_weights(checked, part["attributes"] if isinstance(part.get("attributes"), dict) else {}, len(nodes), where))
                for part in parts]
    except ToolError:
        return None
