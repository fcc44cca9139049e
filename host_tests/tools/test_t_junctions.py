# SPDX-License-Identifier: MIT
"""Edges on which vertices of other faces lie are split there."""

from fractions import Fraction
import math
import random
import time

import numpy
import pytest

from fixel.model import mesh, t_junctions
from fixel.model.mesh import UNIT
from test_model_files import compiled, glb, gltf, png
from test_scene_mesh import ONE, check_faces

BUILT_PROGRAMS = ()


def shape_of(points, faces):
    """The shape of a mesh of decimal points, with its edges split."""
    made = mesh.shape(mesh.Mesh([tuple(round(Fraction(c) * UNIT) for c in point) for point in points], faces), ONE, "m")
    t_junctions.mend(made, "m")
    check_faces(made)
    return made


def area_of(made):
    return sum(mesh.dot(area, area) ** 0.5 for face in made.faces for area in [mesh.newell([made.vertices[c] for c in face.corners])])


# A square beside two that meet at the middle of its edge; faces clockwise.
SIDE_BY_SIDE = [(0, 0, 0), (0, 2, 0), (2, 2, 0), (2, 0, 0), (2, 1, 0), (4, 1, 0), (4, 2, 0), (4, 0, 0)], \
    [[0, 1, 2, 3], [4, 2, 6, 5], [3, 4, 5, 7]]


def test_an_edge_is_split_where_a_neighbour_has_a_vertex():
    made = shape_of(*SIDE_BY_SIDE)
    assert sorted(len(face.corners) for face in made.faces) == [4, 4, 5] and made.sources == [0, 1, 2]
    assert made.open_edges == 7 and any("m: 1 edges had vertices of other faces on them (T-junctions)" in note for note in made.notes)


def test_several_vertices_on_an_edge_come_in_their_order():
    heights = [0, "0.3", "0.7", "1.1", 2]
    points = [(0, 0, 0), (0, 2, 0), (2, 2, 0), (2, 0, 0)] + [(2, y, 0) for y in heights[1:-1]] + [(4, y, 0) for y in heights]
    column = [3, 4, 5, 6, 2]
    faces = [[0, 1, 2, 3]] + [[column[i], column[i + 1], 8 + i, 7 + i] for i in range(4)]
    made = shape_of(points, faces)
    assert [len(face.corners) for face in made.faces] == [7, 4, 4, 4, 4]
    assert [made.vertices[c][1] for c in made.faces[0].corners if made.vertices[c][0] == 2 << 16] == \
        sorted((made.vertices[c][1] for c in made.faces[0].corners if made.vertices[c][0] == 2 << 16), reverse=True)


def test_vertices_of_crossed_edges_and_of_closed_models_stay(tmp_path):
    for points, faces in (([(0, 0, 0), (0, 2, 0), (2, 2, 0), (2, 1, "0.01"), (3, 1, 0), (3, 2, 0)], [[0, 1, 2], [3, 5, 4]]),
                          ([(0, 0, 0), (0, 2, 0), (2, 0, 0), (5, 5, 5), (5, 6, 5), (6, 5, 5)], [[0, 1, 2], [3, 4, 5]])):
        made = shape_of(points, faces)
        assert [len(face.corners) for face in made.faces] == [3, 3] and not any("T-junctions" in note for note in made.notes)


@pytest.mark.parametrize("seed", range(6))
def test_random_directions_keep_area_and_leave_no_open_edge_inside(seed):
    """A strip beside a strip of other steps, turned anyhow, whose vertices are rounded to 16.16."""
    chance = random.Random(seed)
    turn = numpy.linalg.qr(numpy.array([[chance.gauss(0, 1) for _ in range(3)] for _ in range(3)]))[0]
    steps = sorted(chance.uniform(0, 5) for _ in range(9))
    left, right = [0.0, *steps[::2], 5.0], [0.0, *steps[1::2], 5.0]
    flat = [(0, y) for y in left] + [(1, y) for y in left] + [(1, y) for y in right] + [(2, y) for y in right]
    points = [tuple(repr(float(c)) for c in turn @ (x, y, 0)) for x, y in flat]
    faces = [[i, i + 1, len(left) + i + 1, len(left) + i] for i in range(len(left) - 1)]
    base = 2 * len(left)
    faces += [[base + i, base + i + 1, base + len(right) + i + 1, base + len(right) + i] for i in range(len(right) - 1)]
    faces = [face if seed % 2 else face[::-1] for face in faces]
    made = shape_of(points, faces)
    assert made.open_edges == len(left) + len(right) + 2
    assert abs(area_of(made) - 2 * 10 * 65536.0 ** 2) < 2e-4 * 65536.0 ** 2 * 20


