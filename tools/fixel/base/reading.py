# SPDX-License-Identifier: MIT
"""Input files: regular ones of a bounded size, and pieces of them in messages."""

import os
import reprlib
import stat

from fixel.base.errors import ToolError, escaped

QUOTE_MAX = 80      # characters of the input in a message
_DIGITS_MAX = 60    # of a number in a message
_KINDS = ((stat.S_ISDIR, "a folder"), (stat.S_ISFIFO, "a FIFO"), (stat.S_ISCHR, "a device"),
          (stat.S_ISBLK, "a device"), (stat.S_ISSOCK, "a socket"))


def _open(path):
    """A regular file, opened; its size. A FIFO must not be waited for."""
    try:
        descriptor = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
        file = os.fdopen(descriptor, "rb") if stat.S_ISREG(os.fstat(descriptor).st_mode) else None
    except (OSError, ValueError) as error:
        words = getattr(error, "strerror", None) or "its name has a character that no name may have"
        raise ToolError(f"{path}: cannot be read ({words})") from error
    if file:
        return file, os.fstat(descriptor).st_size
    mode = os.fstat(descriptor).st_mode
    os.close(descriptor)
    kind = next((name for test, name in _KINDS if test(mode)), "no regular file")
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


def read_start(path, most):
    """The file's first bytes, at most so many."""
    file, _ = _open(path)
    with file:
        try:
            return file.read(most)
        except OSError as error:
            raise ToolError(f"{path}: cannot be read ({error.strerror})") from error


def read_whole(path, most, advice):
    """The file's bytes; one of more than so many is refused."""
    file, size = _open(path)
    file.close()
    if size > most:
        raise ToolError(f"{path}: {size:,} bytes are more than the limit of {most:,}; {advice}")
    blob = read_start(path, most + 1)
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
