# SPDX-License-Identifier: MIT
"""Scene files with lines and points: the faces on which they lie, and each refusal."""

import pytest

from conftest import assert_one_sentence, run_cli
from fixel.base.errors import ToolError
from fixel.image import image_lines
from fixel.scene import toml_lines
from model_files import build

BUILT_PROGRAMS = ()
BOX = '[[objects]]\nsolid = "box"\nposition = [0, 0, 5]\n'
EDGES = BOX + "edges = {}\n"
ROW = "at = [[-0.3, 0, -0.5], [0, 0.3, -0.5]]"
LINES = BOX + "lines = [{ %s }]\n"
POINTS = BOX + "points = [{ %s }]\n"


def lines_of(folder, text):
    model = build(folder, text).models[0]
    return model, model.lines


def test_each_edge_of_a_box_has_its_two_faces(tmp_path):
    model, lines = lines_of(tmp_path, EDGES)
    assert len(lines) == 12 and all(line.width == 1 for line in lines)
    for line in lines:
        assert 0 < line.faces[0] < line.faces[1]
        for number in line.faces:
            assert {line.start, line.end} <= set(model.faces[number - 1].corners)


def test_edges_of_a_lesser_angle_are_left_out(tmp_path):
    assert [len(lines_of(tmp_path, BOX + f"edges = {{ angle = {angle} }}\n")[1]) for angle in (0, 89, 91)] == [12, 12, 0]


@pytest.mark.parametrize("more, on", [("", True), (", on_faces = false", False)])
def test_a_segment_lies_on_the_faces_that_hold_both_its_ends(tmp_path, more, on):
    model, lines = lines_of(tmp_path, LINES % (ROW + more))
    assert len(lines) == 1 and lines[0].faces[1] == 0
    if on:
        corners = model.faces[lines[0].faces[0] - 1].corners
        assert {model.vertices[corner][2] for corner in corners} == {min(z for _, _, z in model.vertices)}
    else:
        assert lines[0].faces[0] == 0


def test_a_closed_line_has_a_segment_more_and_colours_come_again(tmp_path):
    at = "at = [[2, 0, 0], [3, 0, 0], [2, 2, 0]]"
    for closed, count in (("false", 2), ("true", 3)):
        _, lines = lines_of(tmp_path, LINES % (at + f', closed = {closed}, colours = ["red", "lime"], width = 16'))
        assert len(lines) == count and lines[0].start == lines[count - 2].start - (count - 2) and lines[0].width == 16
        assert len({line.colour for line in lines}) == 2 and lines[0].colour == lines[2 * (count > 2)].colour
    _, dots = lines_of(tmp_path, POINTS % at)
    assert [line.start == line.end for line in dots] == [True] * 3


def test_an_object_of_lines_alone(tmp_path):
    """Its image has no face."""
    alone = '[[objects]]\nsolid = "none"\nposition = [0, 0, 5]\n'
    model, lines = lines_of(tmp_path, alone + f"lines = [{{ {ROW}, width = 3 }}]\npoints = [{{ at = [[0.5, 0, 0]], width = 5 }}]\n")
    assert len(model.vertices) == 3 and not model.faces and [line.width for line in lines] == [3, 5]
    for more in ("", "edges = {}\n"):
        with pytest.raises(ToolError, match='solid = "none" has no faces: give it lines or points'):
            build(tmp_path, alone + more)


# What is wrong, and what the sentence must name: the place, the key, its range or the cure.
REFUSED = [
    (LINES % "at = [[0, 0, 0], [0, 0, 1e-6]]", ("object 0", "lines[0]", "1/65536", "points")),
    (LINES % (ROW.replace("]]", "], [-0.3, 0, -0.5]]") + ", closed = true"), ("object 0", "lines[0]", "closed")),
    (LINES % "at = [[0, 0, 0]]", ("object 0", "lines[0]", "at", "2 to 4096")),
    (LINES % "width = 2", ("object 0", "lines[0]", '"at"')),
    (LINES % (ROW + ", width = 17"), ("object 0", "lines[0]", "width = 17", "1..16")),
    (POINTS % (ROW + ", width = 0"), ("object 0", "points[0]", "width = 0", "1..16")),
    (POINTS % (ROW + ', colour = "red", colours = ["lime"]'), ("object 0", "points[0]", "colour", "colours", "keep one")),
    (POINTS % "at = []", ("object 0", "points[0]", "at", "1 to 4096")),
    (BOX + "points = []\n", ("object 0", "points", "at least one")),
    (BOX + "edges = { angle = 181 }\n", ("object 0", "edges", "angle = 181", "0..180 degrees")),
    (BOX + "edges = { on_faces = true }\n", ("object 0", "edges", '"on_faces"', "angle, colour, width")),
    (LINES % "at = [[100000, 0, 0], [0, 0, 0]]", ("object 0", "100000", "-8191..8191")),
    (EDGES + "parts = [2, 2]\n", ("object 0", "edges", "leave parts away")),
    (EDGES + "clusters = true\n", ("object 0", "edges", "leave clusters away")),
    ('tree = "layers"\n' + EDGES, ("lines", "tree", "leave out edges")),
    ("[[beams]]\ndirection = [3, -4, 0]\nwindow = [[-4, 1, -1], [-4, 2, -1], [-4, 2, 1], [-4, 1, 1]]\n" + EDGES, ("lines", "beams", "leave out edges")),
    ('[[billboards]]\nname = "b"\npattern = "tree"\npixels = [5, 6]\nsize = [2, 3]\n[[objects]]\nbillboard = "b"\nedges = {}\n', ("object 0", '"edges"')),
]


@pytest.mark.parametrize("text, words", REFUSED)
def test_a_refusal_names_the_place_and_the_cure(tmp_path, text, words):
    file, out = tmp_path / "s.toml", tmp_path / "out.fxls"
    file.write_text(text, encoding="utf-8")
    assert_one_sentence(run_cli("build", file, "-o", out), "s.toml", *words)
    assert not out.exists()


@pytest.mark.parametrize("name, limit, text, words", [
    ("TESTS_MAX", 4, LINES % ROW, ("object 0", "4 tests", "on_faces = false", "simplify")),
    ("FACES_MAX", 9, LINES % ROW, ("object 0", "8 vertices", "limit of 9", "fewer points"))])
def test_what_takes_too_long_or_has_no_room_is_refused(tmp_path, monkeypatch, name, limit, text, words):
    monkeypatch.setattr(toml_lines, name, limit)
    with pytest.raises(ToolError) as caught:
        build(tmp_path, text)
    for word in words:
        assert word in str(caught.value)
    monkeypatch.setattr(toml_lines, name, limit + 1)
    assert len(build(tmp_path, text).models[0].lines) == 1


@pytest.mark.parametrize("change, words", [
    ({"width": 17}, ("line 1", "17", "1..16")), ({"width": 0}, ("line 1", "1..16")),
    ({"start": 8}, ("line 1", "model 0", "vertices")), ({"faces": (7, 0)}, ("line 1", "model 0", "faces"))])
def test_an_image_whose_lines_are_broken_is_refused(tmp_path, change, words):
    scene = build(tmp_path, EDGES)
    scene.models[0].lines[1] = scene.models[0].lines[1]._replace(**change)
    packed = image_lines.tables(scene.models)
    found = {"lines": [image_lines.LINE.unpack(each) for each in packed["lines"]], "line map": [image_lines.MAP.unpack(each)[0] for each in packed["line map"]]}
    scene.models[0].lines = []
    with pytest.raises(ToolError) as caught:
        image_lines.read(found, scene.models)
    for word in words:
        assert word in str(caught.value)
