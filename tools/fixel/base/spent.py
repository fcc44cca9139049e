# SPDX-License-Identifier: MIT
"""The CPU time of a command of make: what make, its set-up, its compilers and this tool took, as the goals of the project
count it. Waiting, and what other programs take meanwhile, is no part of it."""

import os
import pathlib
import sys

SHELLS = ("sh", "dash", "bash")     # between make and what it starts
TICKS = os.sysconf("SC_CLK_TCK")


def _process(number):
    """A process's name, the number of the one that started it, its CPU seconds and those of its ended children."""
    name, _, rest = pathlib.Path(f"/proc/{number}/stat").read_text(encoding="utf-8", errors="replace").rpartition(")")
    fields = rest.split()
    return name.partition("(")[2], int(fields[1]), sum(map(int, fields[11:15])) / TICKS


def seconds():
    """CPU seconds of this process, its ended children, and of the make that started it with all that it ran so far."""
    total, waiting, number = sum(os.times()[:4]), 0.0, os.getppid()
    try:
        while number > 1:
            name, number, taken = _process(number)
            waiting += taken
            if name == "make":
                total, waiting = total + waiting, 0.0
            elif name not in SHELLS:
                break
    except OSError:
        pass    # a system without /proc: only what this process knows
    return total


def tell():
    """Says it, at the end of a command of make."""
    if "MAKELEVEL" in os.environ:
        print(f"{seconds():.1f} s of CPU", file=sys.stderr)
