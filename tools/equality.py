# SPDX-License-Identifier: MIT
"""Compares each core's kernels with the portable ones, on the emulated core itself.

A program holds both, feeds them all boundary inputs and so many random ones, and counts where
they differ. Prints a line for each kernel as it ends; exit 1 where any differed.
"""

import argparse
import concurrent.futures
import os
import pathlib
import re
import tempfile
import threading

from fixel import ending as endings
from fixel import emulator, firmware, qemu
from fixel.errors import ToolError, run_main

TIMEOUT = 600.0     # seconds without a kernel's end
LINE = re.compile(r"^equality: (\S+) (\d+)\nequality: differences (\d+)$", re.MULTILINE)
MARKER = re.compile(r"^equality: done$", re.MULTILINE)
PRINTING = threading.Lock()


def results(text):
    """[(kernel, cases, differences)] of what a program has printed so far."""
    return [(name, int(cases), int(wrong)) for name, cases, wrong in LINE.findall(text)]


def run(elf, thousands):
    """All kernels of a core: [(kernel, cases, differences)]; a ToolError where the program failed."""
    core = pathlib.Path(elf).stem
    program = firmware.load(elf)
    options = [*qemu.semihosting(["equality", f"frames={thousands}"]),
               "-kernel", str(program.path.resolve())]
    shown = 0

    with tempfile.TemporaryDirectory(prefix="fixel-equality-") as folder:
        log = pathlib.Path(folder) / "output.txt"

        def watch():
            nonlocal shown
            done = results(log.read_text(encoding="utf-8", errors="replace"))
            for name, cases, wrong in done[shown:]:
                show(core, name, cases, wrong)
            shown = len(done)
            return shown, None

        ending = emulator.emulate(program, options, folder, TIMEOUT, watch)
    done = results(ending.output)
    for name, cases, wrong in done[shown:]:
        show(core, name, cases, wrong)
    wrong = any(each[2] for each in done)
    if ending.code != endings.exit_code("TEST" if wrong else "DONE") or not MARKER.search(ending.output) or not done:
        raise ToolError(f"{elf}: {endings.describe(ending)}\n{ending.output}", exit_code=1)
    return done


def show(core, name, cases, wrong):
    with PRINTING:
        print(f"{core:5} {name:16} {cases:12,} inputs  {wrong:,} differ", flush=True)


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("elf", nargs="+", help="a core's program")
    parser.add_argument("--thousands", type=int, default=10000, help="random inputs for each kernel, in thousands")
    options = parser.parse_args(argv)
    if not 1 <= options.thousands <= 1000000:
        raise ToolError("--thousands is 1 to 1,000,000")
    with concurrent.futures.ThreadPoolExecutor(min(len(options.elf), os.cpu_count() or 1)) as pool:
        done = list(pool.map(lambda elf: run(elf, options.thousands), options.elf))
    cases = sum(each[1] for core in done for each in core)
    wrong = sum(each[2] for core in done for each in core)
    print(f"{cases:,} inputs on {len(done)} cores, {wrong:,} differ")
    return 1 if wrong else 0


if __name__ == "__main__":
    run_main(main)
