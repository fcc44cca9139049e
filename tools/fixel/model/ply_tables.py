# SPDX-License-Identifier: MIT
"""What stands in a PLY file: its header, which says what tables stand behind it and of which numbers, and the tables, binary or text. The numbers
of a text stand in one row, whatever lines they are on."""

import codecs
import re
import struct
from dataclasses import dataclass

import numpy as np

from fixel.base.errors import ToolError
from fixel.base.reading import quoted, shortened

HEADER_MAX = 1 << 16        # bytes
IMAGES_MAX = 64             # named by one file
KINDS = {"char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2", "uint16": "u2",
         "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4", "float": "f4", "float32": "f4", "double": "f8", "float64": "f8"}
_ENDS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_COUNT = re.compile("[0-9]{1,18}")
_WHOLE = ("i", "u")         # kinds of whole numbers


@dataclass
class Element:
    """A table. properties: [(name, kind of its count or None, kind of its numbers)]."""
    name: str
    rows: int
    properties: list


@dataclass
class Header:
    """end: of binary numbers, "<" or ">"; "" of a text. body: what stands behind the header. lines: how many it has."""
    end: str
    elements: list
    images: list
    body: bytes
    lines: int

    def rows(self, name):
        """How many rows the tables of a name have."""
        return next((element.rows for element in self.elements if element.name == name), 0)


def _as_text(blob):
    """The bytes without a byte order mark, in UTF-8."""
    if blob.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return blob.decode("utf-16", "replace").encode()
    return blob.removeprefix(codecs.BOM_UTF8)


def _divided(blob, name):
    """(lines of the header, bytes behind it). The header's first line says how its lines end."""
    end = blob.find(b"end_header", 0, HEADER_MAX)
    if not re.match(rb"ply[ \t]*[\r\n]", blob) or end < 0:
        raise ToolError(f"{name}: a PLY file begins with ply and has end_header within {HEADER_MAX:,} bytes: it is damaged, or no "
                        "PLY file")
    newline = re.match(rb"ply[ \t]*(\r\n|\r|\n)", blob)[1]
    rest = blob[end + len(b"end_header"):].lstrip(b" \t")
    if rest and not rest.startswith(newline):
        newline = b"\r\n" if rest.startswith(b"\r\n") else b"\n"
    if rest and not rest.startswith(newline):
        raise ToolError(f"{name}: the line of end_header does not end: the file is damaged")
    return blob[:end].decode("utf-8", "replace").splitlines(), rest[len(newline):]


def _property(words, where):
    is_list = words[:1] == ["list"]
    kinds = words[1:-1] if is_list else words[:-1]
    if len(words) != (4 if is_list else 2) or not all(kind in KINDS for kind in kinds):
        raise ToolError(f"{where}: {quoted(' '.join(words))} is no property of PLY, such as float x: the file is damaged")
    return words[-1], KINDS[kinds[0]] if is_list else None, KINDS[kinds[-1]]


def _element(words, size, where):
    if len(words) != 2 or not _COUNT.fullmatch(words[1]):
        raise ToolError(f"{where}: {quoted(' '.join(words))} is no element of PLY, such as vertex 8: the file is damaged")
    if int(words[1]) > size:
        raise ToolError(f"{where}: the header promises {int(words[1]):,} of {quoted(words[0])}, and the file has {size:,} bytes: it is "
                        "damaged")
    return Element(words[0], int(words[1]), [])


def read(blob, name):
    """The Header of a file."""
    blob = _as_text(blob)
    lines, body = _divided(blob, name)
    end, elements, images = None, [], []
    for number, line in enumerate(lines, 1):
        (word, *words), where = line.split() or [""], f"{name}:{number}"
        if word == "format":
            end = _ENDS.get(words[0] if words else "")
        elif word == "element":
            elements.append(_element(words, len(blob), where))
            if any(each.name == words[0] for each in elements[:-1]):
                raise ToolError(f"{where}: the element {quoted(words[0])} is there a second time: the file is damaged")
        elif word == "property":
            made = _property(words, where)
            if not elements or (end and made[1] and made[1][0] not in _WHOLE):
                raise ToolError(f"{where}: {quoted(line)} is no property " + ("of a binary file" if elements else "of an element") +
                                ": the file is damaged")
            elements[-1].properties.append(made)
        elif word == "comment" and words[:1] and words[0].lower() == "texturefile":
            images.append(line.split(None, 2)[2].strip() if len(words) > 1 else "")
    if end is None:
        raise ToolError(f"{name}: the header names no format that is ascii, binary_little_endian or binary_big_endian: the file is "
                        "damaged")
    return Header(end, elements, list(filter(None, images))[:IMAGES_MAX], body, len(lines) + 1)


_CODES = {"i1": "b", "u1": "B", "i2": "h", "u2": "H", "i4": "i", "u4": "I", "f4": "f", "f8": "d"}     # of struct


class Damaged(ValueError):
    """A file that does not hold what its header says; the text says what is missing."""


def _even_binary(blob, start, rows, properties, end):
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


def _uneven_binary(blob, start, rows, properties, end):
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


