# SPDX-License-Identifier: MIT
"""Ranges of bytes that records of an image name: of texels, of sprite pixels, of their colours. Records may name the same
range, and ranges may overlap; none is copied."""

from fixel.base.errors import ToolError


class Ranges:
    """The ranges of one table, each made once."""

    def __init__(self, blob):
        self.blob, self.made = memoryview(blob or b""), {}

    def at(self, first, size):
        if (first, size) not in self.made:
            self.made[first, size] = self.blob[first:first + size]
        return self.made[first, size]


def check_apart(scene, name):
    """Each range of an image becomes a table of its own in C. What overlaps would make a small image a large text."""
    records = [(one.texels, one.colours) for one in (scene.surfaces.textures if scene.surfaces else ())]
    records += [(one.pixels, one.colours) for one in (scene.billboards.boards if scene.billboards else ())]
    ranges = {id(blob): len(blob) for record in records for blob in record}
    if sum(ranges.values()) > scene.size:
        raise ToolError(f"{name}: its textures and sprites overlap: they have {sum(ranges.values()):,} bytes in an image of "
                        f"{scene.size:,}, and in C each is a table of its own; build the image anew from its scene file")
