# SPDX-License-Identifier: MIT
"""Meshes and solids: outward, flat, convex, of the right area."""

from fractions import Fraction
import math
import zlib

from hypothesis import assume, given, settings, strategies as st
import pytest

from fixel.image import image
from fixel.model import convex, mesh, solids
from fixel.scene import palette
from fixel.model.mesh import Mesh, UNIT
from fixel.scene.toml_object import matrix

BUILT_PROGRAMS = ()
ONE = [[Fraction(i == j) for j in range(3)] for i in range(3)]
CLOSED = sorted(set(solids.SOLIDS) - {"tile", "disc", "floor", "band", "torus", "island", "none"})
turns = st.tuples(*[st.integers(-180, 180).map(Fraction)] * 3)


def flat_mesh(points):
    """One polygon in the plane y = 0, in integers of 1/65536."""
    return Mesh([(x * UNIT // 65536, 0, z * UNIT // 65536) for x, z in points],
                [list(range(len(points)))])


def area(shape):
    return sum(math.sqrt(sum(c * c for c in mesh.newell([shape.vertices[i] for i in f.corners])))
               for f in shape.faces) / 2


def dent_of(points, area):
    """How far a corner lies at most on the inner side of the line between its neighbours, in units."""
    found = 0
    for a, b, c in zip(points[-1:] + points[:-1], points, points[1:] + points[:1]):
        line = mesh.minus(c, a)
        side = mesh.dot(mesh.cross(mesh.minus(b, a), line), area)
        found = max(found, -side / math.sqrt(mesh.dot(line, line) * mesh.dot(area, area)) if any(line) else 0)
    return found


def check_faces(shape):
    """What the loader asks of every face, and that outline and normal agree."""
    for face in shape.faces:
        points = [shape.vertices[c] for c in face.corners]
        assert 3 <= len(points) <= 24
        image.check_plane(face.normal, points, "a face")
        assert mesh.dot(mesh.newell(points), face.normal) > 0
        assert mesh.is_convex_outline(points, mesh.newell(points))
        assert dent_of(points, mesh.newell(points)) <= 2


@pytest.mark.parametrize("name", CLOSED)
@settings(max_examples=15, deadline=None)
@given(turns, st.fractions(Fraction(1, 4), 60, max_denominator=97))
def test_solids_are_closed_convex_and_look_outward_however_turned(name, turn, scale):
    """SPEC 3.4c."""
    shape = mesh.shape(solids.make(name, {}, name), matrix((scale,) * 3, turn), name)
    check_faces(shape)
    assert shape.open_edges == 0 and not shape.notes
    assert convex.is_convex(shape.vertices, shape.faces)
    for face in shape.faces:
        assert mesh.dot(face.normal, shape.vertices[face.corners[0]]) > 0


@pytest.mark.parametrize("name", sorted(set(solids.SOLIDS) - {"none"}))
def test_solids_fit_the_unit_cube(name):
    shape = mesh.shape(solids.make(name, {}, name), ONE, name)
    assert all(abs(c) <= 32768 for v in shape.vertices for c in v)
    assert all(face.normal == (0, 1 << 30, 0) for face in shape.faces) == (
        name in ("tile", "disc", "floor"))


@pytest.mark.parametrize("name, vertices, faces", [
    ("box", 8, 6), ("pyramid", 5, 5), ("prism", 12, 8), ("cylinder", 32, 18), ("cone", 13, 13), ("band", 32, 16),
    ("sphere", 62, 72), ("tetrahedron", 4, 4), ("octahedron", 6, 8), ("icosahedron", 12, 20), ("dodecahedron", 20, 12),
    ("tile", 4, 1), ("disc", 24, 1), ("floor", 81, 64), ("torus", 200, 200)])
def test_how_many_vertices_and_faces_a_solid_has(name, vertices, faces):
    made = solids.make(name, {}, name)
    assert (len(made.vertices), len(made.faces)) == (vertices, faces)
    assert {corner for face in made.faces for corner in face} == set(range(vertices))
    shape = mesh.shape(made, ONE, name)
    assert len(shape.faces) == faces and (shape.open_edges == 0) == (name in (*CLOSED, "torus"))


def lengths(points, *axes):
    """How far points are from the origin, by some of the axes."""
    return [math.hypot(*(point[axis] / UNIT for axis in axes)) for point in points]


@pytest.mark.parametrize("name", ["tetrahedron", "octahedron", "icosahedron", "dodecahedron"])
def test_edges_of_a_regular_solid_are_equal(name):
    made = solids.make(name, {}, name)
    edges = [lengths([[p - q for p, q in zip(made.vertices[a], made.vertices[b])]], 0, 1, 2)[0]
             for face in made.faces for a, b in zip(face, face[1:] + face[:1])]
    assert max(edges) - min(edges) < 1e-6 and {round(length, 6) for length in lengths(made.vertices, 0, 1, 2)} == {0.5}


def test_round_solids_have_diameter_and_height_1():
    for made in (solids.prism(7), solids.pyramid(5), solids.band(9), solids.prism(6, 0.5)):
        assert {point[1] / UNIT for point in made.vertices} == {-0.5, 0.5}
    ball = solids.sphere(8, 4)
    assert {round(length, 6) for length in lengths(ball.vertices, 0, 1, 2)} == {0.5}
    assert len(ball.vertices) == 8 * 3 + 2 and len(ball.faces) == 8 * 4
    assert [round(length, 6) for length in lengths(solids.band(9, 0.5).vertices, 0, 2)] == 9 * [0.5] + 9 * [0.25]
    assert [round(length, 6) for length in lengths(solids.pyramid(5).vertices, 0, 2)] == 5 * [0.5] + [0]


def test_a_tube_of_a_torus_is_a_quarter_of_the_width_and_looks_outward():
    made = solids.torus(12, 6)
    for point, length in zip(made.vertices, lengths(made.vertices, 0, 2)):
        assert abs(((length - 0.375) / 0.125) ** 2 + (point[1] / UNIT / 0.5) ** 2 - 1) < 1e-6
    for face in made.faces:
        middle = [sum(made.vertices[c][axis] for c in face) / 4 / UNIT for axis in range(3)]
        along = math.hypot(middle[0], middle[2])
        outward = (middle[0] * (1 - 0.375 / along), middle[1], middle[2] * (1 - 0.375 / along))
        assert mesh.dot(mesh.newell([made.vertices[c] for c in face]), outward) > 0
    assert mesh.shape(made, ONE, "torus").open_edges == 0


def test_two_colours_in_turn_make_a_floor_chequered():
    made = solids.floor((3, 4))
    assert len(made.vertices) == 4 * 5
    assert all(len(set(one) & set(after)) == 2 for one, after in zip(made.faces, made.faces[1:]))


@pytest.mark.parametrize("options, crc", [({}, 0x00146bb9), ({"cells": (9, 5), "seed": 7, "sea": 0.1}, 0x2c37523c)])
def test_a_seed_gives_the_same_island_for_ever(options, crc):
    """It is part of a scene's image. Where one is to look otherwise, put the new figure in."""
    made = solids.make("island", options, "here")
    assert zlib.crc32(repr((made.vertices, made.faces)).encode()) == crc


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_an_island_rises_from_the_sea_to_the_top_of_the_cube(seed):
    rows = solids.heights((12, 8), seed, 0.25)
    assert (len(rows), len(rows[0])) == (9, 13)
    assert max(map(max, rows)) == 1 and min(map(min, rows)) == 0
    assert {rows[0][0], rows[0][12], rows[8][0], rows[8][12]} == {0}, "corners lie in the sea"
    assert sum(height > 0 for row in solids.heights((12, 8), seed, 0.0) for height in row) > \
        sum(height > 0 for row in rows for height in row) > 12
    made = solids.island((12, 8), seed, 0.25)
    assert len(made.vertices) == 13 * 9 and len(made.faces) <= 2 * 12 * 8
    assert all(mesh.newell([made.vertices[corner] for corner in face])[1] > 0 for face in made.faces), "all look up"


def test_box_of_unit_size_is_exact():
    shape = mesh.shape(solids.box(), ONE, "box")
    assert sorted(shape.vertices) == sorted((x, y, z) for x in (-32768, 32768)
                                            for y in (-32768, 32768) for z in (-32768, 32768))
    assert shape.faces[0].normal == (0, 0, -(1 << 30)) and len(shape.faces[0].corners) == 4


def test_inside_turns_the_faces_inward():
    shape = mesh.shape(solids.box(), ONE, "box", inside=True)
    check_faces(shape)
    assert all(mesh.dot(f.normal, shape.vertices[f.corners[0]]) < 0 for f in shape.faces)
    assert convex.is_convex(shape.vertices, shape.faces)


def test_a_concave_polygon_is_cut_into_triangles_of_the_same_area():
    """SPEC 3.4d-e."""
    # An L, clockwise from above.
    ell = [(0, 0), (0, 131072), (65536, 131072), (65536, 65536), (131072, 65536), (131072, 0)]
    shape = mesh.shape(flat_mesh(ell), ONE, "ell")
    check_faces(shape)
    assert [len(f.corners) for f in shape.faces] == [3] * 4
    assert area(shape) == 3 * 65536 ** 2
    assert "1 face with concave outlines triangulated" in shape.notes[0]


def test_a_hole_reached_by_a_bridge_stays_a_hole():
    outer = [(0, 0), (0, 300000), (300000, 300000), (300000, 0)]
    hole = [(100000, 100000), (200000, 100000), (200000, 200000), (100000, 200000)]
    keyhole = outer + [outer[0], hole[0], hole[1], hole[2], hole[3], hole[0]]
    shape = mesh.shape(flat_mesh(keyhole), ONE, "frame")
    check_faces(shape)
    assert area(shape) == 300000 ** 2 - 100000 ** 2


def test_an_outline_that_crosses_itself_is_said():
    bow = [(0, 0), (0, 100000), (300000, 0), (300000, 200000)]
    shape = mesh.shape(flat_mesh(bow), ONE, "bow")
    assert all(len(f.corners) == 3 for f in shape.faces)
    assert any("triangulated" in note for note in shape.notes)


@pytest.mark.parametrize("lift, pieces", [(0, 1), (4, 1), (40, 2)])
def test_a_quad_that_is_not_flat_is_cut(lift, pieces):
    corners = [(-65536, lift, -65536), (-65536, 0, 65536), (65536, 0, 65536), (65536, 0, -65536)]
    quad = Mesh([tuple(c * UNIT // 65536 for c in p) for p in corners], [[0, 1, 2, 3]])
    shape = mesh.shape(quad, ONE, "quad")
    check_faces(shape)
    assert len(shape.faces) == pieces
    assert bool(shape.notes) == (pieces == 2)


@pytest.mark.parametrize("sides, faces", [(24, 1), (25, 23)])
def test_polygons_stay_whole_up_to_24_vertices(sides, faces):
    ring = [(round(90000 * math.sin(2 * math.pi * i / sides)),
             round(90000 * math.cos(2 * math.pi * i / sides))) for i in range(sides)]
    shape = mesh.shape(flat_mesh(ring), ONE, "ring")
    check_faces(shape)
    assert len(shape.faces) == faces


def test_faces_without_area_are_dropped_and_said():
    points = [(0, 0, 0), (0, 0, UNIT), (UNIT, 0, 0), (0, 0, 2 * UNIT)]
    shape = mesh.shape(Mesh(points, [[0, 1, 2], [0, 1, 3], [0, 0, 1]]), ONE, "thin")
    assert len(shape.faces) == 1 and shape.sources == [0]
    assert "2 faces without area dropped" in shape.notes[0]


def test_an_inside_out_model_is_turned_round():
    """SPEC 3.4c, 3.4e."""
    box = solids.box()
    box.faces = [face[::-1] for face in box.faces]
    shape = mesh.shape(box, ONE, "box")
    check_faces(shape)
    assert all(mesh.dot(f.normal, shape.vertices[f.corners[0]]) > 0 for f in shape.faces)
    assert "inside out" in shape.notes[0]


@settings(max_examples=120, deadline=None)
@given(st.lists(st.integers(2000, 200000), min_size=3, max_size=40), turns)
def test_star_shaped_polygons_keep_their_area(radii, turn):
    count = len(radii)
    star = [(round(r * math.sin(2 * math.pi * i / count)),
             round(r * math.cos(2 * math.pi * i / count))) for i, r in enumerate(radii)]
    flat = mesh.shape(flat_mesh(star), ONE, "star")
    check_faces(flat)
    exact = abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(star, star[1:] + star[:1]))) / 2
    assert area(flat) == pytest.approx(exact, rel=1e-9)
    assert all(f.normal == (0, 1 << 30, 0) for f in flat.faces)
    turned = mesh.shape(flat_mesh(star), matrix((1, 1, 1), turn), "star")
    check_faces(turned)
    outline = sum(math.dist(a, b) for a, b in zip(star, star[1:] + star[:1]))
    assert area(turned) == pytest.approx(exact, abs=4 * count * outline)


def test_corners_on_a_straight_line_stay_for_the_neighbours():
    """An L of 32 corners, most of them on its straight sides: each is a corner of a triangle."""
    ends = [(0, 0), (0, 8), (4, 8), (4, 4), (8, 4), (8, 0)]
    outline = [(a[0] + (b[0] - a[0]) * i // n, a[1] + (b[1] - a[1]) * i // n)
               for a, b in zip(ends, ends[1:] + ends[:1]) for n in [max(abs(b[0] - a[0]), abs(b[1] - a[1]))]
               for i in range(n)]
    assert len(outline) == 32
    made = mesh.shape(flat_mesh(outline), ONE, "L")
    assert all(len(face.corners) == 3 for face in made.faces) and area(made) == 48
    corners = {corner for face in made.faces for corner in face.corners}
    assert len(made.vertices) == 32 == len(corners)


def test_an_outline_that_crosses_itself_becomes_a_fan():
    made = mesh.shape(flat_mesh([(0, 0), (0, 10), (10, 2), (10, 6)]), ONE, "crossed")
    assert any("cross themselves cut into fans" in note for note in made.notes)


@settings(max_examples=200, deadline=None)
@given(*[st.tuples(*[st.integers(-2 ** 29, 2 ** 29)] * 3)] * 3)
def test_normals_are_of_unit_length_and_right_angled(a, b, c):
    face = mesh.newell([a, b, c])
    assume(face != (0, 0, 0))
    normal = mesh.unit_normal(face)
    assert abs(sum(n * n for n in normal) - (1 << 60)) <= image.NORMAL_SQUARE_MAX_ERROR
    length = math.sqrt(sum(v * v for v in face))
    assert all(abs(n - v / length * 2 ** 30) < 0.51 for n, v in zip(normal, face))


@settings(max_examples=30, deadline=None)
@given(st.integers(256, 1200), st.randoms(use_true_random=False))
def test_the_palette_holds_any_number_of_colours(count, random):
    wanted = {tuple(random.randrange(256) for _ in range(3)): 1 + random.randrange(9)
              for _ in range(count)}
    wanted[17] = 1
    colours, indices, _ = palette.allocate((1, 2, 3), wanted)
    assert len(colours) == 256 and colours[0] == (1, 2, 3) and indices[17] == 17
    assert set(indices) == set(wanted)
    assert all(1 <= i <= 255 and i != 17 for c, i in indices.items() if c != 17)
    worst = max(max(abs(a - b) for a, b in zip(c, colours[i]))
                for c, i in indices.items() if c != 17)
    assert worst <= 96


@pytest.mark.parametrize("away", [(0, 0, 0), (1000 << 16, 0, 0), (0, -1000 << 16, 700 << 16)])
def test_a_point_before_any_face_of_a_large_model_is_seen(away):
    """Also far from the origin, and before a face that is not among those that are looked at first."""
    ball = mesh.shape(solids.make("sphere", {"sides": 24, "rings": 12}, "ball"), ONE, "ball")
    vertices = [tuple(c + by for c, by in zip(vertex, away)) for vertex in ball.vertices]
    assert convex.is_convex(vertices, ball.faces)
    for face in ball.faces[::7]:
        corners = [vertices[corner] for corner in face.corners]
        middle = [sum(corner[axis] for corner in corners) / len(corners) for axis in range(3)]
        for height, is_convex in ((200, False), (-200, True)):
            point = tuple(round(c + height * n / 2 ** 30) for c, n in zip(middle, face.normal))
            assert convex.is_convex([*vertices, point], ball.faces) == is_convex
