# SPDX-License-Identifier: MIT
"""Methods for hidden surfaces against each other, frame by frame: the picture is one and the same. Frames by a tree: before
the reference renderer, before rays, and whatever bands, list and room."""

import json
import pathlib
import random
import subprocess
import tomllib

import pytest
from conftest import CHECKOUT
from host_frames import compiled, run

from fixel.board import dump
from fixel.image import image
from fixel.scene import making, toml_scene, tree

BUILT_PROGRAMS = ("host/hidden", "host/frames", "host/judge", "host/raycast")
FRAMES = 30
SCENES = ("tiny", "cube", "plaza", "w1", "w3", "beam")
WITH_TREE = ("plaza", "w1", "knot")


@pytest.fixture(scope="module", name="found",
                params=[(name, False) for name in SCENES] + [(name, True) for name in WITH_TREE])
def fixture_found(request, build, tmp_path_factory):
    """A scene's name and what was counted, by distance or by a tree over all of it."""
    scene, with_tree = request.param
    file = compiled(pathlib.Path("scenes") / f"{scene}.toml", tmp_path_factory.mktemp("hidden") / f"{scene}.fxls",
                    "--tree", "all" if with_tree else "none")
    return scene, json.loads(run(build / "host" / "hidden", file, "--frames", FRAMES, "--seed", 7, "--tree", int(with_tree)))


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


# --- frames by a tree ------------------------------------------------------------------------------

PLANTED = {"plaza": ("all", 24), "w1": ("0", 20), "knot": ("all", 24), "w3": ("most", 1)}
ROOM = 1 << 20


def draw(build, scene, out, hidden="tree", **options):
    extra = [word for name, value in options.items() for word in (f"--{name}", value)]
    run(build / "host/frames", scene, out, "--hidden", hidden, *extra)
    return out


def verdicts(build, scene, drawn, folder, hidden="tree", every=1):
    """(the judge's, the ray-cast oracle's) on a dump."""
    run(build / "host/judge", scene, drawn, "--json", folder / "judge.json", "--twin",
        folder / "twin.fxld", "--hidden", hidden)
    run(build / "host/raycast", scene, folder / "twin.fxld", "--json", folder / "rays.json",
        "--every", every)
    return [json.loads((folder / name).read_text()) for name in ("judge.json", "rays.json")]


def pictures(file):
    return [frame.pixels.tobytes() for frame in dump.read_dump(file).frames]


@pytest.fixture(scope="module", name="folder")
def fixture_folder(build, tmp_path_factory):
    return tmp_path_factory.mktemp("tree")


@pytest.fixture(scope="module", params=PLANTED, name="planted")
def fixture_planted(request, folder):
    layers, frames = PLANTED[request.param]
    file = folder / f"{request.param}.fxls"
    making.build(str(CHECKOUT / f"scenes/{request.param}.toml"), str(file), frames,
                     layers=layers)
    return request.param, file


def test_double_and_rays_find_nothing_unexplained(build, folder, planted):
    _, scene = planted
    drawn = draw(build, scene, folder / "drawn.fxld", pieces=ROOM)
    judge, rays = verdicts(build, scene, drawn, folder, every=4)
    assert judge["pixels_unexplained"] == 0
    assert judge["pixels_differing"] * 1e5 <= judge["pixels"]
    assert rays["pixels_unexplained"] == 0


@pytest.mark.parametrize("options", [
    {"rows": 7}, {"list": 0}, {"list": 60, "rows": 33}, {"list": 400, "rows": 8, "cache": 1},
    {"hidden": "tree-spans"}, {"hidden": "tree-spans", "list": 100, "rows": 16}])
def test_bands_list_and_direction_change_no_pixel(build, folder, planted, options):
    _, scene = planted
    whole = draw(build, scene, folder / "whole.fxld", pieces=ROOM, frames=6)
    other = draw(build, scene, folder / "other.fxld", pieces=ROOM, frames=6, **options)
    assert pictures(whole) == pictures(other)


