# SPDX-License-Identifier: MIT
"""Puts a folder of results in place: at a kill at any moment the folder OUT, or OUT.old beside it, is whole.

OUT stays the folder that it is, so that shells and programs that have it open, its permissions, and all that is not a
result stay too. (Two folders that change places by renameat2 would change all at once, but a shell that stands in OUT
would then stand in a folder that is gone, and sub-folders and files that others write there would have to follow.)

1. The results before get a second name each in a new folder, which is then renamed to OUT.old: from here on OUT.old is
   whole. File systems without hard links get copies.
2. The files in OUT are replaced, each by a rename. The file that says that a result is whole goes first and comes last.
3. OUT.old is renamed to a temporary name: from here on OUT is whole. It is then removed.

Before OUT.old has its name, a note in the journal of scratch.py says what it is. Where a command was killed in step 2,
the next command of any tool finds the note, puts the results before back, and says so. A command that fails in step 2
puts them back itself. No power cut is heeded.

Two commands with one OUT exclude each other by flock on the folder that OUT is in, while they do these three steps. On a
file system that locks no folder, as NFS, they lock a file of the checkout instead.
"""

import contextlib
import dataclasses
import errno
import fcntl
import fnmatch
import json
import os
import shutil

from fixel.base import scratch

LOCK = "lock"       # in the folder of the journals


