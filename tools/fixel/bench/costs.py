# SPDX-License-Identifier: MIT
"""Renews bench/costs.json: what a frame costs on the cores given, and what the walk takes on the boards given.

Counts what the library does in scenes of the bench and in some of its own, and the instructions that programs of the bench
execute for them, with the memory of a large board down to that of a small one. Fits a cost for each count. Exit: 0 done,
1 a program failed.
"""

import argparse

from fixel import commands
from fixel.base.arguments import number


def setting(text):
    """("SMALL", (8, 1024, 8, 0)) of "SMALL=8:1024:8:0"."""
    name, _, numbers = text.partition("=")
    return name, tuple(map(int, numbers.split(":")))


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--cores", nargs="*", default=[], help="others stay as they are in the file")
    made.add_argument("--sizes", nargs="+", type=setting, metavar="NAME=ROWS:WORDS:ENTRIES:MORE",
                      help="of the cores' programs: rows of a band, words of the list, entries of the cache, and how many more "
                           "entries of the order than a scene needs")
    made.add_argument("--only-new", action="store_true", help="find the costs that the file lacks, by the scenes that have some; "
                                                                 "those that it has stay")
    made.add_argument("--frames", type=number("FRAMES", 1, 1_000_000), default=30, help="of each scene, at most (30)")
    made.add_argument("--boards", nargs="*", default=[], help="others stay as they are in the file")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


main = commands.main_of(parser, "fixel.bench.costs_renewal")
