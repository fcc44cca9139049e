# SPDX-License-Identifier: MIT
"""Results appear whole or not at all: written beside their place, moved there at the end."""

import contextlib
import json
import os
import pathlib
import shutil
import tempfile

from fixel.errors import ToolError


def _unwritable(path, error):
    return ToolError(f"{path}: cannot be written: {error.strerror or error}")


@contextlib.contextmanager
def replaced_folder(path, patterns):
    """Yields a new empty folder whose files become those of path when the block ends well.

    Where the block fails, path stays as it was, or absent. In a folder that is
    already there the files of the run before (those that match patterns) go,
    and anything else stays: it may be somebody's work.
    """
    path = pathlib.Path(path)
    try:
        if path.exists() and not path.is_dir():
            raise ToolError(f"{path}: cannot be written: it is there and is not a folder")
        new = pathlib.Path(tempfile.mkdtemp(prefix=".fixel-", dir=_nearest_folder(path)))
    except OSError as error:
        raise _unwritable(path, error) from error
    try:
        yield new
        new.chmod(0o777 & ~_umask())
        _put_in_place(new, path, patterns)
    except OSError as error:
        raise _unwritable(path, error) from error
    finally:
        shutil.rmtree(new, ignore_errors=True)


def _nearest_folder(path):
    """path, or the nearest folder above it that exists: the same file system, so renames work."""
    while not path.exists():
        path = path.parent
    return path


def _umask():
    mask = os.umask(0)
    os.umask(mask)
    return mask


def _put_in_place(new, path, patterns):
    """Moves the files of new to path; what patterns name last goes first and comes last, so that
    a folder that holds it is whole."""
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        new.rename(path)
        return
    for pattern in reversed(patterns):
        for stale in path.glob(pattern):
            stale.unlink()
    for pattern in patterns:
        for file in sorted(new.glob(pattern)):
            os.replace(file, path / file.name)


def write_file(path, data):
    """Writes bytes or text by way of a temporary file and a rename."""
    path = pathlib.Path(path)
    data = data.encode() if isinstance(data, str) else data
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, temporary = tempfile.mkstemp(prefix=f".{path.name}.", dir=path.parent)
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(data)
            os.chmod(temporary, 0o666 & ~_umask())
            os.replace(temporary, path)
        except BaseException:
            os.unlink(temporary)
            raise
    except OSError as error:
        raise _unwritable(path, error) from error


def write_json(path, value):
    """Writes a value as indented JSON."""
    write_file(path, json.dumps(value, indent=2) + "\n")
