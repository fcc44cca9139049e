# SPDX-License-Identifier: MIT
"""The options of a tool that the user's variables of a make command become.

The Makefile exports the variables that the user gave (it says why): a recipe cannot pass them on. Which variables a
command has stands in its line of help in the Makefile. NAME=value becomes --name=value, but for what stands here.
"""

import pathlib
import re

from fixel.base.errors import ToolError
from fixel.base.reading import shortened

MAKEFILE = pathlib.Path(__file__).resolve().parents[3] / "Makefile"
# By these make chooses what it builds. It compares them with the names that there are, and its recipes pass on what was chosen.
OF_MAKE = {"BOARD", "PROGRAM", "VISIBILITY", "CLIPPER", "ROWS", "DRIVER", "SIZE", "LIB_FLAGS", "COSTS_CORES", "COSTS_BOARDS", "coverage ONLY",
           "pictures ONLY"}
# Options without a value: set by 1, and by nothing else.
FLAGS = {"OPEN", "DRY_RUN", "WHOLE", "FRESH", "ALLOW_OUTSIDE", "RENEW", "BREAK", "BUGS", "ACCEPT", "compare JSON"}
# Passed on even if empty, for the tool to refuse. Any other empty variable counts as not given.
EVEN_EMPTY = {"SCENE", "OUT", "PICTURE", "A", "B", "TOLERANCE"}
OPTIONS = {"PICTURE": "--out", "GDB_COMMANDS": "--commands"}


def commands(makefile=MAKEFILE):
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
    return [word for name in commands()[command] if name in environment
            for word in option(command, name, environment[name])]


def names():
    """Those of all commands."""
    return {name for variables in commands().values() for name in variables}
