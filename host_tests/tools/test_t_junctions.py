# SPDX-License-Identifier: MIT
"""Edges on which vertices of other faces lie are split there."""

from fractions import Fraction
import random

import numpy
import pytest

from fixel.model import mesh, t_junctions
from fixel.model.mesh import UNIT
from test_model_files import compiled, glb, gltf, png
from test_scene_mesh import ONE, check_faces


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


def test_a_model_with_very_many_open_edges_is_left_as_it_is(monkeypatch):
    monkeypatch.setattr(t_junctions, "EDGES_MAX", 8)
    assert [len(face.corners) for face in shape_of(*SIDE_BY_SIDE).faces] == [4, 4, 4]
