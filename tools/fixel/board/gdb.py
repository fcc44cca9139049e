# SPDX-License-Identifier: MIT
"""Opens a debugger on a board's program, powered on from its flash image and stopped at main."""

import argparse

from fixel.base import reading
from fixel.board import boot
from fixel.board.boot import positive


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    made.add_argument("--board", required=True, help="the board of the image and the program")
    made.add_argument("--image", required=True, help="the flash image")
    made.add_argument("--elf", required=True, help="the program that the image holds")
    made.add_argument("--frames", type=positive, help="number of frames (default: the whole path)")
    made.add_argument("--commands", help="a file of GDB commands (default: GDB asks for them)")
    return made


def before(options):
    """Refuses a file of commands that is not there, and a board without a flash image."""
    if options.commands:
        reading.open_regular(options.commands)[0].close()
    boot.before(options)


def main(argv):
    options = parser().parse_args(argv)
    from fixel.board import debugger
    return debugger.debug(options.board, options.elf, options.image, options.frames, options.commands)
