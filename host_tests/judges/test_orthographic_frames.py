# SPDX-License-Identifier: MIT
"""Frames with an orthographic lens, against the reference renderer in double (docs/extras/orthographic.md)."""

import host_frames
import pytest
from conftest import run_cli
from drawn_scenes import head
from host_frames import judged, pixels

from fixel.scene.target import VALUES

BUILT_PROGRAMS = ("host/frames", "host/judge")
TARGETS = [(form, bits) for form in VALUES["pixels"] for bits in (0, 16, 32)]
FAR, CUT = (9, 1, 60), (14, 14, 22)     # scale, near, far; in the second frames near and far cut faces
ASIDE = (11.7, 1, 60, 31.3, 60.9)       # and the centre

PATH = """
[path]
keys = [{ position = [-12, 15, -12], yaw = 45, pitch = -35.26, frames = 3 },
        { position = [-10, 12, -14], yaw = 40, pitch = -30, roll = 8, frames = 3 },
        { position = [-2, 6, -10], yaw = 0, pitch = -30 }]
"""
LIGHT = "[light]\nlevels = 16\nambient = 0.3\nstrength = 0.7\ndirection = [0.5, -0.7, 0.5]\nfog = { near = 5, far = 50 }\n"
BEAM = "[glow]\nstrength = 1.25\n[[beams]]\ndirection = [0.85, -0.5, 0.3]\nwindow = [[-14, 1, -3.9], [-14, 7.5, -3.9], [-14, 7.5, 3.7]]\n"
BOARD = '[[billboards]]\nname = "tree"\npattern = "tree"\nsize = [2, 3]\n'
TREES = '[[objects]]\nbillboard = "tree"\nposition = [-2, 0.6, -2]\nrepeat = { count = [3, 1, 3], step = [3, 0, 3] }\nlayer = 1\n'
LINES = """
[[objects]]
solid = "box"
colour = "#4060c0"
position = [1, 0.5, -6]
scale = [2, 3, 1]
rotation = [30, 0, 10]
edges = { colour = "white", width = 3 }
lines = [{ at = [[-0.7, 0.9, -0.6], [0.8, -0.2, 0.9], [0.9, 0.9, 0.2]], colour = "#f0e020", width = 2 }]
points = [{ at = [[0, 0.8, 0], [0.7, 0.7, 0.7]], colour = "#e02020", width = 5 }]
layer = 1
[[objects]]
solid = "box"
colour = "#c060a0"
position = [5, 1, -1]
spin = { yaw = 9, pitch = 5 }
size = 2.5
edges = { colour = "#20e0e0", width = 1 }
layer = 1
"""
FLAT = """
[[objects]]
solid = "box"
colour = "#40a040"
position = [-4.5, 0, -4.5]
repeat = { count = [4, 1, 4], step = [3, 0, 3] }
layer = 1
[[objects]]
solid = "torus"
sides = 40
rings = 20
scale = 2
colour = "#d04040"
position = [3, 4, 2]
rotation = [70, 20, 0]
layer = 1
[[objects]]
solid = "torus"
colour = "#d0d040"
position = [-3, 3, 2]
motion = { circle = 0.5, degrees = 12 }
turn = [10, 20, 30]
size = 1.6
layer = 1
"""
TEXTURED = """
[[objects]]
solid = "floor"
cells = [3, 3]
scale = [14, 1, 14]
position = [0, -0.7, 0]
texture = "stones"
texels_per_unit = 16
layer = 0
[[objects]]
solid = "box"
texture = "crate"
tiles = [1, 1]
position = [-4.5, 0, -4.5]
repeat = { count = [4, 1, 4], step = [3, 0, 3] }
division = "affine"
layer = 1
[[objects]]
solid = "box"
texture = "crate"
smooth = true
position = [3, 3, 0]
spin = { yaw = 12 }
layer = 1
"""


def scene(folder, lens, target, *parts):
    scale, near, far, *centre = lens
    form, bits = target
    file = folder / "scene.toml"
    view = [f"scale = {scale}", f"near = {near}", f"far = {far}", f'pixels = "{form}"', f"depth = {bits}"]
    if centre:
        view.append(f"centre = {centre}")
    textures = [(name, name, 64) for name in ("crate", "stones")]
    file.write_text('background = "#203040"\n' + head(120, 72, view, textures) + "".join(parts) + PATH)
    return host_frames.compiled(file, folder / "scene.fxls")


def explained(build, image, *options):
    dumped = host_frames.drawn(build, image, "frames", *options)
    assert judged(build, image, dumped)["pixels_unexplained"] == 0
    return pixels(dumped)


@pytest.mark.parametrize("lens", [FAR, CUT, ASIDE])
@pytest.mark.parametrize("target", TARGETS)
@pytest.mark.parametrize("parts", [(LIGHT, BOARD, TREES, FLAT), (LIGHT, BOARD, TEXTURED, TREES), (BEAM, FLAT), (LINES, FLAT), (LIGHT, LINES, BOARD, TEXTURED, TREES)])
def test_the_reference_explains_each_pixel_in_bands_too(parts, target, lens, build, tmp_path):
    """orthographic 2.4c, 2.5b, 2.5c, 2.8a, 2.10a-c, 2.11b-d, 2.12a, 2.12b, formats 1.2bc, SPEC 4.2o"""
    image = scene(tmp_path, lens, target, *parts)
    whole = explained(build, image)
    assert len(set(b"".join(whole))) > 4
    for options in (["--rows", "7", "--list", "0"], ["--rows", "5", "--list", "400", "--cache", "0"]):
        assert pixels(host_frames.drawn(build, image, "bands", *options)) == whole


@pytest.mark.parametrize("more, parts", [('tree = "all"\n', (FLAT,)), ("", (BEAM, TEXTURED.replace("smooth = true\n", "")))])
def test_what_does_not_go_with_the_lens_is_refused_by_the_tool(more, parts, tmp_path):
    file = tmp_path / "scene.toml"
    textures = [(name, name, 64) for name in ("crate", "stones")]
    file.write_text(more + head(120, 72, ["scale = 9"], textures) + "".join(parts) + PATH)
    made = run_cli("build", file, "-o", tmp_path / "scene.fxls")
    assert made.returncode == 2 and not (tmp_path / "scene.fxls").exists()
    assert "orthographic" in made.stderr and ("tree" if more else "beams") in made.stderr


@pytest.mark.parametrize("key", ["fov = 60", "focal = 100", "centre = [1000, 2]", "inset = 0.5", "scale = 5000"])
def test_a_lens_of_two_kinds_is_refused(key, tmp_path):
    file = tmp_path / "scene.toml"
    view = ["scale = 9", key] if not key.startswith("scale") else [key]
    file.write_text(head(120, 72, view) + FLAT + PATH)
    made = run_cli("build", file, "-o", tmp_path / "scene.fxls")
    assert made.returncode == 2 and not (tmp_path / "scene.fxls").exists()
    assert key.split()[0] in made.stderr and "scene.toml" in made.stderr
