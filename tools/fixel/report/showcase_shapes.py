# SPDX-License-Identifier: MIT
"""Shapes, images and files (OBJ with MTL, STL, PLY, GLB) of the showcase's models. A shape is (points, triangles, uvs): arrays of (n, 3), (m, 3), (n, 2); x to the
right, y up, z towards the front, triangles counter-clockwise."""

import io
import json
import math
import struct

import numpy as np
from PIL import Image


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


def image_bytes(pixels, kind="PNG", **more):
    """An image file's bytes."""
    out = io.BytesIO()
    Image.fromarray(pixels).save(out, kind, **more)
    return out.getvalue()


def obj(folder, name, parts, materials="", head="", digits=5):
    """An OBJ file of [(statements before its faces, shape)], and its MTL file's text."""
    lines, count = [head + (f"mtllib {name}.mtl" if materials else "")], 0
    for statements, (points, triangles, uvs) in parts:
        text = io.StringIO()
        np.savetxt(text, points, f"v %.{digits}f %.{digits}f %.{digits}f")
        np.savetxt(text, np.stack([uvs[:, 0], 1 - uvs[:, 1]], axis=1), f"vt %.{digits}f %.{digits}f")
        text.write(statements + "\n")
        np.savetxt(text, np.repeat(triangles + count + 1, 2, axis=1), "f %d/%d %d/%d %d/%d")
        lines.append(text.getvalue())
        count += len(points)
    (folder / f"{name}.obj").write_text("\n".join(lines))
    if materials:
        (folder / f"{name}.mtl").write_text(materials)


def stl(folder, name, shape, colours=None):
    """A binary STL file, z upward; colours: of each triangle, red, green, blue of 0..31."""
    points, triangles, _ = shape
    rows = np.zeros(len(triangles), np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]))
    rows["corners"] = (points * (1, 1, -1))[:, [0, 2, 1]][triangles]
    if colours is not None:
        red, green, blue = np.asarray(colours).T
        rows["attribute"] = 0x8000 | red << 10 | green << 5 | blue
    (folder / f"{name}.stl").write_bytes(b"showcase".ljust(80) + struct.pack("<I", len(rows)) + rows.tobytes())


def ply(folder, name, shape, colours):
    """A binary PLY file with colours of vertices."""
    points, triangles, _ = shape
    head = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n" + \
        "".join(f"property float {axis}\n" for axis in "xyz") + "".join(f"property uchar {c}\n" for c in ("red", "green", "blue")) + \
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    vertices = np.zeros(len(points), np.dtype([("place", "<f4", 3), ("colour", "u1", 3)]))
    vertices["place"], vertices["colour"] = points, colours
    faces = np.zeros(len(triangles), np.dtype([("count", "u1"), ("corners", "<i4", 3)]))
    faces["count"], faces["corners"] = 3, triangles
    (folder / f"{name}.ply").write_bytes(head.encode() + vertices.tobytes() + faces.tobytes())


def ply_tables(folder, name, shape, colours):
    """A text PLY file with colours of faces."""
    points, triangles, _ = shape
    lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}", *(f"property float {axis}" for axis in "xyz"),
             f"element face {len(triangles)}", "property list uchar int vertex_index",
             *(f"property uchar {c}" for c in ("red", "green", "blue")), "end_header"]
    lines += [f"{x:.5f} {y:.5f} {z:.5f}" for x, y, z in points]
    lines += [f"3 {a} {b} {c} {red} {green} {blue}" for (a, b, c), (red, green, blue) in zip(triangles, colours)]
    (folder / f"{name}.ply").write_text("\n".join(lines) + "\n")