def binary_tables(header):
    """({element: {property: its numbers, one a row, or an array a row}} of a file, how many bytes stand behind them)."""
    blob, at, found = header.body, 0, {}
    for element in header.elements:
        rows, properties = element.rows, element.properties
        if not rows or not properties:
            continue
        even = _even_binary(blob, at, rows, properties, header.end)
        if even is None and not any(count for _, count, _ in properties):
            raise Damaged(f"it ends within the {rows:,} rows of {shortened(element.name)}")
        found[element.name], at = even or _uneven_binary(blob, at, rows, properties, header.end)
    return found, len(blob) - at


_PART = 1 << 20         # bytes whose words are numbers at a time
_NEWLINE = re.compile(rb"\r\n|\r|\n")
_OTHER = re.compile(rb"[^0-9eE+\-.naifytNAIFYT\s]")      # of no number, of no NaN and of no infinity


def _numbers(words):
    """The words as an array of doubles; ValueError where one is no number."""
    return np.array(list(map(float, words)), dtype=float)


def _whole_words(body, at):
    """(the words from a place on, about a part of them; where the next one begins)."""
    end = at + _PART
    while end < len(body) and not body[end:end + 1].isspace():
        end += 1
    return body[at:end], end


class _Row:
    """The numbers of a body, as many of them as are numbers, and the first word that is none."""

    def __init__(self, body):
        self.at, parts, self.bad, self.words_behind, at = 0, [], None, 0, 0
        while at < len(body) and self.bad is None:
            start, (part, at) = at, _whole_words(body, at)
            try:
                if _OTHER.search(part):
                    raise ValueError("no number")
                parts.append(_numbers(part.split()))
            except ValueError:
                parts.append(self._up_to_bad(body, start, part))
        self.numbers = np.concatenate(parts) if parts else np.zeros(0)
        if self.bad is not None:
            self.words_behind = len(body[at:].split()) + self.in_part

    def _up_to_bad(self, body, start, part):
        """The numbers of a part before the first word that is none."""
        found = []
        words = list(re.finditer(rb"\S+", part))
        for number, word in enumerate(words):
            try:
                if _OTHER.search(word[0]):
                    raise ValueError("no number")
                found.append(float(word[0]))
            except ValueError:
                line = 1 + len(_NEWLINE.findall(body, 0, start + word.start()))
                self.bad, self.in_part = (line, word[0].decode("utf-8", "replace")), len(words) - number
                break
        return np.array(found)

    def take(self, count):
        """The next numbers; None where there are fewer."""
        if self.at + count > len(self.numbers):
            return None
        self.at += count
        return self.numbers[self.at - count:self.at]


def _length(value, most):
    """The length of a list as a whole number; -1 for what is none."""
    return int(value) if 0 <= value <= most and value == int(value) else -1


def _uneven(row, element):
    """The columns of a table with lists, row by row; None where numbers are missing."""
    found = [[] for _ in element.properties]
    for _ in range(element.rows):
        for column, (_, count, _) in zip(found, element.properties):
            length = 1
            if count:
                given = row.take(1)
                length = -1 if given is None else _length(given[0], len(row.numbers))
            numbers = row.take(length) if length >= 0 else None
            if numbers is None:
                return None
            column.append(numbers if count else numbers[0])
    return found


def _even(row, element):
    """The columns of a table all of whose lists are as long as those of its first row; None where they are not."""
    at, places = row.at, []
    for _, count, _ in element.properties:
        length = 1
        if count:
            length = _length(row.numbers[at], len(row.numbers)) if at < len(row.numbers) else -1
            if length < 0:
                return None
            at += 1
        places.append((at - row.at, length, count))
        at += length
    size = at - row.at
    if not size or row.at + size * element.rows > len(row.numbers):
        return None
    table = row.numbers[row.at:row.at + size * element.rows].reshape(element.rows, size)
    if any(count and (table[:, place - 1] != length).any() for place, length, count in places):
        return None
    row.at += size * element.rows
    return [table[:, place:place + length] if count else table[:, place] for place, length, count in places]


def _of_kind(column, kind):
    """Whole numbers of a property that says it has such; in the kind's range."""
    if kind[0] == "f":
        return np.asarray(column, dtype=float)
    most = np.iinfo(kind)
    return np.clip(np.nan_to_num(np.asarray(column, dtype=float)), most.min, most.max).astype(kind)


def tables(header, name):
    """({element: {property: its numbers, one a row, or an array a row}} of a file, how many words stand behind them)."""
    row, found = _Row(header.body), {}
    for element in header.elements:
        if not element.rows or not element.properties:
            continue
        columns = _even(row, element) or _uneven(row, element)
        if columns is None and row.bad:
            raise ToolError(f"{name}:{header.lines + row.bad[0]}: {quoted(row.bad[1])} is not a number")
        if columns is None:
            raise Damaged(f"it ends within the {element.rows:,} rows of {shortened(element.name)}")
        found[element.name] = {key: column if count else _of_kind(column, kind)
                               for (key, count, kind), column in zip(element.properties, columns)}
    return found, len(row.numbers) - row.at + row.words_behind
