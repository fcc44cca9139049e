# SPDX-License-Identifier: MIT
"""docs/looks.md: each pair of pictures is what its two commands draw, and the two halves differ."""

import re

import numpy
import pytest
from conftest import CHECKOUT
from PIL import Image

from fixel.image import image_surface
from fixel.report import looks
from fixel.scene import compiler, look

PAGE = (CHECKOUT / "docs" / "looks.md").read_text(encoding="utf-8")
ROWS = re.findall(r"^\| !\[(\w+)\]\(looks/(\w+)\.png\) \| .* \| `([^`]+)`; `([^`]+)` \|$", PAGE, re.MULTILINE)


def test_the_page_has_every_pair_with_its_commands():
    assert [(name, wrong, right) for name, _, wrong, right in ROWS] == [(name, wrong, right) for name, (wrong, right, _) in looks.LOOKS.items()]
    assert all(name == file for name, file, *_ in ROWS) and len(ROWS) > 5
    assert sorted(file.stem for file in (CHECKOUT / "docs" / "looks").glob("*.png")) == sorted(looks.LOOKS)


def test_the_page_shows_the_commands_of_a_half():
    assert f".venv/bin/fixel build docs/looks/open.toml --screen {looks.SCREEN} --frames {looks.FRAMES} -o open.fxls" in PAGE
    assert "--look backs" in PAGE and list(looks.LOOKS).index("backs") == 2


@pytest.mark.parametrize("name", list(looks.LOOKS))
def test_a_pair_is_what_the_page_shows(build, name):
    drawn = numpy.array(looks.pair(build / "host" / "frames", name))
    assert numpy.array_equal(drawn, numpy.array(Image.open(CHECKOUT / "docs" / "looks" / f"{name}.png").convert("RGB")))
    width = (drawn.shape[1] - looks.GAP) // 2
    differs = (drawn[:, :width] != drawn[:, -width:]).any(axis=2)
    assert differs.mean() > 0.01


CONE = "v 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\nv 0 0 3\ng cone\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 4 3 2 1\n"    # z points upward
STRAY = CONE + "v 90 0 0\nv 91 0 0\nv 90 1 0\nv 90 0 1\ng stray\nf 6 8 7\nf 6 7 9\nf 7 8 9\nf 8 6 9\n"


def cured(folder, text, cure="", key="[[objects]]\n"):
    """A SceneImage of the scene file that --write writes of a model, with a line of the table in it."""
    (folder / "m.obj").write_text(text, encoding="utf-8")
    written, _ = compiler.compile_scene(str(folder / "m.obj"), 4, look=look.Look(), write=str(folder / "s.toml"))
    assert key in written.text and cure.partition(" = ")[0] in PAGE
    made = written.text.replace(key, key + cure + "\n", 1) if key == "[[objects]]\n" else written.text.replace(key, cure, 1)
    (folder / "s.toml").write_text(made, encoding="utf-8")
    return compiler.compile_scene(str(folder / "s.toml"))[0]


def test_cures_without_a_picture(tmp_path):
    lying, standing = (max(cured(tmp_path, CONE, *cure).models[0].vertices, key=lambda vertex: vertex[1]) for cure in ((), ("rotation = [0, -90, 0]",)))
    assert standing[1] > 1.4 * lying[1] and abs(standing[0]) + abs(standing[2]) < 100     # the tip
    before, after = (cured(tmp_path, CONE, *cure).path[0] for cure in ((), ("start = 210", "start = 30")))
    assert all(abs(one + other) < 100 for one, other in zip((before[0], before[2]), (after[0], after[2])))
    assert [len(cured(tmp_path, STRAY, *cure).models[0].faces) for cure in ((), ('without = ["stray"]',))] == [9, 5]
    assert not cured(tmp_path, CONE).surfaces
    assert [kind.flags & image_surface.BLENDED for kind in cured(tmp_path, CONE, "blend = true").surfaces.surfaces] == [image_surface.BLENDED]
