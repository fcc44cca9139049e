# SPDX-License-Identifier: MIT
"""Light and colours of scenes: what becomes of each key of light at run time, the ramp, and each refusal; light that the tool bakes into
textures, in however many directions their faces look; and how many colours become few."""

import json
import types
import zlib

import numpy
import pytest

from board_programs import BOARD
from conftest import CHECKOUT, run_cli
from fixel.base.errors import ToolError
from fixel.image import image, image_light
from fixel.report import showcase_models
from fixel.scene import compiler, look, palette, toml_scene, toml_texture
from model_files import build, glb, gltf, png
# place field: images that are broken, for the tools
from scene_sections import section
from test_model_files import grid

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "host/judge", "host/raycast", "host/predict")
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
    """light 3.3a, formats 1.11d."""
    scene = build(tmp_path, LIGHT + 'dark = "#102030"\n' + BOX)
    [colour] = colours_of(scene)
    shades = [scene.palette[level[colour]] for level in scene.light.ramp]
    assert shades[0] == (0x10, 0x20, 0x30) and shades[-1] == (0xE0, 0x80, 0x40)
    assert shades == [palette.between(shades[0], shades[-1], level, 8) for level in range(9)]
    other = next(i for i in range(256) if i != colour)
    assert all(level[other] == other for level in scene.light.ramp)


def test_what_has_no_shade_keeps_its_colour_at_every_level(tmp_path):
    """light 3.3c."""
    scene = build(tmp_path, LIGHT + BOX + BOX + "shade = false\nlayer = 1\n")
    [lit], [plain] = colours_of(scene, 0), colours_of(scene, 1)
    assert lit != plain and scene.palette[lit] == scene.palette[plain]
    assert {level[plain] for level in scene.light.ramp} == {plain} and len({level[lit] for level in scene.light.ramp}) == 9


def test_many_colours_share_the_palette(tmp_path):
    """light 3.3b-c."""
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
    """Where the palette has no room for every shade, too. light 3.3b."""
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
            ("[light]\nstrength = 1\n", ["strength", "give levels"]),
            ("[light]\nfog = { near = 1, far = 2 }\n", ["fog", "give levels"]),
            (LIGHT + 'sky = "red"\n', ["sky", "leave out levels"]),
            (LIGHT + "direction = [0, 0, 0]\n", ["no direction"]),
            (LIGHT + "fog = { near = 2, far = 2 }\n", ["near = 2", "not below"]),
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


# --- light that is baked into textures --------------------------------------------------------

CHECKS = png([[(255, 255, 255) if (x + y) % 2 else (200, 200, 200) for x in range(16)] for y in range(16)])


def hill(tmp_path):
    """A textured hill whose faces look in many directions."""
    points, triangles = grid(12, lambda x, y: x * y / 9)
    file = tmp_path / "m.glb"
    data, blob = gltf(points, triangles, uvs=[(x / 12, y / 12) for x, y, _ in points], image=CHECKS)
    data["materials"][0]["doubleSided"] = True
    file.write_bytes(glb(data, blob))
    return file


def baked(file, **more):
    """The scene of a model with baked light."""
    made, notes = compiler.compile_scene(str(file), 4, look=look.of(look.Asked(bake_light=True, **more), "rgb565", 16, 16))
    assert image.unpack(image.pack(made)) == made
    return made, notes


def test_a_model_has_no_light_at_run_time_and_at_most_16_textures(tmp_path):
    made, notes = baked(hill(tmp_path))
    faces = made.models[0].faces
    assert made.light is None and not any("directions" in note for note in notes)
    assert len({face.normal for face in faces}) > 50 and 4 < len(made.surfaces.textures) <= toml_texture.DIRECTIONS_MAX
    assert all(face.mapped.normals == (0, 0, 0) for face in faces)
    plain, _ = compiler.compile_scene(str(hill(tmp_path)), 4, look=look.Look())
    assert plain.light is not None and len(plain.surfaces.textures) == 1


def test_each_texture_is_as_bright_as_its_faces_are_lit(tmp_path):
    """Within half of a level of the light, and the rounding of RGB565."""
    made, _ = baked(hill(tmp_path))
    light = palette.Light([0.8, -1, 0.4], 1 / 3, (0xFF, 0xF2, 0xDC), (0xC4, 0xD4, 0xFF))
    wanted = {face: light.bake((255, 255, 255), face.normal) for model in made.models for face in map(_Key, model.faces)}
    step = (max(map(sum, wanted.values())) - min(map(sum, wanted.values()))) / 15
    for face, colour in wanted.items():
        texture = made.surfaces.textures[made.surfaces.surfaces[face.mapped.surface].texture - 1]
        texels = [int.from_bytes(texture.texels[i:i + 2], "little") for i in range(0, 2 << texture.log_width + texture.log_height, 2)]
        shown = numpy.array([((each >> 11) * 255 / 31, (each >> 5 & 63) * 255 / 63, (each & 31) * 255 / 31) for each in texels]).max(axis=0)
        assert abs(shown.sum() - sum(colour)) <= step / 2 + 3 * 255 / 62 + 3


