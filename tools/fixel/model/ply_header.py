# SPDX-License-Identifier: MIT
"""The header of a PLY file: what tables stand behind it, and of which numbers."""

import codecs
import re
from dataclasses import dataclass

from fixel.base.errors import ToolError
from fixel.base.reading import quoted

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
