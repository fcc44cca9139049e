# SPDX-License-Identifier: MIT
"""A static bound of stack depth: frame sizes and the graph of calls, from machine code.

Frame sizes come from the compiler (-fstack-usage, .su files) where it wrote
them, else from the instructions that move the stack pointer (libgcc's
assembly). Calls come from the disassembly. A call or a jump through a register
of which a literal tells the target is one by name. Any other counts as one of
the deepest function whose address is taken somewhere, or which nobody calls by
name. Recursion, and a pointer behind a pointer, have no bound here and are
reported: then a depth is only the least that there may be.
"""

import dataclasses
import pathlib
import re
import struct

from elftools.elf.elffile import ELFFile

from fixel.base import children, reading
from fixel.base.errors import ToolError

SHF_ALLOC = 2
HEADER = re.compile(r"^[0-9a-f]+ <([^>]+)>:$")
INSTRUCTION = re.compile(r"^\s*[0-9a-f]+:\t[0-9a-f ]+\t(\S+)(?:\t(.*))?$")
LITERAL_LOAD = re.compile(r"^(r\d+), \[pc, .*\((\w+) <")
LITERAL = re.compile(r"^\s*([0-9a-f]+):\t[0-9a-f ]+\t\.word\t0x([0-9a-f]+)")
START = re.compile(r"^([0-9a-f]+) <([^>]+)>:$", re.MULTILINE)
ADDRESS = re.compile(r"R_ARM_(?:ABS32|TARGET1|REL32|THM_MOVW_ABS_NC)\s+(\S+)")
RELOCATION = re.compile(r"^\s*[0-9a-f]+: R_ARM_(?:THM_)?(?:CALL|JUMP\d+|PC22|PC11)\s+(\S+)")
TARGET = re.compile(r"<([^>+]+)>")
BRANCH = re.compile(r"^(bl|b|b\.[nw]|b(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)(\.[nw])?|cbn?z)$")


@dataclasses.dataclass
class Function:
    """What the machine code of a function says."""
    frame: int = 0                                      # bytes
    calls: set = dataclasses.field(default_factory=set)
    indirect: int = 0                                   # calls and jumps through a register
    resolved: set = dataclasses.field(default_factory=set)  # of calls, those that a literal told


def run(command):
    """Output of a binutils program."""
    try:
        done = children.run(command, text=True)
    except OSError as error:
        raise ToolError(f"{command[0]}: cannot be started: {error.strerror}") from error
    if done.returncode:
        raise ToolError(f"{command[0]}: {done.stderr.strip().splitlines()[-1:]}")
    return done.stdout


def register_count(text):
    """Registers in a list such as {r4, r5-r7, lr}."""
    count = 0
    for part in text.strip("{} ").split(","):
        ends = part.strip().split("-")
        count += 1 if len(ends) == 1 else int(ends[1][1:]) - int(ends[0][1:]) + 1
    return count


def stack_bytes(mnemonic, operands):
    """Bytes by which an instruction deepens the stack."""
    if mnemonic.startswith("push"):
        return 4 * register_count(operands)
    if mnemonic.startswith("stmdb") and operands.startswith("sp!"):
        return 4 * register_count(operands.split(",", 1)[1])
    match = re.match(r"(?:sp, )?sp, #(\d+)", operands)
    if mnemonic.startswith("sub") and match:
        return int(match[1])
    match = re.search(r"\[sp, #-(\d+)\]!", operands)
    return int(match[1]) if match else 0


def parse_disassembly(text):
    """Functions by name; of several of one name (static ones) the union, which bounds each."""
    functions, name, depth, known = {}, None, 0, {}
    lines = text.splitlines()
    starts = {int(address, 16): start for address, start in START.findall(text)}
    literals = {int(word[1], 16): starts.get(int(word[2], 16) & ~1) for word in map(LITERAL.match, lines) if word}
    for number, line in enumerate(lines):
        if header := HEADER.match(line):
            name, depth, known = header[1], 0, {}
            functions.setdefault(name, Function())
        elif name and (moved := RELOCATION.match(line)):
            functions[name].calls.add(moved[1].removeprefix(".text."))
        elif name and (instruction := INSTRUCTION.match(line)):
            mnemonic, operands = instruction[1], re.split("[;@]", instruction[2] or "")[0].strip()
            depth += stack_bytes(mnemonic, operands)
            functions[name].frame = max(functions[name].frame, depth)
            _note_registers(known, mnemonic, instruction[2] or "", literals)
            # Of an instruction that is still to be relocated, only the relocation knows the target.
            if not any(map(RELOCATION.match, lines[number + 1:number + 2])):
                _add_call(functions[name], name, mnemonic, operands, known)
    return functions


def _note_registers(known, mnemonic, text, literals):
    """What registers hold that matters: a function of a literal, or an address to return to."""
    if load := LITERAL_LOAD.match(text) if mnemonic.startswith("ldr") else None:
        known[load[1]] = literals.get(int(load[2], 16))
    elif mnemonic.startswith("pop"):
        for register in re.findall(r"r\d+", text):
            known[register] = RETURN
    elif mnemonic not in ("bx", "blx"):
        known.pop(text.split(",")[0], None)


