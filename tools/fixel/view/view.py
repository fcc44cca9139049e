# SPDX-License-Identifier: MIT
"""Starts a board and shows its frames live on a web page of this machine.

Keys go from the page to the firmware; the page shows the frame of the reference renderer beside it.
Ctrl-C ends everything. Exit: 0 after Ctrl-C, 2 the board could not be started; else the board ended by
itself, with the exit code of its program.
"""

import argparse

from fixel.board import methods
from fixel.base import bounded


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--board", required=True)
    made.add_argument("--scene", required=True, help="a .toml, a model (.obj, .gltf, .glb, .stl), or a scene image (.fxls)")
    made.add_argument("--screen", help="width and height, like 128x64 (default: the scene's)")
    bounded.add_options(made)
    methods.add_options(made)
    made.add_argument("--port", help="port on 127.0.0.1 (default: 8065, or a free one)")
    made.add_argument("--open", action="store_true", help="open the page in this machine's browser")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


def main(argv):
    options = parser().parse_args(argv)
    from fixel.view import live
    return live.command(options)
