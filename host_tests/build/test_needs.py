# SPDX-License-Identifier: MIT
"""Which sources of the library make compiles for a program: those that it needs, and few others."""

import subprocess
import sys

import pytest

from conftest import CHECKOUT

HEADER = 'extern "C" {\nvoid fxl_one(void);\nvoid fxl_two(void);\n%s}\n'
KINDS = {
    "a call": ({"lib/a/one.c": "void fxl_one(void) { }"}, "void main(void) { fxl_one(); }"),
    "a record": ({"lib/a/one.c": "const int fxl_one[2][3] = {0};"}, "void *p = &fxl_one;"),
    "a call of a call": ({"lib/a/one.c": "void fxl_one(void) { fxl_three(); }", "lib/a/three.c": "int fxl_three(int x)\n{\n}"},
                         "void main(void) { fxl_one(); }"),
    "a header's code": ({"lib/a/one.c": "void fxl_one(void) { }"}, '#include "code.h"\n'),
    "a header's macro": ({"lib/a/one.c": "void fxl_one(void) { }"}, '#include "macro.h"\n'),
    "code of a header, for a name": ({"lib/a/one.c": '#define THIS fxl_one\n#include "../include/this.h"\n'}, "int main = fxl_one;"),
    "in place but for a small library": ({"lib/a/one.c": '#define FXL_HERE\n#include "../include/place.h"\n'}, '#include "code.h"\n'),
    "assembly": ({"lib/a/one.S": "    .global fxl_one\nfxl_one:\n    b fxl_three\n", "lib/a/three.c": "int fxl_three(int x)\n{\n}"},
                 "void main(void) { fxl_one(); }")}
HEADERS = {"code.h": HEADER % "static inline void f(void) { fxl_one(); }\n", "macro.h": HEADER % "#define ONE() \\\n    fxl_one()\n",
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
    found = needs(tmp_path, {"lib/a/two.c": "void fxl_two(void) { }"}, '#include "code.h"\n/* fxl_two(); */ // fxl_two();\n')
    assert found == {"main.c": set()}


def test_a_record_is_chosen_by_its_name(tmp_path):
    found = needs(tmp_path, {"lib/a/one.c": "const method fxl_one = {fxl_two};", "lib/a/two.c": "void fxl_two(void) { }"}, "")
    assert found == {"main.c": set(), "fxl_one": {"a/one", "a/two"}}


def test_a_walk_is_built_without_what_it_never_calls(tmp_path):
    done = subprocess.run(["make", "-n", "V=1", f"BUILD={tmp_path}", f"{tmp_path}/boards/mps2-an385/walk.elf"], cwd=CHECKOUT,
                          capture_output=True, text=True, check=True)
    assert "/render.c" in done.stdout and "/offsets.c" in done.stdout and "/fill_rows_armv7m.S" in done.stdout
    for name in ("slide.c", "clip_once.c", "pages.c", "world_change.c", "fill_rows_armv6m.S"):
        assert f"/{name}" not in done.stdout
