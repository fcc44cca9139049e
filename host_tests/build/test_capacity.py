# SPDX-License-Identifier: MIT
"""FXL_POLYGON_CAPACITY as a setting of the build: what it costs, what it draws, and that the library
and its user cannot differ in it."""

import re
import subprocess
from pathlib import Path

import pytest
from conftest import run_cli

BUILT_PROGRAMS = ("host/libfixel.a",)
ROOT = Path(__file__).resolve().parents[2]
SMALL, USUAL = 12, 32
STRICT = ["-std=c11", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wpedantic", "-Werror"]
# Draws the cube of the examples, as characters.
PROGRAM = """
#include <fixel.h>
#include <stdio.h>
#include "cube_scene.h"
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static uint8_t pixels[28][64];
int main(void)
{
    fxl_config config = fxl_config_default(64, 28);
    fxl_pose eye = {{FXL_UNITS(1), FXL_UNITS(2), FXL_UNITS(-8)}, 0, FXL_DEGREES(-12), 0};
    if (fxl_renderer_init(&renderer, &cube_scene, &config, memory, sizeof memory) ||
        fxl_render(&renderer, &eye, pixels[0], 64)) return 1;
    for (int y = 0; y < 28; y++, putchar('\\n'))
        for (int x = 0; x < 64; x++) putchar(pixels[y][x] == 0 ? ' ' : '#' + pixels[y][x]);
    return 0;
}
"""

# A scene whose second face has five corners.
PENTAGON = """
#include <fixel.h>
#include <stdio.h>
#include <string.h>
int main(void)
{
    static const fxl_point vertices[] = {{0, 0, 0}, {0, 65536, 0}, {65536, 98304, 0}, {131072, 65536, 0},
                                         {131072, 0, 0}};
    static const uint16_t corners[] = {0, 1, 2, 3, 0, 1, 2, 3, 4};
    static const fxl_face faces[] = {{{0, 0, -FXL_Q2_30_ONE}, 4, 1, FXL_INDICES_AT(0, 0)},
                                     {{0, 0, -FXL_Q2_30_ONE}, 5, 2, FXL_INDICES_AT(0, 4)}};
    static const fxl_model models[] = {{0, 5, 0, 2, FXL_MODEL_CONVEX, 0, 0, 3 * 65536, 0}};
    static const fxl_instance objects[] = {{{0, 0, 0}, 0, 0, 0}};
    fxl_scene scene = {vertices, corners, faces, models, objects, 5, 9, 2, 1, 1, 0, 0, 0};
    fxl_scene_fault fault = {"nothing", 0};
    fxl_status status = fxl_scene_check(&scene, &fault);
    printf("%s: %s %u\\n", fxl_status_text(status), fault.what, (unsigned)fault.index);
    return status == FXL_OK ? 0 : status == FXL_E_CAPACITY ? 3 : 4;
}
"""


INCLUDES = [f"-I{ROOT / 'lib/include'}"]
SOURCES = sorted((ROOT / "lib").rglob("*.c"))


def gcc(*arguments, compiler="gcc", cwd=ROOT):
    return subprocess.run([compiler, *map(str, arguments)], cwd=cwd, text=True, capture_output=True,
                          check=False)


@pytest.fixture(scope="module")
def libraries(build, tmp_path_factory):
    """The library for the host, by capacity. That of the usual one is there."""
    folder = tmp_path_factory.mktemp(f"capacity{SMALL}")
    done = gcc(*STRICT, "-O1", f"-DFXL_POLYGON_CAPACITY={SMALL}", *INCLUDES, "-c", *SOURCES, cwd=folder)
    assert done.returncode == 0, done.stderr
    return {SMALL: sorted(folder.glob("*.o")), USUAL: [build / "host/libfixel.a"]}


def test_no_two_sources_have_one_name():
    """A build system that puts all objects into one folder keeps them all."""
    names = [path.stem for path in SOURCES]
    assert sorted(names) == sorted(set(names))


def link(folder, source, objects, *options):
    (folder / "program.c").write_text(source, encoding="utf-8")
    run_cli("export", "--c", ROOT / "examples/cube/cube.obj", "-o", folder / "cube_scene.h")
    return gcc(folder / "program.c", f"-I{folder}", *objects, *INCLUDES, *options, "-o",
               folder / "program")


def test_a_small_capacity_draws_the_same_picture(libraries, tmp_path):
    pictures = set()
    for capacity in (SMALL, USUAL):
        done = link(tmp_path, PROGRAM, libraries[capacity], f"-DFXL_POLYGON_CAPACITY={capacity}")
        assert done.returncode == 0, done.stderr
        pictures.add(subprocess.run([tmp_path / "program"], text=True, capture_output=True,
                                    check=True).stdout)
    assert len(pictures) == 1 and len(set(pictures.pop())) >= 4


@pytest.mark.parametrize("library, user", [(SMALL, []), (SMALL, [f"-DFXL_POLYGON_CAPACITY={SMALL + 1}"]),
                                           (USUAL, [f"-DFXL_POLYGON_CAPACITY={SMALL}"])])
def test_another_capacity_than_the_library_does_not_link(libraries, tmp_path, library, user):
    done = link(tmp_path, PROGRAM, libraries[library], *user)
    assert done.returncode != 0
    wanted = user[0].split("=")[1] if user else str(USUAL)
    assert f"undefined reference to `fxl_renderer_init_for_polygons_of_{wanted}'" in done.stderr


@pytest.mark.parametrize("capacity, code", [(SMALL, 3), (SMALL + 1, 0), (USUAL, 0)])
def test_a_face_that_is_too_much_is_refused_and_named(tmp_path, capacity, code):
    wanted = ("scene_check.c", "plane.c", "arith.c", "status.c")
    checker = [file for file in SOURCES if file.name in wanted]
    done = link(tmp_path, PENTAGON, checker, f"-DFXL_POLYGON_CAPACITY={capacity}")
    assert done.returncode == 0, done.stderr
    run = subprocess.run([tmp_path / "program"], text=True, capture_output=True, check=False)
    assert run.returncode == code
    assert run.stdout.endswith(": face 1\n" if code else ": nothing 0\n")


@pytest.mark.parametrize("capacity", [11, 33, "4"])
def test_a_capacity_out_of_range_does_not_compile(capacity):
    """SPEC 3.1p."""
    done = gcc("-std=c11", "-fsyntax-only", f"-DFXL_POLYGON_CAPACITY={capacity}", *INCLUDES,
               "lib/draw/display_list.c")
    assert done.returncode != 0 and "FXL_POLYGON_CAPACITY is" in done.stderr


@pytest.mark.parametrize("core", ["cortex-m0", "cortex-m3", "cortex-m55"])
@pytest.mark.parametrize("capacity", [SMALL, USUAL])
def test_a_renderer_is_as_large_as_its_header_says(tmp_path, core, capacity):
    header = (ROOT / "lib/include/fixel/render.h").read_text(encoding="utf-8")
    said = re.search(r"takes (\d+) bytes and\s+\* (\d+) for each vertex of FXL_POLYGON_CAPACITY: "
                     r"(\d+) where that is 32, (\d+) where\s+\* it is 12", header)
    fixed, each, usual, small = map(int, said.groups())
    assert (fixed + each * USUAL, fixed + each * SMALL) == (usual, small)
    source = tmp_path / "size.c"
    size = {SMALL: small, USUAL: usual}[capacity]
    source.write_text("#include <fixel.h>\n"
                      f"_Static_assert(sizeof(fxl_renderer) == {size}, \"renderer\");\n"
                      "_Static_assert(sizeof(fxl_draw_entry) == 12, \"entry\");\n", encoding="utf-8")
    done = gcc("-std=c11", "-fsyntax-only", f"-mcpu={core}", "-mthumb", *INCLUDES,
               f"-DFXL_POLYGON_CAPACITY={capacity}", source, compiler="arm-none-eabi-gcc")
    assert done.returncode == 0, done.stderr
