# SPDX-License-Identifier: MIT
"""docs/looks.md: each pair of pictures is what its two commands draw, and the two halves differ."""

import re

import numpy
import pytest
from conftest import CHECKOUT
from PIL import Image

from fixel.report import looks

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
