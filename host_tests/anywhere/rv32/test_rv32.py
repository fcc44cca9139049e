# SPDX-License-Identifier: MIT
"""The board rv32, where its tools are: the frames of scenes, a display's wires, faults, the first program, and unit tests."""

import functools
import json
import shutil
import subprocess

import own_tools
import pytest
from board_programs import ROOT
from conftest import run_make
from fixel.board import dump

NEEDED = subprocess.run([ROOT / "tools/setup.sh", "--missing", "riscv"], capture_output=True, text=True, check=True).stdout.split()
here = pytest.mark.skipif(bool(NEEDED), reason=f"needs {' '.join(NEEDED)}")


run = functools.partial(own_tools.run, "rv32")


@here
@pytest.mark.parametrize("scene, words", own_tools.SCENES)
def test_scenes_are_equal_to_the_host(tmp_path, scene, words):
    summary = own_tools.draw_scene("rv32", tmp_path / "out", scene, words)
    assert summary["cpu"] == "rv32imc" and summary["instructions_per_frame"]["min"] > 0


@here
@pytest.mark.parametrize("scene", ["window", "car", "room", "gallery", "grove"])
def test_instructions_are_predicted_as_near_as_for_other_boards(tmp_path, scene):
    """Of scenes that are not in the fit."""
    _, drawn = run(tmp_path / "out", f"SCENE=scenes/{scene}.toml", "FRAMES=12")
    done = run_make("predict", "BOARD=rv32", f"SCENE=scenes/{scene}.toml", "FRAMES=12", f"JSON={tmp_path / 'said.json'}")
    assert done.returncode == 0, done.stderr
    said = json.loads((tmp_path / "said.json").read_text(encoding="utf-8"))
    assert said["core"] == "rv32" and abs(said["instructions_per_frame"]["mean"] / drawn["instructions_per_frame"]["mean"] - 1) <= 0.15


@here
@pytest.mark.parametrize("words", own_tools.GAMES)
def test_the_game_is_equal_and_a_display_shows_it(tmp_path, words):
    own_tools.draw_game("rv32", tmp_path / "out", words)


@here
@pytest.mark.parametrize("name", own_tools.EXPORTED)
def test_the_program_of_an_exported_scene_draws_the_frames_of_make_run(tmp_path, name):
    own_tools.draw_exported("rv32", tmp_path, name)


@here
@pytest.mark.parametrize("name", own_tools.UNITS)
def test_unit_tests_pass(name):
    assert own_tools.run_unit("rv32", name)["left_out"] == {}


@here
@pytest.mark.parametrize("text, code, sentence", [
    ("*(volatile int *)16 = 1;", 44, "access through a null pointer"),
    ("return *(volatile int *)0x05000000;", 46, "access to an address where nothing answers"),
    ("__asm__ volatile(\".word 0\");", 47, "an instruction that the core cannot execute"),
    ("for (;;) {}", 50, "the program hung"),
    ("char much[70000]; for (int i = 69999; i >= 0; i -= 100) { *(volatile char *)&much[i] = 1; } return much[5];", 40, "stack")])
def test_faults_end_the_program(tmp_path, text, code, sentence):
    (tmp_path / "failing.c").write_text(f"int main(void) {{ {text} return 0; }}\n", encoding="utf-8")
    done = run_make("run", "BOARD=rv32", f"PROGRAM={tmp_path / 'failing.c'}", f"OUT={tmp_path / 'out'}")
    assert done.returncode == 2 and f"Error {code}" in done.stderr and f"fault: {sentence}" in done.stderr, done.stderr
    assert code in (40, 50) or "pc  0x8000" in done.stderr and "in main+" in done.stderr


@here
def test_the_first_program_draws_the_picture_of_the_host(tmp_path):
    from fixel.scene import making
    making.export(str(ROOT / "examples/cube/cube.obj"), str(tmp_path / "cube_scene.h"))
    shutil.copy(ROOT / "examples/cube/main.c", tmp_path)
    _, summary = run(tmp_path / "out", f"PROGRAM={tmp_path / 'main.c'}")
    assert summary["host_frames_equal"] and len(dump.read_dump(tmp_path / "out/board.fxld").frames) == 1


@here
def test_counted_instructions_are_exact(tmp_path):
    """Those of two runs are equal, and no multiple of a clock's steps."""
    counts = []
    for name in ("one", "two"):
        run(tmp_path / name, "SCENE=scenes/tiny.toml", "FRAMES=4", "FRESH=1")
        counts.append([frame.instructions for frame in dump.read_dump(tmp_path / name / "board.fxld").frames])
    assert counts[0] == counts[1] and any(count % 40 for count in counts[0])
