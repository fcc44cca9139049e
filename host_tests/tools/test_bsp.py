# SPDX-License-Identifier: MIT
"""Trees over the faces of a scene: what cuts leave, what faces share, and what hides what."""

from fractions import Fraction
import math
import random
import types

from conftest import run_cli
from hypothesis import given, settings, strategies as st
import numpy as np
import pytest

from fixel.image import image
from fixel.scene import tree, tree_choice, tree_faces
from fixel.base.errors import ToolError
from fixel.image.image import Face, Model, Object, SceneImage
from fixel.image.image_tree import NONE, Node, PLANARITY_MAX
from fixel.model.mesh import DENT_MAX, Mesh, UNIT, cross, dot, is_convex_outline, minus, newell, shape, unit_normal
from fixel.model.solids import make
from fixel.scene.toml_object import matrix

BUILT_PROGRAMS = ()
ONE = 65536
SQUARE_NORMAL = (0, 1 << 30, 0)


def solid(name="box", scale=(1, 1, 1), rotation=(0, 0, 0), kind=image.CONVEX):
    made = shape(make(name, {}, name), matrix([Fraction(s) for s in scale], rotation), name)
    return Model(made.vertices, [Face(f.normal, f.corners, 1 + i % 255)
                                 for i, f in enumerate(made.faces)], kind)


def scene(models, centres, layers=None):
    layers = layers or [0] * len(models)
    return SceneImage(160, 120, 1 << 30, 16384, 64 << 16, 4, 0, [(i, i, i) for i in range(256)],
                      list(models), [Object(tuple(c), i, layer)
                                     for i, (c, layer) in enumerate(zip(centres, layers))],
                      image.POSES, [(0, 0, 0, 0, 0, 0)])


def beams():
    """Three beams, each over the next: no order of whole beams is right."""
    models, centres = [], []
    for yaw in (0, 120, 240):
        models.append(solid("box", (5, Fraction(2, 5), Fraction(1, 2)), (yaw, 0, 12)))
        centres.append((round(0.8 * ONE * math.sin(math.radians(yaw))), 0,
                        round(0.8 * ONE * math.cos(math.radians(yaw)))))
    return scene(models, centres)


def grown(made):
    """(parts, nodes, faces, sources, vertices) of a tree over all objects."""
    lines = tree.Lines()
    parts = tree.parts_of(made, range(len(made.objects)), (0, 0, 0), lines)
    rings = [list(part.ring) for part in parts]
    nodes, faces, sources, counts = tree.grow(parts, lines)
    assert counts.faces_out == len(faces) and counts.nodes == len(nodes)
    return parts, rings, nodes, faces, sources, lines.points


boxes = st.lists(st.tuples(
    st.tuples(*[st.integers(-6 * ONE, 6 * ONE)] * 3),
    st.tuples(*[st.integers(1, 9)] * 3),
    st.tuples(*[st.integers(0, 359)] * 3),
    st.sampled_from(["box", "prism", "octahedron"])), min_size=1, max_size=6)


def bumpy_torus(around, across):
    """A torus of triangles that is not convex anywhere inside."""
    vertices, faces = [], []
    for i in range(around):
        for j in range(across):
            a, b = 2 * math.pi * i / around, 2 * math.pi * j / across
            thick = 1 + math.sin(3 * a + 2 * b) / 4
            vertices.append(tuple(round(ONE * c) for c in ((2.5 + thick * math.cos(b)) * math.cos(a), thick * math.sin(b),
                                                           (2.5 + thick * math.cos(b)) * math.sin(a))))
            next_i, next_j = (i + 1) % around * across, (j + 1) % across
            corners = i * across + j, next_i + j, next_i + next_j, i * across + next_j
            faces += [tuple(corners[k] for k in half) for half in ((0, 1, 2), (0, 2, 3))]
    return Model(vertices, [Face(unit_normal(newell([vertices[c] for c in corners])), corners, 1) for corners in faces],
                 image.SORTED)


def random_scene(drawn):
    return scene([solid(name, [Fraction(s, 2) for s in scale], rotation)
                  for _, scale, rotation, name in drawn], [centre for centre, *_ in drawn])


