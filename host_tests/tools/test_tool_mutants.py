# SPDX-License-Identifier: MIT
"""What make mutants takes for a mistake in a tool, how it tries one, and the survivors that it knows."""

import sys

import pytest
from conftest import CHECKOUT, write_files

from fixel.base.errors import ToolError
from fixel.check import lines, mutants, mutate_python, mutate, tool_mutants

BUILT_PROGRAMS = ()
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
    ("raise AssertionError('never')", set()),
    ("raise", {("raise", "pass")}),
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


def survivor(folder, **changes):
    entry = {"file": "a.py", "line": "return a < b", "change": "'<' becomes '<='", "reason": "a is never b", **changes}
    file = folder / "survivors.toml"
    file.write_text("[[survivors]]\n" + "".join(f'{name} = "{value}"\n' for name, value in entry.items()), encoding="utf-8")
    return file


def test_a_survivor_that_is_known(tmp_path):
    text = CODE % "return a < b"
    (tmp_path / "a.py").write_text(text, encoding="utf-8")
    known = mutate.load(survivor(tmp_path), tmp_path, mutate_python.mutants)
    keys = [key[:3] for key, _ in mutate.keyed(mutate_python.mutants("a.py", text), text)]
    assert [known.get(key) for key in keys] == ["a is never b", None]


@pytest.mark.parametrize("changes, words", [
    ({"line": "return a < c"}, "no longer has the line 'return a < c'"),
    ({"change": "'<' becomes '=='"}, "with the change '<' becomes '=='"),
    ({"file": "gone.py"}, "gone.py no longer has"), ({"reason": " "}, "survivor 1: it needs"), ({"more": "x"}, "it needs")])
def test_a_survivor_whose_line_has_changed_is_refused(tmp_path, changes, words):
    (tmp_path / "a.py").write_text(CODE % "return a < b", encoding="utf-8")
    with pytest.raises(ToolError, match=words):
        mutate.load(survivor(tmp_path, **changes), tmp_path, mutate_python.mutants)


def test_the_survivors_of_the_project_are_there():
    mutate.load(CHECKOUT / mutants.KNOWN, CHECKOUT, mutants.mutants_of)


def test_a_change_of_one_line_moves_no_other_mutant():
    def order(text):
        keyed = mutate.keyed(mutate_python.mutants("a.py", text), text)
        return [key for key, _ in sorted(keyed, key=lambda pair: mutate.place_of(7, pair[0])) if "a < b" in key[1]]
    before = CODE % "a < b; a < b"
    assert len(order(before)) == 4
    assert order(before) == order("x = 1\n\n" + before + "    return 3 * a\n") != sorted(order(before))


def test_the_function_of_a_line():
    functions = lines.Functions("def f():\n    def g():\n        pass\n\n\nclass C:\n    @m\n    def h(self):\n        pass\n")
    assert [functions.place(line) for line in range(1, 10)] == \
        [("f", 0), ("f", 1), ("f", 2), None, None, None, ("C.h", 0), ("C.h", 1), ("C.h", 2)]


def test_functions_of_tests_and_their_arguments():
    text = "def test_a(b):\n    pass\n\n\n@c\nasync def test_d(e):\n    pass\n\n\ndef f():\n    pass\n"
    assert list(lines.functions_of(text)) == ["test_a", "test_d"]
    assert lines.arguments_of(text) == {"test_a": ["b"], "test_d": ["e"], "f": []}


def test_the_first_parameters_of_all_tests_come_first_and_those_of_files_with_a_tools_name():
    tests = {"f/test_a.py::a[1]", "f/test_a.py::a[2]", "f/test_a.py::a[3]", "f/test_a.py::b", "f/test_c.py::c"}
    assert [test[-4:] for test in lines.spread(tests)] == ["a[1]", "y::b", "y::c", "a[2]", "a[3]"]
    assert [test[-4:] for test in lines.spread(tests, "x/c.py")] == ["y::c", "a[1]", "y::b", "a[2]", "a[3]"]


