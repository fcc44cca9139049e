# SPDX-License-Identifier: MIT
"""Draws a scene's path as wireframes on this machine, and compares them with double."""

import argparse

from fixel import commands
from fixel.base import kept
from fixel.scene import scene_options


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    scene_options.add(made, targets=False, looks=False)
    made.add_argument("--out", default="build/wire", help="folder for the results")
    made.add_argument("--build", default="build", help="folder that make builds in")
    kept.add_option(made)
    return made


main = commands.main_of(parser, "fixel.report.wireframes")
