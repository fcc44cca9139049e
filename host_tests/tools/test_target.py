# SPDX-License-Identifier: MIT
"""PIXELS=, ORDER= and DEPTH=: what a scene is drawn as, in the place of what its [view] says, and what is refused."""

import re

import pytest
from conftest import CHECKOUT, assert_one_sentence, run_cli, run_make

from fixel.base.errors import ToolError
from fixel.board import dump, methods
from fixel.image import image
from fixel.scene import making
from fixel.scene.target import Target

BUILT_PROGRAMS = ("boards/host/walk", "host/judge", "host/raycast")
TINY, KNOT = CHECKOUT / "scenes/tiny.toml", CHECKOUT / "scenes/knot.toml"


# place pixel-format: the values of PIXELS=
def asked_of(scene):
    """(bits of a pixel, bits of its depth, whether by distance) that an image asks for."""
    return scene.pixel_bits, scene.depth_bits, scene.by_distance


def built(tmp_path, source, asked=None, **more):
    file = tmp_path / "scene.fxls"
    making.build(str(source), str(file), asked=asked, **more)
    return file


def pixel_bits(drawn):
    """Of a frame dump."""
    return 8 * drawn.frames[0].pixels.itemsize


# --- what a scene is drawn as -----------------------------------------------------------

@pytest.mark.parametrize("source, asked, expected", [
    (TINY, Target(), (8, 0, False)),
    (TINY, Target("rgb565"), (16, 0, False)),
    (TINY, Target("rgb565", "distance", "32"), (16, 32, True)),
    (KNOT, Target(order="distance", depth="16"), (8, 16, True)),
    (KNOT, Target(order="tree"), (8, 0, False)),
    (CHECKOUT / "scenes/gallery.toml", Target(depth="0"), (8, 0, False)),
    (CHECKOUT / "examples/cube/cube.obj", Target("rgb565", depth="16"), (16, 16, False)),
])
def test_a_scene_asks_for_what_is_asked_for(tmp_path, source, asked, expected):
    """rgb565 3.5."""
    assert asked_of(image.load(built(tmp_path, source, asked))) == expected


def test_what_is_asked_for_has_the_last_word(tmp_path):
    scene = tmp_path / "deep.toml"
    scene.write_text(TINY.read_text(encoding="utf-8").replace("view = { ", 'view = { pixels = "rgb565", depth = 32, '), encoding="utf-8")
    assert asked_of(image.load(built(tmp_path, scene))) == (16, 32, False)
    assert asked_of(image.load(built(tmp_path, scene, Target(pixels="palette")))) == (8, 32, False)
    assert asked_of(image.load(built(tmp_path, scene, Target(depth="0")))) == (16, 0, False)


def test_an_image_is_drawn_as_something_else(build, tmp_path):
    """An image that is built already is drawn as one that is built so; it stays as it is."""
    plain = built(tmp_path, TINY, frames=2)
    before, frames = plain.read_bytes(), []
    for name, words in (("image", (plain,)), ("scene", (TINY, "--frames", 2))):
        done = run_cli("run", "--board", "host", "--scene", *words, "--pixels", "rgb565", "--depth", "16", "--out", tmp_path / name)
        assert done.returncode == 0, done.stderr
        frames.append(dump.read_dump(tmp_path / name / "board.fxld"))
    assert pixel_bits(frames[0]) == 16 and frames[0].pictures_sha256 == frames[1].pictures_sha256
    assert plain.read_bytes() == before


def test_a_flash_image_is_booted_as_something_else(build, tmp_path):
    scene, flash, elf = built(tmp_path, TINY, frames=2), tmp_path / "host.bin", build / "boards/host/walk"
    done = run_cli("flash", "--board", "host", "--elf", elf, "--scene", scene, "--image", flash, "--pixels", "rgb565")
    assert done.returncode == 0, done.stderr
    before, bits = flash.read_bytes(), []
    for words in ((), ("--pixels", "palette", "--depth", "16")):
        done = run_cli("boot", "--board", "host", "--image", flash, "--elf", elf, "--dump", tmp_path / "frames.fxld", *words)
        assert done.returncode == 0, done.stderr
        bits.append(pixel_bits(dump.read_dump(tmp_path / "frames.fxld")))
    assert bits == [16, 8] and flash.read_bytes() == before


