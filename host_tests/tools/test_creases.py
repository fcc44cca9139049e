# SPDX-License-Identifier: MIT
"""Which edges do not show in smooth light where a file has no normals: by the shape, and by the smoothing groups of OBJ."""

import math
import random

import pytest

from fixel.image import image
from fixel.model import creases, obj, solids
from fixel.model.mesh import UNIT, newell
from fixel.scene import compiler, look, toml_scene


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
