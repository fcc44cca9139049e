# SPDX-License-Identifier: MIT
"""What the models of one build read: their files, and the images of their materials. All models of a scene share one
Sources, whose limits hold for them together."""

import hashlib
import os

from fixel import reading, texture_image
from fixel.errors import ToolError

BYTES_MAX = 128 << 20       # read by all models, each time that a file is read
PIXELS_MAX = 16 << 20       # of all images: 64 MB, four of the largest
PIXELS_A_BYTE = 8           # more, for each byte of the files
TEXELS_MAX = 1 << 18        # of the textures that are made of images, which take about 2.5 us each
BYTES_A_TEXEL = 4           # of the files, for one texel more
TEXELS_LEAST = 64           # what a small texture counts
CUT_MAX = 2 * 4096 ** 2     # squares of the corners of faces that are cut: 20 ns each, where outlines cross themselves
PIECES_MAX = 1 << 14        # faces more that cutting makes of faces, which take about 0.09 ms each
BYTES_A_PIECE = 64          # of the files, for one such face more
SURFACED_MAX = 12_288       # faces with surfaces, which take about 0.13 ms each
BYTES_A_SURFACED = 80       # of the files, for one such face more


class Sources:
    """Reads files within limits, and decodes each image once, by whatever name it is asked for."""

    def __init__(self):
        self.read_bytes = self.file_bytes = 0       # each time, and of each file once
        self.pixels = self.texels = self.cut = self.pieces = self.surfaced = 0
        self.files, self.by_path, self.by_content = set(), {}, {}

    def read(self, path, most, advice):
        """The bytes of a file of a model; one of more than so many is refused."""
        blob = reading.read_whole(path, most, advice)
        self._count_bytes(len(blob), path)
        real = os.path.realpath(path)
        if real not in self.files:
            self.files.add(real)
            self.file_bytes += len(blob)
        return blob

    def _count_bytes(self, count, where):
        self.read_bytes += count
        if self.read_bytes > BYTES_MAX:
            raise ToolError(f"{where}: the models of a scene read more than the limit of {BYTES_MAX:,} bytes together; "
                            "simplify them")

    def image_of_file(self, path, where):
        """The texture_image.Texture in a file."""
        real = os.path.realpath(path)
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
            image = texture_image.decode(bytes(blob), where)
            self.pixels += image.width * image.height
            most = PIXELS_MAX + PIXELS_A_BYTE * self.file_bytes
            if self.pixels > most:
                raise ToolError(f"{where}: the images of the models have more than the limit of {most:,} pixels together "
                                f"({PIXELS_MAX:,}, and {PIXELS_A_BYTE} for each byte of their files); make them smaller")
            image.sources = self
            self.by_content[key] = image
        return self.by_content[key]

    def count_texels(self, count, where):
        """Counts the texels of a texture before it is made of an image."""
        self.texels += max(count, TEXELS_LEAST)
        most = TEXELS_MAX + self.file_bytes // BYTES_A_TEXEL
        if self.texels > most:
            raise ToolError(f"{where}: the textures made of the models' images have more than the limit of {most:,} texels "
                            f"together ({TEXELS_MAX:,}, and one for each {BYTES_A_TEXEL} bytes of the models' files); give "
                            "a smaller size, or fewer materials")

    def count_cut(self, corners, where):
        """Counts a face of many corners before it is cut into triangles."""
        self.cut += corners * corners
        if self.cut > CUT_MAX:
            raise ToolError(f"{where}: the faces of the models that have more corners than a board draws have together more "
                            f"than the limit of {CUT_MAX:,}, each with the square of its corners; cut them in the models")

    def count_pieces(self, count, where):
        """Counts the pieces of a face that was cut."""
        self.pieces += count - 1
        most = PIECES_MAX + self.file_bytes // BYTES_A_PIECE
        if self.pieces > most:
            raise ToolError(f"{where}: cutting the faces of the models that are not flat, not convex or have too many corners "
                            f"makes more than the limit of {most:,} faces more ({PIECES_MAX:,}, and one for each "
                            f"{BYTES_A_PIECE} bytes of their files); cut them in the models")

    def check_surfaced(self, faces, where):
        """Refuses more faces with surfaces than the models of a scene may have."""
        most = SURFACED_MAX + self.file_bytes // BYTES_A_SURFACED
        if self.surfaced + faces > most:
            raise ToolError(f"{where}: the models have more than the limit of {most:,} faces with textures, opacity or light "
                            f"at run time together ({SURFACED_MAX:,}, and one for each {BYTES_A_SURFACED} bytes of their "
                            "files); simplify them, or give fewer of them surfaces")

    def count_surfaced(self, faces, where):
        """Counts the faces of a model with surfaces."""
        self.check_surfaced(faces, where)
        self.surfaced += faces
