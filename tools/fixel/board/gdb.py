# SPDX-License-Identifier: MIT
"""Opens a debugger on a board's program, powered on from its flash image and stopped at main."""

import argparse

from fixel.board.boot import positive
from fixel.board.debugger import debug


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--board", required=True, help="the board of the image and the program")
    parser.add_argument("--image", required=True, help="the flash image")
    parser.add_argument("--elf", required=True, help="the program that the image holds")
    parser.add_argument("--frames", type=positive, help="number of frames (default: the whole path)")
    parser.add_argument("--commands", help="a file of GDB commands (default: GDB asks for them)")
    options = parser.parse_args(argv)
    return debug(options.board, options.elf, options.image, options.frames, options.commands)
