#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A command of make: its tool, with the recipe's options and then those that the user's variables become.

    make.py COMMAND OPTION...
    make.py --nearest NAME ENDING WORD...   the question which word was meant by a name, for an error of the Makefile
"""

import argparse
import importlib
import os
import sys

from fixel.base import interpreter, make_variables, nearest

TOOLS = {"profile": "profile_frame"}


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("command", choices=make_variables.commands(), metavar="COMMAND", help="as make help lists them")
    parser.add_argument("options", nargs=argparse.REMAINDER, metavar="OPTION", help="of the command's tool")
    given = parser.parse_args(argv)
    command = given.command
    words = [*given.options, *make_variables.options(command, os.environ)]
    # What the tool starts does not have this command's variables: the tests call make.
    for name in make_variables.names():
        os.environ.pop(name, None)
    tool = importlib.import_module(TOOLS.get(command, command.replace("-", "_")))
    sys.argv[0] = f"make {command}"
    return tool.main(words)


if __name__ == "__main__":
    if sys.argv[1] == "--nearest":
        print(nearest.question(sys.argv[2], sys.argv[4:], sys.argv[3]))
        sys.exit(0)
    interpreter.choose()
    from fixel.base.errors import run_main
    run_main(main)
