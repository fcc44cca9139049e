# SPDX-License-Identifier: MIT
"""Every clipper draws every scene as double does, whole and in bands (docs/extras/clippers.md); also what an inset takes from
the border of the picture, and faces in the near or far plane (docs/accuracy.md, section 4)."""

import json
import math
import re
import subprocess

import host_frames
import pytest
from conftest import CHECKOUT, clipper_names, sampled
from host_frames import judged, pixels

from fixel.scene import making
from fixel.image import image, image_header

BUILT_PROGRAMS = ("host/frames", "host/judge")
CLIPPERS = (*clipper_names(), "near-box")
SCENES = ("tiny", "cube", "plaza", "w1", "w3", "adversarial", "beam")
DISTANCE = 1 / 8192                                 # that explains a pixel (docs/accuracy.md, section 4)
SPOT = CHECKOUT.parent / "shared" / "models" / "spot.obj"


@pytest.fixture(scope="module", name="folder")
def fixture_folder(tmp_path_factory):
    return tmp_path_factory.mktemp("clippers")


@pytest.fixture(scope="module", name="scene")
def fixture_scene(request, folder):
    source, frames = CHECKOUT / "scenes" / f"{request.param}.toml", None
    if request.param == "spot":
        if not SPOT.exists():
            pytest.skip("needs ../shared/models/spot.obj")
        source, frames = SPOT, 6
    compiled = folder / f"{request.param}.fxls"
    making.build(source, compiled, frames=frames)
    return compiled


def drawn(build, scene, clipper, out, *options):
    """What the program counted; the pixels of each frame."""
    counted = host_frames.run(build / "host" / "frames", scene, out, "--clipper", clipper, *options)
    return json.loads(counted), pixels(out)


def bound(scene, clipper):
    """Pixels: the world's clipper is off by two units of the world where near is (docs/extras/clippers.md, section 5)."""
    if clipper != "world":
        return DISTANCE
    opened = image.load(scene)
    return max(DISTANCE, opened.width / math.tan(opened.fov / 2**32 * math.pi) / opened.near)


@pytest.mark.parametrize("scene, clipper", sampled("clippers", [(name, clipper) for name in (*SCENES, "spot") for clipper in CLIPPERS], 30),
                         indirect=["scene"])
def test_double_explains_every_pixel(build, scene, clipper, tmp_path):
    """accuracy 4.2b, 4.2d-f."""
    counted, whole = drawn(build, scene, clipper, tmp_path / "whole.fxld")
    assert counted["drawn"] > 0 and counted["refused"] == 0
    found = judged(build, scene, tmp_path / "whole.fxld", "--clipper", clipper, "--distance", bound(scene, clipper))
    assert found["pixels_unexplained"] == 0
    assert found["pixels_differing"] * 100_000 <= found["pixels"]
    _, bands = drawn(build, scene, clipper, tmp_path / "bands.fxld", "--rows", "7", "--list", "700", "--cache", "5")
    assert len(whole) == counted["frames"] and bands == whole


@pytest.mark.parametrize("clipper", ["view", "near"])
def test_what_an_inset_hides_is_not_explained(build, folder, tmp_path, clipper):
    """Planes that lie far inside of the screen leave a border; of a clipper that leaves the sides to the scan, faces
    that lie in it."""
    text = (CHECKOUT / "scenes" / "tiny.toml").read_text(encoding="utf-8")
    unexplained = {}
    for inset in ("0", "1/2"):
        source = folder / "inset.toml"
        source.write_text(re.sub(r'inset = "[^"]*"', f'inset = "{inset}"', text), encoding="utf-8")
        compiled = folder / "inset.fxls"
        making.build(source, compiled)
        drawn(build, compiled, clipper, tmp_path / "inset.fxld")
        unexplained[inset] = judged(build, compiled, tmp_path / "inset.fxld", "--clipper", clipper)["pixels_unexplained"]
    assert unexplained["0"] == 0
    assert unexplained["1/2"] > 1000


def test_wrong_usage_is_said(build, tmp_path):
    done = subprocess.run([build / "host" / "frames", "none.fxls", tmp_path / "out", "--clipper", "best"],
                          text=True, capture_output=True, check=False)
    assert done.returncode == 2
    assert "usage" in done.stderr


# --- what an inset takes from the picture is told (docs/accuracy.md, section 4.1) ------------------------

FRAMES = 3
ROOM = """
screen = { width = 320, height = 240 }
view = { fov = 75, near = "1/256", far = 100, INSET }
background = "#102030"
[[objects]]
solid = "box"
inside = true
scale = ["1/50", "1/50", "1/50"]
colours = ["#806040", "#608040", "#406080", "#804060", "#604080", "#408060"]
[path]
keys = [{ position = [0, 0, 0], yaw = 0, frames = FRAMES }, { position = [0, 0, 0], yaw = 60, pitch = 10 }]
"""


