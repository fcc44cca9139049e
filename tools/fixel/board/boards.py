# SPDX-License-Identifier: MIT
"""Compares all boards: sizes, stack, speed, and whether their frames equal the host's.

Draws the scenes and runs the unit tests on all boards. The first scene must run on every board, as it asks to be drawn. If
a board has no room for another scene, or for what --pixels, --order and --depth ask for, the table says why. Exit: 0 all frames equal the host's and no unit test failed,
1 not, 2 there was nothing to compare with.
"""

import argparse
import os

from fixel import commands
from fixel.check import units
from fixel.scene import target


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--boards", nargs="+", required=True, help="the boards; the host, which they are compared with, is not one of them")
    made.add_argument("--scene", nargs="+", required=True, help="scenes; the first must run on every board")
    units.add_options(made)
    made.add_argument("--not-run", nargs="+", action="append", default=[], metavar="BOARD", help="a board that is left out, and the packages that it needs")
    made.add_argument("--build", default="build", help="folder that make builds in")
    made.add_argument("--out", default="build/boards.json", help="the JSON file to write")
    target.add_options(made)
    made.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    return made


main = commands.main_of(parser, "fixel.board.all_boards")
