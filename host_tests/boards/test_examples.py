# SPDX-License-Identifier: MIT
"""docs/examples.md: each of its programs draws its picture, and compiles for a small core; the walker finds out of the maze."""

import re
import subprocess

import numpy
import pytest
from conftest import CHECKOUT
from PIL import Image

from fixel.base import picture
from fixel.report import examples

PAGE = (CHECKOUT / "docs" / "examples.md").read_text(encoding="utf-8")
ROWS = re.findall(r"^\| !\[(\w+)\]\(([\w./]+)\) \| \[(\w+)\]\(\.\./examples/(\w+)/(\w+\.c)\) \| (\d+) \| ", PAGE, re.MULTILINE)
NAMES = [row[0] for row in ROWS]
FLAGS = ["-std=c11", "-Wall", "-Wextra", "-Werror", f"-I{CHECKOUT / 'lib' / 'include'}"]
# Follows the walker of examples/maze: it keeps its radius from each wall, and ends beyond the maze.
WALK = """
#define main maze_main
#include "MAZE"
#undef main
#include <stdio.h>
static int frames, inside;
int show(const uint8_t *shown)
{
    (void)shown;
    for (int i = 0; i < SIDE * SIDE; i++) {
        const int64_t x = walker.centre.x - FXL_UNITS(i % SIDE * 2), z = walker.centre.z - FXL_UNITS(i / SIDE * 2);
        const int64_t beside_x = x < 0 ? -x - 65536 : x - 65536, beside_z = z < 0 ? -z - 65536 : z - 65536;
        const int64_t out_x = beside_x > 0 ? beside_x : 0, out_z = beside_z > 0 ? beside_z : 0;
        inside += map[i / SIDE][i % SIDE] == '#' && out_x * out_x + out_z * out_z < (int64_t)walker.radius * walker.radius;
    }
    return ++frames == 1000;
}
int main(void)
{
    const int failed = maze_main();
    printf("%d %d %d %d", failed, frames, inside, walker.centre.x > FXL_UNITS(2 * SIDE));
    return 0;
}
"""


def test_the_page_has_every_example_once():
    assert len(NAMES) >= 12 and sorted(NAMES) == sorted(folder.name for folder in (CHECKOUT / "examples").iterdir() if folder.is_dir())
    assert {*examples.PICTURES, *examples.WIDE_PICTURES} == set(NAMES) - {"game"}
    assert sorted(file.stem for file in (CHECKOUT / "docs" / "examples").glob("*.png")) == \
        sorted(name for name in NAMES if examples.picture_of(name).parent.name == "examples")


@pytest.mark.parametrize("name, picture, same, folder, source, lines", ROWS, ids=NAMES)
def test_a_row_names_its_files(name, picture, same, folder, source, lines):
    assert name == same == folder and CHECKOUT / "docs" / picture == examples.picture_of(name)
    text = (CHECKOUT / "examples" / name / source).read_text(encoding="utf-8")
    assert len([line for line in text.splitlines() if line.strip()]) == int(lines)
    assert set(re.findall(r"(\d+) lines", text.partition("#include")[0])) <= {lines}    # what its own comment says


@pytest.mark.parametrize("name", list(examples.PICTURES))
def test_an_example_draws_its_picture(build, name):
    pixels, palette = examples.draw_example(build / "host" / "libfixel.a", name)
    shown = numpy.array(Image.open(examples.picture_of(name)).convert("RGB"))
    assert len(numpy.unique(pixels)) > 1
    assert numpy.array_equal(palette[pixels], shown)


def test_the_model_draws_its_picture(build):
    pixels = examples.draw_wide(build / "host" / "libfixel.a", "model")
    shown = numpy.array(Image.open(examples.picture_of("model")).convert("RGB"))
    assert len(numpy.unique(pixels)) > 100      # texels and smooth light
    assert numpy.array_equal(picture.as_rgb(pixels, picture.rgb565_colours()), shown)


def test_the_model_is_the_one_that_the_tool_makes(tmp_path):
    examples.write_own_scene(tmp_path)
    stored = (tmp_path / "model_scene.h").read_text(encoding="utf-8")
    assert "&fxl_rgb565_depth_16," in stored and "fxl_attach_surfaces" in stored and "fxl_attach_lit" in stored
    examples.write_model(tmp_path / "model.glb")
    examples.write_own_scene(tmp_path, tmp_path / "model.glb")
    assert (tmp_path / "model_scene.h").read_text(encoding="utf-8") == stored


@pytest.mark.parametrize("name", [*examples.PICTURES, "model"])
def test_an_example_compiles_for_a_small_core(tmp_path, name):
    examples.write_scene(tmp_path)
    examples.write_own_scene(tmp_path)
    subprocess.run(["arm-none-eabi-gcc", "-mcpu=cortex-m0", "-mthumb", *FLAGS, "-c", f"-I{tmp_path}",
                    str(CHECKOUT / "examples" / name / "main.c")], cwd=tmp_path, check=True)


def test_the_walker_finds_out_of_the_maze(build, tmp_path):
    (tmp_path / "walk.c").write_text(WALK.replace("MAZE", str(CHECKOUT / "examples" / "maze" / "main.c")), encoding="utf-8")
    subprocess.run(["gcc", *FLAGS, "walk.c", str(build / "host/libfixel.a"), "-o", "walk"], cwd=tmp_path, check=True)
    said = subprocess.run(["./walk"], cwd=tmp_path, text=True, capture_output=True, check=True).stdout
    failed, frames, inside, out = map(int, said.split())
    assert failed == 0 and 100 < frames < 1000 and inside == 0 and out == 1, said


def test_show_of_the_page_writes_a_frame(build, tmp_path):
    show, = re.findall(r"```c\n(.*?)```", PAGE, re.DOTALL)
    (tmp_path / "show.c").write_text(show, encoding="utf-8")
    examples.write_scene(tmp_path)
    subprocess.run(["gcc", *FLAGS, f"-I{tmp_path}", str(CHECKOUT / "examples/turn/main.c"), "show.c", str(build / "host/libfixel.a"),
                    "-o", "turn"], cwd=tmp_path, check=True)
    subprocess.run(["./turn"], cwd=tmp_path, check=True)
    assert (tmp_path / "frame.pgm").read_bytes().startswith(b"P5 320 240 255\n")
    assert (tmp_path / "frame.pgm").stat().st_size == 15 + 320 * 240
