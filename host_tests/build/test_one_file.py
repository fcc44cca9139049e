# SPDX-License-Identifier: MIT
"""fixel.h and fixel.c: any compiler takes them, they have what the library has, and they draw its frames."""

import functools
import re
import shutil
import subprocess

import pytest

from conftest import CHECKOUT, run_cli
from fixel.base import version
from fixel.board import dump
from fixel.check import frame_hashes
from fixel.package import one_file, private_names
from fixel.scene import making
from test_compilers import PICTURE, PROGRAM, WARNINGS, clang_named

BUILT_PROGRAMS = ("boards/host/walk", "host/libfixel.a")
WALK = CHECKOUT / "build" / "boards" / "host"
LINKED = [("gcc", "c11"), ("g++", "c++11"), (clang_named("clang++"), "c++20")]
OTHERS = [(clang_named("clang"), "c11"), ("gcc", "c2x"), ("g++", "c++14"), ("g++", "c++17"), ("g++", "c++20"), (clang_named("clang++"), "c++11")]
SECTIONS = ["-ffunction-sections", "-fdata-sections"]
# A scene of colours, and one each of textures, a depth buffer, a tree and billboards.
SCENES = ("plaza", "room", "gallery", "knot", "grove")


def run(*command, **more):
    done = subprocess.run([str(word) for word in command], text=True, capture_output=True, check=False, **more)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout + done.stderr


@pytest.fixture(scope="module", name="folder")
def fixture_folder(tmp_path_factory):
    """Where the command has written the two files, and nothing else is."""
    folder = tmp_path_factory.mktemp("one")
    done = run_cli("one-file", "--out", folder)
    assert done.returncode == 0, done.stderr
    assert sorted(file.name for file in folder.iterdir()) == ["fixel.c", "fixel.h"]
    return folder


def command(compiler, standard):
    """A compiler with every warning that the library has, as errors. Before C++20 names of members in an initialiser are an
    extension, of which -Wpedantic would tell."""
    extensions = ["-Wno-pedantic", "-Wno-c++20-designator"] if standard.startswith("c++1") else []
    return [compiler, f"-std={standard}", *WARNINGS, "-Wundef", *extensions, *(["-x", "c++"] if "++" in compiler else ["-x", "c"])]


@pytest.fixture(scope="module", name="compiled")
def fixture_compiled(folder):
    """By a compiler and a standard: fixel.c as an object, each function in a section of its own."""
    @functools.cache
    def compiled(compiler, standard):
        out = folder / f"{compiler}-{standard}.o"
        assert run(*command(compiler, standard), "-O1", *SECTIONS, "-c", "fixel.c", "-o", out, cwd=folder) == ""
        return out
    return compiled


@pytest.mark.parametrize("compiler, standard", OTHERS)
def test_every_compiler_takes_it(folder, compiler, standard):
    assert run(*command(compiler, standard), "-fsyntax-only", folder / "fixel.c") == ""


def exported(*files):
    """The functions and objects that others may use."""
    return {line.split()[2] for line in run("nm", "-g", "--defined-only", *files).splitlines() if len(line.split()) == 3}


@pytest.mark.parametrize("compiler, standard", LINKED)
def test_a_program_with_it_draws_the_cube(folder, compiled, compiler, standard, tmp_path):
    language = ["-x", "c++"] if "++" in compiler else ["-x", "c"]
    run(compiler, f"-std={standard}", *language, PROGRAM / "cube.c", PROGRAM / "hosted.c", f"-I{folder}", f"-I{PROGRAM}",
        "-x", "none", compiled(compiler, standard), "-o", tmp_path / "cube")
    assert run(tmp_path / "cube") == PICTURE


@pytest.fixture(scope="module", name="images")
def fixture_images(tmp_path_factory):
    """{scene: (its image, the hashes of its first frames as the library draws them)}."""
    folder, images = tmp_path_factory.mktemp("images"), {}
    for scene in SCENES:
        image = folder / f"{scene}.fxls"
        making.build(str(CHECKOUT / "scenes" / f"{scene}.toml"), str(image))
        images[scene] = (image, drawn(WALK / "walk", image, folder))
    return images


def drawn(program, image, folder):
    """The hashes of the first frames that a walk draws."""
    run(program, image, folder / "frames.fxld", "2")
    return [frame.sha256 for frame in dump.read_dump(folder / "frames.fxld").frames]


@pytest.mark.parametrize("compiler, standard", LINKED)
def test_the_walk_with_it_draws_the_librarys_frames(build, images, compiled, compiler, standard, tmp_path):
    """firmware/walk, which draws every kind of scene, with the one object in place of the library."""
    parts = [file for part in ("boards", "firmware/walk") for file in sorted((WALK / part).rglob("*.o")) if not file.stem.endswith("wires")]
    run("gcc", *parts, compiled(compiler, standard), "-o", tmp_path / "walk")
    for scene, (image, hashes) in images.items():
        assert drawn(tmp_path / "walk", image, tmp_path) == hashes and len(hashes) == 2, scene
    frozen = frame_hashes.load()["plaza"]["frames"][:2]
    assert [found[:frame_hashes.DIGITS] for found in images["plaza"][1]] == frozen


