# SPDX-License-Identifier: MIT
"""The file that holds a board's flash: read, and replaced in one step.

A new image is written into a file beside the old one, checked there, and then
renamed into its place: a power cut or a kill at any moment leaves the old image
or the new one, never a mixture.
"""


from fixel.base import output, reading
from fixel.base.errors import ToolError

ERASED = b"\xff"


def read_old(program, image):
    """What the flash holds so far: the image file, or erased flash."""
    target = output.target_of(image)
    if not target.exists():
        return ERASED * program.image_size
    file, found = reading.open_regular(target)
    with file:
        if found.st_size != program.image_size:
            raise ToolError(f"{image} is not a flash image of board {program.board}, or a damaged one: {found.st_size} "
                            f"bytes, {program.image_size} expected; delete it to begin with erased flash")
        return file.read(found.st_size)


def replace(image, data, check):
    """Puts data in an image's place after check(path) has passed it, and answers
    what check answered; on any failure the image stays as it was."""
    return output.replace(image, data, check, durable=True)
