# SPDX-License-Identifier: MIT
"""The board rv32, where its tools are: the frames of scenes, a display's wires, faults, the first program, and unit tests."""

import json
import shutil
import subprocess

import pytest
from board_programs import ROOT, built
from conftest import run_make
from fixel.board import dump, unit_tests

NEEDED = subprocess.run([ROOT / "tools/setup.sh", "--missing", "riscv"], capture_output=True, text=True, check=True).stdout.split()
here = pytest.mark.skipif(bool(NEEDED), reason=f"needs {' '.join(NEEDED)}")


def run(out, *words):
    """make run on this board: (what it said, its summary)."""
    done = run_make("run", "BOARD=rv32", f"OUT={out}", *words)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout, json.loads((out / "summary.json").read_text())


@here
@pytest.mark.parametrize("scene, words", [
    ("plaza", []), ("spin", []), ("room", ["PIXELS=rgb565"]), ("gallery", ["DEPTH=16"]), ("knot", [])])
def test_scenes_are_equal_to_the_host(tmp_path, scene, words):
    said, summary = run(tmp_path / "out", f"SCENE=scenes/{scene}.toml", "FRAMES=3", *words)
    assert "equal to host          yes" in said and summary["host_frames_equal"] and summary["frames"] == 3
    assert summary["pixels_unexplained"] == 0 and summary["instructions_per_frame"]["min"] > 0
    assert summary["cpu"] == "rv32imc" and len(set(summary["frame_crc"])) > 1


@here
@pytest.mark.parametrize("words", [["DRIVER=st7789"], ["PIXELS=rgb565", "DEPTH=16"]])
def test_the_game_is_equal_and_a_display_shows_it(tmp_path, words):
    _, summary = run(tmp_path / "out", "PROGRAM=game", "FRAMES=12", *words)
    assert summary["host_frames_equal"]
    assert summary["wires_frames_equal"] == (12 if words[0].startswith("DRIVER") else None)


@here
@pytest.mark.parametrize("name", ["test_crc", "test_render", "test_project", "test_plane", "test_clip_view", "test_depth"])
def test_unit_tests_pass(name):
    """Some of them; make test BOARD=rv32 runs all."""
    linked = json.loads(built("rv32/unit/units.json").read_text(encoding="utf-8"))
    assert linked["left_out"] == {}
    elf, = [each for each, names in linked["programs"].items() if name in names]
    file, = unit_tests.run(ROOT / "build/boards/rv32/unit" / elf, [name])
    assert file.passed > 0 and file.failed == 0, file.output


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
