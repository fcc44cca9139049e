# SPDX-License-Identifier: MIT
"""Smooth light: normals of a file, vn of OBJ, NORMAL of glTF, for a model without a scene file and for smooth = "file"; and where a file has
none, which edges do not show, by the shape, and by the smoothing groups of OBJ."""

import json
import math
import random

import numpy
import pytest

from conftest import CHECKOUT, run_cli
from fixel.base.errors import ToolError
from fixel.image import image
from fixel.model import creases, gltf, obj, solids
from fixel.model.mesh import UNIT, newell
from fixel.scene import compiler, look, target, toml_scene
from model_files import File, build

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "host/frames", "host/judge", "host/raycast", "host/predict")
ONE = 1 << 30


def compiled(path, **wanted):
    made, notes = compiler.compile_scene(str(path), 4, look=look.Look(**wanted))
    assert image.unpack(image.pack(made)) == made
    return made, notes


def corners(made):
    """{(corner, the face's normal): the normal there} of all faces that are lit at their corners, as unit vectors."""
    found = {}
    for model in made.models:
        for face in model.faces:
            for vertex, number in zip(face.mapped.vertices, face.mapped.normals) if face.mapped else ():
                found[model.vertices[vertex], face.normal] = numpy.array(made.surfaces.normals[number]) / ONE
    return found


def roof(path, normals, scale=1):
    """A roof of two faces that bend by 90 degrees, with these normals at the ridge."""
    text = f"v -1 0 0\nv 0 {scale} 0\nv 1 0 0\nv -1 0 4\nv 0 {scale} 4\nv 1 0 4\n" + "".join(f"vn {' '.join(map(str, normal))}\n" for normal in normals)
    path.write_text(text + "f 1//1 4//1 5//2 2//2\nf 2//2 5//2 6//3 3//3\n")
    return path


UP = [(-1, 1, 0), (0, 1, 0), (1, 1, 0)]


def test_normals_of_an_obj_file_make_smooth_light(tmp_path):
    made, _ = compiled(roof(tmp_path / "m.obj", UP))
    found = corners(made)
    ridge = [normal for (vertex, _), normal in found.items() if vertex[1] == max(v[1] for v, _ in found)]
    assert made.light and len(ridge) >= 4 and all(abs(abs(normal[1]) - 1) < 1e-6 for normal in ridge)
    # The file is open: the backs have the same normals, turned round.
    assert {round(float(normal[1])) for normal in ridge} == {1, -1}
    by_angle, _ = compiled(tmp_path / "m.obj", normals=False)       # --smooth: the edge of 90 degrees shows
    assert by_angle.light is None and by_angle.surfaces is None


def test_a_file_whose_normals_are_those_of_its_faces_is_flat(tmp_path):
    """A bowl that the crease would make smooth."""
    rows, faces = [], []
    for y in range(5):
        for x in range(5):
            rows.append(f"v {x} {-((x - 2) ** 2 + (y - 2) ** 2) / 16} {y}\n")
    for y in range(4):
        for x in range(4):
            a = 5 * y + x + 1
            faces += [(a, a + 5, a + 6), (a, a + 6, a + 1)]
    points = [tuple(map(float, row.split()[1:])) for row in rows]
    normals = []
    for face in faces:
        p, q, r = (numpy.array(points[c - 1]) for c in face)
        normals.append(numpy.cross(q - p, r - p))
    (tmp_path / "plain.obj").write_text("".join(rows) + "".join("f %d %d %d\n" % face for face in faces))
    (tmp_path / "flat.obj").write_text("".join(rows) + "".join("vn %g %g %g\n" % tuple(n) for n in normals) +
                                       "".join("f " + " ".join(f"{c}//{i + 1}" for c in face) + "\n" for i, face in enumerate(faces)))
    assert compiled(tmp_path / "plain.obj")[0].light and compiled(tmp_path / "flat.obj")[0].light is None
    assert compiled(tmp_path / "flat.obj", normals=False)[0].light


