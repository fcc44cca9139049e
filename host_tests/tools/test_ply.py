# SPDX-License-Identifier: MIT
"""The reader of PLY: what trimesh writes and what other programs do, and what is refused."""

import struct

import numpy
import pytest
import trimesh

from fixel.image import image
from fixel.model import ply
from fixel.model.mesh import UNIT
from fixel.scene import compiler, look
from model_files import SQUARE, TETRAHEDRON, assert_refused, png

BUILT_PROGRAMS = ()
RGB = ("red", "green", "blue")


def text(points=TETRAHEDRON[0], faces=TETRAHEDRON[1], vertex=(), face=(), comment=""):
    """A text PLY file's bytes. vertex, face: (declarations, rows) of more properties."""
    (vertex_names, vertex_rows), (face_names, face_rows) = vertex or ((), [()] * len(points)), face or ((), [()] * len(faces))
    lines = ["ply", "format ascii 1.0", *([f"comment {comment}"] if comment else []), f"element vertex {len(points)}",
             *(f"property float {axis}" for axis in "xyz"), *(f"property {each}" for each in vertex_names),
             f"element face {len(faces)}", "property list uchar int vertex_indices", *(f"property {each}" for each in face_names),
             "end_header", *(" ".join(map(str, (*point, *row))) for point, row in zip(points, vertex_rows)),
             *(" ".join(map(str, (len(each), *each, *row))) for each, row in zip(faces, face_rows)), ""]
    return "\n".join(lines).encode()


def binary(points=TETRAHEDRON[0], faces=TETRAHEDRON[1], end="<", reds=None):
    """A binary PLY file's bytes. reds: the colour of each face."""
    more = "".join(f"property uchar {channel}\n" for channel in RGB) if reds else ""
    order = {"<": "little", ">": "big"}[end]
    head = (f"ply\nformat binary_{order}_endian 1.0\nelement vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
            f"element face {len(faces)}\nproperty list uchar int vertex_index\n{more}end_header\n")
    return head.encode() + b"".join(struct.pack(end + "3f", *point) for point in points) + \
        b"".join(struct.pack(f"{end}B{len(face)}i", len(face), *face) + bytes(red) for face, red in zip(faces, reds or [()] * len(faces)))


def read(tmp_path, data):
    (tmp_path / "model.ply").write_bytes(data)
    return ply.read(str(tmp_path / "model.ply"), "model.ply")


@pytest.mark.parametrize("data", [text(), binary(), binary(end=">")])
def test_corners_stand_where_the_file_says(tmp_path, data):
    mesh, notes = read(tmp_path, data)
    ours = [[tuple(c / UNIT for c in mesh.vertices[corner]) for corner in face[::-1]] for face in mesh.faces]
    assert ours == [[(x, y, -z) for x, y, z in (TETRAHEDRON[0][corner] for corner in face)] for face in TETRAHEDRON[1]]
    assert mesh.surfaces is None and any("z was negated" in note for note in notes)


@pytest.mark.parametrize("encoding", ["ascii", "binary"])
@pytest.mark.parametrize("kind", ["vertex", "face"])
def test_colours_as_trimesh_writes_them(tmp_path, encoding, kind):
    colours = [(255, 0, 0, 255), (0, 255, 0, 255), (0, 0, 255, 255), (90, 120, 30, 255)]
    made = trimesh.Trimesh(*TETRAHEDRON, process=False, **{f"{kind}_colors": colours})
    mesh, notes = read(tmp_path, made.export(file_type="ply", encoding=encoding))
    rows = numpy.array(colours)[:, :3]
    wanted = rows if kind == "face" else [rows[list(face)].mean(axis=0) for face in TETRAHEDRON[1]]
    assert numpy.abs(numpy.array(mesh.surfaces.colours()) - wanted).max() <= 0.5
    assert sum("vertices have colours" in note for note in notes) == (kind == "vertex")


