# SPDX-License-Identifier: MIT
"""How large the textures of a scene need be for what its path shows: a texture with two texels a pixel or more, wherever it
is seen, may have half as many.

The measure is a bound: a face that looks away or that another one hides counts as seen, and each face as if it looked at
the eye. Nine tenths of the area that shows a texture have at least a texel a pixel; what is stretched over the rest may
have less."""

import math

import numpy as np

from fixel.image import image

POSES_MAX = 64      # of a path that are looked at
PART = 0.1          # of the area, which may have less than a texel a pixel
_UNIT = 65536


def _poses(scene):
    """(eyes, ways that they look) in world units; None for a path of strides, which only a player walks."""
    if scene.path_kind != image.POSES:
        return None
    step = -(-len(scene.path) // POSES_MAX)
    poses = np.array(scene.path[::step], dtype=float)
    yaw, pitch = (poses[:, i] * (2 * math.pi / 2 ** 32) for i in (3, 4))
    return poses[:, :3] / _UNIT, np.stack([np.sin(yaw) * np.cos(pitch), np.sin(pitch), np.cos(yaw) * np.cos(pitch)], axis=1)


def _slopes(points, texels):
    """Of faces, (count, 3 corners, 3) and (count, 3, 2): texels a world unit along u and along v, and the areas."""
    one, two = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
    along, across = texels[:, 1] - texels[:, 0], texels[:, 2] - texels[:, 0]
    a, b, c = (one * one).sum(1), (one * two).sum(1), (two * two).sum(1)
    square = np.maximum(a * c - b * b, 1e-30)
    # The gradient in the face's plane of what is p at the one corner and q at the other.
    found = [np.sqrt(np.maximum(c * p * p - 2 * b * p * q + a * q * q, 0) / square) for p, q in zip(along.T, across.T)]
    return np.stack(found, axis=1), np.sqrt(square) / 2


def _nearest(scene, corners, firsts, poses):
    """Of faces the least depth of a corner where a pose may see them, in world units; infinity for those that none sees.
    corners: of all faces in turn; firsts: the first of each."""
    eyes, ways = poses
    across = math.tan(scene.fov * math.pi / 2 ** 32) * math.hypot(1, scene.height / scene.width)
    counts = np.diff([*firsts, len(corners)])
    centres = np.add.reduceat(corners, firsts) / counts[:, None]
    radii = np.maximum.reduceat(np.sqrt(((corners - np.repeat(centres, counts, axis=0)) ** 2).sum(1)), firsts)
    least, near = np.full(len(firsts), np.inf), scene.near / _UNIT
    for eye, way in zip(eyes, ways):
        apart = centres - eye
        depth = apart @ way
        aside = np.sqrt(np.maximum((apart * apart).sum(1) - depth * depth, 0))
        seen = (depth + radii > near) & (aside - radii <= across * (depth + radii))
        closest = np.maximum(np.minimum.reduceat((corners - eye) @ way, firsts), near)
        least = np.where(seen, np.minimum(least, closest), least)
    return least


def _faces(scene):
    """{number of a texture: (corners of its faces, three of each, which have these texels)} in 1/65536; None for one on what turns
    or moves."""
    found, still = {}, len(scene.objects) - len(scene.placements)
    for number, item in enumerate(scene.objects):
        model = scene.models[item.model]
        for face in model.faces:
            if face.mapped is None or not (texture := scene.surfaces.surfaces[face.mapped.surface].texture):
                continue
            if number >= still:
                found[texture] = None
            elif found.setdefault(texture, ([], [], [])) is not None:
                corners, threes, texels = found[texture]
                corners.append([[c + o for c, o in zip(model.vertices[v], item.centre)] for v in face.corners])
                threes.append([model.vertices[v] for v in face.mapped.vertices])
                texels.append(face.mapped.texels)
    return found


def _least(values, areas):
    """The value that is reached over all but PART of the area."""
    order = np.argsort(values)
    return values[order][np.searchsorted(np.cumsum(areas[order]), PART * areas.sum())]


def needed(scene):
    """{number of a texture from 1: (width, height) that it need have}: those of the scene or a power of two less."""
    if scene.surfaces is None or not scene.surfaces.textures:
        return {}
    poses, focal, result = _poses(scene), scene.width / 2 / math.tan(scene.fov * math.pi / 2 ** 32), {}
    for number, faces in _faces(scene).items():
        texture = scene.surfaces.textures[number - 1]
        sides = [1 << texture.log_width, 1 << texture.log_height]
        if faces is not None and poses is not None:
            slopes, areas = _slopes(*(np.array(each, dtype=float) / _UNIT for each in faces[1:]))
            counts = np.array([len(each) for each in faces[0]])
            corners = np.array([corner for each in faces[0] for corner in each], dtype=float) / _UNIT
            depths = _nearest(scene, corners, np.cumsum(counts) - counts, poses)
            for axis in range(2):
                ratio = _least(slopes[:, axis] * depths / focal, areas)     # texels a pixel
                while ratio >= 2 and sides[axis] > 1:
                    ratio, sides[axis] = ratio / 2, sides[axis] // 2
        result[number] = tuple(sides)
    return result
