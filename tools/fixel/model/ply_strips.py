# SPDX-License-Identifier: MIT
"""The triangle strips of a PLY file as triangles."""

import numpy as np

_BREAK = -1         # stands between two strips of a list


def triangles(strips):
    """The triangles of lists of vertices, an array of three columns. Of a strip every second triangle is turned round; one that names a
    vertex twice only goes on to the next."""
    found = [_of_one(np.atleast_1d(np.asarray(strip, dtype=float))) for strip in strips]
    return np.concatenate(found) if found else np.zeros((0, 3))


def _of_one(strip):
    if len(strip) < 3:
        return np.zeros((0, 3))
    places = np.arange(len(strip))
    begun = np.maximum.accumulate(np.where(strip == _BREAK, places + 1, 0))      # of the strip that a vertex belongs to
    three = np.column_stack([strip[:-2], strip[1:-1], strip[2:]])
    is_odd = (places - begun)[:-2] % 2 == 1
    three[is_odd] = three[is_odd][:, [1, 0, 2]]
    a, b, c = three.T
    return three[(three != _BREAK).all(axis=1) & (a != b) & (b != c) & (c != a)]
