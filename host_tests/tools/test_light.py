# SPDX-License-Identifier: MIT
"""Frames in light and fog, against the reference renderer in double (docs/extras/light.md)."""

import json
import subprocess

import pytest
from conftest import run_cli

LIGHTS = ("day", "lamps", "dusk")


def drawn(build, image, out, *options):
    done = subprocess.run([build / "host" / "frames", image, out, "--frames", "40", *options], text=True,
                          capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    return out


@pytest.mark.parametrize("scene, tree", [("plaza", "none"), ("beam", "none"), ("w3", "none"), ("knot", "all")])
@pytest.mark.parametrize("light", LIGHTS)
def test_lit_frames_are_those_of_the_reference(scene, tree, light, build, tmp_path):
    image = tmp_path / "scene.fxls"
    made = run_cli("scene", "build", f"scenes/{scene}.toml", "-o", image, *(["--tree", "all"] if tree == "all" else []))
    assert made.returncode == 0, made.stderr
    methods = ["--hidden", "tree"] if tree == "all" else []
    lit = drawn(build, image, tmp_path / "lit.fxld", "--light", light, *methods)
    plain = drawn(build, image, tmp_path / "plain.fxld", *methods)
    assert lit.read_bytes() != plain.read_bytes()
    found = {}
    for name, options in (("lit", ["--light", light]), ("unlit", [])):
        out = tmp_path / f"{name}.json"
        done = subprocess.run([build / "host" / "judge", image, lit, "--json", out, "--distance", "0.0001220703125",
                               *methods, *options], text=True, capture_output=True, check=False)
        assert done.returncode == 0, done.stderr
        found[name] = json.loads(out.read_text())
    assert found["lit"]["pixels_unexplained"] == 0
    assert found["unlit"]["pixels_unexplained"] > 1000  # the judge would see a light that is not there


@pytest.mark.parametrize("options", [["--rows", "7", "--list", "0"], ["--hidden", "spans"], ["--rows", "3", "--list", "600"]])
def test_lit_frames_do_not_depend_on_bands_and_methods(options, build, tmp_path):
    image = tmp_path / "scene.fxls"
    assert run_cli("scene", "build", "scenes/plaza.toml", "-o", image).returncode == 0
    whole = drawn(build, image, tmp_path / "whole.fxld", "--light", "dusk")
    other = drawn(build, image, tmp_path / "other.fxld", "--light", "dusk", *options)
    assert _pixels(whole) == _pixels(other)


def _pixels(dumped):
    from fixel import dump
    return [frame.pixels for frame in dump.read_dump(dumped).frames]
