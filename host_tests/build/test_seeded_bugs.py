# SPDX-License-Identifier: MIT
"""The ledgers of breaks, how a break finds its line, and a test of the tests: bugs put into the library on purpose must each
be seen. make seeded-bugs tries all of them, these tests a sample."""

import concurrent.futures
import functools
import os
import pathlib
import shutil
import subprocess
import tempfile
import threading

import pytest
from board_programs import made
from conftest import CHECKOUT, run_cli

from fixel.base import sampling
from fixel.check import planting, seeded_bugs
from fixel.base.errors import ToolError

BUILT_PROGRAMS = ("*",)     # a sample of bugs is built from a copy of what is built
SAMPLE = 5


def test_there_are_bugs_of_every_kind():
    assert {"rounding", "sign", "carry", "fill rule", "shift"} <= {bug.kind for bug in planting.seeded(CHECKOUT)}


def test_each_break_applies():
    """Where one does not: give its entry the file, function and line in which the same mistake can be made now."""
    assert "\n".join(planting.stale(CHECKOUT, planting.entries(CHECKOUT)).values()) == ""


def test_no_two_entries_are_the_same_break():
    """They are one, with more tests, rows and clauses. A blind one has none of these, and stands beside the other."""
    found = {}
    for each in planting.entries(CHECKOUT):
        broken = each.apply((CHECKOUT / each.file).read_text(encoding="utf-8"))
        found.setdefault((each.blind, each.file, broken), []).append(each.id)
    assert [ids for ids in found.values() if len(ids) > 1] == []


def test_each_room_has_its_ledger():
    rooms = {path.name for path in (CHECKOUT / "lib").iterdir() if path.is_dir()} - {"include"}
    for each in planting.entries(CHECKOUT):
        folders = pathlib.PurePath(each.file).parts
        room = folders[1] if folders[0] == "lib" and folders[1] in rooms else "others"
        assert each.ledger == f"host_tests/breaks/{room}.toml", each.id


def test_each_bug_names_tests_that_there_are():
    assert {test for bug in planting.seeded(CHECKOUT) for test in bug.tests} <= set(seeded_bugs.all_tests(CHECKOUT))


def test_each_run_has_a_scene_and_a_bug_that_it_must_see():
    named = {test for bug in planting.seeded(CHECKOUT) for test in bug.tests}
    assert set(seeded_bugs.RUNS) <= named
    for test in seeded_bugs.RUNS:
        name = test.split("/")[1]
        assert sum((CHECKOUT / pattern.format(name)).exists() for pattern in seeded_bugs.RUN_SCENES) == 1, test


def test_the_library_has_no_marks():
    """A bug is found by its function and its line."""
    assert [file for file, text in planting.sources(CHECKOUT).items() if "/* bug:" in text] == []


FUNCTION = "static int f(int x)\n{\n%s    return x;\n}\n"


@pytest.fixture
def root(tmp_path):
    """A library of one file, and its bug."""
    (tmp_path / "lib").mkdir()
    (tmp_path / planting.FOLDER).mkdir(parents=True)
    write(tmp_path, FUNCTION % "    x = 1;\n")
    return tmp_path


def write(root, text, becomes="x = 2;", function="f", line="x = 1;", more="tests = ['test_a']", file="a.c"):
    (root / "lib" / file).write_text(text)
    record(root, entry(becomes=becomes, function=function, line=line, more=more))


def record(root, text, ledger="a"):
    (root / planting.FOLDER / f"{ledger}.toml").write_text(text)


def entry(name="one", becomes="x = 2;", function="f", line="x = 1;", more="tests = ['test_a']"):
    quotes = '"""'
    return (f"['lib/a.c'.{function}.{name}]\nkind = 'k'\nwhy = 'w'\n"
            f"line = {quotes}{line}{quotes}\nbecomes = {quotes}{becomes}{quotes}\n{more}\n")


def stale(root):
    return list(planting.stale(root, planting.entries(root)).values())


def seeded(root):
    [bug] = planting.seeded(root)
    return bug.apply((root / bug.file).read_text())