def test_normals_of_a_gltf_file_turn_with_their_node(tmp_path):
    slant = numpy.array([3.0, 1.0, 0.0])
    made = File({"name": "box", "mesh": 0, "rotation": [0, 0, math.sin(math.pi / 4), math.cos(math.pi / 4)], "scale": [2, 1, 1]})
    mesh = made.box()
    made.data["meshes"][mesh]["primitives"][0]["attributes"]["NORMAL"] = made.add([slant] * 8, "<f4", "VEC3")
    read, _ = gltf.read(str(made.write(tmp_path / "m.glb")))
    wanted = numpy.array([-1.0, 1.5, 0.0])      # (3 / 2, 1, 0), a quarter turn about z
    wanted /= numpy.linalg.norm(wanted)
    assert all(numpy.allclose(normal, wanted) for normals in read.normals for normal in normals)


def test_a_mirrored_node_has_normals_that_look_outward(tmp_path):
    made = File({"name": "ball", "mesh": 0, "scale": [-1, 1, 1]}, {"name": "ball", "mesh": 0, "translation": [3, 0, 0]}, roots=[0, 1])
    mesh = made.box()
    made.data["meshes"][mesh]["primitives"][0]["attributes"]["NORMAL"] = made.add(
        [[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], "<f4", "VEC3")
    scene, _ = compiled(made.write(tmp_path / "m.glb"))
    found = corners(scene)
    assert len(found) > 20
    for (vertex, _), normal in found.items():
        assert numpy.allclose(normal, numpy.sign(vertex) / math.sqrt(3), atol=1e-5)


def test_normals_that_are_none_and_damaged_ones_are_left_out(tmp_path):
    for second in ((0, 0, 0), ("1e-200", 0, 0), ("1e200", 0, 0)):
        made, _ = compiled(roof(tmp_path / "m.obj", [(-1, 1, 0), second, ("nan", 1, 0)]))
        assert made.light is None
    (tmp_path / "n.obj").write_text((tmp_path / "m.obj").read_text().replace("//3", "//9"))
    assert compiled(tmp_path / "n.obj")[0].light is None
    file = File({"mesh": 0})
    mesh = file.box()
    file.data["meshes"][mesh]["primitives"][0]["attributes"]["NORMAL"] = file.add([[0, 1, 0]] * 5, "<f4", "VEC3")
    read, _ = gltf.read(str(file.write(tmp_path / "m.glb")))
    assert read.normals == []


def test_vertices_in_the_middle_of_an_edge_have_normals_between(tmp_path):
    """A T-junction on the ridge of the roof: the left face is divided there."""
    (tmp_path / "m.obj").write_text("v -1 0 0\nv 0 1 0\nv 1 0 0\nv -1 0 4\nv 0 1 4\nv 1 0 4\nv 0 1 1\nv 1 0 1\nvn -1 1 0\nvn 0 1 0\nvn 1 1 0\nvn 0 1 1\n"
                                    "f 1//1 4//1 5//4 2//2\nf 2//2 7//2 8//3 3//3\nf 7//2 5//2 6//3 8//3\n")
    made, notes = compiled(tmp_path / "m.obj")
    assert any("had vertices of other faces on them" in note for note in notes)
    top = max(vertex[1] for vertex, _ in corners(made))
    found = [normal for (vertex, own), normal in corners(made).items() if vertex[1] == top and own[0] < 0 and own[1] > 0]
    bends = sorted(round(float(-normal[2]), 3) for normal in found)
    assert bends[0] == 0 and bends[-1] == round(math.sqrt(0.5), 3)
    between = numpy.array([0, 1, 0.25]) / numpy.linalg.norm([0, 1, 0.25])
    assert len(found) == 2 or round(float(between[2]), 3) in bends


def test_smooth_file_of_a_scene_file(tmp_path):
    roof(tmp_path / "m.obj", UP)
    scene = '[light]\nlevels = 8\n[[objects]]\nmodel = "m.obj"\nrotation = 90\nscale = [1, 2, 1]\nsmooth = "file"\n'
    (tmp_path / "s.toml").write_text(scene)
    made, _ = toml_scene.compile_file(str(tmp_path / "s.toml"))
    found = {tuple(round(float(c), 4) for c in normal) for normal in corners(made).values()}
    # (-1, 1 / 2, 0) and (1, 1 / 2, 0), a quarter turn about y.
    slope = round(2 / math.sqrt(5), 4)
    assert (0, 1, 0) in found and {(0, round(slope / 2, 4), z) for z in (-slope, slope)} <= found
    (tmp_path / "s.toml").write_text(scene.replace('model = "m.obj"', 'solid = "box"'))
    with pytest.raises(ToolError, match='"file" means nothing for a solid'):
        toml_scene.compile_file(str(tmp_path / "s.toml"))


def test_a_file_without_normals_takes_the_crease(tmp_path):
    (tmp_path / "m.obj").write_text("v -1 0 0\nv 0 0.2 0\nv 1 0 0\nv -1 0 4\nv 0 0.2 4\nv 1 0 4\nf 1 4 5 2\nf 2 5 6 3\n")
    scene = '[light]\nlevels = 8\n[[objects]]\nmodel = "m.obj"\nsmooth = {}\n'
    found = []
    for value in ('"file"', 40):
        (tmp_path / "s.toml").write_text(scene.format(value))
        found.append(image.pack(toml_scene.compile_file(str(tmp_path / "s.toml"))[0]))
    assert found[0] == found[1]


def test_a_model_with_normals_is_drawn_as_double_draws_it_and_by_its_scene_file(build, tmp_path):
    path = roof(tmp_path / "m.obj", UP)
    done = run_cli("run", "--board", "mps2-an385", "--scene", path, "--frames", 4, "--out", tmp_path / "run", "--write", tmp_path / "s.toml")
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "run" / "summary.json").read_text())
    assert summary["pixels_unexplained"] == 0 and summary["host_frames_equal"]
    assert 'smooth = "file"' in (tmp_path / "s.toml").read_text()
    made, _ = compiler.compile_scene(str(path), 4, look=look.Look())
    assert image.pack(toml_scene.compile_file(str(tmp_path / "s.toml"))[0]) == image.pack(made)


