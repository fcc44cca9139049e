# SPDX-License-Identifier: MIT
"""Frames in light and fog, against the reference renderer in double (docs/extras/light.md)."""

import json
import subprocess

import pytest
from conftest import run_cli

from fixel.board import dump

LIGHTS = ("day", "lamps", "dusk")
EXPLAINED = 1 / 8192  # pixels from an edge: that of make run


def built(scene, folder, *options):
    image = folder / f"{scene}.fxls"
    made = run_cli("build", f"scenes/{scene}.toml", "-o", image, *options)
    assert made.returncode == 0, made.stderr
    return image


def drawn(build, image, name, *options, frames=30):
    out = image.with_name(f"{name}.fxld")
    done = subprocess.run([build / "host" / "frames", image, out, "--frames", str(frames), *options], text=True,
                          capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    return out


def judged(build, image, dumped, *options):
    out = dumped.with_suffix(".json")
    done = subprocess.run([build / "host" / "judge", image, dumped, "--json", out, "--distance", str(EXPLAINED), *options],
                          text=True, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(out.read_text())


def pixels(dumped):
    return [bytes(frame.pixels) for frame in dump.read_dump(dumped).frames]


@pytest.mark.parametrize("scene, tree", [("plaza", []), ("beam", []), ("w3", []), ("knot", ["--tree", "all"])])
@pytest.mark.parametrize("light", LIGHTS)
def test_lit_frames_are_those_of_the_reference(scene, tree, light, build, tmp_path):
    image = built(scene, tmp_path, *tree)
    methods = ["--hidden", "tree"] if tree else []
    lit = drawn(build, image, "lit", "--light", light, *methods)
    assert pixels(lit) != pixels(drawn(build, image, "plain", *methods))
    assert judged(build, image, lit, "--light", light, *methods)["pixels_unexplained"] == 0


def test_the_judge_sees_a_light_that_is_not_there(build, tmp_path):
    image = built("tiny", tmp_path)
    lit = drawn(build, image, "lit", "--light", "lamps", frames=1)
    assert judged(build, image, lit)["pixels_unexplained"] > 1000


@pytest.mark.parametrize("options", [["--rows", "7", "--list", "0"], ["--hidden", "spans"],
                                     ["--rows", "3", "--list", "600"], ["--clipper", "world", "--rows", "5"]])
def test_lit_frames_do_not_depend_on_bands_and_methods(options, build, tmp_path):
    image = built("w3", tmp_path)
    clipper = options[:2] if "--clipper" in options else []
    assert pixels(drawn(build, image, "whole", "--light", "dusk", *clipper)) == \
        pixels(drawn(build, image, "other", "--light", "dusk", *options))


def test_the_light_of_an_image_is_that_of_the_reference(build, tmp_path):
    """Nobody names a light: the image has it."""
    image = built("lit", tmp_path)
    lit = drawn(build, image, "lit")
    assert judged(build, image, lit)["pixels_unexplained"] == 0
    dusk = drawn(build, image, "dusk", "--light", "dusk", frames=1)     # the judge takes its time where all is wrong
    assert pixels(dusk) != pixels(lit)[:1] and judged(build, image, dusk)["pixels_unexplained"] > 1000
