# SPDX-License-Identifier: MIT
"""Temporary files and folders of the tools, and the removal of those that a killed tool left.

A process that makes some keeps a journal in build/.scratch of the checkout: a file with their paths. A path
is written there before anything is made at it. The process holds a lock on its journal for as long as it
lives, so a journal without a lock is that of a dead process: the next command removes what its paths name, and
then the journal. If the checkout cannot be written, there is no journal, and what a killed tool left stays.

A journal also has the notes of placing.py: JSON, which no path begins like. What they tell of is mended first.
"""

import atexit
import contextlib
import fcntl
import os
import pathlib
import re
import secrets
import shutil
import tempfile
import threading

JOURNALS = pathlib.Path(__file__).resolve().parents[3] / "build" / ".scratch"
NAME = re.compile(r"\.fixel-[a-z]+-[0-9a-f]{16}")    # nothing else is ever removed
END = b"\0"     # of a path or a note in a journal
NOTE = "{"      # begins a note


def _lock(path, flags):
    """A journal's file, locked; None where another process has it, or it has no name any more."""
    handle = os.open(path, flags | os.O_RDWR | os.O_CLOEXEC, 0o600)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        if os.fstat(handle).st_nlink:
            return handle
    except BlockingIOError:
        pass
    except BaseException:
        os.close(handle)
        raise
    os.close(handle)
    return None


class _Journal:
    """The paths that this process must remove, and the notes about what it has not finished."""

    def __init__(self):
        self._guard = threading.Lock()
        self._handle = self._file = None
        self._process = os.getpid()
        self._paths = set()

    def _open(self):
        """Makes the file. A command that cleans up may take a new one, which nobody holds yet, for a dead
        process's: then there is another."""
        JOURNALS.mkdir(parents=True, exist_ok=True)
        self._handle = None
        while self._handle is None:
            self._file = JOURNALS / f"{os.getpid()}-{secrets.token_hex(8)}"
            self._handle = _lock(self._file, os.O_CREAT | os.O_EXCL | os.O_APPEND)
        for path in self._paths:
            self._write(path)

    def _write(self, path):
        left = os.fsencode(path) + END
        while left:
            left = left[os.write(self._handle, left):]

    def add(self, path):
        with self._guard:
            if self._process != os.getpid():    # after a fork
                self._handle, self._paths, self._process = None, set(), os.getpid()
            self._paths.add(path)
            with contextlib.suppress(OSError):
                if self._handle is None or not os.fstat(self._handle).st_nlink:     # never made, or `make clean`
                    self._open()
                else:
                    self._write(path)

    def drop(self, path):
        with self._guard:       # another thread may be writing the paths into a new journal
            self._paths.discard(path)

    def close(self):
        """Removes what is left, and the journal. With a note that was not dropped the next command has work to do."""
        if self._process == os.getpid() and not any(path.startswith(NOTE) for path in self._paths) \
                and _remove_all(list(self._paths)) and self._handle is not None:
            self._file.unlink(missing_ok=True)


_journal = _Journal()
atexit.register(_journal.close)


def _remove(path):
    """Whether nothing is at a path any more."""
    if NAME.fullmatch(os.path.basename(path)):
        with contextlib.suppress(OSError):
            if os.path.isdir(path) and not os.path.islink(path):
                shutil.rmtree(path, ignore_errors=True)
            elif os.path.lexists(path):
                os.unlink(path)
        return not os.path.lexists(path)
    return True


def _remove_all(paths):
    """Whether nothing is at any of them any more."""
    return not [path for path in paths if not _remove(path)]


def _entries(blob):
    """The paths and notes of a journal. Behind the last one there may be a part of another."""
    return list(map(os.fsdecode, blob.split(END)[:-1]))


def note(text):
    """Notes in the journal what is not finished: JSON of an object."""
    _journal.add(text)


def drop_note(text):
    """What a note tells of is finished."""
    _journal.drop(text)


def notes():
    """The notes in all journals, also of processes that live."""
    found = []
    for file in JOURNALS.glob("*-*"):
        with contextlib.suppress(OSError):
            found += [entry for entry in _entries(file.read_bytes()) if entry.startswith(NOTE)]
    return found


def remove_left_over(mend):
    """Removes what dead processes left. mend(note) is called for each note, and answers sentences about what it did;
    all of them are the answer. What mend cannot do is left for the next command."""
    said = []
    for file in JOURNALS.glob("*-*"):
        with contextlib.suppress(OSError):
            handle = _lock(file, 0)
            if handle is not None:
                with open(handle, "rb") as journal:     # locked until all is done
                    entries = _entries(journal.read())
                    for entry in entries:
                        said += mend(entry) if entry.startswith(NOTE) else []
                    if _remove_all(entry for entry in entries if not entry.startswith(NOTE)):
                        file.unlink()
    return said


def _new_path(what, parent):
    """A path that nothing is at, in the journal."""
    path = os.path.join(os.path.abspath(parent or tempfile.gettempdir()), f".fixel-{what}-{secrets.token_hex(8)}")
    _journal.add(path)
    return path


@contextlib.contextmanager
def _gone_at_the_end(path):
    try:
        yield
    finally:
        if _remove(path):
            _journal.drop(path)


@contextlib.contextmanager
def folder(what, parent=None):
    """A new folder, removed with what is in it at the end. what: a word for its name. parent: where it is; None:
    where temporary files are."""
    path = _new_path(what, parent)
    with _gone_at_the_end(path):
        os.mkdir(path, 0o700)
        yield pathlib.Path(path)


@contextlib.contextmanager
def file(what, parent=None):
    """A new file: (its path, it, open for writing bytes). It is removed at the end if it still has that name."""
    path = _new_path(what, parent)
    with _gone_at_the_end(path), open(os.open(path, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o600), "wb") as handle:
        yield pathlib.Path(path), handle
