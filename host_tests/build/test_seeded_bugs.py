# SPDX-License-Identifier: MIT
"""A test of the tests: bugs put into the library on purpose must each be seen. make seeded-bugs tries
all of them, these tests a sample."""

import concurrent.futures
import functools
import os
import pathlib
import shutil
import subprocess
import tempfile

import pytest
from conftest import CHECKOUT, run_cli

from fixel.base import sampling
from fixel.check import bugs
from fixel.base.errors import ToolError

SAMPLE = 5


def test_there_are_bugs_of_every_kind():
    assert {"rounding", "sign", "carry", "fill rule", "shift"} <= {bug.kind for bug in bugs.read(CHECKOUT)}


def test_each_marker_stands_once_and_has_a_bug():
    """read() refuses anything else, as the next tests show."""
    marked = bugs.markers(CHECKOUT)
    assert all(len(places) == 1 for places in marked.values())
    assert sorted(marked) == sorted(bug.marker for bug in bugs.read(CHECKOUT))


@pytest.fixture
def root(tmp_path):
    """A library of one file, and its bug."""
    (tmp_path / "lib").mkdir()
    (tmp_path / "host_tests" / "build" / "seeded_bugs").mkdir(parents=True)
    write(tmp_path, "    x = 1; /* bug: one */\n")
    return tmp_path


def write(root, text, becomes="x = 2;", marker="one"):
    (root / "lib" / "a.c").write_text(f"/* Line. */\n{text}    y = 1;\n")
    (root / bugs.BUGS).write_text(f'[[bug]]\nmarker = "{marker}"\nname = "n"\nkind = "k"\nwhy = "w"\n'
                                  f'becomes = """{becomes}"""\ntests = []\n')


def seeded(root):
    [bug] = bugs.read(root)
    return bug.seed((root / "lib" / "a.c").read_text())


@pytest.mark.parametrize("text, becomes, result", [
    ("    x = 1; /* bug: one */\n", "x = 2;", "    x = 2;\n"),
    ("    x = 1; /* bug: one */\n", "x = 2;\nz = 3;", "    x = 2;\n    z = 3;\n"),
    ("    x = 1; /* bug: one */\n", "", ""),
    ("    x = 1; /* why */ /* bug: one */\n", "x = 2;", "    x = 2;\n"),
    ("    /* bug: one */\n    x = 1;\n", "x = 2;", "    /* bug: one */\n    x = 2;\n"),
    ("    x = 1; /* bug: one */ \\\n", "x = 2; \\\\", "    x = 2; \\\n"),
])
def test_a_marked_line_becomes_another(root, text, becomes, result):
    write(root, text, becomes)
    assert seeded(root) == f"/* Line. */\n{result}    y = 1;\n"


@pytest.mark.parametrize("text, marker, words", [
    ("    x = 1;\n", "one", "its marker is in lib/ 0 times, not once"),
    ("    x = 1; /* bug: one */\n    x = 1; /* bug: one */\n", "one", "its marker is in lib/ 2 times, not once: lib/a.c, lib/a.c"),
    ("    x = 1; /* bug: one */\n    x = 1; /* bug: two */\n", "one", "marker 'two' has no bug"),
    ("    /* bug: one */ x = 1;\n", "one", "no line that ends with its marker"),
])
def test_markers_that_do_not_fit_are_refused(root, text, marker, words):
    write(root, text, marker=marker)
    with pytest.raises(ToolError, match=words):
        bugs.read(root)


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
        words = check(file, bug.seed(text), *warnings)
    elif check(file, text):
        words = check_in_sources(file, bug.seed(text), *warnings)
    else:
        words = check(file, bug.seed(text))
    return f"{bug.name}: {words}" if words else ""


def test_each_bug_compiles():
    """A marked line that was wrapped since is a line no longer. Assembly, and the headers that it alone includes, are
    left to the sample."""
    inputs = [bug for bug in bugs.read(CHECKOUT)
              if not bug.file.endswith(".S") and ".macro" not in (CHECKOUT / bug.file).read_text(encoding="utf-8")]
    includers()   # once, not in each thread
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        assert "".join(pool.map(compiler_says, inputs)) == ""


def test_a_sample_depends_on_the_sources_alone():
    every = bugs.read(CHECKOUT)
    first, again = (sampling.choose(CHECKOUT, "bugs", every, SAMPLE) for _ in range(2))
    assert first == again and len({bug.name for bug in first}) == SAMPLE


def test_samples_reach_every_bug(root):
    """Over many states of the sources."""
    every, found = list(range(20)), set()
    for number in range(60):
        write(root, f"    x = {number}; /* bug: one */\n")
        found.update(sampling.choose(root, "bugs", every, SAMPLE))
    assert found == set(every)


def test_a_sample_of_seeded_bugs_is_caught(tmp_path):
    done = run_cli("seeded-bugs", "--sample", SAMPLE, "--build", tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"{SAMPLE} of {SAMPLE} bugs caught" in done.stdout + done.stderr
