# SPDX-License-Identifier: MIT
"""The tables of a binary PLY file. trimesh reads only those in which all faces have as many corners."""

import re
import struct

import numpy as np

_KINDS = {"char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2", "uint16": "u2",
          "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4", "float": "f4", "float32": "f4", "double": "f8", "float64": "f8"}
_CODES = {"i1": "b", "u1": "B", "i2": "h", "u2": "H", "i4": "i", "u4": "I", "f4": "f", "f8": "d"}     # of struct
_END = re.compile(rb"end_header[ \t]*\r?\n")


class Damaged(ValueError):
    """A file that does not hold what its header says; the text says what is missing."""


def is_binary(blob):
    """Whether the header of a PLY file says so."""
    return re.match(rb"ply\s+format\s+binary_(little|big)_endian\b", blob) is not None


def _elements(head):
    """[(name, how many rows, [(property, kind of its count or None, kind of its numbers)])] of a header."""
    found = []
    for line in head.splitlines():
        word, *rest = line.split() or [""]
        if word == "element" and len(rest) == 2 and re.fullmatch("[0-9]{1,18}", rest[1]):
            found.append((rest[0], int(rest[1]), []))
        elif word == "property":
            kinds = rest[1:-1] if rest[:1] == ["list"] else rest[:-1]
            if not found or len(kinds) != (2 if rest[:1] == ["list"] else 1) or not all(kind in _KINDS for kind in kinds) or \
                    (len(kinds) == 2 and _KINDS[kinds[0]][0] == "f"):
                raise Damaged("a line of the header is no property")
            found[-1][2].append((rest[-1], _KINDS[kinds[0]] if len(kinds) == 2 else None, _KINDS[kinds[-1]]))
        elif word == "element":
            raise Damaged("a line of the header is no element")
    return found


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


def tables(blob):
    """({element: {property: its numbers, one a row, or an array a row}} of a file, how many bytes stand behind them)."""
    header = _END.search(blob)
    if not header:
        raise Damaged("its header has no end")
    end, at, found = "<" if b"binary_little" in blob[:64] else ">", header.end(), {}
    for name, rows, properties in _elements(blob[:header.start()].decode("utf-8", "replace")):
        if not rows or not properties:
            continue
        even = _even(blob, at, rows, properties, end)
        if even is None and not any(count for _, count, _ in properties):
            raise Damaged(f"it ends within {rows:,} rows")
        found[name], at = even or _uneven(blob, at, rows, properties, end)
    return found, len(blob) - at
