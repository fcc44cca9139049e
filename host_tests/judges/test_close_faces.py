# SPDX-License-Identifier: MIT
"""Faces that a depth buffer cannot tell apart."""

import pytest
from conftest import CHECKOUT

from fixel.scene import making
from fixel.image import image
from fixel.model import close_faces

BUILT_PROGRAMS = ()
UNIT = close_faces.UNIT


def wall(z, width=4, front=-1):
    """A square across the view at a distance, in front of which the eye is."""
    corners = [(-width * UNIT, -UNIT, z), (-width * UNIT, UNIT, z), (width * UNIT, UNIT, z), (width * UNIT, -UNIT, z)]
    return image.Model(corners, [image.Face((0, 0, front << 30), (0, 1, 2, 3) if front < 0 else (3, 2, 1, 0), 1)])


def scene_of(*models, centres=None):
    centres = centres or [(0, 0, 0)] * len(models)
    return image.SceneImage(width=64, height=48, fov=1 << 30, near=UNIT, far=200 * UNIT, inset=0, background=0, palette=[],
                            models=list(models), objects=[image.Object(centre, number) for number, centre in enumerate(centres)],
                            path_kind=0, path=[])


@pytest.mark.parametrize("near, far, bits, share", [
    (49152, 14952505, 16, 33 / 32 / 4096), (49152, 14952505, 32, 1 / 4096 / 32), (4096, 64 * UNIT, 16, 33 / 32 / 4096),
    (UNIT, 2 * UNIT, 16, 33 / 32 / 16384), (UNIT, 100 * UNIT, 16, 33 / 32 / 8192), (256, 32767 * UNIT, 16, 33 / 32 / 2048)])
def test_the_resolution_is_that_of_the_specification(near, far, bits, share):
    assert close_faces.resolution(near, far, bits) == share


def test_a_decal_is_found_where_it_is_too_close():
    limit = close_faces.resolution(UNIT, 200 * UNIT) * 200
    near, apart = int(limit * UNIT / 2), int(limit * UNIT * 2)
    found = close_faces.find(scene_of(wall(10 * UNIT), wall(10 * UNIT - near, width=1)))
    assert [(pair.one, pair.other) for pair in found] == [((0, 0), (1, 0))] or \
        [(pair.other, pair.one) for pair in found] == [((0, 0), (1, 0))]
    assert found[0].gap == pytest.approx(near / UNIT)
    assert close_faces.find(scene_of(wall(10 * UNIT), wall(10 * UNIT - apart))) == []
    assert "either may be seen" in close_faces.note(scene_of(wall(10 * UNIT), wall(10 * UNIT - near)))


def test_what_does_not_overlap_or_shows_its_back_is_left_alone():
    beside = scene_of(wall(10 * UNIT, 1), wall(10 * UNIT, 1), centres=[(0, 0, 0), (2 * UNIT, 0, 0)])
    assert close_faces.find(beside) == []
    assert close_faces.find(scene_of(wall(10 * UNIT), wall(10 * UNIT + 9, front=1))) == []
    assert close_faces.note(beside) is None


def test_a_scene_of_the_project(tmp_path):
    file = tmp_path / "w1.fxls"
    making.build(str(CHECKOUT / "scenes/w1.toml"), str(file), 1)
    assert close_faces.note(image.load(file)) is None
