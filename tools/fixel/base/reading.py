# SPDX-License-Identifier: MIT
"""Input files: regular ones of a bounded size, and pieces of them in messages.

A tool opens its input here, so that the process knows which files it has read: output.py refuses to replace one of
them. A process that reads for another one, such as the child that compiles a scene, sends opened() to it, and the other
calls note_opened().
"""

import os
import reprlib
import stat

from fixel.base.errors import ToolError, escaped

class OutsideError(ToolError):
    """A file outside the folder of the file that the user named, and below."""


QUOTE_MAX = 80      # characters of the input in a message
_DIGITS_MAX = 60    # of a number in a message
_KINDS = ((stat.S_ISDIR, "a folder"), (stat.S_ISFIFO, "a FIFO"), (stat.S_ISCHR, "a device"),
          (stat.S_ISBLK, "a device"), (stat.S_ISSOCK, "a socket"))


_opened = set()     # (device, inode)


def opened():
    """The (device, inode) of each input file that this process has opened, or was told of."""
    return frozenset(_opened)


def note_opened(files):
    """Adds files that another process opened for this one, as its opened() has them."""
    _opened.update((device, inode) for device, inode in files)


_confined = None        # (the file that the user named, its identity, its folder, the folder without symbolic links)


def confine(named):
    """From here on this process opens as input no file outside the folder of the file that the user named, and below.
    Symbolic links are resolved; the named file itself may be one."""
    global _confined
    named = os.fspath(named)
    folder = os.path.dirname(named) or "."
    _confined = named, identity(named), folder, os.path.realpath(folder)


ALLOW = "put the file there, or allow files outside with --allow-outside"     # what a command can do; the live window says something else


def _refuse_outside(path, found):
    """Refuses an open file outside the folder; found: its os.stat_result, as the name may have changed in between."""
    named, itself, folder, real = _confined
    opened_now = found.st_dev, found.st_ino
    if opened_now == itself:
        return
    target = os.path.realpath(path)
    if os.path.commonpath([real, target]) == real and identity(target) == opened_now:
        return
    raise OutsideError(f"{path}: is outside {folder}, the folder of {named}, and what lies below it; {ALLOW}")


def open_file(path):
    """A regular file, opened as input for reading bytes."""
    file, found = open_regular(path)
    if _confined:
        try:
            _refuse_outside(path, found)
        except OutsideError:
            file.close()
            raise
    _opened.add((found.st_dev, found.st_ino))
    return file


def open_regular(path):
    """(a regular file, opened for reading bytes, its os.stat_result). It does not count as input: the tool may replace
    it. A FIFO must not be waited for."""
    try:
        descriptor = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
        found = os.fstat(descriptor)
    except (OSError, ValueError) as error:
        words = getattr(error, "strerror", None) or "its name has a character that no name may have"
        raise ToolError(f"{path}: cannot be read ({words})") from error
    if stat.S_ISREG(found.st_mode):
        return os.fdopen(descriptor, "rb"), found
    os.close(descriptor)
    kind = next((name for test, name in _KINDS if test(found.st_mode)), "no regular file")
    raise ToolError(f"{path}: is {kind}; give a regular file")


class Beside(os.PathLike):
    """A file that the input names, beside the file that names it. As text, which is for messages, it is at most 80
    characters of that name, escaped. os.fspath answers the path itself."""

    def __init__(self, folder, name):
        self.path, self.shown = os.path.join(folder, name), shortened(name)

    def __fspath__(self):
        return self.path

    def __str__(self):
        return self.shown

    def exists(self):
        """Whether there is anything at the path; no file has a name with a zero byte."""
        return "\0" not in self.path and os.path.exists(self.path)


def identity(path):
    """What two names of one file have in common; of no file, the name."""
    try:
        found = os.stat(path)
        return found.st_dev, found.st_ino
    except (OSError, ValueError):
        return os.fspath(path)


def _read(file, path, most):
    try:
        return file.read(most)
    except OSError as error:
        raise ToolError(f"{path}: cannot be read ({error.strerror})") from error


def read_start(path, most):
    """The file's first bytes, at most so many."""
    with open_file(path) as file:
        return _read(file, path, most)


def read_whole(path, most, advice):
    """The file's bytes; one of more than so many is refused before it is read."""
    with open_file(path) as file:
        size = os.fstat(file.fileno()).st_size
        if size > most:
            raise ToolError(f"{path}: {size:,} bytes are more than the limit of {most:,}; {advice}")
        blob = _read(file, path, most + 1)
    if len(blob) > most:
        raise ToolError(f"{path}: more than the limit of {most:,} bytes; {advice}")
    return blob


def read_all(path):
    """The bytes of a file of any size: one that a tool made."""
    return read_start(path, -1)


class _Short(reprlib.Repr):
    """Values of TOML as short text, however large or deep they are."""

    def __init__(self):
        super().__init__()
        self.maxlevel = 3
        self.maxother = self.maxstring = QUOTE_MAX

    def repr_int(self, value, _):
        """An integer of any size; one of many digits takes too long to write out."""
        return repr(value) if value.bit_length() < 3 * _DIGITS_MAX else "a number of many digits"


def quoted(value):
    """A value of the input for a message: at most 80 characters, a string in double quotes and escaped."""
    if isinstance(value, str):
        text = "".join(map(_escaped, value[:QUOTE_MAX]))
        return f'"{_cut(text, len(value) > QUOTE_MAX)}"'
    return _cut(_Short().repr(value), False)


def _escaped(character):
    return "\\" + character if character in '"\\' else escaped(character)


def shortened(text):
    """A message of another program: both ends of it, at most 80 characters."""
    text = "".join(map(_escaped, text if len(text) <= QUOTE_MAX else text[:40] + "..." + text[-37:]))
    return text if len(text) <= QUOTE_MAX else text[:40] + "..." + text[-37:]


def _cut(text, more):
    """At most 80 characters; three dots stand for what is left out."""
    return text[:QUOTE_MAX - 3] + "..." if more or len(text) > QUOTE_MAX else text
