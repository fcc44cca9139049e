# SPDX-License-Identifier: MIT
"""The work that a scene file asks for. Each stage takes what it needs from one budget before it begins, so that all of
them together stay within the bound that docs/scenes.md promises: 2 s, and 2 s more for each MB of the scene's files.
A tree has a budget of its own, of 20 s more.

The unit is a step: about 1 us of CPU time on a PC of 2020. The tool itself takes 0.4 s of the 2 s to begin. What
it takes to read a byte is not part of the budget."""

from fixel.base import reading
from fixel.base.errors import ToolError

STEPS = 1_500_000       # of any scene
STEPS_A_BYTE = 1        # more, for each byte of its TOML file, which takes up to 1 us to read
STEPS_A_MODEL_BYTE = 1.3    # more, for each byte of its models and images, which take up to 0.7 us
TREE_STEPS = 20_000_000     # of any tree

# What each of these takes at most, as measured. The names stand in messages.
COSTS = {
    # --- objects
    "objects": 60,
    "copies": 11,
    "places on rings or in positions": 21,
    "copies that differ": 40,               # in turn or in colour
    "turned or moving objects": 110,        # each copy
    "parents": 160,
    "keys of motions": 50,
    "parts": 80,
    "faces in parts": 9,
    # --- models
    "solids": 60,
    "cells of islands": 14,
    "cells of other solids": 5,
    "shapes": 200,          # a solid or a file at one size and turn
    "vertices": 3,
    "vertices placed": 0.2,                 # once for each object and turn
    "faces": 14,            # of shapes
    "corners of faces with many": 0.8,      # the square of a face's corners, of faces with more than four
    "nodes of glTF files": 8,
    "primitives of glTF files": 60,
    "values of glTF files": 0.12,
    "triangles of glTF files": 6,
    "triangles with colours of vertices": 22,
    "faces merged": 28,
    "faces cut": 20,
    "corners of faces cut": 0.02,           # the square of a face's corners
    "faces coloured": 4,
    "models": 20,
    "faces of models": 10,
    "corners of models": 0.8,
    "faces of sorted models": 5,
    "faces in clusters": 8,
    # --- surfaces
    "faces with textures": 95,
    "faces with light or opacity": 60,
    "shapes with surfaces": 150,
    "faces with surfaces in models": 8,
    "corners of surfaces": 1 / 16,          # the cube of a face's corners
    "colours of textures": 4,               # in each direction that its faces look
    "texels of patterns": 2,
    "texels of pictures": 0.5,
    "texels of materials": 1.6,
    "texels of textures": 0.6,              # in each light; and of billboards
    "pixels": 0.02,
    "texts in images": 2200,
    "names of files": 20,
    "bytes read again": 0.7,
    "folders in names of files": 2,
    "colours blended": 1000,
    "pictures": 200,
    "colours merged": 13,
    "colours of the palette": 6,
    # --- paths
    "poses": 10,
    "poses of an orbit": 22,
    "keys of the path": 65,
    "steps of the path": 12,
    # --- trees
    "faces of its layers": 30,
    "corners of its layers": 16,             # and 200 bytes of memory
    "nodes": 120,
    "corners of faces at nodes": 1.5,        # a face comes to each node above its own
    "objects at nodes": 10,
    "planes tried at nodes": 10,
    "corners at planes tried": 0.04,
    "faces split": 60,
    "corners added by the cuts of neighbours": 6,
    "diagonals of faces with many corners": 0.7,
}


class Work:
    """The budget of one scene, and what was taken from it."""

    asks, cure = ": the scene asks", "use fewer of these"

    def __init__(self):
        self.most, self.taken, self.kinds, self.files = STEPS, 0, {}, set()

    def allow(self, path, size, steps=STEPS_A_MODEL_BYTE):
        """The scene reads a file of so many bytes. It comes to the budget once, whoever reads it; answers whether this is
        the first time. steps: for each byte."""
        identity = reading.identity(path)
        if identity in self.files:
            self.take("bytes read again", size, path)
            return False
        self.files.add(identity)
        self.most += int(steps * size)
        return True

    def take(self, kind, count, where):
        """Takes the steps of so many of a kind (COSTS), or refuses the scene. where: stands before the message."""
        steps = COSTS[kind] * count
        self.taken += steps
        self.kinds[kind] = self.kinds.get(kind, 0) + steps
        if self.taken > self.most:
            raise ToolError(f"{where}{self.asks} for too much work; most of it is for {self._shares()}: {self.cure} "
                            f"(the limit is {self._limit()})")

    def _limit(self):
        return f"{self.most:,} steps: {STEPS:,}, and about one for each byte of its files"

    def _shares(self):
        """The kinds that take most, in words."""
        first = sorted(self.kinds, key=self.kinds.get, reverse=True)[:3]
        return ", ".join(f"{kind} ({100 * self.kinds[kind] / self.taken:.0f} %)" for kind in first if self.kinds[kind])


class PictureWork(Work):
    """The budget of a picture that is no scene's."""

    asks, cure = ": the picture asks", "save it anew, with fewer scans or texts"


class TreeWork(Work):
    """The budget of one tree."""

    asks, cure = " asks", "give its layers fewer faces, or name fewer layers"

    def __init__(self, most=TREE_STEPS):
        super().__init__()
        self.most = most

    def _limit(self):
        return f"{self.most:,} steps"
