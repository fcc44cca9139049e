# SPDX-License-Identifier: MIT
"""What make coverage counts: of the views of llvm-cov, of programs that fail, and what has a reason for not being reached."""

import sys
import types

import pytest

from conftest import CHECKOUT
from fixel.base.errors import ToolError
from fixel.check import coverage, coverage_builds

BUILT_PROGRAMS = ()
SOURCE = """/* A file. */
static int of_room(int a, int b)
{
    if (a > 0 &&
        (b < 3 || ALWAYS)) {
        return 1;
    }
    return a > 0 ? 2 : 3;
}
"""
# What llvm-cov prints of it, as it is in a.c and as it is in b.c.
SHOWN = """{name}:
    1|       |/* A file. */
  ------------------
  | a.c:of_room:
  |    2|      4|static int of_room(int a, int b)
  |    4|      4|    if (a > 0 &&
  |  ------------------
  |  |  Branch (4:9): [True: 2, False: 2]
  |  ------------------
  |    5|      2|        (b < 3 || ALWAYS)) {{
  |  ------------------
  |  |  Branch (5:10): [True: {first}, False: 1.2k]
  |  |  Branch (5:19): [Folded - Ignored]
  |  ------------------
  |  |---> MC/DC Decision Region (4:9) to (5:26)
  |  |
  |  |  Number of Conditions: 3
  |  |     Condition C1 --> (4:9)
  |  |     Condition C2 --> (5:10)
  |  |     Condition C3 --> (5:19)
  |  |
  |  |  C1-Pair: covered: (1,2)
  |  |  C2-Pair: {second}
  |  |  C3-Pair: constant folded
  |  |  MC/DC Coverage for Decision: 50.00%
  |  |
  |  ------------------
  |    6|      0|        return 1;
  |    8|      2|    return a > 0 ? 2 : 3;
  |  ------------------
  |  |  Branch (8:12): [True: 0, False: 2]
  |  ------------------
"""


@pytest.fixture(name="root")
def fixture_root(tmp_path):
    """A checkout with one file."""
    (tmp_path / "lib" / "math").mkdir(parents=True)
    (tmp_path / "lib" / "math" / "a.h").write_text(SOURCE, encoding="utf-8")
    return tmp_path


def shown(root, first="0", second="not covered"):
    return SHOWN.format(name=root / "lib" / "math" / "a.h", first=first, second=second)


def measured(root, *views):
    return {name: file.result() for name, file in coverage.views("\n".join(views), root).items()}


def test_what_no_test_reaches_is_told_by_its_text(root):
    files = measured(root, "/usr/include/c.h:\n    1|      1|int x;", shown(root))
    assert files == {"lib/math/a.h": {
        "lines": [4, 5], "branches": [4, 6], "conditions": [1, 2],
        "open": [coverage.Gap(5, "of_room", "b < 3", ("true", "alone")), coverage.Gap(8, "of_room", "a > 0 #2", ("true",))]}}


def test_what_one_view_reaches_is_reached(root):
    files = measured(root, shown(root), shown(root, "7", "covered: (1,3)"))
    assert files["lib/math/a.h"]["branches"] == [5, 6] and files["lib/math/a.h"]["conditions"] == [2, 2]
    assert [gap.condition for gap in files["lib/math/a.h"]["open"]] == ["a > 0 #2"]


@pytest.mark.parametrize("column, text, condition", [
    (5, "if (a[i] < f(b, c) && d) {", "a[i] < f(b, c)"), (10, "    x = (a ? b : c);", "a"), (8, "while (next(&x) != NULL) {", "next(&x) != NULL"),
    (5, "if (a <", "a < b + 1"), (6, "case 7:", "7")])
def test_the_text_of_a_condition(column, text, condition):
    assert coverage.condition_at([text, "      b + 1 || c) {"], 1, column) == condition


@pytest.mark.parametrize("line, name", [(1, "MAX"), (2, "MAX"), (5, "first"), (9, "second"), (10, "second"), (11, "third"), (13, "fourth")])
def test_the_function_of_a_line(line, name):
    text = ["#define MAX(a, b) \\", "    ((a) > (b) ? (a) : (b))", "int first(int a);", "static const int *first(int a,", "    int b) { a; }", "",
            "FXL_COLD fxl_status", "second(int a)", "{", "}", "static __attribute__((noinline)) int third(int a)",
            "static __attribute__((noinline)) int", "fourth(int a)"]
    assert coverage.function_of(text, line) == name


def test_rooms():
    counts = {"lines": [9, 10], "branches": [3, 4], "conditions": [1, 3], "open": []}
    rooms = coverage.by_room({"lib/math/a.c": counts, "lib/math/b.c": counts, "lib/include/fixel/c.h": counts})
    assert list(rooms) == ["lib/include/fixel", "lib/math", "all together"]
    assert rooms["lib/math"] == {"lines": [18, 20], "branches": [6, 8], "conditions": [2, 6]}
    assert coverage.rows(rooms)[-1] == ["all together", "27 of 30   90.0 %", "9 of 12   75.0 %", "3 of 9   33.3 %"]