def test_obj_normals_run_as_the_corners_do(tmp_path):
    read, _ = obj.read(str(roof(tmp_path / "m.obj", UP)))
    for face, normals in zip(read.faces, read.normals):
        for corner, normal in zip(face, normals):
            assert normal[0] == math.copysign(1, read.vertices[corner][0]) * (read.vertices[corner][0] != 0) and normal[1] == 1


# --- by the angle of edges -----------------------------------------------------------------------

def normals_at(made):
    """{vertex: the normals that faces have there} of a scene's first model, and how many corners its lit faces have."""
    found, model = {}, made.models[0]
    for face in model.faces:
        if face.mapped:
            for vertex, normal in zip(face.mapped.vertices, face.mapped.normals):
                found.setdefault(vertex, set()).add(made.surfaces.normals[normal])
    return found, {len(face.corners) for face in model.faces if face.mapped}


def test_an_edge_that_bends_little_does_not_show_where_faces_across_a_vertex_bend_more():
    """A ball of 12 x 6: its edges bend by at most 30 degrees, two faces that meet at a vertex alone by 42."""
    made, _ = compiler.compile_scene(str(CHECKOUT / "host_tests" / "tools" / "models" / "ball_textured.obj"), 4, look=look.Look())
    found, corners = normals_at(made)
    assert len(found) == len(made.models[0].vertices) and {len(normals) for normals in found.values()} == {1} and corners == {3}


