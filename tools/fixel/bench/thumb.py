# SPDX-License-Identifier: MIT
"""Sorts Thumb instructions by what they cost: enough of the encoding of Armv6-M to Armv8.1-M
(the Architecture Reference Manuals' tables "instruction set encoding") to tell a multiplication
from a load, and no more."""

import dataclasses

# Every kind that kind_of answers. A "taken" or not of a branch is seen when the program runs.
KINDS = ("other", "multiply", "multiply add", "long multiply", "long multiply add", "divide",
         "load", "store", "load multiple", "store multiple", "pop to pc", "load to pc",
         "branch", "branch conditional", "branch exchange", "table branch", "call",
         "call register", "it", "system", "float", "float multiply add", "float divide",
         "float root", "float load", "float store", "float load multiple", "float store multiple",
         "vector")
CALLS = {"call", "call register"}
RETURNS = {"branch exchange", "pop to pc", "load to pc"}


@dataclasses.dataclass(frozen=True)
class Instruction:
    """An instruction: bytes, kind, how many registers it moves where it moves several, whether it loads from beside
    the code."""
    size: int
    kind: str
    registers: int = 0
    is_literal: bool = False


def size_of(first):
    """2 or 4, from the first halfword."""
    return 4 if first >> 11 in (0x1D, 0x1E, 0x1F) else 2


def decode(first, second=0):
    """The instruction of one halfword, or of two."""
    if size_of(first) == 2:
        return _narrow(first)
    return _wide(first, second)


def _narrow(h):
    top = h >> 12
    if top == 4:
        return Instruction(2, _narrow_four(h), is_literal=h >> 11 == 0b01001)
    if top == 5:
        return Instruction(2, "store" if (h >> 9) & 7 < 3 else "load")
    if top in (6, 7, 8, 9):
        return Instruction(2, "load" if h & 0x0800 else "store")
    if top == 0xB:
        return _narrow_miscellaneous(h)
    if top == 0xC:
        return Instruction(2, "load multiple" if h & 0x0800 else "store multiple",
                           (h & 0xFF).bit_count())
    if top == 0xD:
        return Instruction(2, "branch conditional" if (h >> 8) & 15 < 14 else "system")
    return Instruction(2, "branch" if top == 0xE else "other")


def _narrow_four(h):
    """0x4000 to 0x4FFF: register operations, branches to a register, loads from beside the code."""
    if h >> 11 == 0b01001:
        return "load"
    if h >> 10 == 0b010000:
        return "multiply" if (h >> 6) & 15 == 13 else "other"
    if (h >> 8) & 3 == 3:
        return "call register" if h & 0x80 else "branch exchange"
    target = (h & 7) | (h >> 4 & 8)
    return "branch exchange" if target == 15 and (h >> 8) & 3 != 1 else "other"


def _narrow_miscellaneous(h):
    """0xB000 to 0xBFFF."""
    if h & 0xF500 == 0xB100:
        return Instruction(2, "branch conditional")     # compare with zero and branch
    if h & 0xFE00 == 0xB400:
        return Instruction(2, "store multiple", (h & 0x1FF).bit_count())
    if h & 0xFE00 == 0xBC00:
        return Instruction(2, "pop to pc" if h & 0x100 else "load multiple", (h & 0x1FF).bit_count())
    if h & 0xFF00 == 0xBF00:
        return Instruction(2, "it" if h & 15 else "system")
    if h & 0xFF00 in (0xB600, 0xBE00):
        return Instruction(2, "system")
    return Instruction(2, "other")


def _wide(a, b):
    group = a >> 11 & 3
    if a & 0x0400 and group != 2:
        return _coprocessor(a, b)
    if group == 1:
        return _wide_memory(a, b)
    if group == 2:
        return Instruction(4, _wide_branch(a, b) if b & 0x8000 else "other")
    if a & 0xFE00 == 0xF800:
        return _wide_single(a, b)
    if a & 0xFF00 == 0xFB00:
        return Instruction(4, _wide_multiply(a, b))
    return Instruction(4, "other")


def _wide_memory(a, b):
    """0xE800 to 0xEBFF: several registers, pairs, exclusives, table branches, shifted operands."""
    if a & 0x0200:
        return Instruction(4, "other")
    loads = bool(a & 0x10)
    if not a & 0x40:
        if loads and b & 0x8000:
            return Instruction(4, "pop to pc", b.bit_count())
        return Instruction(4, "load multiple" if loads else "store multiple", b.bit_count())
    if a & 0xFFF0 == 0xE8D0 and b & 0xE0 == 0:
        return Instruction(4, "table branch")
    if a & 0x0120:      # a pair: an index before or after the base is what tells it from an exclusive
        return Instruction(4, "load multiple" if loads else "store multiple", 2)
    return Instruction(4, "load" if loads else "store")


def _wide_branch(a, b):
    """0xF000 to 0xF7FF with the second halfword's top bit set."""
    if b & 0xD000 == 0xD000:
        return "call"
    if b & 0xD000 == 0x9000:
        return "branch"
    if b & 0xD000 == 0xC000:    # loops of Armv8.1-M: DLS only sets the counter up
        return "other" if b & 0x2000 else "branch conditional"
    return "system" if a >> 7 & 7 == 7 else "branch conditional"


def _wide_single(a, b):
    """0xF800 to 0xF9FF: one register."""
    if not a & 0x10:
        return Instruction(4, "store")
    if b >> 12 == 15:
        return Instruction(4, "load to pc" if a & 0xFF70 == 0xF850 else "system")
    return Instruction(4, "load", is_literal=a & 15 == 15)


def _wide_multiply(a, b):
    """0xFB00 to 0xFBFF."""
    if a & 0x80:
        operation = a >> 4 & 7
        if operation in (1, 3):
            return "divide"
        return "long multiply" if operation in (0, 2) else "long multiply add"
    return "multiply" if b >> 12 == 15 else "multiply add"


def _coprocessor(a, b):
    """0xEC00 to 0xEFFF and 0xFC00 to 0xFFFF: floating point and vectors."""
    if b >> 8 & 15 not in (10, 11) or a & 0x0300 == 0x0300:
        return Instruction(4, "vector")
    if a & 0xFE00 == 0xEC00:
        return _float_memory(a, b)
    if a & 0x1000 or b & 0x10:
        return Instruction(4, "float")
    operation = a >> 4 & 11
    if operation in (0, 1, 9, 10):
        return Instruction(4, "float multiply add")
    if operation == 8:
        return Instruction(4, "float divide")
    if operation == 11 and a & 15 == 1 and b & 0xC0 == 0xC0:
        return Instruction(4, "float root")
    return Instruction(4, "float")


def _float_memory(a, b):
    loads = bool(a & 0x10)
    if a & 0xFFE0 == 0xEC40:
        return Instruction(4, "float")      # to or from two core registers
    words = b & 0xFF
    if a & 0x0120 == 0x0100:    # one register: 4 bytes, or 8 as two
        if b & 0x0100:
            return Instruction(4, "float load multiple" if loads else "float store multiple", 2)
        return Instruction(4, "float load" if loads else "float store")
    return Instruction(4, "float load multiple" if loads else "float store multiple", words)
