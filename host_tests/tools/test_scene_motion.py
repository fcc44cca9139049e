# SPDX-License-Identifier: MIT
"""Scene files whose objects turn and move: what becomes of each key, and each refusal."""

import math
from pathlib import Path

import pytest

from conftest import CHECKOUT
from fixel.base.errors import ToolError
from fixel.image import image, image_placement
from fixel.scene import compiler, toml_scene
from model_files import build
# place field: images that are broken, for the tools
from scene_sections import section

BUILT_PROGRAMS = ()
BOX = '[[objects]]\nsolid = "box"\nposition = [0, 0, 5]\n'
NAMED = BOX + 'name = "base"\nsize = 2\n'
ONE, QUARTER = 65536, 1 << 30


def refused(tmp_path, text, *parts):
    with pytest.raises(ToolError) as caught:
        build(tmp_path, text)
    for part in parts:
        assert part in str(caught.value)


def test_a_scene_without_such_keys_keeps_its_version(tmp_path):
    assert section(image.pack(build(tmp_path, BOX)), "placements") == (0, 0)
    assert section(image.pack(build(tmp_path, BOX + "size = 2\n")), "placements")[1] == 1


def test_what_turns_comes_last_and_what_moves_comes_after_it(tmp_path):
    scene = build(tmp_path, BOX + "spin = { yaw = 5 }\nlayer = 1\n" + BOX + "turn = 90\nlayer = 2\n" + BOX + "layer = 3\n")
    assert [item.layer for item in scene.objects] == [3, 2, 1]
    assert (len(scene.placements), len(scene.motions)) == (2, 1)
    assert scene.placements[0].rows == (0, 0, QUARTER, 0, QUARTER, 0, -QUARTER, 0, 0)
    assert {item.model for item in scene.objects} == {0}


def test_copies_on_a_turned_ring_share_a_model(tmp_path):
    ring = "ring = { count = 4, radius = 3, turned = true }\n"
    scene = build(tmp_path, BOX + ring)
    assert len(scene.models) == 1 and len(scene.placements) == 4 and not scene.motions
    assert [placement.rows[2] for placement in scene.placements] == [0, QUARTER, 0, -QUARTER]
    assert scene.objects[1].centre == (3 * ONE, 0, 5 * ONE)
    baked = build(tmp_path, BOX + "scale = [1, 2, 3]\n" + ring.replace(", turned = true", ""))
    assert not baked.placements and len(baked.models) > 1


