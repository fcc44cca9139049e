# SPDX-License-Identifier: MIT
"""No pixel changes: every scene draws the frames on record, on the host and on emulated cores. Of the cores, each state
of the sources tries a sample of the scenes."""

import pathlib
import shutil

from board_programs import built
from conftest import CHECKOUT, run_cli, sampled
import pytest

from fixel.base.errors import ToolError
from fixel.scene import making
from fixel.board import dump, emulator, flash_memory
from fixel.check import frame_hashes

BUILT_PROGRAMS = ("host/frames",)
MODELS = CHECKOUT.parent / "shared" / "models"
OWN = sorted((CHECKOUT / "scenes").glob("*.toml"))
OTHERS = [CHECKOUT / "host_tests" / "judges" / "frames" / f"{name}.toml" for name in ("spot", "teapot")]
# Armv6-M, Armv7-M, Armv8.1-M, and the library built for size.
BOARDS = ("microbit", "mps2-an385", "mps3-an547", "mps2-an505")
# Sorted models need more entries for the order of drawing than 16 KB of RAM hold, and so do pieces of what moves among a
# tree; and these two images are larger than a scene partition of 256 KB.
NO_ROOM = {"microbit": {"gallery", "horizon", "knot", "lines", "spot", "teapot", "w3", "w3b", "c500", "e300", "f32", "f32p", "g2000"},
           "mps3-an547": {"spot", "teapot"}}
# Each record's scene, and the layers that are to have a tree where they are not those that the scene names.
SCENES = {**{file.stem: (file, None) for file in [*OWN, *OTHERS]},
          "knot-by-distance": (CHECKOUT / "scenes" / "knot.toml", "none")}
ON_BOARDS = sampled("frame hashes", [(board, name) for name in SCENES for board in BOARDS
                                     if name not in NO_ROOM.get(board, ())], 20)
TIMEOUT = 60.0      # seconds of CPU time without a new frame


@pytest.fixture(scope="module", params=SCENES, name="scene")
def fixture_scene(request, tmp_path_factory):
    """A record's name and the image of its scene."""
    folder = tmp_path_factory.mktemp("frames")
    source, layers = SCENES[request.param]
    if source in OTHERS:
        model = MODELS / f"{source.stem}.obj"
        if not model.exists():
            pytest.skip(f"needs ../shared/models/{model.name}")
        source = pathlib.Path(shutil.copy(source, folder))
        shutil.copy(model, folder)
    image = folder / "scene.fxls"
    making.build(str(source), str(image), layers=layers)
    return request.param, image


def test_each_scene_has_a_record_and_no_record_is_without_a_scene():
    assert sorted(frame_hashes.load()) == sorted(SCENES)


def test_the_host_draws_what_is_on_record(build, scene, tmp_path):
    name, image = scene
    drawn = frame_hashes.drawn_by_host(image, build, tmp_path)
    assert frame_hashes.difference(frame_hashes.load()[name], drawn) == ""


@pytest.mark.parametrize("board, scene", ON_BOARDS, indirect=["scene"])
def test_emulated_cores_draw_it(build, board, scene, tmp_path):
    name, image = scene
    record = frame_hashes.load()[name]
    elf = built(f"{board}/walk.elf")
    flash_memory.flash(board, elf, image, tmp_path / "flash.bin")
    out = tmp_path / "frames.fxld"
    emulator.run(board, tmp_path / "flash.bin", elf, out, timeout=TIMEOUT)
    assert frame_hashes.difference(record, dump.read_dump(out)) == ""


def test_a_changed_pixel_or_counter_is_seen(build, tmp_path):
    image = tmp_path / "tiny.fxls"
    making.build(str(CHECKOUT / "scenes" / "tiny.toml"), str(image))
    record = frame_hashes.load()["tiny"]
    drawn = frame_hashes.drawn_by_host(image, build, tmp_path)
    drawn.frames[3].counters["drawn"] += 1
    assert frame_hashes.difference(record, drawn).startswith("counters are")
    pixels = drawn.frames[5].pixels.copy()
    pixels[7, 9] ^= 1
    object.__setattr__(drawn.frames[5], "pixels", pixels)
    assert frame_hashes.difference(record, drawn).startswith("frame 5 ")


def test_the_tool_alters_no_record(build, tmp_path, monkeypatch):
    image = tmp_path / "tiny.fxls"
    making.build(str(CHECKOUT / "scenes" / "tiny.toml"), str(image))
    records = frame_hashes.load()
    assert frame_hashes.add(image, records, build, tmp_path) == "on record"
    records["tiny"] = {**records["tiny"], "frames": ["0" * frame_hashes.DIGITS] * len(records["tiny"]["frames"])}
    with pytest.raises(ToolError, match="frame 0"):
        frame_hashes.add(image, records, build, tmp_path)


def test_wrong_usage_is_said():
    done = run_cli("frame-hashes", "none.toml")
    assert done.returncode == 2 and "none.toml" in done.stderr
