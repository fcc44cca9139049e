# SPDX-License-Identifier: MIT
"""Light that the tool bakes into textures, in however many directions their faces look."""

import json

import numpy
import pytest

from conftest import run_cli
from board_programs import BOARD
from fixel.base.errors import ToolError
from fixel.image import image
from fixel.report import showcase_models
from fixel.scene import compiler, look, palette, toml_texture
from model_files import glb, gltf, png
from test_model_files import grid

CHECKS = png([[(255, 255, 255) if (x + y) % 2 else (200, 200, 200) for x in range(16)] for y in range(16)])


def hill(tmp_path):
    """A textured hill whose faces look in many directions."""
    points, triangles = grid(12, lambda x, y: x * y / 9)
    file = tmp_path / "m.glb"
    data, blob = gltf(points, triangles, uvs=[(x / 12, y / 12) for x, y, _ in points], image=CHECKS)
    data["materials"][0]["doubleSided"] = True
    file.write_bytes(glb(data, blob))
    return file


def baked(file, **more):
    """The scene of a model with baked light."""
    made, notes = compiler.compile_scene(str(file), 4, look=look.of(look.Asked(bake_light=True, **more), "rgb565", 16, 16))
    assert image.unpack(image.pack(made)) == made
    return made, notes


def test_a_model_has_no_light_at_run_time_and_at_most_16_textures(tmp_path):
    made, notes = baked(hill(tmp_path))
    faces = made.models[0].faces
    assert made.light is None and not any("directions" in note for note in notes)
    assert len({face.normal for face in faces}) > 50 and 4 < len(made.surfaces.textures) <= toml_texture.DIRECTIONS_MAX
    assert all(face.mapped.normals == (0, 0, 0) for face in faces)
    plain, _ = compiler.compile_scene(str(hill(tmp_path)), 4, look=look.Look())
    assert plain.light is not None and len(plain.surfaces.textures) == 1


def test_each_texture_is_as_bright_as_its_faces_are_lit(tmp_path):
    """Within half of a level of the light, and the rounding of RGB565."""
    made, _ = baked(hill(tmp_path))
    light = palette.Light([0.8, -1, 0.4], 1 / 3, (0xFF, 0xF2, 0xDC), (0xC4, 0xD4, 0xFF))
    wanted = {face: light.bake((255, 255, 255), face.normal) for model in made.models for face in map(_Key, model.faces)}
    step = (max(map(sum, wanted.values())) - min(map(sum, wanted.values()))) / 15
    for face, colour in wanted.items():
        texture = made.surfaces.textures[made.surfaces.surfaces[face.mapped.surface].texture - 1]
        texels = [int.from_bytes(texture.texels[i:i + 2], "little") for i in range(0, 2 << texture.log_width + texture.log_height, 2)]
        shown = numpy.array([((each >> 11) * 255 / 31, (each >> 5 & 63) * 255 / 63, (each & 31) * 255 / 31) for each in texels]).max(axis=0)
        assert abs(shown.sum() - sum(colour)) <= step / 2 + 3 * 255 / 62 + 3


class _Key:
    """A face that may be a key."""

    def __init__(self, face):
        self.normal, self.mapped = face.normal, face.mapped


def test_a_scene_file_says_it_by_light_bake(tmp_path):
    hill(tmp_path)
    scene = '[light]\n{}[[objects]]\nmodel = "m.glb"\nimages = true\nmerge = false\n'
    (tmp_path / "s.toml").write_text(scene.format("bake = true\n"))
    made, notes = compiler.compile_scene(str(tmp_path / "s.toml"))
    assert made.light is None and len(made.surfaces.textures) > 4 and not any("directions" in note for note in notes)
    (tmp_path / "s.toml").write_text(scene.format("bake = true\nlevels = 16\n"))
    with pytest.raises(ToolError, match="bake: belongs to light that the tool computes"):
        compiler.compile_scene(str(tmp_path / "s.toml"))


def test_a_model_without_textures_has_flat_faces(tmp_path):
    file = showcase_models.write(next(each for each in showcase_models.MODELS if each.name == "vase"), tmp_path)
    made, _ = baked(file)
    assert made.light is None and made.surfaces is None and len({face.colour for face in made.models[0].faces}) > 8


def test_what_moves_cannot_be_baked(tmp_path):
    file = showcase_models.write(next(each for each in showcase_models.MODELS if each.name == "planets"), tmp_path)
    with pytest.raises(ToolError, match="--bake-light: the animation moves parts"):
        baked(file)


def test_the_option_and_its_scene_file_give_the_same_frames(tmp_path):
    file, a, b = hill(tmp_path), tmp_path / "a.fxls", tmp_path / "b.fxls"
    done = run_cli("build", file, "--bake-light", "-o", a, "--write", tmp_path / "s.toml")
    assert done.returncode == 0, done.stderr
    assert "bake = true" in (tmp_path / "s.toml").read_text() and run_cli("build", tmp_path / "s.toml", "-o", b).returncode == 0
    assert a.read_bytes() == b.read_bytes()
    done = run_cli("build", file, "--bake-light", "--smooth", "40", "-o", a)
    assert done.returncode == 2 and "--bake-light and --smooth exclude each other" in done.stderr


def test_a_board_draws_it_as_double_does(build, tmp_path):
    done = run_cli("run", "--board", BOARD, "--scene", hill(tmp_path), "--frames", 2, "--bake-light", "--out", tmp_path / "run", "--build", build)
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "run" / "summary.json").read_text())
    assert summary["pixels_unexplained"] == 0 and summary["order_wrong_pixels"] == 0 and "light at run time" not in done.stderr
