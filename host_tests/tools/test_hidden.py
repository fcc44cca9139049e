# SPDX-License-Identifier: MIT
"""Methods for hidden surfaces against each other, frame by frame: the picture is one and the same."""

import json
import pathlib
import subprocess

import pytest

from conftest import run_cli

FRAMES = 30
SCENES = ("tiny", "cube", "plaza", "w1", "w3")


@pytest.fixture(scope="module", name="found", params=SCENES)
def fixture_found(request, build, tmp_path_factory):
    image = tmp_path_factory.mktemp("hidden") / f"{request.param}.fxls"
    made = run_cli("scene", "build", pathlib.Path("scenes") / f"{request.param}.toml", "-o", image)
    assert made.returncode == 0, made.stderr
    done = subprocess.run([build / "host" / "hidden", image, "--frames", str(FRAMES), "--seed", "7"],
                          text=True, capture_output=True, timeout=300, check=False)
    assert done.returncode == 0, done.stderr
    return request.param, json.loads(done.stdout)


def test_the_span_buffer_draws_the_painters_picture(found):
    """Whole and in bands, with any list and any pool, by both scans."""
    scene, tally = found
    assert tally["frames"] == (1 if scene == "w3" else min(FRAMES, 16 if scene == "tiny" else FRAMES))
    assert tally["covered"] > 0 and tally["draws"] == 24 * tally["frames"]
    assert min(tally[name] for name in ("in_bands", "with_small_list", "with_least_pool", "by_box")) > 0
    assert tally["differing"] == 0
    assert tally["miscounted"] == 0


def test_overdraw_is_one(found):
    """Pixels are counted as they are written: each that is covered once, no other."""
    _, tally = found
    assert tally["counted_draws"] == tally["frames"]
    assert tally["counted_covered"] == tally["covered"]
    assert tally["counted_writes"] == tally["counted_covered"]
    assert tally["most_writes"] == 1


def test_a_full_pool_was_met(found):
    """Where a row holds more than one interval, the least pool is too small for a whole frame."""
    scene, tally = found
    assert tally["split_bands"] >= tally["split_draws"]
    assert scene == "cube" or tally["split_draws"] > 0


def test_bad_arguments_are_refused(build):
    for arguments in ([], ["no such file"], ["--frames"], ["a", "b"], ["a", "--seed", "x"]):
        done = subprocess.run([build / "host" / "hidden", *arguments], text=True, capture_output=True,
                              timeout=60, check=False)
        assert done.returncode == 2
        assert done.stderr.startswith("error: ")
