# SPDX-License-Identifier: MIT
"""How fixel breaks draws, makes and judges breaks. The breaks of the list itself: make breaks."""

import argparse
import dataclasses
import json
import pathlib
import types

import pytest
from conftest import CHECKOUT

from fixel.base.errors import ToolError
from fixel.check import breaks, clauses, planting, trace_break
from fixel.check.breaks import NAMED, PASSED, UNNAMED
from fixel.prove import bugs, rows

BUILT_PROGRAMS = ()
BREAK = """["lib/a.c".sum.%s]
kind = "%s"
line = "%s"
becomes = "%s"
why = "w"
blind = true
command = "%s"
names = "%s"
"""
SPEC = "**1.1** A sum is exact.\n"
CODE = "int sum(int a, int b)\n{\n    /* SPEC 1.1 */\n    return a + b;\n}\n"
TEST = "/* SPEC 1.1 */\nvoid test_sum(void)\n{\n}\n"


@pytest.fixture
def root(tmp_path):
    """A checkout of a clause with its code and its test, and a break that takes the tag away."""
    for folder in ("docs/extras", "lib", "host_tests/unit", "host_tests/breaks", "host_tests/build/trace"):
        (tmp_path / folder).mkdir(parents=True)
    (tmp_path / "SPEC.md").write_text(SPEC)
    (tmp_path / "lib/a.c").write_text(CODE)
    (tmp_path / "host_tests/unit/test_a.c").write_text(TEST)
    (tmp_path / planting.FOLDER / "b.toml").write_text('["lib/a.c".sum.one]\nwhy = "w"\nline = "return a + b;"\nbecomes = "return a - b;"\n'
                                                       'tests = ["test_a"]\n')
    clauses.accept(tmp_path, clauses.read(tmp_path), {})
    listed(tmp_path, ("tag", "clause", "/* SPEC 1.1 */", "", "make trace", "SPEC 1.1"))
    return tmp_path


def listed(root, *entries):
    (root / planting.FOLDER / "a.toml").write_text("".join(BREAK % entry for entry in entries))


def broken(root, capsys, *options):
    """(exit code, what is printed, the JSON file)."""
    code = breaks.main(["--root", str(root), "--build", str(root / "build"), "--units", "units", "--cc", "gcc", *options])
    return code, capsys.readouterr().out, json.loads((root / "build/breaks/breaks.json").read_text())


def entry(number, kind):
    return blind(f"{kind}-{number}", kind, "a", "make test", "SPEC 1.1")


def blind(id_, kind, becomes, command, names, file="lib/a.c", function="sum", line="return a + b;"):
    return planting.Break(file, function, id_, line, becomes, "w", "a.toml", kind=kind, blind=True, command=command, names=names)


# --- the list --------------------------------------------------------------------------

def test_there_are_eighty_blind_breaks_that_can_be_made_and_fifteen_of_each_kind():
    """Where fewer can: give the entries that make breaks names the text as it stands now, with the same mistake."""
    every = breaks.blind(CHECKOUT)
    stale = planting.stale(CHECKOUT, every)
    kinds = [each.kind for each in every if each.id not in stale]
    assert len(kinds) >= 80 and all(kinds.count(kind) >= 15 for kind in planting.BLIND_KINDS), stale


# --- the draw --------------------------------------------------------------------------

def test_a_seed_draws_the_same_breaks_each_time_and_as_many_of_each_kind():
    every = [entry(number, kind) for number in range(15) for kind in planting.BLIND_KINDS]
    first, again, other = (breaks.draw(every, seed, 20) for seed in ("1", "1", "2"))
    assert first == again != other and len(set(first)) == 20
    assert [each.kind for each in first] == [kind for kind in planting.BLIND_KINDS for _ in range(5)]
    assert [each.kind for each in breaks.draw(every, "1", 6)] == ["clause", "clause", "contract", "contract", "bound", "coverage"]
    assert len(breaks.draw(every, "1", 1000)) == 60


def test_a_seed_draws_the_same_breaks_wherever_a_ledger_has_them(root):
    entries = [(f"bound-{number}", "bound", "return a + b;", f"return {number};", "make test", "SPEC 1.1") for number in range(9)]
    drawn = []
    for some in (entries, entries[::-1]):
        listed(root, *some)
        drawn.append([each.id for each in breaks.draw(breaks.blind(root), "1", 8)])
    assert drawn[0] == drawn[1] and len(drawn[0]) == 2


