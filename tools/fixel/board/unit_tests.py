# SPDX-License-Identifier: MIT
"""Runs a program of Unity tests on its emulated board: firmware/unittest/main.c.

A program has many files of tests and says which one it runs. Where it ends inside a file, by a fault or a failed
assertion, that file has one failure more, and the program runs again from the next file on. Which programs and tests a board has, units.json
says, as firmware/unittest/programs.py linked them.
"""

import dataclasses
import json
import pathlib
import re

from fixel.base.errors import ToolError
from fixel.commands import late

emulator, execute = late("fixel.board", "emulator execute")

MARKER = "unittest: done"
BEGUN = re.compile(r"^unittest: (test_\w+)\n", re.MULTILINE)
STACK = re.compile(r"^stack: \d+ of (\d+) bytes", re.MULTILINE)
ROOMY_STACK = 64 << 10      # the most that a program of tests gets: linker/sections.ld
FILE_CPU = 300.0            # seconds of CPU time for one file


@dataclasses.dataclass(frozen=True)
class File:
    """What a file of tests gave. no_room: why the board has no room for it after all, or None."""
    name: str
    passed: int = 0
    failed: int = 0
    skipped: int = 0
    output: str = ""
    no_room: str | None = None
    cpu: float = 0.0    # seconds of the run that began with this file


def count_unity(text):
    """Passed, failed, skipped as Unity printed them, a line for each test."""
    return tuple(len(re.findall(pattern, text, re.MULTILINE))
                 for pattern in (r":PASS\s*$", r":FAIL\b", r":IGNORE\b"))


def _sections(text):
    """(name, output) of each file that began."""
    parts = BEGUN.split(text)[1:]
    return list(zip(parts[::2], parts[1::2]))


def _stack_is_too_small(ending, output):
    """Why, where the stack overflowed that is smaller than other boards': a need of the tests, which passes there."""
    stack = STACK.search(output)
    if ending.code == execute.exit_code("STACK") and stack and int(stack[1]) < ROOMY_STACK:
        return f"its stack takes more than {stack[1]} bytes"
    return None


def _run_once(elf, word, files):
    """The files that a run began, and whether it got to its end."""
    try:
        ending = emulator.run_text(elf, ["unittest", *([word] if word else [])], FILE_CPU * files, icount=False)
    except ToolError as error:
        return [], f"{error}\n"
    found = []
    for name, output in _sections(ending.output):
        whole = f"unittest: {name} done\n" in output
        no_room = None if whole else _stack_is_too_small(ending, output)
        if not whole:
            output += f"\n{elf}: {execute.describe(ending)}\n"
        passed, failed, skipped = count_unity(output)
        found.append(File(name, 0, 0, 0, output, no_room) if no_room else
                     File(name, passed, failed + (not whole), skipped, output))
    if found:
        found[0] = dataclasses.replace(found[0], cpu=ending.cpu)
    failed = any(file.failed for file in found)
    if MARKER in ending.output.splitlines() and ending.code == execute.exit_code("TEST" if failed else "DONE"):
        return found, None
    return found, f"{ending.output if not found else ''}\n{elf}: {execute.describe(ending)}\n"


def run(elf, names, every=True):
    """A File for each of the names. every: the program has no other files; otherwise they run one by one."""
    if not every:
        return [file for name in names for file in _run(elf, [name], name)]
    return _run(elf, names, None)


def _run(elf, names, word):
    left, files = list(names), []
    while left:
        found, why = _run_once(elf, word, len(left))
        files += [file for file in found if file.name in left]
        left = [name for name in left if name not in {file.name for file in found}]
        if why is None or not found:
            break
        ended_inside = found[-1].no_room or f"unittest: {found[-1].name} done\n" not in found[-1].output
        if not ended_inside:    # all of it ran, and still it did not end as agreed
            files[-1] = dataclasses.replace(files[-1], failed=files[-1].failed + 1, output=files[-1].output + why)
            break
        word = f"after={found[-1].name}"
    return files + [File(name, failed=1, output=why or f"{elf} has no {name}\n") for name in left]


def add_options(parser):
    """--units."""
    parser.add_argument("--units", nargs=2, action="append", default=[], metavar=("BOARD", "FILE"),
                        help="a board and its units.json, which names its programs of unit tests")


def _read(file):
    try:
        return json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ToolError(f"{file}: cannot be read: {error}; run 'make boards-programs'") from error


def of_boards(options):
    """[(board, program, names of its files of tests)] of --units."""
    return [(board, pathlib.Path(file).parent / program, names)
            for board, file in options.units for program, names in _read(file)["programs"].items()]


def left_out(options, board):
    """{name: why} of the files of tests that a board has no room for, as its linker said."""
    return {name: why for other, file in options.units if other == board
            for name, why in _read(file)["left_out"].items()}


def with_reasons(no_room):
    """"test_a (why), ..." of {name: why}."""
    return ", ".join(f"{name} ({why})" for name, why in sorted(no_room.items()))
