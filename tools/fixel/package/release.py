# SPDX-License-Identifier: MIT
"""Builds every artefact of a version into dist/: the source, the one file, the packages, the Python package, an SPDX list of
what is in them, and their hashes. The same commit gives the same bytes. Nothing is published.

Exit: 0 written, 2 the checkout has changes, its tag is that of another version, or a file cannot be written.
"""

import argparse
import pathlib

from fixel import commands


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--out", type=pathlib.Path, default=pathlib.Path("dist"), metavar="FOLDER", help="where to (dist)")
    return made


main = commands.main_of(parser, "fixel.package.artefacts")
