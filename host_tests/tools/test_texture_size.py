# SPDX-License-Identifier: MIT
"""Textures as large as the path shows, or as an option says."""

import math

import numpy
import pytest
from PIL import Image

from conftest import run_cli
from fixel.base.errors import ToolError
from fixel.image import image
from fixel.scene import compiler, look, texture_size
from fixel.scene.target import Target
from model_files import SQUARE, glb, gltf, png

NOISE = [[((37 * x + 91 * y) % 256 & 0xC0, (53 * x * y) % 256 & 0xC0, (11 * x + 7 * y * y) % 256 & 0xC0) for x in range(256)] for y in range(256)]
FOCAL = 160 / math.tan(math.radians(37.5))
WALL = """
[[textures]]
name = "noise"
file = "noise.png"
{size}
[[objects]]
solid = "tile"
rotation = [0, -90, 0]
scale = [4, 1, 4]
texture = "noise"
{more}
[path]
keys = [{{ position = [0, 0, -{far}], frames = 20 }}, {{ position = [0, 0, -{near}] }}]
"""


def sides(scene):
    """Of each texture."""
    return [(1 << each.log_width, 1 << each.log_height) for each in scene.surfaces.textures]


def wall(tmp_path, size, far, near, more="", pixels=256):
    (tmp_path / "noise.png").write_bytes(png([row[:pixels] for row in NOISE[:pixels]]))
    (tmp_path / "s.toml").write_text(WALL.format(size=size, far=far, near=near, more=more))
    made, notes = compiler.compile_scene(str(tmp_path / "s.toml"))
    assert image.unpack(image.pack(made)) == made
    return sides(made), notes


@pytest.mark.parametrize("shown, side", [(300, 256), (129, 256), (127, 128), (65, 128), (63, 64), (9, 16)])
def test_a_wall_has_as_many_texels_as_the_nearest_pose_shows_pixels(tmp_path, shown, side):
    near = 4 * FOCAL / shown        # a wall of 4 units is so many pixels wide
    found, notes = wall(tmp_path, 'size = "path"', 1.5 * near, near)
    assert found == [(side, side)] and any(f"no more than {side} texels a side" in note for note in notes)


def test_without_a_size_a_file_keeps_its_own(tmp_path):
    assert wall(tmp_path, "", 90, 60)[0] == [(256, 256)]


@pytest.mark.parametrize("pixels, size, side", [(256, 64, 64), (200, 256, 256), (100, 32, 32), (16, 64, 16)])
def test_a_size_is_the_most_of_a_side(tmp_path, pixels, size, side):
    assert wall(tmp_path, f"size = {size}", 9, 6, pixels=pixels)[0] == [(side, side)]


@pytest.mark.parametrize("size, more, words", [
    ("size = 48", "", ["48", "power of two"]), ('size = "all"', "", ['"all"', "power of two"]), ("size = [64, 64]", "", ["power of two"]),
    ('size = "path"', "texels_per_unit = 4", ["texels_per_unit", '"noise"', "object 0"]),
    ('size = "path"', "texel_offset = [1, 2]", ["texel_offset", "number"])])
def test_sizes_that_are_wrong(tmp_path, size, more, words):
    with pytest.raises(ToolError) as caught:
        wall(tmp_path, size, 9, 6, more)
    assert all(word in str(caught.value) for word in words)


def test_what_moves_and_what_a_player_walks_keeps_its_size(tmp_path):
    for more in ("spin = { yaw = 3 }", ""):
        text = WALL.format(size='size = "path"', far=90, near=60, more=more)
        if not more:
            text = text.partition("[path]")[0] + '[path]\nstart = { position = [0, 0, -90] }\nsteps = [{ keys = ["forward"], frames = 4 }]\n'
        (tmp_path / "noise.png").write_bytes(png(NOISE))
        (tmp_path / "s.toml").write_text(text)
        assert sides(compiler.compile_scene(str(tmp_path / "s.toml"))[0]) == [(256, 256)]


def model(tmp_path):
    """A square with a picture of 256 x 256."""
    (tmp_path / "m.glb").write_bytes(glb(*gltf(*SQUARE, uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], image=png(NOISE))))
    return tmp_path / "m.glb"


