# SPDX-License-Identifier: MIT
"""Scenes with surfaces in the live window, beside the reference renderer. build/view/<scene>.png is how each looked."""

import numpy
import pytest

import scene as scene_tool
from board_programs import ROOT
from fixel import browser
from test_view_page import canvases, show_beside, wait_for_frames
from viewers import HEIGHT, WIDTH, ready

# Pixels of a frame that may show another texel or level than the reference does: within their bounds of
# docs/extras/surfaces.md, which `make run` judges.
DIFFER = {"landscape": 20, "gallery": 1000, "car": 50, "room": 1000}


@pytest.mark.parametrize("name", DIFFER)
def test_a_scene_is_walked_beside_the_reference(name, chromium, build, tmp_path):
    ready("mps2-an385", build)
    image = tmp_path / f"{name}.fxls"
    scene_tool.build(str(ROOT / "scenes" / f"{name}.toml"), str(image))
    with browser.viewing("mps2-an385", image, build) as (_, address), \
            browser.page(chromium, address, WIDTH, HEIGHT) as page:
        page.set_default_timeout(0)
        page.wait_for_function("() => document.getElementById('board-rate').textContent !== '–'")
        show_beside(page, "1", "double")
        first, _ = canvases(page, "fixed", "other")
        page.keyboard.down("ArrowRight")
        wait_for_frames(page, 10)
        page.keyboard.up("ArrowRight")
        wait_for_frames(page, 5)
        fixed, double = canvases(page, "fixed", "other")
        assert (fixed != first).any(axis=2).mean() > 0.01
        assert len(numpy.unique(fixed.reshape(-1, 3), axis=0)) > 10
        assert fixed.shape == double.shape and (fixed != double).any(axis=2).sum() <= DIFFER[name]
        (build / "view").mkdir(exist_ok=True)
        page.screenshot(path=str(build / "view" / f"{name}.png"))
        assert page.complaints == []
