# SPDX-License-Identifier: MIT
"""The reader of STL: against trimesh, and what it refuses."""

import struct

import numpy
import pytest
import trimesh

from fixel.model import stl
from fixel.model.mesh import UNIT
from fixel.scene import compiler, look
from model_files import assert_refused, stl as make, stl_text

BUILT_PROGRAMS = ()


def read(tmp_path, data):
    (tmp_path / "model.stl").write_bytes(data)
    return stl.read(str(tmp_path / "model.stl"), "model.stl")


@pytest.mark.parametrize("pack", [make, stl_text])
def test_triangles_as_trimesh_reads_them(tmp_path, pack):
    points = [(0, 0, 0), (1.5, 0, 0), (0, 2.25, 0), (0.1, 0, 3)]
    mesh, notes = read(tmp_path, pack(points))
    ours = [[(x / UNIT, z / UNIT, y / UNIT) for x, y, z in (mesh.vertices[c] for c in reversed(face))] for face in mesh.faces]
    theirs = trimesh.load_mesh(tmp_path / "model.stl", process=False)
    assert numpy.allclose(numpy.array(ours), theirs.vertices[theirs.faces], atol=1e-7)
    assert any("z upward" in note for note in notes) and len(mesh.places) == 4


@pytest.mark.parametrize("pack", [make, stl_text])
def test_a_model_stands_upright_and_looks_outward(tmp_path, pack):
    (tmp_path / "model.stl").write_bytes(pack([(-1, -1, 0), (1, -1, 0), (0, 1, 0), (0, 0, 5)],
                                              [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]))
    compiled, notes = compiler.compile_scene(str(tmp_path / "model.stl"), 4)
    tops = [max(axis) - min(axis) for axis in zip(*compiled.models[0].vertices)]
    assert tops[1] == max(tops)             # STL's z is up
    assert not any("inside out" in note or "turned round" in note for note in notes)


def test_faces_that_look_the_wrong_way_are_turned(tmp_path):
    triangles = [(0, 2, 1), (0, 1, 3), (3, 2, 1), (2, 0, 3)]    # the third one
    points = [(-1, -1, 0), (1, -1, 0), (0, 1, 0), (0, 0, 5)]
    (tmp_path / "model.stl").write_bytes(make(points, triangles))
    compiled, notes = compiler.compile_scene(str(tmp_path / "model.stl"), 4)
    assert any("1 faces were turned round" in note for note in notes)
    assert compiled.models[0].kind == 0     # convex: all fronts look outward


def test_a_text_in_capitals_and_with_a_byte_order_mark(tmp_path):
    plain, _ = read(tmp_path, stl_text())
    for data in (stl_text().upper(), b"\xef\xbb\xbf" + stl_text(), b"\xff\xfe" + stl_text().decode().encode("utf-16-le")):
        mesh, _ = read(tmp_path, data)
        assert (mesh.vertices, mesh.faces) == (plain.vertices, plain.faces)


@pytest.mark.parametrize("data", [make() + b"\0" * 7, make() + bytes(50), stl_text() + b"\0\0\nsigned by no one\n"])
def test_what_stands_after_the_end_is_left_out_and_said(tmp_path, data):
    plain, _ = read(tmp_path, make())
    mesh, notes = read(tmp_path, data)
    assert (mesh.vertices, mesh.faces) == (plain.vertices, plain.faces)
    assert sum("left out" in note and "after the last" in note for note in notes) == 1


def with_attributes(values, header=b""):
    """A binary file whose triangles have these attributes."""
    blob = bytearray(make())
    blob[:len(header)] = header
    for face, value in enumerate(values):
        struct.pack_into("<H", blob, 84 + 50 * face + 48, value)
    return bytes(blob)


def test_colours_of_a_binary_file(tmp_path):
    assert read(tmp_path, with_attributes([0, 5, 0x7FFF, 9]))[0].surfaces is None
    mesh, _ = read(tmp_path, with_attributes([0x8000 | 31 << 10, 0x8000 | 31 << 5, 0x801F, 0]))
    assert mesh.surfaces.colours() == [(255, 0, 0), (0, 255, 0), (0, 0, 255), (200, 192, 176)]
    mesh, _ = read(tmp_path, with_attributes([31, 31 << 5, 31 << 10, 0x8000], b"made by hand COLOR=" + bytes((9, 99, 199, 255))))
    assert mesh.surfaces.colours() == [(255, 0, 0), (0, 255, 0), (0, 0, 255), (9, 99, 199)]


