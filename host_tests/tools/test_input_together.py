# SPDX-License-Identifier: MIT
"""Short scene files that ask for much of several things, each of which would be fine alone: the limits of
test_input_bounds.py hold for all together."""

import tracemalloc

import pytest

from fixel.image import image
from fixel.scene import compiler
from test_input_bounds import assert_built, assert_ended, assert_refused
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
# What may take more than there is.
BEYOND = {
    "shapes": "".join(item('solid = "tile"', f"rotation = [0, {i}, {i}]", RING) for i in range(30)),
    "known shapes": item('solid = "tile"', RING) * 40,
    "motions": box("motion = { circle = 1, degrees = 2 }", copies(39, 1000, 1)),
    "spins": box("spin = { axis = [0, 1, 0], degrees = 3 }", copies(19, 1000, 1)),
    "rings that turn": box("ring = { count = 1000, radius = 9, turned = true }") * 40,
    "parents": box('name = "p"', "turn = 3") + box('parent = "p"') * 15_000,
    "faces, copies and motions": "".join(item('solid = "floor"', "cells = [30, 30]", f"rotation = [0, {i}, 0]") for i in range(43)) +
                                 box(copies(40, 600, 1)) + box(SPIN, copies(39, 1000, 1)),
    "corners": BRICKS + item('solid = "disc"', "sides = 24", 'texture = "t0"', RING),
    "short objects": "objects = [" + '{ solid = "box" }, ' * 54_000 + "]\n",
    "objects that turn": "objects = [" + '{ solid = "box", turn = 1 }, ' * 30_000 + "]\n",
    "solids": "".join(item('solid = "prism"', f"taper = {1 + i / 10_000}") for i in range(8000)),
    "colours of textures": NOISE + "".join(box(f"rotation = [{i}, {i}, {i}]", 'texture = "t0"') for i in range(300)),
    "keys": box("motion = { keys = [{ turn = 1e7, frames = 900000 }, {}] }"),
    "parts": item('solid = "floor"', "cells = [140, 140]", "parts = [64, 64]", copies(15, 1, 1)),
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
    noise(tmp_path, "noise.png", 64)
    assert_ended(tmp_path, scene(tmp_path, BEYOND[name]))


def test_keys_of_motions_are_counted_before_they_are_made(tmp_path):
    """A turn of ten million degrees between two keys needs a key in every few frames."""
    text = box("motion = { keys = [{ turn = 1e8, frames = 900000 }, {}] }")
    assert_refused(tmp_path, scene(tmp_path, text * 2), "1,000,000 keys together")


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
