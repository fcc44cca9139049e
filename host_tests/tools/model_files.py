# SPDX-License-Identifier: MIT
"""Model and scene files made by hand, for the tests of their readers: glTF files of one node, or of several, with animations, skins, lights and
cameras, other formats, and scene files, compiled."""

import base64
import io
import json
import math
import struct

import numpy
import pytest
from PIL import Image

from fixel.base.errors import ToolError
from fixel.image import image
from fixel.scene import toml_scene

TETRAHEDRON = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
SQUARE = ([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])


def assert_refused(read, folder, data, words, most=300):
    """That a reader refuses a file in one short sentence that begins with the file and has these words."""
    with pytest.raises(ToolError) as caught:
        read(folder, data)
    text = str(caught.value)
    assert text.startswith("model.") and len(text) < most and text.isprintable()
    for word in words:
        assert word in text


def png(pixels):
    """Rows of red, green, blue as a PNG file's bytes."""
    out = io.BytesIO()
    Image.fromarray(numpy.array(pixels, dtype=numpy.uint8)).save(out, "PNG")
    return out.getvalue()


def gltf(points=SQUARE[0], triangles=SQUARE[1], uvs=None, colours=None, image=None, material=None, nodes=None):
    """(JSON as plain data, binary part) of a mesh; the binary part's buffer has no uri."""
    blob, views, accessors = b"", [], []

    def add(rows, component, kind, **more):
        nonlocal blob
        packed = numpy.array(rows, dtype=component).tobytes()
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(packed)})
        accessors.append({"bufferView": len(views) - 1, "count": len(rows), "type": kind,
                          "componentType": {"<f4": 5126, "<u2": 5123, "<u1": 5121}[component], **more})
        blob += packed + b"\0" * (-len(packed) % 4)
        return len(accessors) - 1

    part = {"attributes": {"POSITION": add(points, "<f4", "VEC3")},
            "indices": add([corner for three in triangles for corner in three], "<u2", "SCALAR")}
    if uvs is not None:
        part["attributes"]["TEXCOORD_0"] = add(uvs, "<f4", "VEC2")
    if colours is not None:
        part["attributes"]["COLOR_0"] = add(colours, "<u1", "VEC4", normalized=True)
    data = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": nodes or [{"mesh": 0, "name": "thing"}], "meshes": [{"primitives": [part]}],
            "accessors": accessors, "bufferViews": views}
    if material is not None or image is not None:
        part["material"] = 0
        base = dict(material or {})
        if image is not None:
            views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(image)})
            blob += image + b"\0" * (-len(image) % 4)
            data["images"], data["textures"] = [{"bufferView": len(views) - 1, "mimeType": "image/png"}], [{"source": 0}]
            base["baseColorTexture"] = {"index": 0}
        data["materials"] = [{"name": "paint", "pbrMetallicRoughness": base}]
    data["buffers"] = [{"byteLength": len(blob)}]
    return data, blob


def glb(data, blob):
    """A GLB file's bytes."""
    text = json.dumps(data).encode()
    text += b" " * (-len(text) % 4)
    parts = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(blob), 0x004E4942) + blob
    return struct.pack("<4sII", b"glTF", 2, 12 + len(parts)) + parts


def gltf_text(data, blob):
    """A .gltf file's bytes, with the buffer in its text."""
    whole = {**data, "buffers": [{**data["buffers"][0],
                                  "uri": "data:application/octet-stream;base64," + base64.b64encode(blob).decode()}]}
    return json.dumps(whole).encode()


def stl(points=TETRAHEDRON[0], triangles=TETRAHEDRON[1]):
    """A binary STL file's bytes."""
    rows = b"".join(struct.pack("<3f9fH", 0, 0, 0, *(c for corner in three for c in points[corner]), 0)
                    for three in triangles)
    return b"made by hand".ljust(80, b"\0") + struct.pack("<I", len(triangles)) + rows


def stl_text(points=TETRAHEDRON[0], triangles=TETRAHEDRON[1]):
    """A text STL file's bytes."""
    lines = ["solid thing"]
    for three in triangles:
        lines += ["facet normal 0 0 0", "outer loop", *(f"vertex {x} {y} {z}" for x, y, z in (points[c] for c in three)),
                  "endloop", "endfacet"]
    return "\n".join([*lines, "endsolid thing", ""]).encode()


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


class Limbs:
    """Collects tubes of four sides whose corners hang on joints, as one mesh."""

    def __init__(self):
        self.points, self.triangles, self.joints, self.weights = [], [], [], []

    def add(self, axis, *rings):
        """A tube along an axis. rings: (middle, half a side, {joint: weight}) of each."""
        first, across = len(self.points), [each for each in range(3) if each != axis]
        for middle, half, shares in rings:
            for one, other in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                point = list(middle)
                point[across[0]] += one * half
                point[across[1]] += other * half
                self.points.append(point)
                self.joints.append([*shares, *[0] * (4 - len(shares))])
                self.weights.append([*shares.values(), *[0] * (4 - len(shares))])
        for ring in range(first, len(self.points) - 4, 4):
            for a, b in ((0, 1), (1, 2), (2, 3), (3, 0)):
                self._outward([ring + a, ring + b, ring + 4 + b, ring + 4 + a], numpy.mean(self.points[ring:ring + 8], axis=0))
        for ring in (first, len(self.points) - 4):
            self._outward([ring, ring + 1, ring + 2, ring + 3], numpy.mean(self.points[first:], axis=0))

    def _outward(self, corners, middle):
        """Two triangles of a square that looks away from a point."""
        a, b, c = (numpy.array(self.points[corner]) for corner in corners[:3])
        if numpy.dot(numpy.cross(b - a, c - a), a - middle) < 0:
            corners = corners[::-1]
        self.triangles += [corners[:3], [corners[0], corners[2], corners[3]]]

    def mesh(self, made, name, colour=(0.9, 0.6, 0.4, 1)):
        """The number of the mesh in a File."""
        made.data["materials"].append({"pbrMetallicRoughness": {"baseColorFactor": list(colour)}})
        made.data["meshes"].append({"name": name, "primitives": [{"material": len(made.data["materials"]) - 1, "attributes": {
            "POSITION": made.add(self.points, "<f4", "VEC3"), "JOINTS_0": made.add(self.joints, "<u1", "VEC4"),
            "WEIGHTS_0": made.add(self.weights, "<f4", "VEC4")}, "indices": made.add(numpy.array(self.triangles).ravel(), "<u2", "SCALAR")}]})
        return len(made.data["meshes"]) - 1


