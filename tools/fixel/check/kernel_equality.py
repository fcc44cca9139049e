# SPDX-License-Identifier: MIT
"""Each kernel of a core beside the portable one, on the emulated core."""

import concurrent.futures
import hashlib
import json
import pathlib
import re
import threading
import time

from fixel.board import ending as endings
from fixel.base import output, scratch
from fixel.board import emulator, firmware, qemu
from fixel.base.errors import ToolError

TIMEOUT = 3600.0    # seconds of CPU time for a kernel
THOUSANDS_MAX = 1000000
KERNEL_SHIFT = 20   # as in firmware/equality/main.c
LINE = re.compile(r"^equality: (\S+) (\d+)\nequality: differences (\d+)$", re.MULTILINE)
NAME = re.compile(r"^equality: kernel (\S+)$", re.MULTILINE)
MARKER = re.compile(r"^equality: done$", re.MULTILINE)


def execute(elf, number, timeout):
    """What a program prints that is asked for frames=number."""
    program = firmware.load(elf)
    options = [*qemu.semihosting(["equality", f"frames={number}"]), "-kernel", str(program.path.resolve())]
    with scratch.folder("equality") as folder:
        ending = emulator.emulate(program, options, folder, timeout)
    wrong = any(int(each[2]) for each in LINE.findall(ending.output))
    if ending.code != endings.exit_code("TEST" if wrong else "DONE") or not MARKER.search(ending.output):
        raise ToolError(f"{elf}: {endings.describe(ending)}", exit_code=1, words=ending.output)
    return ending.output


def kernels(elf):
    """The names of a program's kernels, in its order."""
    names = NAME.findall(execute(elf, 0, TIMEOUT))
    if not names:
        raise ToolError(f"{elf} names no kernel")
    return names


def compare(elf, thousands, kernel=0, timeout=TIMEOUT):
    """[(name, cases, differences)] of one kernel, counted from 1, or of all of them."""
    done = LINE.findall(execute(elf, kernel << KERNEL_SHIFT | thousands, timeout))
    if not done:
        raise ToolError(f"{elf} compared nothing")
    return [(name, int(cases), int(wrong)) for name, cases, wrong in done]


def first_difference(elf, thousands, timeout):
    """None if no kernel of a core differs, else words that say which does."""
    try:
        wrong = [name for name, _, wrong in compare(elf, thousands, timeout=timeout) if wrong]
    except ToolError as error:
        return str(error)
    return f"{wrong[0]} differs" if wrong else None


class Journal:
    """What was compared: rows of core, kernel, thousands, inputs, differ, seconds, program."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.lock = threading.Lock()
        try:
            self.rows = json.loads(self.path.read_text(encoding="utf-8"))["rows"]
        except (OSError, ValueError, KeyError, TypeError):
            self.rows = []

    def find(self, core, kernel, program, thousands):
        return next((row for row in self.rows if (row["core"], row["kernel"], row["program"]) ==
                     (core, kernel, program) and row["thousands"] >= thousands), None)

    def keep(self, row):
        with self.lock:
            self.rows = [each for each in self.rows
                         if (each["core"], each["kernel"]) != (row["core"], row["kernel"])] + [row]
            self.rows.sort(key=lambda each: (each["core"], each["kernel"]))
            output.write_file(self.path, json.dumps({"rows": self.rows}, indent=1) + "\n")
            print_row(row)

    def show(self, row):
        with self.lock:
            print_row(row, "  (before)")


def print_row(row, note=""):
    print(f"{row['core']:9} {row['kernel']:14} {row['inputs']:12,} inputs  {row['differ']:,} differ"
          f"  {row['seconds']:6.1f} s{note}", flush=True)


def work(job, thousands, journal):
    """A kernel's row, compared or from the journal."""
    elf, program, number, kernel = job
    core = pathlib.Path(elf).stem
    row = journal.find(core, kernel, program, thousands)
    if row is not None:
        journal.show(row)
        return row
    begin = time.monotonic()
    [(_, inputs, differ)] = compare(elf, thousands, number)
    row = {"core": core, "kernel": kernel, "thousands": thousands, "inputs": inputs, "differ": differ,
           "seconds": round(time.monotonic() - begin, 1), "program": program}
    journal.keep(row)
    return row


def jobs_of(elf):
    names = kernels(elf)
    program = hashlib.sha256(pathlib.Path(elf).read_bytes()).hexdigest()[:16]
    return [(elf, program, number, name) for number, name in enumerate(names, 1)]


def command(options):
    """The command; its exit code."""
    if not 1 <= options.thousands <= THOUSANDS_MAX:
        raise ToolError(f"--thousands is 1 to {THOUSANDS_MAX:,}")
    if options.jobs < 1:
        raise ToolError("--jobs is 1 or more")
    jobs = [job for elf in options.elf for job in jobs_of(elf)]
    journal = Journal(options.journal or pathlib.Path(options.elf[0]).parent / "equality.json")
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        rows = list(pool.map(lambda job: work(job, options.thousands, journal), jobs))
    if options.keep:
        kept = [{key: row[key] for key in ("core", "kernel", "inputs", "differ")} for row in rows]
        output.write_json(options.keep, {"rows": kept})
    inputs, wrong = (sum(row[key] for row in rows) for key in ("inputs", "differ"))
    print(f"{inputs:,} inputs of {len(rows)} kernels in {len(options.elf)} programs, {wrong:,} differ")
    return 1 if wrong else 0