class Gltf:
    """Builds a GLB file."""

    def __init__(self):
        self.blob, self.data = b"", {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [],
                                     "accessors": [], "bufferViews": []}

    def _view(self, data):
        self.data["bufferViews"].append({"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data)})
        self.blob += data + bytes(-len(data) % 4)
        return len(self.data["bufferViews"]) - 1

    def accessor(self, rows, kind, component="<f4", **more):
        """The number of a table of numbers."""
        rows = np.ascontiguousarray(rows, dtype=component)
        codes = {"<f4": 5126, "<u4": 5125, "<u2": 5123, "u1": 5121, "<i2": 5122}
        ends = {"min": [float(x) for x in np.atleast_1d(rows.min(axis=0))], "max": [float(x) for x in np.atleast_1d(rows.max(axis=0))]}
        self.data["accessors"].append({"bufferView": self._view(rows.tobytes()), "count": len(rows), "type": kind,
                                       "componentType": codes[component], **ends, **more})
        return len(self.data["accessors"]) - 1

    def texture(self, blob, kind="image/png", **sampler):
        """The number of a texture with an image."""
        self.data.setdefault("images", []).append({"bufferView": self._view(blob), "mimeType": kind})
        texture = {"source": len(self.data["images"]) - 1}
        if sampler:
            self.data.setdefault("samplers", []).append(sampler)
            texture["sampler"] = len(self.data["samplers"]) - 1
        self.data.setdefault("textures", []).append(texture)
        return len(self.data["textures"]) - 1

    def material(self, name, colour=(1, 1, 1, 1), texture=None, transform=None, **more):
        """The number of a material."""
        base = {"baseColorFactor": list(colour), "metallicFactor": 0}
        if texture is not None:
            base["baseColorTexture"] = {"index": texture, **({"extensions": {"KHR_texture_transform": transform}} if transform else {})}
        self.data.setdefault("materials", []).append({"name": name, "pbrMetallicRoughness": base, **more})
        return len(self.data["materials"]) - 1

    def mesh(self, name, *parts):
        """The number of a mesh of (shape, material, more attributes as numbers of accessors)."""
        primitives = []
        for (points, triangles, uvs), material, *more in parts:
            primitives.append({"attributes": {"POSITION": self.accessor(points, "VEC3"), "TEXCOORD_0": self.accessor(uvs, "VEC2"),
                                              **(more[0] if more else {})},
                               "indices": self.accessor(np.asarray(triangles).ravel(), "SCALAR", "<u4"), "material": material})
        self.data["meshes"].append({"name": name, "primitives": primitives})
        return len(self.data["meshes"]) - 1

    def node(self, name, mesh=None, parent=None, **more):
        """The number of a node."""
        self.data["nodes"].append({"name": name, **({} if mesh is None else {"mesh": mesh}), **more})
        number = len(self.data["nodes"]) - 1
        above = self.data["scenes"][0]["nodes"] if parent is None else self.data["nodes"][parent].setdefault("children", [])
        above.append(number)
        return number

    def spin(self, nodes, seconds, axis, steps=8):
        """An animation that turns nodes once: {node: how often}."""
        times, samplers, channels = self.accessor(np.linspace(0, seconds, steps + 1), "SCALAR"), [], []
        for node, turns in nodes.items():
            halves = np.pi * turns * np.linspace(0, 1, steps + 1)
            rows = np.concatenate([np.sin(halves)[:, None] * np.array(axis), np.cos(halves)[:, None]], axis=1)
            samplers.append({"input": times, "output": self.accessor(rows, "VEC4"), "interpolation": "LINEAR"})
            channels.append({"sampler": len(samplers) - 1, "target": {"node": node, "path": "rotation"}})
        self.data.setdefault("animations", []).append({"name": "spin", "samplers": samplers, "channels": channels})

    def write(self, folder, name, *extensions, required=()):
        """The file."""
        data = {**self.data, "buffers": [{"byteLength": len(self.blob)}]}
        used = sorted({*extensions, *required})
        data |= {"extensionsUsed": used} if used else {}
        data |= {"extensionsRequired": list(required)} if required else {}
        text = json.dumps(data).encode()
        text += b" " * (-len(text) % 4)
        blob = self.blob + bytes(-len(self.blob) % 4)
        parts = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(blob), 0x004E4942) + blob
        (folder / f"{name}.glb").write_bytes(struct.pack("<4sII", b"glTF", 2, 12 + len(parts)) + parts)
