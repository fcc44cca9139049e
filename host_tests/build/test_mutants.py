# SPDX-License-Identifier: MIT
"""What fixel mutants takes for a mistake, and what it leaves alone; and the mutants of a small project, of its library and its tools: the same
bytes on one process and on eight, and what is done is kept."""

import contextlib
import fcntl
import json
import shutil
import subprocess
import sys
import threading
import types

import pytest

from conftest import CHECKOUT, environment, LAUNCHER, write_files
from fixel.check import library_mutants, mutate

BUILT_PROGRAMS = ()
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


# --- a small project ----------------------------------------------------------------

ROOM = """#include "attic.h"
int positive(int value)
{
    if (value > 0) {
        return value;
    }
    return 0;
}

int forgotten(int value)
{
    return value + HALF(value);
}
"""
HEADER = """static inline int half(int value)
{
    return value / 2;
}
#define HALF(value) half(value)
int positive(int value);
int forgotten(int value);
"""
UNIT = """#include "attic/attic.h"
int main(void)
{
    return positive(2) != 2 || positive(-2) != 0 || positive(1) != 1;
}
"""
TOOL = """
def positive(value):
    if value > 0:
        return value
    return 0


def forgotten(value):
    return value or 3
"""
TESTS = """
from fixel import attic


def test_positive():
    assert attic.positive(1) == 1 and attic.positive(-2) == 0


def test_forgotten_runs():
    attic.forgotten(1)
"""
CONFTEST = """
import pathlib
import sys
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tools"))
"""
COMPILER = "gcc -std=c11 -g -MMD -MP -Ilib"
MUTANTS = 10        # of each part, or all that there are
ALLOWED = {"FIXEL_KEPT": "", "CI": ""}      # to keep what is done


class Project:
    """A checkout with a build folder, in which make has built a unit test."""

    def __init__(self, root):
        self.root, self.units = root, root / "build/host/unit"
        shutil.copytree(CHECKOUT / "tools", root / "tools", ignore=shutil.ignore_patterns("__pycache__"))
        write_files(root, {"lib/attic/attic.c": ROOM, "lib/attic/attic.h": HEADER, "boards/none": "", "host_tests/unit/test_attic.c": UNIT,
                           "tools/fixel/attic.py": TOOL, "host_tests/tools/test_attic.py": TESTS, "host_tests/conftest.py": CONFTEST,
                           "host_tests/pytest.ini": "[pytest]\n", "host_tests/build/survivors.toml": "", "empty.c": ""})
        (root / ".venv").symlink_to(sys.prefix)
        (root / "Makefile").symlink_to(CHECKOUT / "Makefile")
        self.units.mkdir(parents=True)
        self.compile("host_tests/unit/test_attic.c", "test_attic.o")
        for name in ("test_attic_main.o", "unity.o", "assert.o"):
            self.compile("empty.c", name)
        for name in ("libhelpers.a", "libparts.a"):
            subprocess.run(["ar", "rc", self.units / name], check=True)
        self.compile("lib/attic/attic.c", "attic.o")
        subprocess.run(["gcc", self.units / "test_attic.o", self.units / "attic.o", "-o", self.units / "test_attic"], check=True)

    def compile(self, source, to):
        subprocess.run([*COMPILER.split(), "-c", source, "-o", self.units / to], cwd=self.root, check=True)

    def __call__(self, *options, **changes):
        """(the bytes of both reports, what the command said)."""
        words = ["--seed", "1", "--count", MUTANTS, "--only", "attic", "--build", "build", "--cc", COMPILER, "--units", "build/host/unit"]
        done = subprocess.run([sys.executable, self.root / LAUNCHER.relative_to(CHECKOUT), "mutants", *map(str, [*words, *options])],
                              cwd=self.root, env=environment(**changes), capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
        return [(self.root / f"build/mutants/{part}-seed-1.json").read_bytes() for part in ("lib", "tools")], done.stderr


@pytest.fixture(name="project", scope="module")
def fixture_project(tmp_path_factory):
    return Project(tmp_path_factory.mktemp("project") / "checkout")


def test_one_process_and_eight_give_the_same_bytes_and_shards_that_are_done_are_kept(project):
    one, said = project("--jobs", 1, **ALLOWED)
    assert "0 of them by earlier commands" in said
    assert project("--jobs", 8, FIXEL_KEPT="no")[0] == one
    again, said = project(**ALLOWED)
    assert again == one
    for part, report in zip(("library", "tools"), map(json.loads, one), strict=True):
        shards = len(report["mutants"])
        assert f"mutants of the {part}: {shards} of {shards} shards done, {shards} of them by earlier commands" in said
        results = [each["result"] for each in report["mutants"]]
        assert results.count("killed") == report["killed"] > 2, report
        assert results.count("survived") == report["count"] - report["killed"] > 0, report
        (row,) = json.loads((project.root / f"build/campaigns/{part}-mutants.json").read_text())["kinds"]
        assert row["shard_seconds"] > 0.03, "the time of the process that runs the tests is in it"


def test_other_tests_are_other_shards(project):
    before, _ = project(**ALLOWED)
    unit, tests = project.root / "host_tests/unit/test_attic.c", project.root / "host_tests/tools/test_attic.py"
    unit.write_text(UNIT.replace("positive(1) != 1", "forgotten(6) != 9 || forgotten(0) != 0"))
    tests.write_text(TESTS + "    assert attic.forgotten(0) == 3\n")
    project.compile("host_tests/unit/test_attic.c", "test_attic.o")
    subprocess.run(["gcc", project.units / "test_attic.o", project.units / "attic.o", "-o", project.units / "test_attic"], check=True)
    after, said = project(**ALLOWED)
    assert said.count(", 0 of them by earlier commands") == 2
    assert [json.loads(new)["percent"] > json.loads(old)["percent"] for old, new in zip(before, after, strict=True)] == [True, True]


def test_two_that_begin_at_once_make_a_folder_once_and_neither_waits_for_the_others_end(tmp_path, monkeypatch):
    """Each has its lock before one of them makes the folder."""
    real, both, made = fcntl.flock, threading.Barrier(2), []

    def flock(handle, how):
        real(handle, how)
        if how == fcntl.LOCK_SH:
            both.wait()

    monkeypatch.setattr(library_mutants.fcntl, "flock", flock)
    monkeypatch.setattr(library_mutants, "_held", contextlib.ExitStack())
    with library_mutants._held:
        held = [threading.Thread(target=library_mutants.hold, args=(tmp_path / "library-1", made.append), daemon=True) for _ in range(2)]
        for thread in held:
            thread.start()
        for thread in held:
            thread.join()
        assert len(made) == 1 and (tmp_path / "library-1").is_dir()