@pytest.mark.parametrize("kind, row", [("uchar", (51, 102, 255)), ("ushort", (13107, 26214, 65535)), ("float", (0.2, 0.4, 1))])
def test_colours_of_every_kind_of_number(tmp_path, kind, row):
    mesh, _ = read(tmp_path, text(vertex=([f"{kind} {channel}" for channel in RGB], [row] * 4)))
    assert set(mesh.surfaces.colours()) == {(51, 102, 255)}


def test_alpha_is_left_out_and_said(tmp_path):
    rows = [(9, 99, 199, 80)] * 4
    mesh, notes = read(tmp_path, text(vertex=([f"uchar {channel}" for channel in (*RGB, "alpha")], rows)))
    assert set(mesh.surfaces.colours()) == {(9, 99, 199)} and any("left out alpha" in note for note in notes)


@pytest.mark.parametrize("where", ["vertex", "face"])
def test_an_image_by_coordinates_of_vertices_or_of_corners(tmp_path, where):
    (tmp_path / "skin.png").write_bytes(png([[(255, 0, 0), (0, 0, 255)]]))
    uvs = [(0, 0), (1, 0), (1, 1), (0, 1)]
    more = {"vertex": (("float s", "float t"), uvs)} if where == "vertex" else \
        {"face": (("list uchar float texcoord",), [(6, *(c for corner in face for c in uvs[corner])) for face in SQUARE[1]])}
    mesh, _ = read(tmp_path, text(*SQUARE, comment="TextureFile skin.png", **more))
    assert [[(1 - u, v) for u, v in face[::-1]] for face in mesh.surfaces.uvs] == \
        [[(1 - uvs[corner][0], 1 - uvs[corner][1]) for corner in face] for face in SQUARE[1]]
    compiled, _ = compiler.compile_scene(str(tmp_path / "model.ply"), 4, look=look.Look())
    assert compiled.surfaces.textures and image.unpack(image.pack(compiled)) == compiled


def test_an_image_that_is_not_there_is_said(tmp_path):
    mesh, notes = read(tmp_path, text(*SQUARE, comment="TextureFile C:\\skins\\skin.png", vertex=(("float u", "float v"), [(0, 0)] * 4)))
    assert mesh.surfaces is None and any('no image "C:\\\\skins\\\\skin.png"' in note for note in notes)


