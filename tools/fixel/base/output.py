# SPDX-License-Identifier: MIT
"""Results appear whole or not at all: written beside their place, moved there at the end. None of them replaces a file
that this process has read as input."""

import contextlib
import json
import os
import pathlib
import stat
import sys

from fixel.base import placing, reading, scratch
from fixel.base.errors import ToolError, one_line

# What a name may stand for that is no file, and no tool replaces.
KINDS = ((stat.S_ISDIR, "a folder"), (stat.S_ISFIFO, "a FIFO"), (stat.S_ISSOCK, "a socket"),
         (stat.S_ISCHR, "a device"), (stat.S_ISBLK, "a device"))

_made = set()       # (device, inode) of each file that this process has put in place: it may write it again


def _unwritable(path, error):
    about = f" ({error.filename})" if error.filename and str(error.filename) != str(path) else ""
    return ToolError(f"{path}: cannot be written: {error.strerror or error}{about}")


def not_a_file(path):
    """What is at a path, as words, where it is neither a file nor absent. Symbolic links are followed."""
    try:
        mode = os.stat(path).st_mode
    except FileNotFoundError:
        return None
    return next((words for is_kind, words in KINDS if is_kind(mode)), None)


def target_of(path):
    """The file that a result replaces: path itself, or what the symbolic link there leads to, so that the link
    stays. A path at which there is something else is refused."""
    try:
        found = not_a_file(path)
    except OSError as error:
        raise _unwritable(path, error) from error
    if found:
        raise ToolError(f"{path}: cannot be written: it is {found}; name a file")
    return pathlib.Path(os.path.realpath(path))


def refuse_input(target, path):
    """Refuses a target that is a file which this process has opened as input, by any name. path: what messages call it."""
    found = reading.identity(target)
    if found in reading.opened() and found not in _made:
        raise ToolError(f"{path}: cannot be written: this command has read it as input; name another file for the result")


def move(new, target, path=None):
    """Moves a finished file to its place, in one step. path: what messages call the target."""
    refuse_input(target, path or target)
    os.replace(new, target)
    _made.add(reading.identity(target))


@contextlib.contextmanager
def replaced_folder(path, patterns):
    """Yields a new empty folder whose files become those of path when the block ends well (placing.py).

    Where the block fails, path stays as it was, or absent. In a folder that is already there the files of the run before
    go, and anything else stays: it may be somebody's work. patterns: globs of these files, or a function that answers
    those for the folder; the last one is that of the file that says that a result is whole.
    """
    try:
        out = pathlib.Path(os.path.realpath(path))
        if out.exists() and not out.is_dir():
            raise ToolError(f"{path}: cannot be written: it is there and is not a folder")
        with scratch.folder("results", placing.beside(out)) as new:
            yield new
            new.chmod(0o777 & ~_umask())
            made = [reading.identity(file) for file in new.iterdir()]
            said = placing.put(new, out, patterns, lambda file: refuse_input(file, pathlib.Path(path) / file.name))
            _made.update(made)
            for sentence in said:
                print(f"note: {one_line(sentence)}", file=sys.stderr)
    except OSError as error:
        raise _unwritable(path, error) from error


def numbered(before, after):
    """Globs of files with a number of four to seven digits between these texts."""
    return [f"{before}{'[0-9]' * digits}{after}" for digits in range(4, 8)]


def make_folder(path):
    """A folder, made if it is not there."""
    try:
        pathlib.Path(path).mkdir(parents=True, exist_ok=True)
    except FileExistsError as error:
        raise ToolError(f"{path}: is there and is not a folder") from error
    except OSError as error:
        raise ToolError(f"{path}: the folder cannot be made: {error.strerror}") from error


def _umask():
    mask = os.umask(0)
    os.umask(mask)
    return mask


def replace(path, data, check=None, durable=False):
    """Puts bytes in a file's place in one step: a kill at any moment leaves the old file or the new one. check:
    is called with the path of the new file before that; its answer is the answer, and what it raises leaves the
    file as it was. durable: a power cut, too, leaves one of both."""
    target = target_of(path)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        with scratch.file("output", target.parent) as (new, file):
            file.write(data)
            file.flush()
            if durable:
                os.fsync(file.fileno())
            new.chmod(0o666 & ~_umask())    # a temporary file nobody else may read
            answer = check(new) if check else None
            move(new, target, path)
        if durable:
            _sync_folder(target.parent)
        return answer
    except OSError as error:
        raise ToolError(f"{_unwritable(path, error)}; it is unchanged") from error


def _sync_folder(folder):
    """Makes a rename last over a power cut, too."""
    handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def write_file(path, data):
    """Writes bytes or text as a whole file."""
    replace(path, data.encode() if isinstance(data, str) else data)


def _check_new(path, text, option):
    """The file that a text is to be, refused where another text is there: somebody may have changed it. option: what names it."""
    target = target_of(path)
    if target.exists() and target.read_bytes() != text.encode():
        raise ToolError(f"{path}: is there already and has another text, perhaps yours: remove it, or name another file after {option}")
    return target


def write_new(path, text, option):
    """Writes text as a file, unless another text is there. option: what names it."""
    _check_new(path, text, option)
    write_file(path, text)


def write_both(path, data, other, text, option):
    """Writes a result and a text beside it, as write_file and write_new do: both or, where one is refused or cannot be written,
    neither."""
    first, second = target_of(path), _check_new(other, text, option)
    if first == second:
        raise ToolError(f"{other}: {option} and the result name one file: name another one")
    refuse_input(second, other)
    is_new = not second.exists()
    write_new(other, text, option)
    try:
        write_file(path, data)
    except BaseException:
        if is_new:      # else it had this text before
            second.unlink(missing_ok=True)
        raise


def write_json(path, value):
    """Writes a value as indented JSON."""
    write_file(path, json.dumps(value, indent=2) + "\n")
