# SPDX-License-Identifier: MIT
"""Source lines and inlined functions of a program's addresses, from its DWARF."""

import bisect
import os
import pathlib
import re

from elftools.dwarf.descriptions import describe_form_class
from elftools.dwarf.ranges import BaseAddressEntry
from elftools.elf.elffile import ELFFile

from fixel.base import reading
from fixel.board import symbols

ROOT = pathlib.Path(__file__).resolve().parents[3]


class DebugLines:
    """line(address) -> "file:line" or None; inlined(address) -> names, outermost first;
    files: {function: the file that it stands in}."""

    def __init__(self, path):
        with reading.open_file(path) as file:
            elf = ELFFile(file)
            self.rows, self.scopes, self.files = [], [], {}
            if elf.has_dwarf_info():
                self._read(elf.get_dwarf_info())
        self.rows.sort(key=lambda row: row[0])
        self.addresses = [row[0] for row in self.rows]
        self.edges = sorted({edge for low, high, *_ in self.scopes for edge in (low, high)})
        self.around = {}    # between two edges all instructions were inlined alike

    def _read(self, dwarf):
        for unit in dwarf.iter_CUs():
            program = dwarf.line_program_for_CU(unit)
            if program is not None:
                self._read_lines(program)
            for die in unit.iter_DIEs():
                if die.tag == "DW_TAG_subprogram" and program is not None:
                    self._read_place(die, program.header)
                if die.tag == "DW_TAG_inlined_subroutine":
                    name = _origin_name(die)
                    self.scopes += [(low, high, _depth(die), name) for low, high in _ranges(dwarf, unit, die)]

    def _read_lines(self, program):
        before = None
        for entry in program.get_entries():
            state = entry.state
            if state is None:
                continue
            if before is not None and before[0] < state.address:
                self.rows.append((before[0], state.address, before[1]))
            before = None if state.end_sequence else \
                (state.address, f"{_relative(symbols.file_name(program.header, state.file))}:{state.line}")

    def _read_place(self, die, header):
        """Where a function stands; of functions of one name in several files, the first counts."""
        if "DW_AT_name" in die.attributes and "DW_AT_decl_file" in die.attributes \
                and "DW_AT_declaration" not in die.attributes:
            file = _relative(symbols.file_name(header, die.attributes["DW_AT_decl_file"].value))
            self.files.setdefault(die.attributes["DW_AT_name"].value.decode("utf-8", "replace"), file)

    def line(self, address):
        """file:line of an instruction; None where the program does not say (code of a library)."""
        place = bisect.bisect_right(self.addresses, address) - 1
        if place < 0 or address >= self.rows[place][1]:
            return None
        return self.rows[place][2]

    def file_of(self, name, address):
        """The file of a function that begins at an address; assembly has lines, but says no names."""
        if name not in self.files:
            line = self.line(address)
            self.files[name] = line.rsplit(":", 1)[0] if line else ""
        return self.files[name]

    def inlined(self, address):
        """The functions that were inlined about an instruction, outermost first."""
        place = bisect.bisect_right(self.edges, address)
        if place not in self.around:
            self.around[place] = [name for _, name in sorted((depth, name) for low, high, depth, name in self.scopes if low <= address < high)]
        return self.around[place]


def _relative(name):
    """A file's name without this machine's folders, nor those that the compiler was built in."""
    name = os.path.relpath(name, ROOT) if name.startswith(str(ROOT)) else name
    return re.sub(r"^(\.\./)+", "", name)


def _depth(die):
    depth = 0
    while (die := die.get_parent()) is not None:
        depth += 1
    return depth


def _origin_name(die):
    """An inlined function's name, which stands where it was declared."""
    while "DW_AT_name" not in die.attributes:
        link = "DW_AT_abstract_origin" if "DW_AT_abstract_origin" in die.attributes else "DW_AT_specification"
        if link not in die.attributes:
            return "?"
        die = die.get_DIE_from_attribute(link)
    return die.attributes["DW_AT_name"].value.decode("utf-8", "replace")


def _ranges(dwarf, unit, die):
    """[(from, up to)] of a piece of code."""
    attributes = die.attributes
    if "DW_AT_low_pc" in attributes and "DW_AT_high_pc" in attributes:
        low, high = attributes["DW_AT_low_pc"].value, attributes["DW_AT_high_pc"]
        offset = 0 if describe_form_class(high.form) == "address" else low
        return [(low, high.value + offset)]
    if "DW_AT_ranges" not in attributes:
        return []
    base = unit.get_top_DIE().attributes.get("DW_AT_low_pc")
    base = base.value if base else 0
    found = []
    for entry in dwarf.range_lists().get_range_list_at_offset(attributes["DW_AT_ranges"].value, cu=unit):
        if isinstance(entry, BaseAddressEntry):
            base = entry.base_address
        else:
            start = 0 if entry.is_absolute else base
            found.append((start + entry.begin_offset, start + entry.end_offset))
    return found
