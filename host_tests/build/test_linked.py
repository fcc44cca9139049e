# SPDX-License-Identifier: MIT
"""What a program does not name it does not link, and make compiles of the library what the program needs and little else (lib/needs.py)."""

import glob
import os
import re
import subprocess
import sys

import pytest

from conftest import CHECKOUT

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "host/judge", "host/libfixel.a", "host/libfixel_study.a")
PROGRAM = """
#include <fixel.h>
int main(void)
{
    static fxl_scene scene;
    return NAME != FXL_E_ARGUMENT;
}
"""
MORE = {"fxl_bsp_check", "fxl_beam_check", "fxl_beams_fit", "fxl_cluster_check", "fxl_clusters", "fxl_list_clusters"}

CROSS = os.environ.get("CROSS", "arm-none-eabi-")
UNDEFINED, DEFINED = " U ", re.compile(r" [BDRTVW] ")


def symbols(archive, kind):
    """The names of an archive that nm gives this letter."""
    lines = subprocess.run(["nm", archive], check=True, text=True, capture_output=True).stdout.splitlines()
    return {line.split()[-1] for line in lines if re.search(kind, line)}


def test_the_library_needs_nothing_of_the_study(build):
    library, study = build / "host" / "libfixel.a", build / "host" / "libfixel_study.a"
    ours, theirs = symbols(library, DEFINED), symbols(study, DEFINED)
    assert {"fxl_clipper_view", "fxl_line_by_codes", "fxl_split_edge", "fxl_box_planes", "fxl_plane_from_points"} <= ours
    assert {"fxl_clipper_near", "fxl_clipper_world", "fxl_palette_spans", "fxl_palette_box"} <= theirs
    assert not ours & theirs and not symbols(library, UNDEFINED) & theirs


SHADERS = {"fxl_renderer_set_shader", "fxl_submit_coloured_face", "fxl_light_brightness"}


@pytest.mark.parametrize("call, linked", [("fxl_scene_check(&scene, NULL)", set()),
                                          ("fxl_scene_check_all(&scene, NULL)", MORE),
                                          ("fxl_scene_open(NULL, 0, NULL, NULL)", MORE)])
def test_a_scene_without_tree_beams_and_clusters_links_nothing_of_them(build, tmp_path, call, linked):
    source, program = tmp_path / "check.c", tmp_path / "check"
    source.write_text("#include <stddef.h>\n" + PROGRAM.replace("NAME", call), encoding="utf-8")
    subprocess.run(["gcc", "-std=c11", "-I", build.parent / "lib" / "include", source, build / "host" / "libfixel.a",
                    "-o", program], check=True)
    subprocess.run([program], check=True)
    names = subprocess.run(["nm", program], check=True, text=True, capture_output=True).stdout.split()
    assert MORE & set(names) == linked


def test_a_renderer_without_a_world_and_light_links_nothing_of_them(build, tmp_path):
    """light 5.3."""
    source, program = tmp_path / "draw.c", tmp_path / "draw"
    call = "fxl_frame_begin(NULL, NULL) + fxl_renderer_init_with(NULL, &scene, NULL, NULL)"
    for named, text in ((False, call), (True, call + " + fxl_attach_light(NULL, NULL, NULL)")):
        source.write_text("#include <stddef.h>\n#include <fixel/light.h>\n" + PROGRAM.replace("NAME", text),
                          encoding="utf-8")
        subprocess.run(["gcc", "-std=c11", "-I", build.parent / "lib" / "include", source,
                        build / "host" / "libfixel.a", "-o", program], check=True)
        names = subprocess.run(["nm", program], check=True, text=True, capture_output=True).stdout.split()
        assert bool(SHADERS & set(names)) == named
        assert not any(name.startswith("fxl_world") for name in names)


@pytest.mark.parametrize("call, other", [
    ("fxl_attach_surfaces(NULL, NULL, NULL, FXL_SURFACES_OF(fxl_palette_depth_16)) + "
     "fxl_renderer_choose(NULL, &(fxl_config){.target = &fxl_palette_depth_16})", ("fxl_billboard", "fxl_sprite")),
    ("fxl_attach_billboards(NULL, NULL, NULL, FXL_SPRITES_OF(fxl_palette))", ("fxl_depth", "fxl_surface")),
    ("fxl_scene_open(NULL, 0, NULL, NULL) + fxl_scene_check_all(&scene, NULL)", ("fxl_surfaces_open", "fxl_surfaces_check"))])