class _Key:
    """A face that may be a key."""

    def __init__(self, face):
        self.normal, self.mapped = face.normal, face.mapped


def test_a_scene_file_says_it_by_light_bake(tmp_path):
    hill(tmp_path)
    scene = '[light]\n{}[[objects]]\nmodel = "m.glb"\nimages = true\nmerge = false\n'
    (tmp_path / "s.toml").write_text(scene.format("bake = true\n"))
    made, notes = compiler.compile_scene(str(tmp_path / "s.toml"))
    assert made.light is None and len(made.surfaces.textures) > 4 and not any("directions" in note for note in notes)
    (tmp_path / "s.toml").write_text(scene.format("bake = true\nlevels = 16\n"))
    with pytest.raises(ToolError, match="bake: belongs to light that the tool computes"):
        compiler.compile_scene(str(tmp_path / "s.toml"))


def test_a_model_without_textures_has_flat_faces(tmp_path):
    file = showcase_models.write(next(each for each in showcase_models.MODELS if each.name == "vase"), tmp_path)
    made, _ = baked(file)
    assert made.light is None and made.surfaces is None and len({face.colour for face in made.models[0].faces}) > 8


def test_what_moves_cannot_be_baked(tmp_path):
    file = showcase_models.write(next(each for each in showcase_models.MODELS if each.name == "planets"), tmp_path)
    with pytest.raises(ToolError, match="--bake-light: the animation moves parts"):
        baked(file)


def test_the_option_and_its_scene_file_give_the_same_frames(tmp_path):
    file, a, b = hill(tmp_path), tmp_path / "a.fxls", tmp_path / "b.fxls"
    done = run_cli("build", file, "--bake-light", "-o", a, "--write", tmp_path / "s.toml")
    assert done.returncode == 0, done.stderr
    assert "bake = true" in (tmp_path / "s.toml").read_text() and run_cli("build", tmp_path / "s.toml", "-o", b).returncode == 0
    assert a.read_bytes() == b.read_bytes()
    done = run_cli("build", file, "--bake-light", "--smooth", "40", "-o", a)
    assert done.returncode == 2 and "--bake-light and --smooth exclude each other" in done.stderr


def test_a_board_draws_it_as_double_does(build, tmp_path):
    done = run_cli("run", "--board", BOARD, "--scene", hill(tmp_path), "--frames", 2, "--bake-light", "--out", tmp_path / "run", "--build", build)
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "run" / "summary.json").read_text())
    assert summary["pixels_unexplained"] == 0 and summary["order_wrong_pixels"] == 0 and "light at run time" not in done.stderr


# --- the palette ------------------------------------------------------------------------------

ONE_COLOUR = 1 << 30
WHITE = (255, 255, 255)


@pytest.mark.parametrize("normal, part", [
    ((0, ONE_COLOUR, 0), 0.75 + 0.25),                             # turned to the light, and up: all of the glow
    ((0, -ONE_COLOUR, 0), 0.25 * 0.75),                            # turned from it, and down: three quarters of the glow
    ((ONE_COLOUR, 0, 0), 0.75 * 0.5 ** 1.5 + 0.25 * 0.875)])       # half way
def test_a_face_has_a_part_of_its_colour(normal, part):
    for direction in ((0, -1, 0), (0, -3, 0)):
        made = palette.Light(direction, 0.25, WHITE, WHITE).bake((200, 100, 50), normal)
        assert made == tuple(round(each * part) for each in (200, 100, 50))


def test_light_and_glow_have_colours():
    assert palette.Light((0, -1, 0), 0.25, (255, 0, 0), (0, 0, 255)).bake((200, 100, 48), (0, ONE_COLOUR, 0)) == (150, 0, 12)
    # From the side: the light travels along x and z, and a face that looks back at it has all of it.
    light = palette.Light((3, 0, -4), 0, WHITE, WHITE)
    assert light.bake((200, 100, 50), (round(-0.6 * ONE_COLOUR), 0, round(0.8 * ONE_COLOUR))) == (200, 100, 50)
    assert light.bake((200, 100, 50), (round(0.6 * ONE_COLOUR), 0, round(-0.8 * ONE_COLOUR))) == (0, 0, 0)


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
