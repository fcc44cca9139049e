# SPDX-License-Identifier: MIT
"""Paths: exact at keys, within the keys' range between them."""

import math
import types
from fractions import Fraction

from hypothesis import given, settings, strategies as st

from fixel.model import quantity
from fixel.scene import path
from fixel.scene.path import Key

BUILT_PROGRAMS = ()
TURN = 1 << 32


def key(position, frames=1, yaw=0, pitch=0, roll=0, target=None):
    return Key(tuple(Fraction(c) for c in position), frames, Fraction(yaw), Fraction(pitch),
               Fraction(roll), target)


def test_a_line_is_a_line():
    poses = path.poses([key((0, 0, 0), 4), key((4, 0, 8), 1, yaw=90)], False, "key")
    assert len(poses) == 5
    assert [p[0] for p in poses] == [i << 16 for i in range(5)]
    assert [p[3] for p in poses] == [i << 28 for i in range(5)]


def test_the_last_key_is_held_and_angles_wrap():
    poses = path.poses([key((0, 0, 0), 2, yaw=720), key((1, 0, 0), 3, yaw=-90)], True, "key")
    assert len(poses) == 5 and poses[2] == poses[3] == poses[4]
    assert poses[0][3] == 0 and poses[4][3] == 3 << 30


coordinate = st.fractions(-8191, 8191, max_denominator=512)
angle = st.fractions(-720, 720, max_denominator=64)
keys = st.lists(st.builds(key, st.tuples(coordinate, coordinate, coordinate),
                          st.integers(1, 7), angle, angle, angle), min_size=1, max_size=6)


@settings(max_examples=150, deadline=None)
@given(keys, st.booleans())
def test_exact_at_keys_and_never_beyond_them(made, smooth):
    poses = path.poses(made, smooth, "key")
    assert len(poses) == sum(k.frames for k in made)
    frame = 0
    for i, here in enumerate(made):
        assert poses[frame] == (*(quantity.q16(c) for c in here.position), quantity.angle(here.yaw),
                                quantity.angle(here.pitch), quantity.angle(here.roll))
        after = made[min(i + 1, len(made) - 1)]
        for pose in poses[frame:frame + here.frames]:
            for axis in range(3):
                ends = sorted(quantity.q16(k.position[axis]) for k in (here, after))
                assert ends[0] - 1 <= pose[axis] <= ends[1] + 1
        frame += here.frames


def test_look_at_keeps_the_eye_on_the_point():
    target = (Fraction(0), Fraction(1), Fraction(0))
    made = [key((0, 1, -5), 8, target=target), key((-5, 1, 0), 8, target=target),
            key((0, 1, 5), 1, target=target)]
    for x, y, z, yaw, pitch, _ in path.poses(made, True, "key"):
        wanted, _ = path.aim((x, y, z), (0, 65536, 0), "key")
        off = (yaw - wanted / 360 * TURN) % TURN
        assert min(off, TURN - off) < TURN / 360 * 0.01
        assert min(pitch, TURN - pitch) < TURN / 360 * 0.01


def test_yaw_next_to_look_at_goes_the_short_way():
    made = [key((0, 0, 0), 10, yaw=350), key((0, 0, 0), 1, target=(1, 0, 10))]
    turns = [p[3] * 360 / TURN for p in path.poses(made, True, "key")]
    assert all(t >= 350 or t <= 6 for t in turns)


def test_an_orbit_looks_at_its_centre():
    poses = path.orbit((0, 1, 0), Fraction(3), Fraction(3), 4, Fraction(0), Fraction(1))
    assert poses[0] == (0, 4 << 16, -3 << 16, 0, 7 << 29, 0)
    assert [p[3] for p in poses] == [0, 1 << 30, 2 << 30, 3 << 30]
    assert poses[1][:3] == (-3 << 16, 4 << 16, 0)


def test_a_smooth_path_through_keys_at_equal_steps_on_a_line_is_a_line():
    poses = path.poses([key((1, -2, 8), 4), key((5, -6, 4), 4), key((9, -10, 0))], True, "key")
    assert [p[:3] for p in poses] == [((1 + i) << 16, -(2 + i) << 16, (8 - i) << 16) for i in range(9)]


def test_a_smooth_path_has_the_weighted_harmonic_mean_of_the_slopes_beside_a_key():
    # The slopes are 1/2 for 2 frames and 2 for 1: (4 + 5) / (4 / (1/2) + 5 / 2) = 6/7 at the key between them.
    poses = path.poses([key((0, 0, 0), 2), key((1, 0, 0), 1), key((3, 0, 0))], True, "key")
    cubic = Fraction(1, 2) * 2 / 8 + 2 * Fraction(1, 4) - Fraction(6, 7) * 2 / 8
    assert poses[1][0] == quantity.q16(cubic)
    # Where the direction turns back, the slope is 0.
    poses = path.poses([key((0, 0, 0), 2), key((1, 0, 0), 1), key((0, 0, 0))], True, "key")
    assert poses[1][0] == quantity.q16(Fraction(1, 2) * 2 / 8 + 2 * Fraction(1, 4))


def test_between_two_points_to_look_at_the_point_moves():
    made = [key((0, 2, 0), 4, target=(-10, 2, 10)), key((0, 2, 0), 1, target=(10, 2, 10))]
    for smooth, part in ((False, 0.25), (True, 0.15625)):       # 3 u^2 - 2 u^3
        yaw = math.degrees(math.atan2(-10 + 20 * part, 10))
        assert path.poses(made, smooth, "key")[1][3] == quantity.angle(Fraction(yaw))


def test_an_orbit_about_any_centre():
    poses = path.orbit((1, 2, 3), Fraction(4), Fraction(-4), 4, Fraction(90), Fraction(-1))
    assert [p[:3] for p in poses] == [(x << 16, -2 << 16, z << 16) for x, z in ((-3, 3), (1, -1), (5, 3), (1, 7))]
    assert [p[3:] for p in poses] == [(turn << 30, 1 << 29, 0) for turn in (1, 0, 3, 2)]


def test_beside_a_key_that_looks_at_no_point_the_angles_move():
    made = [key((0, 0, 0), 2, target=(0, 0, 10)), key((0, 0, 0), 2, yaw=40), key((0, 0, 0), target=(10, 0, 0))]
    assert [p[3] for p in path.poses(made, False, "key")] == [quantity.angle(Fraction(yaw)) for yaw in (0, 20, 40, 65, 90)]


def test_a_scene_without_a_path_is_circled_about_the_middle_of_all_that_it_has():
    unit = types.SimpleNamespace(vertices=[(-65536, 0, 0), (65536, 0, 0)])
    placed = [types.SimpleNamespace(centre=(x << 16, 2 << 16, -3 << 16), model=0) for x in (10, 14)]
    scene = types.SimpleNamespace(models=[unit], objects=placed, placements=[], fov=1 << 30, width=160, height=120, far=8 << 16)
    poses, notes = path.about(scene, 4, "s.toml")
    for one, other in ((0, 2), (1, 3)):
        assert [(poses[one][axis] + poses[other][axis]) / 2 ** 17 for axis in (0, 2)] == [12, -3]
    # The ball about both has a radius of 3. Its half angle's tangent is 3/4, of the lower half of the screen, so its sine is
    # 3/5, and a twentieth more is left around.
    assert all(5.249 < math.dist(pose[:3], (12 << 16, 2 << 16, -3 << 16)) / 65536 < 5.27 for pose in poses)
    assert notes[1:] == ["s.toml: the far plane cuts what is seen from there: view.far = 9 would show all"]
