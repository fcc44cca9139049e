# SPDX-License-Identifier: MIT
"""The tables of a binary PLY file."""

import struct

import numpy as np

from fixel.base.reading import shortened

_CODES = {"i1": "b", "u1": "B", "i2": "h", "u2": "H", "i4": "i", "u4": "I", "f4": "f", "f8": "d"}     # of struct


class Damaged(ValueError):
    """A file that does not hold what its header says; the text says what is missing."""


def _even(blob, start, rows, properties, end):
    """(table of an element whose lists are all as long as those of its first row, where it ends); None where they are not."""
    kinds, at, counts = [], start, []
    for number, (_, count, kind) in enumerate(properties):
        if count:
            if at + np.dtype(count).itemsize > len(blob):
                return None
            length = int(np.frombuffer(blob, end + count, 1, at)[0])
            if not 0 <= length <= len(blob):
                return None
            kinds.append((f"count {number}", end + count))
            counts.append((f"count {number}", length))
            kinds.append((f"{number}", end + kind, (length,)))
        else:
            kinds.append((f"{number}", end + kind))
        at = start + np.dtype(kinds).itemsize
    size = np.dtype(kinds).itemsize
    if start + size * rows > len(blob):
        return None
    table = np.frombuffer(blob, np.dtype(kinds), rows, start)
    if any((table[name] != length).any() for name, length in counts):
        return None
    return {name: table[f"{number}"] for number, (name, _, _) in enumerate(properties)}, start + size * rows


def _uneven(blob, start, rows, properties, end):
    """(table of an element, row by row, where it ends)."""
    found = [[] for _ in properties]
    steps = [(struct.Struct(end + _CODES[count]) if count else None, np.dtype(end + kind)) for _, count, kind in properties]
    at = start
    for _ in range(rows):
        for column, (count, kind) in zip(found, steps):
            length = 1
            if count:
                length, = count.unpack_from(blob, at) if at + count.size <= len(blob) else (-1,)
                at += count.size
            if not 0 <= length or at + length * kind.itemsize > len(blob):
                raise Damaged("it ends within a face")
            numbers = np.frombuffer(blob, kind, int(length), at)
            column.append(numbers if count else numbers[0])
            at += int(length) * kind.itemsize
    return {name: column if count else np.array(column) for (name, count, _), column in zip(properties, found)}, at


def tables(header):
    """({element: {property: its numbers, one a row, or an array a row}} of a file, how many bytes stand behind them)."""
    blob, at, found = header.body, 0, {}
    for element in header.elements:
        rows, properties = element.rows, element.properties
        if not rows or not properties:
            continue
        even = _even(blob, at, rows, properties, header.end)
        if even is None and not any(count for _, count, _ in properties):
            raise Damaged(f"it ends within the {rows:,} rows of {shortened(element.name)}")
        found[element.name], at = even or _uneven(blob, at, rows, properties, header.end)
    return found, len(blob) - at
