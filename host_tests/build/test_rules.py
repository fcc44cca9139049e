# SPDX-License-Identifier: MIT
"""make rules without cppcheck: what of its words is a finding, what the page allows, what is new against the record. The command
itself runs by test_commands.py."""

import json
import subprocess

import pytest

from conftest import CHECKOUT
from fixel.base.errors import ToolError
from fixel.check import rules

BUILT_PROGRAMS = ()
PAGE = """| rule | what it asks | decision | files | reason |
| --- | --- | --- | --- | --- |
| 15.5 | one return | deviated | `lib/clip/*` | refusals come first |
| 21.3 | no heap | kept | | |
| 12.1 | parentheses | disapplied | | the sequence of C |
| P1 | 15.5 | a letter | `^[a-c] =` | nothing |
"""
TEXT = "a = 1;\nb = 2;\nb = 2;\nc = 3;\n"


@pytest.fixture(name="root")
def fixture_root(tmp_path):
    """A checkout with one file, and its page."""
    (tmp_path / "lib" / "clip").mkdir(parents=True)
    (tmp_path / "lib" / "clip" / "a.c").write_text(TEXT, encoding="utf-8")
    (tmp_path / "rules.md").write_text(PAGE, encoding="utf-8")
    return tmp_path


def found(root, *places):
    return rules.of_words([f"lib/clip/a.c:{line}:misra-c2012-{rule}:misra violation\n" for line, rule in places], root)


def test_what_cppcheck_prints_is_read(root):
    words = ["lib/clip/a.c:4:misra-c2012-15.5:misra violation\n", "lib/clip/a.c:1:misra-c2012-15.5:misra violation\n",
             "lib/clip/a.c:4:misra-c2012-15.5:the same line in another column\n", "lib/clip/a.c:2:variableScope:a word of its own\n"]
    assert rules.of_words(words, root) == [rules.Finding("lib/clip/a.c", 1, "15.5", "a = 1;"), rules.Finding("lib/clip/a.c", 4, "15.5", "c = 3;")]


def test_the_page_is_read(root):
    page = rules.read_page(root / "rules.md")
    assert page == {"15.5": rules.Rule("one return", "deviated", ("lib/clip/*",), "refusals come first"),
                    "21.3": rules.Rule("no heap", "kept", (), ""), "12.1": rules.Rule("parentheses", "disapplied", (), "the sequence of C")}
    (permit,) = rules.read_permits(root / "rules.md")
    assert (permit.name, permit.rule, permit.construct, permit.stands) == ("P1", "15.5", "a letter", "nothing")


@pytest.mark.parametrize("row, words", [
    ("| 8.7 | static | deviated | | a reason |", "has files and a reason"), ("| 8.7 | static | deviated | `lib/*` | |", "has files and a reason"),
    ("| 8.7 | static | kept | `lib/*` | why |", "has files and a reason"), ("| 8.7 | static | perhaps | | |", "a row is"),
    ("| 8.7 | static | kept |", "a row is"), ("| 10.1 | operands | disapplied | | why |", "advisory"),
    ("| 8.7 | static | disapplied | | |", "advisory"), ("| 8.7 | static | disapplied | `lib/*` | why |", "has files and a reason"), ("| 21.3 | no heap | kept | | |", "stands there twice")])
def test_a_row_that_decides_nothing_is_refused(root, row, words):
    (root / "rules.md").write_text(f"{PAGE}{row}\n", encoding="utf-8")
    with pytest.raises(ToolError, match=words):
        rules.read_page(root / "rules.md")


@pytest.mark.parametrize("row, words", [
    ("| P2 | 15.5 | all | any | nothing |", "a permit is"), ("| P2 | 15.5 | `x` |", "a permit is"), ("| P1 | 15.5 | all | `x` | nothing |", "twice"),
    ("| P2 | 15.5 | all | `(` | nothing |", "P2: no expression")])
def test_a_permit_that_names_no_construct_is_refused(root, row, words):
    (root / "rules.md").write_text(f"{PAGE}{row}\n", encoding="utf-8")
    with pytest.raises(ToolError, match=words):
        rules.read_permits(root / "rules.md")


def test_a_finding_without_a_permit_is_found(root):
    page, permits = rules.read_page(root / "rules.md"), rules.read_permits(root / "rules.md")
    other = rules.Finding("lib/clip/a.c", 9, "15.5", "return a;")
    assert rules.without_permit(page, permits, [*found(root, (1, "15.5"), (2, "12.1"), (3, "21.3")), other]) == [other]
    assert rules.idle(permits, found(root, (1, "15.5"))) == [] and rules.idle(permits, [other]) == permits
    assert [rules.is_disapplied(page, each) for each in found(root, (1, "12.1"), (1, "15.5"))] == [True, False]


def test_what_the_page_does_not_allow_is_found(root):
    page = rules.read_page(root / "rules.md")
    assert [each.rule for each in rules.not_allowed(page, found(root, (1, "15.5"), (2, "21.3"), (3, "2.2")))] == ["2.2", "21.3"]
    elsewhere = rules.Finding("lib/draw/b.c", 1, "15.5", "a")
    assert rules.not_allowed(page, [elsewhere]) == [elsewhere]