class Recorder:
    """In place of a copy of the checkout: test_ab[0] takes a second, so the later parameters are skipped; all tests execute
    line 2 of a tool, and those of test_b line 3 too."""

    def __init__(self, folder):
        self.folder, self.asked = folder, []
        write_files(folder, {"tools/fixel/a.py": "def f():\n    pass\n    pass\n"})
        (folder / "host_tests").symlink_to(folder.parent / "host_tests")

    def run(self, tests, cpu, lines, enough):
        self.asked += tests
        report = []
        for number, test in enumerate(each for name in tests for each in ((f"{name}[0]", f"{name}[1]") if name.endswith("ab") else (name,))):
            skipped = test.endswith("[1]")
            report.append({"test": test, "passed": not skipped, "skipped": skipped, "cpu": 1.0 - skipped, "number": number})
            if not skipped:
                (lines / str(number)).write_text("a.py:2\n" + "a.py:3\n" * test.endswith("b"), encoding="utf-8")
        return 0, report

    def record(self):
        pass

    def close(self):
        pass


def test_only_functions_of_tests_that_are_new_or_changed_are_recorded(tmp_path):
    tests, tree = tmp_path / "host_tests/tools/test_a.py", Recorder(tmp_path / "tree")
    tests.parent.mkdir(parents=True)
    mutant = mutate_python.mutants("tools/fixel/a.py", "def f():\n    x.y = 1\n    z.y = 1\n")
    text = "def f():\n    pass\n    pass\n"

    def records(content):
        tests.write_text(content, encoding="utf-8")
        tree.asked.clear()
        made = lines.Records(tmp_path / "records", tmp_path)
        made.complete(lambda: [tree])
        return [[each.partition("::")[2] for each in made.tests(mutant[place], text)] for place in (0, -1)], \
            [each.partition("::")[2] for each in tree.asked]
    a, b, ab = ("def test_a():\n    pass\n", "def test_b():\n    pass\n", "def test_ab(x):\n    pass\n")
    assert records(a + b) == ([["test_a", "test_b"], ["test_b"]], ["test_a", "test_b"])
    assert records("# other lines\n" + b + "\n\n" + a) == ([["test_a", "test_b"], ["test_b"]], [])
    # A parameter that was skipped is taken for like the one that was recorded.
    assert records(a + b + ab) == ([["test_a", "test_ab[0]", "test_b", "test_ab[1]"], ["test_b"]], ["test_ab"])
    assert records(a.replace("pass", "x = 1") + ab) == ([["test_a", "test_ab[0]", "test_ab[1]"], []], ["test_a"])
    assert records(ab) == ([["test_ab[0]", "test_ab[1]"], []], [])
    (record,) = (tmp_path / "records").iterdir()
    record.write_text('{"of": "another version"}', encoding="utf-8")
    assert records(ab)[1] == ["test_ab"]


class Slow:
    """In place of a copy of the checkout: what each function of tests does, or that it does not end, by its name."""

    def __init__(self, folder, text):
        self.folder, self.asked = folder, []
        write_files(folder, {"tools/fixel/a.py": "def f():\n    pass\n", "host_tests/test_a.py": text})

    def run(self, tests, cpu, lines, enough):
        self.asked.append([test.partition("::")[2] for test in tests])
        report = []
        for number, test in enumerate(tests, 1):
            in_fixture = "\nslow" if "fixture" in test else "\n"
            (lines / "begun").write_text(test + in_fixture, encoding="utf-8")
            (lines / str(number)).write_text("a.py:2", encoding="utf-8")
            if "slow" in test:
                return "it used 6 s of CPU time", report
            report.append({"test": test, "passed": True, "skipped": False, "cpu": 1.0, "number": number})
        return 0, report


def test_functions_after_one_that_does_not_end_are_recorded(tmp_path):
    names = {"test_1": "", "test_slow": "quick", "test_2": "quick", "test_slow_fixture": "quick, slow", "test_3": "slow",
             "test_4": "quick"}
    tree = Slow(tmp_path, "".join(f"def {name}({arguments}):\n    pass\n" for name, arguments in names.items()))
    made = lines.record(tree, "test_a.py", list(names))
    assert tree.asked == [list(names), list(names)[1:], list(names)[2:], ["test_4"]]
    # A test that does not end is not known, nor what needs a fixture that does not end.
    assert made["tests"] == [f"test_a.py::test_{word}" for word in "124"]
    assert made["lines"] == {"tools/fixel/a.py:f:1": [f"test_a.py::test_{word}" for word in "124"]}
    again = Slow(tmp_path / "again", "".join(f"def test_slow{number}():\n    pass\n" for number in range(9)))
    lines.record(again, "test_a.py", [f"test_slow{number}" for number in range(9)])
    assert len(again.asked) == lines.RUNS


