# SPDX-License-Identifier: MIT
"""Temporary files and folders: gone at the end, or once the next command has run; and nobody else's."""

import fcntl
import os
import pathlib
import re
import signal
import subprocess
import sys
import threading
import time

import pytest

from conftest import CHECKOUT, TOOLS
from fixel.base import placing, scratch

BUILT_PROGRAMS = ()
MAKER = f"""
import pathlib, sys, time
sys.path.insert(0, {str(TOOLS)!r})
from fixel.base import scratch
scratch.JOURNALS, place = map(pathlib.Path, sys.argv[1:])
with scratch.folder("made", place) as folder, scratch.file("made", place) as (path, file):
    (folder / "inside").mkdir()
    (folder / "inside" / "file").touch()
    file.write(b"some")
    file.flush()
    (place / "ready").touch()
    time.sleep(600)
"""


@pytest.fixture
def journals(tmp_path, monkeypatch):
    """A folder of journals that no other process has."""
    monkeypatch.setattr(scratch, "JOURNALS", tmp_path / "journals")
    monkeypatch.setattr(scratch, "_journal", scratch._Journal())
    return tmp_path / "journals"


@pytest.fixture
def place(tmp_path):
    (tmp_path / "place").mkdir()
    return tmp_path / "place"


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_gone_at_the_end(journals, place):
    with scratch.folder("one", place) as folder, scratch.file("two", place) as (path, file):
        file.write(b"x")
        (folder / "x").touch()
        assert all(scratch.NAME.fullmatch(each.name) for each in (folder, path))
        assert folder.stat().st_mode & 0o777 == 0o700 and path.stat().st_mode & 0o777 == 0o600
        assert names(place) == sorted([folder.name, path.name]) and len(names(journals)) == 1
    assert not names(place)
    scratch._journal.close()
    assert not names(journals)


def test_what_was_moved_stays(journals, place):
    with scratch.file("one", place) as (path, file):
        file.write(b"x")
        os.replace(path, place / "result")
    scratch._journal.close()
    assert names(place) == ["result"]


def test_what_a_killed_process_left(journals, place):
    process = subprocess.Popen([sys.executable, "-c", MAKER, journals, place])
    while not (place / "ready").exists():
        assert process.poll() is None
        time.sleep(0.01)
    scratch.remove_left_over(placing.mend)
    assert len(names(place)) == 3       # it lives
    process.send_signal(signal.SIGKILL)
    process.wait()
    assert len(names(place)) == 3
    scratch.remove_left_over(placing.mend)
    assert names(place) == ["ready"] and not names(journals)


def test_the_path_is_in_the_journal_before_anything_is_there(journals, place, monkeypatch):
    real = os.mkdir

    def mkdir(path, mode):
        if place not in pathlib.Path(path).parents:
            return real(path, mode)
        (journal,) = journals.iterdir()
        assert journal.read_bytes().endswith(os.fsencode(path) + b"\0")
        raise OSError("enough")

    monkeypatch.setattr(os, "mkdir", mkdir)
    with pytest.raises(OSError, match="enough"), scratch.folder("one", place):
        pass


def test_a_journal_names_what_may_not_be_removed(journals, place):
    """A journal that is damaged, or another's, costs nobody a file."""
    kept = place / "kept"
    kept.touch()
    (place / ".fixel-x-0123456789abcdef").symlink_to(kept)
    journals.mkdir()
    paths = [kept, place, place / ".fixel-x-0123456789abcdef", place / ".fixel-x-0123"]
    paths[3].touch()
    (journals / "1-x").write_bytes(b"".join(os.fsencode(path) + b"\0" for path in paths) + b"/tmp")
    scratch.remove_left_over(placing.mend)
    assert names(place) == [".fixel-x-0123", "kept"] and not names(journals)


def test_a_journal_that_a_cleaner_took_before_it_was_locked(journals, place, monkeypatch):
    real, taken = fcntl.flock, []

    def flock(handle, flags):
        if not taken:
            taken.extend(journals.iterdir())
            taken[0].unlink()
        real(handle, flags)

    monkeypatch.setattr(fcntl, "flock", flock)
    with scratch.folder("one", place) as folder:
        (journal,) = journals.iterdir()
        assert journal != taken[0] and journal.read_bytes() == os.fsencode(folder) + b"\0"


def test_one_makes_while_others_clean(journals, place):
    """A command that cleans may take a new journal for a dead process's; nothing of the living may go."""
    ended = threading.Event()

    def clean():
        while not ended.is_set():
            scratch.remove_left_over(placing.mend)

    cleaners = [threading.Thread(target=clean) for _ in range(2)]
    for each in cleaners:
        each.start()
    try:
        for _ in range(100):
            scratch._journal = scratch._Journal()       # as another process would
            with scratch.file("one", place) as (path, _file):
                for _ in range(5):
                    assert path.exists() and scratch._journal._file.exists()
                    time.sleep(0)
            os.close(scratch._journal._handle)
    finally:
        ended.set()
        for each in cleaners:
            each.join()


def test_after_make_clean(journals, place):
    with scratch.folder("one", place) as first:
        for journal in journals.iterdir():
            journal.unlink()
        with scratch.folder("two", place) as second:
            (journal,) = journals.iterdir()
            assert {os.fsencode(first), os.fsencode(second)} <= set(journal.read_bytes().split(b"\0"))


def test_a_checkout_that_cannot_be_written(journals, place, monkeypatch):
    monkeypatch.setattr(scratch, "JOURNALS", place / "file" / "journals")
    (place / "file").touch()
    with scratch.folder("one", place) as folder:
        assert folder.is_dir()
    scratch.remove_left_over(placing.mend)
    assert names(place) == ["file"]


def test_every_tool_makes_its_temporary_files_so():
    """No tool has another way, but for files that have no name."""
    other = re.compile(r"tempfile\.(?!gettempdir|TemporaryFile)|mkdtemp|mkstemp")
    found = [f"{file.relative_to(CHECKOUT)}: {line.strip()}" for file in TOOLS.rglob("*.py")
             for line in file.read_text(encoding="utf-8").splitlines() if other.search(line)]
    assert not found
