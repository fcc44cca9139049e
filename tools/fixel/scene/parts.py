# SPDX-License-Identifier: MIT
"""An object in parts: a grid of objects, each with the faces that lie over a cell of it."""

import dataclasses

from fixel.model.convex import is_convex
from fixel.image.image import CONVEX, SORTED

MOST = 64       # across, and along


def _cell(low, high, count, middle):
    """The number of the cell, of so many between low and high, in which a middle lies. middle: a sum and how many."""
    total, points = middle
    return max(0, min(count - 1, (total - low * points) * count // ((high - low) * points))) if high > low else 0


def _grouped(shape, counts):
    """The numbers of the faces of each cell that has some, by cell; and the ends of the shape along x and z."""
    ends = [(min(v[axis] for v in shape.vertices), max(v[axis] for v in shape.vertices)) for axis in (0, 2)]
    cells = {}
    for number, face in enumerate(shape.faces):
        place = tuple(_cell(*end, count, (sum(shape.vertices[c][axis] for c in face.corners), len(face.corners)))
                      for axis, end, count in zip((0, 2), ends, counts))
        cells.setdefault(place[::-1], []).append(number)
    return cells, ends


def _part(shape, numbers):
    """The shape of these faces alone."""
    used = sorted({corner for number in numbers for corner in shape.faces[number].corners})
    place = {corner: i for i, corner in enumerate(used)}
    faces = [dataclasses.replace(shape.faces[number], corners=tuple(place[c] for c in shape.faces[number].corners))
             for number in numbers]
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
        """The placement of this part of a placement."""
        (x, y, z), (along, up, ahead) = whole.centre, self.offset
        return type(whole)(**{**vars(whole), "shape": self.shape, "kind": self.kind, "colours": self.colours,
                              "looks": self.looks, "clusters": whole.clusters and self.kind == SORTED, "centre": (x + along, y + up, z + ahead)})


def split(placement, counts, sorts):
    """The parts of a placement. counts: of cells along x and z. A part is placed at the middle of its cell, at the height
    of the whole. sorts: its faces are sorted even if it is convex."""
    shape, moved = placement.shape
    cells, ends = _grouped(shape, counts)
    made = []
    for (row, column), numbers in sorted(cells.items()):
        middle = [low + (2 * place + 1) * (high - low) // (2 * count)
                  for place, (low, high), count in zip((column, row), ends, counts)]
        offset = (middle[0] - moved[0], 0, middle[1] - moved[2])
        part = _part(shape, numbers)
        convex = not sorts and is_convex(part.vertices, part.faces)
        made.append(Part((part, tuple(m + o for m, o in zip(moved, offset))), CONVEX if convex else SORTED, offset,
                         tuple(placement.colours[number] for number in numbers),
                         tuple(placement.looks[number] for number in numbers) if placement.looks else ()))
    return made