class Endless:
    """In place of a copy of the checkout: tests that do not end with a mutant, nor perhaps without it."""

    def __init__(self, folder, original, ends):
        self.folder, self.original, self.ends = folder, original, ends

    def write(self, file, text):
        (self.folder / file).write_text(text, encoding="utf-8")

    def run(self, tests, _cpu, *_):
        if self.ends and (self.folder / "a.py").read_text(encoding="utf-8") == self.original:
            return 0, [{"test": test, "passed": True} for test in tests]
        return "it used 15 s of CPU time", []


@pytest.mark.parametrize("ends, result", [(True, "killed"), (False, "survived")])
def test_a_test_that_does_not_end_kills_if_it_ends_without_the_mutant(tmp_path, ends, result):
    text = "def f(a):\n    return a < 1\n"
    (tmp_path / "a.py").write_text(text, encoding="utf-8")
    mutant = mutate_python.mutants("a.py", text)[0]
    assert tool_mutants.Trial(Endless(tmp_path, text, ends)).run(mutant, ["t"])["result"] == result


class Missing:
    """In place of a copy of the checkout: pytest runs nothing where it does not find a test."""

    def __init__(self, folder):
        self.folder = folder

    def write(self, file, text):
        (self.folder / file).write_text(text, encoding="utf-8")

    def run(self, tests, _cpu, *_):
        if "gone" in tests:
            return 4, []
        passed = (self.folder / "a.py").read_text(encoding="utf-8") == ALONE
        return int(not passed), [{"test": test, "passed": passed} for test in tests]


ALONE = "def f(a):\n    return a < 1\n"


def test_a_test_that_is_gone_keeps_no_other_from_killing(tmp_path):
    (tmp_path / "a.py").write_text(ALONE, encoding="utf-8")
    trial, mutant = tool_mutants.Trial(Missing(tmp_path)), mutate_python.mutants("a.py", ALONE)[0]
    assert trial.run(mutant, ["gone", "t"]) == {"result": "killed"}
    assert trial.run(mutant, ["gone"]) == {"result": "survived", "words": "no test that passes without it executes it"}


# --- a campaign in a checkout of a few lines ------------------------------------

TOOL = """
def limit(value):
    return value < 3


def positive(value):
    if value > 0:
        return value
    return 0


def forgotten(value):
    return value or 3


def called(value):
    value.append(1)


def ends(value):
    while value > 0:
        value -= 1


def alone(value):
    return value == 1
"""
TESTS = """
import pathlib
import subprocess
import sys

import pytest

from fixel import a

MARK = pathlib.Path(%(mark)r)


@pytest.mark.parametrize("value", [2, 3])
def test_limit(value):
    assert a.limit(value) == (value == 2)


@pytest.mark.parametrize("value", [-1, 0, 1])
def test_positive(value):
    assert a.positive(value) == max(value, 0)


def test_that_fails():
    assert a.forgotten(3) == 4


def test_that_fails_later():
    assert a.forgotten(3) == 3
    assert not MARK.exists()


def test_called_by_a_program():
    program = "from fixel import a; found = []; a.called(found); assert found"
    subprocess.run([sys.executable, "-c", program], check=True, cwd=pathlib.Path(__file__).parents[2] / "tools")


def test_ends():
    a.ends(2)


def test_in_a_process_that_looks_at_no_variable():
    program = f"import sys; sys.path.insert(0, {str(pathlib.Path(__file__).parents[2] / 'tools')!r}); from fixel import a; assert a.alone(1)"
    subprocess.run([sys.executable, "-I", "-c", program], check=True)
"""
CONFTEST = """
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tools"))
"""
WHERE = "tools/fixel/a.py"


TRIED = [
    ("return value < 3", "'<' becomes '>='", "killed", ""),
    ("return value < 3", "'3' becomes '2'", "killed", ""),
    ("if value > 0:", "'>' becomes '<='", "killed", ""),
    ("if value > 0:", "'0' becomes '1'", "killed", ""),
    ("if value > 0:", "'>' becomes '>='", "known", "0 is answered by 0 either way"),
    ("value.append(1)", "'value.append(1)' becomes 'pass'", "killed", ""),
    ("return value == 1", "'==' becomes '!='", "killed", ""),
    ("return value or 3", "'or' becomes 'and'", "survived", "no test that passes without it"),
    ("value -= 1", "'value -= 1' becomes 'pass'", "killed", ""),
    ("while value > 0:", "'>' becomes '>='", "survived", ""),
]


