# SPDX-License-Identifier: MIT
"""Compares each core's kernels with the portable ones, on the emulated core itself.

A program has both kernels, gives them the same boundary inputs and random inputs, and counts the
differences. The tool prints a line for each kernel. Exit: 0 all kernels are equal, 1 a kernel differs.
A journal beside the programs keeps what is done: the tool skips a kernel that the same program has
already compared with as many inputs.
"""

import argparse
import os

from fixel import commands


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("elf", nargs="+", help="the program of a core")
    made.add_argument("--thousands", type=int, default=10000, help="random inputs for each kernel, in thousands")
    made.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="kernels at a time")
    made.add_argument("--keep", metavar="FILE", help="write the result, for the report of make bench")
    made.add_argument("--journal", help="the journal (default: equality.json beside the first program)")
    return made


main = commands.main_of(parser, "fixel.check.kernel_equality")
