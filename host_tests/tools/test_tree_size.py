# SPDX-License-Identifier: MIT
"""A tree that would be too large for a model is refused as soon as that is known."""

import math

import pytest

from test_input_bounds import PATH, run_bounded
from fixel.scene import tree, tree_faces
from fixel.base.errors import ToolError
from fixel.scene import compiler


def planted(folder, name, objects):
    """What a tree of a scene is made of, over all its objects: parts and lines."""
    file = folder / f"{name}.toml"
    file.write_text(f"view = {{ far = 4000 }}\n{objects}{PATH}", encoding="utf-8")
    compiled, _ = compiler.compile_scene(str(file), None, None, None, "program")
    lines = tree.Lines()
    parts = tree.parts_of(compiled, range(len(compiled.objects)), (0, 0, 0), lines)
    return parts, lines


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


@pytest.mark.parametrize("objects, words", [
    (boxes(110), "66,000 faces"),
    ('[[objects]]\nobj = "ring.obj"\nkind = "sorted"\nrepeat = { count = [32, 1, 1], step = [3, 1, 0] }\n', "vertices")])
def test_more_than_a_model_has_is_refused_before_the_work(tmp_path, objects, words):
    (tmp_path / "ring.obj").write_text(ring(2000), encoding="utf-8")
    file = tmp_path / "scene.toml"
    file.write_text(objects + PATH, encoding="utf-8")
    code, said = run_bounded("build", file, "-o", tmp_path / "out.fxls", "--tree", "all")
    assert code == 2 and f"{words} or more, and a model has at most 65,535" in said, said
    assert not (tmp_path / "out.fxls").exists()


def test_cuts_beyond_the_faces_of_a_model_end_at_once(tmp_path, monkeypatch):
    parts, lines = planted(tmp_path, "scene", COMB)
    monkeypatch.setattr(tree, "FACES_MAX", len(parts) + 9)
    with pytest.raises(ToolError, match=f"would have {len(parts) + 10} faces or more"):
        tree.grow(parts, lines)


def test_faces_that_beams_divide_are_counted_before(tmp_path, monkeypatch):
    """A disc of 24 corners becomes 22 triangles."""
    (tmp_path / "ring.obj").write_text(ring(9), encoding="utf-8")
    parts, lines = planted(tmp_path, "scene", '[[objects]]\nobj = "ring.obj"\nkind = "sorted"\n')
    monkeypatch.setattr(tree_faces, "halve", None)
    monkeypatch.setattr(tree, "FACES_MAX", len(parts) * 22 - 1)
    with pytest.raises(ToolError, match=f"would have {len(parts) * 22} faces or more"):
        tree.grow(parts, lines, most=3)
