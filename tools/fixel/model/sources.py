# SPDX-License-Identifier: MIT
"""What the models of one build read: their files, and the images of their materials. All models of a scene share one
Sources."""

import hashlib

from fixel.base import reading
from fixel.model import texture_image


class Sources:
    """Reads files, and decodes each image once, by whatever name it is asked for."""

    def __init__(self):
        self.by_path, self.by_content = {}, {}

    def read(self, path, most, advice):
        """The bytes of a file of a model; one of more than so many is refused."""
        return reading.read_whole(path, most, advice)

    def image_of_file(self, path, where):
        """The texture_image.Texture in a file."""
        real = reading.identity(path)
        if real not in self.by_path:
            self.by_path[real] = self.image_of_bytes(self.read(path, texture_image.FILE_MAX, "make the image smaller"), where)
        return self.by_path[real]

    def image_of_bytes(self, blob, where):
        """The texture_image.Texture in bytes of a file that was read already."""
        key = hashlib.sha256(blob).digest()
        if key not in self.by_content:
            self.by_content[key] = texture_image.decode(bytes(blob), where)
        return self.by_content[key]
