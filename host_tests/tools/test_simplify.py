# SPDX-License-Identifier: MIT
"""Models of fewer faces: borders, seams, names and closed edges stay, and what is said is measured."""

import collections
import math
import os
import types

import numpy
import pytest

from conftest import run_cli
from fixel.base import interpreter
from fixel.base.errors import ToolError
from fixel.board import flash_memory
from fixel.image import image
from fixel.model import obj, simplify
from fixel.model.mesh import UNIT
from fixel.scene import compiler, look, toml_model
from model_files import png

BUILT_PROGRAMS = ()
SET_UP = pytest.mark.skipif(simplify.module() is None, reason="tools/setup.sh simplify has not set up meshoptimizer")


def ball(folder, sides=48, rings=32, images=True, groups=True, bump=0.08):
    """A closed ball with a seam of texture coordinates, and with two materials that meet at the equator."""
    lines = ["mtllib m.mtl"]
    for ring in range(1, rings):
        for side in range(sides):
            a, b = math.pi * ring / rings, 2 * math.pi * side / sides
            r = 1 + bump * math.sin(3 * b) * math.sin(a) ** 3
            lines.append(f"v {r * math.sin(a) * math.cos(b):.6f} {r * math.cos(a):.6f} {r * math.sin(a) * math.sin(b):.6f}")
    lines += ["v 0 1 0", "v 0 -1 0"]
    north, south = sides * (rings - 1) + 1, sides * (rings - 1) + 2
    for ring in range(rings + 1):
        lines += [f"vt {side / sides:.6f} {1 - ring / rings:.6f}" for side in range(sides + 1)]

    def corner(ring, side):
        vertex = north if ring == 0 else south if ring == rings else (ring - 1) * sides + side % sides + 1
        return f"{vertex}/{ring * (sides + 1) + side + 1}"
    for half, (first, end) in enumerate(((0, rings // 2), (rings // 2, rings))):
        lines += [f"g {'upper lower'.split()[half]}"] * groups + [f"usemtl {'cloth skin'.split()[half]}"]
        for ring in range(first, end):
            for side in range(sides):
                quad = [corner(ring, side), corner(ring, side + 1), corner(ring + 1, side + 1), corner(ring + 1, side)]
                quad = quad[1:] if ring == 0 else quad[:3] if ring == rings - 1 else quad
                lines.append("f " + " ".join(quad))
    (folder / "m.obj").write_text("\n".join(lines) + "\n")
    picture = "map_Kd m.png\n" if images else ""
    (folder / "m.mtl").write_text(f"newmtl cloth\nKd 1 1 1\n{picture}newmtl skin\nKd 0.5 0.2 0.1\n{picture}")
    (folder / "m.png").write_bytes(png([[(8 * x, 8 * y, 99) for x in range(32)] for y in range(32)]))
    return obj.read(str(folder / "m.obj"), "m.obj")[0]


def between(mesh, key_of):
    """The places of vertices of edges at which faces differ in a key: key_of(face, {vertex: corner})."""
    found = collections.defaultdict(set)
    for number, face in enumerate(mesh.faces):
        for a, b in zip(face, [*face[1:], face[0]]):
            ends = tuple(sorted((mesh.vertices[a], mesh.vertices[b])))
            found[ends].add(key_of(number, {mesh.vertices[c]: i for i, c in enumerate(face)}, ends))
    return {end for ends, keys in found.items() if len(keys) > 1 for end in ends}


def material(mesh):
    return between(mesh, lambda face, corners, ends: mesh.surfaces.of_face[face])


def seams(mesh):
    """But for the poles, where every edge is one."""
    return between(mesh, lambda face, corners, ends: tuple(tuple(mesh.surfaces.uvs[face][corners[end]]) for end in ends
                                                           if abs(end[1]) < UNIT))


def open_ends(mesh):
    """The places of the ends of open edges."""
    count = collections.Counter()
    for face in mesh.faces:
        for a, b in zip(face, [*face[1:], face[0]]):
            a, b = mesh.vertices[a], mesh.vertices[b]
            count[min(a, b), max(a, b)] += 1 if a < b else -1
    return {end for ends, sum_ in count.items() if sum_ for end in ends}


@SET_UP
@pytest.mark.parametrize("count", [1500, 700, 300])
def test_borders_seams_names_and_closed_edges_stay(tmp_path, count):
    mesh = ball(tmp_path)
    made = simplify.simplified(mesh, count, "m.obj")
    assert made.before == 48 * 2 * 31 and 0.9 * count <= len(made.mesh.faces) <= count
    assert not open_ends(mesh) and not open_ends(made.mesh)
    assert set(made.mesh.vertices) <= set(mesh.vertices)        # no vertex moves
    for places in (material, seams):
        assert len(places(mesh)) > 20 and 4 < len(places(made.mesh)) < len(places(mesh))
        assert places(made.mesh) <= places(mesh)
    assert made.mesh.surfaces.materials is mesh.surfaces.materials
    for name, sign in (("upper", 1), ("lower", -1)):
        numbers = [number for first, end in made.mesh.groups[name] for number in range(first, end)]
        assert numbers and {made.mesh.surfaces.of_face[number] for number in numbers} == {0 if sign > 0 else 1}
        assert all(sign * made.mesh.vertices[corner][1] >= 0 for number in numbers for corner in made.mesh.faces[number])
    assert sorted(number for runs in made.mesh.groups.values() for first, end in runs for number in range(first, end)) == \
        list(range(len(made.mesh.faces)))


@SET_UP
def test_texture_coordinates_stay_those_of_their_places(tmp_path):
    mesh = ball(tmp_path)
    made = simplify.simplified(mesh, 500, "m.obj").mesh
    known = {(mesh.vertices[c], tuple(uv)) for face, uvs in zip(mesh.faces, mesh.surfaces.uvs) for c, uv in zip(face, uvs)}
    assert all((made.vertices[c], tuple(uv)) in known for face, uvs in zip(made.faces, made.surfaces.uvs) for c, uv in zip(face, uvs))


@SET_UP
def test_the_border_of_an_open_model_keeps_its_vertices(tmp_path):
    mesh = ball(tmp_path).part("upper")
    made = simplify.simplified(mesh, 300, "m.obj").mesh
    assert open_ends(made) and open_ends(made) <= open_ends(mesh)


@SET_UP
def test_colours_of_vertices_are_kept(tmp_path):
    mesh = ball(tmp_path, images=False, groups=False)
    mesh.surfaces.of_face = [0] * len(mesh.faces)
    mesh.surfaces.tints = [(250, 0, 0) if mesh.vertices[face[0]][0] > 0 else (0, 0, 250) for face in mesh.faces]
    made = simplify.simplified(mesh, 600, "m.obj").mesh
    for face, tint in zip(made.faces, made.surfaces.tints):
        x = numpy.mean([made.vertices[corner][0] for corner in face]) / UNIT
        assert abs(x) < 0.3 or (tint[0] > 200) == (x > 0)


@SET_UP
def test_a_model_without_images_and_groups(tmp_path):
    mesh = ball(tmp_path, images=False, groups=False)
    mesh.surfaces.of_face = [1] * len(mesh.faces)
    made = simplify.simplified(mesh, 700, "m.obj").mesh
    assert 600 <= len(made.faces) <= 700 and not open_ends(made)
    assert set(made.vertices) <= set(mesh.vertices) and set(made.surfaces.of_face) == {1}


@pytest.mark.parametrize("installed, cure", [(False, "tools/setup.sh simplify"), (True, "npm install meshoptimizer")], ids=["checkout", "package"])
@pytest.mark.parametrize("lacks", ["node", "module"])
def test_what_is_not_set_up_is_refused_with_the_command_for_it(tmp_path, monkeypatch, installed, cure, lacks):
    """A package of pip finds the module where its user works."""
    tree, work, programs = tmp_path / "tree", tmp_path / "work", tmp_path / "programs"
    for folder in (tree / "tools", work, programs):
        folder.mkdir(parents=True)
    if installed:
        (tree / "installed").write_text("")
    if lacks == "node":
        module = (work if installed else tree / ".node") / "node_modules" / "meshoptimizer" / "meshopt_simplifier.js"
        module.parent.mkdir(parents=True)
        module.write_text("")
    else:
        (programs / "node").write_text("#!/bin/sh\n")
        (programs / "node").chmod(0o755)
    monkeypatch.setattr(interpreter, "TOOLS", tree / "tools")
    monkeypatch.setattr(interpreter, "INSTALLED", tree / "installed")
    monkeypatch.chdir(work)
    monkeypatch.setenv("PATH", str(programs))
    with pytest.raises(ToolError) as caught:
        simplify.simplified(ball(tmp_path), 700, "m.obj")
    assert all(word in str(caught.value) for word in ("m.obj: simplify: ", "node", cure)) and "\n" not in str(caught.value)
    if lacks == "node":
        (programs / "node").write_text("#!/bin/sh\n")
        (programs / "node").chmod(0o755)
        assert simplify.module() == module


def test_a_model_with_fewer_faces_stays_as_it_is(tmp_path):
    assert simplify.simplified(ball(tmp_path, 8, 6), 1000, "m.obj") is None


@SET_UP
def test_no_group_goes_where_very_few_faces_are_asked_for(tmp_path):
    """A large ball and four small ones, of which no face was left."""
    ball(tmp_path, sides=24, rings=16, images=False, groups=False)
    plain = [line for line in (tmp_path / "m.obj").read_text().splitlines() if line[:2] in ("v ", "f ")]
    points = [list(map(float, line.split()[1:])) for line in plain if line[0] == "v"]
    faces = [[int(each.split("/")[0]) for each in line.split()[1:]] for line in plain if line[0] == "f"]
    lines = []
    for number, (size, x) in enumerate([(1, 0), (0.05, 2), (0.05, 3), (0.04, 4), (0.04, 5)]):
        lines += [f"v {size * a + x:.6f} {size * b:.6f} {size * c:.6f}" for a, b, c in points] + [f"g ball{number}"]
        lines += ["f " + " ".join(str(corner + number * len(points)) for corner in face) for face in faces]
    (tmp_path / "m.obj").write_text("\n".join([*lines, ""]))
    mesh = obj.read(str(tmp_path / "m.obj"), "m.obj")[0]
    result = simplify.simplified(mesh, 40, "m.obj")
    assert sorted(result.mesh.groups) == [f"ball{number}" for number in range(5)]
    for name in result.mesh.groups:
        part, whole = result.mesh.part(name), mesh.part(name)
        sizes = [[max(axis) - min(axis) for axis in zip(*each.vertices)] for each in (part, whole)]
        assert len(part.faces) >= 4 and all(own > 0.5 * other for own, other in zip(*sizes)) and not open_ends(part)
    assert len(result.mesh.faces) < 250


def test_numbers_of_any_size_are_said_in_digits(tmp_path):
    """Pixels of a surface that moved very far had an exponent; and that nothing was done was not said."""
    found = [toml_model._short(number) for number in (0.0123456, 0.5, 12.345, 99.96, 163.2, 12345.6)]
    assert found == ["0.0123", "0.5", "12.3", "100", "163", "12,346"]
    ball(tmp_path)
    _, notes = compiler.compile_scene(str(tmp_path / "m.obj"), 2, look=look.Look(simplify=5000))
    assert "m.obj: simplify: it has no more than 5,000 triangles, and stays as it is" in notes


def halves(folder, picture):
    """Two halves of a wavy sheet, of which one has three times as many vertices on the edge where they meet."""
    lines, corners, count = ["mtllib m.mtl", "usemtl cloth"], [], 0
    for cells, left in ((12, -2), (36, 0)):
        for j in range(cells + 1):
            at = 12 * j / cells
            low, part = min(int(at), 11), at - min(int(at), 11)
            wave = (1 - part) * math.sin(low / 3) + part * math.sin((low + 1) / 3)      # straight between vertices of the coarse half
            for i in range(cells + 1):
                x = left + 2 * i / cells
                lines += [f"v {x:.6f} {wave / 4:.6f} {2 * j / cells:.6f}", f"vt {x / 4 + 0.5:.6f} {j / cells:.6f}"]
        corners += [[count + j * (cells + 1) + i + step + 1 for step in (0, 1, cells + 2, cells + 1)] for j in range(cells) for i in range(cells)]
        count += (cells + 1) ** 2
    (folder / "m.obj").write_text("\n".join([*lines, *("f " + " ".join(f"{c}/{c}" for c in each) for each in corners), ""]))
    (folder / "m.mtl").write_text("newmtl cloth\n" + "map_Kd m.png\n" * picture)
    (folder / "m.png").write_bytes(png([[(8 * x, 8 * y, 99) for x in range(32)] for y in range(32)]))
    return obj.read(str(folder / "m.obj"), "m.obj")[0]


@SET_UP
@pytest.mark.parametrize("picture", [True, False])
@pytest.mark.parametrize("count", [800, 200])
def test_no_edge_opens_at_t_junctions(tmp_path, count, picture):
    """Both sides of the edge at which they lie become the same, with coordinates between those of its ends."""
    mesh = halves(tmp_path, picture)
    result = simplify.simplified(mesh, count, "m.obj")
    inner = [[end for end in open_ends(each) if abs(end[0]) < UNIT / 4 and UNIT / 100 < abs(end[2]) < 1.99 * UNIT] for each in (mesh, result.mesh)]
    assert inner[0] and not inner[1]
    assert result.before == 2 * (12 * 12 + 36 * 36) and len(result.mesh.faces) <= count
    for face, uvs in zip(result.mesh.faces, result.mesh.surfaces.uvs):
        assert all(abs(mesh_x / UNIT / 4 + 0.5 - u) < 1e-5 for mesh_x, (u, _) in zip((result.mesh.vertices[c][0] for c in face), uvs))


def test_an_edge_that_opens_is_found():
    closed = numpy.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
    assert not simplify.has_new_open_edges(closed, closed) and simplify.has_new_open_edges(closed, closed[:3])
    assert not simplify.has_new_open_edges(closed[:3], closed[:3])


@SET_UP
def test_a_result_with_an_open_edge_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(simplify, "_by_meshoptimizer", lambda made, *_: made.corners[:-7])
    with pytest.raises(ToolError, match="m.obj: simplify: edges .* than 1,000"):
        simplify.simplified(ball(tmp_path), 1000, "m.obj")


# --- the deviation ---------------------------------------------------------------------------

def test_the_deviation_of_a_bump():
    """A pyramid of 0.25 in height on a square, and the square."""
    points = numpy.array([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (1, 1, 0.25)], dtype=float)
    pyramid, square = numpy.array([(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]), numpy.array([(0, 1, 2), (0, 2, 3)])
    assert simplify.between((points, pyramid), (points, square)) == pytest.approx(0.25)
    # Of the second mesh the middles are measured: its vertices are those of the first one.
    assert simplify.between((points, square), (points, pyramid)) == pytest.approx(0.125)


def test_distances_are_those_of_all_pairs():
    chance = numpy.random.default_rng(5)
    vertices, triangles = chance.normal(size=(90, 3)), chance.integers(0, 90, (60, 3))
    points = chance.normal(size=(400, 3))
    weights = chance.dirichlet((1, 1, 1), 4000)     # places of every triangle, which are no nearer than the nearest
    places = numpy.einsum("pk,tkc->tpc", weights, vertices[triangles]).reshape(-1, 3)
    near = numpy.array([numpy.sqrt(((places - point) ** 2).sum(axis=1)).min() for point in points])
    found = numpy.array([simplify.largest(point[None], vertices, triangles) for point in points])
    assert (found <= near + 1e-9).all() and numpy.abs(found - near).max() < 0.08
    assert simplify.largest(points, vertices, triangles) == pytest.approx(found.max())


# --- commands and scene files ----------------------------------------------------------------

@SET_UP
def test_a_model_by_itself_and_its_scene_file(tmp_path):
    ball(tmp_path)
    done = run_cli("build", tmp_path / "m.obj", "--simplify", "400", "-o", tmp_path / "a.fxls", "--write", tmp_path / "s.toml")
    assert done.returncode == 0, done.stderr
    line, = [line for line in done.stderr.splitlines() if "simplify: " in line]
    assert "2,976 triangles became 400" in line and "pixels at the nearest pose" in line
    assert "simplify = 400" in (tmp_path / "s.toml").read_text()
    assert run_cli("build", tmp_path / "s.toml", "-o", tmp_path / "b.fxls").returncode == 0
    assert (tmp_path / "a.fxls").read_bytes() == (tmp_path / "b.fxls").read_bytes()
    assert image.load(tmp_path / "a.fxls").surfaces.textures
    done = run_cli("build", tmp_path / "m.obj", "--look", "--simplify 400", "-o", tmp_path / "b.fxls")
    assert done.returncode == 0 and (tmp_path / "a.fxls").read_bytes() == (tmp_path / "b.fxls").read_bytes()


@SET_UP
def test_the_deviation_that_is_said_is_in_world_units_and_pixels(tmp_path):
    ball(tmp_path)
    (tmp_path / "s.toml").write_text('[view]\nfov = 90\n[[objects]]\nmodel = "m.obj"\nscale = 10\nsimplify = 300\n'
                                     "[path]\nkeys = [{ position = [0, 0, -41] }]\n")
    _, notes = compiler.compile_scene(str(tmp_path / "s.toml"))
    line, = [note for note in notes if "simplify: " in note]
    units, pixels = (float(line.partition(before)[2].split()[0]) for before in ("by at most ", "units, "))
    mesh = ball(tmp_path)
    assert units == pytest.approx(10 * simplify.simplified(mesh, 300, "m").deviation, rel=0.01)
    radius = 10 * max(math.dist((0, 0, 0), vertex) for vertex in mesh.vertices) / UNIT
    assert pixels == pytest.approx(units * 160 / (41 - radius), rel=0.06)


@pytest.mark.parametrize("text, words", [
    ('model = "m.obj"\nsimplify = 3', ["simplify", "3", "4"]), ('model = "m.obj"\nsimplify = "few"', ["simplify"]),
    ('solid = "box"\nsimplify = 9', ["simplify", "means nothing for a solid"])])
def test_numbers_that_are_wrong(tmp_path, text, words):
    ball(tmp_path)
    (tmp_path / "s.toml").write_text(f"[[objects]]\n{text}\n")
    with pytest.raises(ToolError) as caught:
        compiler.compile_scene(str(tmp_path / "s.toml"))
    assert all(word in str(caught.value) for word in words)


@pytest.mark.parametrize("words, said", [(["--simplify", "3"], "whole number of faces"), (["--simplify", "many"], "whole number of faces")])
def test_options_that_are_wrong(tmp_path, words, said):
    ball(tmp_path)
    done = run_cli("build", tmp_path / "m.obj", *words, "-o", tmp_path / "out.fxls")
    assert done.returncode == 2 and said in done.stderr


@SET_UP
def test_a_node_that_is_too_old_is_named(tmp_path, monkeypatch):
    mesh, node = ball(tmp_path), tmp_path / "bin" / "node"
    node.parent.mkdir()
    node.write_text("#!/bin/sh\necho 'node: bad option: --disable-wasm-trap-handler is an error' >&2\nexit 9\n")
    node.chmod(0o755)
    monkeypatch.setenv("PATH", f"{node.parent}{os.pathsep}{os.environ['PATH']}")
    with pytest.raises(ToolError, match="node could not make fewer faces .*it needs node 20.15 or later"):
        simplify.simplified(mesh, 400, "m.obj")


def test_too_many_faces_name_the_option(tmp_path):
    points = [f"v {x} {y} {x * y % 7}" for y in range(190) for x in range(190)]
    faces = [f"f {190 * y + x + 1} {190 * y + x + 2} {190 * y + x + 192}\nf {190 * y + x + 1} {190 * y + x + 192} {190 * y + x + 191}"
             for y in range(189) for x in range(189)]
    (tmp_path / "m.obj").write_text("\n".join(points + faces) + "\n")
    _, notes = compiler.compile_scene(str(tmp_path / "m.obj"), 4, look=look.Look(depth=0))
    assert any("71,442 faces" in note and "--simplify 65535" in note for note in notes)


def test_refusals_of_large_models_name_the_option():
    with pytest.raises(ToolError, match="9000 bytes, the scene partition of board b has 8000; a model may have fewer faces .--simplify., and the boards "
                       "with the room are .*microbit"):
        flash_memory.check_scene_fits(types.SimpleNamespace(scene_size=8000, board="b"), bytes(9000), "x.fxls")
    with pytest.raises(ToolError, match="with the room are mps2-an385, .*rv32$"):
        flash_memory.check_scene_fits(types.SimpleNamespace(scene_size=8000, board="b"), bytes(1_700_000), "x.fxls")
    with pytest.raises(ToolError, match="at least 1,048,577 faces; the limit is 1,048,576 faces of a file, also for --simplify"):
        obj._refuse_many_faces("m.obj", (1 << 20) + 1)