PYRAMID = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, 1)], [(3, 2, 1, 0), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
REDS = [f"uchar {c}" for c in RGB], [(10 * i, 0, 0) for i in range(5)]


@pytest.mark.parametrize("data", [text(*PYRAMID, face=REDS), binary(*PYRAMID, reds=REDS[1]), binary(*PYRAMID, end=">", reds=REDS[1]),
                                  binary(PYRAMID[0], PYRAMID[1][::-1], reds=REDS[1][::-1])])
def test_faces_of_different_numbers_of_corners(tmp_path, data):
    mesh, _ = read(tmp_path, data)
    if len(mesh.faces[0]) == 3:     # the file has them the other way round
        mesh.faces, mesh.surfaces.tints, mesh.surfaces.of_face = mesh.faces[::-1], mesh.surfaces.tints[::-1], mesh.surfaces.of_face[::-1]
    assert [len(face) for face in mesh.faces] == [4, 3, 3, 3, 3] and mesh.surfaces.colours() == [(10 * i, 0, 0) for i in range(5)]


def test_a_ply_file_is_a_scene_by_itself_and_in_a_scene_file(tmp_path):
    (tmp_path / "model.ply").write_bytes(binary())
    (tmp_path / "scene.toml").write_text('[[objects]]\nmodel = "model.ply"\nfit = 4\n')
    for name in ("model.ply", "scene.toml"):
        made, notes = compiler.compile_scene(str(tmp_path / name), 4)
        assert made.models[0].kind == image.CONVEX and not any("inside out" in note or "turned round" in note for note in notes)


NAN = text([(0, 0, 0), (1, 0, 0), (0, "nan", 0), (0, 0, 1)])
BAD = {
    "no PLY": (b"OFF\n3 1 0\n", ["begins with ply"]),
    "no end": (b"ply\nformat ascii 1.0\nelement vertex 3\n", ["end_header"]),
    "promise": (text().replace(b"vertex 4", b"vertex 4000000000"), ["promises 4,000,000,000", '"vertex"', "damaged"]),
    "many": (text().replace(b"face 4", b"face 1048577") + b" " * (1 << 21), ["1,048,577 faces", "1,048,576"]),
    "points alone": (text(faces=[]), ["no faces", "MeshLab"]),
    "strips": (text(faces=[]).replace(b"end_header", b"element tristrips 1\nproperty list int int vertex_indices\nend_header"), ["strips"]),
    "cut": (binary()[:-3], ["cannot be read", "ends within a face", "damaged"]),
    "cut within vertices": (binary()[:195], ["cannot be read", "ends within the 4 rows of vertex"]),
    "cut text": (text()[:-6], ["cannot be read", "ends within the 4 rows of face"]),
    "uneven and cut": (binary(*PYRAMID)[:-3], ["cannot be read", "ends within a face"]),
    "kind": (binary().replace(b"float y", b"real y"), ["model.ply:5", '"real y" is no property']),
    "kind of a text": (text().replace(b"float y", b"long y"), ["model.ply:5", '"long y" is no property']),
    "no element": (text().replace(b"element vertex", b"property float q\nelement vertex"), ["model.ply:3", "of an element"]),
    "element twice": (text().replace(b"element face", b"element vertex"), ["model.ply:7", '"vertex" is there a second time']),
    "format": (text().replace(b"ascii", b"utf8"), ["names no format"]),
    "end of the header": (text().replace(b"end_header\n", b"end_header 0 0 0 "), ["end_header does not end"]),
    "element": (binary().replace(b"element vertex 4", b"element vertex -4"), ["model.ply:3", '"vertex -4" is no element']),
    "count of a fraction": (binary().replace(b"list uchar", b"list float"), ["model.ply:8", "is no property of a binary file"]),
    "NaN": (NAN, ["vertex 2: y is nan"]),
    "huge": (binary([(0, 0, 1e30), (1, 0, 0), (0, 1, 0), (0, 0, 1)]), ["vertex 0: z is 1e+30"]),
    "index": (text(faces=[(0, 1, 4)]), ["face 0", "does not exist", "there are 4"]),
    "index with a fraction": (text(faces=[(0, 1, 2), (0, 1, 2.5)]), ["face 1", "does not exist"]),
    "two corners": (text(faces=[(0, 1), (2, 3)]), ["no face of three corners"]),
    "word": (text().replace(b"1 0 0\n", b"1 0 zero\n"), ["model.ply:11", '"zero" is not a number']),
    "word in a file that ends with CR": (text().replace(b"1 0 0\n", b"1 0 1_0\n").replace(b"\n", b"\r"), ["model.ply:11", '"1_0" is not']),
    "first word": (text().replace(b"end_header\n0 0 0", b"end_header\n0,5 0 0"), ["model.ply:10", '"0,5" is not a number']),
    "list for a number": (text([(*point[:2], 1, point[2]) for point in TETRAHEDRON[0]]).replace(b"float z", b"list uchar float z"),
                          ['"z" is a list']),
    "no z": (text().replace(b"float z", b"float w"), ["model.ply"]),
    "no indices": (text().replace(b"vertex_indices", b"numbers"), ["the faces have no", "vertex_indices"]),
}


@pytest.mark.parametrize("kind", BAD)
def test_what_is_wrong_is_said_in_one_sentence(tmp_path, kind):
    assert_refused(read, tmp_path, *BAD[kind], most=400)


def test_what_stands_behind_the_end_of_a_binary_file_is_left_out(tmp_path):
    mesh, notes = read(tmp_path, binary() + b"more")
    assert len(mesh.faces) == 4 and any("left out what stands behind the end: 4 bytes" in note for note in notes)


def test_a_text_with_edges_and_lines_behind_its_end(tmp_path):
    whole = text()
    mesh, _ = read(tmp_path, whole)
    edges = whole.replace(b"element face", b"element edge 2\nproperty int vertex1\nproperty int vertex2\nelement face")
    head, body = edges.split(b"end_header\n")
    rows = body.splitlines()
    count = len(TETRAHEDRON[0])
    made, notes = read(tmp_path, b"\n".join([head + b"end_header", *rows[:count], b"0 1", b"", b"1 2", *rows[count:], b"7 7", b""]))
    assert made.faces == mesh.faces and made.vertices == mesh.vertices
    assert any("left out what stands behind the end: 2 words" in note for note in notes)
    assert any('left out "element edge"' in note for note in notes)
    made, notes = read(tmp_path, whole + b"the end, 1 2\n")
    assert made.faces == mesh.faces and any("left out what stands behind the end: 4 words" in note for note in notes)


def test_a_binary_file_with_other_elements_and_kinds(tmp_path):
    """Lists that are not read, of other lengths, before and behind what is read; lines that end as in Windows."""
    points, faces = SQUARE
    head = (f"ply\nformat binary_big_endian 1.0\nelement edge 2\nproperty list uint8 double bends\nproperty short mark\n"
            f"element vertex {len(points)}\nproperty double x\nproperty int y\nproperty float32 z\nproperty int8 mark\n"
            f"element face {len(faces)}\nproperty list uint8 uint8 marks\nproperty list int uint16 vertex_indices\n"
            "element empty 0\nproperty float q\nend_header\n").replace("\n", "\r\n")
    data = head.encode() + struct.pack(">BdhBddh", 1, 0.5, 3, 2, 0.5, 0.5, 4) + \
        b"".join(struct.pack(">difb", x, y, z, -1) for x, y, z in points) + \
        b"".join(struct.pack(f">B{i}Bi{len(face)}H", i, *range(i), len(face), *face) for i, face in enumerate(faces))
    mesh, notes = read(tmp_path, data)
    plain, _ = read(tmp_path, text(*SQUARE))
    assert (mesh.vertices, mesh.faces) == (plain.vertices, plain.faces) and not any("behind" in note for note in notes)
    note, = [note for note in notes if "left out" in note]
    assert note == 'model.ply: left out "element edge", "mark of vertex", "marks of face"'


NORMALS = [(0, 0, 2), (0, 1, 1), (-3, 0, 0), (0.5, 0.5, 0.5)]


@pytest.mark.parametrize("kind", ["float", "double"])
def test_normals_are_those_of_the_corners(tmp_path, kind):
    mesh, _ = read(tmp_path, text(vertex=([f"{kind} n{axis}" for axis in "xyz"], NORMALS)))
    wanted = [[(x, y, -z) for x, y, z in (NORMALS[corner] for corner in face[::-1])] for face in TETRAHEDRON[1]]
    assert [list(map(tuple, face)) for face in mesh.normals] == wanted
    compiled, _ = compiler.compile_scene(str(tmp_path / "model.ply"), 4, look=look.Look())
    assert any(face.mapped for face in compiled.models[0].faces)
    flat, _ = read(tmp_path, text())
    assert flat.normals == []


def test_a_face_with_a_normal_that_is_no_direction_has_none(tmp_path):
    for wrong in ((0, 0, 0), ("nan", 0, 0), (1e30, 0, 0), (1e-30, 0, 0)):
        mesh, _ = read(tmp_path, text(vertex=([f"float n{axis}" for axis in "xyz"], [*NORMALS[:3], wrong])))
        assert [face is None for face in mesh.normals] == [3 in face for face in TETRAHEDRON[1]]


@pytest.mark.parametrize("change", [
    lambda data: data.decode().encode("utf-8-sig"), lambda data: data.decode().encode("utf-16"), lambda data: data.replace(b"\n", b"\r\n"),
    lambda data: data.replace(b"\n", b"\r"), lambda data: data.replace(b"\n", b"\n\n"),
    lambda data: b"end_header\n".join(part if i == 0 else b" ".join(part.split()) for i, part in enumerate(data.split(b"end_header\n")))])
def test_a_text_as_other_computers_write_it(tmp_path, change):
    """Byte order marks, ends of lines, all rows on one line; lists of several lengths."""
    uvs = ("list uchar float texcoord",), [(2 * len(face), *(0.5 for _ in range(2 * len(face)))) for face in PYRAMID[1]]
    data = text(*PYRAMID, face=uvs)
    assert (lambda made: (made.vertices, made.faces, made.uvs))(read(tmp_path, change(data))[0]) == \
        (lambda made: (made.vertices, made.faces, made.uvs))(read(tmp_path, data)[0])
    assert len(read(tmp_path, data)[0].faces) == 5


@pytest.mark.parametrize("head", [b"comment made by hand\n", b"obj_info a\ncomment format ascii 1.0\n"])
def test_a_binary_file_whose_format_is_not_its_second_line(tmp_path, head):
    mesh, _ = read(tmp_path, binary().replace(b"ply\n", b"ply\n" + head))
    assert mesh.faces == read(tmp_path, binary())[0].faces
    mesh, _ = read(tmp_path, binary().replace(b"\n", b"\r", 8).replace(b"end_header\n", b"end_header\r"))
    assert mesh.faces == read(tmp_path, binary())[0].faces


@pytest.mark.parametrize("names", [("diffuse_red", "diffuse_green", "diffuse_blue"), ("r", "g", "b")])
def test_colours_under_other_names(tmp_path, names):
    mesh, _ = read(tmp_path, text(vertex=([f"uchar {channel}" for channel in names], [(51, 102, 255)] * 4)))
    assert set(mesh.surfaces.colours()) == {(51, 102, 255)}


def test_triangle_strips_are_triangles(tmp_path):
    """Every second triangle is turned round; -1 stands between strips, and a vertex named twice goes on to the next."""
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 2, 0), (1, 2, 0)]
    lists = (7, 0, 1, 2, 3, -1, 4, 5), (6, 2, 3, 3, 4, 5, -1)
    data = text(points, []).replace(b"end_header", b"element tristrips 2\nproperty list int int vertex_indices\nend_header")
    mesh, _ = read(tmp_path, data + b"\n".join(" ".join(map(str, each)).encode() for each in lists))
    assert [tuple(face[::-1]) for face in mesh.faces] == [(0, 1, 2), (2, 1, 3), (3, 4, 5)]
    mesh, notes = read(tmp_path, text(points, [(0, 1, 2)]).replace(b"end_header", b"element tristrips 1\nproperty list int int vertex_indices\n"
                                                                   b"end_header") + b"3 1 2 3\n")
    assert len(mesh.faces) == 1 and any("left out triangle strips" in note for note in notes)


def test_what_a_scan_leaves_in_a_file(tmp_path):
    """Vertices that are no numbers and that no face has, faces of two corners, an image without coordinates."""
    points = [*TETRAHEDRON[0], ("nan", "nan", "nan")]
    mesh, notes = read(tmp_path, text(points, [(0, 1), *TETRAHEDRON[1]], comment="TextureFile skin.png",
                                      face=([f"uchar {c}" for c in RGB], [(10 * i, 0, 0) for i in range(5)])))
    assert len(mesh.faces) == 4 and len(mesh.vertices) == 4 and mesh.surfaces.colours() == [(10 * i, 0, 0) for i in range(1, 5)]
    for said in ("fewer than three corners: 1", "vertices that no face has: 1", 'left out the image "skin.png"'):
        assert sum(said in note for note in notes) == 1


def test_colours_of_faces_go_before_those_of_vertices(tmp_path):
    mesh, notes = read(tmp_path, text(vertex=([f"uchar {c}" for c in RGB], [(1, 2, 3)] * 4), face=([f"uchar {c}" for c in RGB], [(9, 8, 7)] * 4)))
    assert set(mesh.surfaces.colours()) == {(9, 8, 7)} and any("left out the colours of the vertices" in note for note in notes)
