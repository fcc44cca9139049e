# SPDX-License-Identifier: MIT
"""The file that holds a board's flash: read, and replaced in one step.

A new image is written into a file beside the old one, checked there, and then
renamed into its place: a power cut or a kill at any moment leaves the old image
or the new one, never a mixture. Files that a killed command left are removed by
the next one; a lock tells them from those of one that is still at work.
"""

import contextlib
import fcntl
import os
import pathlib
import tempfile

from fixel.errors import ToolError

ERASED = b"\xff"


def read_old(program, image):
    """What the flash holds so far: the image file, or erased flash."""
    try:
        old = pathlib.Path(image).read_bytes()
    except FileNotFoundError:
        return ERASED * program.flash_size
    except OSError as error:
        raise ToolError(f"cannot read {image}: {error.strerror}") from error
    if len(old) != program.flash_size:
        raise ToolError(f"{image} is not a flash image of board {program.board}, or a damaged one: {len(old)} "
                        f"bytes, {program.flash_size} expected; delete it to begin with erased flash")
    return old


def prefix(image):
    """With what the names of the files beside an image begin."""
    return f".{image.name}-"


def remove_left_over(image):
    """Removes what killed commands left beside an image."""
    for path in image.parent.glob(f"{prefix(image)}*"):
        with contextlib.suppress(OSError), path.open("rb") as file:  # locked, or gone meanwhile
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            path.unlink()


def sync_folder(folder):
    """Makes a rename last over a power cut, too."""
    handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def write_beside(image, file, data, check):
    """Writes data into a new file beside the image and has it checked there."""
    path = pathlib.Path(file.name)
    fcntl.flock(file, fcntl.LOCK_EX)
    file.write(data)
    file.flush()
    os.fsync(file.fileno())
    path.chmod(0o644)  # a temporary file nobody else may read
    result = check(path)
    os.replace(path, image)
    return result


def replace(image, data, check):
    """Puts data in an image's place after check(path) has passed it, and answers
    what check answered; on any failure the image stays as it was."""
    image = pathlib.Path(image)
    file = None
    try:
        image.parent.mkdir(parents=True, exist_ok=True)
        remove_left_over(image)
        with tempfile.NamedTemporaryFile(prefix=prefix(image), dir=image.parent, delete=False) as file:
            result = write_beside(image, file, data, check)
        file = None
        sync_folder(image.parent)
        return result
    except OSError as error:
        raise ToolError(f"cannot write {image}: {error.strerror}; it is unchanged") from error
    except KeyboardInterrupt as error:
        raise ToolError(f"interrupted; {image} is unchanged" if file else "interrupted", 130) from error
    finally:
        if file is not None:
            pathlib.Path(file.name).unlink(missing_ok=True)
