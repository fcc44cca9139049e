# SPDX-License-Identifier: MIT
"""Scene files that are lit at run time: what becomes of each key, the ramp, and each refusal."""

import types

import pytest

from conftest import CHECKOUT
from fixel.image import image, image_light
from fixel.scene import palette, toml_scene
from fixel.base.errors import ToolError
# place field: images that are broken, for the tools
from scene_sections import section
from scene_text import build

BOX = '[[objects]]\nsolid = "box"\nposition = [0, 0, 5]\ncolour = "#e08040"\n'
LIGHT = "[light]\nlevels = 9\n"
ONE, Q30 = 65536, 1 << 30


def colours_of(scene, model=0):
    return {face.colour for face in scene.models[model].faces}


def test_levels_make_an_image_with_light(tmp_path):
    baked, lit = build(tmp_path, BOX), build(tmp_path, LIGHT + BOX)
    assert baked.light is None and section(image.pack(baked), "light") == (0, 0)
    assert section(image.pack(lit), "light")[1] == 1 and section(image.pack(lit), "levels")[1] == len(lit.light.ramp)
    assert len(colours_of(baked)) > 1 and len(colours_of(lit)) == 1


def test_each_key_becomes_a_number(tmp_path):
    light = build(tmp_path, LIGHT + "ambient = 0.25\nstrength = 0.5\ndirection = [0, -3, 0]\nfog = { near = 2, far = 8.5 }\n"
                  "points = [{ position = [1, 2, 3], range = 4 }, { position = [0, 0, 0], range = 0.5, strength = 0.125 }]\n"
                  + BOX).light
    assert (light.ambient, light.strength, light.direction) == (Q30 // 4, Q30 // 2, (0, -Q30, 0))
    assert light.fog == (2 * ONE, 17 * ONE // 2)
    assert build(tmp_path, LIGHT + "fog = { near = 0, far = 32767 }\n" + BOX).light.fog == (0, 32767 * ONE)
    assert light.points == [(ONE, 2 * ONE, 3 * ONE, 4 * ONE, Q30), (0, 0, 0, ONE // 2, Q30 // 8)]


def test_the_least_range_of_a_point_light(tmp_path):
    def points(reach):
        return LIGHT + f"points = [{{ position = [0, 0, 0], range = {reach} }}]\n" + BOX
    assert build(tmp_path, points(2 ** -16)).light.points == [(0, 0, 0, 1, Q30)]
    with pytest.raises(ToolError, match="range"):
        build(tmp_path, points(2 ** -16 - 2 ** -30))


def test_what_is_not_given_has_a_default(tmp_path):
    light = build(tmp_path, LIGHT + BOX).light
    assert (light.ambient, light.strength) == (round(0.4 * Q30), round(0.6 * Q30))
    assert light.fog == (0, 0) and light.points == [] and len(light.ramp) == 9


# place light: the ramp that the tools make
def test_a_ramp_goes_from_dark_to_the_colour_itself(tmp_path):
    scene = build(tmp_path, LIGHT + 'dark = "#102030"\n' + BOX)
    [colour] = colours_of(scene)
    shades = [scene.palette[level[colour]] for level in scene.light.ramp]
    assert shades[0] == (0x10, 0x20, 0x30) and shades[-1] == (0xE0, 0x80, 0x40)
    assert shades == [palette.between(shades[0], shades[-1], level, 8) for level in range(9)]
    other = next(i for i in range(256) if i != colour)
    assert all(level[other] == other for level in scene.light.ramp)


def test_what_has_no_shade_keeps_its_colour_at_every_level(tmp_path):
    """light 3.3."""
    scene = build(tmp_path, LIGHT + BOX + BOX + "shade = false\nlayer = 1\n")
    [lit], [plain] = colours_of(scene, 0), colours_of(scene, 1)
    assert lit != plain and scene.palette[lit] == scene.palette[plain]
    assert {level[plain] for level in scene.light.ramp} == {plain} and len({level[lit] for level in scene.light.ramp}) == 9


def test_many_colours_share_the_palette(tmp_path):
    colours = ", ".join(f'"#{r:02x}{g:02x}40"' for r in range(0, 256, 12) for g in range(0, 256, 12))
    text = f'[[objects]]\nsolid = "floor"\ncells = [20, 20]\nposition = [0, -1, 5]\nscale = 20\ncolours = [{colours}]\n'
    scene = build(tmp_path, LIGHT + text + BOX + "shade = false\n" + "[palette]\nreserve = 7\n")
    assert 200 < len(colours_of(scene)) and max(colours_of(scene)) < 249
    shown = {level[colour] for level in scene.light.ramp for colour in colours_of(scene)}
    assert max(shown) < 249
    assert all(level[entry] == entry for level in scene.light.ramp for entry in range(249, 256))


def nearest(palette, colour):
    return min(range(len(palette)), key=lambda i: (sum((a - b) ** 2 for a, b in zip(palette[i], colour)), i))


def test_levels_are_the_nearest_entries(tmp_path):
    """Where the palette has no room for every shade, too. light 3.3."""
    colours = ", ".join(f'"#{i * 5 % 256:02x}{i * 37 % 256:02x}{i * 91 % 256:02x}"' for i in range(90))
    scene = build(tmp_path, LIGHT + f'[[objects]]\nsolid = "floor"\ncells = [10, 10]\nposition = [0, -1, 5]\ncolours = [{colours}]\n')
    assert len(colours_of(scene)) == 90
    for colour in colours_of(scene):
        for number, level in enumerate(scene.light.ramp[:-1]):
            wanted = palette.between((0, 0, 0), scene.palette[colour], number, 8)
            assert level[colour] == nearest(scene.palette, wanted)
        assert scene.light.ramp[-1][colour] == colour


def test_a_colour_index_is_lit(tmp_path):
    scene = build(tmp_path, LIGHT + BOX.replace('colour = "#e08040"', "colour_index = 200"))
    assert colours_of(scene) == {200}
    assert scene.palette[scene.light.ramp[0][200]] == (0, 0, 0) and scene.light.ramp[8][200] == 200


def test_a_beam_lights_the_levels(tmp_path):
    beam = "[[beams]]\ndirection = [0, -1, 0]\nwindow = [[-1, 3, 4], [-1, 3, 6], [1, 3, 6], [1, 3, 4]]\n"
    scene = build(tmp_path, LIGHT + beam + BOX)
    [colour] = colours_of(scene)
    for level in scene.light.ramp[1:]:
        before, after = scene.palette[level[colour]], scene.palette[scene.lit[level[colour]]]
        assert sum(after) > sum(before)


def test_what_is_wrong_is_named(tmp_path):
    for text, parts in (
            ("[light]\nlevels = 1\n", ["levels = 1", "2..64"]),
            ("[light]\nlevels = 65\n", ["levels = 65"]),
            ("[light]\nstrength = 1\n", ["strength", "give levels"]),
            ("[light]\nfog = { near = 1, far = 2 }\n", ["fog", "give levels"]),
            (LIGHT + 'sky = "red"\n', ["sky", "leave out levels"]),
            (LIGHT + "ambient = 1.5\n", ["ambient = 1.5"]),
            (LIGHT + "strength = -1\n", ["strength = -1"]),
            (LIGHT + "direction = [0, 0, 0]\n", ["no direction"]),
            (LIGHT + "fog = { near = 2, far = 2 }\n", ["near = 2", "not below"]),
            (LIGHT + "fog = { near = 2 }\n", ['"far" is missing']),
            (LIGHT + "fog = { near = 2, far = 40000 }\n", ["far = 40000"]),
            (LIGHT + "points = [{ position = [0, 0, 0] }]\n", ['"range" is missing']),
            (LIGHT + "points = [{ position = [0, 0, 0], range = 0 }]\n", ["points[0]", "range = 0"]),
            (LIGHT + "points = [{ position = [0, 0, 9000], range = 1 }]\n", ["position[2]"]),
            (LIGHT + "points = [" + "{ position = [0, 0, 0], range = 1 }," * 5 + "]\n", ["5 point lights", "4"]),
            (LIGHT + "level = 1\n", ["unknown key", "levels"])):
        with pytest.raises(ToolError) as caught:
            build(tmp_path, text + BOX)
        for part in parts:
            assert part in str(caught.value)


def test_the_own_scene_has_what_it_promises():
    scene, notes = toml_scene.compile_file(str(CHECKOUT / "scenes" / "lit.toml"))
    light = scene.light
    assert len(light.ramp) == 24 and len(light.points) == image_light.POINTS_MAX and light.strength and any(light.fog)
    assert scene.motions and not [note for note in notes if "merged" in note]


def test_too_many_colours_share_the_entries_by_how_many_there_are_of_each_kind():
    """Three quarters of the colours are not lit."""
    def grey(number):
        return number % 256, number // 2 % 256, number // 3 % 256
    light = types.SimpleNamespace(dark=(0, 0, 0), levels=2)
    wanted = {**{grey(number): 1 for number in range(300)}, **{(*grey(number), 1): 1 for number in range(300, 400)}}
    _, indices, merged, _, _ = palette.allocate_lit((0, 0, 0), wanted, (), light, None)
    plain, lit = ({index for colour, index in indices.items() if len(colour) == length} for length in (3, 4))
    assert len(plain) <= 255 * 3 // 4 and len(lit) <= 255 - 255 * 3 // 4 and not plain & lit
    assert len(plain) > 180 and len(lit) > 60
    assert merged == 400