# --- what is refused ---------------------------------------------------------------------

def names_all(said, settings):
    """Whether a sentence names each setting and its value."""
    return all(word in said.lower() for setting in settings for word in setting.lower().split("="))


@pytest.mark.parametrize("settings, cure", [
    ("VISIBILITY=depth DEPTH=16", "leave out DEPTH=16"), ("VISIBILITY=tree ORDER=distance DEPTH=0", "leave out ORDER=distance DEPTH=0"),
    ("VISIBILITY=spans-box PIXELS=rgb565", "leave out PIXELS=rgb565"), ("ORDER=tree DEPTH=32", "leave out DEPTH=32"),
    ("PIXELS=rgb", "palette rgb565"), ("ORDER=bsp", "distance tree"), ("DEPTH=24", "0 16 32"),
    *((f"BOARD={board} {setting}", "that it fits are: host ") for board, setting in (
        ("microbit", "DEPTH=32"), ("stm32vldiscovery", "DEPTH=16"), ("stm32vldiscovery", "PIXELS=rgb565"), ("stm32vldiscovery", "ORDER=tree"),
        ("microbit", "PROGRAM=game PIXELS=rgb565 DEPTH=16"), ("stm32vldiscovery", "VISIBILITY=spans"))),
])
def test_make_refuses_before_anything_is_built(settings, cure):
    done = run_make("run", *settings.split())
    assert done.returncode == 2 and names_all(done.stderr, settings.split()) and cure in done.stderr
    assert done.stdout == "" and len(done.stderr.splitlines()) == 1


@pytest.mark.parametrize("settings", ["PIXELS=palette ORDER=distance DEPTH=0 BOARD=stm32vldiscovery", "VISIBILITY=depth-32 BOARD=microbit",
                                      "DEPTH=16 PIXELS=rgb565 BOARD=microbit", "VISIBILITY=depth PIXELS=rgb565"])
def test_make_takes_what_goes_together(settings):
    done = run_make("-n", "run", *settings.split(), "MAKE=:")
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("settings, cure", [
    ("PIXELS=rgb", "palette or rgb565"), ("ORDER=", "distance or tree"), ("DEPTH=8", "0, 16 or 32"),
    ("ORDER=tree DEPTH=16", "leave out DEPTH=16"), ("VISIBILITY=depth ORDER=distance", "leave out ORDER=distance"),
    ("VISIBILITY=spans PIXELS=rgb565", "PIXELS=palette"), ("VISIBILITY=none", "sorted, box"), ("ORDER=tree", "tree"),
])
def test_the_tools_refuse_the_same(tmp_path, settings, cure):
    words = [word for setting in settings.split() for word in ("--" + setting.replace("=", " ", 1).lower()).split(" ")]
    done = run_cli("run", "--board", "host", "--scene", TINY, "--frames", 1, "--out", tmp_path / "out", *words)
    assert_one_sentence(done, cure)
    assert names_all(done.stderr, settings.split()) and not (tmp_path / "out").exists()


def refused(parts, call, *arguments, **more):
    """What is called is refused in a sentence that has these parts, the cure last."""
    with pytest.raises(ToolError) as caught:
        call(*arguments, **more)
    assert not [part for part in parts if part not in str(caught.value)], caught.value


@pytest.mark.parametrize("asked, settings", [(Target(depth="16"), "DEPTH=16"), (Target("rgb565", depth="32"), "PIXELS=rgb565 DEPTH=32")])
def test_a_depth_buffer_is_refused_beside_the_order_by_tree(tmp_path, asked, settings):
    refused([settings, "knot.toml", "ORDER=distance"], built, tmp_path, KNOT, asked)


