# SPDX-License-Identifier: MIT
"""Models as other programs write them, in the folder models: what each must look like, and what must be said of it."""

import pathlib

import pytest

from fixel.base.errors import ToolError
from fixel.image import image
from fixel.scene import compiler

MODELS = pathlib.Path(__file__).parent / "models"


def compiled(name):
    """The scene of a file of the folder, and the tool's notes."""
    made, notes = compiler.compile_scene(str(MODELS / name), None if name.endswith(".toml") else 4)
    assert image.unpack(image.pack(made)) == made
    return made, notes


def colours(made):
    """The colours of all faces."""
    return {made.palette[face.colour] for model in made.models for face in model.faces}


def said(notes, *words):
    """How many notes have all of these words."""
    return sum(all(word in note for word in words) for note in notes)


def test_colours_of_vertices_are_kept():
    made, notes = compiled("vertex_colours.obj")
    assert len(colours(made)) == 6 and said(notes, "vertices have colours", "mean of its corners' colours") == 1


def test_an_image_that_is_not_there():
    made, notes = compiled("missing_image.obj")
    red, green, blue = max(colours(made))
    assert red > green > blue and said(notes, "missing_image.mtl:3", "wood.png", "the colour of Kd") == 1


def test_a_file_whose_name_has_another_case():
    made, notes = compiled("case.obj")
    red, green, blue = max(colours(made))
    assert blue > green > red and said(notes, 'no "Case.MTL": "case.mtl" is read instead') == 1


def test_a_text_of_stl_in_capitals():
    made, _ = compiled("capitals.stl")
    assert sum(len(model.faces) for model in made.models) == 6


def test_a_statement_that_is_not_known():
    made, notes = compiled("unknown_statement.obj")
    assert len(made.models[0].faces) == 6 and said(notes, "not known", "1 x vw", "unknown_statement.obj:9") == 1


@pytest.mark.parametrize("suffix, words", [
    ("fbx", ["FBX", "Blender", ".glb"]), ("dae", ["Collada", ".glb"]), ("3mf", ["3MF", "STL"]), ("vox", ["MagicaVoxel", "OBJ"]),
    ("blend", ["Blender", ".glb"]), ("ZIP", ["archive", "unpack"]), ("ply", ["PLY", "OBJ"])])
def test_formats_that_are_not_read_are_refused_by_name_with_the_way_to_go(tmp_path, suffix, words):
    (tmp_path / f"model.{suffix}").write_bytes(b"x")
    (tmp_path / "scene.toml").write_text(f'[[objects]]\nmodel = "model.{suffix}"\n')
    for name in (f"model.{suffix}", "scene.toml"):
        with pytest.raises(ToolError) as caught:
            compiler.compile_scene(str(tmp_path / name))
        assert all(word in str(caught.value) for word in (f"model.{suffix}", *words)) and "\n" not in str(caught.value)
