# SPDX-License-Identifier: MIT
"""Compares two sets of frames: PNGs, folders of PNGs, or frame dumps, in any combination.

Exit: 0 equal, 1 different, 2 cannot be compared.
"""

import argparse
import os

from fixel import commands
from fixel.base import reading
from fixel.base.errors import ToolError

SIDE_MAX = 4096         # pixels
PIXELS_MAX = 1 << 23    # of a PNG: two of them, and what is made of them, take less than 200 MB and 2 s


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=f"{__doc__.splitlines()[0]} A PNG may have at most 8 bits a channel, "
                                   f"{SIDE_MAX:,} pixels a side and {PIXELS_MAX:,} together.")
    made.add_argument("--a", default="", help="a PNG, a folder of PNGs, or a frame dump (A=)")
    made.add_argument("--b", default="", help="the other: a PNG, a folder of PNGs, or a frame dump (B=)")
    made.add_argument("--tolerance", default="0",
                      help="largest difference of a colour channel that counts as equal")
    made.add_argument("--out", help="folder for compare.json and the pictures")
    made.add_argument("--json", action="store_true", help="JSON instead of the table")
    return made


def tolerance_of(text):
    """0..255 from a command line."""
    if not (len(text) <= 3 and text.isascii() and text.isdigit() and int(text) <= 255):
        raise ToolError(f"TOLERANCE is '{reading.shortened(text)}'; it must be a whole number from 0 to 255")
    return int(text)


def before(options):
    """Refuses one picture, and names at which there is nothing."""
    for name in ("a", "b"):
        path = getattr(options, name)
        if not path:
            raise ToolError(f"{name.upper()}= is missing: make compare A=... B=... takes two PNGs, folders of PNGs, or frame dumps")
        if not os.path.exists(path):
            raise ToolError(f"{path}: there is no such file or folder")
    tolerance_of(options.tolerance)


main = commands.main_of(parser, "fixel.report.comparison")
