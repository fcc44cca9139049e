# SPDX-License-Identifier: MIT
"""make size: the proof finds float and heap where there is some; the stack bound adds up."""

import pathlib
import re
import shutil
import subprocess
import sys

import pytest
from conftest import CHECKOUT

from fixel.bench import linked_size, size, stack
from fixel.board import fleet
from fixel.scene import making

BUILT_PROGRAMS = ("boards/microbit/walk.elf", "boards/mps2-an385/walk.elf", "lib/*")
CROSS = "arm-none-eabi-"
PURE = """
#include <stdint.h>
#include <string.h>
int64_t fxl_divide(int64_t a, int64_t b) { return a / b; }
uint32_t fxl_rest(uint32_t a, uint32_t b) { return a % b; }
void fxl_copy(char *to, const char *from, unsigned n) { memcpy(to, from, n); }
"""

pytestmark = pytest.mark.skipif(not shutil.which(f"{CROSS}gcc"), reason="no cross compiler here")


def library(folder, source, core="cortex-m0"):
    """libfixel.a of one C source for a core, with .su beside it."""
    (folder / "fixel.c").write_text(source)
    subprocess.run([f"{CROSS}gcc", f"-mcpu={core}", "-mthumb", "-mfloat-abi=soft", "-O1", "-ffreestanding",
                    "-fstack-usage", "-ffunction-sections", "-c", "fixel.c", "-o", "fixel.o"],
                   cwd=folder, check=True)
    subprocess.run([f"{CROSS}ar", "rcs", "libfixel.a", "fixel.o"], cwd=folder, check=True)
    return folder / "libfixel.a"


def test_whole_numbers_and_memory_functions_pass(tmp_path):
    proof = size.prove_pure(library(tmp_path, PURE), CROSS)
    assert proof["passes"], proof["wrong"]
    assert {"memcpy", "__aeabi_ldivmod", "__aeabi_uidivmod"} <= set(proof["undefined"])
    assert proof["linked_symbols"] > 10


def test_what_does_not_link_by_itself_fails(tmp_path):
    """All files are linked, and two of them define the same functions."""
    file = library(tmp_path, PURE)
    (tmp_path / "other.o").write_bytes((tmp_path / "fixel.o").read_bytes())
    subprocess.run([f"{CROSS}ar", "rcs", "libfixel.a", "other.o"], cwd=tmp_path, check=True)
    proof = size.prove_pure(file, CROSS)
    assert not proof["passes"] and proof["linked_symbols"] == 0
    assert [sentence.partition(":")[0] for sentence in proof["wrong"]] == ["it does not link by itself"]


@pytest.mark.parametrize("body", [
    "float fxl_bad(float a, float b) { return a * b; }",
    "double fxl_bad(double a, double b) { return a / b; }",
    "int fxl_bad(float a) { return (int)a; }",
    "double fxl_bad(int a) { return a; }",
    "int fxl_bad(double a, double b) { return a < b; }",
    "void *malloc(unsigned); void *fxl_bad(void) { return malloc(4); }",
    "void free(void *); void fxl_bad(void *a) { free(a); }",
    "int printf(const char *, ...); void fxl_bad(void) { printf(\"x\"); }",
    "int elsewhere(void); int fxl_bad(void) { return elsewhere(); }",
])
def test_float_heap_and_strangers_fail(tmp_path, body):
    proof = size.prove_pure(library(tmp_path, PURE + body + "\n"), CROSS)
    assert not proof["passes"] and proof["wrong"]


@pytest.mark.parametrize("name", ["__aeabi_fadd", "__aeabi_dmul", "__aeabi_i2d", "__aeabi_d2lz",
                                  "__aeabi_cdcmple", "__aeabi_f2d", "__aeabi_ul2f", "__adddf3",
                                  "__floatsisf", "__fixdfsi", "malloc", "_malloc_r", "free", "_sbrk", "printf"])
def test_forbidden_names(name):
    assert size.FORBIDDEN.match(name) and not size.ALLOWED.match(name)


@pytest.mark.parametrize("name", ["memcpy", "__aeabi_lmul", "__aeabi_uidiv", "__aeabi_uldivmod", "__clzsi2",
                                  "__aeabi_llsl", "__gnu_thumb1_case_uqi", "__aeabi_memcpy4", "__divsi3",
                                  "__udivmoddi4", "fxl_fill_band", "fxl_frustum_from_sides", "__aeabi_idiv0"])