def edges_of(faces):
    """Directed edges: how often one way more than the other."""
    balance = {}
    for face in faces:
        for a, b in zip(face.corners, face.corners[1:] + face.corners[:1]):
            key, step = ((a, b), 1) if a < b else ((b, a), -1)
            balance[key] = balance.get(key, 0) + step
    return {edge: count for edge, count in balance.items() if count}


def distance_to_edge(point, a, b):
    """How far a point lies from an edge's line, squared, as a Fraction."""
    way = minus(b, a)
    area = cross(minus(point, a), way)
    return Fraction(dot(area, area), dot(way, way))


@settings(max_examples=25, deadline=None)
@given(boxes)
def test_parts_tile_their_face_and_share_every_vertex_of_an_edge(drawn):
    made = random_scene(drawn)
    parts, rings, _, faces, sources, points = grown(made)
    by_source, by_object = {}, {}
    for face, source in zip(faces, sources):
        assert len(set(face.corners)) == len(face.corners) <= image.FACE_VERTICES_MAX
        by_source.setdefault(source, []).append(face)
        by_object.setdefault(parts[source].group, []).append(face)
    assert set(by_source) == set(range(len(parts)))
    for source, own in by_source.items():
        # What is left of the edges is the face's outline: inner ones cancel.
        ring = [points[v] for v in rings[source]]
        outline = {v for edge in edges_of(own) for v in edge}
        for vertex in outline:
            assert any(distance_to_edge(points[vertex], a, b) <= 1
                       for a, b in zip(ring, ring[1:] + ring[:1]))
        # The areas add up to that of the outline, exactly, and none is the other way round.
        chain = chain_of(edges_of(own))
        total = newell([points[v] for v in chain])
        areas = [newell([points[v] for v in face.corners]) for face in own]
        assert tuple(map(sum, zip(*areas))) == total
        assert all(dot(area, own[0].normal) > 0 for area in areas)
        assert all(face.colour == parts[source].colour for face in own)
    for own in by_object.values():
        assert edges_of(own) == {}      # closed: each edge has its two owners, bit for bit


def hull_of(points, area):
    """The convex hull of points of a plane, decided exactly along the area's largest axis."""
    axis = max(range(3), key=lambda k: abs(area[k]))
    x, y = (axis + 1) % 3, (axis + 2) % 3

    def half(ordered):
        kept = []
        for point in ordered:
            while len(kept) > 1 and ((kept[-1][x] - kept[-2][x]) * (point[y] - kept[-2][y]) <=
                                     (kept[-1][y] - kept[-2][y]) * (point[x] - kept[-2][x])):
                kept.pop()
            kept.append(point)
        return kept[:-1]
    ordered = sorted(set(points), key=lambda point: (point[x], point[y]))
    return half(ordered) + half(ordered[::-1])


def dent(points):
    """How far a vertex of an outline lies inside its convex hull, squared."""
    hull = hull_of(points, newell(points))
    edges = list(zip(hull, hull[1:] + hull[:1]))
    return max(min(distance_to_edge(point, a, b) for a, b in edges) for point in points)


def test_a_dent_is_measured():
    square = [(0, 0, 0), (0, 900, 0), (900, 900, 0), (900, 0, 0)]
    assert dent(square) == 0
    assert dent([*square, (450, 0, 0)]) == 0
    assert dent([*square, (450, 3, 0)]) == 9
    assert not is_convex_outline([*square, (450, 3, 0)], newell([*square, (450, 3, 0)]))


def dents_of(made):
    """The dents of the faces that a tree made of a scene."""
    _, _, _, faces, _, points = grown(made)
    return [dent([points[corner] for corner in face.corners]) for face in faces]


@settings(max_examples=25, deadline=None)
@given(boxes)
def test_no_outline_has_a_dent_beyond_its_bound(drawn):
    """SPEC.md, section 3.4."""
    assert max(dents_of(random_scene(drawn))) <= DENT_MAX ** 2


@pytest.mark.parametrize("around, across", [(10, 7), (13, 9), (16, 8)])
def test_cuts_of_cuts_leave_dents_within_their_bound(around, across):
    """SPEC.md, section 3.4. Vertices of an edge are rounded, so there are dents."""
    dents = dents_of(scene([bumpy_torus(around, across)], [(0, 0, 0)]))
    assert 0 < max(dents) <= DENT_MAX ** 2


