# SPDX-License-Identifier: MIT
"""Every clipper draws every scene as double does, whole and in bands (docs/extras/clippers.md)."""

import json
import math
import pathlib
import re
import struct
import subprocess

import pytest
from clipper_names import clipper_names
from conftest import CHECKOUT, sampled

from fixel.scene import making
from fixel.image import image

CLIPPERS = (*clipper_names(), "near-box")
SCENES = ("tiny", "cube", "plaza", "w1", "w3", "adversarial", "beam")
DISTANCE = 1 / 8192                                 # that explains a pixel (docs/accuracy.md, section 4)
SPOT = CHECKOUT.parent / "shared" / "models" / "spot.obj"
HEAD, BEFORE_PIXELS, AFTER_PIXELS = 784, 32, 48     # of a dump, of a frame


@pytest.fixture(scope="module", name="folder")
def fixture_folder(tmp_path_factory):
    return tmp_path_factory.mktemp("clippers")


@pytest.fixture(scope="module", name="scene")
def fixture_scene(request, folder):
    source, frames = CHECKOUT / "scenes" / f"{request.param}.toml", None
    if request.param == "spot":
        if not SPOT.exists():
            pytest.skip("there is no ../shared/models/spot.obj")
        source, frames = SPOT, 6
    compiled = folder / f"{request.param}.fxls"
    making.build(source, compiled, frames=frames)
    return compiled


def drawn(build, scene, clipper, out, *options):
    """What the program counted; the pixels of each frame."""
    done = subprocess.run([build / "host" / "frames", scene, out, "--clipper", clipper, *options],
                          text=True, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    dump = pathlib.Path(out).read_bytes()
    width, height = struct.unpack_from("<HH", dump, 6)
    size = BEFORE_PIXELS + width * height + AFTER_PIXELS
    starts = range(HEAD + BEFORE_PIXELS, len(dump) - size + BEFORE_PIXELS, size)
    return json.loads(done.stdout), [dump[start:start + width * height] for start in starts]


def bound(scene, clipper):
    """Pixels: the world's clipper is off by two units of the world where near is (docs/extras/clippers.md, section 5)."""
    if clipper != "world":
        return DISTANCE
    opened = image.load(scene)
    return max(DISTANCE, opened.width / math.tan(opened.fov / 2**32 * math.pi) / opened.near)


@pytest.mark.parametrize("scene, clipper", sampled("clippers", [(name, clipper) for name in (*SCENES, "spot") for clipper in CLIPPERS], 30),
                         indirect=["scene"])
def test_double_explains_every_pixel(build, scene, clipper, tmp_path):
    """accuracy 4.2."""
    counted, whole = drawn(build, scene, clipper, tmp_path / "whole.fxld")
    assert counted["drawn"] > 0 and counted["refused"] == 0
    verdict = tmp_path / "verdict.json"
    subprocess.run([build / "host" / "judge", scene, tmp_path / "whole.fxld", "--clipper", clipper, "--json",
                    verdict, "--distance", str(bound(scene, clipper))], check=True, capture_output=True)
    found = json.loads(verdict.read_text(encoding="utf-8"))
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
        verdict = tmp_path / "inset.json"
        subprocess.run([build / "host" / "judge", compiled, tmp_path / "inset.fxld", "--clipper", clipper, "--json",
                        verdict], check=True, capture_output=True)
        unexplained[inset] = json.loads(verdict.read_text(encoding="utf-8"))["pixels_unexplained"]
    assert unexplained["0"] == 0
    assert unexplained["1/2"] > 1000


def test_wrong_usage_is_said(build, tmp_path):
    done = subprocess.run([build / "host" / "frames", "none.fxls", tmp_path / "out", "--clipper", "best"],
                          text=True, capture_output=True, check=False)
    assert done.returncode == 2
    assert "usage" in done.stderr
