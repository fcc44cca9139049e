# SPDX-License-Identifier: MIT
"""How fixel breaks draws, makes and judges breaks. The breaks of the list itself: make breaks."""

import argparse
import json
import types

import pytest
from conftest import CHECKOUT

from fixel.base.errors import ToolError
from fixel.check import break_commands, break_list, breaks, bugs, clauses, trace_break
from fixel.check.break_commands import NAMED, PASSED, UNNAMED

BREAK = """[[break]]
id = "%s"
kind = "%s"
file = "lib/a.c"
old = "%s"
new = "%s"
what = "w"
command = "%s"
names = "%s"
"""
SPEC = "**1.1** A sum is exact.\n"
CODE = "/* SPEC 1.1 */\nint sum(int a, int b)\n{\n    return a + b;\n}\n"
TEST = "/* SPEC 1.1 */\nvoid test_sum(void)\n{\n}\n"


@pytest.fixture
def root(tmp_path):
    """A checkout of a clause with its code and its test, and a break that takes the tag away."""
    for folder in ("docs/extras", "lib", "host_tests/unit", "host_tests/build/seeded_bugs", "host_tests/build/trace"):
        (tmp_path / folder).mkdir(parents=True)
    (tmp_path / "SPEC.md").write_text(SPEC)
    (tmp_path / "lib/a.c").write_text(CODE)
    (tmp_path / "host_tests/unit/test_a.c").write_text(TEST)
    (tmp_path / bugs.BUGS).write_text('[[bug]]\nid = "one"\nname = "n"\nkind = "k"\nfile = "lib/a.c"\nfunction = "sum"\nwhy = "w"\n'
                                      'line = "return a + b;"\nbecomes = "return a - b;"\ntests = []\n')
    (tmp_path / clauses.RECORD).write_text(clauses.record_text(clauses.read(tmp_path)))
    listed(tmp_path, ("tag", "clause", "/* SPEC 1.1 */", "", "make trace", "SPEC 1.1"))
    return tmp_path


def listed(root, *entries):
    (root / break_list.LIST).write_text("".join(BREAK % entry for entry in entries))


def broken(root, capsys, *options):
    """(exit code, what is printed, the JSON file)."""
    code = breaks.main(["--root", str(root), "--build", str(root / "build"), "--units", "units", "--cc", "gcc", *options])
    return code, capsys.readouterr().out, json.loads((root / "build/breaks/breaks.json").read_text())


def entry(number, kind):
    return break_list.Break(f"{kind}-{number}", kind, "lib/a.c", "a", "b", "w", "make test", "SPEC 1.1")


# --- the list --------------------------------------------------------------------------

def test_the_list_has_eighty_breaks_that_can_be_made_and_fifteen_of_each_kind():
    """Where fewer can: give the entries that make breaks names the text as it stands now, with the same mistake."""
    every = break_list.read(CHECKOUT)
    stale = break_list.stale(CHECKOUT, every)
    kinds = [each.kind for each in every if each.id not in stale]
    assert len(kinds) >= 80 and all(kinds.count(kind) >= 15 for kind in break_list.KINDS), stale


@pytest.mark.parametrize("old, new, words", [
    ("names =", "name =", "break 1: it needs the texts"), ('"clause"', '"claws"', "break 1: kind is one of"), ("[[break]]", "[[brake]]", "holds no"),
    ('"make trace"', '"make tea"', "command one of"), ("[[break]]", "[[break", "cannot be read")])
def test_a_list_that_is_wrong_is_refused(root, old, new, words):
    text = (root / break_list.LIST).read_text()
    (root / break_list.LIST).write_text(text.replace(old, new))
    with pytest.raises(ToolError, match=words):
        break_list.read(root)


def test_two_breaks_of_one_id_are_refused(root):
    (root / break_list.LIST).write_text((root / break_list.LIST).read_text() * 2)
    with pytest.raises(ToolError, match="two breaks have the id 'tag'"):
        break_list.read(root)


# --- the draw --------------------------------------------------------------------------

def test_a_seed_draws_the_same_breaks_each_time_and_as_many_of_each_kind():
    every = [entry(number, kind) for number in range(15) for kind in break_list.KINDS]
    first, again, other = (breaks.draw(every, seed, 20) for seed in ("1", "1", "2"))
    assert first == again != other and len(set(first)) == 20
    assert [each.kind for each in first] == [kind for kind in break_list.KINDS for _ in range(5)]
    assert [each.kind for each in breaks.draw(every, "1", 6)] == ["clause", "clause", "contract", "contract", "bound", "coverage"]
    assert len(breaks.draw(every, "1", 1000)) == 60


def test_a_break_whose_text_is_there_no_more_is_named_and_not_drawn(root, capsys):
    listed(root, ("tag", "clause", "/* SPEC 1.1 */", "", "make trace", "SPEC 1.1"), ("gone", "bound", "a * b", "a", "make test", "SPEC 1.1"),
           ("often", "bound", "int", "long", "make test", "SPEC 1.1"))
    code, said, found = broken(root, capsys)
    assert code == 0 and [each["id"] for each in found["breaks"]] == ["tag"] and found["listed"] == 3
    assert "not drawn: gone: lib/a.c has its text 0 times" in said and "not drawn: often: lib/a.c has its text 3 times" in said
    assert "of 3 in the list 2 are stale" in said


def test_nothing_to_break_is_refused(root):
    with pytest.raises(ToolError, match="no break of .* has 'nothing'"):
        breaks.main(["--root", str(root), "--units", "u", "--cc", "gcc", "--only", "nothing"])
    with pytest.raises(ToolError, match="DRAW="):
        breaks.main(["--root", str(root), "--units", "u", "--cc", "gcc", "--draw", "0"])


