# SPDX-License-Identifier: MIT
"""An object in parts: a grid of objects, each with the faces that lie over a cell of it."""

import dataclasses
import itertools
import math

import numpy as np

from fixel.base.errors import ToolError
from fixel.model.convex import is_convex
from fixel.model.mesh import FACES_MAX
from fixel.image.image import CONVEX, SORTED, Face

MOST = 64       # across, and along


def _cells_along(shape, axis, count):
    """(of each face the number of the cell, of so many along an axis, in which its middle lies; the ends of the shape)."""
    along = np.array([vertex[axis] for vertex in shape.vertices], dtype=np.int64)
    sizes = np.array([len(face.corners) for face in shape.faces], dtype=np.int64)
    corners = np.fromiter(itertools.chain.from_iterable(face.corners for face in shape.faces), np.int64, int(sizes.sum()))
    sums = np.add.reduceat(along[corners], np.cumsum(sizes) - sizes)
    low, high = int(along.min()), int(along.max())
    found = (sums - low * sizes) * count // ((high - low) * sizes) if high > low else np.zeros(len(sizes), np.int64)
    return np.clip(found, 0, count - 1), (low, high)


def _grouped(shape, counts):
    """The numbers of the faces of each cell that has some, by cell; and the ends of the shape along x and z."""
    (across, wide), (along, deep) = (_cells_along(shape, axis, count) for axis, count in zip((0, 2), counts))
    places = along * counts[0] + across
    order = np.argsort(places, kind="stable")
    found, starts = np.unique(places[order], return_index=True)
    return {divmod(int(place), counts[0]): numbers.tolist()
            for place, numbers in zip(found, np.split(order, starts[1:]))}, [wide, deep]


def fitting(shape, where):
    """The least number of cells, across and along, whose parts are no larger than a model may be; None where the shape
    is not larger itself."""
    most = max(len(shape.faces), len(shape.vertices))
    if most <= FACES_MAX:
        return None
    for count in range(math.ceil(math.sqrt(most / FACES_MAX)), MOST + 1):
        cells, _ = _grouped(shape, (count, count))
        if all(len(numbers) <= FACES_MAX and len({c for number in numbers for c in shape.faces[number].corners}) <= FACES_MAX
               for numbers in cells.values()):
            return count, count
    raise ToolError(f"{where}: {len(shape.faces):,} faces and {len(shape.vertices):,} vertices are more than the {FACES_MAX:,} of a "
                    f"model, and so are those over a cell of {MOST} x {MOST}; give it fewer faces (--simplify, or simplify of the "
                    "object), or split it into several files")


def _part(shape, numbers):
    """The shape of these faces alone."""
    used = sorted({corner for number in numbers for corner in shape.faces[number].corners})
    place = {corner: i for i, corner in enumerate(used)}
    faces = [Face(face.normal, tuple([place[c] for c in face.corners]), face.colour)
             for face in map(shape.faces.__getitem__, numbers)]
    return dataclasses.replace(shape, vertices=[shape.vertices[corner] for corner in used], faces=faces,
                               sources=[shape.sources[number] for number in numbers])


@dataclasses.dataclass(frozen=True)
class Part:
    """The faces over a cell, which every copy of a shape in these colours shares."""
    shape: tuple        # and where its middle is
    kind: int
    offset: tuple       # from the centre of the whole
    colours: tuple
    looks: tuple

    def placed(self, whole):
        """The instance of this part."""
        (x, y, z), (along, up, ahead) = whole.centre, self.offset
        return type(whole)(**{**vars(whole), "shape": self.shape, "kind": self.kind, "colours": self.colours,
                              "looks": self.looks, "clusters": whole.clusters and self.kind == SORTED, "centre": (x + along, y + up, z + ahead)})


def split(instance, counts, sorts):
    """The parts of an instance. counts: of cells along x and z. A part is placed at the middle of its cell, at the height
    of the whole. sorts: its faces are sorted even if it is convex."""
    shape, moved = instance.shape
    cells, ends = _grouped(shape, counts)
    made = []
    for (row, column), numbers in sorted(cells.items()):
        middle = [low + (2 * place + 1) * (high - low) // (2 * count)
                  for place, (low, high), count in zip((column, row), ends, counts)]
        offset = (middle[0] - moved[0], 0, middle[1] - moved[2])
        part = _part(shape, numbers)
        convex = not sorts and is_convex(part.vertices, part.faces)
        made.append(Part((part, tuple(m + o for m, o in zip(moved, offset))), CONVEX if convex else SORTED, offset,
                         tuple(instance.colours[number] for number in numbers),
                         tuple(instance.looks[number] for number in numbers) if instance.looks else ()))
    return made
