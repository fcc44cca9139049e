# SPDX-License-Identifier: MIT
"""What make mutants takes for a mistake in a tool, which tests it tries first, and the survivors that it knows."""

import pytest
from conftest import CHECKOUT

from fixel.base.errors import ToolError
from fixel.check import likely, mutate_python, survivors

CODE = '''"""A text with 1 + 1."""
LIMIT = 1 + 1
def f(a, b):
    """a < b and 2"""
    assert a < 3
    %s
'''


def becomes(statement):
    return {(mutant.was, mutant.becomes) for mutant in mutate_python.mutants("a.py", CODE % statement)}


@pytest.mark.parametrize("statement, expected", [
    ("return a < b", {("<", "<="), ("<", ">=")}),
    ("return a in b", {("in", "not in")}),
    ("return a and not b", {("and", "or"), ("not ", "")}),
    ("return a + 3", {("+", "-"), ("3", "4"), ("3", "2")}),
    ("return 'é' + a, a // b", {("//", "*")}),
    ("return '%d' % a", set()),
    ("return f'{a + 1}'", set()),
    ("return True", {("True", "False")}),
    ("a(b)", {("a(b)", "pass")}),
    ("c = a", set()),
    ("a.c = b", {("a.c = b", "pass")}),
    ("a[b] += b", {("a[b] += b", "pass")}),
    ("raise ValueError(f'{a} is not {1}')", {("raise ValueError(f'{a} is not {1}')", "pass")}),
])
def test_mistakes(statement, expected):
    assert becomes(statement) == expected


def test_a_mutant_changes_its_place_alone():
    text = CODE % "return 'äöü', a < b"
    for mutant in mutate_python.mutants("a.py", text):
        assert mutant.apply(text) == text.replace("äöü', a < b", f"äöü', a {mutant.becomes} b")
        assert str(mutant) == f"a.py:6: '<' becomes '{mutant.becomes}'"


def test_every_tool_can_be_mutated():
    for path in sorted((CHECKOUT / "tools" / "fixel").rglob("*.py")):
        text = path.read_text(encoding="utf-8")
        for mutant in mutate_python.mutants(path.name, text)[::17]:
            compile(mutant.apply(text), path.name, "exec")


def test_the_likeliest_tests_come_first():
    found = likely.Map(CHECKOUT)
    for module, first in (("image/bdf.py", "test_font.py"), ("model/stl.py", "test_stl.py"), ("board/qmp.py", "test_qmp.py"),
                          ("base/output.py", "test_output.py")):
        tests = [test.name for test in found.tests(f"tools/fixel/{module}")]
        assert first in tests[:3], (module, tests[:5])
        assert len(tests) == len(set(tests))


def survivor(folder, **changes):
    entry = {"file": "a.py", "line": "return a < b", "change": "'<' becomes '<='", "reason": "a is never b", **changes}
    file = folder / "survivors.toml"
    file.write_text("[[survivors]]\n" + "".join(f'{name} = "{value}"\n' for name, value in entry.items()), encoding="utf-8")
    return file


def test_a_survivor_that_is_known(tmp_path):
    text = CODE % "return a < b"
    (tmp_path / "a.py").write_text(text, encoding="utf-8")
    known = survivors.load(survivor(tmp_path), tmp_path, mutate_python.mutants)
    keys = [("a.py", survivors.line_of(mutant, text), survivors.change_of(mutant))
            for mutant in mutate_python.mutants("a.py", text)]
    assert [key in known for key in keys] == [True, False]


@pytest.mark.parametrize("changes, words", [
    ({"line": "return a < c"}, "no longer has the line 'return a < c'"),
    ({"change": "'<' becomes '=='"}, "with the change '<' becomes '=='"),
    ({"file": "gone.py"}, "gone.py no longer has"), ({"reason": " "}, "survivor 1: it needs"), ({"more": "x"}, "it needs")])
def test_a_survivor_whose_line_has_changed_is_refused(tmp_path, changes, words):
    (tmp_path / "a.py").write_text(CODE % "return a < b", encoding="utf-8")
    with pytest.raises(ToolError, match=words):
        survivors.load(survivor(tmp_path, **changes), tmp_path, mutate_python.mutants)


def test_the_survivors_of_the_project_are_there():
    survivors.load(CHECKOUT / "host_tests" / "tools" / "survivors.toml", CHECKOUT, mutate_python.mutants)
