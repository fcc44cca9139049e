# SPDX-License-Identifier: MIT
"""What a walk draws with: a tree unasked, VISIBILITY= and CLIPPER=, and what rays say of the order."""

import argparse
import json
import pathlib
import subprocess

import pytest
from conftest import CHECKOUT, assert_one_sentence, run_cli, run_make, sampled

from fixel.scene import making
from fixel.board import fleet, methods
from test_run import walk

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "boards/stm32vldiscovery/walk.elf", "boards/*/walk-*",
                  "host/judge", "host/live", "host/predict", "host/raycast")
KNOT = str(CHECKOUT / "scenes/knot.toml")   # beams that no order by distance draws right
FRAMES = 6


@pytest.fixture(scope="module", name="planted")
def fixture_planted(tmp_path_factory):
    """The knot with a tree."""
    file = tmp_path_factory.mktemp("knot") / "knot.fxls"
    making.build(KNOT, str(file), FRAMES)
    return file


@pytest.fixture(scope="module", name="plain")
def fixture_plain(build, planted, tmp_path_factory):
    """What a walk with the tree leaves, and what it prints."""
    out = tmp_path_factory.mktemp("tree") / "out"
    done = walk(out, scene=planted, frames=None)
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads((out / "summary.json").read_text()), done.stdout


def chosen(out, scene, *words, board="host"):
    """A walk with a choice, built before: its summary."""
    options = methods_of(words)
    built = run_make(f"BOARD={board}", *(f"{word.strip('-').upper()}={name}" for word, name in zip(words[::2], words[1::2])),
                     *(f"build/boards/{name}/{methods.program(options)}{'' if name == 'host' else '.elf'}"
                       for name in {board, "host"}))
    assert built.returncode == 0, built.stdout + built.stderr
    done = run_cli("run", "--board", board, "--scene", scene, "--out", out, *words)
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads((out / "summary.json").read_text())


def methods_of(words):
    parser = argparse.ArgumentParser()
    methods.add_options(parser)
    return parser.parse_args(list(words))


def test_a_scene_with_a_tree_is_drawn_by_it_unasked(plain):
    summary, text = plain
    assert summary["host_frames_equal"] and summary["pixels_unexplained"] == 0
    assert summary["order_wrong_pixels"] == 0 and summary["order_judged_pixels"] == summary["pixels"]
    assert "wrong by the order" in text and "--tree" not in text


def test_the_order_by_distance_is_counted_wrong(build, tmp_path, planted, plain):
    summary = chosen(tmp_path / "out", planted, "--visibility", "sorted")
    assert summary["host_frames_equal"] and summary["pixels_unexplained"] == 0, "board and double agree"
    assert summary["order_wrong_pixels"] > summary["pixels"] / 200
    assert summary["visibility"] == "sorted" and summary["frame_sha256"] != plain[0]["frame_sha256"]


def test_says_what_to_do_where_the_order_is_wrong(build, tmp_path):
    knot = tmp_path / "knot.fxls"
    making.build(KNOT, str(knot), 3, layers="none")
    done = walk(tmp_path / "out", board="host", scene=knot, frames=None)
    assert done.returncode == 0 and "--tree all" in done.stdout


@pytest.mark.parametrize("words", [("--visibility", "tree-spans"),
                                   ("--clipper", "once", "--visibility", "tree"), ("--clipper", "near")])
def test_other_methods_draw_the_same_frames(build, tmp_path, planted, plain, words):
    summary = chosen(tmp_path / "out", planted, *words, board="mps2-an385")
    assert summary["host_frames_equal"] and summary["pixels_unexplained"] == 0
    assert summary["order_wrong_pixels"] == 0
    differing = sum(one != other for one, other in zip(summary["frame_sha256"], plain[0]["frame_sha256"]))
    assert differing == 0 or "--clipper" in words, "another clipper may round another way"


@pytest.mark.parametrize("board, method", sampled("depth", [
    (board, method) for board in ("mps2-an385", "mps3-an547") for method in ("depth", "depth-32")], 2))
def test_a_depth_buffer_draws_the_nearest_faces(build, tmp_path, board, method):
    knot = tmp_path / "knot.fxls"
    making.build(KNOT, str(knot), FRAMES, layers="none")
    summary = chosen(tmp_path / "out", knot, "--visibility", method, board=board)
    assert summary["host_frames_equal"] and summary["pixels_unexplained"] == 0
    assert summary["order_wrong_pixels"] == 0 and summary["order_judged_pixels"] == summary["pixels"]


