# SPDX-License-Identifier: MIT
"""Compares each core's kernels with the portable ones, on the emulated core itself.

A program has both kernels, gives them the same boundary inputs and random inputs, and counts the
differences. The tool prints a line for each kernel, and writes them to DIR/equality/equality.json. The inputs are
a campaign: shards of a million random inputs. Exit: 0 all kernels are equal, 1 a kernel differs.
"""

import argparse

from fixel import commands
from fixel.base.arguments import whole_number
from fixel.campaign import runner

SHARD = 1000        # thousands of random inputs
SHARD_SHIFT, KERNEL_SHIFT = 10, 26  # as in firmware/equality/main.c
THOUSANDS_MAX = SHARD << KERNEL_SHIFT - SHARD_SHIFT


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("cores", nargs="+", metavar="core", help="a core whose program is built, such as m3 or m0-small")
    made.add_argument("--thousands", default="10000", help="random inputs for each kernel, in thousands (THOUSANDS=)")
    made.add_argument("--build", default="build", help="folder that make builds in")
    made.add_argument("--keep", metavar="FILE", help="write the result there too, for the report of make bench (KEEP=)")
    runner.add_options(made)
    return made


def before(options):
    """The number of thousands; refuses what is none."""
    return whole_number("--thousands", options.thousands, 1, THOUSANDS_MAX)


main = commands.main_of(parser, "fixel.check.kernel_equality")