def test_a_face_whose_light_is_linear_is_not_cut(tmp_path):
    """A ring of a cylinder; rings of a cone and of a ball, whose quadrilaterals are no parallelograms."""
    def ring(name, *circles):
        rows = [f"v {r * math.cos(math.pi * i / 8)} {y} {r * math.sin(math.pi * i / 8)}" for r, y in circles for i in range(16)]
        rows += [f"f {16 * k + i + 1} {16 * k + 16 + i + 1} {16 * k + 16 + (i + 1) % 16 + 1} {16 * k + (i + 1) % 16 + 1}" for k in range(len(circles) - 1)
                 for i in range(16)]
        (tmp_path / name).write_text("\n".join(rows))
        return normals_at(compiler.compile_scene(str(tmp_path / name), 4, look=look.Look())[0])
    assert ring("cylinder.obj", (1, 0), (1, 1))[1] == {4}
    assert ring("cone.obj", (1, 0), (0.5, 1))[1] == {3}
    assert ring("ball.obj", (1, 0), (0.87, 0.5), (0.5, 0.87))[1] == {3}


def test_edges_that_show_part_the_normals_of_a_vertex(tmp_path):
    """A roof whose two sides bend by 60 degrees, each of two faces that bend by 10: two normals at each vertex of the ridge."""
    steep, flat = math.tan(math.radians(35)), math.tan(math.radians(25))
    profile = [(-2, -steep - flat), (-1, -flat), (0, 0), (1, -flat), (2, -steep - flat)]
    rows = [f"v {x} {y} {z}" for z in (0, 3) for x, y in profile] + [f"f {i} {i + 5} {i + 6} {i + 1}" for i in range(1, 5)]
    (tmp_path / "m.obj").write_text("\n".join(rows))
    made, _ = compiler.compile_scene(str(tmp_path / "m.obj"), 4, look=look.Look())
    lines = {}      # along the roof: a face has normals at three of its corners
    for vertex, normals in normals_at(made)[0].items():
        lines.setdefault(made.models[0].vertices[vertex][:2], set()).update(normal for normal in normals if normal[1] > 0)
    assert [len(lines[line]) for line in sorted(lines)] == [1, 1, 2, 1, 1]


# --- edges that do not show -------------------------------------------------------------------

def triangles(outlines):
    return [[corners[0], corners[i], corners[i + 1]] for corners in outlines for i in range(1, len(corners) - 1)]


def edges(points, outlines, **how):
    """{bend in whole degrees: (edges that show, edges that do not)}."""
    normals = [newell([points[corner] for corner in corners]) for corners in outlines]
    units = [[c / math.hypot(*normal) for c in normal] for normal in normals]
    smooth, found = creases.smooth_pairs(points, outlines, units, [False] * len(outlines), **how), {}
    for one, other, _ in creases._pairs(outlines, [False] * len(outlines)):
        cosine = sum(a * b for a, b in zip(units[one], units[other]))
        found.setdefault(round(math.degrees(math.acos(max(-1, min(1, cosine))))), [0, 0])[(one, other) in smooth] += 1
    return {bend: tuple(counts) for bend, counts in found.items() if bend}


def solid(name, **options):
    made = solids.make(name, options, "")
    height = 0.25 if name == "torus" else 1
    return [(x / UNIT, height * y / UNIT, z / UNIT) for x, y, z in made.vertices], [list(face) for face in made.faces]


def bar(profile):
    """A bar of 10 units with this outline."""
    count = len(profile)
    return [(x, y, z) for z in (0, 10) for x, y in profile], [list(range(count))[::-1], list(range(count, 2 * count))] + \
        [[i, (i + 1) % count, count + (i + 1) % count, count + i] for i in range(count)]