def test_a_room_without_decisions():
    assert coverage.rows({"lib/a": {"lines": [1, 1], "branches": [0, 0], "conditions": [0, 0]}}) == \
        [["lib/a", "1 of 1  100.0 %", "0 of 0", "0 of 0"]]


def reasons(root, *lines):
    path = root / "uncovered.toml"
    path.write_text('[[reason]]\nwhy = "b is at least 3"\ngaps = [' + "".join(f'\n    "{line}",' for line in lines) + "\n]\n", encoding="utf-8")
    return coverage.read(path)


def test_each_gap_has_a_reason_or_fails(root, capsys):
    files = measured(root, shown(root))
    all_of = reasons(root, "lib/math/a.h | of_room | b < 3 | true alone", "lib/math/a.h | of_room | a > 0 #2 | true")
    assert coverage.sentences(files, all_of) == ([], []) and coverage.compare(files, all_of, "r.toml")
    assert "2 branches, 1 conditions; without one: 0 places" in capsys.readouterr().out
    part = reasons(root, "lib/math/a.h | of_room | b < 3 | true")
    assert coverage.sentences(files, part)[0] == ["lib/math/a.h:5: lib/math/a.h | of_room | b < 3 | alone",
                                              "lib/math/a.h:8: lib/math/a.h | of_room | a > 0 #2 | true"]
    assert not coverage.compare(files, part, "r.toml")
    assert "a.h:8: " in capsys.readouterr().err


def test_a_reason_that_nothing_needs_fails(root):
    files = measured(root, shown(root, "7", "covered: (1,3)"))
    stated = reasons(root, "lib/math/a.h | of_room | b < 3 | true alone", "lib/math/a.h | of_room | a > 0 #2 | true",
                     "lib/math/a.h | of_hall | a > 0 | true")
    assert coverage.sentences(files, stated) == ([], ["lib/math/a.h | of_room | b < 3 | true alone", "lib/math/a.h | of_hall | a > 0 | true"])
    assert not coverage.compare(files, stated, "r.toml")


def test_a_condition_may_have_a_bar():
    assert coverage.parsed("lib/a.c | f | (a | b) == 0 | false alone", "r.toml") == (("lib/a.c", "f", "(a | b) == 0"), ("false", "alone"))


def test_a_gap_keeps_its_reason_where_lines_move(root):
    stated = reasons(root, "lib/math/a.h | of_room | b < 3 | true alone", "lib/math/a.h | of_room | a > 0 #2 | true")
    (root / "lib" / "math" / "a.h").write_text("\n\n" + SOURCE, encoding="utf-8")
    moved = shown(root)
    for line in (8, 6, 5, 4, 2, 1):
        moved = moved.replace(f"  {line}|", f"  {line + 2}|").replace(f"({line}:", f"({line + 2}:")
    assert coverage.sentences(measured(root, moved), stated) == ([], [])


@pytest.mark.parametrize("line, words", [
    ("lib/math/a.h | of_room | b < 3", "a gap is"), ("lib/math/a.h | of_room | b < 3 | maybe", "a gap is"), ("x | y | z | true\",\n \"x | y | z | true", "twice")])
def test_a_file_of_reasons_that_says_something_else_is_refused(root, line, words):
    with pytest.raises(ToolError, match=words):
        reasons(root, line)


def test_without_clang_it_is_not_run(monkeypatch, root):
    monkeypatch.setattr(coverage.shutil, "which", lambda name: None)
    with pytest.raises(ToolError, match="not run: needs clang 19") as refused:
        coverage.main(["--library", "l.so", "--tests", "t", "--out", str(root / "c.json")])
    assert refused.value.exit_code == 2


def test_the_reasons_name_functions_that_are_there():
    stated = coverage.read(CHECKOUT / "host_tests" / "unit" / "uncovered.toml")
    texts = {file: (CHECKOUT / file).read_text(encoding="utf-8") for file in {key[0] for key in stated}}
    assert len(stated) > 20 and [key for key in stated if f"{key[1]}(" not in texts[key[0]]] == []


def test_programs_that_fail_are_named_and_the_others_counted(tmp_path):
    write = "import os, sys; open(os.environ['LLVM_PROFILE_FILE'], 'w').close(); "
    programs = []
    for name, words in (("good", write), ("bad", write + "sys.exit('no pixel')"), ("worse", "raise SystemExit(3)")):
        program = tmp_path / name
        program.write_text(f"#!{sys.executable}\n{words}\n", encoding="utf-8")
        program.chmod(0o755)
        programs.append([program])
    counts, failed = coverage.run_programs(programs, tmp_path, 2)
    assert [each.name for each in counts] == ["0.profraw", "1.profraw"]
    assert failed == {"bad": "no pixel\n", "worse": ""}


# --- make coverage-builds ---

