# SPDX-License-Identifier: MIT
"""What fixel trace joins, and each mistake that it must name."""

import json
import re
import types

import pytest
from conftest import CHECKOUT, run_cli, run_make, write_files

from fixel.base.errors import ToolError
from fixel.check import clauses, equality, kernel_text, planting, sentences, trace, trace_break

BUILT_PROGRAMS = ()
SAMPLE = 5
SPEC = """# Page

**1.1 Sums.** A sum is exact, and is made of two numbers.

* **1.2** A product
is rounded once, with halves upward.

**1.2.1** (informative) A reader may skip this one and go on.
"""
CODE = """/* SPEC 1.1 */
int sum(int a, int b)
{
    return a + b;
}

int difference(int a, int b)
{
    int c = a;

    /* SPEC 1.2, beams 2.1 */
    c -= b;
    /* SPEC 1.1 */
    return c;
}
"""
TEST = """/* SPEC 1.1, 1.2 */
/* What it shows. */
void test_sum(void)
{
}
"""
PYTEST = '''def test_beam():
    """A beam is straight. beams 2.1."""
'''
LEDGER = str(planting.FOLDER / "a.toml")
BUG = """["lib/a.c".sum.one]
line = "return a + b;"
becomes = "return a - b;"
why = "w"
tests = ["test_a"]
clause = "%s"
"""
PAGES = {"SPEC", "beams"}


@pytest.fixture
def root(tmp_path):
    """A checkout of three clauses with their code and tests."""
    write_files(tmp_path, {"SPEC.md": SPEC, "docs/extras/beams.md": "**2.1** A beam is straight.\n", "lib/a.c": CODE,
                           "host_tests/unit/test_a.c": TEST, "host_tests/build/test_b.py": PYTEST, LEDGER: BUG % "SPEC 1.1"})
    clauses.accept(tmp_path, clauses.read(tmp_path), {})
    return tmp_path


def change(root, file, old, new):
    text = (root / file).read_text()
    assert old in text
    (root / file).write_text(text.replace(old, new, 1))


def traced(root, capsys, *options):
    """(exit code, what is printed, sentences of the JSON file)."""
    code = trace.main(["--root", str(root), "--build", str(root / "build"), *options])
    said = json.loads((root / "build/trace.json").read_text())
    return code, capsys.readouterr().out, said["wrong"]


# --- what is read --------------------------------------------------------------------

def test_clauses_are_found_with_their_first_words():
    found = clauses.of_text("SPEC.md", SPEC)
    assert [(each.id, each.line, each.words, each.normative) for each in found] == [
        ("SPEC 1.1", 3, "Sums. A sum is exact, and is made", True),
        ("SPEC 1.2", 5, "A product is rounded once, with halves upward.", True),
        ("SPEC 1.2.1", 8, "A reader may skip this one and go", False)]


def test_clauses_come_by_page_and_number():
    ids = ["beams 2.10", "beams 2.9", "SPEC 10.1", "SPEC 9.1.1", "SPEC 9.1"]
    assert sorted(ids, key=clauses.place) == ["SPEC 9.1", "SPEC 9.1.1", "SPEC 10.1", "beams 2.9", "beams 2.10"]


def test_two_clauses_of_one_number_are_refused(root):
    change(root, "SPEC.md", "**1.2**", "**1.1**")
    with pytest.raises(ToolError, match="SPEC.md:5: the clause SPEC 1.1 stands at line 3 already"):
        clauses.read(root)


@pytest.mark.parametrize("text, ids", [
    ("SPEC 1.1", ["SPEC 1.1"]), ("SPEC 1.1, 1.2", ["SPEC 1.1", "SPEC 1.2"]), ("SPEC 1.1; beams 2.1.3", ["SPEC 1.1", "beams 2.1.3"]),
    ("SPEC 1.1b", ["SPEC 1.1b"]), ("SPEC 1.1y-ab, beams 2.1", ["SPEC 1.1y", "SPEC 1.1z", "SPEC 1.1aa", "SPEC 1.1ab", "beams 2.1"]),
    ("SPEC 1.1-b", None), ("SPEC 1.1b-a", None), ("SPEK 1.1", None), ("SPEC 1", None), ("SPEC 1.1 and 1.2", None), ("1.1", None)])
