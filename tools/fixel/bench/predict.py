# SPDX-License-Identifier: MIT
"""Predicts flash, RAM, stack and instructions a frame of a scene on a board, before anything is built for the board.

Exit: 0 the board has room for the scene, 1 it has not, 2 there is no prediction.
"""

import argparse

from fixel.base import bounded


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--board", required=True)
    made.add_argument("--core", default="", help="the compiler's flags for the board's core")
    made.add_argument("--scene", required=True, help="a .toml, a model (.obj, .gltf, .glb, .stl), or a scene image (.fxls)")
    for name, what in (("band", "bytes of a band"), ("order", "entries of the order"), ("list", "bytes of the display list"),
                       ("cache", "entries of the vertex cache")):
        made.add_argument(f"--{name}", type=int, required=True, help=what)
    made.add_argument("--list-most", type=int, default=0, help="bytes that limit the display list alone")
    made.add_argument("--without-surfaces", action="store_true", help="the board's program draws none")
    made.add_argument("--frames", help="number of frames (default: the whole path)")
    made.add_argument("--screen", help="width and height, like 128x64 (default: the scene's)")
    bounded.add_options(made)
    made.add_argument("--json", help="write the prediction to this file too; - for the terminal, and nothing else")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


def main(argv):
    options = parser().parse_args(argv)
    from fixel.bench import prediction
    return prediction.command(options)
