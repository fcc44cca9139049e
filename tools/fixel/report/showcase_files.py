# SPDX-License-Identifier: MIT
"""Writes the showcase's models: OBJ with MTL, STL, PLY and GLB files, and their images."""

import io
import json
import struct

import numpy as np
from PIL import Image


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