def test_the_ids_of_a_tag(text, ids):
    assert clauses.ids_of(text, PAGES) == ids


def test_a_tag_of_code_ends_at_the_next_one_and_with_its_function():
    assert [(tag.id, tag.line, tag.last) for tag in clauses.c_code("lib/a.c", CODE, PAGES)] == [
        ("SPEC 1.1", 1, 5), ("SPEC 1.2", 11, 12), ("beams 2.1", 11, 12), ("SPEC 1.1", 13, 15)]


def test_a_tag_of_a_test_is_about_that_test():
    assert [(tag.id, tag.test) for tag in clauses.c_tests("host_tests/unit/test_a.c", TEST, PAGES)] == [
        ("SPEC 1.1", "test_sum"), ("SPEC 1.2", "test_sum")]
    assert [(tag.id, tag.test) for tag in clauses.python_tests("host_tests/build/test_b.py", PYTEST, PAGES)] == [
        ("beams 2.1", "build/test_b.py::test_beam")]


def test_other_comments_are_no_tags():
    assert clauses.c_code("lib/a.c", "/* IEEE 802.3, reflected. */\n/* SPEC 1.1 says why. */ int a;\n", PAGES) == []


def test_tags_of_modules():
    text = "# beams 2.1\ndef f():\n    pass\n\n\ndef g():\n    # SPEC 1.1\n    pass\n    # SPEC 1.2\n    pass\n"
    assert [(tag.id, tag.line, tag.last) for tag in clauses.python_code("a.py", text, PAGES)] == [
        ("beams 2.1", 1, 3), ("SPEC 1.1", 7, 8), ("SPEC 1.2", 9, 10)]


# --- what is wrong -------------------------------------------------------------------

def test_all_is_well(root, capsys):
    code, said, wrong = traced(root, capsys)
    assert (code, wrong) == (0, []) and "3 of 3 normative clauses have code and a test\n" in said
    code, said, _ = traced(root, capsys, "--only", "SPEC 1.2")
    assert code == 0 and "lib/a.c:11" in said and "informative" in said and "beams" not in said


@pytest.mark.parametrize("file, old, new, words", [
    ("host_tests/build/test_b.py", "beams 2.1", "", "docs/extras/beams.md:1: beams 2.1 has no test"),
    ("lib/a.c", "SPEC 1.2, beams 2.1", "SPEC 1.2", "docs/extras/beams.md:1: beams 2.1 has no code"),
    ("host_tests/unit/test_a.c", "SPEC 1.1, 1.2", "SPEC 1.1", "SPEC.md:5: SPEC 1.2 has no test"),
    ("SPEC.md", "(informative) ", "", "SPEC.md:8: SPEC 1.2.1 has no code"),
    ("lib/a.c", "beams 2.1", "beams 2.7", "lib/a.c:11: the tag 'beams 2.7' names no clause: look up the number in docs/extras/beams.md"),
    ("host_tests/unit/test_a.c", "1.2 */", "1.2, 1.9 */", "host_tests/unit/test_a.c:1: the tag 'SPEC 1.9' names no clause"),
    ("host_tests/build/test_b.py", "2.1.", "2.1, 2.3.", "host_tests/build/test_b.py:1: the tag 'beams 2.3' names no clause"),
    (LEDGER, "SPEC 1.1", "SPEC 7.1", "bug 'one': clause = 'SPEC 7.1' names no clause"),
    (LEDGER, "SPEC 1.1", "SPEC one", "bug 'one': clause = 'SPEC one' names no clause"),
    ("SPEC.md", "**1.2** A", "**1.3** A", "SPEC.md:5: SPEC 1.3 was SPEC 1.2: give it that number again"),
    ("SPEC.md", "A sum is", "The sum is", "SPEC.md:3: SPEC 1.1 begins with other words than in"),
    ("SPEC.md", "**1.2.1** (informative) A reader may skip this one and go on.", "", "SPEC 1.2.1 is there no more"),
    ("SPEC.md", "# Page", "# Page\n\n**1.4** (informative) New.", "SPEC.md:3: SPEC 1.4 is not in"),
])
def test_a_mistake_is_named_with_its_place(root, capsys, file, old, new, words):
    change(root, file, old, new)
    code, _, wrong = traced(root, capsys)
    assert code == 1 and any(words in each for each in wrong), wrong