def test_a_break_whose_text_is_there_no_more_is_named_and_not_drawn(root, capsys):
    listed(root, ("tag", "clause", "/* SPEC 1.1 */", "", "make trace", "SPEC 1.1"), ("gone", "bound", "return a * b;", "a", "make test", "SPEC 1.1"),
           ("same", "bound", "return a + b;", "return a + b;", "make test", "SPEC 1.1"))
    code, said, found = broken(root, capsys)
    assert code == 0 and [each["id"] for each in found["breaks"]] == ["tag"] and found["listed"] == 3
    assert "not drawn: host_tests/breaks/a.toml: break 'gone': lib/a.c: sum has no line 'return a * b;'" in said
    assert "not drawn: host_tests/breaks/a.toml: break 'same': it changes nothing" in said
    assert "of 3 in the list 2 are stale" in said


def test_sentences_are_drawn_of_all_that_are_no_prose_and_one_without_a_break_is_named(root, capsys, monkeypatch):
    (root / "SPEC.md").write_text("**1.1** A sum is exact. It is quick. It wraps.\n\n**1.2** A sum is odd.\n")
    clauses.accept(root, clauses.read(root), {})
    record = root / clauses.RECORD
    record.write_text(record.read_text().replace("1.1b:", "1.1b, prose:"))
    (root / "host_tests/unit/test_a.c").write_text(TEST.replace("1.1", "1.1a, 1.2"))
    listed(root, ("tag", "clause", "/* SPEC 1.1 */", "", "make trace", "SPEC 1.1a"))
    assert sorted(breaks.draw_sentences(root, "1", 9)) == ["SPEC 1.1a", "SPEC 1.1c", "SPEC 1.2a"]
    assert breaks.draw_sentences(root, "1", 2) == breaks.draw_sentences(root, "1", 9)[:2]
    monkeypatch.setattr(breaks, "try_all", lambda drawn, _: [breaks.row(each, [breaks.Step("make test", NAMED)]) for each in drawn])
    code, said, written = broken(root, capsys, "--only", "sentences")
    assert code == 1 and written["noticed"] == 1 and sorted(written["without"]) == ["SPEC 1.1c", "SPEC 1.2a"]
    assert "1 of 3 sentences drawn are noticed" in said


def test_a_break_of_a_sentence_is_tried_with_the_tests_of_that_sentence(root):
    (root / "SPEC.md").write_text("**1.1** A sum is exact. It wraps.\n")
    clauses.accept(root, clauses.read(root), {})
    (root / "host_tests/unit/test_a.c").write_text("".join(TEST.replace("1.1", f"1.1{letter}").replace("sum", letter) for letter in "ab"))
    commands = commands_of(root)
    assert [[tag.test for tag in commands._tagged(id_)] for id_ in ("SPEC 1.1", "SPEC 1.1b", "SPEC 1.1c", "SPEC 2.1")] == [
        ["test_a", "test_b"], ["test_b"], [], []]


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
    listed(root, ("sum", "clause", "return a + b;", "return a - b;", "make trace", "SPEC 1.1"))
    monkeypatch.setattr(breaks.Commands, "host_tests", lambda *_: breaks.Step("make test", UNNAMED, "test_a.c:1: FAIL"))
    monkeypatch.setattr(breaks.Commands, "proofs_of_file", lambda *_: breaks.Step("make prove", PASSED))
    code, said, found = broken(root, capsys)
    assert code == 1 and "0 of 1 breaks noticed (0 failed and named, 1 failed, not named, 0 passed)" in said
    assert "sum: lib/a.c: w\n  make trace: passed\n  make test: failed, not named: test_a.c:1: FAIL\n  make prove: passed\n" in said
    assert [step["result"] for step in found["breaks"][0]["steps"]] == [PASSED, UNNAMED, PASSED]


def test_no_command_runs_once_one_has_named_the_break():
    def step(result):
        return lambda each: ran.append(result) or breaks.Step("c", result)

    ran = []
    commands = types.SimpleNamespace(of=lambda each: map(step, (PASSED, NAMED, UNNAMED)))
    assert breaks.best(breaks.try_break(entry(1, "bound"), commands)) == NAMED and ran == [PASSED, NAMED]


def commands_of(root, *drawn):
    return breaks.Commands(argparse.Namespace(root=root, build=root / "build", units="units", cc="gcc", jobs=1, samples=1), drawn)


