# SPDX-License-Identifier: MIT
"""The frustum's inset and the border of the screen: what an inset takes from the picture is told (docs/accuracy.md, section 4.1)."""

import json
import subprocess

import pytest

from clipper_names import clipper_names
from fixel.image import image, image_lens
from fixel.scene import making

WIDTH, HEIGHT, FRAMES = 320, 240, 3
ROOM = """
screen = { width = 320, height = 240 }
view = { fov = 75, near = "1/256", far = 100, INSET }
background = "#102030"
[[objects]]
solid = "box"
inside = true
scale = ["1/50", "1/50", "1/50"]
colours = ["#806040", "#608040", "#406080", "#804060", "#604080", "#408060"]
[path]
keys = [{ position = [0, 0, 0], yaw = 0, frames = FRAMES }, { position = [0, 0, 0], yaw = 60, pitch = 10 }]
"""


def judged(build, folder, inset, clipper="view", near="1/256"):
    """A room so small that its walls are where near is, drawn with such an inset: (frames' pixels of background,
    the judge's verdict)."""
    source, compiled, dump, verdict = (folder / f"room.{end}" for end in ("toml", "fxls", "fxld", "json"))
    source.write_text(ROOM.replace(", INSET", inset).replace("1/256", near).replace("FRAMES", str(FRAMES)), encoding="utf-8")
    making.build(source, compiled)
    subprocess.run([build / "host" / "frames", compiled, dump, "--clipper", clipper], check=True, capture_output=True)
    subprocess.run([build / "host" / "judge", compiled, dump, "--clipper", clipper, "--json", verdict], check=True,
                   capture_output=True)
    data, frame = dump.read_bytes(), 32 + WIDTH * HEIGHT + 48
    pixels = [data[784 + i * frame + 32:784 + i * frame + 32 + WIDTH * HEIGHT] for i in range(FRAMES)]
    return [each.count(0) for each in pixels], json.loads(verdict.read_text(encoding="utf-8"))


@pytest.mark.parametrize("clipper", ["view", "world", "once"])
def test_a_border_of_background_is_told(build, tmp_path, clipper):
    """accuracy 4.1."""
    background, verdict = judged(build, tmp_path, ', inset = "4/65536"', clipper)
    assert min(background) > 1000
    for empty, frame in zip(background, verdict["frames"]):
        assert frame["pixels_unexplained"] > 0.9 * empty


@pytest.mark.parametrize("clipper", clipper_names(but=("world", "left")))
def test_the_default_leaves_no_border(build, tmp_path, clipper):
    background, verdict = judged(build, tmp_path, "", clipper)
    assert background == [0] * FRAMES
    assert verdict["pixels_unexplained"] == 0


@pytest.mark.parametrize("near, inset", [("1/256", 1), ("1/128", 1), ("1/110", 1), ("1/128", 2), ("1/256", 0)])
def test_a_run_says_beforehand_that_the_inset_hides_pixels(build, tmp_path, near, inset):
    """Where a half pixel of border is hidden at the near plane, where the room's walls are, there are unexplained ones."""
    told = judged(build, tmp_path, f', inset = "{inset}/65536"', near=near)[1]["pixels_unexplained"]
    scene = image.load(tmp_path / "room.fxls")
    note = image_lens.note_of_inset(scene)
    assert (note is not None) == (told > 0) == (image_lens.hidden_border(scene) > 0.5)
    assert note is None or f"{image_lens.hidden_border(scene):.2f} pixel" in note and "view.inset" in note
