# SPDX-License-Identifier: MIT
"""Faces that lie in the near or the far plane to within the rounding of the camera's matrix (docs/accuracy.md, section 4.3)."""

import json
import subprocess

import pytest

from clipper_names import clipper_names
from fixel.scene import making

UNIT = 65536
NEAR, FAR, INSET = UNIT, 50 * UNIT, 4               # units of 1/65536
HALF_WALL = UNIT // 2
TURNS = (1, 2, 3, 7, 20, 100, 1000, 10000)          # units of 2^-32 turn
SCENE = """
screen = {{ width = 160, height = 120 }}
view = {{ fov = 90, near = "{near}/65536", far = "{far}/65536", inset = "{inset}/65536" }}
[[objects]]
solid = "box"
scale = [300, 300, 1]
position = [0, 0, "{middle}/65536"]
[path]
interpolation = "linear"
keys = [
{keys}
]
"""


def wall(folder, plane, inward=0):
    """A wall that fills the screen, its front in the near or the far plane or so many units within, seen by a
    camera that is turned a little from square."""
    front = NEAR + INSET + inward if plane == "near" else FAR - INSET - inward
    keys = "\n".join(f'{{ position = [0, 0, 0], yaw = "{yaw}/4294967296 turn", pitch = "{3 * yaw}/4294967296 turn", '
                     f'roll = "{5 * yaw}/4294967296 turn" }},' for yaw in TURNS)
    source = folder / f"{plane}{inward}.toml"
    source.write_text(SCENE.format(near=NEAR, far=FAR, inset=INSET, middle=front + HALF_WALL, keys=keys),
                      encoding="utf-8")
    compiled = source.with_suffix(".fxls")
    making.build(source, compiled)
    return compiled


def drawn(build, scene, clipper):
    dump = scene.with_suffix(f".{clipper}.fxld")
    subprocess.run([build / "host" / "frames", scene, dump, "--clipper", clipper], check=True, capture_output=True)
    return dump


def judged(build, scene, dump, clipper):
    verdict = dump.with_suffix(".json")
    subprocess.run([build / "host" / "judge", scene, dump, "--clipper", clipper, "--json", verdict], check=True,
                   capture_output=True)
    return json.loads(verdict.read_text(encoding="utf-8"))


@pytest.mark.parametrize("clipper", clipper_names(but=("triangles", "left")))
@pytest.mark.parametrize("plane", ["near", "far"])
def test_what_the_rounding_of_depths_decides_is_explained(build, tmp_path, plane, clipper):
    """accuracy 4.3."""
    scene = wall(tmp_path, plane)
    found = judged(build, scene, drawn(build, scene, clipper), clipper)
    assert found["pixels_near_far"] > 500
    assert found["pixels_unexplained"] == 0


@pytest.mark.parametrize("plane", ["near", "far"])
def test_a_wall_on_the_wrong_side_by_one_unit_is_not_explained(build, tmp_path, plane):
    """One unit of 1/65536 is more than 20 times the bound for this wall. Frames turned further tilt it by more than the unit. accuracy 4.3."""
    inside, outside = wall(tmp_path, plane, 1), wall(tmp_path, plane, -1)
    for board, truth in ((inside, outside), (outside, inside)):
        dump = drawn(build, board, "view")
        assert judged(build, board, dump, "view")["pixels_unexplained"] == 0
        frames = judged(build, truth, dump, "view")["frames"]
        for frame in frames[:TURNS.index(20) + 1]:
            assert (frame["pixels_unexplained"], frame["pixels_near_far"]) == (160 * 120, 0)