def test_breaks_of_different_files_are_made_together_and_named_one_by_one(root):
    """Two of one file are made one after the other."""
    (root / "lib/b.c").write_text("int f(void)\n")
    of_a, again = (blind(name, "coverage", "return 1;", "make coverage", "sum") for name in ("one", "two"))
    of_b = blind("three", "coverage", "int g(void)", "make coverage", "f", "lib/b.c", "f", "int f(void)")
    commands, seen = commands_of(root, of_a, again, of_b), []

    def run():
        copy = root / "build/breaks/checkout/lib"
        seen.append([(copy / name).read_text() != (root / "lib" / name).read_text() for name in ("a.c", "b.c")])
        return "lib/a.c:4: lib/a.c | sum | 1 | true"

    commands._cover = run
    assert [commands.coverage(each).result for each in (of_a, again, of_b)] == [NAMED, NAMED, PASSED]
    assert seen == [[True, True], [True, False]] and (root / "build/breaks/checkout/lib/a.c").read_text() == CODE


def test_a_break_of_a_clause_is_tried_with_the_tests_that_have_its_tag(root, monkeypatch):
    """In a copy of the sources."""
    def fails(_suite, tree, changed, file, _cpu):
        """Of a source that is compiled with the break in it."""
        return (tree.folder / file).read_text().count("return a;") and changed == [tree.object(pathlib.Path(file))] and "test_a.c:1: FAIL"

    (root / "boards").mkdir()
    monkeypatch.setattr(trace_break.Tree, "linked", lambda _, sources, __: sources)
    monkeypatch.setattr(trace_break.Tree, "compile", lambda *_: None)
    monkeypatch.setattr(trace_break.Suite, "main", lambda *_: None)
    monkeypatch.setattr(trace_break.Suite, "fails", fails)
    each = blind("one", "clause", "return a;", "make test", "SPEC 1.1")
    step = commands_of(root, each).tagged_tests(each)
    assert (step.command, step.result, step.words) == ("make test BOARD=host ONLY=test_a", NAMED, "test_a: test_a.c:1: FAIL")
    assert (root / "build/breaks/units/lib/a.c").read_text() == CODE


def test_a_test_without_the_tag_names_no_clause(root, monkeypatch):
    """The tests of the tag run first; all others fail without naming it."""
    tree = types.SimpleNamespace(dependents=lambda file: ["lib/a.c"], linked=lambda sources, suites: sources)
    breaker = types.SimpleNamespace(try_change=lambda each, suites: {"result": "killed", "by": "test_a: words"})
    monkeypatch.setattr(breaks.Commands, "_breaker", (tree, breaker))
    monkeypatch.setattr(trace_break.Suite, "main", lambda *_: None)
    each = blind("one", "clause", "return a;", "make test", "SPEC 1.1")
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
    each = blind("one", "bound", "return a;", "make report", "claim")
    commands = commands_of(root, each)
    with pytest.raises(ToolError, match="does not build"):
        commands.report(each)
    assert (root / "build/breaks/checkout/lib/a.c").read_text() == CODE


# --- rows of proofs ----------------------------------------------------------------

# Bugs that may be untried, or tried with another text: they become fewer.
UNTRIED = 2


def test_each_row_has_a_bug_of_its_own_that_it_noticed():
    """The record of fixel prove --bugs, which names what it has not tried, or with another text."""
    every = rows.read(CHECKOUT)
    pairs, known = bugs.pairs_of(CHECKOUT, every), {each.id for each in every}
    assert {each for bug in planting.of_rows(CHECKOUT) for each in bug.rows} <= known
    # a row that runs a formula is asked for the bug of the formula's row
    assert not {each.id for each in every if not each.formula} - {each.id for _, each in pairs}, "a row without a bug: add one to host_tests/breaks"
    assert {(each, bug) for each, named in bugs.load(CHECKOUT).items() for bug in named} <= {(each.id, bug.id) for bug, each in pairs}
    stale = [f"{each.id}: {bug.id}" for bug, each in bugs.stale(CHECKOUT, pairs)]
    assert len(stale) <= UNTRIED, f"make prove BUGS=1 tries them: {', '.join(stale)}"


