# SPDX-License-Identifier: MIT
"""examples/turn: a cube that turns in 25 lines."""

import subprocess

import numpy
import pytest
from conftest import CHECKOUT

from fixel.report import examples

EXAMPLE = CHECKOUT / "examples" / "turn" / "main.c"
FRAMES = 121    # a whole turn, and the first frame of the next
SHOW = f"""
#include <stdint.h>
#include <stdio.h>
int show(const uint8_t *pixels);
int show(const uint8_t *pixels)
{{
    static int calls;
    if (calls > 0) {{ fwrite(pixels, 1, 320 * 240, stdout); }}
    return calls++ == {FRAMES};
}}
"""


@pytest.fixture(name="folder")
def fixture_folder(tmp_path):
    examples.write_scene(tmp_path)
    (tmp_path / "show.c").write_text(SHOW, encoding="utf-8")
    return tmp_path


def test_it_turns(build, folder):
    subprocess.run(["gcc", "-std=c11", "-Wall", "-Wextra", "-Werror", f"-I{CHECKOUT / 'lib' / 'include'}", f"-I{folder}",
                    str(EXAMPLE), "show.c", str(build / "host/libfixel.a"), "-o", "turn"], cwd=folder, check=True)
    done = subprocess.run([folder / "turn"], capture_output=True, check=True)
    frames = numpy.frombuffer(done.stdout, numpy.uint8).reshape(FRAMES, 240, 320)
    assert (frames[0] == frames[120]).all() and len({frame.tobytes() for frame in frames[:120]}) == 120
    assert all((frame != frame[0, 0]).sum() > 3000 for frame in frames)


def test_it_compiles_for_a_small_core(folder):
    subprocess.run(["arm-none-eabi-gcc", "-mcpu=cortex-m0", "-mthumb", "-std=c11", "-Wall", "-Wextra", "-Werror", "-c",
                    f"-I{CHECKOUT / 'lib' / 'include'}", f"-I{folder}", str(EXAMPLE)], cwd=folder, check=True)


def test_it_is_short():
    lines = EXAMPLE.read_text(encoding="utf-8").splitlines()
    assert len([line for line in lines if line.strip() and not line.startswith("/*")]) <= 25
