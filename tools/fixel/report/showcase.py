# SPDX-License-Identifier: MIT
"""Makes 24 models of the kinds that people have, draws each by its first command, and writes a page of them.

Exit: 0 the frames of every model are right, as those of make run are; 1 not; 2 a model could not be drawn."""

import argparse

from fixel import commands
from fixel.base import kept


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--board", required=True)
    made.add_argument("--only", default="", help="models with one of these words in their name, with commas between")
    made.add_argument("--out", default="build/showcase", help="folder for the page, the pictures and the models")
    made.add_argument("--build", default="build", help="folder that make builds in")
    kept.add_option(made)
    return made


main = commands.main_of(parser, "fixel.report.showcase_page")