def line_table(kernel, function):
    """The line program of a unit with C and assembly, of a portable one and of one that is not the library's, as a linker placed them."""
    return [[(kernel, "lib/a_armv7m.S", 3, False), (kernel + 2, "lib/a_armv7m.S", 9, False), (kernel + 10, "lib/a_armv7m.S", 9, True)],
            [(function, "lib/a.c", 5, False), (function + 4, "lib/a.h", 2, False), (function + 4, "lib/a.c", 6, False), (function + 6, "lib/a.c", 5, False),
             (function + 8, "lib/a.c", 5, True), (0, "lib/a.c", 20, False), (6, "lib/a.c", 20, True)],
            [(0x300, "portable/lib/a.c", 5, False), (0x304, "portable/lib/a.c", 5, True)], [(0x400, "boards/b.c", 1, False), (0x404, "boards/b.c", 1, True)]]


CODE = [0x100, 0x102, 0x106, 0x108, 0x200, 0x204, 0x206, 0x300, 0x302, 0x400]


def test_an_address_has_the_file_and_line_of_its_table():
    found = coverage_builds.places(line_table(0x100, 0x200), CODE)
    assert sorted(found.values(), key=str) == sorted([
        ("lib/a_armv7m.S", 3, 0x100), ("lib/a_armv7m.S", 9, 0x102), ("lib/a_armv7m.S", 9, 0x106), ("lib/a_armv7m.S", 9, 0x108),
        ("lib/a.c", 5, 0x200), ("lib/a.c", 6, 0x204), ("lib/a.c", 5, 0x206), ("lib/a.c", 20, None), ("portable/lib/a.c", 5, 0x300)], key=str)


def test_a_place_is_the_same_wherever_a_program_has_it():
    moved = coverage_builds.places(line_table(0x1100, 0x2200), [each + (0x1000 if each < 0x200 else 0x2000) for each in CODE])
    assert moved.keys() == coverage_builds.places(line_table(0x100, 0x200), CODE).keys()


def test_what_one_program_of_a_build_reaches_is_reached(monkeypatch, tmp_path):
    executed = {"one": {0x100, 0x102, 0x200}, "two": {0x106, 0x300}}
    monkeypatch.setattr(coverage_builds.machine_code, "MachineCode", lambda elf: elf)
    monkeypatch.setattr(coverage_builds, "run", lambda elf, *_: executed[elf])
    monkeypatch.setattr(coverage_builds, "line_programs", lambda elf: line_table(0x100, 0x200))
    monkeypatch.setattr(coverage_builds, "instructions", lambda code: CODE)
    files = coverage_builds.merged(coverage_builds.measure((build, elf, True), "p.so", tmp_path) for build, elf in (("m3", "one"), ("m3", "two"), ("m55", "one")))
    assert {key: coverage_builds.count([some]) for key, some in files.items()} == {
        ("m3", "lib/a_armv7m.S"): [3, 4], ("m3", "lib/a.c"): [1, 3], ("portable", "lib/a.c"): [1, 1],
        ("m55", "lib/a_armv7m.S"): [2, 4], ("m55", "lib/a.c"): [1, 3]}
    assert ["lib/a_armv7m.S", "m3", "3 of 4", " 75.0 %"] in coverage_builds.rows(files)
    assert ["lib", "m55", "1 of 3", " 33.3 %"] in coverage_builds.rows(files)
    assert coverage_builds.never(files) == []        # line 9 is reached


def test_a_line_of_assembly_that_no_build_reaches_is_named():
    reached, left = {("u", 0, 0, 3): True, ("u", 0, 2, 9): False}, {("u", 0, 0, 3): False, ("u", 0, 2, 9): False, ("u", 0, 4, 9): False}
    assert coverage_builds.never({("m3", "lib/a.S"): reached, ("m55", "lib/a.S"): left}) == ["lib/a.S:9: 1 instructions of m3"]


@pytest.mark.parametrize("endings, is_whole", [(["DONE"], True), (["STACK", "DONE"], True), (["TEST"], False), (["STACK", "TEST"], False)])
def test_a_program_runs_on_behind_a_file_that_its_stack_has_no_room_for(endings, is_whole, monkeypatch, tmp_path):
    left, asked = list(endings), []

    def execute(elf, code, plugin, words, folder):
        asked.append(words)
        return types.SimpleNamespace(code=coverage_builds.endings.exit_code(left.pop(0)), output="unittest: test_a\n"), {len(asked)}
    monkeypatch.setattr(coverage_builds, "execute", execute)
    monkeypatch.setattr(coverage_builds.endings, "describe", str)
    if is_whole:
        assert coverage_builds.run("e", None, "p", True, tmp_path / "f") == set(range(1, len(endings) + 1))
        assert asked == [["unittest"], ["unittest", "after=test_a"]][:len(endings)]
    else:
        with pytest.raises(ToolError) as failed:
            coverage_builds.run("e", None, "p", True, tmp_path / "f")
        assert failed.value.exit_code == 1
