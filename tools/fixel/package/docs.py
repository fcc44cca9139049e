# SPDX-License-Identifier: MIT
"""Writes the reference of all public functions and types, pages of HTML that Doxygen makes of the headers.

Exit: 0 written; 1 a function or a type has no comment, or a comment names what is not there; 2 Doxygen is missing.
"""

import argparse
import pathlib

from fixel import commands


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--out", type=pathlib.Path, default=pathlib.Path("build/docs"), metavar="FOLDER", help="where to (build/docs)")
    return made


main = commands.main_of(parser, "fixel.package.reference")