def test_a_line_that_is_new_is_named_and_one_that_moved_is_not(root):
    record = json.loads(rules.record_text(found(root, (1, "15.5"), (2, "15.5"))))
    (root / "lib" / "clip" / "a.c").write_text("new;\n" + TEXT, encoding="utf-8")
    assert rules.new_findings(found(root, (2, "15.5"), (3, "15.5")), record) == []
    (added,) = rules.new_findings(found(root, (2, "15.5"), (3, "15.5"), (5, "15.5")), record)
    assert (added.line, added.text) == (5, "c = 3;")
    (twin,) = rules.new_findings(found(root, (2, "15.5"), (3, "15.5"), (4, "15.5")), record)
    assert twin.text == "b = 2;"
    assert len(rules.new_findings(found(root, (2, "21.3")), record)) == 1


def test_fewer_lines_are_counted_and_a_deviation_without_a_line_is_told(root):
    record = json.loads(rules.record_text(found(root, (1, "15.5"), (2, "15.5"), (4, "10.4"))))
    assert rules.count_of_fewer(found(root, (1, "15.5")), record) == 2
    assert rules.stale(rules.read_page(root / "rules.md"), []) == ["15.5", "12.1"]


@pytest.mark.parametrize("said, words", [("Cppcheck 2.17.1", "needs cppcheck 2.10, as Debian 12 has it; this is Cppcheck 2.17.1"), (None, "which is not there")])
def test_with_another_cppcheck_it_is_not_run(monkeypatch, said, words):
    monkeypatch.setattr(rules.shutil, "which", lambda name: said)
    monkeypatch.setattr(rules.children, "run", lambda *words, **how: subprocess.CompletedProcess(words, 0, f"{said}\n"))
    with pytest.raises(ToolError, match="not run: needs cppcheck 2.10") as refused:
        rules.require_version()
    assert words in str(refused.value) and refused.value.exit_code == 2


def test_the_right_cppcheck_is_taken(monkeypatch):
    monkeypatch.setattr(rules.shutil, "which", lambda name: name)
    monkeypatch.setattr(rules.children, "run", lambda *words, **how: subprocess.CompletedProcess(words, 0, "Cppcheck 2.10\n"))
    rules.require_version()


def test_a_new_finding_fails_and_says_where(root, monkeypatch, capsys):
    for folder in ("docs/safety", "host_tests/build", "build"):
        (root / folder).mkdir(parents=True)
    (root / rules.PAGE).write_text(PAGE, encoding="utf-8")
    (root / rules.RECORD).write_text(rules.record_text(found(root, (1, "15.5"))), encoding="utf-8")
    monkeypatch.setattr(rules, "ROOT", root)
    monkeypatch.setattr(rules, "require_version", lambda: None)
    monkeypatch.setattr(rules, "all_findings", lambda _: found(root, (1, "15.5"), (4, "15.5")))
    for options in ([], ["--renew"]):
        with pytest.raises(ToolError) as failed:
            rules.main(options)
        assert failed.value.exit_code == 1 and "lib/clip/a.c:4: rule 15.5: c = 3;" in failed.value.words
        assert "a.c:1:" not in failed.value.words
    assert rules.main(["--accept-new"]) == 0 and rules.main([]) == 0
    monkeypatch.setattr(rules, "all_findings", lambda _: [*found(root, (1, "15.5"), (2, "12.1")), rules.Finding("lib/clip/a.c", 4, "15.5", "return c;")])
    with pytest.raises(ToolError) as bare:
        rules.main(["--accept-new"])
    assert bare.value.exit_code == 1 and "lib/clip/a.c:4: rule 15.5: return c;" in bare.value.words and "12.1" not in bare.value.words
    monkeypatch.setattr(rules, "all_findings", lambda _: found(root, (4, "15.5")))
    capsys.readouterr()
    assert rules.main([]) == 0 and "1 findings fewer" in capsys.readouterr().out
    assert rules.main(["--renew"]) == 0 and json.loads((root / rules.RECORD).read_text())["lib/clip/a.c"]["15.5"].count(" ") == 0


def test_the_page_deviates_from_what_is_on_record_there():
    page = rules.read_page(CHECKOUT / rules.PAGE)
    record = json.loads((CHECKOUT / rules.RECORD).read_text(encoding="utf-8"))
    there = [rules.Finding(file, 0, rule, "") for file, lines in record.items() for rule in lines]
    disapplied = [rule for rule, said in page.items() if said.decision == "disapplied"]
    assert len(there) > 200 and rules.not_allowed(page, there) == [] and rules.stale(page, there) == disapplied
    assert not any(rules.is_disapplied(page, each) for each in there)
    permitted = {permit.rule for permit in rules.read_permits(CHECKOUT / rules.PAGE)}
    assert permitted == {rule for rule, said in page.items() if said.decision == "deviated"}
    assert all((CHECKOUT / file).is_file() for file in record)
