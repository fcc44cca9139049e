# SPDX-License-Identifier: MIT
"""Large models as people have them: spheres, a terrain, many objects, many materials, concave faces, many nodes. Each
function writes the files of one into a folder and answers the file that a command takes."""

import math

import numpy as np
from PIL import Image

from model_files import glb


def sphere(meridians, rings):
    """(vertices, quads and triangles) of a sphere of meridians * rings faces."""
    around = np.arange(meridians) * 2 * np.pi / meridians
    down = np.arange(1, rings) * np.pi / rings
    points = np.stack([np.outer(np.sin(down), np.cos(around)), np.repeat(np.cos(down)[:, None], meridians, 1),
                       np.outer(np.sin(down), np.sin(around))], axis=2).reshape(-1, 3)
    top, low = len(points), len(points) + 1
    faces = []
    for ring in range(rings):
        for i in range(meridians):
            j, above, below = (i + 1) % meridians, (ring - 1) * meridians, ring * meridians
            if ring == 0:
                faces.append((top, j, i))
            elif ring == rings - 1:
                faces.append((low, above + i, above + j))
            else:
                faces.append((above + i, above + j, below + j, below + i))
    return np.vstack([points, [[0, 1, 0], [0, -1, 0]]]), faces


def triangles_of(faces):
    """The faces as triangles."""
    return np.array([(face[0], face[i], face[i + 1]) for face in faces for i in range(1, len(face) - 1)])


def _text(points, faces):
    rows = [f"v {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in points.tolist()]
    return "".join(rows + [f"f {' '.join(str(corner + 1) for corner in face)}\n" for face in faces])


def obj_file(folder, points, faces):
    """An OBJ file."""
    (folder / "model.obj").write_text(_text(points, faces))
    return folder / "model.obj"


def stl_file(folder, points, triangles):
    """A binary STL file."""
    records = np.zeros(len(triangles), np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]))
    records["corners"] = points[triangles]
    (folder / "model.stl").write_bytes(bytes(80) + len(triangles).to_bytes(4, "little") + records.tobytes())
    return folder / "model.stl"


def _mesh_data(points, triangles):
    """(JSON's data, binary part) of a glTF file with one mesh."""
    blob = points.astype("<f4").tobytes() + triangles.astype("<u4").tobytes()
    views = [{"buffer": 0, "byteOffset": 0, "byteLength": len(points) * 12},
             {"buffer": 0, "byteOffset": len(points) * 12, "byteLength": triangles.size * 4}]
    accessors = [{"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3"},
                 {"bufferView": 1, "componentType": 5125, "count": triangles.size, "type": "SCALAR"}]
    return {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}], "bufferViews": views,
            "accessors": accessors, "buffers": [{"byteLength": len(blob)}]}, blob


def glb_file(folder, points, triangles):
    """A GLB file."""
    (folder / "model.glb").write_bytes(glb(*_mesh_data(points, triangles)))
    return folder / "model.glb"


def sphere_file(folder, suffix, count):
    """A sphere of 40,000 or 65,535 faces. Of triangles a closed sphere has an even number: the larger one has a hole."""
    if suffix == "obj":
        return obj_file(folder, *sphere(*{40_000: (200, 200), 65_535: (257, 255)}[count]))
    points, faces = sphere(*{40_000: (125, 161), 65_535: (128, 257)}[count])
    triangles = triangles_of(faces)[:count]
    assert len(triangles) == count
    return {"stl": stl_file, "glb": glb_file}[suffix](folder, points, triangles)


def terrain(folder):
    """A terrain of 200,000 triangles, of which no two lie in one plane."""
    across, along = np.meshgrid(np.arange(401), np.arange(251))
    points = np.column_stack([across.ravel(), (8 * np.sin(across * 0.07) * np.cos(along * 0.05) + np.sin(across * 0.9 + along)).ravel(),
                              along.ravel()]).astype(float)
    first = (along[:-1, :-1] * 401 + across[:-1, :-1]).ravel()
    triangles = np.concatenate([np.column_stack([first, first + 401, first + 1]),
                                np.column_stack([first + 1, first + 401, first + 402])])
    assert len(triangles) == 200_000
    return obj_file(folder, points, triangles.tolist())


def many_objects(folder):
    """20,000 boxes, each an object of the file with a place, a size and a colour of its own."""
    chance = np.random.default_rng(7)
    places = chance.uniform(-200, 200, (20_000, 3)).round(2).tolist()
    colours = chance.integers(0, 1 << 24, 20_000).tolist()
    rows = [f'[[objects]]\nname = "box {i}"\nsolid = "box"\nposition = {place}\nscale = {1 + i % 8}\ncolour = "#{colour:06x}"\n'
            for i, (place, colour) in enumerate(zip(places, colours))]
    (folder / "scene.toml").write_text("[view]\nfar = 1000\n" + "".join(rows))
    return folder / "scene.toml"


def many_materials(folder):
    """200 materials with 40 images of 1024 x 1024, on a floor of 20 x 10 squares and as many walls."""
    y, x = np.mgrid[0:1024, 0:1024]
    for number in range(40):
        pixels = np.stack([(x >> 2) + number * 5, (y >> 2) ^ (x >> 3), np.full_like(x, 6 * number)], axis=2).astype(np.uint8)
        Image.fromarray(pixels).save(folder / f"image{number}.png", compress_level=1)
    (folder / "model.mtl").write_text("".join(f"newmtl m{i}\nKd {1 - i % 7 / 10} 1 {1 - i % 3 / 10}\nmap_Kd image{i % 40}.png\n"
                                              for i in range(200)))
    rows = ["mtllib model.mtl\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"]
    for i in range(200):
        column, row = i % 20, i // 20
        corners = [(column, 0, row), (column + 1, 0, row), (column + 1, 0, row + 1), (column, 0, row + 1)]
        rows += [f"v {a} {b} {c}\n" for a, b, c in corners] + [f"v {a} {c - row} {row}\n" for a, b, c in corners]
        rows.append(f"usemtl m{i}\n" + "".join(f"f {' '.join(f'{8 * i + k + j}/{j}' for j in range(1, 5))}\n" for k in (0, 4)))
    (folder / "model.obj").write_text("".join(rows))
    (folder / "scene.toml").write_text('[[objects]]\nmodel = "model.obj"\nimages = { levels = 4 }\nfit = 40\ntwo_sided = true\n')
    return folder / "scene.toml"


def concave_faces(folder):
    """Ten faces of 3,000 corners each: gears with teeth."""
    rows = []
    for number in range(10):
        rows += [f"v {(9 + i % 2) * math.cos(i * math.pi / 1500):.6f} {(9 + i % 2) * math.sin(i * math.pi / 1500):.6f} {number}\n"
                 for i in range(3000)]
    rows += [f"f {' '.join(str(3000 * number + i + 1) for i in range(3000))}\n" for number in range(10)]
    (folder / "model.obj").write_text("".join(rows))
    return folder / "model.obj"


def many_nodes(folder):
    """A glTF file of 3,000 nodes, eight deep, each with a mesh."""
    data, blob = _mesh_data(*(lambda made: (made[0], triangles_of(made[1])))(sphere(4, 2)))
    nodes = [{"mesh": 0, "translation": [0.5, 1.5 if i % 8 else 0, 0.25 * (i // 8)], "scale": [0.9] * 3,
              **({"children": [i + 1]} if i % 8 < 7 else {})} for i in range(3000)]
    data["nodes"], data["scenes"] = nodes, [{"nodes": list(range(0, 3000, 8))}]
    (folder / "model.glb").write_bytes(glb(data, blob))
    return folder / "model.glb"
