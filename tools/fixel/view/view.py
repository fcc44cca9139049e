# SPDX-License-Identifier: MIT
"""Starts a board and shows its frames live on a web page of this machine.

Keys go from the page to the firmware; the page shows the frame of the reference renderer beside it.
Ctrl-C ends everything. Exit: 0 after Ctrl-C, 2 the board could not be started; else the board ended by
itself, with the exit code of its program.
"""

import argparse

from fixel import commands
from fixel.base.errors import ToolError
from fixel.board import methods
from fixel.scene import scene_options


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    scene_options.add_board(made)
    scene_options.add(made, frames=False)
    methods.add_options(made)
    made.add_argument("--source", help="C file, or folder of C files, of a program of your own, which is --program")
    made.add_argument("--port", help="port on 127.0.0.1 (default: 8065, or a free one)")
    made.add_argument("--open", action="store_true", help="open the page in this machine's browser")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


def port_number(text):
    """A port from a command line."""
    if not (text.isascii() and text.isdigit() and 1 <= int(text) <= 65535):
        raise ToolError(f"PORT is '{text}'; it must be a whole number from 1 to 65535")
    return int(text)


def before(options):
    """Refuses what is no port."""
    if options.port is not None:
        port_number(options.port)


main = commands.main_of(parser, "fixel.view.live")