def test_names_that_are_not_forbidden(name):
    assert not size.FORBIDDEN.match(name)


def test_stack_adds_up_along_the_calls(tmp_path):
    source = """
    void use(volatile char *p);
    __attribute__((noinline)) int fxl_leaf(int n) { volatile char room[100]; room[n] = 1; return room[0]; }
    __attribute__((noinline)) int fxl_mid(int n) { volatile char room[40]; room[n] = 1; return fxl_leaf(n) + room[1]; }
    int fxl_top(int n) { return fxl_mid(n) + 1; }
    """
    file = library(tmp_path, source, "cortex-m3")
    graph = stack.Graph(stack.disassemble(file, CROSS), stack.read_usage(tmp_path), size.is_public)
    deepest = graph.depth("fxl_top")
    assert deepest.path == ["fxl_top", "fxl_mid", "fxl_leaf"]
    usage = stack.read_usage(tmp_path)
    assert deepest.size == sum(usage[name] for name in deepest.path) >= 148
    assert not graph.recursive


def test_frames_without_su_files_come_from_the_instructions(tmp_path):
    source = "int use(int, int); int fxl_one(int a, int b) { volatile char room[64]; room[a] = 1; return use(a, b) + room[b]; }"
    file = library(tmp_path, source, "cortex-m3")
    usage = stack.read_usage(tmp_path)
    assert stack.Graph(stack.disassemble(file, CROSS), {}, size.is_public).frame("fxl_one") == usage["fxl_one"]


def test_recursion_is_reported(tmp_path):
    source = "int fxl_loop(int n) { return n < 2 ? n : fxl_loop(n - 1) * fxl_loop(n - 2); }"
    graph = stack.Graph(stack.disassemble(library(tmp_path, source), CROSS), {}, size.is_public)
    graph.depth("fxl_loop")
    assert graph.unbounded() == ["fxl_loop"]


def test_call_through_a_pointer_counts_as_the_deepest_that_nobody_names(tmp_path):
    source = """
    static int small(int n) { volatile char room[16]; room[n] = 1; return room[0]; }
    static int large(int n) { volatile char room[200]; room[n] = 1; return room[0]; }
    static int (*const table[])(int) = {small, large};
    int fxl_any(int which, int n) { return table[which](n) + 1; }
    """
    file = library(tmp_path, source, "cortex-m3")
    graph = stack.Graph(stack.disassemble(file, CROSS), stack.read_usage(tmp_path), size.is_public)
    deepest = graph.depth("fxl_any")
    assert deepest.path == ["fxl_any", "large"] and deepest.size > 200
    assert graph.unbounded() == []


def graph_of(folder, source, core="cortex-m3"):
    file = library(folder, source, core)
    return stack.Graph(stack.disassemble(file, CROSS), stack.read_usage(folder), size.is_public,
                       stack.addresses_taken(file, CROSS))


def test_a_jump_through_a_register_counts_as_a_call(tmp_path):
    source = """
    static int large(int n) { volatile char room[200]; room[n] = 1; return room[0]; }
    int (*const fxl_table[])(int) = {large};
    __attribute__((optimize("O2"))) int fxl_tail(int (*const *table)(int), int n) { return table[0](n); }
    """
    graph = graph_of(tmp_path, source)
    assert any("bx\tr" in line for line in stack.run([f"{CROSS}objdump", "-d", str(tmp_path / "libfixel.a")]).splitlines())
    assert graph.depth("fxl_tail").path == ["fxl_tail", "large"] and graph.depth("fxl_tail").size >= 200


@pytest.mark.parametrize("core", ["cortex-m0", "cortex-m3"])
def test_a_function_that_is_called_by_name_and_by_pointer_counts_for_both(tmp_path, core):
    source = """
    __attribute__((noinline)) int fxl_both(int n) { volatile char room[300]; room[n] = 1; return room[0]; }
    int (*const fxl_table[])(int) = {fxl_both};
    int fxl_named(int n) { return fxl_both(n) + 1; }
    int fxl_pointed(int (*const *table)(int), int n) { return table[0](n) + 1; }
    """
    graph = graph_of(tmp_path, source, core)
    assert graph.depth("fxl_pointed").path == ["fxl_pointed", "fxl_both"]