def test_billboards_surfaces_and_depth_do_not_link_each_other(build, tmp_path, call, other):
    """billboards 4.4, surfaces 6.4, formats 1.12h."""
    source, program = tmp_path / "draw.c", tmp_path / "draw"
    text = "fxl_frame_begin(NULL, NULL) + fxl_renderer_init_with(NULL, &scene, NULL, NULL) + " + call
    source.write_text("#include <stddef.h>\n#include <fixel/all.h>\n" + PROGRAM.replace("NAME", text), encoding="utf-8")
    subprocess.run(["gcc", "-std=c11", "-I", build.parent / "lib" / "include", source, build / "host" / "libfixel.a", "-o",
                    program], check=True)
    names = subprocess.run(["nm", program], check=True, text=True, capture_output=True).stdout.split()
    assert not [name for name in names if name.startswith(other)]


@pytest.mark.parametrize("explains", [False, True])
def test_sentences_are_linked_only_where_they_are_asked_for(build, tmp_path, explains):
    source, program = tmp_path / "draw.c", tmp_path / "draw"
    call = "fxl_renderer_init(NULL, &scene, NULL, NULL, 0) + fxl_render(NULL, NULL, NULL, 0)"
    more = " + (fxl_renderer_explain(NULL, &scene, NULL, NULL, 0) != NULL)" if explains else ""
    source.write_text("#include <stddef.h>\n" + PROGRAM.replace("NAME", call + more), encoding="utf-8")
    subprocess.run(["gcc", "-std=c11", "-I", build.parent / "lib" / "include", source, build / "host" / "libfixel.a", "-o",
                    program], check=True)
    names = subprocess.run(["nm", program], check=True, text=True, capture_output=True).stdout.split()
    assert ("fxl_renderer_explain" in names) == explains and (b"config->fov must" in program.read_bytes()) == explains


def test_a_list_of_sentences_is_linked_by_itself(build, tmp_path):
    """The archive for users has sections, which its linker drops where nothing names them."""
    source, program, library = tmp_path / "draw.c", tmp_path / "draw", build.parent / "lib"
    source.write_text("#include <stddef.h>\n#include <fixel/light.h>\n"
                      + PROGRAM.replace("NAME", "fxl_explain(fxl_light_reasons, FXL_OK) != NULL"), encoding="utf-8")
    subprocess.run(["gcc", "-std=c11", "-ffunction-sections", "-fdata-sections", "-Wl,--gc-sections", "-I",
                    library / "include", source, library / "scene" / "reasons.c", library / "draw" / "reasons_draw.c",
                    "-o", program], check=True)
    text = program.read_bytes()
    assert b"settings->levels must" in text and b"billboard" not in text and b"cluster" not in text


def test_an_int_of_16_bits_is_refused(build, tmp_path):
    """There is no such compiler here: int stands for short, once the system's headers are read."""
    source = tmp_path / "short.c"
    source.write_text("#include <stdbool.h>\n#include <stddef.h>\n#include <stdint.h>\n#include <string.h>\n"
                      "#ifdef SHORT\n#define int short\n#endif\n#include \"math/arith.h\"\n", encoding="utf-8")
    library = build.parent / "lib"
    command = ["gcc", "-std=c11", "-fsyntax-only", "-I", library / "include", "-I", library, source]
    subprocess.run(command, check=True)
    done = subprocess.run([*command, "-DSHORT"], text=True, capture_output=True, check=False)
    assert done.returncode != 0 and "needs an int of at least 32 bits" in done.stderr


# --- lib/needs.py -------------------------------------------------------------------

