# SPDX-License-Identifier: MIT
"""Frames in light and fog, against the reference renderer in double (docs/extras/light.md)."""

import host_frames
import pytest
from host_frames import pixels

BUILT_PROGRAMS = ("host/frames", "host/judge")
LIGHTS = ("day", "lamps", "dusk")
EXPLAINED = 1 / 8192  # pixels from an edge: that of make run


def built(scene, folder, *options):
    return host_frames.compiled(f"scenes/{scene}.toml", folder / f"{scene}.fxls", *options)


def drawn(build, image, name, *options, frames=30):
    return host_frames.drawn(build, image, name, "--frames", frames, *options)


def judged(build, image, dumped, *options):
    return host_frames.judged(build, image, dumped, "--distance", EXPLAINED, *options)


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