# --- what notices ----------------------------------------------------------------------

def test_a_break_that_a_command_names_is_noticed(root, capsys):
    code, said, found = broken(root, capsys)
    assert code == 0 and "1 of 1 breaks noticed (1 failed and named, 0 failed, not named, 0 passed)" in said and "seed 1" in said
    [only] = found["breaks"]
    assert only["result"] == NAMED and "SPEC 1.1 has no code" in only["steps"][0]["words"]
    assert (root / "lib/a.c").read_text() == (root / "build/breaks/checkout/lib/a.c").read_text() == CODE


def test_a_break_that_no_command_names_is_printed_with_its_harm(root, capsys, monkeypatch):
    listed(root, ("sum", "clause", "a + b", "a - b", "make trace", "SPEC 1.1"))
    monkeypatch.setattr(break_commands.Commands, "host_tests", lambda *_: break_commands.Step("make test", UNNAMED, "test_a.c:1: FAIL"))
    monkeypatch.setattr(break_commands.Commands, "proofs_of_file", lambda *_: break_commands.Step("make prove", PASSED))
    code, said, found = broken(root, capsys)
    assert code == 1 and "0 of 1 breaks noticed (0 failed and named, 1 failed, not named, 0 passed)" in said
    assert "sum: lib/a.c: w\n  make trace: passed\n  make test: failed, not named: test_a.c:1: FAIL\n  make prove: passed\n" in said
    assert [step["result"] for step in found["breaks"][0]["steps"]] == [PASSED, UNNAMED, PASSED]


def test_no_command_runs_once_one_has_named_the_break():
    def step(result):
        return lambda each: ran.append(result) or break_commands.Step("c", result)

    ran = []
    commands = types.SimpleNamespace(of=lambda each: map(step, (PASSED, NAMED, UNNAMED)))
    assert breaks.best(breaks.try_break(entry(1, "bound"), commands)) == NAMED and ran == [PASSED, NAMED]


def commands_of(root, *drawn):
    return break_commands.Commands(argparse.Namespace(root=root, build=root / "build", units="units", cc="gcc", jobs=1, samples=1), drawn)


def test_breaks_of_different_files_are_made_together_and_named_one_by_one(root):
    """Two of one file are made one after the other."""
    (root / "lib/b.c").write_text("b\n")
    of_a, again = (break_list.Break(name, "coverage", "lib/a.c", old, "1", "w", "make coverage", "sum")
                   for name, old in (("one", "a + b"), ("two", "return")))
    of_b = break_list.Break("three", "coverage", "lib/b.c", "b", "c", "w", "make coverage", "f")
    commands, seen = commands_of(root, of_a, again, of_b), []

    def run():
        copy = root / "build/breaks/checkout/lib"
        seen.append([(copy / name).read_text() != (root / "lib" / name).read_text() for name in ("a.c", "b.c")])
        return "lib/a.c:4: lib/a.c | sum | 1 | true"

    commands._cover = run
    assert [commands.coverage(each).result for each in (of_a, again, of_b)] == [NAMED, NAMED, PASSED]
    assert seen == [[True, True], [True, False]] and (root / "build/breaks/checkout/lib/a.c").read_text() == CODE


def test_a_test_without_the_tag_names_no_clause(root, monkeypatch):
    """The tests of the tag run first; all others fail without naming it."""
    tree = types.SimpleNamespace(dependents=lambda file: ["lib/a.c"], linked=lambda sources, suites: sources)
    breaker = types.SimpleNamespace(try_change=lambda each, suites: {"result": "killed", "by": "test_a: words"})
    monkeypatch.setattr(break_commands.Commands, "_breaker", (tree, breaker))
    monkeypatch.setattr(trace_break.Suite, "main", lambda *_: None)
    each = break_list.Break("one", "clause", "lib/a.c", "a + b", "a", "w", "make test", "SPEC 1.1")
    commands = commands_of(root, each)
    step = commands.tagged_tests(each)
    assert (step.command, step.result) == ("make test BOARD=host ONLY=test_a", NAMED)
    assert commands.host_tests(each).result == UNNAMED
    breaker.try_change = lambda *_: {"result": "survived"}
    assert commands.tagged_tests(each).result == commands.host_tests(each).result == PASSED


# --- the copy --------------------------------------------------------------------------

def test_a_copy_is_renewed_where_it_differs(root):
    """What is the same keeps its time, by which make goes."""
    copy = root / "build/breaks/checkout"
    (root / "lib/room").mkdir()
    (root / "lib/room/b.c").write_text("b\n")
    commands_of(root)
    time = (copy / "lib/a.c").stat().st_mtime_ns
    (copy / "lib/room/b.c").write_text("broken\n")
    (copy / "lib/room/old.c").write_text("old\n")
    (copy / "SPEC.md").write_text("broken\n")
    commands_of(root)
    assert (copy / "lib/room/b.c").read_text() == "b\n" and (copy / "SPEC.md").read_text() == SPEC
    assert (copy / "lib/a.c").stat().st_mtime_ns == time and not (copy / "lib/room/old.c").exists()


def test_a_break_is_taken_back_where_its_command_fails(root):
    each = break_list.Break("one", "bound", "lib/a.c", "a + b", "a", "w", "make report", "claim")
    commands = commands_of(root, each)
    with pytest.raises(ToolError, match="does not build"):
        commands.report(each)
    assert (root / "build/breaks/checkout/lib/a.c").read_text() == CODE
