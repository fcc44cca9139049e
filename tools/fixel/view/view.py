# SPDX-License-Identifier: MIT
"""Starts a board and shows its frames live on a web page of this machine.

Keys go from the page to the firmware; the page shows the frame of the reference renderer beside it.
Ctrl-C ends everything. Exit: 0 after Ctrl-C, 2 the board could not be started; else the board ended by
itself, with the exit code of its program.
"""

import argparse

from fixel import commands
from fixel.board import methods
from fixel.scene import scene_options


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    scene_options.add_board(made)
    scene_options.add(made, frames=False)
    methods.add_options(made)
    made.add_argument("--port", help="port on 127.0.0.1 (default: 8065, or a free one)")
    made.add_argument("--open", action="store_true", help="open the page in this machine's browser")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


main = commands.main_of(parser, "fixel.view.live")
