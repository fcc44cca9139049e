# SPDX-License-Identifier: MIT
"""Models of the showcase, drawn as `make showcase` draws them; and its page. All 24 are drawn by that command."""

import json

import numpy
import pytest
from PIL import Image

from board_programs import BOARD
from conftest import run_cli
from fixel.base.errors import ToolError
from fixel.image import image
from fixel.report import showcase_models, showcase
from fixel.scene import compiler, look

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "host/frames", "host/judge", "host/raycast", "host/predict")


def of(name):
    """The model of a name."""
    found, = (model for model in showcase_models.MODELS if model.name == name)
    return found


def compiled(folder, name):
    """(the scene of a model as its author made it, notes)."""
    made, notes = compiler.compile_scene(str(showcase_models.write(of(name), folder)), 2, look=look.Look())
    assert image.unpack(image.pack(made)) == made
    return made, notes


def colours(made):
    """The colours of all faces."""
    return {made.palette[face.colour] for model in made.models for face in model.faces}


def pictures(build, folder, name):
    """The two pictures of a model that was drawn, of which every pixel is explained and none is wrong by the order."""
    file = showcase_models.write(of(name), folder)
    done = run_cli("run", "--board", BOARD, "--scene", file, "--frames", 2, "--out", folder / "run", "--build", build)
    assert done.returncode == 0, done.stderr
    summary = json.loads((folder / "run" / "summary.json").read_text())
    assert summary["pixels_unexplained"] == 0 and summary["order_wrong_pixels"] in (0, None)
    return [numpy.asarray(Image.open(folder / "run" / f"frame_{number:04d}.png").convert("RGB")).astype(int) for number in range(2)]


def background(picture):
    """How much of a picture shows no face."""
    return float((picture == picture[0, 0]).all(axis=2).mean())


def test_a_palette_atlas_needs_no_texture_and_keeps_its_colours(build, tmp_path):
    made, _ = compiled(tmp_path, "village")
    assert not made.surfaces or not made.surfaces.textures
    atlas = {(70, 130, 60), (120, 80, 50), (40, 100, 50), (200, 60, 50), (230, 220, 200), (160, 160, 150)}
    assert all(min(max(abs(a - b) for a, b in zip(one, found)) for found in colours(made)) <= 2 for one in atlas)
    assert all(0.5 < background(picture) < 0.95 for picture in pictures(build, tmp_path, "village"))


def test_a_gradient_atlas_of_40_materials_needs_no_texture(build, tmp_path):
    made, _ = compiled(tmp_path, "city")
    assert not made.surfaces or not made.surfaces.textures
    assert len(colours(made)) > showcase_models.BUILDINGS
    assert all(0.4 < background(picture) < 0.95 for picture in pictures(build, tmp_path, "city"))


def test_a_model_in_millimetres_fits_the_screen(build, tmp_path):
    made, notes = compiled(tmp_path, "bracket")
    low, high = ([end(axis) for axis in zip(*made.models[0].vertices)] for end in (min, max))
    wide, up, deep = ((b - a) for a, b in zip(low, high))
    assert wide / up == pytest.approx(120 / 68, rel=0.01) and wide / deep == pytest.approx(120 / 80, rel=0.01)     # STL's z is up
    assert not any("turned round" in note for note in notes)
    assert all(0.5 < background(picture) < 0.9 for picture in pictures(build, tmp_path, "bracket"))


def test_a_car_keeps_its_9_nodes_and_its_wheels_turn(build, tmp_path):
    made, _ = compiled(tmp_path, "car")
    assert set(made.names) == {"body", "cabin", "windows", "lamps", "spoiler", *(f"wheel {end} {side}" for end in ("front", "rear")
                                                                                for side in ("left", "right"))}
    assert len(made.motions) == 4
    front, behind = pictures(build, tmp_path, "car")
    assert 0.4 < background(front) < 0.95 and (front != behind).any()


def test_a_skin_of_three_joints_stands_in_its_pose(build, tmp_path):
    made, _ = compiled(tmp_path, "character")
    points = [[c + o for c, o in zip(vertex, item.centre)] for item in made.objects for vertex in made.models[item.model].vertices]
    low, high = ([end(axis) for axis in zip(*points)] for end in (min, max))
    assert (high[1] - low[1]) / (high[0] - low[0]) == pytest.approx(2.26 / 1.02, rel=0.02)
    assert all(0.7 < background(picture) < 0.97 for picture in pictures(build, tmp_path, "character"))


def test_mirrored_texture_coordinates_beyond_the_image(build, tmp_path):
    """The quilt's left half mirrors its right one, and the picture shows all three colours of the cloth."""
    made, _ = compiled(tmp_path, "quilt")
    assert made.surfaces.textures
    front, _ = pictures(build, tmp_path, "quilt")
    red, green, blue = (front[..., i] for i in range(3))
    for is_it in ((blue > red + 30) & (blue > 80), (red > 120) & (green > 100) & (blue < 90), (red > 120) & (green < 90)):
        assert is_it.sum() > 60


def test_there_are_24_models_each_made_the_same_each_time(tmp_path):
    assert len(showcase_models.MODELS) == len({model.name for model in showcase_models.MODELS}) == 24
    assert of("scan").look == "--simplify 5000" and showcase_models.SCAN_FACES == 200_000 and showcase_models.SCAN_IMAGE == 4096
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        for name in ("village", "gem", "terrain", "photo"):
            showcase_models.write(of(name), tmp_path / folder)
    files = sorted(file.name for file in (tmp_path / "a").iterdir())
    assert len(files) == 6 and all((tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes() for name in files)


def test_the_page_has_a_command_and_a_picture_of_each_model(build, tmp_path):
    done = run_cli("showcase", "--board", "host", "--only", "badge,gem", "--out", tmp_path / "page", "--build", build)
    assert done.returncode == 0, done.stderr
    text = (tmp_path / "page" / "index.html").read_text()
    for model in map(of, ("badge", "gem")):
        assert f"make run SCENE={tmp_path}/page/{model.file}" in text and f'src="{model.name}_seen.png"' in text
        assert Image.open(tmp_path / "page" / f"{model.name}_seen.png").size == (320, 240) and (tmp_path / "page" / model.file).exists()
    assert "RGB565" in text and "seed 2026" in text
    summary = json.loads((tmp_path / "page" / "summary.json").read_text())
    assert [row["name"] for row in summary["models"]] == ["badge", "gem"] and all(row["pass"] for row in summary["models"])


def test_a_model_that_is_not_there_is_named():
    with pytest.raises(ToolError, match="ONLY is lorry; the models are: crate, village"):
        showcase.chosen("lorry")
