# SPDX-License-Identifier: MIT
"""Saves a picture of an emulated board's screen after the last frame."""

import argparse
import pathlib

from fixel import commands
from fixel.board import methods
from fixel.scene import scene_options


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    scene_options.add_board(made)
    scene_options.add(made)
    methods.add_options(made)
    made.add_argument("--device", help="a display to add to the board, in the words of QEMU's -device")
    made.add_argument("--out", required=True, type=pathlib.Path, help="the picture (.png)")
    made.add_argument("--build", default="build", help="folder that make builds in")
    made.add_argument("--timeout", type=float, default=120.0, help="limit of the drawing time in seconds (120)")
    return made


main = commands.main_of(parser, "fixel.board.screenshot")