@pytest.mark.parametrize("name", ["spot", "teapot"])
def test_a_depth_buffer_draws_models_whole(build, tmp_path, name):
    """These models are no part of the project: where they are not, the test is left out."""
    source = CHECKOUT.parent / "shared/models" / f"{name}.obj"
    if not source.exists():
        pytest.skip(f"{source} is not there")
    text = (CHECKOUT / "host_tests/judges/frames" / f"{name}.toml").read_text(encoding="utf-8")
    (tmp_path / f"{name}.obj").write_bytes(source.read_bytes())
    scene = tmp_path / f"{name}.toml"
    scene.write_text(text.replace('anchor = "middle"', 'anchor = "middle"\ntwo_sided = true'), encoding="utf-8")
    file = tmp_path / f"{name}.fxls"
    making.build(str(scene), str(file), 8)
    summary = chosen(tmp_path / "out", file, "--visibility", "depth", board="host")
    assert summary["host_frames_equal"] and summary["pixels_unexplained"] == 0
    assert summary["order_wrong_pixels"] == 0 and summary["pixels_differing"] < 100


@pytest.mark.parametrize("scene", sampled("names", ["beam", "room", "gallery", "car"], 2))
def test_rays_tell_faces_by_their_names_where_there_are_beams_or_surfaces(build, tmp_path, scene):
    done = walk(tmp_path / "out", board="host", scene=str(CHECKOUT / "scenes" / f"{scene}.toml"), frames=4)
    summary = json.loads((tmp_path / "out/summary.json").read_text())
    assert done.returncode == 0, done.stderr
    assert summary["order_judged_pixels"] == summary["pixels"]
    # In the room of the beam, the distance of centres is wrong at a few pixels.
    assert summary["order_wrong_pixels"] <= (summary["pixels"] / 1000 if scene == "beam" else 0)


def test_a_wrong_order_is_counted_by_names_too(build, tmp_path):
    gallery = tmp_path / "gallery.fxls"
    making.build(str(CHECKOUT / "scenes/gallery.toml"), str(gallery), 1, (80, 60))
    summary = chosen(tmp_path / "out", gallery, "--visibility", "surfaces", board="host")
    assert summary["order_wrong_pixels"] > summary["pixels"] / 200


@pytest.mark.parametrize("setting, names", [("CLIPPER=nonsense", "half-spaces"), ("VISIBILITY=nonsense", "tree-spans")])
def test_an_unknown_name_is_refused_with_those_there_are(setting, names):
    done = run_make("-n", "run", setting)
    assert done.returncode == 2 and "nonsense" in done.stderr and names in done.stderr


@pytest.mark.parametrize("scene", ["planted", CHECKOUT / "scenes/room.toml", "depth"], ids=["tree", "surfaces", "depth"])
def test_a_board_without_room_for_a_tree_surfaces_or_depth_says_so(build, tmp_path, planted, scene):
    elf = build / "boards/stm32vldiscovery/walk.elf"
    if not elf.exists():
        assert run_make(elf.relative_to(CHECKOUT)).returncode == 0
    if scene == "depth":
        scene = tmp_path / "deep.toml"
        scene.write_text(pathlib.Path(KNOT).read_text().replace('tree = "all"', "").replace("[view]", '[view]\nvisibility = "depth"'))
    done = walk(tmp_path / "out", board="stm32vldiscovery", scene=planted if scene == "planted" else scene, frames=None)
    assert done.returncode == 13 and "no room to draw by a BSP tree, with surfaces or with a depth buffer" in done.stderr
    assert ("VISIBILITY=surfaces builds a program" in done.stderr) == (scene == CHECKOUT / "scenes/room.toml")
    assert not (tmp_path / "out").exists()


def test_a_board_of_8_kb_draws_surfaces_where_asked(build, tmp_path):
    """The program with surfaces has more flash and stack, and scenes have less (BOARD_MEMORY_FOR_SURFACES in boards/stm32vldiscovery/board.mk)."""
    room = tmp_path / "room.fxls"
    making.build(str(CHECKOUT / "scenes/room.toml"), str(room), 24)
    summary = chosen(tmp_path / "out", room, "--visibility", "surfaces", board="stm32vldiscovery")
    assert summary["host_frames_equal"] and summary["pixels_unexplained"] == 0
    # The list has room for a few of the polygons, so each band of six rows walks the scene.
    assert summary["texel_pixels"] > 0 and summary["polygons"]["spilled"] > summary["polygons"]["drawn"] // 2 > 0
    sizes = fleet.sizes(build / "boards/stm32vldiscovery/walk-surfaces-view.elf")
    assert sizes["scene_room"] == 25 * 1024 and sizes["ram_bytes"] <= 8192


def test_a_board_of_8_kb_draws_the_landscape(build, tmp_path):
    built = run_make("build/boards/stm32vldiscovery/walk.elf")
    assert built.returncode == 0, built.stderr
    done = walk(tmp_path / "out", board="stm32vldiscovery", scene=str(CHECKOUT / "scenes/landscape.toml"), frames=3)
    summary = json.loads((tmp_path / "out/summary.json").read_text())
    assert done.returncode == 0 and summary["host_frames_equal"] and summary["pixels_unexplained"] == 0


@pytest.mark.parametrize("words", [["--hidden"], ["--hidden", "nonsense"], ["--clipper", "nonsense"], ["more", "words"]])
def test_the_reference_of_the_live_window_refuses_unknown_names(build, planted, words):
    done = subprocess.run([build / "host/live", planted, *words], stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, check=False)
    assert_one_sentence(done, "usage")
