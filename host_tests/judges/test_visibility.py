# SPDX-License-Identifier: MIT
"""Methods for hidden surfaces against each other, frame by frame: the picture is one and the same."""

import json
import pathlib
import subprocess

import pytest

from conftest import run_cli

FRAMES = 30
SCENES = ("tiny", "cube", "plaza", "w1", "w3", "beam")
WITH_TREE = ("plaza", "w1", "knot")


@pytest.fixture(scope="module", name="found",
                params=[(name, False) for name in SCENES] + [(name, True) for name in WITH_TREE])
def fixture_found(request, build, tmp_path_factory):
    """A scene's name and what was counted, by distance or by a tree over all of it."""
    scene, tree = request.param
    image = tmp_path_factory.mktemp("hidden") / f"{scene}.fxls"
    made = run_cli("build", pathlib.Path("scenes") / f"{scene}.toml", "-o", image,
                   "--tree", "all" if tree else "none")
    assert made.returncode == 0, made.stderr
    done = subprocess.run([build / "host" / "hidden", image, "--frames", str(FRAMES), "--seed", "7",
                           "--tree", str(int(tree))],
                          text=True, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    return scene, json.loads(done.stdout)


def test_the_span_buffer_draws_the_painters_picture(found):
    """Whole and in bands, with any list and any pool, by both scans."""
    scene, tally = found
    assert tally["frames"] == {"w3": 1, "tiny": 16, "knot": 24}.get(scene, FRAMES)
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
                              check=False)
        assert done.returncode == 2
        assert done.stderr.startswith("error: ")
