# SPDX-License-Identifier: MIT
"""Records the live window for the README: a walk through the plaza, by keys, in a headless browser."""

import argparse
import pathlib

from fixel import commands


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    made.add_argument("--board", required=True)
    made.add_argument("--scene", required=True)
    made.add_argument("--build", default="build", help="folder that make builds in")
    made.add_argument("--out", type=pathlib.Path, required=True, help="the recording, a GIF")
    return made


main = commands.main_of(parser, "fixel.view.recording")