def test_a_bug_was_tried_with_this_text_of_its_function_and_row(tmp_path):
    """A comment is no text."""
    path = tmp_path / "lib/math/a.c"
    path.parent.mkdir(parents=True)
    harness = tmp_path / "a.c"
    harness.write_text("void prove_a(void)\n{\n}\n", encoding="utf-8")
    one = rows.Row(function="lib/math/a.c:a", property="", place=harness, id="a", harness="prove_a")
    bug = planting.Break("lib/math/a.c", "a", "one-more", "return 1;", "return 2;", "one more", ledger="")
    seen = []
    for text in ("return 1;", "return  1; /* one */", "return 1 + 0;"):
        bugs._lines.cache_clear()
        path.write_text(f"int a(void)\n{{\n    {text}\n}}\n", encoding="utf-8")
        seen.append(bugs.hash_of(tmp_path, bug, one))
    assert seen[0] == seen[1] != seen[2]
    assert bugs.hash_of(tmp_path, bug, dataclasses.replace(one, unwind=9)) != seen[2]
    (tmp_path / rows.PROOFS).mkdir(parents=True)
    bugs.save(tmp_path, [(bug, one)], {"a": {"one-more": seen[2], "gone": "0"}})
    assert bugs.load(tmp_path) == {"a": {"one-more": seen[2]}} and bugs.stale(tmp_path, [(bug, one)]) == []


def test_stubs_that_assume_what_no_row_says_are_named_and_become_fewer():
    every, found = rows.read(CHECKOUT), {}
    for place, to, _ in rows.assumptions(CHECKOUT, every):
        found.setdefault(place, set()).add(to)
    assert found == {place: set(named) for place, named in rows.UNSTATED.items()}
    assert sum(map(len, found.values())) <= 11
    assert {named for of in rows.BY_Z3.values() for named in of.values()} <= {each.id for each in every if each.tool == "z3"}


STUB = """#include "math/a.c"
int any_b(int from, const int *to)
{
    int found;
    ASSUME(%s);
    return found;
}

/* [[row]]
 * function = "a"
 * property = "p"
 * stands_in = { b = "any_b" }
 */
void prove_a(void)
{
    PROOF_ENDS();
}

/* [[row]]
 * function = "b"
 * property = "p"
 */
void prove_b(void)
{
    ASSERT("between them", status != FXL_OK || (x >= (int64_t)low && x <= high));
    ASSERT("no more", status != FXL_OK || (x >= low && x <= high));
    ASSERT("below 4", WITHIN(b(low, &high), 4));
}
"""


@pytest.mark.parametrize("assumed, is_said", [
    ("found >= from && found <= *to", True),
    ("!good || found <= *to", True),
    ("found >= (int64_t)from && found <= *to", True),
    ("found >= (int32_t)from", False),
    ("WITHIN(found, 4)", True),
    ("WITHIN(found, 3)", False),
    ("found > from && found <= *to", False),
    ("found >= from && from <= *to", False),    # another number between them
    ("found >= found", False),
])
def test_what_a_stub_assumes_a_row_says_in_the_same_words(tmp_path, assumed, is_said):
    (tmp_path / "lib").mkdir()
    harness = tmp_path / rows.PROOFS / "math/arith.c"
    harness.parent.mkdir(parents=True)
    harness.write_text(STUB % assumed, encoding="utf-8")
    every = rows.read(tmp_path)
    assert rows.assumptions(tmp_path, every) == ([] if is_said else [("math/arith.c", "any_b", "b")])
    if not is_said:
        with pytest.raises(ToolError, match="any_b assumes what no row of b asserts"):
            rows.check_assumptions(tmp_path, every)


@pytest.mark.parametrize("words, equations, tool, is_said", [
    ("FXL_EQUATES(FXL_BELOW(FXL_RESULT, 3))", True, "cbmc", True),
    ("FXL_EQUATES(FXL_BELOW(FXL_RESULT, 3))", False, "cbmc", False),    # no row of Z3 proves it
    ("FXL_ENSURES(FXL_BELOW(FXL_RESULT, 3))", False, "cbmc", True),
    ("", False, "z3", True),
    ("", False, "gappa", False),
])
def test_what_a_stub_assumes_a_contract_says_or_a_row_of_z3(tmp_path, monkeypatch, words, equations, tool, is_said):
    (tmp_path / "lib").mkdir()
    (tmp_path / "lib/a.h").write_text(f"int b(int from, const int *to)\n    {words};\n", encoding="utf-8")
    harness = tmp_path / rows.PROOFS / "math/arith.c"
    harness.parent.mkdir(parents=True)
    harness.write_text(STUB % "WITHIN(found, 3)", encoding="utf-8")
    a, b = rows.read(tmp_path)
    other = dataclasses.replace(b, id="bound", tool=tool)
    monkeypatch.setattr(rows, "BY_Z3", {"math/arith.c": {"any_b": "bound"}})
    assert (rows.assumptions(tmp_path, [a, dataclasses.replace(b, contract=True, equations=equations), other]) == []) == is_said