def plate(sides):
    """A plate of a regular outline whose upper edge has a chamfer of 30 degrees."""
    part = 1 / math.cos(math.pi / sides)
    rings = [(5, 0), (5, 1), (5 - 0.5 / math.tan(math.radians(30)), 1.5)]
    points = [(part * r * math.cos(2 * math.pi * i / sides), y, part * r * math.sin(2 * math.pi * i / sides)) for r, y in rings for i in range(sides)]
    return points, [list(range(sides)), [2 * sides + i for i in range(sides)][::-1]] + \
        [[low * sides + i, low * sides + sides + i, low * sides + sides + (i + 1) % sides, low * sides + (i + 1) % sides] for low in (0, 1) for i in range(sides)]


def dome(sides, rings):
    """A half of a ball on a flat floor."""
    points = [(math.cos(a) * math.cos(b), math.sin(a), math.cos(a) * math.sin(b)) for a in (math.pi / 2 * j / rings for j in range(rings))
              for b in (2 * math.pi * i / sides for i in range(sides))] + [(0, 1, 0)]
    return points, [list(range(sides))] + [[j * sides + i, j * sides + sides + i, j * sides + sides + (i + 1) % sides, j * sides + (i + 1) % sides]
                                           for j in range(rings - 1) for i in range(sides)] + \
        [[(rings - 1) * sides + i, rings * sides, (rings - 1) * sides + (i + 1) % sides] for i in range(sides)]


RISE = 10 * math.tan(math.radians(30))
ROUND = {"ball": solid("sphere", sides=12, rings=6), "coarse ball": solid("sphere", sides=10, rings=5), "cone": solid("cone", sides=12),
         "ring": solid("torus", sides=12, rings=10), "cylinder": solid("cylinder", sides=12), "dome": dome(12, 3),
         "arch": bar([(10 * math.cos(math.radians(a)), 10 * math.sin(math.radians(a))) for a in range(0, 181, 30)])}
EDGED = {"roof": bar([(0, 0), (20, 0), (20, 5), (10, 5 + RISE / 2.155), (0, 5)]), "chamfers": bar([(0, 0), (30, 0), (30, 5), (20, 5 + RISE), (10, 5 + RISE), (0, 5)]),
         "ramp": bar([(0, 0), (40, 0), (40, 5 + RISE), (20, 5 + RISE), (10, 5), (0, 5)]), **{f"plate of {sides}": plate(sides) for sides in (4, 6, 8)},
         "dice": solid("dodecahedron")}


@pytest.mark.parametrize("cut", [list, triangles])
@pytest.mark.parametrize("name", ROUND)
def test_no_edge_of_a_round_shape_of_few_faces_shows(name, cut):
    points, outlines = ROUND[name]
    found = edges(points, cut(outlines))
    assert any(20 < bend <= 40 for bend in found)
    assert all(shown == 0 if bend <= 40 else hidden == 0 for bend, (shown, hidden) in found.items())


@pytest.mark.parametrize("cut", [list, triangles])
@pytest.mark.parametrize("name", EDGED)
def test_edges_of_30_degrees_of_a_part_with_flat_faces_show(name, cut):
    points, outlines = EDGED[name]
    found = edges(points, cut(outlines))
    assert all(hidden == 0 for bend, (_, hidden) in found.items() if bend > 25)
    assert all(hidden == 0 for bend, (_, hidden) in edges(points, cut(outlines), degrees=20).items() if bend > 25)
    assert name == "dice" or edges(points, cut(outlines), degrees=40)[30][0] == 0     # as who asks for degrees gets them


def test_a_chamfer_round_a_cylinder_shows_and_the_cylinder_does_not():
    found = edges(*plate(12))
    assert found[30] == (12, 12) and found[15] == (0, 12)


def half_pipe(path, groups):
    """Twelve faces that bend by 15 degrees each; groups: what stands before each, such as "s 1"."""
    lines = [f"v {math.cos(a):.6f} {math.sin(a):.6f} {z}" for a in (math.pi * i / 12 for i in range(13)) for z in (-1, 1)]
    for i, group in enumerate(groups):
        a = 2 * i + 1
        lines += [group, f"f {a} {a + 1} {a + 3} {a + 2}"]
    path.write_text("\n".join(lines) + "\n")
    return path


