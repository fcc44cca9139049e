# SPDX-License-Identifier: MIT
"""A static bound of stack depth: frame sizes and the graph of calls, from machine code.

Frame sizes come from the compiler (-fstack-usage, .su files) where it wrote
them, else from the instructions that move the stack pointer (libgcc's
assembly). Calls come from the disassembly. A call through a pointer counts as
one of the deepest function that nobody calls by name. Recursion, and a pointer
behind a pointer, have no bound here and are reported.
"""

import dataclasses
import pathlib
import re
import subprocess

from fixel.errors import ToolError

HEADER = re.compile(r"^[0-9a-f]+ <([^>]+)>:$")
INSTRUCTION = re.compile(r"^\s*[0-9a-f]+:\t[0-9a-f ]+\t(\S+)(?:\t(.*))?$")
RELOCATION = re.compile(r"^\s*[0-9a-f]+: R_ARM_(?:THM_)?(?:CALL|JUMP\d+|PC22|PC11)\s+(\S+)")
TARGET = re.compile(r"<([^>+]+)>")
BRANCH = re.compile(r"^(bl|b|b\.[nw]|b(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)(\.[nw])?|cbn?z)$")


@dataclasses.dataclass
class Function:
    """What the machine code of a function says."""
    frame: int = 0                                      # bytes
    calls: set = dataclasses.field(default_factory=set)
    indirect: int = 0                                   # calls through a register


def run(command):
    """Output of a binutils program."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
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
    functions, name, depth = {}, None, 0
    lines = text.splitlines()
    for number, line in enumerate(lines):
        if header := HEADER.match(line):
            name, depth = header[1], 0
            functions.setdefault(name, Function())
        elif name and (moved := RELOCATION.match(line)):
            functions[name].calls.add(moved[1].removeprefix(".text."))
        elif name and (instruction := INSTRUCTION.match(line)):
            mnemonic, operands = instruction[1], re.split("[;@]", instruction[2] or "")[0].strip()
            depth += stack_bytes(mnemonic, operands)
            functions[name].frame = max(functions[name].frame, depth)
            # Of an instruction that is still to be relocated, only the relocation knows the target.
            if not any(map(RELOCATION.match, lines[number + 1:number + 2])):
                _add_call(functions[name], name, mnemonic, operands)
    return functions


def _add_call(function, name, mnemonic, operands):
    """Counts an instruction if it is a call. A jump to a function's own start is a loop."""
    target = TARGET.search(operands)
    if mnemonic == "blx" and not target:
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


class Graph:
    """Stack depth over a graph of calls. entries are called from outside only, never by pointer."""

    def __init__(self, functions, usage, is_entry):
        self.functions = functions
        self.usage = usage
        self.recursive = set()
        self.known = {}
        self.pointed = [name for name in self.roots() if not is_entry(name)]
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