def chain_of(edges):
    """The one closed way along directed edges."""
    follow = {}
    for (a, b), count in edges.items():
        assert abs(count) == 1
        follow.setdefault(*((a, b) if count > 0 else (b, a)))
    assert len(follow) == len(edges)
    chain = [min(follow)]
    while follow[chain[-1]] != chain[0]:
        chain.append(follow[chain[-1]])
    assert len(chain) == len(edges)
    return chain


def check_sides(vertices, faces, nodes):
    """How far, in units of 2^-46, a vertex of a face lies on the wrong side of a plane that it is
    under: at most PLANARITY_MAX << 30 in a sound tree."""
    worst = 0
    for node in nodes:
        planes, at = [], node
        while at.parent != NONE:
            above = nodes[at.parent]
            planes.append((1 if above.front != NONE and nodes[above.front] is at else -1, above))
            at = above
        for face in faces[node.first_face:node.first_face + node.face_count]:
            for corner in face.corners:
                for sign, above in planes:
                    out = -sign * (dot(above.normal, vertices[corner]) - above.distance)
                    worst = max(worst, out)
    return worst


@settings(max_examples=25, deadline=None)
@given(boxes)
def test_faces_keep_to_their_sides_and_an_image_of_them_is_sound(drawn):
    """bsp 2.4a."""
    made = random_scene(drawn)
    counts = tree.plant(made, {0})
    model = made.models[-1]
    assert check_sides(model.vertices, model.faces, made.tree.nodes) <= PLANARITY_MAX << 30
    assert counts.faces_out >= counts.faces_in
    again = image.unpack(image.pack(made))
    assert again == made and again.tree == made.tree


def in_order(nodes, faces, eye):
    """The numbers of the faces far to near, as docs/extras/bsp.md says."""
    order = []

    def visit(number):
        if number == NONE:
            return
        node = nodes[number]
        front = dot(node.normal, eye) > node.distance
        visit(node.back if front else node.front)
        order.extend(range(node.first_face, node.first_face + node.face_count))
        visit(node.front if front else node.back)
    visit(0)
    assert sorted(order) == list(range(len(faces)))
    return order


def hits(eye, way, points, faces):
    """(distance, number) of faces that a ray passes through well inside, and whether it came
    close to the edge of one."""
    found, close = [], False
    for number, face in enumerate(faces):
        corners = [points[c] for c in face.corners]
        slope = dot(face.normal, way)
        if slope >= 0:
            continue
        along = dot(face.normal, minus(corners[0], eye)) / slope
        if along <= 0:
            continue
        at = [e + along * w for e, w in zip(eye, way)]
        insides = []
        for a, b in zip(corners, corners[1:] + corners[:1]):
            edge = minus(b, a)
            out = cross(edge, face.normal)
            size = math.sqrt(dot(out, out))
            insides.append(-dot(out, minus(at, a)) / size if size else 1e9)
        if min(insides) > 64:
            found.append((along, number))
        elif min(insides) > -64:
            close = True
    return found, close


@settings(max_examples=25, deadline=None)
@given(boxes, st.integers(0, 2 ** 32))
def test_of_what_a_ray_hits_the_nearest_is_drawn_last(drawn, seed):
    made = random_scene(drawn)
    _, _, nodes, faces, _, points = grown(made)
    chance, judged = random.Random(seed), 0
    for _ in range(30):
        eye = tuple(chance.randint(-12 * ONE, 12 * ONE) for _ in range(3))
        place = {number: i for i, number in enumerate(in_order(nodes, faces, eye))}
        target = points[chance.choice(faces).corners[0]]
        way = [t - e + chance.gauss(0, ONE / 2) for t, e in zip(target, eye)]
        found, close = hits(eye, way, points, faces)
        if close:
            continue
        judged += 1
        found.sort()
        # Faces nearer to each other than the tree promises are no claim.
        length = math.sqrt(dot(way, way))
        for (near, a), (far, b) in zip(found, found[1:]):
            if (far - near) * length > 64:
                assert place[a] > place[b]
    assert judged >= 1 or not drawn


