# SPDX-License-Identifier: MIT
"""Model files made by hand, for the tests of their readers."""

import base64
import io
import json
import struct

import numpy
import pytest
from PIL import Image

from fixel.base.errors import ToolError

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
