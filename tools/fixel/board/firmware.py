# SPDX-License-Identifier: MIT
"""A board's program (ELF) and what it says about its board.

Every program carries a section `.fxl_board` with lines of key=value, the symbols
of its memory map, and, where the flash has sectors of different sizes, a section
`.fxl_sectors`. There is no other table of boards: a new board needs no change
here.
"""

import dataclasses
import functools
import io
import pathlib
import shlex
import struct

from elftools.common.exceptions import ELFError
from elftools.construct import ConstructError
from elftools.elf.elffile import ELFFile

from fixel.base import reading
from fixel.base.errors import ToolError

HOST = "host"
SYMBOLS = ("fxl_flash_base", "fxl_flash_size", "fxl_flash_sector", "fxl_scene_base", "fxl_scene_size")
SECOND = ("fxl_scene_flash_base", "fxl_scene_flash_size")   # a flash for scenes alone; 0, 0: there is none
SECTORS_MAX = 1 << 16  # of a flash; more is a mistake
ELF_MAX = 1 << 28   # bytes, with all that a debugger reads
# What pyelftools lets through where a file is damaged.
DAMAGE = (ELFError, ConstructError, struct.error, ArithmeticError, AttributeError, LookupError, MemoryError,
          TypeError, ValueError)


@dataclasses.dataclass(frozen=True)
class Program:
    """A program and its board. Addresses and sizes are bytes; those of the
    host board, which has no memory map, are 0."""

    path: pathlib.Path
    board: str
    cpu: str
    qemu: tuple[str, ...]
    openocd: tuple[str, ...]  # configuration for the real board; empty where there is none
    segments: tuple[tuple[int, bytes], ...]
    flash_base: int = 0
    flash_size: int = 0
    scene_base: int = 0
    scene_size: int = 0
    scene_flash_base: int = 0   # of a second flash, for scenes alone
    scene_flash_size: int = 0   # 0: there is none
    sectors: tuple[int, ...] = ()  # the size of each of the flash, from the lowest on
    window_size: int = 0    # of the memory that QEMU can share with a viewer; 0: none
    emulator: str = "qemu-system-arm"
    counts: str = "instructions"    # what its clock counts; "cycles" are the emulator's
    code: str = ""          # "own": its core's code is not that of other boards with the core (-Os, -DFXL_SMALL)
    uf2: int = 0            # the family of its UF2 files; 0: it takes none
    wires: dict = dataclasses.field(default_factory=dict)   # of a display on the real board: line -> its pin; none: recorded ones
    clock: int = 0          # of the real board's core in Hz, where there are wires
    spi: int = 0            # of the display's clock
    uart: int = 0           # the pin of what it prints
    keys: dict = dataclasses.field(default_factory=dict)  # of a player: bit -> QEMU's names of what is pressed for it

    @property
    def hosted(self):
        return self.board == HOST

    @property
    def banks(self):
        """(address, size, offset in the image) of each flash: the image has one after the other."""
        first = (self.flash_base, self.flash_size, 0)
        return (first, (self.scene_flash_base, self.scene_flash_size, self.flash_size)) if self.scene_flash_size else (first,)

    @property
    def image_size(self):
        """Bytes of all flash."""
        return self.flash_size + self.scene_flash_size

    def offset(self, address):
        """Where the image has an address; None where no flash has it."""
        return next((address - base + offset for base, size, offset in self.banks if base <= address < base + size), None)

    def address(self, offset):
        """What a place of the image has as its address."""
        return next(base + offset - start for base, size, start in self.banks if start <= offset < start + size)


def open_elf(path):
    """A program's file, read."""
    return ELFFile(io.BytesIO(reading.read_whole(path, ELF_MAX, "give a program that make built")))


def read_note(elf, path):
    section = elf.get_section_by_name(".fxl_board")
    if section is None:
        raise ToolError(f"{path} is not a program of Fixel: it does not name its board")
    text = section.data().replace(b"\0", b"\n").decode("ascii", "replace")
    note = dict(line.split("=", 1) for line in text.splitlines() if "=" in line)
    if not note.get("board"):
        raise ToolError(f"{path} does not name its board: build it again")
    return note