@pytest.mark.parametrize("text, becomes, result", [
    ("    x = 1;\n", "x = 2;", "    x = 2;\n"),
    ("    x = 1;\n", "x = 2;\nz = 3;", "    x = 2;\n    z = 3;\n"),
    ("    x = 1;\n", "", ""),
    ("    x = 1; /* why */\n", "x = 2;", "    x = 2;\n"),
    ("    x = 1; /* why */ /* and how */\n", "x = 2;", "    x = 2;\n"),
    ("        x = 1;   \n", "x = 2;", "        x = 2;\n"),
])
def test_a_line_becomes_another(root, text, becomes, result):
    write(root, FUNCTION % text, becomes)
    assert seeded(root) == FUNCTION % result


OTHER = (FUNCTION % "    x = 1;\n").replace(" f(", " g(")


@pytest.mark.parametrize("text, function, result", [
    (OTHER + FUNCTION % "    x = 1;\n", "f", OTHER + FUNCTION % "    x = 2;\n"),
    ("static const uint32_t\nf(int x)\n{\n    x = 1;\n}\n", "f", "static const uint32_t\nf(int x)\n{\n    x = 2;\n}\n"),
    ("static int f(int x,\n             int y)\n{\n#if A\n    x = 1;\n}\n", "f",
     "static int f(int x,\n             int y)\n{\n#if A\n    x = 2;\n}\n"),
    ("static const int table[] = {\n    x = 1;\n};\n", "table", "static const int table[] = {\n    x = 2;\n};\n"),
    ("#define M(x) \\\n    x = 1; /* why */ \\\n    g()\n", "M", "#define M(x) \\\n    x = 2; \\\n    g()\n"),
    ("int f(int x)\n{\n#define M 1\n    x = 1;\n}\n", "f", "int f(int x)\n{\n#define M 1\n    x = 2;\n}\n"),
    ("    .global f\nf:\n1:  nop\n.Lrow:\n    x = 1;\n", "f", "    .global f\nf:\n1:  nop\n.Lrow:\n    x = 2;\n"),
    ("    .macro f a, b\n    x = 1;\n    .endm\ng:\n    x = 1;\n", "f", "    .macro f a, b\n    x = 2;\n    .endm\ng:\n    x = 1;\n"),
], ids=["two", "type", "conditions", "table", "macro", "define", "label", "assembly"])
def test_a_line_is_looked_for_in_its_function(root, text, function, result):
    write(root, text, function=function)
    assert seeded(root) == result


TWICE = FUNCTION % "    x = 1;\n    x = 1; /* again */\n"


@pytest.mark.parametrize("number, result", [(1, "    x = 2;\n    x = 1; /* again */\n"), (2, "    x = 1;\n    x = 2;\n")])
def test_of_equal_lines_the_entry_chooses_one(root, number, result):
    write(root, TWICE, more=f"occurrence = {number}\ntests = ['test_a']")
    assert seeded(root) == FUNCTION % result


@pytest.mark.parametrize("line, becomes, result", [
    ("a = 1;\nif (a) {\n    x = 1;\n}", "x = 2;", "    x = 2;\n"),
    ("if (a) {\nx = 1;\n}", "if (b) {\n    x = 1;\n}", "    a = 1; /* why */\n    if (b) {\n        x = 1;\n    }\n"),
    ("x = 1;\n}", "}", "    a = 1; /* why */\n    if (a) {\n        }\n"),
])
def test_several_lines_become_others(root, line, becomes, result):
    """Their indentation does not count."""
    write(root, FUNCTION % "    a = 1; /* why */\n    if (a) {\n        x = 1;\n    }\n", becomes, line=line)
    assert seeded(root) == FUNCTION % result


@pytest.mark.parametrize("name, text, function, line, result", [
    ("a.c", "int f(void);\n/* SPEC 1.1 */\nint g(void)\n{\n}\n", "f", "/* SPEC 1.1 */", "int f(void);\nint g(void)\n{\n}\n"),
    ("a.md", "<!-- words -->\n# Page\n\n## Part two\n\n**1.1** A sum.\n", "'Part two'", "**1.1** A sum.", "<!-- words -->\n# Page\n\n## Part two\n\n")])