def test_a_texture_goes_on_through_a_vertex_on_an_edge(tmp_path):
    """The coordinates at the new corner lie between those at the ends of its edge."""
    points = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (2, 1, 0), (4, 0, 0), (4, 1, 0), (4, 2, 0)]
    triangles = [(0, 1, 2), (0, 2, 3), (1, 5, 6), (1, 6, 4), (4, 6, 7), (4, 7, 2)]
    image = png([[(4 * x, 4 * y, 9) for x in range(64)] for y in range(64)])
    made, notes = compiled(tmp_path, '[[objects]]\nmodel = "m.glb"\nimages = true\nshade = false\n',
                           m_glb=glb(*gltf(points, triangles, uvs=[(x / 4, 1 - y / 2) for x, y, _ in points], image=image)))
    assert any("T-junctions" in note for note in notes)
    model, sides = made.models[0], []
    for face in model.faces:
        sides.append(len(face.corners))
        for number, (u, v) in zip(face.mapped.vertices, face.mapped.texels):
            x, y, _ = model.vertices[number]
            assert abs(u - x * 16) < 70_000 and abs(v - ((64 << 16) - y * 32)) < 70_000
    assert sorted(sides) == [3] * 5 + [4]       # the triangle at whose edge the vertex lies


@pytest.mark.parametrize("limit, most", [("PAIRS_MAX", 2), ("SPLITS_MAX", 0)])
@pytest.mark.parametrize("cells", [0, 1 << 60])
@pytest.mark.parametrize("each", [0, 1 << 60])
def test_a_model_with_very_many_open_edges_is_left_as_it_is_and_said(monkeypatch, limit, most, cells, each):
    monkeypatch.setattr(t_junctions, "_CELLS_MAX", cells)
    monkeypatch.setattr(t_junctions, "_PAIRS_EACH", each)
    monkeypatch.setattr(t_junctions, limit, most)
    made = shape_of(*SIDE_BY_SIDE)
    assert [len(face.corners) for face in made.faces] == [4, 4, 4] and any("too many to look for" in note for note in made.notes)


def fan(count, where):
    """Faces that share one edge, and where their third corners are."""
    chance, third = random.Random(count), {
        "circle": lambda i: (math.cos(2 * math.pi * i / count), 0.5, math.sin(2 * math.pi * i / count)), "row": lambda i: (i / count, 0.5, 0),
        "cube": lambda i: (chance.random(), chance.random(), chance.random())}[where]
    points = [(0, 0, 0), (0, 1, 0), *(third(i) for i in range(count))]
    return [tuple(round(50 * UNIT * c) for c in point) for point in points], [[0, 1, 2 + i] for i in range(count)]


def work(monkeypatch, points, faces):
    """(what is inserted, how many pairs and boxes were looked at)."""
    counted, real = [], t_junctions._Near.found

    def found(self, *edges):
        try:
            return real(self, *edges)
        finally:
            counted.append(self.looked)
    with monkeypatch.context() as patch:
        patch.setattr(t_junctions._Near, "found", found)
        return t_junctions._inserted(faces, points, t_junctions._open_edges(faces)), sum(counted)


