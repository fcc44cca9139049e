# SPDX-License-Identifier: MIT
"""Names of an exported header: that of the scene, of its instances, models, surfaces and textures."""

import subprocess

import pytest

from board_programs import ROOT
from conftest import assert_one_sentence, run_cli
from fixel.image import c_names
from fixel.scene import compiler, making
from test_export import compiled

BUILT_PROGRAMS = ()
CUBE = ROOT / "examples" / "cube" / "cube.obj"


@pytest.mark.parametrize("name, words", [
    ("9a", ["begin with a letter", "--name scene_9a"]), ("a-b", ["English", "--name a_b"]), ("", ["--name scene"]),
    ("_a", ["--name a"]), ("a__b", ["__", "--name a_b"]), ("fxl", ["fxl", "--name scene_fxl"]),
    ("FXL_a", ["--name scene_FXL_a"]), ("ä", ["English"]), ("a" * 41, ["longer than 40", "--name aaa"]),
    ("a\nb", ["--name a_b"]),
])
def test_names_that_are_no_c_names_are_refused(tmp_path, name, words):
    done = run_cli("export", "--c", CUBE, "-o", tmp_path / "x.h", f"--name={name}")
    assert done.returncode == 2 and "Traceback" not in done.stderr
    for word in ["error: the name", *words]:
        assert word in done.stderr
    assert not list(tmp_path.iterdir())


def test_a_name_that_is_proposed_is_taken():
    for name in ("9a", "a-b", "", "_a", "a__b", "fxl", "ä", "a" * 41, "-", "fxl" + "_" * 50, "a" * 39 + "_b", "Fxl9"):
        c_names.check_name(c_names.suggestion(name))


@pytest.mark.parametrize("file, name", [("my model.obj", "my_model"), ("2 cubes.obj", "scene_2_cubes"), ("cube.obj", "cube")])
def test_a_file_whose_name_is_no_c_name_gives_one_like_it(tmp_path, file, name):
    (tmp_path / file).write_bytes(CUBE.read_bytes())
    done = run_cli("export", "--c", tmp_path / file, "-o", tmp_path / "x.h")
    assert done.returncode == 0, done.stderr
    assert f" {name}_scene = " in (tmp_path / "x.h").read_text()


def test_a_name_that_is_given_and_is_no_c_name_is_told_to_be_another(tmp_path):
    done = run_cli("export", "--c", CUBE, "-o", tmp_path / "x.h", "--name", "my model")
    assert_one_sentence(done, '"my model"', "--name my_model")


def test_names_of_objects_become_enumerations(tmp_path):
    scene = '[[objects]]\nname = "Gem, red"\nsolid = "octahedron"\n' \
            '[[objects]]\nname = "pillars"\nsolid = "prism"\nring = { count = 3, radius = 4 }\n' \
            '[[objects]]\nsolid = "tile"\n[[objects]]\nname = "gem red"\nsolid = "box"\nturn = 3\n' \
            "[[objects]]\nname = '\"*/'\nsolid = \"cone\"\n"
    (tmp_path / "scene.toml").write_text(scene, encoding="utf-8")
    making.export(str(tmp_path / "scene.toml"), str(tmp_path / "scene.h"), "s")
    made, _ = compiler.compile_scene(str(tmp_path / "scene.toml"))
    wanted = {"S_INSTANCE_GEM_RED": 0, "S_INSTANCE_PILLARS": 1, "S_INSTANCES_OF_PILLARS": 3, "S_INSTANCE_GEM_RED_2": 6,
              "S_INSTANCE_U0022_U002A_U002F": 5, "S_MODEL_U0022_U002A_U002F": made.objects[5].model,
              "S_MODEL_GEM_RED": made.objects[0].model, "S_MODEL_PILLARS": made.objects[1].model,
              "S_MODEL_GEM_RED_2": made.objects[6].model}
    checks = "".join(f"    if ({name} != {value}) {{ return {i}; }}\n" for i, (name, value) in enumerate(wanted.items(), 1))
    text = (tmp_path / "scene.h").read_text(encoding="utf-8")
    assert subprocess.run([compiled(tmp_path, f'#include "scene.h"\nint main(void)\n{{\n{checks}    return 0;\n}}\n')],
                          check=False).returncode == 0
    assert text.count("_INSTANCE_") == 4 and "enum {" in text


@pytest.mark.parametrize("names, words", [
    (["wheel fl", "int", "7up", "Zoë", "Straße", "__x"], ["WHEEL_FL", "INT", "7UP", "ZOE", "STRASSE", "X"]),
    (["a b", "a-b", "A_B_2", "a+b"], ["A_B", "A_B_2", "A_B_2_2", "A_B_3"]),
    (["колесо", "轮", "轮子", "🙂", "轮b"], ["U043A_U043E_U043B_U0435_U0441_U043E", "U8F6E", "U8F6E_U5B50", "U1F642", "B"]),
    (["x" * 60, "x" * 61, "_", "!"], ["X" * 40, "X" * 40 + "_2", "U005F", "U0021"])])
def test_every_name_is_a_word_of_its_own(names, words):
    assert list(c_names.distinct(names).values()) == words


def test_many_names_of_one_word_are_numbered_in_a_moment():
    assert len(set(c_names.distinct(f"a{'!' * number}" for number in range(20_000)).values())) == 20_000


def test_names_of_textures_and_of_their_objects_become_enumerations(tmp_path):
    file = str(ROOT / "host_tests" / "tools" / "surfaces.toml")
    making.export(file, str(tmp_path / "scene.h"), "s")
    made, _ = compiler.compile_scene(file)
    looks = {name: sorted({face.mapped.surface for face in made.models[item.model].faces if face.mapped})
             for name, item in zip(made.names, made.objects)}
    wanted = {"S_SURFACE_ROOM": looks["room"][0], "S_SURFACE_CRATE": looks["crate"][0],
              "S_SURFACES_OF_CRATE": len(looks["crate"]), "S_SURFACE_PANE": looks["pane"][0]}
    for name in ("bricks", "grille"):
        numbers = [i for i, own in enumerate(made.surfaces.texture_names) if own == name]
        wanted[f"S_TEXTURE_{name.upper()}"] = numbers[0]
        assert all(made.surfaces.textures[i].log_height == {"bricks": 5, "grille": 4}[name] for i in numbers) and numbers
    assert len(looks["crate"]) == 4 and len(made.surfaces.texture_names) == len(made.surfaces.textures)
    checks = "".join(f"    if ({name} != {value}) {{ return {i}; }}\n" for i, (name, value) in enumerate(wanted.items(), 1))
    source = f'#include "scene.h"\nint main(void)\n{{\n{checks}    return 0;\n}}\n'
    assert subprocess.run([compiled(tmp_path, source)], check=False).returncode == 0


def test_a_tree_takes_the_names_of_what_it_swallows(tmp_path):
    scene, _ = compiler.compile_scene(str(ROOT / "scenes" / "knot.toml"), None, None, "all")
    assert len(scene.names) == len(scene.objects) and scene.names[scene.tree.object] is None