HEADER = 'extern "C" {\nvoid fxl_one(void);\nvoid fxl_two(void);\n%s}\n'
KINDS = {
    "a call": ({"lib/a/one.c": "void fxl_one(void) { }"}, "void main(void) { fxl_one(); }"),
    "a record": ({"lib/a/one.c": "const int fxl_one[2][3] = {0};"}, "void *p = &fxl_one;"),
    "a call of a call": ({"lib/a/one.c": "void fxl_one(void) { fxl_three(); }", "lib/a/three.c": "int fxl_three(int x)\n{\n}"},
                         "void main(void) { fxl_one(); }"),
    "a header's code": ({"lib/a/one.c": "void fxl_one(void) { }"}, '#include "code.h"\nvoid main(void) { f(); }'),
    "a header's macro": ({"lib/a/one.c": "void fxl_one(void) { }"}, '#include "macro.h"\nvoid main(void) { ONE(); }'),
    "a header's function, named by its macro": ({"lib/a/one.c": "void fxl_one(void) { }"}, '#include "code.h"\n#include "macro.h"\nvoid main(void) { G(); }'),
    "a header's record": ({"lib/a/one.c": "void fxl_one(void) { }"}, '#include "record.h"\n'),
    "code of a header, for a name": ({"lib/a/one.c": '#define THIS fxl_one\n#include "../include/this.h"\n'}, "int main = fxl_one;"),
    "in place but for a small library": ({"lib/a/one.c": '#define FXL_HERE\n#include "../include/place.h"\n'}, "int main = fxl_one;"),
    "assembly": ({"lib/a/one.S": "    .global fxl_one\nfxl_one:\n    b fxl_three\n", "lib/a/three.c": "int fxl_three(int x)\n{\n}"},
                 "void main(void) { fxl_one(); }")}
HEADERS = {"code.h": HEADER % "static inline void f(void) { fxl_one(); }\n", "macro.h": HEADER % "#define ONE() \\\n    fxl_one()\n#define G() f()\n",
           "record.h": HEADER % "static void (*const p[])(void) = {fxl_one};\n",
           "this.h": "const int THIS = {3};\n", "place.h": "FXL_IN_PLACE void fxl_one(int x)\n#if SMALL\n;\n#else\n{ }\n#endif\n"}


def needs(folder, library, program):
    """What lib/needs.py writes of a library and a program, as {source or record: names}."""
    for name, text in [*library.items(), ("main.c", program), *((f"lib/include/{name}", text) for name, text in HEADERS.items())]:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    done = subprocess.run([sys.executable, CHECKOUT / "lib" / "needs.py", *library, "--", "main.c"], cwd=folder,
                          capture_output=True, text=True, check=True)
    lines = (line.removeprefix("LIB_NEEDS.").split(" :=") for line in done.stdout.splitlines())
    return {source: set(names.split()) for source, names in lines}


@pytest.mark.parametrize("kind", KINDS)
def test_a_program_needs(tmp_path, kind):
    library, program = KINDS[kind]
    found = needs(tmp_path, {**library, "lib/a/two.c": "void fxl_two(void) { }"}, program)
    assert found["main.c"] == {name.removeprefix("lib/").rpartition(".")[0] for name in library}


