# SPDX-License-Identifier: MIT
"""Shapes and images of the showcase's models. A shape is (points, triangles, uvs): arrays of (n, 3), (m, 3), (n, 2); x to the
right, y up, z towards the front, triangles counter-clockwise."""

import math

import numpy as np


def joined(*shapes):
    """Several shapes as one."""
    points, triangles, uvs, count = [], [], [], 0
    for own, threes, places in shapes:
        points.append(own)
        triangles.append(np.asarray(threes) + count)
        uvs.append(places)
        count += len(own)
    return np.concatenate(points), np.concatenate(triangles), np.concatenate(uvs)


def placed(shape, position=(0, 0, 0), scale=1, yaw=0, pitch=0):
    """A shape stretched, turned about x and then y, and moved. Angles in degrees."""
    points, triangles, uvs = shape
    a, b = math.radians(pitch), math.radians(yaw)
    about_x = np.array([[1, 0, 0], [0, math.cos(a), -math.sin(a)], [0, math.sin(a), math.cos(a)]])
    about_y = np.array([[math.cos(b), 0, math.sin(b)], [0, 1, 0], [-math.sin(b), 0, math.cos(b)]])
    return points * scale @ (about_y @ about_x).T + np.array(position), triangles, uvs


def flat(shape, uv):
    """A shape of which every corner is at one place of an image."""
    points, triangles, uvs = shape
    return points, triangles, np.tile(np.array(uv, dtype=float), (len(uvs), 1))


def box(width=1, height=1, depth=1):
    """A box on the ground, with the whole image on each side."""
    points, triangles, uvs = [], [], []
    for axis, sign in ((0, 1), (0, -1), (1, 1), (1, -1), (2, 1), (2, -1)):
        normal = np.eye(3)[axis] * sign
        up = np.array([0, 1, 0]) if axis != 1 else np.array([0, 0, -sign])
        right = np.cross(up, normal)
        first = len(points)
        for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
            points.append(normal / 2 + right * (u - 0.5) + up * (v - 0.5))
            uvs.append((u, 1 - v))
        triangles += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return np.array(points) * (width, height, depth) + (0, height / 2, 0), np.array(triangles), np.array(uvs, dtype=float)


def surface(function, across, along):
    """A grid over u and v of 0..1, of points function(u, v) of arrays; without cells that have no area."""
    u, v = (each.ravel() for each in np.meshgrid(np.linspace(0, 1, across + 1), np.linspace(0, 1, along + 1)))
    points = np.stack(function(u, v), axis=1)
    cells = np.arange(along)[:, None] * (across + 1) + np.arange(across)
    a, b, c, d = (each.ravel() for each in (cells, cells + 1, cells + across + 2, cells + across + 1))
    triangles = np.stack([a, d, c, a, c, b], axis=1).reshape(-1, 3)
    one, two, three = (points[triangles[:, i]] for i in range(3))
    return points, triangles[np.linalg.norm(np.cross(two - one, three - one), axis=1) > 1e-12], np.stack([u, v], axis=1)


def lathe(profile, sides=32):
    """A profile of (radius, height), from the top down, turned about y."""
    radii, heights = np.array(profile, dtype=float).T
    steps = np.linspace(0, 1, len(radii))

    def function(u, v):
        radius, angle = np.interp(v, steps, radii), 2 * np.pi * np.where(u == 1, 0, u)
        return radius * np.sin(angle), np.interp(v, steps, heights), radius * np.cos(angle)
    return surface(function, sides, len(radii) - 1)


def ball(radius=1, sides=24, rings=12):
    """A sphere."""
    angles = np.linspace(0, np.pi, rings + 1)
    return lathe(list(zip(np.where((angles == 0) | (angles == np.pi), 0, radius * np.sin(angles)), radius * np.cos(angles))), sides)


def wheel(radius=0.35, width=0.25, sides=20):
    """A drum about x."""
    made = lathe([(0, width / 2), (radius, width / 2), (radius, -width / 2), (0, -width / 2)], sides)
    points, triangles, uvs = made
    return points[:, [1, 0, 2]] * (1, -1, 1), triangles, uvs


def tube(centres, radius, sides=12):
    """A closed tube about a closed line of points."""
    count = len(centres)
    ahead = np.roll(centres, -1, axis=0) - np.roll(centres, 1, axis=0)
    ahead /= np.linalg.norm(ahead, axis=1)[:, None]
    side = np.zeros((count + 1, 3))
    side[0] = np.cross(ahead[0], (0.3, 1, 0.2))
    for number in range(count + 1):     # carried on, so that it does not turn about the line
        way = ahead[number % count]
        side[number] = side[max(number - 1, 0)] - way * (side[max(number - 1, 0)] @ way)
        side[number] /= np.linalg.norm(side[number])
    up = np.cross(side[:count], ahead)
    twist = np.arctan2(side[count] @ up[0], side[count] @ side[0]) / count      # what is left at the end, shared by all
    side = side[:count]

    def function(u, v):
        number = np.rint(v * count).astype(int) % count
        angle = 2 * np.pi * np.where(u == 1, 0, u) + twist * number
        ring = side[number] * np.cos(angle)[:, None] - up[number] * np.sin(angle)[:, None]
        return tuple((centres[number] + radius * ring).T)
    return surface(function, sides, count)


# --- images ----------------------------------------------------------------------------------

def noise(chance, side, cells):
    """Smooth noise of 0..1 that repeats: (side, side)."""
    grid = chance.random((cells, cells))
    places = np.arange(side) * cells / side
    low, part = places.astype(int), places % 1
    part, high = part * part * (3 - 2 * part), (low + 1) % cells
    rows = grid[low] * (1 - part)[:, None] + grid[high] * part[:, None]
    return rows[:, low] * (1 - part) + rows[:, high] * part


def clouds(chance, side, cells=4, octaves=4):
    """Noise of several sizes."""
    total = sum(noise(chance, side, cells << octave) / 2 ** octave for octave in range(octaves))
    return total / sum(0.5 ** octave for octave in range(octaves))


def mixed(one, other, part):
    """An image between two colours."""
    part = np.asarray(part)[..., None]
    return np.clip(np.array(one) * (1 - part) + np.array(other) * part, 0, 255).round().astype(np.uint8)


def planks(chance, side=256):
    """Boards with grain, in a frame."""
    y, x = np.mgrid[:side, :side]
    shade = chance.random(4)[y * 4 // side] * 0.4 + 0.5 * noise(chance, side, 8) + 0.1 * chance.random((side, side))
    image = mixed((120, 78, 40), (196, 146, 86), shade)
    image[(y % (side // 4)) < side // 64] = (60, 38, 20)
    frame = side // 10
    edge = np.minimum(np.minimum(x, y), side - 1 - np.maximum(x, y))
    image[edge < frame] = mixed((150, 104, 58), (190, 140, 84), noise(chance, side, 16))[edge < frame]
    image[(edge == frame) | (edge == frame - 1)] = (70, 44, 22)
    return image


def cloth(side=256):
    """Stripes one way, a dot and a corner of another colour, so that one sees how a face lies on it."""
    y, x = np.mgrid[:side, :side] / side
    image = mixed((232, 220, 190), (190, 60, 50), ((x * 3) % 1 < 0.5).astype(float))
    image[(x - 0.68) ** 2 + (y - 0.65) ** 2 < 0.03] = (40, 70, 130)
    image[(x < 0.3) & (y < 0.3)] = (240, 200, 60)
    return image