def test_comments_and_lines_of_documents_are_found(root, name, text, function, line, result):
    (root / "lib" / name).write_text(text)
    record(root, entry(becomes="", function=function, line=line).replace("lib/a.c", f"lib/{name}"))
    assert planting.seeded(root)[0].apply(text) == result


# --- what applies no more ----------------------------------------------------------------

@pytest.mark.parametrize("text, more, words", [
    (FUNCTION % "    y = x + 3;\n", "", "f has no line 'x = 1;'"),
    (FUNCTION % "    x = 10;\n", "", "f has no line 'x = 1;'; it probably means line 3, in f: 'x = 10;'"),
    (FUNCTION % "    x = 1; y = 1;\n", "", "f has no line 'x = 1;'; it probably means line 3, in f: 'x = 1; y = 1;'"),
    (OTHER, "", "f has no line 'x = 1;'; it probably means line 3, in g: 'x = 1;'"),
    (TWICE, "", "f has the line 'x = 1;' 2 times: give occurrence = 1 to 2"),
    (TWICE, "occurrence = 3", "f has the line 'x = 1;' 2 times: give occurrence = 1 to 2"),
    (FUNCTION % "    x = 1;\n", "occurrence = 1", "f has the line 'x = 1;' once: leave occurrence out"),
])
def test_a_break_that_applies_no_more_is_named_with_the_line_that_it_probably_means(root, text, more, words):
    write(root, text, more=f"tests = ['test_a']\n{more}")
    assert stale(root) == [f"host_tests/breaks/a.toml: seeded bug 'one': lib/a.c: {words}"]
    with pytest.raises(ToolError, match="1 of 1 entries do not apply"):
        planting.seeded(root)


def test_all_breaks_that_apply_no_more_are_named(root):
    record(root, entry("one", line="gone") + entry("two") + entry("three", function="gone"))
    assert [words.split("'")[1] for words in stale(root)] == ["one", "three"]
    with pytest.raises(ToolError, match="2 of 3 entries do not apply") as refused:
        planting.seeded(root)
    assert refused.value.words.splitlines() == stale(root)


def test_a_break_that_changes_nothing_is_named(root):
    write(root, FUNCTION % "    x = 1;\n", becomes="x = 1;")
    assert stale(root) == ["host_tests/breaks/a.toml: seeded bug 'one': it changes nothing in lib/a.c"]


@pytest.mark.parametrize("old", [None, OTHER])
def test_a_function_that_has_moved_to_another_file_is_found(root, old):
    """Where two files have it now, both are named, and none is chosen."""
    (root / "lib" / "a.c").rename(root / "lib" / "b.c")
    if old:
        (root / "lib" / "a.c").write_text(old)
    assert stale(root) == [] and seeded(root) == FUNCTION % "    x = 2;\n" and planting.seeded(root)[0].file == "lib/b.c"
    shutil.copy(root / "lib" / "b.c", root / "lib" / "c.c")
    [words] = stale(root)
    assert "seeded bug 'one': " in words and "lib/a.c" in words and "it stands in lib/b.c, lib/c.c" in words


BLIND = "blind = true\ncommand = 'make test'\nnames = 'SPEC 1.1'\n"


@pytest.mark.parametrize("table, words", [
    ("", "has no .* entry"), (entry() + entry(), "a.toml: cannot be read"), (entry().replace("why", "because"), "'one': 'why' is missing"),
    (entry(more="mark = 'a'"), "unknown mark"), (entry(more="occurrence = 0"), "'occurrence' is no whole number from 1 on"),
    (entry(more="clause = 1"), "'clause' is missing or no str"), (entry(more="occurrence = true"), "'occurrence' is missing or no int"),
    ("[[bug", "cannot be read"), ("a = 1", "the head of an entry is"), ("['lib/a.c'.f]\nline = 'x'", "the head of an entry is"),
    (entry(more="tests = ['test_a']\n[bug]\n"), "the head of an entry is"), (entry(more=""), "give tests or rows"),
    (entry(more="tests = ['test_a']\nnames = 'f'"), "command and names are of entries with blind"),
    (entry(more=BLIND), "kind is one of clause, contract"), (entry(more=BLIND).replace("make test", "make tea"), "command one of make test"),
    (entry(more=f"{BLIND}tests = ['test_a']"), "a blind entry has blind, command"), (entry(more=f"{BLIND}rows = ['f']"), "a blind entry has"),
    (entry(more=f"{BLIND}clause = 'SPEC 1.1'"), "a blind entry has"), (entry(more="blind = true"), "a blind entry has")])