@pytest.fixture(scope="module")
def campaign(tmp_path_factory):
    """[(mutant, result)] of some mutants of a small tool."""
    folder = tmp_path_factory.mktemp("campaign")
    checkout, mark = folder / "checkout", folder / "mark"
    write_files(checkout, {"tools/fixel/__init__.py": "", WHERE: TOOL, "host_tests/pytest.ini": "[pytest]\n",
                           "host_tests/conftest.py": CONFTEST, "host_tests/tools/test_a.py": TESTS % {"mark": str(mark)}})
    (checkout / ".venv").symlink_to(sys.prefix)
    records = lines.Records(folder / "lines", checkout)
    records.complete(lambda: [tool_mutants.Tree(folder / "recorded", checkout)])
    mark.touch()
    wanted = [(line, change) for line, change, _, _ in TRIED]
    drawn = [each for each in mutants.draw(tool_mutants.files(checkout), "", 1, checkout) if each[0][1:3] in wanted]
    known = {(WHERE, "if value > 0:", "'>' becomes '>='"): "0 is answered by 0 either way"}
    tree = tool_mutants.Tree(folder / "tree", checkout)
    trial = tool_mutants.Trial(tree)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(tool_mutants, "CPU_MORE", 1.0)
        patch.setattr(tool_mutants, "CPU_TEST", 0.5)
        tried = mutants.try_all(drawn, 100, known, lambda some: {place: trial.run(mutant, records.tests(mutant, TOOL))
                                                                 for place, _, mutant in some})
    assert (tree.folder / WHERE).read_text(encoding="utf-8") == TOOL
    tree.close()
    return tried


@pytest.mark.parametrize("line, change, result, words", TRIED)
def test_what_becomes_of_a_mutant(campaign, line, change, result, words):
    text = TOOL.split("\n")
    found = [each for mutant, each in campaign if text[mutant.line - 1].strip() == line and mutate.change_of(mutant) == change]
    assert [each["result"] for each in found] == [result], found
    assert words in found[0].get("words", "")


def test_what_changes_no_result_is_told_apart_and_not_counted(campaign, capsys):
    result = mutants.judge(campaign, 1)
    assert result["known"] == 1
    assert result["count"] == len(campaign) - 1 == result["killed"] + sum(each["result"] == "survived" for _, each in campaign)
    mutants.print_result("tools", result)
    said = capsys.readouterr().out.splitlines()
    assert f"changes no result: {WHERE}:7: '>' becomes '>=' (0 is answered by 0 either way)" in said
    assert f"survived: {WHERE}:13: 'or' becomes 'and' (no test that passes without it executes it)" in said
    assert said[-1].startswith(f"{result['killed']} of {result['count']} mutants of the tools killed: ")
    assert said[-1].endswith("Not counted: 1 that change no result (host_tests/build/survivors.toml)")


def test_a_sample_ends_with_the_last_that_counts():
    tried = [("a", {"result": "killed"}), ("b", {"result": "known"}), ("c", {"result": "survived"}), ("d", {"result": "killed"})]
    assert mutants.up_to(tried, 2) == tried[:3]
    assert mutants.up_to(tried, 9) == tried


def test_as_many_more_are_tried_as_do_not_count():
    drawn, asked = [((str(number), "", "", 1), number) for number in range(20)], []
    known = {("3", "", ""): "known"}

    def compute(some):
        asked.append([place for place, _, _ in some])
        return {place: {"result": "killed" if place % 2 else "no mutant"} for place, _, _ in some}

    tried = mutants.try_all(drawn, 4, known, compute)
    assert [number for number, _ in tried] == list(range(10)) and tried[3][1] == {"result": "known", "words": "known"}
    assert asked == [[0, 1, 2, 4], [5, 6, 7], [8], [9]]
    assert [number for number, _ in mutants.try_all(drawn, 99, known, compute)] == list(range(20))


def test_a_tree_has_journals_of_its_own(tmp_path):
    """A mutant of scratch.py may take the temporary files of commands that live for left over: it must not know them."""
    checkout = tmp_path / "checkout"
    write_files(checkout, {"tools/fixel/base/scratch.py": "", "host_tests/a.py": "", "build/.scratch/1-a": "", "build/host/frames": "", "README.md": ""})
    tree = tool_mutants.Tree(tmp_path / "tree", checkout).folder
    assert not (tree / "build/.scratch").exists() and not (tree / "build").is_symlink()
    assert (tree / "build/host/frames").exists() and (tree / "README.md").is_symlink()