RETURN = object()


def _add_call(function, name, mnemonic, operands, known):
    """Counts an instruction if it is a call. A jump to a function's own start is a loop."""
    target = TARGET.search(operands)
    if mnemonic in ("blx", "bx") and not target and operands not in ("lr", "ip", "pc"):
        if isinstance(known.get(operands), str):
            function.calls.add(known[operands])
            function.resolved.add(known[operands])
        elif known.get(operands) is not RETURN:
            function.indirect += 1
    elif mnemonic == "blx" and not target:
        function.indirect += 1
    elif BRANCH.match(mnemonic) and target and (target[1] != name or mnemonic == "bl"):
        function.calls.add(target[1])


def disassemble(file, cross):
    """Functions of a program or of a library."""
    return parse_disassembly(run([f"{cross}objdump", "-d", "-r", str(file)]))


def read_usage(*folders):
    """Frame sizes by function from the .su files under folders; the larger of two of one name."""
    usage = {}
    for file in (file for folder in folders for file in pathlib.Path(folder).rglob("*.su")):
        for line in file.read_text(encoding="utf-8").splitlines():
            place, size, _ = line.split("\t")
            name = place.rsplit(":", 1)[1]
            usage[name] = max(usage.get(name, 0), int(size))
    return usage


@dataclasses.dataclass
class Depth:
    """The deepest way down from a function."""
    size: int
    path: list


def addresses_taken(file, cross):
    """Functions of which a literal, a table or an instruction holds the address: by relocations in a
    library, by words in a program."""
    names = {name.split("+")[0].removeprefix(".text.") for name in ADDRESS.findall(run([f"{cross}objdump", "-r",
                                                                                      str(file)]))}
    with reading.open_file(file) as handle:
        if handle.read(4) != b"\x7fELF":
            return names
        elf = ELFFile(handle)
        functions = {symbol["st_value"] | 1: symbol.name for symbol in elf.get_section_by_name(".symtab").iter_symbols()
                     if symbol["st_info"]["type"] == "STT_FUNC"}
        for section in elf.iter_sections():
            if section["sh_flags"] & SHF_ALLOC and section["sh_type"] != "SHT_NOBITS":
                data = section.data()
                words = struct.unpack(f"<{len(data) // 4}I", data[:len(data) // 4 * 4])
                names.update(functions[word] for word in words if word in functions)
    return names


class Graph:
    """Stack depth over a graph of calls. entries are called from outside only, never by pointer; taken are
    the functions whose address is taken, which may be called by pointer too."""

    def __init__(self, functions, usage, is_entry, taken=()):
        self.functions = functions
        self.usage = usage
        self.recursive = set()
        self.known = {}
        roots, resolved = set(self.roots()), {name for each in functions.values() for name in each.resolved}
        self.pointed = [name for name in functions if name in taken and name not in resolved or
                        name in roots and not is_entry(name)]
        self.deepest_pointed = Depth(0, [])
        self.deepest_pointed = max(map(self.depth, self.pointed), key=lambda depth: depth.size,
                                   default=Depth(0, []))
        self.known = {}

    def frame(self, name):
        """Bytes of one function's frame. The compiler may split or clone a function (name.part.0)."""
        stated = self.usage.get(name, self.usage.get(name.split(".")[0], 0))
        return max(stated, self.functions[name].frame)

    def depth(self, name, above=()):
        """The deepest way from a function; a call back to one above it is noted and cut there."""
        if name in self.known:
            return self.known[name]
        if name in above:
            self.recursive.add(name)
            return Depth(0, [])
        if name not in self.functions:
            return Depth(0, [])     # another's: the firmware's memcpy, seen from the library
        ways = [self.depth(callee, (*above, name)) for callee in sorted(self.functions[name].calls)]
        if self.functions[name].indirect:
            ways.append(self.deepest_pointed)
        deepest = max(ways, key=lambda depth: depth.size, default=Depth(0, []))
        result = Depth(self.frame(name) + deepest.size, [name, *deepest.path])
        self.known[name] = result
        return result

    def roots(self):
        """Functions that nobody calls by name."""
        called = {callee for function in self.functions.values() for callee in function.calls}
        return [name for name in self.functions if name not in called]

    def unbounded(self):
        """Functions that may deepen the stack beyond what is counted."""
        behind = {each for name in self.pointed for each in self.indirect(name)}
        return sorted(self.recursive | behind)

    def reach(self, name):
        """Every function that can run below one."""
        seen, todo = set(), [name]
        while todo:
            current = todo.pop()
            if current in self.functions and current not in seen:
                seen.add(current)
                todo += self.functions[current].calls
        return seen

    def indirect(self, name):
        """Functions below one that call through a pointer."""
        return sorted(each for each in self.reach(name) if self.functions[each].indirect)