@pytest.mark.parametrize("file, old, new, words", [
    ("lib/a.c", "/* SPEC 1.1 */", "/* SPEK 1.1 */", "lib/a.c:1: the tag 'SPEK 1.1' is no list of clauses"),
    ("lib/a.c", "SPEC 1.2, beams 2.1", "SPEC 1.2 and 1.1", "lib/a.c:11: the tag 'SPEC 1.2 and 1.1' is no list of clauses"),
    ("lib/a.c", "SPEC 1.2, beams 2.1", "SPEC 1.2, beems 2.1", "lib/a.c:11: the tag 'SPEC 1.2, beems 2.1' is no list of clauses"),
    ("host_tests/unit/test_a.c", "void test_sum", "static void sum", "host_tests/unit/test_a.c:1: the tag is above no test")])
def test_a_tag_that_cannot_be_read_is_refused(root, capsys, file, old, new, words):
    change(root, file, old, new)
    with pytest.raises(ToolError, match=re.escape(words)):
        traced(root, capsys)


def test_a_judge_is_no_code_of_the_library(root, capsys):
    (root / "host_tests/judges/reference").mkdir(parents=True)
    (root / "host_tests/judges/reference/sum.c").write_text("/* SPEC 1.1 */\nint sum(void)\n{\n}\n")
    with pytest.raises(ToolError, match="sum.c:1: the tag 'SPEC 1.1' is in a judge"):
        traced(root, capsys)


def test_two_clauses_that_changed_places_are_named(root, capsys):
    change(root, "SPEC.md", "**1.1 Sums.**", "**1.9 Sums.**")
    change(root, "SPEC.md", "**1.2** A", "**1.1** A")
    change(root, "SPEC.md", "**1.9 Sums.**", "**1.2 Sums.**")
    _, _, wrong = traced(root, capsys)
    assert [each.partition(": ")[2].partition(":")[0] for each in wrong] == ["SPEC 1.1 was SPEC 1.2", "SPEC 1.2 was SPEC 1.1"]
    with pytest.raises(ToolError, match="not changed: 2 clauses have other numbers"):
        traced(root, capsys, "--accept")


def test_accept_takes_new_clauses_and_other_words(root, capsys):
    change(root, "SPEC.md", "A sum is", "The sum is")
    change(root, "SPEC.md", "# Page", "# Page\n\n**1.4** (informative) New.")
    assert traced(root, capsys, "--accept")[0] == 0
    assert traced(root, capsys)[0] == 0


def test_a_reason_for_what_is_no_normative_clause_is_refused(root, capsys):
    (root / trace.UNBROKEN).write_text('[reasons]\n"SPEC 1.2.1" = "r"\n"beams 2.1" = "r"\n')
    _, _, wrong = traced(root, capsys)
    assert len(wrong) == 1 and "'SPEC 1.2.1' is no normative clause" in wrong[0]


# --- sentences -----------------------------------------------------------------------

PAGE = """**1.1 Sums.** A sum is exact, e.g. that of two
numbers. It has a [sign](a.md). Of three:

| row | says |
| --- | --- |
| first | `a` |

* An entry, which goes
  on. It ends.

    no = sentence;

1. A step.
"""


def test_sentences_entries_and_rows_are_found_with_their_lines():
    [clause] = clauses.of_text("SPEC.md", PAGE)
    assert [(each.line, each.words) for each in clause.sentences] == [
        (1, "A sum is exact, e.g. that of two"), (2, "It has a sign."), (2, "Of three:"), (6, "first a"),
        (8, "An entry, which goes on."), (9, "It ends."), (13, "A step.")]


def record_of(sentences_):
    return [(each.letter, each.state, each.words) for each in sentences_]


@pytest.mark.parametrize("old, new, letters, gone", [
    ("", "", "abcdefg", []), ("It has", "It wraps. It has", "ahbcdefg", []), ("It has a", "It had a", "abcdefg", []),
    ("* An entry", "* A new one.\n* An entry", "abcdhefg", []), (" It ends.", "", "abcdeg", ["f"]), ("| first", "| last", "abcdefg", [])])