def test_a_spin_about_an_axis_and_one_of_angles(tmp_path):
    about = build(tmp_path, BOX + 'spin = { axis = [0, 2, 0], degrees = "1/8 turn", start = 90 }\n').motions[0]
    assert (about.axis, about.spin, about.steps) == ((0, 8191 * ONE, 0), (QUARTER, QUARTER // 2), (0, 0, 0))
    angles = build(tmp_path, BOX + "turn = [0, 45, 0]\nspin = { yaw = 90, roll = -45 }\n").motions[0]
    assert angles.steps == (QUARTER, 0, (1 << 32) - QUARTER // 2)
    assert angles.keys[0].angles == (0, QUARTER // 2, 0) and angles.axis == (0, 0, 0)


def test_a_circle_may_face_along_its_way(tmp_path):
    motion = build(tmp_path, BOX + "motion = { circle = 2, degrees = 45, start = 90, facing = true }\n").motions[0]
    assert (motion.radius, motion.circle) == (2 * ONE, (QUARTER, QUARTER // 2))
    assert motion.keys[0].angles[0] == 2 * QUARTER and motion.steps[0] == QUARTER // 2
    back = build(tmp_path, BOX + "motion = { circle = 2, degrees = -45, facing = true }\n").motions[0]
    assert back.keys[0].angles[0] == 3 * QUARTER
    for words in ("", ", facing = false"):
        still = build(tmp_path, BOX + f"motion = {{ circle = 2, degrees = 45, start = 90{words} }}\n").motions[0]
        assert still.keys[0].angles == still.steps == (0, 0, 0) and still.circle == (QUARTER, QUARTER // 2)


def test_a_way_goes_to_and_fro(tmp_path):
    motion = build(tmp_path, BOX + "motion = { by = [1, 0, -2], frames = 10, back = true }\n").motions[0]
    assert [(key.frame, key.centre) for key in motion.keys] == [
        (0, (0, 0, 5 * ONE)), (10, (ONE, 0, 3 * ONE)), (20, (0, 0, 5 * ONE))]
    assert motion.repeats == 1
    once = build(tmp_path, BOX + "motion = { by = [1, 0, 0], frames = 10, repeats = false }\n").motions[0]
    assert (len(once.keys), once.repeats) == (2, 0)


def test_key_frames_go_through_the_angles_as_written(tmp_path):
    motion = build(tmp_path, BOX + "turn = 10\nsize = 2\nmotion = { keys = [{ frames = 30 }, "
                   "{ turn = 720, size = 0.5, offset = [0, 1, 0], frames = 6 }] }\n").motions[0]
    frames = [key.frame for key in motion.keys]
    assert frames[0] == 0 and 30 in frames and frames[-1] == 36 and len(frames) > 8
    for a, b in zip(motion.keys, motion.keys[1:]):
        step = (b.angles[0] - a.angles[0] + 2 * QUARTER) % (4 * QUARTER) - 2 * QUARTER
        assert step > 0 if b.frame <= 30 else step < 0
    at = motion.keys[frames.index(30)]
    assert (at.scale, at.centre[1]) == (ONE, ONE)
    assert motion.keys[-1].centre == motion.keys[0].centre and motion.scales == (ONE, 2 * ONE)


def test_a_child_is_placed_in_its_parent(tmp_path):
    child = '[[objects]]\nsolid = "box"\nscale = 0.5\nposition = [1, 0, 3]\nparent = "base"\n'
    scene = build(tmp_path, NAMED + "turn = 90\n" + child)
    assert [motion.parent for motion in scene.motions] == [0, 1]
    # The parent's right side is -z, what is before it is +x; its size is 2.
    assert scene.objects[1].centre == (6 * ONE, 0, 3 * ONE)
    assert scene.placements[1].scale == 2 * ONE and scene.placements[1].rows == scene.placements[0].rows


def test_a_base_rises_with_the_size(tmp_path):
    scene = build(tmp_path, BOX + 'anchor = "base"\nsize = 3\n')
    assert scene.objects[0].centre == (0, 3 * ONE // 2, 5 * ONE)


@pytest.mark.parametrize("text, parts", [
    ("size = 200\nmotion = { keys = [{ frames = 5 }, { size = 2 }] }\n", ["size = 400", "256"]),
    ("spin = {}\n", ["spin", "axis"]),
    ("spin = { axis = [0, 0, 0], degrees = 1 }\n", ["spin", "no axis"]),
    ("spin = { axis = [0, 1, 0] }\n", ['"degrees" is missing']),
    ("spin = { axis = [0, 1, 0], yaw = 1 }\n", ["axis and degrees"]),
    ("spin = { yaw = 1, start = 1 }\n", ["start", "belongs to an axis"]),
    ("motion = {}\n", ["none is given"]),
    ("motion = { circle = 1, by = [0, 0, 1] }\n", ["both"]),
    ("motion = { circle = 1, degrees = 1, frames = 4 }\n", ["frames", "does not belong to circle"]),
    ("motion = { keys = [{ offset = [0, 0, 20000] }] }\n", ["offset"]),
    ('parent = "nobody"\n', ["parent", "nobody"]),
    ("motion = { circle = 8188, degrees = 1, start = 180 }\n", ["range", "motion 0"]),
    ("colour = 'red'\nturns = 4\n", ['unknown key "turns"', '"turn"']),
])
def test_what_is_wrong_is_named(tmp_path, text, parts):
    refused(tmp_path, BOX + text, *parts)


def test_a_parent_is_one_object_before(tmp_path):
    child = BOX + 'parent = "base"\n'
    refused(tmp_path, child + NAMED, "no object before this one")
    refused(tmp_path, NAMED + NAMED + child, "2 objects have the name")
    refused(tmp_path, BOX + 'name = "base"\n' + child, "no object before this one")


def test_a_chain_has_at_most_eight_parents(tmp_path):
    chain = "".join(f'[[objects]]\nsolid = "box"\nname = "n{i}"\nsize = 1\n' + (f'parent = "n{i - 1}"\n' if i else "")
                    for i in range(10))
    longest = build(tmp_path, chain[:chain.rindex("[[")])
    assert image.unpack(image.pack(longest)).motions[-1].parent == len(longest.motions) - 1 == 8
    refused(tmp_path, chain, "more than 8 parents")


def test_as_many_keys_as_an_image_may_have(tmp_path, monkeypatch):
    text = BOX + "motion = { keys = [{ frames = 9 }, { offset = [1, 0, 0], frames = 9 }, { offset = [2, 0, 0] }] }\n"
    text += BOX + "spin = { yaw = 5 }\n" + BOX + "turn = 10\nmotion = { keys = [{ frames = 60 }, { turn = 720 }] }\n"
    keys = sum(len(motion.keys) for motion in build(tmp_path, text).motions)
    monkeypatch.setattr(image_placement, "KEYS_MAX", keys)
    build(tmp_path, text)
    monkeypatch.setattr(image_placement, "KEYS_MAX", keys - 1)
    refused(tmp_path, text, f"more than {keys - 1} keys together")


def test_a_tree_leaves_what_turns_alone():
    scene, _ = compiler.compile_scene(str(CHECKOUT / "host_tests" / "fuzz" / "scenes" / "placements.toml"), layers="0")
    assert scene.tree.object == len(scene.objects) - len(scene.placements) - 1
    assert image.unpack(image.pack(scene)) == scene


@pytest.mark.parametrize("name, turned, moving", [("spin", 64, 49), ("plaza-turned", 64, 0)])
def test_own_scenes_have_what_they_promise(name, turned, moving):
    scene, _ = toml_scene.compile_file(str(CHECKOUT / "scenes" / f"{name}.toml"))
    assert (len(scene.placements), len(scene.motions)) == (turned, moving)


def test_placements_of_frame_0_are_rotations():
    """Entries are rounded once: a row is within 0.87 unit of unit length."""
    scene, _ = toml_scene.compile_file(str(Path(CHECKOUT) / "scenes" / "spin.toml"))
    for placement in scene.placements:
        for i in (0, 3, 6):
            assert abs(math.sqrt(sum(c * c for c in placement.rows[i:i + 3])) - QUARTER) < 0.9


def test_a_scale_that_grows_along_a_chain_is_refused(tmp_path):
    refused(tmp_path, NAMED.replace("size = 2", "size = 200") + BOX + 'parent = "base"\nsize = 2\nposition = [0, 0, 0]\n'
            .replace("position = [0, 0, 0]\n", ""), "range")
    assert image_placement.SCALE_MAX == 256 * ONE