def binds(made, places):
    """The number of the accessor of inverseBindMatrices of joints that stood at these places when the mesh was bound, unturned."""
    found = [numpy.eye(4) for _ in places]
    for matrix, place in zip(found, places):
        matrix[:3, 3] = [-c for c in place]
    return made.add([matrix.T.ravel() for matrix in found], "<f4", "MAT4")


# Joints of a biped: parent, and place in it. It looks along z.
BONES = {"hips": (None, (0, 2, 0)), "chest": ("hips", (0, 0.7, 0)), "head": ("chest", (0, 0.7, 0)),
         **{f"{part} {side}": (above, (sign * x, y, z)) for side, sign in (("left", 1), ("right", -1))
            for part, above, x, y, z in (("thigh", "hips", 0.3, -0.1, 0), ("shin", f"thigh {side}", 0, -0.9, 0), ("arm", "chest", 0.5, 0.5, 0),
                                         ("hand", f"arm {side}", 0, -0.7, 0))}}


def places_of(bones):
    """Where joints stand in the file."""
    found = {}
    for name, (above, place) in bones.items():
        found[name] = numpy.array(place) + (found[above] if above else 0)
    return found


def biped(bends=True, steps=True):
    """A figure of one mesh with soft weights at knees, elbows and neck, and a hat, a mesh of the head's node. It walks: two seconds,
    with the hips going up and down."""
    numbers, places = {name: number for number, name in enumerate(BONES)}, places_of(BONES)
    nodes = [{"name": name, "translation": list(place)} for name, (_, place) in BONES.items()]
    for name, (above, _) in BONES.items():
        if above:
            nodes[numbers[above]].setdefault("children", []).append(numbers[name])
    made, limbs = File(*nodes), Limbs()

    def tube(top, below, half, length, axis=1):
        """Along y, from a joint down past the next one, which takes its part of the weights around it."""
        a, b = numbers[top], numbers[below]
        x, y, z = places[top]
        knee = y - places[below][1]
        half_way = {a: 0.5, b: 0.5} if bends else {a: 1}
        limbs.add(axis, ((x, y, z), half, {a: 1}), ((x, y - knee + 0.15, z), half, {a: 1}), ((x, y - knee, z), half, half_way),
                  ((x, y - knee - 0.15, z), half, {b: 1}), ((x, y - knee - length, z), half, {b: 1}))
    limbs.add(1, ((0, 1.8, 0), 0.4, {numbers["hips"]: 1}), ((0, 2.6, 0), 0.4, {numbers["hips"]: 0.5, numbers["chest"]: 0.5}),
              ((0, 3.3, 0), 0.45, {numbers["chest"]: 1}))
    limbs.add(1, ((0, 3.3, 0), 0.15, {numbers["chest"]: 0.6, numbers["head"]: 0.4}), ((0, 3.4, 0), 0.28, {numbers["head"]: 1}),
              ((0, 3.9, 0), 0.28, {numbers["head"]: 1}))
    for side in ("left", "right"):
        tube(f"thigh {side}", f"shin {side}", 0.18, 0.9)
        tube(f"arm {side}", f"hand {side}", 0.13, 0.6)
    made.data["nodes"].append({"name": "figure", "mesh": limbs.mesh(made, "body"), "skin": 0, "translation": [50, 50, 50]})
    made.data["scenes"][0]["nodes"].append(len(made.data["nodes"]) - 1)
    made.data["nodes"].append({"name": "hat", "mesh": made.box((0.7, 0.3, 0.7), (0.2, 0.3, 0.9, 1)), "translation": [0, 0.65, 0]})
    made.data["nodes"][numbers["head"]].setdefault("children", []).append(len(made.data["nodes"]) - 1)
    made.data["skins"] = [{"joints": list(numbers.values()), "inverseBindMatrices": binds(made, [places[name] for name in BONES])}]
    if steps:
        times, waves = [0, 0.5, 1, 1.5, 2], numpy.sin(numpy.linspace(0, 2 * math.pi, 5))
        made.animate(*((numbers[f"{part} {side}"], "rotation", times, [about_x(size * sign * wave + rest) for wave in waves])
                       for side, sign in (("left", 1), ("right", -1)) for part, size, rest in (("thigh", -35, 0), ("shin", 30, 30), ("arm", 30, 0),
                                                                                              ("hand", -20, -20))),
                     (numbers["hips"], "translation", times, [(0, 2 + 0.05 * abs(wave), 0) for wave in waves]), name="walk")
    return made


PATH = "[path]\nkeys = [{ position = [0, 0, 0] }]\n"


def build(folder, text):
    """The scene of a text, with a path of one pose; its image holds all of it."""
    file = folder / "scene.toml"
    file.write_text(text + PATH)
    scene, _ = toml_scene.compile_file(str(file))
    assert image.unpack(image.pack(scene)) == scene
    return scene