def test_a_sentence_keeps_its_letter(old, new, letters, gone):
    [before], [after] = clauses.of_text("SPEC.md", PAGE), clauses.of_text("SPEC.md", PAGE.replace(old, new, 1))
    sentences.name_new(before.sentences, [])
    record = record_of(before.sentences)
    assert "".join(letter for letter, _, _ in record) == "abcdefg"
    assert sentences.match(after.sentences, record) == gone
    sentences.name_new(after.sentences, record)
    assert "".join(each.letter for each in after.sentences) == letters


def test_there_are_letters_enough():
    many = [sentences.Sentence(1, str(number)) for number in range(60)]
    sentences.name_new(many, [])
    assert [many[number].letter for number in (25, 26, 27, 52)] == ["z", "aa", "ab", "ba"] and len({each.letter for each in many}) == 60


@pytest.fixture
def two(root):
    """The checkout with a second sentence in SPEC 1.1, the first one tagged."""
    change(root, "SPEC.md", "of two numbers.", "of two numbers. It wraps.")
    change(root, "host_tests/unit/test_a.c", "SPEC 1.1, 1.2", "SPEC 1.1a, 1.2")
    trace.main(["--root", str(root), "--build", str(root / "build"), "--accept"])
    return root


def test_a_new_sentence_needs_a_test_or_is_prose(two, capsys):
    code, _, wrong = traced(two, capsys)
    assert code == 1 and len(wrong) == 1 and wrong[0].startswith("SPEC.md:3: SPEC 1.1b ('It wraps.') has no test")
    for state in (", prose", ", open"):
        change(two, str(clauses.RECORD), "SPEC 1.1b:", f"SPEC 1.1b{state}:")
        assert traced(two, capsys)[0] == 0
        assert traced(two, capsys, "--accept")[0] == 0      # which keeps it
        assert f"SPEC 1.1b{state}: " in (two / clauses.RECORD).read_text()
        change(two, "host_tests/unit/test_a.c", "SPEC 1.1a", "SPEC 1.1a, 1.1b")
        code, _, wrong = traced(two, capsys)
        assert code == 1 and len(wrong) == 1 and "has a test, host_tests/unit/test_a.c:1: take" in wrong[0]
        assert (traced(two, capsys, "--accept")[0] == 0) == (state == ", open")
        change(two, str(clauses.RECORD), "SPEC 1.1b:" if state == ", open" else f"SPEC 1.1b{state}:", "SPEC 1.1b:")
        assert traced(two, capsys)[0] == 0
        change(two, "host_tests/unit/test_a.c", "SPEC 1.1a, 1.1b", "SPEC 1.1a")


@pytest.mark.parametrize("file, old, new, words", [
    ("host_tests/unit/test_a.c", "SPEC 1.1a", "SPEC 1.1c", "the tag 'SPEC 1.1c' names no clause"),
    ("SPEC.md", "It wraps.", "It does not.", "'It does not.' of SPEC 1.1 is not in"),
    ("SPEC.md", " It wraps.", "", "there is no sentence SPEC 1.1b any more"),
    (str(clauses.RECORD), "SPEC 1.1b: ", "SPEC 1.1b, proze: ", "is not 'id: first words'")])
def test_a_sentence_that_is_not_as_on_record_is_named(two, capsys, file, old, new, words):
    change(two, file, old, new)
    try:
        code, _, wrong = traced(two, capsys)
    except ToolError as error:
        code, wrong = 1, [str(error)]
    assert code == 1 and any(words in each for each in wrong), wrong


def test_a_row_of_a_proof_shows_a_sentence(two, capsys):
    (two / "host_tests/proofs/math").mkdir(parents=True)
    row = '/* [[row]]\n * function = "lib/a.c:sum"\n * property = "it wraps"\n * clause = "SPEC 1.1b"\n */\nvoid sum(void)\n{\n}\n'
    (two / "host_tests/proofs/math/a.c").write_text(row)
    assert traced(two, capsys)[0] == 0
    assert "make prove: sum" in traced(two, capsys, "--only", "SPEC 1.1")[1]
    change(two, "host_tests/proofs/math/a.c", "SPEC 1.1b", "SPEC 1.1 b")
    with pytest.raises(ToolError, match="make prove: sum: clause = 'SPEC 1.1 b' is no list of clauses"):
        traced(two, capsys)


# --- what is broken ------------------------------------------------------------------