def test_beams_in_a_circle_are_split_and_any_order_of_beams_is_wrong():
    made = beams()
    _, _, nodes, faces, sources, points = grown(made)
    assert len(faces) > len(set(sources)) == 18
    chance, wrong = random.Random(5), 0
    for _ in range(400):
        turn = chance.uniform(0, 6.3)
        eye = tuple(int(c * ONE) for c in (5 * math.sin(turn), 3, 5 * math.cos(turn)))
        place = {number: i for i, number in enumerate(in_order(nodes, faces, eye))}
        way = [chance.uniform(-1, 1) * ONE - e for e in eye]
        found, close = hits(eye, way, points, faces)
        if close or len(found) < 2:
            continue
        found.sort()
        for (_, a), (_, b) in zip(found, found[1:]):
            assert place[a] > place[b]
        wrong += 1
    assert wrong > 20


def test_a_face_with_too_many_vertices_is_halved_and_loses_nothing():
    lines = tree.Lines()
    ring = [lines.vertex((round(9 * ONE * math.cos(-i / 30 * math.pi)), 0,
                          round(9 * ONE * math.sin(-i / 30 * math.pi)))) for i in range(60)]
    pieces = tree_faces.halve(lines, tree.Part(SQUARE_NORMAL, 7, 0, 0, ring))
    faces = [tree_faces.flat_face(lines, piece) for piece in pieces]
    assert all(3 <= len(face.corners) <= image.FACE_VERTICES_MAX for face in faces)
    assert chain_of(edges_of(faces)) == ring or set(chain_of(edges_of(faces))) == set(ring)
    areas = [newell([lines.points[v] for v in face.corners]) for face in faces]
    assert tuple(map(sum, zip(*areas))) == newell([lines.points[v] for v in ring])


def test_a_line_that_many_cut_gives_its_vertices_to_both_sides():
    """A wall before a picket fence: the fence's planes cut the one, and the neighbour shares."""
    models = [solid("box", (20, 4, 1))] + [solid("box", (Fraction(1, 4), 6, 6), (10, 0, 0))] * 30
    centres = [(0, 0, 0)] + [((i - 15) * 40000, 0, 0) for i in range(30)]
    made = scene(models, centres)
    _, _, _, faces, _, points = grown(made)
    assert edges_of(faces) == {}
    counts = tree.plant(made, {0})
    assert counts.splits > 100 and counts.shared > 0
    assert max(len(face.corners) for face in made.models[-1].faces) <= image.FACE_VERTICES_MAX


def test_faces_in_one_plane_share_a_node_and_keep_their_order():
    flat = Model([(-ONE, 0, -ONE), (-ONE, 0, ONE), (ONE, 0, ONE), (ONE, 0, -ONE)],
                 [Face(SQUARE_NORMAL, (0, 1, 2, 3), 1)], image.SORTED)
    made = scene([flat, flat, flat], [(0, 0, 0), (ONE, 0, 0), (0, 0, ONE)], [2, 1, 1])
    for model, colour in zip(made.models, (9, 5, 6)):
        made.models[made.models.index(model)] = Model(
            model.vertices, [Face(SQUARE_NORMAL, (0, 1, 2, 3), colour)], image.SORTED)
    counts = tree.plant(made, {1, 2})
    assert counts.nodes == 1 and counts.splits == 0
    assert [face.colour for face in made.models[-1].faces] == [5, 6, 9]
    assert made.objects[-1].layer == 2


def test_others_stay_as_they_are():
    made = scene([solid(), solid("octahedron"), solid("prism"), solid()],
                 [(0, 0, 0), (5 * ONE, 0, 0), (0, 5 * ONE, 0), (9 * ONE, 0, 0)], [1, 0, 1, 1])
    moving, still = made.models[2], made.models[1]
    tree.plant(made, {1}, moving=(2,))
    assert [made.models[item.model] for item in made.objects[:2]] == [still, moving]
    assert [item.layer for item in made.objects] == [0, 1, 1]
    assert made.tree.object == 2 and len(made.models) == 3
    assert len(made.models[-1].faces) == 12
    image.unpack(image.pack(made))


