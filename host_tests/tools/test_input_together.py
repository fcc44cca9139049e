# SPDX-License-Identifier: MIT
"""Short scene files that ask for much of several things, each of which would be fine alone: one budget holds for all
(tools/fixel/scene/work.py). The bounds are those of test_input_bounds.py."""

import re
import tracemalloc

import pytest

from conftest import CHECKOUT
from fixel.image import image
from fixel.scene import work
from fixel.base.errors import ToolError
from fixel.scene import compiler
from test_input_bounds import assert_built, assert_refused
from test_input_work import noise, scene

NOISE = '[[textures]]\nname = "t0"\nfile = "noise.png"\nmost_colours = 255\n'
BRICKS = '[[textures]]\nname = "t0"\npattern = "bricks"\n'


def item(*lines):
    return "\n".join(["[[objects]]", *lines, ""])


def box(*lines):
    return item('solid = "box"', *lines)


def copies(*count):
    return f"repeat = {{ count = {list(count)}, step = [0, 0, 0] }}"


RING = "ring = { count = 1000, radius = 9 }"
SPIN = "spin = { yaw = 2 }"
# What takes more than there is: the text, and the kind of work that is named first.
BEYOND = {
    "shapes": ("".join(item('solid = "tile"', f"rotation = [0, {i}, {i}]", RING) for i in range(30)), "shapes"),
    "known shapes": (item('solid = "tile"', RING) * 40, "copies that differ"),
    "motions": (box("motion = { circle = 1, degrees = 2 }", copies(39, 1000, 1)), "turned or moving objects"),
    "spins": (box("spin = { axis = [0, 1, 0], degrees = 3 }", copies(19, 1000, 1)), "turned or moving objects"),
    "rings that turn": (box("ring = { count = 1000, radius = 9, turned = true }") * 40, "turned or moving objects"),
    "parents": (box('name = "p"', "turn = 3") + box('parent = "p"') * 15_000, "turned or moving objects"),
    "faces, copies and motions": ("".join(item('solid = "floor"', "cells = [30, 30]", f"rotation = [0, {i}, 0]") for i in range(43))
                                  + box(copies(40, 600, 1)) + box(SPIN, copies(39, 1000, 1)), "copies"),
    "corners": (BRICKS + item('solid = "disc"', "sides = 24", 'texture = "t0"', RING), "corners of surfaces"),
    "short objects": ("objects = [" + '{ solid = "box" }, ' * 54_000 + "]\n", "objects"),
    "objects that turn": ("objects = [" + '{ solid = "box", turn = 1 }, ' * 30_000 + "]\n", "turned or moving objects"),
    "solids": ("".join(item('solid = "prism"', f"taper = {1 + i / 10_000}") for i in range(8000)), "shapes"),
    "colours of textures": (NOISE + "".join(box(f"rotation = [{i}, {i}, {i}]", 'texture = "t0"') for i in range(300)),
                            "colours of textures"),
    "keys": (box("motion = { keys = [{ turn = 1e7, frames = 900000 }, {}] }"), "keys of motions"),
    "parts": (item('solid = "floor"', "cells = [140, 140]", "parts = [64, 64]", copies(15, 1, 1)), "copies"),
}
# What looks as hostile, and is not: the same is made once.
WITHIN = {
    "colours of a texture": NOISE + item('solid = "floor"', "cells = [60, 60]", 'texture = "t0"'),
    "copies": box(copies(65, 1000, 1)),
    "copies at fractions": box('position = ["1/999999999999999997", 0, 0]',
                               copies(65, 1000, 1).replace("[0, 0, 0]", '["1/99999999999999991", 0, 0]')),
    "one solid in six ways": "".join(item('solid = "floor"', "cells = [141, 141]", f'anchor = "{anchor}"', f'kind = "{kind}"')
                                     for anchor in ("origin", "base", "middle") for kind in ("convex", "sorted")),
    "a large solid": item('solid = "floor"', "cells = [190, 190]"),
    "motions": box("motion = { by = [1, 1, 1], frames = 9, back = true }", copies(6, 1000, 1)),
}


@pytest.mark.parametrize("name", BEYOND)
def test_beyond(tmp_path, name):
    text, kind = BEYOND[name]
    noise(tmp_path, "noise.png", 64)
    assert_refused(tmp_path, scene(tmp_path, text), "too much work; most of it is for " + kind)


@pytest.mark.parametrize("name", WITHIN)
def test_within(tmp_path, name):
    noise(tmp_path, "noise.png", 64)
    assert_built(tmp_path, scene(tmp_path, WITHIN[name]))


def test_a_chain_of_parents(tmp_path):
    """Its depth was checked when the whole scene was packed."""
    text = box('name = "n0"', "turn = 3") + "".join(box(f'name = "n{i + 1}"', f'parent = "n{i}"') for i in range(8000))
    assert_refused(tmp_path, scene(tmp_path, text), 'object 9 ("n9")', "more than 8 parents")


def test_decimals_of_hundreds_of_digits(tmp_path):
    digits = "0.0" + "7" * 200
    text = box(f"position = [{digits}, 0, 0]", copies(65, 1000, 1).replace("0, 0, 0", f"{digits}, 0, 0"))
    assert_refused(tmp_path, scene(tmp_path, text), "a number has more than 24 characters")


def test_texels_take_little_memory(tmp_path):
    """Each was an object of its own while they were packed, which took a hundred bytes."""
    noise(tmp_path, "noise.png", 64)
    file = scene(tmp_path, NOISE + "".join(box(f"rotation = [{i}, {i}, {i}]", 'texture = "t0"') for i in range(60)))
    compiled, _ = compiler.compile_scene(str(file))
    texels = sum(len(texture.texels) for texture in compiled.surfaces.textures)
    tracemalloc.start()
    image.pack(compiled)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert texels > 500_000 and most < 20 * texels


def test_the_budget_is_one(tmp_path):
    """It is not for each kind, and a refusal names what took most."""
    budget = work.Work()
    file = tmp_path / "a"
    file.touch()
    assert budget.allow(file, 1000)
    budget.take("copies", 100_000, "a")
    with pytest.raises(ToolError) as refused:
        budget.take("parents", 5000, "the place")
    assert str(refused.value) == ("the place: the scene asks for too much work; most of it is for copies (58 %), parents (42 %): use "
                                  "fewer of these (the limit is 1,501,300 steps: 1,500,000, and about one for each byte of its files)")


def test_the_documents_have_the_costs():
    text = (CHECKOUT / "docs" / "scenes.md").read_text(encoding="utf-8").split("| kind | steps for each |")[1].split("\n\n")[0]
    told = dict(re.findall(r"\| ([a-z ]+) \| ([0-9]+) \|", text))
    assert len(told) == 11 and {kind: work.COSTS[kind] for kind in told} == {kind: int(steps) for kind, steps in told.items()}