TEXELS = CHECKOUT / "host_tests/fuzz/scenes/texels.toml"
ADDED = 'view = { %s }\n[[objects]]\nsolid = "tile"\nposition = [0, -1, 5]\nblend = "add"\n'


def test_frames_of_a_palette_cannot_show_texels_of_rgb565(tmp_path):
    """One sentence names both, and the way out; so it does of an image that is built already. rgb565 3.5e-f, surfaces 1.3d."""
    for scene, name in ((TEXELS, '"stones"'), (built(tmp_path, TEXELS), "0")):
        refused(["PIXELS=palette", f"texture {name}", "bits = 8"], making.make_scene_image, scene, tmp_path, None, asked=Target("palette"))
    plain = tmp_path / "plain.toml"
    plain.write_text(TEXELS.read_text(encoding="utf-8").replace('pixels = "rgb565", ', ""), encoding="utf-8")
    refused(["plain.toml", "[view]", "bits = 8"], built, tmp_path, plain)
    assert asked_of(image.load(built(tmp_path, plain, Target("rgb565", depth="32")))) == (16, 32, False)


def test_frames_of_a_palette_cannot_add_colours(tmp_path):
    """rgb565 3.5e-f."""
    scene = tmp_path / "added.toml"
    scene.write_text(ADDED % "", encoding="utf-8")
    refused(['blend = "add"', 'pixels = "rgb565"', "[view]"], built, tmp_path, scene)
    scene.write_text(ADDED % 'pixels = "rgb565"', encoding="utf-8")
    assert asked_of(image.load(built(tmp_path, scene))) == (16, 0, False)
    refused(["PIXELS=palette", 'blend = "add"', "PIXELS=rgb565", "blend = true"], built, tmp_path, scene, Target("palette"))


def test_beams_cannot_light_texels_of_rgb565(tmp_path):
    scene = tmp_path / "lit.toml"
    scene.write_text(TEXELS.read_text(encoding="utf-8").replace("[palette]", "[[beams]]\ndirection = [0, -1, 0]\nwindow = [[0, 2, 2], "
                                                                "[0, 2, 4], [2, 2, 4]]\n[palette]"), encoding="utf-8")
    refused(["lit.toml", "beams", 'texture "stones"', "bits = 8"], built, tmp_path, scene)


def test_the_order_by_tree_is_refused_beside_a_depth_buffer(tmp_path):
    refused(["ORDER=tree", "gallery.toml", "DEPTH=0"], built, tmp_path, CHECKOUT / "scenes/gallery.toml", Target(order="tree"), layers="all")


# --- VISIBILITY= ---------------------------------------------------------------------------

def test_the_judge_draws_the_methods_as_their_table_says():
    """The reference renderer includes nothing of the project, so it has a table of its own."""
    text = (CHECKOUT / "host_tests/judges/reference/frustum.c").read_text(encoding="utf-8")
    judged = {name: (tree == "true", flat == "true", int(bits))
              for name, tree, flat, bits in re.findall(r'\{"([\w-]+)",\s+(\w+), (\w+), (\d+)\}', text)}
    assert judged == {name: (row.order == "tree", not row.shows_surfaces, row.depth_bits) for name, row in methods.rows().items()}
    assert len(judged) == 9


def test_the_host_draws_the_methods_as_their_table_says():
    text = (CHECKOUT / "host_tests/judges/frames/methods.c").read_text(encoding="utf-8")
    drawn = {name: (order, target, surfaces == "true")
             for name, order, target, surfaces in re.findall(r'\{"([\w-]+)", &fxl_by_(\w+), &fxl_(\w+), (\w+)\}', text)}
    assert drawn == {name: (row.order, row.target.removeprefix("fxl_") or f"palette_depth_{row.depth_bits}".removesuffix("_depth_0"),
                            row.shows_surfaces) for name, row in methods.rows().items()}
