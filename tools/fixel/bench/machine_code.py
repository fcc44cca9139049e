# SPDX-License-Identifier: MIT
"""A program's functions and instructions, from its ELF file."""

import dataclasses
import pathlib

from elftools.common.exceptions import ELFError
from elftools.elf.elffile import ELFFile

from fixel.base import reading
from fixel.bench import thumb
from fixel.base.errors import ToolError

SHF_EXECINSTR = 4


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
        # "$t" and "$d" mark where code and data begin within a section.
        self.marks = sorted((symbol["st_value"] & ~1, symbol.name[1]) for symbol in symbols
                            if symbol.name[:2] in ("$t", "$d"))
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
            second = self._halfword(address + 2) if thumb.size_of(first) == 4 else 0
            self.decoded[address] = thumb.decode(first, second)
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