@pytest.mark.parametrize("text", ["", "7", "0,7", "most,1", "1,", "-1", "²"])
def test_layers_that_there_are_not_are_refused(text):
    with pytest.raises(ToolError, match="layers of the tree"):
        tree.layers_of(text, beams())


def test_what_cannot_have_a_tree_says_why():
    made = scene([solid(), solid(kind=image.SORTED)], [(0, 0, 0), (9 * ONE, 0, 0)])
    with pytest.raises(ToolError, match="not convex"):
        tree.plant(made, {0}, moving=(1,))
    with pytest.raises(ToolError, match="stands still"):
        tree.plant(made, {0}, moving=(0, 1))
    made = scene([solid(), solid()], [(0, 0, 0), (9 * ONE, 0, 0)], [0, 1])
    with pytest.raises(ToolError, match="not its last"):
        tree.plant(made, {0, 1}, moving=(0,))


def test_the_command_says_what_it_did(tmp_path, checkout):
    out = tmp_path / "knot.fxls"
    done = run_cli("build", checkout / "scenes/knot.toml", "-o", out, "--tree", "all")
    assert done.returncode == 0, done.stderr
    assert "18 faces in" in done.stderr and "splits" in done.stderr and "deep" in done.stderr
    done = run_cli("info", out)
    assert "tree" in done.stdout and "over object 1" in done.stdout
    done = run_cli("build", checkout / "scenes/knot.toml", "-o", out, "--tree", "3")
    assert done.returncode == 2 and "layers of the tree" in done.stderr


def test_a_mesh_of_its_own_is_cut_too():
    """A model that is not convex: a slab through a frame."""
    points = [(x * UNIT, y * UNIT, z * UNIT) for x, y, z in
              ((-3, -1, 0), (-3, 1, 0), (3, 1, 0), (3, -1, 0), (0, -2, -2), (0, -2, 2), (0, 2, 2), (0, 2, -2))]
    mesh = Mesh(points, [[0, 1, 2, 3], [3, 2, 1, 0], [4, 5, 6, 7], [7, 6, 5, 4]])
    made = shape(mesh, matrix([Fraction(1)] * 3, (0, 0, 0)), "cross")
    model = Model(made.vertices, [Face(f.normal, f.corners, 3) for f in made.faces], image.SORTED)
    crossed = scene([model], [(0, 0, 0)])
    counts = tree.plant(crossed, {0})
    assert counts.splits == 2 and counts.faces_out == 6


def test_a_plane_divides_if_something_is_in_it_or_on_either_side():
    unit = 65536
    points = [(x * unit, y * unit, 0) for x in (10, 20) for y in (0, 1, 2)]
    low, high, both = (types.SimpleNamespace(ring=ring) for ring in ([0, 1, 2], [3, 4, 5], [0, 1, 4, 3]))

    def costs(*parts):
        planes = [((1 << 30, 0, 0), (x * unit) << 30) for x in (5, 10, 15, 20, 30)]
        return [int(cost) for cost in np.concatenate(tree_choice._costs(points, list(parts), planes), axis=None)]
    none = tree_choice.COST_MAX
    assert costs(low, high) == [none, 1, 0, 1, none]
    assert costs(low, low, high) == [none, 1, 1, 2, none]
    assert costs(low) == [none, 0, none, none, none] and costs(high) == [none, none, none, 0, none]
    # One that crosses the plane is split.
    assert costs(both) == [none, none, tree_choice.SPLIT_COST, none, none]
    assert costs(both, high) == [none, none, tree_choice.SPLIT_COST + 1, 1, none]


@pytest.mark.parametrize("points", [[(0, 0, 0), (2, 0, 0), (0, 4, 2)], [(0, 0, 0), (6, 0, 0), (0, 8, 0)]])
def test_a_node_s_sphere_is_the_least_whole_one_about_its_faces(points):
    node = Node(SQUARE_NORMAL, 0, NONE, NONE, NONE, 0, 1)
    tree_faces.add_spheres([node], [Face(SQUARE_NORMAL, (0, 1, 2), 1)], points)
    farthest = max(math.dist(point, node.centre) for point in points)
    assert farthest <= node.radius < farthest + 1
