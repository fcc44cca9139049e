# SPDX-License-Identifier: MIT
"""A command of make: the command of fixel, with the recipe's options and then those that the user's variables become.

    fixel make COMMAND OPTION...

The Makefile exports the variables that the user gave (it says why): a recipe cannot pass them on. Which variables a command
has stands in its line of help in the Makefile. NAME=value becomes --name=value, but for what stands here.
"""

import argparse
import os
import pathlib
import re

from fixel import commands
from fixel.base.errors import ToolError
from fixel.base.reading import shortened

MAKEFILE = pathlib.Path(__file__).resolve().parents[3] / "Makefile"
# By these make chooses what it builds. It compares them with the names that there are, and its recipes pass on what was chosen.
OF_MAKE = {"BOARD", "PROGRAM", "VISIBILITY", "CLIPPER", "ROWS", "DRIVER", "SIZE", "LIB_FLAGS", "COSTS_CORES", "COSTS_BOARDS", "coverage ONLY",
           "coverage-builds ONLY", "pictures ONLY"}
# Options without a value: set by 1, and by nothing else.
FLAGS = {"OPEN", "DRY_RUN", "WHOLE", "FRESH", "ALLOW_OUTSIDE", "RENEW", "BREAK", "RELEASE", "BUGS", "ACCEPT", "compare JSON"}
# Passed on even if empty, for the tool to refuse. Any other empty variable counts as not given.
EVEN_EMPTY = {"SCENE", "OUT", "PICTURE", "A", "B", "TOLERANCE"}
OPTIONS = {"PICTURE": "--out", "GDB_COMMANDS": "--commands"}


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("command", choices=list(variables()), metavar="COMMAND", help="as make help lists them")
    made.add_argument("options", nargs=argparse.REMAINDER, metavar="OPTION", help="of the command")
    return made


def main(argv):
    given = parser().parse_args(argv)
    words = [*given.options, *options(given.command, os.environ)]
    # What the command starts does not have this command's variables: the tests call make.
    for name in names():
        os.environ.pop(name, None)
    return commands.start(given.command, words, "make")


def variables(makefile=MAKEFILE):
    """{command: names of its variables}, in the order of make help."""
    lines = re.findall(r"^([a-z-]+):.* ## (.*)$", makefile.read_text(encoding="utf-8"), re.MULTILINE)
    return {command: re.findall(r"[A-Z_]+(?==)", text[text.rfind("["):]) if text.endswith("]") else []
            for command, text in lines}


def option(command, name, value):
    """The words that a variable becomes."""
    names_here = {name, f"{command} {name}"}
    if names_here & OF_MAKE or not value and name not in EVEN_EMPTY:
        return []
    word = OPTIONS.get(name, f"--{name.lower().replace('_', '-')}")
    if not names_here & FLAGS:
        return [f"{word}={value}"]
    if value != "1":
        raise ToolError(f"{name} is '{shortened(value)}'; it must be 1, or be left out")
    return [word]


def options(command, environment):
    """The options that the variables of a command become."""
    return [word for name in variables()[command] if name in environment
            for word in option(command, name, environment[name])]


def names():
    """Those of all commands."""
    return {name for taken in variables().values() for name in taken}