def border_of(build, folder, inset, clipper="view", near="1/256"):
    """A room so small that its walls are where near is, drawn with such an inset: (frames' pixels of background,
    the judge's verdict)."""
    source = folder / "room.toml"
    source.write_text(ROOM.replace(", INSET", inset).replace("1/256", near).replace("FRAMES", str(FRAMES)), encoding="utf-8")
    compiled, options = source.with_suffix(".fxls"), ("--clipper", clipper)
    making.build(source, compiled)
    dumped = host_frames.drawn(build, compiled, "room", *options)
    return [each.count(0) for each in pixels(dumped)], judged(build, compiled, dumped, *options)


@pytest.mark.parametrize("clipper", ["view", "world", "once"])
def test_a_border_of_background_is_told(build, tmp_path, clipper):
    """accuracy 4.1c, 4.1f."""
    background, verdict = border_of(build, tmp_path, ', inset = "4/65536"', clipper)
    assert min(background) > 1000
    for empty, frame in zip(background, verdict["frames"]):
        assert frame["pixels_unexplained"] > 0.9 * empty


@pytest.mark.parametrize("clipper", clipper_names(but=("world", "left")))
def test_the_default_leaves_no_border(build, tmp_path, clipper):
    background, verdict = border_of(build, tmp_path, "", clipper)
    assert background == [0] * (FRAMES + 1)     # with the last key's own
    assert verdict["pixels_unexplained"] == 0


@pytest.mark.parametrize("near, inset", [("1/256", 1), ("1/128", 1), ("1/110", 1), ("1/128", 2), ("1/256", 0)])
def test_a_run_says_beforehand_that_the_inset_hides_pixels(build, tmp_path, near, inset):
    """Where a half pixel of border is hidden at the near plane, where the room's walls are, there are unexplained ones."""
    told = border_of(build, tmp_path, f', inset = "{inset}/65536"', near=near)[1]["pixels_unexplained"]
    scene = image.load(tmp_path / "room.fxls")
    note = image_header.note_of_inset(scene)
    assert (note is not None) == (told > 0) == (image_header.hidden_border(scene) > 0.5)
    assert note is None or f"{image_header.hidden_border(scene):.2f} pixel" in note and "view.inset" in note


# --- faces in the near or the far plane, to within the rounding of the camera's matrix (section 4.3) ----------

UNIT = 65536
NEAR, FAR, INSET = UNIT, 50 * UNIT, 4               # units of 1/65536
HALF_WALL = UNIT // 2
TURNS = (1, 2, 3, 7, 20, 100, 1000, 10000)          # units of 2^-32 turn
WALL = """
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
    source.write_text(WALL.format(near=NEAR, far=FAR, inset=INSET, middle=front + HALF_WALL, keys=keys),
                      encoding="utf-8")
    compiled = source.with_suffix(".fxls")
    making.build(source, compiled)
    return compiled


def walls(build, scene, clipper):
    """The dump of a wall's frames."""
    return host_frames.drawn(build, scene, f"{scene.stem}.{clipper}", "--clipper", clipper)


@pytest.mark.parametrize("clipper", clipper_names(but=("triangles", "left")))
@pytest.mark.parametrize("plane", ["near", "far"])
def test_what_the_rounding_of_depths_decides_is_explained(build, tmp_path, plane, clipper):
    """accuracy 1.1p, 4.3h-k."""
    scene = wall(tmp_path, plane)
    found = judged(build, scene, walls(build, scene, clipper), "--clipper", clipper)
    assert found["pixels_near_far"] > 500
    assert found["pixels_unexplained"] == 0


@pytest.mark.parametrize("plane", ["near", "far"])
def test_a_wall_on_the_wrong_side_by_one_unit_is_not_explained(build, tmp_path, plane):
    """One unit of 1/65536 is more than 20 times the bound for this wall. Frames turned further tilt it by more than the unit. accuracy 1.1p, 4.3c, 4.3f-g."""
    inside, outside = wall(tmp_path, plane, 1), wall(tmp_path, plane, -1)
    for board, truth in ((inside, outside), (outside, inside)):
        dumped = walls(build, board, "view")
        assert judged(build, board, dumped)["pixels_unexplained"] == 0
        frames = judged(build, truth, dumped)["frames"]
        for frame in frames[:TURNS.index(20) + 1]:
            assert (frame["pixels_unexplained"], frame["pixels_near_far"]) == (160 * 120, 0)