def test_a_jump_to_a_literal_is_followed():
    functions = stack.parse_disassembly(
        "00000010 <reset>:\n"
        "      10:\t4801      \tldr\tr0, [pc, #4]\t@ (18 <reset+0x8>)\n"
        "      12:\t4700      \tbx\tr0\n"
        "      18:\t00000021 \t.word\t0x00000021\n"
        "\n"
        "00000020 <start>:\n"
        "      20:\tb510      \tpush\t{r4, lr}\n"
        "      22:\tbc08      \tpop\t{r3}\n"
        "      24:\t4718      \tbx\tr3\n")
    assert functions["reset"].calls == {"start"} and functions["reset"].indirect == 0
    assert functions["start"].indirect == 0


def test_a_pointer_behind_a_pointer_makes_the_figure_the_least(tmp_path):
    source = """
    static int inner(int n) { volatile char room[200]; room[n] = 1; return room[0]; }
    int (*const fxl_inner[])(int) = {inner};
    static int outer(int n) { return fxl_inner[n](n) + 2; }
    int (*const fxl_outer[])(int) = {outer};
    int fxl_any(int (*const *table)(int), int n) { return table[0](n) + 1; }
    """
    graph = graph_of(tmp_path, source.replace("fxl_inner[n](n)", "((int (*const volatile *)(int))fxl_inner)[n](n)"))
    each = {"stack": graph.depth("fxl_any").size, "not_bounded": graph.unbounded()}
    assert each["not_bounded"] and size.stack_text(each).startswith("at least")
    assert size.stack_text({"stack": 8, "stack_measured": 900, "not_bounded": ["outer"]}) == "at least 900"
    assert size.stack_text({"stack": 8, "not_bounded": []}) == "8"


def test_the_firmwares_figure_is_not_below_what_a_run_shows(build):
    elf = build / "boards" / "mps2-an385" / "walk.elf"
    found = size.measure_firmware(elf, CROSS, [elf.parent, *build.glob("core/cpu-cortex-m3*")])
    found["stack_measured"] = size.measure_run("mps2-an385", elf, size.SCENES[:1])
    assert found["stack_measured"] > 500 and len(found["stack_path"]) > 4
    figure = size.stack_text(found)
    assert int(figure.removeprefix("at least ").replace(",", "")) >= found["stack_measured"]


@pytest.mark.parametrize("row, beams, board, column", [("surfaces, lit ones or with holes", False, "mps2-an385", 2),
                                                       ("surfaces and light beams", True, "mps2-an385", 2), ("surfaces and light beams", True, "microbit", 1)])
def test_the_stack_with_a_depth_buffer_is_what_its_page_says(build, tmp_path, row, beams, board, column):
    """The deepest scene of make costs."""
    text = (CHECKOUT / "bench/costs_deepest.toml").read_text(encoding="utf-8")
    scene = tmp_path / "scene.toml"
    scene.write_text(text if beams else re.sub(r"\[\[beams\]\]\n(.+ = .+\n)+", "", text), encoding="utf-8")
    made = tmp_path / "scene.fxls"
    making.build(scene, made, frames=size.SCENE_FRAMES)
    seen = fleet.stack_seen(board, build / f"boards/{board}/walk.elf", made, tmp_path)
    page = (CHECKOUT / "docs/extras/depth.md").read_text(encoding="utf-8")
    stated = float(re.search(rf"^\| {row} \| ([\d.]+) KB \| ([\d.]+) KB \|$", page, re.M)[column])
    assert seen / 1000 <= stated < seen / 1000 + 0.15


