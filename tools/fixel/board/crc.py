# SPDX-License-Identifier: MIT
"""Prints the CRC-32 of each frame of a frame dump: "frame" of what was drawn, "sent" of what a display got.

With --wires and --driver, the record of the display's wires says what the display got. Exit: 0 printed, 2 a file cannot be read,
1 the wires are not those of the dump's frames.
"""

import argparse

from fixel import commands


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("dump", help="a frame dump, as make run leaves it: build/run/board.fxld")
    made.add_argument("--wires", help="the record of a display's wires, wires.bin")
    made.add_argument("--driver", help="the driver that sent them, as DRIVER= names it")
    made.add_argument("--json", action="store_true", help="JSON instead of the lines")
    return made


main = commands.main_of(parser, "fixel.board.crc_lines")
