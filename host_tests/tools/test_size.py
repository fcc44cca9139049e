# SPDX-License-Identifier: MIT
"""make size: the proof finds float and heap where there is some; the stack bound adds up."""

import shutil
import subprocess

import pytest

import size as size_tool
from fixel import stack

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
    proof = size_tool.prove_pure(library(tmp_path, PURE), CROSS)
    assert proof["passes"], proof["wrong"]
    assert {"memcpy", "__aeabi_ldivmod", "__aeabi_uidivmod"} <= set(proof["undefined"])
    assert proof["linked_symbols"] > 10


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
    proof = size_tool.prove_pure(library(tmp_path, PURE + body + "\n"), CROSS)
    assert not proof["passes"] and proof["wrong"]


@pytest.mark.parametrize("name", ["__aeabi_fadd", "__aeabi_dmul", "__aeabi_i2d", "__aeabi_d2lz",
                                  "__aeabi_cdcmple", "__aeabi_f2d", "__aeabi_ul2f", "__adddf3",
                                  "__floatsisf", "__fixdfsi", "malloc", "_malloc_r", "free", "_sbrk", "printf"])
def test_forbidden_names(name):
    assert size_tool.FORBIDDEN.match(name) and not size_tool.ALLOWED.match(name)


@pytest.mark.parametrize("name", ["memcpy", "__aeabi_lmul", "__aeabi_uidiv", "__aeabi_uldivmod", "__clzsi2",
                                  "__aeabi_llsl", "__gnu_thumb1_case_uqi", "__aeabi_memcpy4", "__divsi3",
                                  "__udivmoddi4", "fxl_fill_band", "fxl_frustum_from_camera", "__aeabi_idiv0"])
def test_names_that_are_not_forbidden(name):
    assert not size_tool.FORBIDDEN.match(name)


def test_stack_adds_up_along_the_calls(tmp_path):
    source = """
    void use(volatile char *p);
    __attribute__((noinline)) int fxl_leaf(int n) { volatile char room[100]; room[n] = 1; return room[0]; }
    __attribute__((noinline)) int fxl_mid(int n) { volatile char room[40]; room[n] = 1; return fxl_leaf(n) + room[1]; }
    int fxl_top(int n) { return fxl_mid(n) + 1; }
    """
    file = library(tmp_path, source, "cortex-m3")
    graph = stack.Graph(stack.disassemble(file, CROSS), stack.read_usage(tmp_path), size_tool.is_public)
    deepest = graph.depth("fxl_top")
    assert deepest.path == ["fxl_top", "fxl_mid", "fxl_leaf"]
    usage = stack.read_usage(tmp_path)
    assert deepest.size == sum(usage[name] for name in deepest.path) >= 148
    assert not graph.recursive


def test_frames_without_su_files_come_from_the_instructions(tmp_path):
    source = "int use(int, int); int fxl_one(int a, int b) { volatile char room[64]; room[a] = 1; return use(a, b) + room[b]; }"
    file = library(tmp_path, source, "cortex-m3")
    usage = stack.read_usage(tmp_path)
    assert stack.Graph(stack.disassemble(file, CROSS), {}, size_tool.is_public).frame("fxl_one") == usage["fxl_one"]


def test_recursion_is_reported(tmp_path):
    source = "int fxl_loop(int n) { return n < 2 ? n : fxl_loop(n - 1) * fxl_loop(n - 2); }"
    graph = stack.Graph(stack.disassemble(library(tmp_path, source), CROSS), {}, size_tool.is_public)
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
    graph = stack.Graph(stack.disassemble(file, CROSS), stack.read_usage(tmp_path), size_tool.is_public)
    deepest = graph.depth("fxl_any")
    assert deepest.path == ["fxl_any", "large"] and deepest.size > 200
    assert graph.unbounded() == []
