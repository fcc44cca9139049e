# SPDX-License-Identifier: MIT
"""Scenes drawn as PIXELS=, ORDER= and DEPTH= ask for, on a large board, a small one and one with vector instructions: each
frame is the host's byte for byte, and every pixel that differs from double is explained. make test tries a sample, make test
WHOLE=1 all."""

import json

import pytest
from conftest import CHECKOUT, run_cli, run_make, sampled

from fixel.scene.target import VALUES

BUILT_PROGRAMS = ("boards/host/walk", "boards/microbit/walk.elf", "boards/mps2-an385/walk.elf", "boards/mps3-an547/walk.elf",
                  "host/judge", "host/predict", "host/raycast")
BOARDS = ("mps2-an385", "microbit", "mps3-an547")
FRAMES = 6
# By distance, without a depth buffer and with one; and a scene with a tree, by it and without it.
SCENES = [*((f"scenes/{scene}", ("--depth", depth)) for scene in ("gallery", "room", "car", "grove") for depth in ("0", "16")),
          ("scenes/knot", ("--order", "tree")), ("scenes/knot", ("--order", "distance", "--depth", "16"))]
# Texels of RGB565 and colours that are added, which frames of a palette cannot show.
TEXELS = [("host_tests/fuzz/scenes/texels", ("--depth", depth)) for depth in ("0", "16")]
MATRIX = [*((board, scene, pixels, words) for board in BOARDS for scene, words in SCENES for pixels in VALUES["pixels"]),
          *((board, scene, "rgb565", words) for board in BOARDS for scene, words in TEXELS)]
FRAMES_OF = {"host_tests/fuzz/scenes/texels": 3}
# What moves among the tree is cut to its leaves, for which the smallest board has too little memory. Its partition for scenes
# holds no gallery.
NO_ROOM = ("microbit", "scenes/knot", ("--order", "tree"))
NO_PARTITION = ("microbit", "scenes/gallery")


def test_the_matrix_has_all_that_it_should():
    assert len(MATRIX) == 30 * len(VALUES["pixels"]) + 6 and sum((board, scene, words) == NO_ROOM for board, scene, _, words in MATRIX) == len(VALUES["pixels"])


@pytest.mark.parametrize("board, scene, pixels, words", sampled("matrix", MATRIX, 4))
def test_a_scene_is_drawn_as_asked(build, tmp_path, board, scene, pixels, words):
    elf = f"build/boards/{board}/walk.elf"
    made = run_make(elf) if not (CHECKOUT / elf).exists() else None
    assert made is None or made.returncode == 0, made.stderr
    done = run_cli("run", "--board", board, "--scene", CHECKOUT / f"{scene}.toml", "--frames", FRAMES_OF.get(scene, FRAMES), "--out", tmp_path / "out",
                   "--pixels", pixels, *words)
    if (board, scene, words) == NO_ROOM:
        assert done.returncode == 13 and "too small to cut what moves among the tree" in done.stderr
        return
    if (board, scene) == NO_PARTITION:
        assert done.returncode == 2 and "scene partition of board microbit" in done.stderr
        return
    assert done.returncode == 0, done.stdout + done.stderr
    summary = json.loads((tmp_path / "out" / "summary.json").read_text(encoding="utf-8"))
    assert summary["host_frames_equal"] and summary["pixels_unexplained"] == 0 and summary["frames"] == FRAMES_OF.get(scene, FRAMES)
