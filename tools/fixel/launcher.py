# SPDX-License-Identifier: MIT
"""fixel COMMAND: the tools as commands of one program, .venv/bin/fixel, which set-up makes."""

import pathlib
import sys

if __name__ == "__main__":
    sys.path[0] = str(pathlib.Path(__file__).resolve().parents[1])
    from fixel.base import interpreter
    interpreter.choose()

from fixel import commands
from fixel.base.errors import ToolError, run_main
from fixel.base.nearest import question
from fixel.base.version import version


def usage():
    """The list of commands, by room."""
    width = max(map(len, commands.COMMANDS))
    rooms = ("\n".join([f"{room}:", *(f"  {name:{width}}  {what}" for name, (_, what) in members.items())])
             for room, members in commands.ROOMS.items())
    return "usage: fixel COMMAND ...\n\n" + "\n\n".join(rooms) + "\n\nfixel COMMAND --help tells more of one. fixel --version tells the version."


def main(argv):
    """Runs a command; the exit code."""
    name, *words = argv or ["--help"]
    if name == "--version":
        print(f"fixel {version()}")
        return 0
    if name in ("-h", "--help"):
        print(usage())
        return 0
    if name not in commands.COMMANDS:
        raise ToolError(f"fixel has no command '{name}'{question(name, commands.COMMANDS)} (see fixel --help)")
    return commands.start(name, words)


if __name__ == "__main__":
    run_main(main)