@pytest.mark.parametrize("values, header, count", [
    ([0x8000] * 4, b"", 0), ([0xFC00] * 4, b"", 0), ([0x8000, 0x8000, 0x8000, 0xFC00], b"", 2), ([0xFC00, 0xFC00, 0, 0], b"", 2), ([0x7FFF] * 4, b"", None),
    ([0x8000] * 4, b"COLOR=\x09\x63\xc7\xff", 1), ([31] * 4, b"COLOR=\x09\x63\xc7\xff", 1)])
def test_one_value_behind_every_triangle_is_a_colour_only_where_the_head_says_so(tmp_path, values, header, count):
    """As programs write any bytes there: 12 of 23 published parts of one printer were black or red."""
    mesh, notes = read(tmp_path, with_attributes(values, header))
    assert (mesh.surfaces is None) == (not count)
    assert count in (0, None) or len(set(mesh.surfaces.colours())) == count
    said = [note for note in notes if "two bytes behind" in note]
    assert [f"({count} different)" in note and "--no-colours" in note if count else f"0x{values[0]:04x}" in note for note in said] == [True] * (count is not None)
    made, _ = compiler.compile_scene(str(tmp_path / "model.stl"), 4)
    plain, _ = compiler.compile_scene(str(tmp_path / "model.stl"), 4, look=look.Look("palette", 0, 0, 0, whole=True, colours=False))
    assert (made.palette == plain.palette) == (not count)


BAD = {
    "2 GB": (bytes(80) + struct.pack("<I", 42_949_672) + bytes(200), ["promises 42,949,672 triangles", "2,147,483,684 bytes"]),
    "many": (bytes(80) + struct.pack("<I", (1 << 20) + 1) + bytes(50 * ((1 << 20) + 1)), ["1,048,577 triangles", "1,048,576"]),
    "none": (bytes(84), ["no face"]),
    "short": (b"xyz", ["3 bytes are fewer"]),
    "NaN": (make([(float("nan"), 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]), ["triangle 0", "x of corner 0 is nan"]),
    "huge": (make([(0, 0, 1e30), (1, 0, 0), (0, 1, 0), (0, 0, 1)]), ["triangle 0", "z of corner 0"]),
    "word": (stl_text().replace(b"vertex 0 0 0", b"vertx 0 0 0", 1), ["model.stl:7", "this one has 2"]),
    "one line": (stl_text().replace(b"\n", b" "), ["no face", "line of its own"]),
    "no facet": (b"solid thing\nendsolid thing\n", ["no face"]),
    "number": (stl_text().replace(b"vertex 0 0 0", b"vertex 0 zero 0", 1), ["model.stl:4", '"zero" is not a number']),
    "nan": (stl_text().replace(b"vertex 0 0 0", b"vertex 0 nan 0", 1), ["model.stl:4", '"nan" is not a number']),
    "two": (stl_text().replace(b"vertex 0 0 0\n", b"", 1), ["model.stl:6", "this one has 2"]),
    "end": (stl_text().rsplit(b"endloop", 1)[0], ["ends within a facet"]),
    "few": (stl_text().replace(b"vertex 0 0 0", b"vertex 0 0", 1), ["model.stl:4", "3 numbers, found 2"]),
}


@pytest.mark.parametrize("kind", BAD)
def test_what_is_wrong_is_said_in_one_sentence(tmp_path, kind):
    assert_refused(read, tmp_path, *BAD[kind])


def test_statements_of_a_text_that_are_not_known_are_told_once(tmp_path):
    text = stl_text()
    plain, _ = read(tmp_path, text)
    made, notes = read(tmp_path, text.replace(b"facet normal", b"color 1 0 0\nfacet normal").replace(b"endloop", b"END LOOP")
                       .replace(b"endfacet", b"end facet").replace(b"solid thing\n", b"solid thing\nexported by hand\n", 1))
    assert (made.vertices, made.faces) == (plain.vertices, plain.faces)
    note, = [note for note in notes if "not known" in note]
    assert f"1 x exported, {len(made.faces)} x color (first: model.stl:2)" in note
