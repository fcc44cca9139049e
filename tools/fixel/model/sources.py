# SPDX-License-Identifier: MIT
"""What the models of one build read: their files, and the images of their materials. All models of a scene share one
Sources, whose limits hold for them together."""

import hashlib
import os

from fixel.base import reading
from fixel.model import texture_image
from fixel.base.errors import ToolError
from fixel.scene.work import Work

BYTES_MAX = 128 << 20       # read by all models, each time that a file is read
PIXELS_MAX = 16 << 20       # of all images: 64 MB, four of the largest
PIXELS_A_BYTE = 8           # more, for each byte of the files


class Sources:
    """Reads files within limits, and decodes each image once, by whatever name it is asked for. work: the scene's
    work.Work, to which each file's bytes come."""

    def __init__(self, work=None):
        self.read_bytes = self.file_bytes = 0       # each time, and of each file once
        self.pixels, self.work = 0, work or Work()
        self.by_path, self.by_content = {}, {}

    def read(self, path, most, advice):
        """The bytes of a file of a model; one of more than so many is refused."""
        blob = reading.read_whole(path, most, advice)
        self._count_bytes(len(blob), path)
        if self.work.allow(path, len(blob)):
            self.file_bytes += len(blob)
        return blob

    def _count_bytes(self, count, where):
        self.read_bytes += count
        if self.read_bytes > BYTES_MAX:
            raise ToolError(f"{where}: the models of a scene read more than the limit of {BYTES_MAX:,} bytes together; "
                            "simplify them")

    def count_name(self, path, where):
        """Counts the work of looking for a file."""
        self.work.take("names of files", 1, where)
        self.work.take("folders in names of files", os.fspath(path).count("/"), where)

    def image_of_file(self, path, where):
        """The texture_image.Texture in a file."""
        real = reading.identity(path)
        if real not in self.by_path:
            blob = self.read(path, texture_image.FILE_MAX, "make the image smaller")
            self.by_path[real] = self._decode(blob, where)
        return self.by_path[real]

    def image_of_bytes(self, blob, where):
        """The texture_image.Texture in bytes of a file that was read already."""
        self._count_bytes(len(blob), where)
        return self._decode(blob, where)

    def _decode(self, blob, where):
        key = hashlib.sha256(blob).digest()
        if key not in self.by_content:
            image = texture_image.decode(bytes(blob), where, self.work)
            self.pixels += image.width * image.height
            most = PIXELS_MAX + PIXELS_A_BYTE * self.file_bytes
            if self.pixels > most:
                raise ToolError(f"{where}: the images of the models have more than the limit of {most:,} pixels together "
                                f"({PIXELS_MAX:,}, and {PIXELS_A_BYTE} for each byte of their files); make them smaller")
            image.work = self.work
            self.by_content[key] = image
        return self.by_content[key]