def read_sectors(elf, path, flash_size, sector):
    """Sizes of the flash's sectors: count and size of each run of equal ones
    from .fxl_sectors, else all of one size."""
    section = elf.get_section_by_name(".fxl_sectors")
    if section is None:
        runs = [(flash_size // sector, sector)] if sector > 0 else []
    else:
        runs = list(struct.iter_unpack("<II", section.data()))
    if any(size == 0 for _, size in runs) or sum(count for count, _ in runs) > SECTORS_MAX \
            or sum(count * size for count, size in runs) != flash_size:
        said = " and ".join(f"{count} of {size}" for count, size in runs)
        raise ToolError(f"{path}: BOARD_SECTORS in its board.mk says that the sectors of the flash are "
                        f"{f'{said} bytes' if said else 'none'}, and that the flash has {flash_size}")
    return tuple(size for count, size in runs for _ in range(count))


def read_keys(text):
    """Keys as a note has them, "1:up,16:ctrl+up": bit of fixel/player.h -> QEMU's names."""
    pairs = (each.split(":", 1) for each in text.split(",") if each)
    return {int(bit): tuple(names.split("+")) for bit, names in pairs}


def read_wires(note):
    """How a display is wired, as a note has it: "CLK:18,DIN:19", and the clock by which its own is told."""
    clock = int(note.get("clock", "0"))
    return dict(wires={line: int(pin) for line, _, pin in (each.partition(":") for each in note.get("wires", "").split(",") if each)},
                clock=clock, spi=clock // int(note.get("spi_divisor", "1")), uart=int(note.get("uart", "0")))


def read_map(elf, path):
    table = elf.get_section_by_name(".symtab")
    found = {}
    for name in SYMBOLS:
        symbols = table.get_symbol_by_name(name) if table is not None else None
        if not symbols:
            raise ToolError(f"{path} has no symbol {name}: BOARD_MEMORY in its board.mk does not define it")
        found[name.removeprefix("fxl_")] = symbols[0]["st_value"]
    for name in SECOND:
        symbols = table.get_symbol_by_name(name)
        found[name.removeprefix("fxl_")] = symbols[0]["st_value"] if symbols else 0
    found["sectors"] = read_sectors(elf, path, found["flash_size"] + found["scene_flash_size"], found.pop("flash_sector"))
    return found


def read_segments(elf, path):
    """(address, bytes) of all that is to be in flash."""
    found = []
    for segment in elf.iter_segments():
        if segment["p_type"] == "PT_LOAD" and segment["p_filesz"] > 0:
            content = segment.data()
            if len(content) != segment["p_filesz"]:
                raise ToolError(f"{path} is cut off: build it again")
            found.append((segment["p_paddr"], content))
    return tuple(found)


def load(path, board=None):
    """Reads a program; board, where given, is the one that it must be for."""
    path = pathlib.Path(path)
    try:
        state = path.stat()
    except FileNotFoundError:
        raise ToolError(f"{path}: there is no such program; make run BOARD=NAME builds the one of a board") from None
    except (OSError, ValueError):
        return _load(path, board)   # which says what is wrong
    return _known(path, board, (state.st_dev, state.st_ino, state.st_mtime_ns, state.st_ctime_ns, state.st_size))


@functools.lru_cache(maxsize=16)
def _known(path, board, _state):
    """A program that has been read, as long as its file stays as it is: a command asks for it several times."""
    return _load(path, board)


def _load(path, board):
    try:
        elf = open_elf(path)
        note = read_note(elf, path)
        if board is not None and note["board"] != board:
            raise ToolError(f"{path} is for board {note['board']}, not for {board}")
        common = dict(path=path, board=note["board"], cpu=note.get("cpu", "unknown"),
                      qemu=tuple(shlex.split(note.get("qemu", ""))),
                      openocd=tuple(shlex.split(note.get("openocd", ""))),
                      window_size=int(note.get("window", "0")), emulator=note.get("emulator", Program.emulator), counts=note.get("counts", Program.counts), code=note.get("code", Program.code),
                      uf2=int(note.get("uf2", "0"), 16),
                      keys=read_keys(note.get("keys", "")), **read_wires(note))
        if note["board"] == HOST:
            return Program(segments=(), **common)
        return Program(segments=read_segments(elf, path), **common, **read_map(elf, path))
    except DAMAGE as error:
        raise ToolError(f"{path} is not an ELF file, or a damaged one: {error}") from error
