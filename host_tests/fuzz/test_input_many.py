# SPDX-License-Identifier: MIT
"""Random scene files of a few hundred bytes that ask for much: a feature in each object, thousands of times. Each ends
within the limits of test_input_bounds.py, compiled or ended by one. FUZZ_SEED and FUZZ_EXAMPLES (make fuzz) ask for others."""

import random

import pytest

from fuzzing import EXAMPLES, SEED
from test_input_bounds import LITTLE, run_bounded
from test_input_work import noise

BUILT_PROGRAMS = ()
ANGLES = ["30", '"1/7"', "90", '"3/512 turn"', "-0.001"]
TOP = """
background = "#203040"
[view]
visibility = "default"
{light}
[[textures]]
name = "bricks"
pattern = "bricks"
size = [{side}, {side}]
levels = {levels}
[[textures]]
name = "noise"
file = "noise.png"
most_colours = {colours}
levels = {levels}
[[billboards]]
name = "tree"
size = [1, 1]
pattern = "tree"
pixels = [{side}, {side}]
[path]
{path}
"""
SOLIDS = ['solid = "box"', 'solid = "tile"', 'solid = "disc"\nsides = {sides}', 'solid = "prism"\nsides = {sides}\ntaper = {taper}',
          'solid = "sphere"\nsides = {sides}\nrings = {rings}', 'solid = "torus"\nsides = {sides}\nrings = {rings}',
          'solid = "floor"\ncells = [{cells}, {cells}]', 'solid = "island"\ncells = [{cells}, {cells}]\nseed = {seed}\nsea = {sea}',
          'solid = "icosahedron"']
LOOKS = ["", "", 'colour = "#{colour:06x}"', 'colours = ["#{colour:06x}", "red", "blue"]', "colour_index = 1\ncolour_next = 3",
         'texture = "bricks"', 'texture = "noise"\ntiles = [2, 3]', 'texture = "noise"\ntexels_per_unit = 7\ndivision = 8',
         'texture = "bricks"\nopacity = 7\nblend = true', 'shade = false\ncolour = "#{colour:06x}"', "opacity = {opacity}"]
LIVES = ["", "", "", "turn = {angle}", "turn = [{angle}, {angle}, {angle}]\nsize = 1.3", "spin = {{ axis = [1, 2, 3], degrees = {angle} }}",
         "motion = {{ circle = 1.5, degrees = {angle}, facing = true }}", "motion = {{ by = [1, 2, 3], frames = 9, back = true }}",
         "motion = {{ keys = [{{ turn = {number}, frames = {number} }}, {{ size = 2 }}] }}"]
MORE = ["", "", "two_sided = true", "inside = true", 'anchor = "base"', 'anchor = "middle"\nkind = "sorted"',
        'kind = "sorted"\nclusters = true', "scale = [1.1, 2.2, 3.3]", "parts = [{number}, 7]", "layer = 3\nmoves = true"]
PLACES = ["", "repeat = {{ count = [{number}, {few}, 1], step = [0.01, 0, \"1/7\"] }}", "ring = {{ count = {number}, radius = 5 }}",
          "ring = {{ count = {number}, radius = 5, turn = false }}", "ring = {{ count = {number}, radius = 9, turned = true }}"]
PATHS = ["keys = [{{ position = [0, 0, 0], frames = {number} }}, {{ position = [1, 2, 3], look_at = [5, 5, 5], frames = {number} }}]",
         "orbit = {{ radius = 5, height = 2, frames = {number} }}", 'steps = [{{ keys = ["forward"], frames = {number} }}]']
LIGHTS = ["", "[light]\nlevels = {levels8}", "[light]\nambient = 0.3\nsky = \"#8090ff\""]


def numbers(chance):
    """The numbers of one object: small, or as large as they may be."""
    large = chance.random() < 0.5

    def upto(low, high):
        return chance.randint(low, high) if large else min(high, low + int(1.3 ** chance.randrange(12)))
    return {"sides": upto(3, 64), "rings": upto(2, 64), "taper": chance.randint(1, 999) / 100, "cells": upto(1, 200),
            "seed": chance.randrange(65536), "sea": chance.choice([0, 0.5, 0.9]), "colour": chance.randrange(1 << 24),
            "angle": chance.choice(ANGLES), "number": upto(1, 1000 if large else 60), "few": upto(1, 40), "opacity": upto(1, 16)}


def an_object(chance):
    if chance.random() < 0.08:
        lines = ['billboard = "tree"', chance.choice(LIVES), chance.choice(PLACES[:4])]
    else:
        lines = [chance.choice(each) for each in (SOLIDS, LOOKS, LIVES, MORE, PLACES)]
        lines.append(f"rotation = [{chance.randrange(360)}, {chance.choice([0, 17])}, 0]")
    known = numbers(chance)
    if any("parts" in line for line in lines):      # what turns or moves is not divided
        known["number"] = min(known["number"], 64)
        lines = [line for line in lines if line not in LIVES and "turned" not in line]
    return "[[objects]]\n" + "\n".join(line.format(**known) for line in lines if line) + "\n"


def a_scene(chance):
    """Objects, each of them once, some times, or a hundred times with another turn."""
    objects = [an_object(chance) * chance.choice([1, 1, 3, 40]) for _ in range(chance.choice([1, 3, 30, 300]))]
    side, number = chance.choice([8, 32, 256]), chance.choice([3, 1000, 16_000])
    top = TOP.format(side=side, levels=chance.choice([1, 4]), colours=chance.choice([15, 255]), path=chance.choice(PATHS),
                     light=chance.choice(LIGHTS)).replace("{{", "{").replace("}}", "}")
    return top.replace("{number}", str(number)).replace("{levels8}", "8") + "".join(objects)


@pytest.mark.parametrize("seed", range(SEED, SEED + max(12, EXAMPLES // 15)))
def test_any_scene_that_asks_for_much(tmp_path, seed):
    noise(tmp_path, "noise.png", 64)
    file = tmp_path / "scene.toml"
    file.write_text(a_scene(random.Random(seed)), encoding="utf-8")
    code, said = run_bounded("build", file, "-o", tmp_path / "out.fxls", cpu=LITTLE)
    assert code in (0, 2) and (tmp_path / "out.fxls").exists() == (code == 0), said