def knot_with_ball_at(position, scale):
    """The knot, its ball somewhere else: as if it had moved there."""
    data = tomllib.loads((CHECKOUT / "scenes/knot.toml").read_text(encoding="utf-8"))
    data["objects"][1]["position"] = list(position)
    data["objects"][1]["scale"] = scale
    compiled, _ = toml_scene.compile_data(data, "knot", str(CHECKOUT / "scenes"), 5)
    tree.plant(compiled, {0}, compiled.moving)
    return image.pack(compiled)


def test_a_ball_anywhere_among_the_beams(build, folder):
    """Cut by as many planes as it meets; rays know neither planes nor pieces."""
    chance, scene = random.Random(7), folder / "ball.fxls"
    for _ in range(12):
        place = [round(chance.uniform(-2, 2), 3) for _ in range(3)]
        scene.write_bytes(knot_with_ball_at(place, round(chance.uniform(0.3, 3), 3)))
        drawn = draw(build, scene, folder / "ball.fxld", pieces=ROOM)
        judge, rays = verdicts(build, scene, drawn, folder)
        assert judge["pixels_unexplained"] == 0 and rays["pixels_unexplained"] == 0


def test_balls_in_parts_of_a_tree_that_are_out_of_sight(build, folder):
    """Among the cubes of W1 nodes are left out by their spheres, but not the pieces below them.
    Balls may hide each other by distance alone, which rays would tell: the reference renderer judges."""
    data = tomllib.loads((CHECKOUT / "scenes/w1.toml").read_text(encoding="utf-8"))
    data["objects"].append({"solid": "octahedron", "scale": 3, "moves": True, "colour_index": 9,
                            "colour_step": 20, "positions": [
        [-4, 0, 3], [5, 2, 4], [0, -4, 6], [1, 4, -5], [-6, 1, -2], [3, 0, 0]]})
    compiled, _ = toml_scene.compile_data(data, "w1", str(CHECKOUT / "scenes"), 30)
    tree.plant(compiled, {0}, compiled.moving)
    scene = folder / "balls.fxls"
    scene.write_bytes(image.pack(compiled))
    drawn = draw(build, scene, folder / "balls.fxld", pieces=ROOM)
    judge, _ = verdicts(build, scene, drawn, folder, every=30)
    assert judge["pixels_unexplained"] == 0
    for options in ({"hidden": "tree-spans", "list": 0}, {"rows": 20, "list": 200}):
        other = draw(build, scene, folder / "other.fxld", pieces=ROOM, **options)
        assert pictures(drawn) == pictures(other)


def test_distance_errs_where_the_tree_is_right(build, folder):
    scene = folder / "knot_by_both.fxls"
    making.build(str(CHECKOUT / "scenes/knot.toml"), str(scene), 12, layers="all")
    found = {}
    for hidden in ("sorted", "tree"):
        drawn = draw(build, scene, folder / "both.fxld", hidden, pieces=ROOM)
        judge, rays = verdicts(build, scene, drawn, folder, hidden)
        assert judge["pixels_unexplained"] == 0     # each reference has its own order
        found[hidden] = rays["pixels_unexplained"]
    assert found["tree"] == 0 and found["sorted"] > 1000


def test_without_room_the_ball_is_whole(build, folder):
    """Another picture, but one: the ball where its centre is."""
    scene = folder / "knot_whole.fxls"
    making.build(str(CHECKOUT / "scenes/knot.toml"), str(scene), 6, layers="all")
    with_room = pictures(draw(build, scene, folder / "a.fxld", pieces=ROOM))
    without = pictures(draw(build, scene, folder / "b.fxld", pieces=0))
    again = pictures(draw(build, scene, folder / "c.fxld", pieces=0, rows=9, list=50))
    assert with_room != without and without == again
