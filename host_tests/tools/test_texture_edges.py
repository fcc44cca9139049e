# SPDX-License-Identifier: MIT
"""What a face's texture shows at its edges, and which textures have levels by default."""

from fractions import Fraction
import random

import pytest

from fixel.image import image_surface
from fixel.scene import surfaces
from scene_text import build

TEXTURE = '[[textures]]\nname = "t"\npattern = "checker"\nsize = [16, 8]\n'
TILE = '[[objects]]\nsolid = "tile"\nposition = [0, -1, 5]\ntexture = "t"\n'
CORNERS = [(0, 0, 0), (9, 0, 0), (9, 9, 0), (0, 9, 0)]
MARGIN = surfaces.edge_margin(16, 1, image_surface.DIVIDE_16)


def kept(*coordinates, margin=MARGIN):
    """Those of a face of three or four corners on a texture of 16 x 8 texels that repeats."""
    values = [tuple(map(Fraction, corner)) for corner in coordinates]
    return surfaces.within_edges(CORNERS[:len(values)], values, (0, 1, 2), (16, 8), margin)


@pytest.mark.parametrize("division, between", [(image_surface.DIVIDE_16, 0.3), (image_surface.DIVIDE_8, 0.075), (image_surface.DIVIDE_1, 0)])
def test_a_margin_is_what_a_coordinate_may_be_off(division, between):
    """What SPEC.md, 9.2, allows between two divisions, and rounding, which grows with the texture and with its levels."""
    for side, levels in ((8, 1), (64, 4), (256, 4), (256, 8)):
        rounding = surfaces.edge_margin(side, levels, division) - Fraction(between)
        assert 9 * side / 65536 + 2 ** (levels - 1) / 256 < rounding < 20 * side / 65536 + 2 ** levels / 256


def test_what_ends_at_an_edge_of_a_texture_that_repeats_stays_on_its_side():
    m = MARGIN
    assert kept((0, 0), (16, 0), (16, 8), (0, 8)) == [(m, m), (16 - m, m), (16 - m, 8 - m), (m, 8 - m)]
    assert kept((-16, 8), (32, 8), (32, 24)) == [(m - 16, 8 + m), (32 - m, 8 + m), (32 - m, 24 - m)]     # three times, from its edges on
    assert kept((0, 1), (5, 1), (5, 7)) == [(m, 1), (5, 1), (5, 7)]
    assert kept((Fraction(-1, 200), 1), (5, 1), (5, 7))[0] == (m, 1)     # a file's rounding beyond the edge
    for crosses in ([(3, 1), (20, 1), (20, 7)], [(-1, 1), (15, 1), (15, 7)], [(8, 1), (Fraction(161, 10), 1), (12, 7)]):
        assert kept(*crosses) == crosses                                 # it shows both sides


def test_what_lies_on_an_edge_or_within_its_margin_shows_one_column():
    narrow = Fraction(1, 10)
    assert kept((0, 1), (narrow, 1), (0, 7)) == [(MARGIN, 1), (MARGIN, 1), (MARGIN, 7)]
    assert kept((16, 1), (16 - narrow, 1), (16, 7)) == [(16 - MARGIN, 1), (16 - MARGIN, 1), (16 - MARGIN, 7)]
    assert {u for u, _ in kept((0, 1), (0, 2), (0, 7))} == {MARGIN} and {u for u, _ in kept((16, 1), (16, 2), (16, 7))} == {16 - MARGIN}


def test_kept_coordinates_are_affine_and_hardly_move():
    """Also where a parallelogram has one corner at an edge. Faces of three corners that share one agree about it."""
    chance, touched = random.Random(48), 0
    for _ in range(300):
        (a, b), (c, d), (e, f) = ((chance.choice((0, 1, 4, 8, 12, 16)), chance.choice((0, 1, 3, 6, 8))) for _ in range(3))
        face = [(a, b), (c, d), (c + e - a, d + f - b), (e, f)]
        found = kept(*face)
        touched += found != face
        (p, q), (r, s), (t, u), (v, w) = found
        assert abs(p + t - r - v) <= surfaces.BEND_MAX and abs(q + u - s - w) <= surfaces.BEND_MAX
        assert all(abs(x - y) <= MARGIN for one, other in zip(face, found) for x, y in zip(one, other))
    assert touched > 100
    one, other = kept((0, 1), (5, 0), (9, 3)), kept((0, 1), (9, 3), (2, 8))
    assert one[0] == other[0] == (MARGIN, 1) and one[2] == other[1]


def test_a_texture_that_clamps_keeps_its_coordinates(tmp_path):
    whole, moved = ([(u / 65536, v / 65536) for u, v in build(tmp_path, TEXTURE + says + TILE).models[0].faces[0].mapped.texels]
                    for says in ('wrap = "clamp"\n', ""))
    assert {u for u, _ in whole} == {0, 16} and {v for _, v in whole} == {0, 8}
    assert all(0.3 < u < 15.7 and 0.3 < v < 7.7 for u, v in moved)


@pytest.mark.parametrize("shown", ['texture = "t"', 'textures = ["", "t"]'])
@pytest.mark.parametrize("solid, said, levels", [("floor", "", 5), ("floor", "levels = 1\n", 1), ("floor", "levels = 3\n", 3), ("tile", "", 1)])
def test_a_texture_of_a_floor_has_levels_unless_it_says_otherwise(tmp_path, solid, said, levels, shown):
    """A texture that another solid shows has one level."""
    shown = shown if solid == "floor" else 'texture = "t"'
    scene = build(tmp_path, TEXTURE + said + f'[[objects]]\nsolid = "{solid}"\nscale = [8, 1, 8]\nposition = [0, -1, 5]\n{shown}\n')
    assert [each.levels for each in scene.surfaces.textures] == [levels]
