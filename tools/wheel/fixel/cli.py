# SPDX-License-Identifier: MIT
"""The command fixel of the wheel: the tools that need no compiler and no checkout, on this machine."""

import sys

from fixel import __version__, commands, programs
from fixel.base.errors import ToolError, run_main
from fixel.base.nearest import question

# Commands, and the options that the makefile gives them in a checkout.
WITHOUT = ("build", "export", "info", "texture", "font", "crc", "compare")
ON_HOST = ("run", "view")
BUILT = ("wire",)


def usage():
    """The list of commands."""
    told = {name: what for room in commands.ROOMS.values() for name, (_, what) in room.items() if name in WITHOUT + ON_HOST + BUILT}
    rows = [f"  {name:8}  {what}" for name, what in told.items()]
    return "\n".join(["usage: fixel COMMAND ...", "", *rows, "", "fixel COMMAND --help tells more of one."])


def has(words, option):
    return any(word == option or word.startswith(f"{option}=") for word in words)


def completed(name, words):
    """A command's words with what stands in a checkout's makefile: the scene may come first, the board is this machine."""
    if name not in ON_HOST + BUILT:
        return words
    if words and not words[0].startswith("-"):
        words = [f"--scene={words[0]}", *words[1:]]
    more = ["--board=host"] if name in ON_HOST and not has(words, "--board") else []
    return [*words, *more, *([] if has(words, "--build") else [f"--build={programs.build()}"])]


def work(argv):
    """Runs a command; the exit code."""
    name, *words = argv or ["--help"]
    if name in ("-h", "--help"):
        print(usage())
        return 0
    if name == "--version":
        print(f"fixel {__version__}")
        return 0
    known = WITHOUT + ON_HOST + BUILT
    if name not in known:
        more = " without a checkout" if name in commands.COMMANDS else question(name, known)
        raise ToolError(f"fixel has no command '{name}'{more} (see fixel --help)")
    return commands.start(name, completed(name, words))


def main():
    """The program."""
    run_main(work)


if __name__ == "__main__":
    sys.exit(main())