@pytest.mark.parametrize("groups, smooth", [
    ([""] * 12, 11), (["s 1"] * 12, 11), (["s 1"] * 6 + ["s 2"] * 6, 10), (["s off"] * 12, 0), (["s 0"] * 12, 0), (["s 1"] * 6 + ["s off"] * 6, 5),
    (["s on"] * 12, 11), (["s 01", "s 1"] * 6, 11), (["s what"] * 12, 11), ([""] * 6 + ["s 3"] * 6, 11), (["s 1", "s 2"] * 6, 0)])
def test_smoothing_groups_of_obj(tmp_path, groups, smooth):
    mesh, notes = obj.read(str(half_pipe(tmp_path / "m.obj", groups)))
    assert not any("ignored" in note for note in notes)
    points = [[c / UNIT for c in vertex] for vertex in mesh.vertices]
    found = edges(points, mesh.faces, groups=mesh.smoothing or None)
    assert found == {15: (11 - smooth, smooth)}
    made, _ = compiler.compile_scene(str(tmp_path / "m.obj"), 2, look=look.Look())
    assert image.unpack(image.pack(made)) == made and (made.light is None) == (smooth == 0)
    flat, _ = compiler.compile_scene(str(tmp_path / "m.obj"), 2, look=look.Look(normals=False))
    assert flat.light       # --smooth 40 counts degrees alone


def test_normals_of_the_file_go_before_its_groups(tmp_path):
    path = half_pipe(tmp_path / "m.obj", ["s off"] * 12)
    text = path.read_text().splitlines()
    text = [line if not line.startswith("f ") else "f " + " ".join(f"{word}//{(int(word) + 1) // 2}" for word in line.split()[1:]) for line in text]
    path.write_text("\n".join([*(f"vn {math.cos(a):.6f} {math.sin(a):.6f} 0" for a in (math.pi * i / 12 for i in range(13))), *text]) + "\n")
    made, _ = compiler.compile_scene(str(path), 2, look=look.Look())
    assert made.light and len(made.surfaces.normals) >= 13


def test_a_group_is_smooth_however_much_its_edges_bend_and_a_scene_file_reads_it(tmp_path):
    """A box of one group, and the same without: by the key smooth = "file"."""
    sides = "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n"
    corners = "".join(f"v {x} {y} {z}\n" for y in (0, 1) for x, z in ((0, 0), (1, 0), (1, 1), (0, 1)))
    scene = '[light]\nlevels = 8\n[[objects]]\nmodel = "m.obj"\nsmooth = "file"\n'
    (tmp_path / "s.toml").write_text(scene)
    for group, count in (("s 1\n", 8), ("", 0), ("s off\n", 0)):
        (tmp_path / "m.obj").write_text(corners + group + sides)
        made, _ = toml_scene.compile_file(str(tmp_path / "s.toml"))
        assert len(made.surfaces.normals if made.surfaces else ()) == count


def test_a_scene_file_of_a_model_by_its_shape_gives_the_same_frames(tmp_path):
    half_pipe(tmp_path / "m.obj", ["s 1"] * 6 + ["s 2"] * 6)
    made, _ = compiler.compile_scene(str(tmp_path / "m.obj"), 2, look=look.Look(), write=str(tmp_path / "s.toml"))
    (tmp_path / "s.toml").write_text(made.text)
    assert 'smooth = "file"' in made.text
    again, _ = toml_scene.compile_file(str(tmp_path / "s.toml"))
    assert image.pack(again) == image.pack(made)


def fine_plate(count):
    """A plate of so many sides with a chamfer, as triangles."""
    points = [(radius * math.cos(2 * math.pi * i / count), radius * math.sin(2 * math.pi * i / count), z)
              for radius, z in ((1, 0), (1.01, -0.005), (1.01, -1)) for i in range(count)] + [(0, 0, 0)]
    faces = []
    for i, j in ((i, (i + 1) % count) for i in range(count)):
        faces += [[3 * count, i, j], [i, count + i, j], [j, count + i, count + j], [count + i, 2 * count + i, count + j],
                  [count + j, 2 * count + i, 2 * count + j]]
    return points, faces