@pytest.mark.parametrize("core", ["cortex-m0", "cortex-m3"])
def test_a_flat_program_in_rgb565_links_at_most_3_kib_more(build, tmp_path, core):
    """At -Os, which is where a byte counts. rgb565 3.7b."""
    texts = [linked_size.first_program(), linked_size.in_rgb565(linked_size.first_program())]
    programs = [str(tmp_path / f"{name}.c") for name in ("palette", "rgb565")]
    for program, text in zip(programs, texts, strict=True):
        pathlib.Path(program).write_text(text, encoding="utf-8")
    root = build.parent
    library = sorted(str(each.relative_to(root)) for kind in "cS" for each in (root / "lib").glob(f"*/*.{kind}"))
    said = subprocess.run([sys.executable, "lib/needs.py", *library, "--", *programs], cwd=root, check=True, text=True, capture_output=True)
    needed = {each for line in said.stdout.splitlines() if line.split(" ")[0].removeprefix("LIB_NEEDS.") in programs for each in line.split(":=")[1].split()}
    objects = []
    for source in (each for each in library if each[4:-2] in needed):
        objects.append(tmp_path / f"{source[4:].replace('/', '_')}.o")
        subprocess.run([f"{CROSS}gcc", f"-mcpu={core}", "-mthumb", "-masm-syntax-unified", "-std=c11", "-Os", "-ffreestanding",
                        "-ffunction-sections", "-fdata-sections", "-Ilib/include", "-c", source, "-o", objects[-1]], cwd=root, check=True)
    archive = tmp_path / "libfixel.a"
    subprocess.run([f"{CROSS}ar", "rcs", archive, *objects], check=True)
    palette, wide = (linked_size.measure(core, archive, CROSS, program=text)["linked_flash"] for text in texts)
    more = wide - palette
    print(f"{core} at -Os: a flat program in a palette links {palette:,} bytes, in RGB565 {more:,} more")
    assert 0 < more <= 3 * 1024


def test_the_first_program_links_a_part_of_the_library(build):
    """world 1.4."""
    subprocess.run(["make", "lib", "CORE=cortex-m3"], cwd=build.parent, check=True, capture_output=True)
    file = build / "lib" / "cortex-m3" / "libfixel.a"
    linked, whole = linked_size.measure("cortex-m3", file, CROSS), size.archive_size(file, CROSS)
    assert 5_000 < linked["linked_flash"] < whole["flash"] / 2
    assert "fxl_render(&renderer" in linked_size.first_program()
    said = re.search(r"program below links ([\d.]+) KB of library code on a Cortex-M3", (build.parent / "README.md").read_text(encoding="utf-8"))
    assert abs(float(said.group(1)) * 1000 - linked["linked_flash"]) < 500, linked


@pytest.mark.parametrize("passes, wrong, last", [
    (True, [], "no float, no heap: linked alone for cortex-m0; asks only for memcpy"),
    (False, ["linked, it contains malloc"], "FAIL: the library for cortex-m0 is not free of float and heap:\n  linked, it contains malloc")])
def test_what_is_printed(capsys, passes, wrong, last):
    firmware = {"flash": 5000, "ram": 300, "stack": 100, "stack_measured": 120, "stack_reserved": 2048,
                "not_bounded": ["f calls a pointer"], "stack_path": ["main", "f"]}
    library = {"core": "cortex-m3", "linked_flash": 4000, "linked_ram": 0, "linked_helpers": 77, "stack": 64,
               "not_bounded": [], "stack_path": ["g"]}
    proof = {"passes": passes, "core": "cortex-m0", "undefined": ["memcpy"], "wrong": wrong}
    size.print_sizes({"board": "b", "firmware": [firmware], "library": [library], "proof": proof})
    said = capsys.readouterr().out
    rows = {" ".join(line.split()) for line in said.splitlines()}
    assert {"firmware b 5,000 300 at least 120 120 2,048", "library cortex-m3 4,000 0 64 - -"} <= rows
    assert "(77 bytes)" in said
    assert said.endswith(f"deepest, b: main > f\n  not bounded: f calls a pointer\ndeepest, cortex-m3: g\n{last}\n")


def test_make_size_builds_one_core(build):
    """Right after the first program: the library of a Cortex-M3 alone. CORE=all is all five, of which two share one."""
    def cores(*settings):
        done = subprocess.run(["make", "-n", "MAKE=:", "size", *settings], cwd=build.parent, check=True, text=True, capture_output=True)
        return re.search(r"for core in ([^;]*);", done.stdout)[1].split()
    assert cores() == ["cortex-m3"] and cores("CORE=m0") == ["cortex-m0"]
    assert cores("CORE=all") == ["cortex-m0", "cortex-m3", "cortex-m33", "cortex-m4"]
