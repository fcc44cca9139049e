# SPDX-License-Identifier: MIT
"""Draws a scene's path on a board, and compares the frames with the host's and with double.

Exit: 0 the board's frames equal the host's byte for byte, and every pixel that differs from double is
explained; 1 not; 2 the run could not be made; 124 the program hung; 134 the core locked up; else the code
of the program that failed (boards/contract/system.h).
"""

import argparse

from fixel import commands
from fixel.base import kept
from fixel.board import methods
from fixel.scene import scene_options


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    scene_options.add_board(made)
    scene_options.add(made)
    methods.add_options(made)
    made.add_argument("--whole-frames", action="store_true", help="with --board host: draw whole frames, not in its narrow bands")
    made.add_argument("--band-rows", type=int, help="the most rows of a band that the program was built with (default: what fits)")
    made.add_argument("--driver", help="a driver of a display, whose wires are recorded and read back")
    made.add_argument("--out", default="build/run", help="folder for the results")
    made.add_argument("--build", default="build", help="folder that make builds in")
    kept.add_option(made)
    return made


main = commands.main_of(parser, "fixel.board.judged_run")
