# SPDX-License-Identifier: MIT
"""fixel corpus: archives that are the same bytes everywhere, and an input that is added whole or not at all."""

import hashlib
import io
import os
import shutil
import signal
import subprocess
import sys
import warnings
import zipfile

import pytest
from conftest import CHECKOUT, LAUNCHER, assert_one_sentence, environment

from fixel.base.errors import ToolError
from fixel.check import corpus

BUILT_PROGRAMS = ()
INPUTS = [b"", b"one", bytes(range(256)) * 3]
# SHA-256 of the archive of these inputs.
ARCHIVE = "7e6bafb75e19c54d4516d0e6a2f9291aafac49b51d89ffb9b9d176432802d132"
# A harness that answers with a hash that its input chooses, and fails on some input.
REPLAY = """#!/bin/sh
for file; do
    if grep -q crash "$file"; then echo "x.c:1: runtime error: a bug" >&2; exit 1; fi
    printf '%s %016d\\n' "$(basename "$file")" "$(wc -c < "$file")"
done
"""
KILLED_AT = CHECKOUT / "host_tests" / "tools" / "killed_at.py"
MOST = 50           # calls of a command; one that survives none of them is broken


def named(*contents):
    return {corpus.name_of(content): content for content in contents}


# --- an archive ----------------------------------------------------------------

def test_an_archive_is_the_same_bytes_everywhere():
    blob = corpus.pack(named(*INPUTS))
    assert blob == corpus.pack(named(*reversed(INPUTS)))
    assert hashlib.sha256(blob).hexdigest() == ARCHIVE


@pytest.mark.parametrize("harness", corpus.HARNESSES)
def test_an_archive_of_the_project_is_what_a_command_would_write(harness):
    file = corpus.archive_of(harness)
    assert corpus.pack(corpus.read(file)) == file.read_bytes()


def test_what_was_packed_is_read(tmp_path):
    file = tmp_path / "a.zip"
    corpus.write(file, named(*INPUTS))
    assert corpus.read(file) == named(*INPUTS)
    assert corpus.read(tmp_path / "none.zip") == {}


def zipped(*entries):
    blob = io.BytesIO()
    with zipfile.ZipFile(blob, "w") as archive, warnings.catch_warnings():
        warnings.simplefilter("ignore")     # of a name that stands twice
        for name, content in entries:
            archive.writestr(name, content)
    return blob.getvalue()


GOOD = corpus.pack(named(*INPUTS))
A = corpus.name_of(b"a")


@pytest.mark.parametrize("blob", [
    b"", b"no archive", GOOD[:-1], GOOD[:100], GOOD.replace(b"one", b"two", 1), zipped(("../a", b"a")), zipped((A, b"b")),
    zipped((A, b"a"), (A, b"a"))],
    ids=["empty", "text", "end", "half", "content", "name", "hash", "twice"])
def test_a_damaged_archive_is_refused(tmp_path, blob):
    file = tmp_path / "a.zip"
    file.write_bytes(blob)
    with pytest.raises(ToolError, match="a.zip: is no archive of inputs .*; take it from git again"):
        corpus.read(file)


def test_the_unpacked_folder_follows_the_archive(tmp_path, monkeypatch):
    monkeypatch.setattr(corpus, "CORPUS", tmp_path)
    for inputs in (INPUTS, INPUTS[1:], [*INPUTS, b"more"]):
        corpus.write(corpus.archive_of("scene"), named(*inputs))
        folder = corpus.unpacked("scene", tmp_path)
        assert {file.name: file.read_bytes() for file in folder.iterdir()} == named(*inputs)


def test_unpacking_leaves_other_files(tmp_path):
    (tmp_path / "mine").write_text("mine")
    assert [file.read_bytes() for file in corpus.unpack(named(b"one"), tmp_path)] == [b"one"]
    assert (tmp_path / "mine").read_text() == "mine"


# --- adding an input -------------------------------------------------------------

@pytest.fixture(name="home")
def fixture_home(tmp_path):
    """A checkout with tools and a corpus of its own, and a harness in its build folder."""
    home = tmp_path / "home"
    shutil.copytree(CHECKOUT / "tools", home / "tools", ignore=shutil.ignore_patterns("__pycache__"))
    (home / ".venv").symlink_to(CHECKOUT / ".venv")
    harness = home / "build" / "host" / "fuzz" / "replay_scene"
    harness.parent.mkdir(parents=True)
    harness.write_text(REPLAY)
    harness.chmod(0o755)
    fresh(home)
    (home / "find").write_bytes(b"a find")
    return home


