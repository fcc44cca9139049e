# SPDX-License-Identifier: MIT
"""A tree takes a bounded time, too: it has a budget of its own, and counts at least what it takes."""

import random

import pytest

from test_input_bounds import PATH, run_bounded
import scene as scene_tool
from fixel import framing, tree, work
from fixel.errors import ToolError


def parts(folder, name, objects):
    """A scene file; the parts of a tree over all its objects, and their lines."""
    file = folder / f"{name}.toml"
    file.write_text(f"view = {{ far = 4000 }}\n{objects}{PATH}", encoding="utf-8")
    compiled, _ = scene_tool.compile_scene(str(file), None, None, None, framing.PROGRAM)
    lines = tree.Lines()
    return file, tree.parts_of(compiled, range(len(compiled.objects)), (0, 0, 0), lines), lines


def slivers(folder, count):
    """Triangles at random, which cut one another often."""
    chance, rows = random.Random(count), []
    for _ in range(count):
        middle = [chance.uniform(-100, 100) for _ in range(3)]
        rows += [f"v {' '.join(f'{c + chance.uniform(-50, 50):.4f}' for c in middle)}\n" for _ in range(3)]
    rows += [f"f {3 * i + 1} {3 * i + 2} {3 * i + 3}\n" for i in range(count)]
    (folder / "slivers.obj").write_text("".join(rows), encoding="utf-8")
    return '[[objects]]\nobj = "slivers.obj"\nkind = "sorted"\nposition = [0, 0, 500]\n'


def boxes(count):
    return f'[[objects]]\nsolid = "box"\nrepeat = {{ count = [{count}, 10, 10], step = [3, 4, 5] }}\n'


COMB = """[[objects]]
solid = "box"
scale = [200, 4, 1]
[[objects]]
solid = "box"
scale = ["1/4", 6, 6]
rotation = [10, 0, 0]
repeat = { count = [150, 1, 1], step = [1, 0, 0] }
"""


@pytest.mark.parametrize("kind", ["slivers", "boxes", "comb", "floor"])
def test_the_steps_are_at_least_the_time(tmp_path, kind):
    objects = {"slivers": lambda: slivers(tmp_path, 300), "boxes": lambda: boxes(5), "comb": lambda: COMB,
               "floor": lambda: '[[objects]]\nsolid = "floor"\ncells = [100, 100]\n'}[kind]()
    file, made, lines = parts(tmp_path, kind, objects)
    budget = work.TreeWork()
    tree.grow(made, lines, work=budget)
    size = sum(each.stat().st_size for each in tmp_path.iterdir())
    code, said = run_bounded(tmp_path, "build", file, "-o", tmp_path / "out.fxls", "--tree", "all", size=size,
                             tree_steps=budget.taken)
    assert code == 0 and "tree: " in said, said


@pytest.mark.parametrize("kind, objects", [
    ("nodes of the tree", boxes(1)), ("corners of faces at nodes", boxes(1)), ("faces of its layers", boxes(1)),
    ("faces split", COMB), ("vertices on edges", COMB), ("corners of faces halved", COMB)])
def test_each_kind_is_counted_and_has_a_limit(tmp_path, monkeypatch, kind, objects):
    _, made, lines = parts(tmp_path, "scene", objects)
    monkeypatch.setitem(work.COSTS, kind, work.TREE_STEPS)
    with pytest.raises(ToolError, match=f"the tree: .* too much work; most of it is for {kind} .* fewer faces"):
        tree.grow(made, lines, most=4)      # as beams may ask


def test_more_faces_than_a_model_has_are_refused_before_the_work(tmp_path):
    file = tmp_path / "scene.toml"
    file.write_text(boxes(110) + PATH, encoding="utf-8")
    code, said = run_bounded(tmp_path, "build", file, "-o", tmp_path / "out.fxls", "--tree", "all", size=file.stat().st_size)
    assert code == 2 and "at least 66,000 faces" in said and "65,535" in said, said
    assert not (tmp_path / "out.fxls").exists()


def test_cuts_beyond_the_faces_of_a_model_end_at_once(tmp_path, monkeypatch):
    _, made, lines = parts(tmp_path, "scene", COMB)
    monkeypatch.setattr(tree, "FACES_MAX", len(made) + 9)
    with pytest.raises(ToolError, match=f"at least {len(made) + 10} faces"):
        tree.grow(made, lines)
