# SPDX-License-Identifier: MIT
"""What the models of one build read: their files, and the images of their materials. All models of a scene share one
Sources."""

import hashlib

from fixel.base import reading
from fixel.base.errors import ToolError
from fixel.base.reading import quoted
from fixel.model import texture_image


PLAIN_FACES = "The faces have the colour of their material"


def _once(known, key, make):
    """known[key], made if it is not there. What failed to be made fails again without an attempt."""
    if key not in known:
        try:
            known[key] = make()
        except ToolError as error:
            known[key] = error
    if isinstance(known[key], ToolError):
        raise known[key]
    return known[key]


class Sources:
    """Reads files, and decodes each image once, by whatever name it is asked for. wants_images: whether a note tells of an image
    that cannot be read. unread: what is wrong with each such image."""

    def __init__(self, wants_images=True):
        self.by_path, self.by_content, self.wants_images, self.unread = {}, {}, wants_images, []

    def read(self, path, most, advice):
        """The bytes of a file of a model; one of more than so many is refused."""
        return reading.read_whole(path, most, advice)

    def image(self, obtain, notes, without=PLAIN_FACES):
        """The texture_image.Texture that obtain() answers; None, and a note, where it cannot be read. A file that may not be opened
        (reading.confine) is refused. notes: gets what there is to say. without: what is without the image."""
        found, said = None, []
        try:
            found = obtain()
            said = found.notes
        except reading.OutsideError:
            raise
        except ToolError as error:
            said = [f"{error.message}. {without}"]
            self.unread.append(error.message)
        if self.wants_images:
            notes += [note for note in said if note not in notes]
        return found

    def image_named(self, file, name, where):
        """The texture_image.Texture of a file that a model names. file: that of the name, None where there is none. where: for messages."""
        if file is None:
            raise ToolError(f"{where}: there is no image {quoted(name)}; the path is taken from the model's folder")
        return self.image_of_file(file, f"{where}: {file}")

    def image_of_file(self, path, where):
        """The texture_image.Texture in a file."""
        def make():
            try:
                blob = self.read(path, texture_image.FILE_MAX, "make the image smaller")
            except reading.OutsideError:
                raise
            except ToolError as error:
                raise ToolError(f"{where}: {error.message.removeprefix(f'{path}: ')}") from error
            return self.image_of_bytes(blob, where)
        return _once(self.by_path, reading.identity(path), make)

    def image_of_bytes(self, blob, where):
        """The texture_image.Texture in bytes of a file that was read already."""
        return _once(self.by_content, hashlib.sha256(blob).digest(), lambda: texture_image.decode(bytes(blob), where))
