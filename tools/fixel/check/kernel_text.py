# SPDX-License-Identifier: MIT
"""Hashes of the machine text of the kernels that a program of `make equality` compares.

They come from the object files that the program was linked of, as its map names them: there each function and each
table has a section of its own, and no address is in it yet. A kernel's test reaches sections by relocations. Those of the
library are the kernel; those of the portable library, and of the test itself, are what it is compared with. A
comment, a move within a file, and a change of another kernel alter neither hash. Another compiler may alter both.
"""

import functools
import hashlib
import io
import pathlib
import re
import struct
import typing

from fixel.base import reading
from fixel.base.errors import ToolError

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
LOADED = re.compile(r"^LOAD (\S+\.[oa])$", re.MULTILINE)
ARCHIVE, MEMBER = b"!<arch>\n", 60      # what an archive begins with, bytes of a member's head
SHT_SYMTAB, SHT_RELA, SHT_NOBITS, SHT_REL = 2, 4, 8, 9
STB_LOCAL, SHN_LORESERVE = 0, 0xFF00
DIGITS = 12
NUMBER = re.compile(r"\.\d+$")          # which the compiler gives to a static object, counted in its file


class Kernel(typing.NamedTuple):
    """name; number: its place in the program, counted from 1; machine, text: hashes of the kernel, and of what it is compared
    with."""
    name: str
    number: int
    machine: str
    text: str


class _Section(typing.NamedTuple):
    """relocations: [(offset, type, addend, target)]. A target is a symbol's name, or (section's number, place in it)."""
    name: str
    data: bytes
    size: int
    relocations: list


def _string(table, offset):
    return table[offset:table.index(b"\0", offset)].decode()


def _object(data):
    """({number: section}, {symbol: number of its section}) of an ELF file of 32 bits, lower bytes first."""
    if data[:6] != b"\x7fELF\1\1":
        raise ToolError("an object of make equality is no ELF file of 32 bits: run make clean, then make equality")
    (start,), (size, count, names) = struct.unpack_from("<I", data, 32), struct.unpack_from("<3H", data, 46)
    heads = [struct.unpack_from("<10I", data, start + size * number) for number in range(count)]
    bodies = [b"" if head[1] == SHT_NOBITS else data[head[4]:head[4] + head[5]] for head in heads]
    sections = {number: _Section(NUMBER.sub("", _string(bodies[names], head[0])), bodies[number], head[5], [])
                for number, head in enumerate(heads)}
    defined, targets = {}, []
    for head, body in zip(heads, bodies, strict=True):
        if head[1] == SHT_SYMTAB:
            for name, value, _, info, _, section in struct.iter_unpack("<3I2BH", body):
                is_local = info >> 4 == STB_LOCAL and 0 < section < SHN_LORESERVE
                targets.append((section, value) if is_local else _string(bodies[head[6]], name))
                if not is_local and 0 < section < SHN_LORESERVE:
                    defined[targets[-1]] = section
    for head, body in zip(heads, bodies, strict=True):
        if head[1] in (SHT_REL, SHT_RELA):
            for offset, info, *addend in struct.iter_unpack("<3I" if head[1] == SHT_RELA else "<2I", body):
                sections[head[7]].relocations.append((offset, info & 255, addend[0] if addend else None, targets[info >> 8]))
    return sections, defined


def _members(path):
    """The object files of an archive, or of one object file."""
    with reading.open_file(path) as file:
        data = file.read()
    if not data.startswith(ARCHIVE):
        return [data]
    found, at = [], len(ARCHIVE)
    while at < len(data):
        head, length = data[at:at + MEMBER], int(data[at + 48:at + 58])
        if not head.startswith((b"/ ", b"//")):         # of symbols, of long names
            found.append(data[at + MEMBER:at + MEMBER + length])
        at += MEMBER + length + length % 2
    return found


def _part_of(path):
    """What a file is for: "machine", "text", or None for what no kernel is made of."""
    if "equality" in path.parts:
        return "machine" if path.name == "core.o" else "text"
    return "machine" if "lib" in path.parts else None


@functools.cache
def _read(path, _changed):
    return [_object(data) for data in _members(path)]


class _Program:
    """The sections of a program's objects. A section is named by its object's number and its own."""

    def __init__(self, link_map):
        with reading.open_file(link_map) as file:
            loaded = LOADED.findall(io.TextIOWrapper(file, encoding="utf-8", errors="replace").read())
        self.objects, self.defined = [], {}
        for each in dict.fromkeys(loaded):
            part = _part_of(pathlib.PurePath(each))
            if part is not None:
                place = CHECKOUT / each
                for sections, defined in _read(place, place.stat().st_mtime_ns):
                    for name, number in defined.items():
                        self.defined.setdefault(name, (len(self.objects), number))
                    self.objects.append((part, sections))

    def section(self, place):
        """A section."""
        return self.objects[place[0]][1][place[1]]

    def targets(self, place):
        """The sections that one names."""
        for *_, target in self.section(place).relocations:
            if isinstance(target, tuple):
                yield place[0], target[0]
            elif target in self.defined:
                yield self.defined[target]

    def reached(self, name):
        """All that a function reaches, itself too."""
        found, left = set(), [self.defined[name]]
        while left:
            place = left.pop()
            if place not in found:
                found.add(place)
                left += self.targets(place)
        return found

    def text(self, place):
        """What a section's hash is of."""
        section = self.section(place)
        named = [(offset, kind, addend, target if isinstance(target, str) else (self.section((place[0], target[0])).name, target[1]))
                 for offset, kind, addend, target in section.relocations]
        return repr((section.name, section.size, section.data, named))

    def digest(self, places, part):
        """Of those sections among some that are of a part."""
        texts = sorted(self.text(place) for place in places if self.objects[place[0]][0] == part)
        return hashlib.sha256("\n".join(texts).encode()).hexdigest()[:DIGITS]

    def tests(self):
        """[(kernel's name, function)], as equality_tests lists them: a name, then a function."""
        table = self.defined["equality_tests"]
        entries = sorted(self.section(table).relocations, key=lambda each: each[0])
        for (offset, _, addend, target), (*_, function) in zip(entries[::2], entries[1::2], strict=True):
            if addend is None:
                (addend,) = struct.unpack_from("<I", self.section(table).data, offset)
            yield _string(self.section((table[0], target[0])).data, target[1] + addend), function


@functools.cache
def _kernels(link_map, _changed):
    program = _Program(link_map)
    return [Kernel(name, number, *(program.digest(program.reached(function), part) for part in ("machine", "text")))
            for number, (name, function) in enumerate(program.tests(), 1)]


def kernels(elf):
    """The kernels of a program, in its order."""
    link_map = pathlib.Path(elf).resolve().with_suffix(".map")
    found = _kernels(link_map, link_map.stat().st_mtime_ns if link_map.exists() else 0)
    if not found:
        raise ToolError(f"{elf} names no kernel")
    return found