def fan(count):
    """Faces that share one edge."""
    chance = random.Random(count)
    return [(0, 0, 0), (0, 1, 0), *([chance.random() for _ in range(3)] for _ in range(count))], [[0, 1, 2 + i] for i in range(count)]


@pytest.mark.parametrize("shape", [fine_plate, fan])
def test_the_work_grows_little_faster_than_the_faces(monkeypatch, shape):
    """Eight times the faces: less than 24 times the edges that are looked at, where each with each would be 64 times."""
    made, real = [], creases._Bends.__init__

    def init(self, *given):
        real(self, *given)
        made.append(self)
    monkeypatch.setattr(creases._Bends, "__init__", init)
    for count in (200, 1600):
        edges(*shape(count))
    few, many = (each.looked for each in made)
    assert many < 24 * max(few, 200)


# --- textured balls: small triangles with light are functions of the screen (SPEC.md, section 9.1.1) ---

BALL = """[view]
pixels = "rgb565"
visibility = "depth"
[light]
levels = 8
[[textures]]
name = "t"
pattern = "checker"
[[objects]]
solid = "sphere"
position = [0, 0, 5]
texture = "t"
smooth = true
"""
LIKE_BALL = {"lens": ("[view]", "[view]\nscale = 40"), "palette": ('pixels = "rgb565"\n', ""), "32 bits": ('visibility = "depth"', "depth = 32"),
             "order": ('visibility = "depth"', ""), "every pixel": ('texture = "t"', 'texture = "t"\ndivision = 1'),
             "stipple": ('texture = "t"', 'texture = "t"\nopacity = 8'), "blended": ('texture = "t"', 'texture = "t"\nblend = "add"'),
             "no texture": ('texture = "t"', 'colour = "gold"'), "4 bits": ('pattern = "checker"', 'pattern = "checker"\nbits = 4'),
             "edges": ('pattern = "checker"', 'pattern = "checker"\nwrap = "clamp"'), "flat": ("smooth = true", "lit = true"),
             "band": ('"sphere"', '"band"')}


def test_textured_faces_of_a_ball_are_triangles(tmp_path):
    """All light is of their own corners then."""
    made = build(tmp_path, BALL)
    [model] = made.models
    assert len(model.faces) == 12 * 4 * 2 + 24 and all(len(face.corners) == 3 for face in model.faces)
    for (vertex, _), normal in corners(made).items():
        assert normal @ vertex > 0.99 * math.hypot(*vertex)


@pytest.mark.parametrize("name", LIKE_BALL)
def test_other_faces_stay_whole(tmp_path, name):
    assert any(len(face.corners) == 4 for model in build(tmp_path, BALL.replace(*LIKE_BALL[name])).models for face in model.faces)


@pytest.mark.parametrize("asked, sides", [(("rgb565", None, "16"), {3}), (("rgb565", None, "32"), {3, 4}), (("palette", None, None), {3, 4})])
def test_what_a_command_asks_for_decides_too(tmp_path, asked, sides):
    file = tmp_path / "s.toml"
    file.write_text(BALL if asked[0] == "palette" else BALL.replace(BALL[:BALL.index("[light]")], ""))
    made, _ = compiler.compile_scene(str(file), 4, asked=target.Target(*asked))
    assert {len(face.corners) for face in made.models[0].faces} == sides


def test_some_faces_of_a_ball_have_a_texture(tmp_path):
    """Every other one: the others stay whole."""
    [model] = build(tmp_path, BALL.replace('texture = "t"', 'textures = ["t", ""]')).models
    sides = [len(face.corners) for face in model.faces]
    assert sides.count(4) == 24 and sides.count(3) == 24 * 2 + 24
