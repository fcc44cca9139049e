# SPDX-License-Identifier: MIT
"""A command of make: the command of fixel, with the recipe's options and then those that the user's variables become.

    fixel make COMMAND OPTION...
"""

import argparse
import os

from fixel import commands
from fixel.base import make_variables


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("command", choices=list(make_variables.commands()), metavar="COMMAND", help="as make help lists them")
    made.add_argument("options", nargs=argparse.REMAINDER, metavar="OPTION", help="of the command")
    return made


def main(argv):
    given = parser().parse_args(argv)
    words = [*given.options, *make_variables.options(given.command, os.environ)]
    # What the command starts does not have this command's variables: the tests call make.
    for name in make_variables.names():
        os.environ.pop(name, None)
    return commands.start(given.command, words, "make")
