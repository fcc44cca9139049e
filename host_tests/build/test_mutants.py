# SPDX-License-Identifier: MIT
"""What fixel mutants takes for a mistake, and what it leaves alone."""

import types

import pytest
from conftest import CHECKOUT

from fixel.check import library_mutants, mutate

CODE = """#include "a.h"
#define ONE (1 + 1)
static const int table[2] = {1, 2};
/* a < b && 1 */
static int f(int a, int *b)
{
    const char text[] = "a + 1";
    FXL_ASSERT(a < 4 &&
               a > 2);
    %s
}
"""


def becomes(statement):
    """{(what, what it becomes)} of the mutants of a statement of a function."""
    return {(mutant.was, mutant.becomes) for mutant in mutate.mutants("a.c", CODE % statement)}


@pytest.mark.parametrize("statement, expected", [
    ("return a < *b;", {("<", "<="), ("<", ">=")}),
    ("return a == *b;", {("==", "!=")}),
    ("return a && !*b;", {("&&", "||"), ("!", "")}),
    ("return a + 3u;", {("+", "-"), ("3u", "4u"), ("3u", "2u")}),
    ("return -a;", set()),
    ("return a << *b & a;", {("<<", ">>"), ("&", "|")}),
    ("return true;", {("true", "false")}),
    ("g(&a);", {("g(&a);", "(void)0;")}),
    ("a = *b;", {("a = *b;", "(void)0;")}),
    ("int c = *b;", set()),
    ("return a / 'b';", {("/", "*")}),
    ("return a->b;", set()),
    ("const int64_t c[3], *d, e[2][4];", {("3", "2"), ("2", "1"), ("4", "3")}),
    ("b[3] = *b;", {("3", "4"), ("3", "2"), ("b[3] = *b;", "(void)0;")}),
    ("int c[3] = {1, *b};", {("3", "2"), ("1", "2"), ("1", "0")}),
    ("return !FXL_IS_SMALL && a;", {("&&", "||")}),
])
def test_mistakes(statement, expected):
    assert becomes(statement) == expected


def test_a_mutant_changes_its_place_alone():
    text = CODE % "return a < *b;"
    for mutant in mutate.mutants("a.c", text):
        assert mutant.apply(text) == text.replace("return a < *b;", f"return a {mutant.becomes} *b;")
        assert str(mutant) == f"a.c:10: '<' becomes '{mutant.becomes}'"
    assert {mutant.line for mutant in mutate.mutants("a.c", f"\n{text}")} == {11}


def test_what_a_header_goes_into(tmp_path):
    notes = tmp_path / "a.d"
    notes.write_text("a.o: tests/a.c \\\n lib/draw/../math/root.h lib/b.h\n\nlib/c.h:\n", encoding="utf-8")
    for name, expected in {"lib/math/root.h": True, "lib/b.h": True, "tests/a.c": True, "lib/c.h": False,
                           "lib/draw/root.h": False, "root.h": False}.items():
        assert mutate.includes(notes, tmp_path, name) == expected


def test_only_tests_that_include_a_mutated_header_are_built_anew(tmp_path):
    def unit_test(name, header):
        (tmp_path / f"{name}.d").write_text(f"{name}.o: {name}.c {header}\n", encoding="utf-8")
        return library_mutants.Test(tmp_path / name, (f"{name}.o", "unity.o"), (), f"{name}.c")
    ran = []
    tree = types.SimpleNamespace(folder=tmp_path / "tree", compiler=["cc"],
                                 run=lambda words: ran.append(words[:3]) or ("no" if "broken.c" in words else None))
    tree.folder.mkdir()
    tests = [unit_test("one", "lib/math/root.h"), unit_test("two", "lib/math/root.c"), unit_test("broken", "lib/math/root.h")]
    tests.append(library_mutants.Test(tmp_path / "replay", ("replay.o",)))
    for file, built in (("lib/math/root.h", {tests[0]: tmp_path / "tree/tests/one"}), ("lib/math/root.c", {})):
        assert library_mutants.build_including(tree, tests, file) == built
    new = tmp_path / "tree/tests/one.o"
    assert ran == [["cc", "-c", "one.c"], ["cc", new, "unity.o"], ["cc", "-c", "broken.c"]]


def test_the_tests_that_are_left_out_or_come_last_are_there():
    names = library_mutants.SLOW + library_mutants.LAST
    assert names and all((CHECKOUT / library_mutants.UNITS / f"{name}.c").is_file() for name in names)
