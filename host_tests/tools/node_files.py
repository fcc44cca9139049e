# SPDX-License-Identifier: MIT
"""glTF files of several nodes made by hand, with animations, skins, lights and cameras."""

import numpy

from model_files import glb

CORNERS = [(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]
SIDES = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]
_KINDS = {"<f4": 5126, "<u2": 5123, "<u1": 5121, "<i2": 5122}


class File:
    """Collects the parts of a file; nodes are written as in JSON."""

    def __init__(self, *nodes, roots=None, **more):
        self.blob, self.data = b"", {"asset": {"version": "2.0"}, "scene": 0, "nodes": list(nodes), "meshes": [], "materials": [], "accessors": [],
                                     "bufferViews": [], "scenes": [{"nodes": roots or [0]}], **more}

    def add(self, rows, component, kind, **more):
        """The number of an accessor of these values."""
        packed = numpy.array(rows, dtype=component).tobytes()
        self.data["bufferViews"].append({"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(packed)})
        self.data["accessors"].append({"bufferView": len(self.data["bufferViews"]) - 1, "count": len(rows), "type": kind,
                                       "componentType": _KINDS[component], **more})
        self.blob += packed + b"\0" * (-len(packed) % 4)
        return len(self.data["accessors"]) - 1

    def box(self, size=(1, 1, 1), colour=(1, 1, 1, 1), middle=(0, 0, 0), name=None, **attributes):
        """The number of a mesh: a box of a material of its own."""
        points = [[c * s + m for c, s, m in zip(corner, size, middle)] for corner in CORNERS]
        self.data["materials"].append({"pbrMetallicRoughness": {"baseColorFactor": list(colour)}})
        part = {"attributes": {"POSITION": self.add(points, "<f4", "VEC3"), **attributes}, "material": len(self.data["materials"]) - 1,
                "indices": self.add(numpy.array(SIDES).ravel(), "<u2", "SCALAR")}
        self.data["meshes"].append({"primitives": [part], **({"name": name} if name else {})})
        return len(self.data["meshes"]) - 1

    def animate(self, *tracks, name=None):
        """An animation of (node, path, times, values[, interpolation])."""
        made = {"channels": [], "samplers": [], **({"name": name} if name else {})}
        for node, path, times, values, *mode in tracks:
            kind = "VEC4" if path == "rotation" else "VEC3"
            made["samplers"].append({"input": self.add(times, "<f4", "SCALAR"), "output": self.add(values, "<f4", kind),
                                     **({"interpolation": mode[0]} if mode else {})})
            made["channels"].append({"sampler": len(made["samplers"]) - 1, "target": {"node": node, "path": path}})
        self.data.setdefault("animations", []).append(made)

    def write(self, path):
        """Writes a GLB file and answers its path."""
        self.data["buffers"] = [{"byteLength": len(self.blob)}]
        path.write_bytes(glb({key: value for key, value in self.data.items() if value != []}, self.blob))
        return path


def about_x(degrees):
    """The quaternion of a turn about x."""
    half = numpy.radians(degrees) / 2
    return [float(numpy.sin(half)), 0, 0, float(numpy.cos(half))]


WHEELS = {"wheel fl": (-1.1, 1.3), "wheel fr": (1.1, 1.3), "wheel bl": (-1.1, -1.3), "wheel br": (1.1, -1.3)}


def car(turns=True):
    """A car of nine nodes: a body with a cabin, a bonnet, two lamps and four wheels, which turn once in two seconds."""
    made = File({"name": "body", "mesh": 0, "children": list(range(1, 9))}, {"name": "cabin", "mesh": 1, "translation": [0, 0.65, -0.2]},
                {"name": "bonnet", "mesh": 2, "translation": [0, 0.35, 1.4]}, {"name": "lamp", "mesh": 3, "translation": [-0.7, 0, 2.05]},
                {"name": "lamp", "mesh": 3, "translation": [0.7, 0, 2.05]},
                *({"name": name, "mesh": 4, "translation": [x, -0.4, z]} for name, (x, z) in WHEELS.items()))
    for size, colour in (((2, 0.6, 4), (0.8, 0.1, 0.1, 1)), ((1.6, 0.7, 2), (0.3, 0.5, 0.9, 1)), ((1.6, 0.1, 1), (0.9, 0.3, 0.1, 1)),
                         ((0.3, 0.2, 0.1), (1, 1, 0.7, 1)), ((0.3, 0.9, 0.9), (0.05, 0.05, 0.05, 1))):
        made.box(size, colour)
    if turns:
        made.animate(*((node, "rotation", [0, 0.5, 1, 1.5, 2], list(map(about_x, range(0, 361, 90)))) for node in range(5, 9)),
                     (0, "translation", [0, 1, 2], [(0, 0, 0), (0, 0.4, 0), (0, 0, 0)]), name="drive")
    return made
