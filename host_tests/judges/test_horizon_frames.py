# SPDX-License-Identifier: MIT
"""Scene files with a horizon, their images, and their frames against the reference renderer in double (docs/extras/horizon.md)."""

import math

import host_frames
import pytest
from conftest import assert_one_sentence, run_cli
from drawn_scenes import head
from host_frames import judged, pixels

from fixel.base.errors import ToolError
from fixel.board.programs import HostPrograms
from fixel.image import image, image_horizon
from fixel.scene import compiler
from fixel.scene.target import VALUES

BUILT_PROGRAMS = ("host/frames", "host/judge", "host/raycast")
TARGETS = [(form, bits) for form in VALUES["pixels"] for bits in (0, 16, 32)]
SKY = '[horizon]\ndegrees = [-50, -20, -5, %s, 5, 20, 45, 70]\ncolours = ["#201008", "#402010", "#604020", "#806040", "#c0d8f0", "#80b0f0", "#6090e0", "#4070c0", "#204080"]\n'
LIGHT = '[light]\nlevels = 16\nambient = 0.3\ndark = "#203040"\nfog = { near = 2, far = 14 }\n'
BOX = '[[objects]]\nsolid = "box"\ncolour = "#c04030"\nposition = [0, 0, 4]\n'
GLASS = BOX.replace("[0, 0, 4]", "[-1, 1, 3]") + "blend = true\n"
TURNS = """
[path]
keys = [{ position = [0, 0, -3], frames = 1 }, { position = [0, 0, -3], pitch = 20, roll = 50, frames = 3 },
        { position = [0, 1, -3], pitch = 85, roll = 200, frames = 3 }, { position = [0, 1, -3], yaw = 30, pitch = -70, roll = 290, frames = 3 }]
"""


def scene(folder, *parts, name="scene", target=("palette", 0), lens=("fov = 80",), degrees="0"):
    form, bits = target
    file = folder / f"{name}.toml"
    file.write_text('background = "#ff00ff"\n' + head(96, 72, [*lens, "near = 0.25", "far = 64", f'pixels = "{form}"', f"depth = {bits}"]) +
                    SKY % degrees + "".join(parts))
    return host_frames.compiled(file, folder / f"{name}.fxls")


@pytest.mark.parametrize("target", TARGETS)
@pytest.mark.parametrize("lens", [("fov = 80",), ("focal = 60", "centre = [90, 10]")])
def test_the_reference_explains_each_pixel_in_bands_too(build, tmp_path, target, lens):
    """horizon 1.1a, 1.2a, 1.2b, 1.3a, 1.3b, 1.4a, 1.5a, 1.5b"""
    scenery = scene(tmp_path, LIGHT, BOX, GLASS, TURNS, target=target, lens=lens)
    dumped = host_frames.drawn(build, scenery, "frames")
    found, whole = judged(build, scenery, dumped), pixels(dumped)
    assert found["pixels_unexplained"] == 0 and len(set(b"".join(whole))) > 6
    for options in (["--rows", "7", "--list", "0"], ["--rows", "5", "--cores", "2"]):
        assert pixels(host_frames.drawn(build, scenery, "bands", *options)) == whole


@pytest.mark.parametrize("moved", ["0.001", "-0.001"])
@pytest.mark.parametrize("degrees, sound", [(0.00004, True), (0.00007, False)])
def test_a_level_that_is_off_by_more_than_the_bound_is_not_explained(build, tmp_path, moved, degrees, sound):
    """Frames with the horizon moved, to the other side of a row of pixels whose middle is that many degrees from the horizon. 2^-20 is an
    elevation of 0.0000546 degrees."""
    pitch = math.degrees(math.atan(0.5 * math.tan(math.radians(40)) / 48)) + math.copysign(degrees, float(moved))
    path = f"[path]\nkeys = [{{ position = [0, 0, -3], pitch = {pitch:.9f} }}]\n"
    given, other = (scene(tmp_path, BOX, path, name=name, degrees=at) for name, at in (("given", "0"), ("moved", moved)))
    found = judged(build, given, host_frames.drawn(build, other, "moved"))
    assert found["pixels_differing"] > 80 and (found["pixels_unexplained"] == 0) is sound, found


def test_rays_show_the_same(build, tmp_path):
    scenery = scene(tmp_path, BOX, TURNS)
    found = HostPrograms(build).raycast(scenery, host_frames.drawn(build, scenery, "frames"), tmp_path / "rays.json", 1)
    assert found["pixels_unexplained"] == 0 and found["pixels"] == 10 * 96 * 72


def test_a_scene_without_the_table_has_no_section(tmp_path):
    compiled, _ = compiler.compile_scene(str(_file(tmp_path, BOX + TURNS)))
    assert compiled.horizon is None and image.unpack(image.pack(compiled)).horizon is None


def _file(folder, text):
    file = folder / "scene.toml"
    file.write_text(text)
    return file


def test_sines_are_rounded_to_the_nearest_and_colours_are_entries_of_their_own(tmp_path):
    text = '[horizon]\ndegrees = [-90, 0, 30, 45, 90]\ncolours = ["red", "#010203", "red", "lime", "blue", "#102030"]\n'
    compiled, _ = compiler.compile_scene(str(_file(tmp_path, text + BOX + TURNS)))
    made_of = image.unpack(image.pack(compiled)).horizon
    assert made_of == compiled.horizon and made_of.sines == (-1 << 30, 0, 1 << 29, round(2 ** 0.5 * (1 << 29)), 1 << 30)
    assert [compiled.palette[entry] for entry in made_of.colours] == [(255, 0, 0), (1, 2, 3), (255, 0, 0), (0, 255, 0), (0, 0, 255), (16, 32, 48)]


@pytest.mark.parametrize("text, words", [
    ('[horizon]\ndegrees = [0]\ncolours = ["red", "lime", "blue"]\n', ("3 colours for 1 elevations", "one more")),
    ('[horizon]\ndegrees = [0, -1]\ncolours = ["red", "lime", "blue"]\n', ("degrees", "ascending")),
    ('[horizon]\ndegrees = [91]\ncolours = ["red", "lime"]\n', ("degrees", "-90..90 degrees")),
    ('[horizon]\ndegrees = [0]\n', ('"colours" is missing',)),
    ('[view]\nscale = 9\n[horizon]\ndegrees = [0]\ncolours = ["red", "lime"]\n', ("an orthographic lens and a horizon do not go together", "leave out one"))])
def test_a_refusal_names_the_key_and_the_cure(tmp_path, text, words):
    file, out = _file(tmp_path, text + BOX), tmp_path / "out.fxls"
    assert_one_sentence(run_cli("build", file, "-o", out), "scene.toml", "horizon", *words)
    assert not out.exists()


@pytest.mark.parametrize("sines, words", [
    ([(5,), (4,)], ("sine 1", "below the one before it")), ([((1 << 30) + 1,)], ("sine 0", "-1..1")), ([(-(1 << 30) - 1,)], ("sine 0", "-1..1"))])
def test_an_image_whose_horizon_is_broken_is_refused(sines, words):
    with pytest.raises(ToolError) as caught:
        image_horizon.read({"horizon": sines, "horizon colours": bytes(len(sines) + 1)})
    for word in words:
        assert word in str(caught.value)