@contextlib.contextmanager
def _locked(folder):
    """Holds the lock on a folder."""
    handle = None
    try:
        try:
            handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
            fcntl.flock(handle, fcntl.LOCK_EX)
        except OSError:
            if handle is not None:
                os.close(handle)
                handle = None
            with contextlib.suppress(OSError):      # nothing can be locked there: only the journal is lost, too
                scratch.JOURNALS.mkdir(parents=True, exist_ok=True)
                handle = os.open(scratch.JOURNALS / LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
                fcntl.flock(handle, fcntl.LOCK_EX)
        yield
    finally:
        if handle is not None:
            os.close(handle)


def beside(out):
    """The folder in which OUT's temporary files are: the one above, or OUT itself if that one is on another file system
    or may not be written. Of an OUT that is still to come, the nearest folder above that exists."""
    if not out.exists():
        return beside_nothing(out)
    above = out.parent
    writable = os.access(above, os.W_OK | os.X_OK) and os.stat(above).st_dev == os.stat(out).st_dev
    return above if writable else out


def beside_nothing(out):
    while not out.exists():
        out = out.parent
    return out


@dataclasses.dataclass
class _Replacement:
    """What is done to OUT. old: where the results before are meanwhile. inode: of that folder. patterns: of results, the
    one that says that all is whole last. new: {name: inode} of the results that come."""

    out: str
    old: str
    inode: int
    patterns: list
    new: dict

    def rank(self, name):
        """Where a file stands in the order of coming, None where it is no result."""
        for rank, pattern in enumerate(self.patterns):
            if fnmatch.fnmatchcase(name, pattern):
                return rank
        return -1 if name in self.new else None

    def results(self):
        """Names of the results in OUT, in the order in which they come."""
        with os.scandir(self.out) as entries:
            names = [entry.name for entry in entries if not entry.is_dir(follow_symlinks=False)]
        return self.in_order(name for name in names if self.rank(name) is not None)

    def in_order(self, names):
        return sorted(names, key=lambda name: (self.rank(name), name))

    def is_done(self):
        """Whether every new result is in OUT: what was killed had but to say so."""
        return all(_inode(os.path.join(self.out, name)) == inode for name, inode in self.new.items())

    def put_back(self):
        """Makes the results in OUT those of OUT.old, of which nothing is taken; whether that changed anything."""
        if not os.path.lexists(self.out):
            os.mkdir(self.out)
        kept = self.in_order(os.listdir(self.old))
        wrong = [name for name in self.results() if name not in kept or not self._is_back(name)]
        for name in reversed(wrong):
            os.unlink(os.path.join(self.out, name))
        missing = [name for name in kept if _inode(os.path.join(self.out, name)) is None]
        for name in missing:
            link(os.path.join(self.old, name), os.path.join(self.out, name))
        return bool(wrong or missing)

    def _is_back(self, name):
        return _inode(os.path.join(self.out, name)) == _inode(os.path.join(self.old, name))


def _inode(path):
    try:
        return os.lstat(path).st_ino
    except FileNotFoundError:
        return None


def link(file, name):
    """Gives a file another name, or makes a copy where the file system has no hard links, or allows none."""
    try:
        os.link(file, name, follow_symlinks=False)
    except FileExistsError:
        raise
    except OSError:
        shutil.copy2(file, name, follow_symlinks=False)


def _free_name(out):
    """OUT.old; where somebody has that name, OUT.old-2 and so on."""
    parent, number = beside(out), 1
    while True:
        path = parent / f"{out.name}.old{f'-{number}' if number > 1 else ''}"
        if not os.path.lexists(path):
            return path
        number += 1


def put(new, out, patterns, check):
    """Makes the files of a folder the results in OUT, a path without links. patterns: globs of the results before, or a
    function that answers those for the folder OUT; the last is that of the file that says that all is whole.
    check(path) is called for each file that goes. Answers what there is to say about a command before."""
    out.parent.mkdir(parents=True, exist_ok=True)
    with _locked(out.parent):
        said = _mend_all(out)
        if not out.exists():
            os.rename(new, out)
            return said
        wanted = patterns(out) if callable(patterns) else list(patterns)
        names = {name: os.lstat(new / name).st_ino for name in os.listdir(new)}
        for name in names:
            if os.path.isdir(out / name) and not os.path.islink(out / name):
                raise IsADirectoryError(errno.EISDIR, f"{name} in it is a folder")
        replacement = _Replacement(str(out), str(_free_name(out)), 0, wanted, names)
        going = replacement.results()
        for name in going:
            check(out / name)
        _replace(new, out, going, replacement)
        return said


def _replace(new, out, going, replacement):
    with scratch.folder("old", beside(out)) as work:
        kept = work / "old"
        kept.mkdir()
        for name in going:
            link(out / name, kept / name)
        replacement.inode = os.stat(kept).st_ino
        note = json.dumps(dataclasses.asdict(replacement))
        scratch.note(note)
        try:
            os.rename(kept, replacement.old)
            for name in reversed(going):
                os.unlink(out / name)
            for name in replacement.in_order(replacement.new):
                os.rename(new / name, out / name)
        except BaseException:
            _mend(replacement)
            raise
        else:
            os.rename(replacement.old, kept)
        finally:
            if not os.path.lexists(replacement.old):
                scratch.drop_note(note)


def _mend(replacement):
    """Puts the results before back, unless the new ones are whole; whether that changed anything."""
    if _inode(replacement.old) != replacement.inode:
        return False        # it never came to that, or all was done
    changed = not replacement.is_done() and replacement.put_back()
    with scratch.folder("old", os.path.dirname(replacement.old)) as work:
        os.rename(replacement.old, work / "old")
    return changed


def _read(note):
    """The _Replacement of a note; None where it is none."""
    try:
        return _Replacement(**json.loads(note))
    except (ValueError, TypeError):
        return None


def _sentences(replacement):
    return [f"{replacement.out}: a command was killed while it put its results there; those before are back"] \
        if _mend(replacement) else []


def _mend_all(out):
    """Mends a folder whose lock is held: no command that lives has a note about it."""
    found = [each for each in map(_read, scratch.notes()) if each and each.out == str(out)]
    return [sentence for each in found for sentence in _sentences(each)]


def mend(note):
    """Mends what the note of a dead process is about; answers what there is to say about it."""
    replacement = _read(note)
    if replacement is None:
        return []
    with _locked(os.path.dirname(replacement.out)):
        return _sentences(replacement)
