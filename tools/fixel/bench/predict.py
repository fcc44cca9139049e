# SPDX-License-Identifier: MIT
"""Predicts flash, RAM, stack and instructions a frame of a scene on a board, before anything is built for the board.

Exit: 0 the board has room for the scene, 1 it has not, 2 there is no prediction.
"""

import argparse

from fixel import commands
from fixel.scene import scene_options


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--board", required=True)
    made.add_argument("--core", default="", help="the compiler's flags for the board's core")
    scene_options.add(made, targets=False)
    for name, what in (("band", "bytes of a band"), ("order", "entries of the order"), ("list", "bytes of the display list"),
                       ("cache", "entries of the vertex cache")):
        made.add_argument(f"--{name}", type=int, required=True, help=what)
    made.add_argument("--list-most", type=int, default=0, help="bytes that limit the display list alone")
    made.add_argument("--without", default="", metavar="NAME,...",
                      help="what the board's program leaves out: surfaces, depth, billboards")
    made.add_argument("--json", help="write the prediction to this file too; - for the terminal, and nothing else")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


main = commands.main_of(parser, "fixel.bench.prediction")