def test_a_ledger_that_is_wrong_is_refused(root, table, words):
    record(root, table)
    with pytest.raises(ToolError, match=words):
        planting.seeded(root)


def test_an_id_of_two_ledgers_is_refused(root):
    record(root, entry(), "b")
    with pytest.raises(ToolError, match="b.toml: there is an entry 'one' in host_tests/breaks/a.toml, too"):
        planting.entries(root)


# --- planting ----------------------------------------------------------------------------

def test_a_break_is_taken_out_again_whatever_happens(root):
    good, [bug] = (root / "lib/a.c").read_text(), planting.seeded(root)
    with pytest.raises(ZeroDivisionError), planting.planted(root, [bug]):
        assert (root / "lib/a.c").read_text() == bug.apply(good)
        raise ZeroDivisionError
    assert (root / "lib/a.c").read_text() == good


def test_a_copy_has_one_break_at_a_time():
    """And the results come in the order of the breaks."""
    busy, rounds = [], []

    def meet():
        rounds.append(sorted(busy))
        busy.clear()

    barrier = threading.Barrier(3, meet, 60)

    def attempt(copy, number):
        busy.append(copy)
        barrier.wait()
        return number

    assert planting.try_all("numbers", range(39), ["one", "three", "two"], attempt) == list(range(39))
    assert rounds == [["one", "three", "two"]] * 13


def gcc(*words, text=None):
    return subprocess.run(["gcc", "-std=c11", f"-I{CHECKOUT / 'lib/include'}", *map(str, words)], input=text, text=True,
                          capture_output=True, check=False)


def check(file, text, *warnings):
    """What a compiler says of a file of the library as if its text were another, compiled alone."""
    done = gcc("-x", "c", *warnings, "-fsyntax-only", f"-I{file.parent}", "-", text=text)
    return done.stderr if done.returncode else ""


@functools.cache
def includers():
    """{header: [source]} of the library as it is built for this machine."""
    found = {}
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        sources = sorted((CHECKOUT / "lib").rglob("*.c"))
        for source, done in zip(sources, pool.map(lambda source: gcc("-MM", source), sources)):
            for name in done.stdout.replace("\\\n", " ").split()[1:]:
                found.setdefault(pathlib.Path(name).resolve(), []).append(source)
    return found


def check_in_sources(file, text, *warnings):
    """The same of a header, compiled by the sources that include it, in a library where it has that text."""
    sources = includers().get(file.resolve(), [])
    if not sources:
        return f"{file}: does not compile alone, and no source includes it"
    with tempfile.TemporaryDirectory() as folder:
        library = pathlib.Path(folder) / "lib"
        shutil.copytree(CHECKOUT / "lib", library, copy_function=os.symlink)
        changed = library / file.relative_to(CHECKOUT / "lib")
        changed.unlink()
        changed.write_text(text, encoding="utf-8")
        done = gcc(*warnings, "-fsyntax-only", *(library / source.relative_to(CHECKOUT / "lib") for source in sources))
    return done.stderr if done.returncode else ""


def compiler_says(bug):
    """Of the bug's file with the bug in it: nothing where it compiles. A header that takes names from what includes it
    is compiled by that."""
    file, warnings = CHECKOUT / bug.file, ["-Wall", "-Wextra", "-Werror"]
    text = file.read_text(encoding="utf-8")
    if file.suffix == ".c":
        words = check(file, bug.apply(text), *warnings)
    elif check(file, text, *warnings, "-Wno-unused-function"):
        words = check_in_sources(file, bug.apply(text), *warnings)
    else:
        words = check(file, bug.apply(text), *warnings, "-Wno-unused-function")
    return f"{bug.id}: {words}" if words else ""


