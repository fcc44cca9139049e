# SPDX-License-Identifier: MIT
"""Names for addresses: function, offset and source line, from a program's ELF."""

import bisect
import functools
import re

from elftools.common.exceptions import DWARFError, ELFError

from fixel.board import firmware
from fixel.base.errors import ToolError

WORD = re.compile(r"(\S+) +0x([0-9a-f]{8})")
WORDS = re.compile(r"  (?:\S+ +0x[0-9a-f]{8} *)+")
REMARK = re.compile(r"(  (pc|lr|from) +0x([0-9a-f]{8})  )(\D.*)")
# What a board says about a fault, and what QEMU prints when a core locks up.
FAULT = re.compile(r"^fault: ", re.MULTILINE)
LOCKUP = re.compile(r"^qemu: fatal: Lockup.*?R14=([0-9a-f]{8}) R15=([0-9a-f]{8})", re.MULTILINE | re.DOTALL)
CODE = ("pc", "lr", "from")
RETURNS = ("lr", "from")  # they point behind a call


class Symbols:
    """The symbols of a program; without any, nothing gets a name."""

    def __init__(self, path):
        self.path = path

    @functools.cached_property
    def _tables(self):
        """Functions and objects. To read them takes longer than most programs run: only whoever asks for a name waits."""
        tables = {"STT_FUNC": {}, "STT_OBJECT": {}}
        try:
            table = firmware.open_elf(self.path).get_section_by_name(".symtab")
            for symbol in table.iter_symbols() if table is not None else ():
                kind = symbol["st_info"]["type"]
                if kind in tables and symbol["st_size"] > 0:
                    start = symbol["st_value"] & (~1 if kind == "STT_FUNC" else ~0)  # Thumb
                    tables[kind][start] = (symbol["st_size"], symbol.name)
        except (ToolError, ELFError):
            pass
        return tuple(sorted((start, *rest) for start, rest in tables[kind].items())
                     for kind in ("STT_FUNC", "STT_OBJECT"))

    @staticmethod
    def _find(table, address):
        at = bisect.bisect_right(table, (address, float("inf"), "")) - 1
        if at >= 0 and address < table[at][0] + table[at][1]:
            return table[at]
        return None

    def _line(self, address):
        """The source line of an address, "" where it is not known."""
        try:
            return source_line(firmware.open_elf(self.path), address)
        except (ToolError, ELFError, DWARFError):
            return ""

    def place(self, word, address):
        """Where an address is, as "in function+0x14 (file.c:30)", or "". word:
        what it was printed as."""
        if word not in CODE:
            found = self._find(self._tables[1], address)
            return f"in {found[2]}+{address - found[0]:#x}" if found else ""
        address &= ~1
        looked_up = address - 2 if word in RETURNS else address
        found = self._find(self._tables[0], looked_up)
        if not found:
            return ""
        line = self._line(looked_up)
        return f"in {found[2]}+{address - found[0]:#x}" + (f" ({line})" if line else "")

    def _rows(self, line):
        """A line of a fault: where it is words with addresses, with a line of its
        own for each that has a name."""
        if not WORDS.fullmatch(line):
            remark = REMARK.fullmatch(line)
            place = self.place(remark[2], int(remark[3], 16)) if remark else ""
            return f"{remark[1]}{place}, {remark[4]}" if place else line
        rows, rest = [], []
        for word, digits in WORD.findall(line):
            place = self.place(word, int(digits, 16)) if word in (*CODE, "address") else ""
            if place:
                rows.append(f"  {word:3} 0x{digits}  {place}")
            else:
                rest.append(f"{word:3} 0x{digits}")
        return "\n".join(rows + (["  " + "  ".join(rest)] if rest else [])) if rows else line

    def name_faults(self, text):
        """What a program printed, with names for the addresses of its fault."""
        fault = FAULT.search(text)
        if fault:
            head, tail = text[:fault.start()], text[fault.start():]
            text = head + "\n".join(self._rows(line) for line in tail.split("\n"))
        lockup = LOCKUP.search(text)
        if lockup:
            text = f"{text.rstrip()}\n{self.registers(*(int(value, 16) for value in lockup.groups()))}\n"
        return text

    def registers(self, lr, pc):
        """Two lines: where the core is, and where that was called from."""
        return "\n".join(f"  {word:3} 0x{value:08x}  {self.place(word, value)}".rstrip()
                         for word, value in (("pc", pc), ("lr", lr)))


def source_line(elf, address):
    """file:line of an address by an ELF's DWARF, "" where it has none."""
    if not elf.has_dwarf_info():
        return ""
    dwarf = elf.get_dwarf_info()
    ranges = dwarf.get_aranges()
    offset = ranges.cu_offset_at_addr(address) if ranges else None
    if offset is None:
        return ""
    program = dwarf.line_program_for_CU(dwarf.get_CU_at(offset))
    before = None
    for entry in program.get_entries() if program else ():
        state = entry.state
        if state is None:
            continue
        if before is not None and before.address <= address < state.address:
            return f"{file_name(program.header, before.file)}:{before.line}"
        before = None if state.end_sequence else state
    return ""


def file_name(header, number):
    """A file of a line program as the compiler was given it."""
    five = header["version"] >= 5  # DWARF 5 counts from 0
    entry = header["file_entry"][number if five else number - 1]
    name = entry.name.decode("utf-8", "replace")
    folder = entry.dir_index
    if name.startswith("/") or folder == 0:
        return name
    folders = header["include_directory"]
    prefix = folders[folder if five else folder - 1].decode("utf-8", "replace")
    return f"{prefix}/{name}"
