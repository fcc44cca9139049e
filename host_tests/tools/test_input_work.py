# SPDX-License-Identifier: MIT
"""Short scene files that ask for much work: what is the same is made once, and the limits of
test_input_bounds.py end the rest."""

import numpy as np
from PIL import Image
import pytest

from test_input_bounds import BOX, PATH, assert_built, assert_ended, assert_refused

PARTED = '[[objects]]\nsolid = "floor"\ncells = [100, 100]\nparts = [64, 64]\nrepeat = {{ count = [{}, 1, 1], step = [0, 0, 0] }}\n'


def scene(folder, text):
    file = folder / "scene.toml"
    file.write_text(text + PATH, encoding="utf-8")
    return file


def noise(folder, name, side=256):
    """A file with an image of as many colours as pixels."""
    chance = np.random.default_rng(len(name))
    Image.fromarray(chance.integers(0, 256, (side, side, 3), dtype=np.uint8)).save(folder / name)
    return folder / name


def textures(rows):
    return "".join(f'[[textures]]\nname = "t{i}"\n{row}\n' for i, row in enumerate(rows)) + BOX


def billboards(rows):
    return "".join(f'[[billboards]]\nname = "b{i}"\nsize = [1, 1]\n{row}\n' for i, row in enumerate(rows)) + BOX


def test_parts_are_made_once(tmp_path):
    assert "16,384 objects" in assert_built(tmp_path, scene(tmp_path, PARTED.format(4)))


def test_parts_of_copies_beyond_the_limit(tmp_path):
    assert_refused(tmp_path, scene(tmp_path, PARTED.format(190)), "parts", "65,535 objects")


@pytest.mark.parametrize("solid", ['solid = "island"\ncolours = ["#203040", "#405060", "#a0a0a0"]\n', 'solid = "floor"\n'])
def test_a_solid_of_many_objects_is_made_once(tmp_path, solid):
    assert_built(tmp_path, scene(tmp_path, f"[[objects]]\n{solid}cells = [140, 140]\n" * 90))


def test_keys_of_quoted_parts_with_escapes(tmp_path):
    """Such parts hid how long a key is, and it took quadratic time and memory."""
    key = ".".join(['"\\"-"'] * 20_000)
    assert_refused(tmp_path, scene(tmp_path, f"{key} = 1\n"), "more than 16 parts")


def test_a_picture_of_many_textures_is_made_once(tmp_path):
    picture = noise(tmp_path, "noise.png")
    assert_built(tmp_path, scene(tmp_path, textures(['file = "noise.png"\nlevels = 9\nmost_colours = 255',
                                                     'file = "./noise.png"\nlevels = 9\nmost_colours = 255'] * 30)))


def test_many_pictures_of_one_file(tmp_path):
    picture = noise(tmp_path, "noise.png")
    rows = [f'file = "noise.png"\nlevels = 9\nmost_colours = {255 - i}' for i in range(30)]
    assert_ended(tmp_path, scene(tmp_path, textures(rows)))


def test_many_texels_of_files(tmp_path):
    pictures = [noise(tmp_path, "n" * (number + 1) + ".png", 128) for number in range(16)]
    rows = [f'file = "{picture.name}"\nlevels = 8' for picture in pictures]
    assert_built(tmp_path, scene(tmp_path, textures(rows)))


@pytest.mark.parametrize("rows", [
    [f'pattern = "bricks"\nsize = [256, 256]\nlevels = 9\ncolours = ["#{i:02x}0000", "red", "green", "blue"]' for i in range(30)],
    [f'pattern = "stones"\nsize = [8, 16]\nlevels = 5\ncolours = ["#{i:02x}0000", "red", "green"]' for i in range(256)],
    ['pattern = "checker"\nsize = [256, 256]\nlevels = 9'] * 256])
def test_patterns(tmp_path, rows):
    """Many of other colours take long, unless they are small; many of the same are one."""
    different = len(set(rows)) > 1 and "256, 256" in rows[0]
    (assert_ended if different else assert_built)(tmp_path, scene(tmp_path, textures(rows)))


def test_billboards_of_one_file(tmp_path):
    picture = noise(tmp_path, "noise.png")
    rows = [f'file = "noise.png"\nmost_colours = {255 - i}' for i in range(60)]
    assert_ended(tmp_path, scene(tmp_path, billboards(rows)))
    assert_built(tmp_path, scene(tmp_path, billboards(rows[:1] * 60)))


@pytest.mark.parametrize("line", ["cells = [true, 2]", "parts = [2, true]",
                                  "repeat = { count = [true, 1, 1], step = [1, 0, 0] }"])
def test_true_is_no_number(tmp_path, line):
    assert_refused(tmp_path, scene(tmp_path, f'[[objects]]\nsolid = "floor"\n{line}\n'), "whole numbers from 1")


def test_true_is_no_number_of_pixels(tmp_path):
    assert_refused(tmp_path, scene(tmp_path, billboards(['pattern = "tree"\npixels = [8, true]'])), "whole numbers from 1")


def test_many_objects_of_one_large_model_with_materials(tmp_path):
    """What an object's faces wish for was compared face by face with what others wished for."""
    (tmp_path / "m.mtl").write_text("newmtl a\nKd 1 0 0\n")
    (tmp_path / "m.obj").write_text("mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n" * 40_000)
    assert_built(tmp_path, scene(tmp_path, '[[objects]]\nobj = "m.obj"\n' * 5000))


def test_islands_of_few_faces_and_many_cells(tmp_path):
    text = "".join(f'[[objects]]\nsolid = "island"\ncells = [200, 200]\nsea = 0.9\nseed = {seed}\n' for seed in range(200))
    assert_ended(tmp_path, scene(tmp_path, text))


def test_a_long_list_of_textures_on_many_copies(tmp_path):
    names = ", ".join(['"t0"'] * 40_000)
    text = textures(['pattern = "crate"\nsize = [4, 4]']).replace(BOX, "") + \
        f'[[objects]]\nsolid = "tile"\ntextures = [{names}]\nring = {{ count = 1000, radius = 9 }}\n'
    assert_built(tmp_path, scene(tmp_path, text))


def test_a_solid_of_very_many_faces_with_a_texture(tmp_path):
    text = textures(['pattern = "bricks"']).replace(BOX, "") + \
        '[[objects]]\nsolid = "floor"\ncells = [200, 200]\ntexture = "t0"\n'
    assert_ended(tmp_path, scene(tmp_path, text))