def test_each_bug_compiles():
    """Assembly, and the headers that it alone includes, are left to the sample."""
    inputs = [bug for bug in planting.seeded(CHECKOUT)
              if not bug.file.endswith(".S") and ".macro" not in (CHECKOUT / bug.file).read_text(encoding="utf-8")]
    includers()   # once, not in each thread
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        assert "".join(pool.map(compiler_says, inputs)) == ""


def test_a_bug_that_does_not_compile_is_named_and_ends_no_campaign(root, monkeypatch, capsys):
    for name in ("make_copy", "check_unharmed"):
        monkeypatch.setattr(seeded_bugs, name, lambda *_: None)
    monkeypatch.setattr(seeded_bugs, "all_tests", lambda _: ["test_a"])
    monkeypatch.setattr(seeded_bugs, "build_tests", lambda *_: "no such function")
    copy = root / "build/seeded_bugs/0"
    shutil.copytree(root / "lib", copy / "lib")
    monkeypatch.setattr(seeded_bugs.shutil, "copytree", lambda *_: None)
    assert seeded_bugs.main(["--root", str(root), "--build", str(root / "build"), "--jobs", "1"]) == 1
    said = capsys.readouterr().out
    assert "NOT COMPILED" in said and "lib/a.c: bug 'one' does not compile, so it shows nothing: no such function" in said


def test_a_sample_depends_on_the_sources_alone():
    every = planting.seeded(CHECKOUT)
    first, again = (sampling.choose(CHECKOUT, "bugs", every, SAMPLE) for _ in range(2))
    assert first == again and len({bug.id for bug in first}) == SAMPLE


def test_samples_reach_every_bug(root):
    """Over many states of the sources."""
    every, found = list(range(20)), set()
    for number in range(60):
        write(root, f"    x = {number};\n")
        found.update(sampling.choose(root, "bugs", every, SAMPLE))
    assert found == set(every)


def test_a_sample_of_seeded_bugs_is_caught(tmp_path):
    """What the bugs need is built where other tests run it too, and copied from there."""
    tests = {test for bug in sampling.choose(CHECKOUT, "seeded bugs", planting.seeded(CHECKOUT), SAMPLE) for test in bug.tests}
    for program in sorted(map(seeded_bugs.target, tests)):
        made(program)
    done = run_cli("seeded-bugs", "--sample", SAMPLE, "--build", tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"{SAMPLE} of {SAMPLE} bugs caught" in done.stdout + done.stderr


def test_a_bug_with_a_test_that_is_not_there_is_refused_before_anything_is_built(root):
    record(root, entry(more="tests = ['test_a', 'test_gone', 'equality/m3']"))
    (root / "host_tests/unit").mkdir()
    (root / "host_tests/unit/test_a.c").touch()
    with pytest.raises(ToolError, match="there is no test_gone$"):
        seeded_bugs.main(["--root", str(root), "--build", str(root / "build")])
    with pytest.raises(ToolError, match="no bug has 'nothing'"):
        seeded_bugs.main(["--root", str(root), "--build", str(root / "build"), "--only", "nothing"])
    assert not (root / "build").exists()


@pytest.mark.parametrize("seen, code, words", [
    ("test_a", 0, "1 of 1 bugs caught"), (None, 1, "lib/a.c: no test sees: w\n0 of 1 bugs caught")])
def test_a_bug_that_no_test_sees_is_printed_with_its_harm(root, monkeypatch, capsys, seen, code, words):
    for name in ("make_copy", "check_unharmed"):
        monkeypatch.setattr(seeded_bugs, name, lambda *_: None)
    monkeypatch.setattr(seeded_bugs, "all_tests", lambda _: ["test_a"])
    monkeypatch.setattr(seeded_bugs.shutil, "copytree", lambda *_: None)
    monkeypatch.setattr(seeded_bugs, "try_bug", lambda _, bug, *__: seeded_bugs.Verdict(bug, seen))
    assert seeded_bugs.main(["--root", str(root), "--build", str(root / "build")]) == code
    assert capsys.readouterr().out.endswith(f"{words}\n")