def test_it_exports_what_the_library_exports(build, compiled):
    library = exported(build / "host" / "libfixel.a")
    assert len(library) > 200 and exported(compiled("gcc", "c11")) == library


def test_only_what_is_called_is_linked(folder, compiled, tmp_path):
    """With sections, a program has no more of the library than with the archive, but for what a kernel's sections hold."""
    run("gcc", "-O1", *SECTIONS, f"-I{folder}", f"-I{PROGRAM}", PROGRAM / "cube.c", PROGRAM / "hosted.c", compiled("gcc", "c11"), "-Wl,--gc-sections",
        "-o", tmp_path / "cube")
    linked = {name for name in exported(tmp_path / "cube") if name.startswith("fxl_")}
    assert "fxl_frame_draw" in linked and not linked & {"fxl_crc", "fxl_surfaces_open", "fxl_display_init", "fxl_world_init"}


@pytest.mark.parametrize("core", ["cortex-m0plus", "cortex-m4"])
def test_it_compiles_for_small_cores_and_small(folder, core, tmp_path):
    run("arm-none-eabi-gcc", f"-mcpu={core}", "-mthumb", "-Os", "-std=c11", "-DFXL_SMALL", *WARNINGS, "-ffreestanding", "-c", folder / "fixel.c",
        "-o", tmp_path / "fixel.o")
    assert "fxl_render" in run("arm-none-eabi-nm", tmp_path / "fixel.o")


def test_every_file_of_the_library_is_in_it_once(folder):
    text = (folder / "fixel.c").read_text(encoding="utf-8") + (folder / "fixel.h").read_text(encoding="utf-8")
    titles = re.findall(r"^/\* --- lib/(\S+) \*/$", text, re.MULTILINE)
    assert len(titles) == len(set(titles))
    files = {str(file.relative_to(one_file.LIB)) for file in one_file.LIB.rglob("*.[ch]")
             if "study" not in file.parts and not re.search(r"_(armv6m|armv7m|mve)\.h$", file.name)}
    templates = {"raster/draw_outline_text.h", "draw/target_text.h", "draw/target_flat_text.h", "draw/target_faces_text.h",
                 "draw/sprites_text.h", "draw/surfaces_text.h", "draw/surface_paint_text.h", "draw/surface_depth_text.h", "draw/surface_smooth_text.h", "draw/surface_mapped_text.h", "draw/pixel_row.h",
                 "view/cluster_loop.h", "paint/paint_row.h", "paint/segment_runs.h", "paint/lit_row.h", "paint/small_row.h"}
    unused = {"include/fixel/all.h", "draw/stages.h"}   # included by none of these files
    assert files - set(titles) == templates | unused, "a header that depends on who includes it has no title of its own"
    assert set(titles) <= files and f"Fixel {version.version()}" in text


def test_the_version_is_what_the_header_says(folder, tmp_path):
    assert re.fullmatch(r"\d+\.\d+\.\d+", version.version())
    (tmp_path / "version.c").write_text(f"""#include <fixel.h>
#include <string.h>
int main(void) {{ return strcmp(FXL_VERSION, "{version.version()}") || FXL_VERSION_NUMBER <= 0; }}
""", encoding="utf-8")
    run("gcc", tmp_path / "version.c", f"-I{folder}", "-o", tmp_path / "version")
    run(tmp_path / "version")
    header = tmp_path / "version.h"
    header.write_text(version.HEADER.read_text(encoding="utf-8").replace("MINOR 9", "MINOR 10"), encoding="utf-8")
    assert version.version(header) == version.version().replace(".9.", ".10.")


def test_private_names():
    text = """typedef struct { int x; } pair;
enum { LEFT, RIGHT = 3 };
typedef void painter(void *with);
typedef int (*judge)(int);
struct tree { int clip; };
static const int table[2] = {LEFT, RIGHT};
static int (*const chosen[1])(int) = {0};
/* static int none(void) {} */
static inline __attribute__((always_inline)) int clip(int of) { pair p = {of}; int far; return p.clip + far; }
int fxl_public(int a) { return clip(a); }
"""
    assert private_names.private(text) == {"pair", "LEFT", "RIGHT", "painter", "judge", "tree", "table", "chosen", "clip"}
    changed = private_names.renamed(text, {"clip"}, "here")
    assert "int clip_here(int of)" in changed and "return clip_here(a)" in changed and "p.clip +" in changed


def test_a_name_of_two_sources_is_two_names(folder):
    """The reason for private_names.py: without it the compiler refuses the file."""
    broken = folder / "broken"
    broken.mkdir()
    shutil.copy(folder / "fixel.h", broken)
    text = (folder / "fixel.c").read_text(encoding="utf-8")
    (broken / "fixel.c").write_text(re.sub(r"\b(flat)_target_\w+\b", r"\1", text), encoding="utf-8")
    assert "flat_target_palette" in text
    done = subprocess.run(["gcc", "-fsyntax-only", broken / "fixel.c"], text=True, capture_output=True, check=False)
    assert done.returncode != 0 and "redefinition of" in done.stderr
