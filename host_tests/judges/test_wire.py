# SPDX-License-Identifier: MIT
"""Wireframes of whole paths: both line clippers, bands, and the reference renderer (docs/extras/wire.md)."""

import json
import pathlib

from conftest import run_make
from PIL import Image
import pytest

BUILT_PROGRAMS = ()


@pytest.mark.parametrize("scene, least", [("tiny", 500), ("w1", 10_000), ("adversarial", 4_000), ("window", 2_000)])
def test_wireframes_are_the_twins(scene, least, tmp_path):
    out = tmp_path / "wire"
    done = run_make("wire", f"SCENE=scenes/{scene}.toml", f"OUT={out}")
    assert done.returncode == 0, done.stdout + done.stderr
    summary = json.loads((out / "summary.json").read_text())
    assert summary["lines"] > least
    assert summary["clipped"] > 100
    assert summary["pixels_disagreeing"] == 0
    assert summary["pixels_unexplained"] == 0
    assert summary["pixels_differing"] <= summary["pixels_drawn"] / 5_000
    assert summary["intersections_by_codes"] < summary["intersections_by_planes"]
    assert Image.open(out / "frame_0000.png").getcolors()
    assert "pass" in done.stdout


@pytest.mark.parametrize("view", ["scale = 9", "scale = 9\ncentre = [40, 200]"])
def test_wireframes_by_an_orthographic_lens_are_the_twins(view, tmp_path):
    """orthographic 2.13."""
    text = (pathlib.Path(__file__).parents[2] / "scenes/spin.toml").read_text(encoding="utf-8")
    assert "fov = 70\n" in text
    (tmp_path / "flat.toml").write_text(text.replace("fov = 70\n", f"{view}\n", 1), encoding="utf-8")
    out = tmp_path / "wire"
    done = run_make("wire", f"SCENE={tmp_path / 'flat.toml'}", f"OUT={out}", "FRAMES=12")
    assert done.returncode == 0, done.stdout + done.stderr
    summary = json.loads((out / "summary.json").read_text())
    assert summary["lines"] > 1_000 and summary["clipped"] > 100
    assert summary["pixels_disagreeing"] == summary["pixels_unexplained"] == 0


def test_what_moves_moves(tmp_path):
    """The eye stands still; the reference renderer has each frame's own placements."""
    scene = tmp_path / "turning.toml"
    scene.write_text('[[objects]]\nsolid = "box"\nposition = [0, 0, 5]\nspin = { axis = [1, 2, 0], degrees = 7 }\n'
                     '[path]\nkeys = [{ position = [0, 0, 0], frames = 6 }, { position = [0, 0, 0] }]\n', encoding="utf-8")
    out = tmp_path / "wire"
    done = run_make("wire", f"SCENE={scene}", f"OUT={out}")
    assert done.returncode == 0, done.stdout + done.stderr
    assert json.loads((out / "summary.json").read_text())["pixels_unexplained"] == 0
    pictures = [Image.open(file).tobytes() for file in sorted(out.glob("frame_*.png"))]
    assert len(set(pictures)) == len(pictures) > 5
