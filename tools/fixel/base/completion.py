# SPDX-License-Identifier: MIT
"""Prints a script by which a shell completes commands, options and files of fixel.

    fixel completion bash|zsh

bash: eval "$(.venv/bin/fixel completion bash)". zsh, after compinit: the same with zsh. Exit: 0 done, 2 no package for it.
"""

import argparse

from fixel import commands
from fixel.base.errors import ToolError

SHELLS = ("bash", "zsh")
# What commands call the files and folders that they take.
FILES = {"a", "b", "baseline", "build", "commands", "current", "document", "dump", "dumps", "elf", "file", "font", "image", "json",
         "keep", "library", "out", "picture", "replay", "run", "scene", "scenes", "tests", "usage"}


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("shell", choices=SHELLS)
    return made


def whole_parser(file):
    """All commands as one parser. file: what marks an option that takes a file."""
    made = argparse.ArgumentParser(prog="fixel")
    chosen = made.add_subparsers(dest="command")
    for room in commands.ROOMS.values():
        for name, (_, what) in room.items():
            own = chosen.add_parser(name, parents=[commands.parser(name)], add_help=False, help=what, description=what)
            for action in own._actions:     # argparse has no other list of them, and shtab reads this one too
                if action.dest in FILES and action.nargs != 0:
                    action.complete = file
    return made


def main(argv):
    options = parser().parse_args(argv)
    try:
        import shtab
    except ModuleNotFoundError as error:
        raise ToolError("the package shtab is missing, which makes completions: run 'tools/setup.sh completion'") from error
    print(shtab.complete(whole_parser(shtab.FILE), options.shell))
    return 0
