# SPDX-License-Identifier: MIT
"""A program's functions and instructions, from its ELF file."""

import dataclasses
import functools
import os
import pathlib

from elftools.common.exceptions import ELFError
from elftools.elf.elffile import ELFFile

from fixel.base import reading
from fixel.bench import thumb
from fixel.base.errors import ToolError

SHF_EXECINSTR = 4
READ_ONCE = 8       # files of a kind that a command keeps


@dataclasses.dataclass(frozen=True)
class Function:
    """A function's code: from start up to end."""
    name: str
    start: int
    end: int


class MachineCode:
    """functions in rising order; instruction(address); symbol(name)."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        try:
            with reading.open_file(path) as file:
                elf = ELFFile(file)
                self._read(elf)
        except ELFError as error:
            raise ToolError(f"{path} is not an ELF file: {error}") from error

    def _read(self, elf):
        table = elf.get_section_by_name(".symtab")
        if table is None:
            raise ToolError(f"{self.path} has no symbols")
        symbols = list(table.iter_symbols())
        self.symbols = {symbol.name: symbol["st_value"] for symbol in symbols if symbol.name}
        self.functions = _functions(elf, symbols)
        self.sections = [(section["sh_addr"], section.data()) for section in elf.iter_sections()
                         if section["sh_flags"] & SHF_EXECINSTR and section["sh_size"]]
        self.is_riscv = elf["e_machine"] == "EM_RISCV"
        # "$t" and "$d" mark where code and data begin within a section; those of sections that are not loaded have its offsets.
        # RISC-V has functions of a stated size alone.
        holds_code = [bool(section["sh_flags"] & SHF_EXECINSTR) for section in elf.iter_sections()]
        self.marks = sorted((symbol["st_value"] & ~1, symbol.name[1]) for symbol in symbols
                            if symbol.name[:2] in ("$t", "$d") and isinstance(symbol["st_shndx"], int) and holds_code[symbol["st_shndx"]])
        if self.is_riscv:
            self.marks = sorted(mark for each in self.functions for mark in ((each.start, "t"), (each.end, "d")))
        self.decoded = {}

    def symbol(self, name):
        """A symbol's address, without the bit that says Thumb."""
        if name not in self.symbols:
            raise ToolError(f"{self.path} has no symbol {name}: it is not a program of the bench")
        return self.symbols[name] & ~1

    def instruction(self, address):
        """The instruction at an address."""
        if address not in self.decoded:
            first = self._halfword(address)
            is_long = first & 3 == 3 if self.is_riscv else thumb.size_of(first) == 4
            second = self._halfword(address + 2) if is_long else 0
            self.decoded[address] = (riscv_instruction if self.is_riscv else thumb.decode)(first, second)
        return self.decoded[address]

    def _halfword(self, address):
        for start, data in self.sections:
            if start <= address and address + 2 <= start + len(data):
                return int.from_bytes(data[address - start:address - start + 2], "little")
        raise ToolError(f"{self.path} has no code at {address:#x}: the counts are of another program")

    def each_instruction(self):
        """(address, instruction) of all code."""
        for number, (start, mark) in enumerate(self.marks):
            if mark != "t":
                continue
            limit = self.marks[number + 1][0] if number + 1 < len(self.marks) else None
            yield from self._run(start, limit)

    def _run(self, address, limit):
        for start, data in self.sections:
            if start <= address < start + len(data):
                end = min(start + len(data), limit) if limit is not None else start + len(data)
                while address + 2 <= end:
                    found = self.instruction(address)
                    yield address, found
                    address += found.size


@functools.lru_cache(READ_ONCE)
def _once(read, path, _written):
    return read(path)


def read_once(read, path):
    """read(path), once for a state of the file: MachineCode or DebugLines of a program that draws many scenes."""
    return _once(read, path, os.stat(path).st_mtime_ns) if os.path.exists(path) else read(path)


# Of RISC-V (The RISC-V Instruction Set Manual, volume I, "Instruction Set Listings"): by the opcode of 32 bits, and by quadrant
# and upper three bits of 16 bits. Others are "other".
LONG = {0x03: "load", 0x23: "store", 0x63: "branch conditional", 0x6F: "branch", 0x67: "branch exchange"}
SHORT = {(0, 2): "load", (0, 6): "store", (1, 1): "call", (1, 5): "branch", (1, 6): "branch conditional", (1, 7): "branch conditional",
         (2, 2): "load", (2, 6): "store"}
LINKS = (1, 5)      # registers that a call writes its return address into
CALL_OF = {"branch": "call", "branch exchange": "call register"}


def riscv_instruction(first, second):
    """The instruction of RISC-V of 32 bits of one halfword, or of two, by the kinds of fixel.bench.thumb."""
    if first & 3 != 3:
        kind, register = SHORT.get((first & 3, first >> 13), "other"), first >> 7 & 31
        if first & 0xE07F == 0x8002 and register:
            kind = "call register" if first & 0x1000 else "branch exchange"
        return thumb.Instruction(2, kind)
    word = second << 16 | first
    opcode, target, number = word & 127, word >> 7 & 31, word >> 12 & 7
    kind = LONG.get(opcode, "other")
    if kind in CALL_OF and target in LINKS:
        kind = CALL_OF[kind]
    if opcode == 0x33 and word >> 25 == 1:
        kind = "divide" if number > 3 else "long multiply" if number else "multiply"
    return thumb.Instruction(4, kind)


def _functions(elf, symbols):
    """Functions by address. One without a stated size (assembly) reaches to the next; of two names
    for the same code the global one counts."""
    chosen = {}
    for symbol in symbols:
        section = symbol["st_shndx"]
        if symbol["st_info"]["type"] != "STT_FUNC" or not isinstance(section, int):
            continue
        start = symbol["st_value"] & ~1
        rank = (symbol["st_size"] > 0, symbol["st_info"]["bind"] == "STB_GLOBAL", symbol.name)
        if start not in chosen or rank > chosen[start][0]:
            chosen[start] = (rank, symbol.name, symbol["st_size"], elf.get_section(section))
    starts = sorted(chosen)
    functions = []
    for number, start in enumerate(starts):
        _, name, size, section = chosen[start]
        following = starts[number + 1] if number + 1 < len(starts) else section["sh_addr"] + section["sh_size"]
        end = min(start + size, following) if size else min(following, section["sh_addr"] + section["sh_size"])
        functions.append(Function(name, start, end))
    return functions
