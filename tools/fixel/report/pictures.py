# SPDX-License-Identifier: MIT
"""Makes a picture of a document: frames of `make run` or `make wire`, or of frame dumps, side by side."""

import argparse
import pathlib

from fixel import commands

FRAMES = "30,45,105"       # of the plaza


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    source = made.add_mutually_exclusive_group(required=True)
    source.add_argument("--run", type=pathlib.Path, help="folder of make run's frames")
    source.add_argument("--dumps", type=pathlib.Path, nargs="+", help="frame dumps, one for each number")
    made.add_argument("--frames", default=FRAMES, help="numbers of the frames, like 30,45,105")
    made.add_argument("--out", type=pathlib.Path, required=True, help="the picture")
    return made


main = commands.main_of(parser, "fixel.report.picture_row")
