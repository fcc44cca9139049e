# SPDX-License-Identifier: MIT
"""Runs the benchmark for real boards on the host or on an emulated board, and writes the file that the real one takes."""

import argparse
import pathlib
import re
import sys

from fixel.base import limits
from fixel.base.errors import ToolError, one_line
from fixel.board import rp2040, uf2
from fixel.commands import late

emulator, execute, firmware = late("fixel.board", "emulator execute firmware")

CPU = 300.0     # seconds
LINE = re.compile(r"^FIXEL,(?P<board>[^,\n]+),(?P<clock>\d+),(?P<scene>\w+),(?P<microseconds>\d+),(?P<crc>[0-9a-f]{8})$", re.MULTILINE)
END = "FIXEL,end"


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    made.add_argument("--board", required=True, help="the board of the program")
    made.add_argument("--elf", required=True, help="the program, firmware/benchmark")
    made.add_argument("--uf2", help="the UF2 file to write, for a board that takes one")
    return made


def run(elf, board):
    """What the program prints."""
    elf = pathlib.Path(elf).resolve()
    try:
        if board == firmware.HOST:
            done = limits.run([str(elf)], CPU, merge=True, text=True)
            code, text, agreed = done.returncode, done.stdout, 0
        else:
            done = emulator.run_text(elf, ["benchmark"], CPU)
            code, text, agreed = done.code, done.output, emulator.exit_code("DONE")
    except limits.LimitError as error:
        raise ToolError(f"the benchmark: {error}", 1, error.output) from error
    if code != agreed or END not in text.splitlines() or not LINE.search(text):
        raise ToolError("the benchmark did not end as it should", 1, execute.last_lines(text))
    return text


def write_uf2(elf, file):
    """Writes the program alone as a UF2 file: how many blocks it has; None for a board that takes none."""
    program = firmware.load(elf)
    return uf2.write(program, rp2040.image_of(program), file) if program.uf2 else None


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    text = run(options.elf, options.board)
    print("\n".join(match[0] for match in LINE.finditer(text)))
    if options.board == firmware.HOST:
        return 0
    print(f"  {firmware.load(options.elf).emulator} counted these microseconds: no result of a real board (docs/results.md)", file=sys.stderr)
    blocks = write_uf2(options.elf, pathlib.Path(options.uf2)) if options.uf2 else None
    if blocks:
        print(f"{blocks} blocks of UF2 for the real board: {one_line(options.uf2)}")
    return 0
