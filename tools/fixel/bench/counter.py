# SPDX-License-Identifier: MIT
"""Runs a program of the bench under QEMU with the counting plugin (bench/plugin), and reads what it counted."""

import collections
import dataclasses
import functools
import pathlib

from fixel.bench import machine_code, thumb
from fixel.board import emulator, firmware, qemu
from fixel.board.execute import describe, exit_code, exit_status, last_lines
from fixel.base.errors import ToolError

BEGIN, END = "bench_begin", "bench_end"     # the marker functions
MAP, COUNTS = "program.map", "counts.txt"
MARKER_CALL = 1     # instructions: the call of the end marker, the last one in a region


@dataclasses.dataclass
class Counts:
    """Instructions of every region in the order in which they ended; with detail also where.

    nodes: {id: (parent, function number, where the call comes back to)}, 0 being the root; blocks: {id: (address, sizes)};
    visits: [(node, block, times, times left)].
    """
    regions: list = dataclasses.field(default_factory=list)
    nodes: dict = dataclasses.field(default_factory=dict)
    blocks: dict = dataclasses.field(default_factory=dict)
    visits: list = dataclasses.field(default_factory=list)


@functools.lru_cache(machine_code.READ_ONCE)
def map_text(code, markers=(BEGIN, END)):
    """What the plugin wants to know about a program."""
    lines = [f"{word} {code.symbol(name):x}" for word, name in zip(("begin", "end"), markers)]
    lines += [f"function {function.start:x} {function.end:x}" for function in code.functions]
    for address, instruction in code.each_instruction():
        if instruction.kind in thumb.CALLS:
            lines.append(f"call {address + instruction.size:x}")
        elif instruction.kind in thumb.RETURNS:
            lines.append(f"return {address + instruction.size:x}")
    return "\n".join(lines) + "\n"


def parse(text):
    """The plugin's file."""
    counts = Counts()
    done = None
    for line in text.splitlines():
        word, *fields = line.split()
        if word == "region":
            counts.regions.append(int(fields[0]))
        elif word == "node":
            counts.nodes[int(fields[0])] = (int(fields[1]), int(fields[2]), int(fields[3], 16))
        elif word == "block":
            counts.blocks[int(fields[0])] = (int(fields[1], 16), [int(digit) for digit in fields[2]])
        elif word == "visit":
            counts.visits.append(tuple(map(int, fields)))
        elif word == "done":
            done = int(fields[0])
    if done != len(counts.regions):
        raise ToolError("the counting plugin's file is not whole", exit_code=1)
    return counts


def run(elf, code, plugin, directory, scene=None, frames=None, detail=False, timeout=120.0, markers=(BEGIN, END)):
    """Runs a program in a directory, where its files stay; (its output, Counts).

    scene: a scene image for the board's partition. timeout: seconds without a sign of life, which
    is the growth of the frame dump where there is one. markers: the functions about a region.
    """
    program = firmware.load(elf)
    directory = pathlib.Path(directory)
    if not pathlib.Path(plugin).exists():
        raise ToolError(f"{plugin} is not built: make bench builds it")
    (directory / MAP).write_text(map_text(code, markers), encoding="ascii")
    words = ["bench"] + ([f"frames={frames}"] if frames else [])
    options = ["-icount", "shift=0", *qemu.semihosting(words),
               "-plugin", f"{qemu.escape(pathlib.Path(plugin).resolve())},map={MAP},out={COUNTS}"
               + (",detail=on" if detail else ""),
               "-kernel", str(pathlib.Path(elf).resolve())]
    if scene is not None:
        options += qemu.scene_loader(program, scene)
    ending = emulator.emulate(program, options, directory, timeout, _alive(directory))
    if ending.code != exit_code("DONE"):
        raise ToolError(f"{elf}: {describe(ending)}", exit_status(ending), last_lines(ending.output))
    try:
        return ending.output, read(directory)
    except OSError as error:
        raise ToolError(f"{elf}: the counting plugin left no counts", exit_code=1,
                        words=last_lines(ending.output)) from error


def read(directory):
    """The Counts of a program that has run in a directory."""
    counts = parse((pathlib.Path(directory) / COUNTS).read_text(encoding="ascii"))
    counts.regions = [instructions - MARKER_CALL for instructions in counts.regions]
    return counts


def _alive(directory):
    """A watch for emulator.execute: news is how much the program has written."""
    def watch():
        sizes = [file.stat().st_size for file in directory.glob(emulator.DUMP_NAME + "*")]
        return sum(sizes), None
    return watch


def by_address(counts):
    """{address: (times executed, times left)}: left, of a block's last instruction, says how often
    what ran next was not the instruction behind it."""
    times, left = collections.Counter(), collections.Counter()
    for _, block, count, away in counts.visits:
        address, sizes = counts.blocks[block]
        for size in sizes:
            times[address] += count
            last = address
            address += size
        left[last] += away
    return {address: (times[address], left[address]) for address in sorted(times)}
