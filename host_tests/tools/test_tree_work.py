# SPDX-License-Identifier: MIT
"""A tree takes a bounded time, too: it has a budget of its own, and counts at least what it takes."""

import copy
import math
import random
import time

import pytest

from test_input_bounds import PATH, TRIES, run_bounded, slowness
from fixel.scene import tree, tree_faces, work
from fixel.base.errors import ToolError
from fixel.scene import compiler


def planted(folder, name, objects):
    """A scene file; what its tree is made of, over all its objects: parts, lines and the budget."""
    file = folder / f"{name}.toml"
    file.write_text(f"view = {{ far = 4000 }}\n{objects}{PATH}", encoding="utf-8")
    compiled, _ = compiler.compile_scene(str(file), None, None, None, "program")
    lines, budget = tree.Lines(), work.TreeWork()
    parts = tree.parts_of(compiled, range(len(compiled.objects)), (0, 0, 0), lines, budget)
    return file, parts, lines, budget


def build(folder, file, steps=0):
    """A scene with a tree by the command, within the bound for so many steps: code and words."""
    size = sum(each.stat().st_size for each in folder.iterdir() if each.suffix in (".toml", ".obj"))
    return run_bounded(folder, "build", file, "-o", folder / "out.fxls", "--tree", "all", size=size, tree_steps=steps)


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


def ring(count):
    """Discs of 24 corners on one another, which share no edge."""
    rows = [f"v {math.cos(i / 12 * math.pi) * (1 + k / 9999):.6f} 0 {math.sin(i / 12 * math.pi) * (1 + k / 9999):.6f}\n"
            for k in range(count) for i in range(24)]
    return "".join(rows) + "".join(f"f {' '.join(str(24 * k + i + 1) for i in range(24))}\n" for k in range(count))


OBJECTS = {"boxes": boxes(3), "comb": COMB, "floor": '[[objects]]\nsolid = "floor"\ncells = [60, 60]\n',
           "spheres": '[[objects]]\nsolid = "sphere"\nrepeat = { count = [4, 4, 2], step = [3, 4, 5] }\n'}


@pytest.mark.parametrize("kind", ["slivers", *OBJECTS])
def test_the_steps_are_at_least_the_time(tmp_path, kind):
    """A step stands for 1 us of a PC of 2020, or of this one, where it is slower."""
    _, parts, lines, budget = planted(tmp_path, kind, OBJECTS.get(kind) or slivers(tmp_path, 200))
    ratios, before = [], budget.taken
    while not ratios or (min(ratios) > 1 and len(ratios) < TRIES):
        slow = slowness(tmp_path) if ratios else 1
        budget.taken, trial = before, copy.deepcopy((parts, lines))
        started = time.process_time()
        tree.grow(*trial, budget)
        ratios.append((time.process_time() - started) / slow * 1e6 / budget.taken)
    assert min(ratios) <= 1


def test_a_tree_is_built_within_its_bound(tmp_path):
    file, parts, lines, budget = planted(tmp_path, "scene", slivers(tmp_path, 300))
    tree.grow(parts, lines, budget)
    code, said = build(tmp_path, file, budget.taken)
    assert code == 0 and "tree: 300 faces in" in said, said


@pytest.mark.parametrize("kind, objects", [
    ("nodes", boxes(1)), ("corners of faces at nodes", boxes(1)), ("objects at nodes", boxes(1)),
    ("planes tried at nodes", boxes(1)), ("corners at planes tried", boxes(1)), ("faces split", COMB),
    ("corners added by the cuts of neighbours", COMB), ("diagonals of faces with many corners", COMB)])
def test_each_kind_is_counted_and_has_a_limit(tmp_path, monkeypatch, kind, objects):
    _, parts, lines, budget = planted(tmp_path, "scene", objects)
    monkeypatch.setitem(work.COSTS, kind, work.TREE_STEPS)
    with pytest.raises(ToolError, match=f"^the tree asks for too much work; most of it is for {kind} .* fewer layers"):
        tree.grow(parts, lines, budget, most=4)     # as beams may ask


@pytest.mark.parametrize("kind", ["faces of its layers", "corners of its layers"])
def test_what_is_taken_in_has_a_limit(tmp_path, monkeypatch, kind):
    monkeypatch.setitem(work.COSTS, kind, work.TREE_STEPS)
    with pytest.raises(ToolError, match=f"^the tree asks for too much work; most of it is for {kind} "):
        planted(tmp_path, "scene", boxes(1))


def test_each_search_of_a_diagonal_is_counted():
    """A ring whose corners crowd at one end is not divided evenly, and is searched again and again."""
    lines, budget = tree.Lines(), work.TreeWork()
    corners = [*((1 << 20 >> i, 0, 0) for i in range(16)), (0, 0, 1 << 20)]
    numbers = [lines.vertex(corner) for corner in corners]
    edges = [lines.edge(a, b) for a, b in zip(numbers, numbers[1:] + numbers[:1])]
    pieces = tree_faces.halve(lines, tree.Part((0, 1 << 30, 0), 1, 0, 0, numbers, edges), budget, most=3)
    assert len(pieces) == len(corners) - 2
    searched = sum(count * (count - 3) // 2 for count in range(4, len(corners) + 1))
    assert 0 < budget.kinds["diagonals of faces with many corners"] <= searched
    assert budget.taken > 3 * 0.7 * len(corners) * (len(corners) - 3) // 2


@pytest.mark.parametrize("objects, words", [
    (boxes(110), "66,000 faces"),
    ('[[objects]]\nobj = "ring.obj"\nkind = "sorted"\nrepeat = { count = [32, 1, 1], step = [3, 1, 0] }\n', "vertices")])
def test_more_than_a_model_has_is_refused_before_the_work(tmp_path, objects, words):
    (tmp_path / "ring.obj").write_text(ring(2000), encoding="utf-8")
    file = tmp_path / "scene.toml"
    file.write_text(objects + PATH, encoding="utf-8")
    code, said = build(tmp_path, file)
    assert code == 2 and f"{words} or more, and a model has at most 65,535" in said, said
    assert not (tmp_path / "out.fxls").exists()


def test_cuts_beyond_the_faces_of_a_model_end_at_once(tmp_path, monkeypatch):
    _, parts, lines, budget = planted(tmp_path, "scene", COMB)
    monkeypatch.setattr(tree, "FACES_MAX", len(parts) + 9)
    with pytest.raises(ToolError, match=f"would have {len(parts) + 10} faces or more"):
        tree.grow(parts, lines, budget)


def test_faces_that_beams_divide_are_counted_before(tmp_path, monkeypatch):
    """A disc of 24 corners becomes 22 triangles."""
    (tmp_path / "ring.obj").write_text(ring(9), encoding="utf-8")
    _, parts, lines, budget = planted(tmp_path, "scene", '[[objects]]\nobj = "ring.obj"\nkind = "sorted"\n')
    monkeypatch.setattr(tree_faces, "halve", None)
    monkeypatch.setattr(tree, "FACES_MAX", len(parts) * 22 - 1)
    with pytest.raises(ToolError, match=f"would have {len(parts) * 22} faces or more"):
        tree.grow(parts, lines, budget, most=3)
