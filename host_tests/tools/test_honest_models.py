# SPDX-License-Identifier: MIT
"""Large models as people have them compile within the default limits, and no count refuses one. On a machine of 2026 each
takes less than 10 s of CPU time; make test takes a sample of them."""

import pytest

import honest_models
from conftest import run_cli, sampled
from fixel.base.errors import ToolError
from fixel.image import image
from fixel.model import solids
from fixel.model.mesh import FACES_MAX, shape
from fixel.model.quantity import matrix
from fixel.scene import parts

SPHERES = [(suffix, count) for suffix in ("obj", "glb", "stl") for count in (40_000, 65_535)]
# Name: how its files are made, and at least so many faces are drawn, in so many objects.
MODELS = {f"sphere of {count:,} faces, {suffix}": ((lambda folder, suffix=suffix, count=count: honest_models.sphere_file(
    folder, suffix, count)), 30_000, 1) for suffix, count in SPHERES} | {
        "terrain": (honest_models.terrain, 200_000, 4),
        "objects": (honest_models.many_objects, 20_000 * 6, 20_000),
        "materials": (honest_models.many_materials, 800, 1),
        "concave faces": (honest_models.concave_faces, 29_980, 1),
        "nodes": (honest_models.many_nodes, 20_000, 1)}


@pytest.mark.parametrize("name", sampled("honest models", MODELS, 3))
def test_a_large_model_is_compiled(tmp_path, name):
    make, faces, objects = MODELS[name]
    done = run_cli("build", make(tmp_path), "-o", tmp_path / "out.fxls")
    assert done.returncode == 0, done.stderr[-2000:]
    made = image.load(tmp_path / "out.fxls")
    assert len(made.objects) == objects and max(len(model.faces) for model in made.models) <= FACES_MAX
    assert sum(len(made.models[item.model].faces) for item in made.objects) >= faces


def test_there_are_eleven():
    assert len(MODELS) == 11


def test_a_model_that_turns_is_not_divided(tmp_path):
    honest_models.terrain(tmp_path)
    (tmp_path / "scene.toml").write_text('[[objects]]\nmodel = "model.obj"\nfit = 9\nturn = 3\n')
    done = run_cli("build", tmp_path / "scene.toml", "-o", tmp_path / "out.fxls")
    assert done.returncode == 2 and "200000 faces; a model has at most 65535 of each, so split it" in done.stderr, done.stderr


def test_a_model_is_divided_into_the_fewest_cells_that_do(tmp_path, monkeypatch):
    """Of a grid of as many cells across as along; no face is lost."""
    made = shape(solids.make("floor", {"cells": (20, 20)}, "here"), matrix((9, 9, 9), (0, 0, 0)), "here")
    for most, wanted in ((441, None), (440, (2, 2)), (121, (2, 2)), (120, (3, 3)), (9, (10, 10))):     # vertices of a part
        monkeypatch.setattr(parts, "FACES_MAX", most)
        assert parts.fitting(made, "here") == wanted
    monkeypatch.setattr(parts, "FACES_MAX", 3)
    with pytest.raises(ToolError, match="here: 400 faces and 441 vertices are more than the 3 of a model"):
        parts.fitting(made, "here")
    found, _ = parts._grouped(made, (3, 3))
    assert sorted(number for numbers in found.values() for number in numbers) == list(range(400)) and len(found) == 9