@pytest.mark.parametrize("where", ["circle", "row", "cube"])
def test_the_work_for_many_faces_on_one_edge_grows_little_faster_than_their_number(monkeypatch, where):
    """Eight times the faces: less than 24 times the work, where each edge with each vertex would be 64 times."""
    (_, few), (_, many) = (work(monkeypatch, *fan(count, where)) for count in (750, 6000))
    assert 0 < many < 24 * few and many < 6000 ** 2 / 8


@pytest.mark.parametrize("where", ["circle", "row", "cube"])
def test_both_ways_of_looking_for_vertices_find_the_same(monkeypatch, where):
    points, faces = fan(200, where)
    chance, found = random.Random(7), []
    for face in faces[:150]:        # vertices on edges, whose faces stand apart
        a, b = (points[corner] for corner in chance.sample(face, 2))
        at = chance.random()
        points.append(tuple(round(p + at * (q - p)) for p, q in zip(a, b)))
        points += [tuple(c + UNIT * chance.randint(1, 9) for c in points[-1]) for _ in range(2)]
        faces.append([len(points) - 3, len(points) - 2, len(points) - 1])
    for each in (0, 1 << 60):
        monkeypatch.setattr(t_junctions, "_PAIRS_EACH", each)
        found.append(work(monkeypatch, points, faces)[0])
    assert found[0] == found[1] and len(found[0]) >= 100


def bricks(columns, rows, digits, turn):
    """A wall whose courses lie half a brick beside each other; coordinates of so many decimals."""
    points, faces = [], []
    for row in range(rows):
        for column in range(columns):
            left = column + row % 2 / 2
            base = len(points)
            points += [tuple(repr(round(float(c), digits)) for c in turn @ (u, v, 0)) for u, v in
                       ((left, row), (left, row + 1), (left + 1, row + 1), (left + 1, row))]
            faces.append([base, base + 1, base + 2, base + 3])
    return points, faces


@pytest.mark.parametrize("turn, digits", [(numpy.eye(3), 2), (numpy.linalg.qr(numpy.array([[1, 2, 0], [0.5, 1, 3], [2, 0, 1.0]]))[0], 4)])
def test_a_wall_of_bricks_has_no_open_edge_inside(turn, digits):
    """Every edge along the wall has a vertex on it, also where the file's decimals put it off the edge."""
    columns, rows = 12, 9
    made = shape_of(*bricks(columns, rows, digits, turn))
    ends = 2 * rows + (rows - 1) * 2        # the ends of courses, and the half bricks that stand out
    assert made.open_edges == 2 * columns + ends
    assert any("edges had vertices of other faces on them" in note for note in made.notes)


def test_thousands_of_edges_take_seconds():
    started = time.process_time()
    made = shape_of(*bricks(80, 60, 2, numpy.eye(3)))
    assert made.open_edges == 2 * 80 + 4 * 60 - 2 and time.process_time() - started < 20


@pytest.mark.parametrize("seed", range(4))
def test_the_grid_finds_what_a_look_at_all_finds(seed):
    """Random edges and vertices, some on the edges, against every pair."""
    chance = numpy.random.default_rng(seed)
    ends = chance.integers(-1 << 20, 1 << 20, (300, 2, 3)).astype(float)
    ends[:200, 1] = ends[:200, 0] + chance.integers(-5000, 5000, (200, 3))
    on = [ends[i, 0] + (ends[i, 1] - ends[i, 0]) * t for i in range(300) for t in chance.uniform(-0.1, 1.1, 3)]
    points = numpy.round(numpy.concatenate([ends.reshape(-1, 3), on, chance.integers(-1 << 20, 1 << 20, (500, 3))]))
    near = t_junctions._Near(range(len(points)), points, 3)
    found = near.found(ends[:, 0], ends[:, 1])
    every = {}
    for edge, (one, other) in enumerate(ends):
        along, hit = near._on(one[None].repeat(len(points), 0), other[None].repeat(len(points), 0), points)
        if hit.any():
            every[edge] = [int(place) for place in sorted(numpy.flatnonzero(hit), key=lambda place: (along[place], place))]
    assert found == every and sum(map(len, found.values())) > 300
