# SPDX-License-Identifier: MIT
"""Skins of glTF whose faces hang on one joint each: such a mesh is rigid parts, which move as their joints do."""

import numpy as np

from fixel.base.errors import ToolError
from fixel.model import gltf_check

SETS_MAX = 4        # of joints of a vertex, four each
WHOLE = 0.999       # of a vertex's weights: of a joint on which it hangs alone


def _joints(checked, node, shown, where):
    """(of each face its joint's number in the skin, the skin), or None. shown: (attributes, triangles) of each part."""
    _, skin = checked.entry("skins", node, "skin", where)
    found = []
    for attributes, triangles in shown:
        sets = [number for number in range(SETS_MAX) if f"JOINTS_{number}" in attributes and f"WEIGHTS_{number}" in attributes]
        if not sets or f"JOINTS_{SETS_MAX}" in attributes:
            return None
        joints, weights = ([checked.accessor(attributes[f"{key}_{number}"], where, ("VEC4",), components) for number in sets]
                           for key, components in (("JOINTS", (5121, 5123)), ("WEIGHTS", (gltf_check.FLOAT, 5121, 5123))))
        if len({len(rows) for rows in joints + weights}) > 1:
            return None
        joints, weights = np.hstack(joints), np.hstack(weights).astype(float)
        used = np.unique(triangles)
        if len(used) and used.max() >= len(joints):
            return None
        if not (weights[used].max(axis=1, initial=0) >= WHOLE * weights[used].sum(axis=1)).all():
            return None
        own = joints[np.arange(len(joints)), weights.argmax(axis=1)][triangles]
        if (own != own[:, :1]).any():
            return None
        found.append(own[:, 0])
    return (np.concatenate(found), skin) if found else None


def _bindings(checked, skin, where):
    """Of each joint of a skin (the number of its node, the matrix of 4x4 from the mesh to it)."""
    joints = skin.get("joints")
    if not isinstance(joints, list) or not all(isinstance(each, int) and not isinstance(each, bool) for each in joints):
        checked.fail(where, "joints must be a list of numbers of nodes: the file is damaged")
    if "inverseBindMatrices" not in skin:
        return [(joint, np.eye(4)) for joint in joints]
    rows = checked.accessor(skin["inverseBindMatrices"], where, ("MAT4",), (gltf_check.FLOAT,))
    if len(rows) < len(joints) or not np.isfinite(rows).all():
        checked.fail(where, "inverseBindMatrices has fewer than joints: the file is damaged")
    return [(joint, row.reshape(4, 4).T) for joint, row in zip(joints, rows)]


def rigid(checked, node, shown, where):
    """{number of a joint's node: (the matrix from the mesh to it, its faces, counted from the first of the node)}; None unless
    each face hangs on one joint. What is damaged is not rigid: such a mesh is shown in the pose in which it was bound."""
    try:
        found = _joints(checked, node, shown, where)
        if found is None:
            return None
        bindings, own = _bindings(checked, found[1], where), found[0]
    except ToolError:
        return None
    if len(own) and own.max() >= len(bindings):
        return None
    made = {}
    for number in np.unique(own).tolist():
        joint, matrix = bindings[number]
        if joint in made or abs(np.linalg.det(matrix[:3, :3])) < 1e-12:
            return None
        made[joint] = matrix, np.flatnonzero(own == number).tolist()
    return made
