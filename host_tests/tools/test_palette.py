# SPDX-License-Identifier: MIT
"""Colours of a scene: what light makes of them, and how many of them become few."""

import zlib

import pytest

from fixel.base.errors import ToolError
from fixel.scene import palette

ONE = 1 << 30
WHITE = (255, 255, 255)


@pytest.mark.parametrize("normal, part", [
    ((0, ONE, 0), 0.75 + 0.25),                             # turned to the light, and up: all of the glow
    ((0, -ONE, 0), 0.25 * 0.75),                            # turned from it, and down: three quarters of the glow
    ((ONE, 0, 0), 0.75 * 0.5 ** 1.5 + 0.25 * 0.875)])       # half way
def test_a_face_has_a_part_of_its_colour(normal, part):
    for direction in ((0, -1, 0), (0, -3, 0)):
        made = palette.Light(direction, 0.25, WHITE, WHITE).bake((200, 100, 50), normal)
        assert made == tuple(round(each * part) for each in (200, 100, 50))


def test_light_and_glow_have_colours():
    assert palette.Light((0, -1, 0), 0.25, (255, 0, 0), (0, 0, 255)).bake((200, 100, 48), (0, ONE, 0)) == (150, 0, 12)
    # From the side: the light travels along x and z, and a face that looks back at it has all of it.
    light = palette.Light((3, 0, -4), 0, WHITE, WHITE)
    assert light.bake((200, 100, 50), (round(-0.6 * ONE), 0, round(0.8 * ONE))) == (200, 100, 50)
    assert light.bake((200, 100, 50), (round(0.6 * ONE), 0, round(-0.8 * ONE))) == (0, 0, 0)


def test_a_beam_adds_what_a_colour_sends_back_of_it():
    assert palette.lit((200, 100, 40), 0.5, (255, 0, 51)) == (255, 100, 44)


def test_an_index_has_the_same_colour_for_ever():
    """It is part of a scene's image. Where it is to be another, put the new figure in."""
    assert [palette.wheel(index) for index in range(3)] == [(242, 109, 109), (92, 125, 204), (128, 166, 75)]
    assert zlib.crc32(bytes(part for index in range(256) for part in palette.wheel(index))) == 0x71615adb


def test_colours_are_cut_where_they_reach_farthest_and_each_group_becomes_its_mean():
    weights = {(0, 0, 0): 1, (10, 0, 0): 3, (200, 0, 0): 1, (210, 6, 0): 1}
    assert palette.median_cut(weights, 2) == {(0, 0, 0): (8, 0, 0), (10, 0, 0): (8, 0, 0),     # 30 / 4
                                              (200, 0, 0): (205, 3, 0), (210, 6, 0): (205, 3, 0)}
    assert palette.median_cut(weights, 4) == {colour: colour for colour in weights}
    green = {(0, 0, 0): 1, (0, 40, 0): 1, (9, 41, 0): 1}
    assert palette.median_cut(green, 2) == {(0, 0, 0): (0, 0, 0), (0, 40, 0): (4, 40, 0), (9, 41, 0): (4, 40, 0)}


def test_entries_of_a_palette():
    wanted = {(9, 9, 9): 4, (1, 1, 1): 2, 2: 5, 0: 1}
    entries, indices, merged = palette.allocate((7, 7, 7), wanted, [(5, 5, 5)])
    assert len(entries) == 256 and entries[0] == (7, 7, 7) and entries[255] == (5, 5, 5) and merged == 0
    assert indices == {(1, 1, 1): 1, (9, 9, 9): 3, 2: 2, 0: 0}
    assert entries[1:5] == [(1, 1, 1), palette.wheel(2), (9, 9, 9), (0, 0, 0)]


@pytest.mark.parametrize("colours, merged", [(253, 0), (254, 254)])
def test_colours_beyond_the_entries_are_merged(colours, merged):
    wanted = {(n, 0, 0): 1 for n in range(colours)} | {2: 1}
    entries, indices, found = palette.allocate((7, 7, 7), wanted, [(5, 5, 5)])
    assert found == merged and set(indices.values()) <= set(range(1, 255))
    assert all(abs(entries[indices[colour]][0] - colour[0]) <= 1 for colour in wanted if colour != 2)


def test_an_index_that_the_program_keeps_is_refused():
    assert palette.allocate((0, 0, 0), {254: 1}, [(5, 5, 5)])[1] == {254: 254}
    with pytest.raises(ToolError, match="colour_index 255 is one of the entries 255..255"):
        palette.allocate((0, 0, 0), {255: 1}, [(5, 5, 5)])
    with pytest.raises(ToolError, match="use up all 255 palette entries"):
        palette.allocate((0, 0, 0), {(1, 2, 3): 1, **{n: 1 for n in range(1, 255)}}, [(5, 5, 5)])