def test_mutants_are_of_the_tagged_lines_alone(root):
    (root / "lib/room").mkdir()
    (root / "lib/room/a.c").write_text(CODE)
    found = trace_break.tagged_mutants(root, clauses.c_code("lib/room/a.c", CODE, PAGES)[1:2])
    assert {mutant.line for _, mutant in found} == {12} and "(void)0;" in {mutant.becomes for _, mutant in found}


def result(changes, monkeypatch, seeded=()):
    """What breaking a clause shows whose mutants give these results, in their order."""
    class Mutant:
        def __init__(self, number):
            self.number = number

    results = iter(changes)
    breaker = trace_break.Breaker(types.SimpleNamespace(folder=CHECKOUT), {})
    monkeypatch.setattr(breaker, "check", lambda *_: None)
    monkeypatch.setattr(breaker, "try_change", lambda *_: {"change": "c", "result": next(results)})
    monkeypatch.setattr(trace_break, "tagged_mutants", lambda *_: [((number,), Mutant(number)) for number in range(40)])
    return breaker.clause("SPEC 1.1", [], [], list(seeded))


K, S, N = "killed", "survived", "same machine code"


@pytest.mark.parametrize("changes, shown, by", [
    ([K, K, K, K, S], True, "4 of 5 mutants"), ([K, N, K, N, K, K, K], True, "5 of 5 mutants"),
    ([K, K, K, S, S, K, K, K, K, K], True, "8 of 10 mutants"), ([K, S, S, S], False, "1 of 4 mutants killed"),
    ([N] * 30, False, "0 of 0 mutants killed")])
def test_four_of_five_mutants_are_killed(monkeypatch, changes, shown, by):
    found = result(changes, monkeypatch)
    assert (found["shown"], found["by"], len(found["tried"])) == (shown, by, len(changes))


def test_a_seeded_bug_that_is_caught_is_enough(monkeypatch):
    found = result([S, K], monkeypatch, ["one", "two"])
    assert found["shown"] and [each["result"] for each in found["tried"]] == [S, K]
    assert result([S, K, K, K, K, K], monkeypatch, ["one"])["by"] == "5 of 5 mutants"


def test_what_is_not_seen_needs_a_reason_and_a_reason_goes_when_it_is_seen():
    results = [{"clause": "SPEC 1.1", "shown": False, "by": "b", "tried": [{"change": "c", "result": S}]},
               {"clause": "SPEC 1.2", "shown": True, "by": "b", "tried": []}]
    [first, second] = trace.judge_broken(results, {"SPEC 1.2": "r"})
    assert first.startswith("SPEC 1.1: its tests do not see it broken (b; survived: c): write a test that does")
    assert "SPEC 1.2 is shown to break now (by b): take its line out" in second
    assert trace.judge_broken(results, {"SPEC 1.1": "r"}) == []


# --- the project ---------------------------------------------------------------------

def test_each_clause_has_its_code_and_its_tests(tmp_path):
    done = run_cli("trace", "--build", tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_sample_of_clauses_is_seen_when_it_is_broken(tmp_path):
    """All of them: make trace BREAK=1."""
    done = run_make("trace", "BREAK=1", f"SAMPLE={SAMPLE}")
    assert done.returncode == 0, done.stdout + done.stderr
    assert re.search(r"(\d+) of \1 clauses broken are seen", done.stdout)


def test_kernels_with_few_inputs_are_named_and_keep_a_release_back(root, capsys, monkeypatch):
    record = root / "record.txt"
    record.write_text(f"m0 fill {3 * 'abcd'} {3 * 'abcd'} 10000\nm3 fill {3 * 'abcd'} {3 * 'abcd'} 10000000\n")
    monkeypatch.setattr(equality, "RECORD", record)
    code, printed, wrong = traced(root, capsys)
    assert code == 0 and not wrong and "1 of 2 kernels" in printed and "fill 10,000 (m0)" in printed
    kernel = kernel_text.Kernel("fill", 1, 3 * "abcd", 3 * "abcd")
    for machine, short in ((kernel.machine, []), (3 * "0123", ["1 kernels"])):
        monkeypatch.setattr(equality, "programs_of", lambda _, machine=machine: {"m3": [kernel._replace(machine=machine)]})
        code, printed, wrong = traced(root, capsys, "--release", "--cores", "m3")
        assert code == len(short) and len(wrong) == len(short) and all(words in wrong[0] for words in short)
        assert ("fill 0 (m3)" in printed) == bool(short)