def fresh(home):
    """The corpus as it is before."""
    corpus.write(home / "host_tests/fuzz/corpus/scene.zip", named(*INPUTS))
    record = home / "host_tests/fuzz/record/scene.txt"
    record.parent.mkdir(exist_ok=True)
    record.write_text("".join(f"{name} {len(content):016}\n" for name, content in sorted(named(*INPUTS).items())))


def held(home):
    """What the archive and the record hold."""
    return corpus.read(home / "host_tests/fuzz/corpus/scene.zip"), (home / "host_tests/fuzz/record/scene.txt").read_text()


def run(home, *words, killed=None):
    driver = [] if killed is None else [KILLED_AT, str(killed)]
    return subprocess.run([sys.executable, *driver, home / LAUNCHER.relative_to(CHECKOUT), "corpus", *words], cwd=home,
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False, env=environment())


def add(home, file="find", killed=None):
    return run(home, "--harness", "scene", "--add", home / file, killed=killed)


def wanted(home):
    """What archive and record hold with the find."""
    inputs, record = held(home)
    name = corpus.name_of(b"a find")
    lines = [*record.splitlines(), f"{name} {6:016}"]
    return {**inputs, name: b"a find"}, "".join(f"{line}\n" for line in sorted(lines))


def test_a_find_is_added_with_its_answer(home):
    expected = wanted(home)
    done = add(home)
    assert done.returncode == 0, done.stderr
    assert held(home) == expected
    assert "1 added, 0 removed, 4 in all" in done.stdout
    assert (home / "host_tests/fuzz/corpus/scene.zip").read_bytes() == corpus.pack(expected[0])


def test_a_list_has_each_input_and_its_answer(home):
    assert run(home, "--harness", "scene").stdout.splitlines() == [
        f"{name} {len(content):5} {len(content):016}" for name, content in sorted(named(*INPUTS).items())]
    assert run(home).stdout.split()[-8:-4] == ["scene", "3", "771", "3"]


def test_what_is_refused_changes_nothing(home):
    before = held(home)
    (home / "again").write_bytes(b"one")
    (home / "long").write_bytes(bytes(8193))
    (home / "bad").write_bytes(b"crash")
    assert_one_sentence(add(home, "again"), "again: host_tests/fuzz/corpus/scene.zip has this input already, as "
                        + corpus.name_of(b"one"))
    assert_one_sentence(add(home, "long"), "8,193 bytes are more than the limit of 8,192; the harness scene reads no longer input")
    assert_one_sentence(add(home, "bad"), "the library fails: x.c:1: runtime error: a bug", code=1)
    assert_one_sentence(add(home, "none"), "none: cannot be read")
    assert_one_sentence(run(home, "--add", home / "find"), "--harness is missing")
    assert held(home) == before
    (home / "host_tests/fuzz/corpus/scene.zip").write_bytes(GOOD[:-1])
    assert_one_sentence(add(home), "scene.zip: is no archive of inputs")
    assert (home / "host_tests/fuzz/corpus/scene.zip").read_bytes() == GOOD[:-1]


def test_an_answer_that_is_not_that_on_record_changes_nothing(home):
    record = home / "host_tests/fuzz/record/scene.txt"
    with record.open("a") as file:
        file.write(f"{corpus.name_of(b'a find')} {7:016}\n")
    before = held(home)
    assert_one_sentence(add(home), "the answers to 1 inputs are others now", code=1)
    assert held(home) == before


def test_a_kill_at_each_call_leaves_what_the_same_command_completes(home):
    before, after, states = held(home), wanted(home), []
    for number in range(1, MOST):
        fresh(home)
        done = add(home, killed=number)
        if done.returncode != -signal.SIGKILL:
            break
        states.append(held(home))
        assert states[-1] in (before, (after[0], before[1]), after)
        again = add(home)
        assert again.returncode == 0 or (states[-1] == after and "already" in again.stderr), again.stderr
        assert held(home) == after
        assert os.listdir(home / "host_tests/fuzz/corpus") == ["scene.zip"]
    assert done.returncode == 0
    assert before in states and (after[0], before[1]) in states