def test_a_model_alone_has_what_its_circle_shows(tmp_path):
    file = model(tmp_path)
    for screen, side in (((320, 240), 256), ((160, 120), 128), ((64, 48), 64)):
        made, _ = compiler.compile_scene(str(file), 4, screen, look=look.Look())
        assert sides(made) == [(side, side)]
    made, _ = compiler.compile_scene(str(file), 4, (64, 48), look=look.of(look.Asked(texture=128), "rgb565", 16, 128))
    assert sides(made) == [(128, 128)]
    assert texture_size.needed(made) == {1: (64, 64)}


def test_the_option_gives_the_most_and_no_more_is_tried(tmp_path):
    file, out = model(tmp_path), tmp_path / "out.fxls"
    for words, side in ((["--texture", "32"], 32), (["--look", "--texture 8"], 8), ([], 256)):
        done = run_cli("build", file, "-o", out, *words)
        assert done.returncode == 0, done.stderr
        assert sides(image.load(out)) == [(side, side)]
    wanted = look.smaller(look.Asked(texture=64), "rgb565", 16)
    assert [(each.texels, each.is_fixed) for each in wanted] == [(64, True), (32, False), (16, False), (0, False), (0, False), (0, False)]
    assert [each.animation for each in wanted] == [""] * 5 + ["none"], "what moves is left out last"
    assert look.best(look.Asked(texture=64), Target(), False).texels == 64


def test_the_scene_file_of_a_model_has_the_size(tmp_path):
    file = model(tmp_path)
    done = run_cli("build", file, "-o", tmp_path / "a.fxls", "--screen", "64x48", "--write", tmp_path / "s.toml")
    assert done.returncode == 0, done.stderr
    assert run_cli("build", tmp_path / "s.toml", "-o", tmp_path / "b.fxls").returncode == 0
    assert (tmp_path / "a.fxls").read_bytes() == (tmp_path / "b.fxls").read_bytes() and "size = 64" in (tmp_path / "s.toml").read_text()


@pytest.mark.parametrize("words, said", [(["--texture", "48"], "power of two"), (["--texture", "512"], "power of two"),
                                         (["--texture", "64", "--no-textures"], "exclude each other")])
def test_options_that_are_wrong(tmp_path, words, said):
    done = run_cli("build", model(tmp_path), "-o", tmp_path / "out.fxls", *words)
    assert done.returncode == 2 and said in done.stderr


def test_two_textures_of_one_file_have_a_size_each(tmp_path):
    """The second had one texel; and where both need the same, one is stored."""
    (tmp_path / "noise.png").write_bytes(png(NOISE))
    near = 4 * FOCAL / 200
    for far, found in ((4, [(256, 256), (64, 64)]), (1, [(256, 256)])):
        rows = "".join(f'[[textures]]\nname = "{name}"\nfile = "noise.png"\nsize = "path"\n' for name in "ab")
        walls = "".join(f'[[objects]]\nsolid = "tile"\nrotation = [0, -90, 0]\nscale = [4, 1, 4]\nposition = [{x}, 0, {(away - 1) * near}]\n'
                        f'texture = "{name}"\nshade = false\n' for name, x, away in (("a", -2, 1), ("b", 2, far)))
        (tmp_path / "s.toml").write_text(rows + walls + f"[path]\nkeys = [{{ position = [0, 0, -{near}] }}]\n")
        assert sides(compiler.compile_scene(str(tmp_path / "s.toml"))[0]) == found


def test_the_file_of_a_texture_may_have_as_many_pixels_as_an_image(tmp_path):
    """A file of more than 4 MiB, which was refused."""
    Image.fromarray(numpy.zeros((1500, 1200, 3), dtype=numpy.uint8)).save(tmp_path / "large.bmp")
    assert (tmp_path / "large.bmp").stat().st_size > 5 << 20
    (tmp_path / "s.toml").write_text('[[textures]]\nname = "t"\nfile = "large.bmp"\n[[objects]]\nsolid = "box"\ntexture = "t"\nshade = false\n')
    assert sides(compiler.compile_scene(str(tmp_path / "s.toml"))[0]) == [(256, 256)]