def test_a_unit_test_needs_the_helpers_whose_headers_it_includes_and_what_they_need(tmp_path):
    unit = {"lib/a/one.c": "void fxl_one(void) { }", "host_tests/unit/helper.h": "void helper(void);\n",
            "host_tests/unit/helper.c": '#include "helper.h"\nvoid helper(void) { fxl_one(); }', "host_tests/unit/other.c": ""}
    for name, text in {**unit, "host_tests/unit/test_it.c": '#include "helper.h"\n'}.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    done = subprocess.run([sys.executable, CHECKOUT / "lib" / "needs.py", "lib/a/one.c", "--", "host_tests/unit/test_it.c"],
                          cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[:2] == ["LIB_NEEDS.host_tests/unit/test_it.c := a/one",
                                            "UNIT_HELPERS.host_tests/unit/test_it.c := helper"]


def test_a_name_that_a_macro_makes_of_its_own_argument_may_be_any(tmp_path):
    texts = {"lib/a/one.c": "const int fxl_one_rows = 1;", "lib/a/two.c": "const int fxl_two = 2;"}
    program = ('#define ROWS_OF(target) (&target##_rows)\n#define BOTH(target) ROWS_OF(target), 0\n'
               "const void *p[] = {BOTH(fxl_one)}; /* of fxl_two nothing */")
    assert needs(tmp_path, texts, program)["main.c"] == {"a/one"}


def test_comments_and_declarations_need_nothing(tmp_path):
    found = needs(tmp_path, {"lib/a/two.c": "void fxl_two(void) { }"}, '#include "code.h"\n/* fxl_two(); */ // fxl_two();\nchar *s = "fxl_two";')
    assert found == {"main.c": set()}


@pytest.mark.parametrize("header", ["code.h", "macro.h"])
def test_a_headers_functions_and_macros_that_a_program_does_not_name_need_nothing(tmp_path, header):
    assert needs(tmp_path, {"lib/a/one.c": "void fxl_one(void) { }"}, f'#include "{header}"\n') == {"main.c": set()}


def test_a_record_is_chosen_by_its_name(tmp_path):
    found = needs(tmp_path, {"lib/a/one.c": "const method fxl_one = {fxl_two};", "lib/a/two.c": "void fxl_two(void) { }"}, "")
    assert found == {"main.c": set(), "fxl_one": {"a/one", "a/two"}}


def build_of_the_walk(folder, *words):
    """What make would do."""
    done = subprocess.run(["make", "-n", "V=1", *words, f"BUILD={folder}", f"{folder}/boards/mps2-an385/walk.elf"], cwd=CHECKOUT,
                          capture_output=True, text=True, check=True)
    return done.stdout


def test_a_walk_is_built_without_what_it_never_calls(tmp_path):
    said = build_of_the_walk(tmp_path)
    assert "/render.c" in said and "/offsets.c" in said and "/fill_rows_armv7m.S" in said
    for name in ("slide.c", "clip_once.c", "pages.c", "world_change.c", "fill_rows_armv6m.S", "fill_compact_armv7m.S", "depth_runs.c"):
        assert f"/{name}" not in said


def test_a_compiler_is_asked_once_which_sources_have_no_text(tmp_path):
    """An answer that is kept is believed, though it be wrong: but no part of one, none of other flags, and none once a header is newer."""
    build_of_the_walk(tmp_path)
    kept, = tmp_path.glob("lib_conditions-cpu-cortex-m3_*unaligned-access")
    told = kept.read_text(encoding="ascii")
    wrong = told.replace("raster/fill_rows_armv7m ", "")
    for text, is_believed in ((wrong, True), (wrong.replace("-O2", "-O1"), False), (wrong[:-5], False)):
        kept.write_text(text, encoding="ascii")
        assert ("/fill_rows_armv7m.S" not in build_of_the_walk(tmp_path)) == is_believed
        assert kept.read_text(encoding="ascii") == (text if is_believed else told)
    kept.write_text(wrong, encoding="ascii")
    os.utime(tmp_path / "lib_conditions.mk", (0, 0))
    assert "/fill_rows_armv7m.S" in build_of_the_walk(tmp_path, "-o", tmp_path / "lib_conditions.mk")


# A core of each kind of kernels; the last one has vectors.
CORES = {"m0": "-mcpu=cortex-m0 -O2", "m3": "-mcpu=cortex-m3 -O2", "m3, compact": "-mcpu=cortex-m3 -Os", "m3, small": "-mcpu=cortex-m3 -Os -DFXL_SMALL",
         "m55": "-mcpu=cortex-m55 -mfloat-abi=hard -O2"}


@pytest.mark.parametrize("core", CORES)
def test_what_a_core_has_no_text_of_is_not_compiled(tmp_path, core):
    """Of the sources whose lines all stand under conditions: those that lib/needs.py finds empty, and no others, make an object without a name."""
    sources = {os.path.splitext(name)[0].removeprefix("lib/"): name for name in sorted(glob.glob("lib/*/*.[cS]", root_dir=CHECKOUT))}
    subprocess.run([sys.executable, "lib/needs.py", "--conditions", tmp_path / "x", *sources.values()], cwd=CHECKOUT, check=True)
    compiler = [f"{CROSS}gcc", "-mthumb", "-masm-syntax-unified", *CORES[core].split(), "-w", "-I.", "-Ilib/include"]
    printed = "".join(subprocess.run([*compiler, "-E", "-P", f"{tmp_path}/x{ending}"], cwd=CHECKOUT, text=True, capture_output=True, check=True).stdout
                      for ending in (".c", ".S"))
    full = set(re.findall(r"^fxl_text_of (\S+)$", printed, re.MULTILINE))
    conditional = set((tmp_path / "x.mk").read_text(encoding="utf-8").split(" := ")[1].split())
    assert {"x.c", "x.S"} < full and conditional - full and full - {"x.c", "x.S"} < conditional
    for name in conditional - {"draw/offsets"}:         # assertions alone
        subprocess.run([*compiler, "-c", sources[name], "-o", tmp_path / "x.o"], cwd=CHECKOUT, check=True)
        names = subprocess.run([f"{CROSS}nm", "--defined-only", tmp_path / "x.o"], text=True, capture_output=True, check=True).stdout
        assert (name in full) == (" T fxl_" in names), f"{name}: {names}"
