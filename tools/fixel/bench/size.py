# SPDX-License-Identifier: MIT
"""Prints flash, RAM and stack of the firmware, and of the library for each core.

Also checks on the Cortex-M0 build, or on another one where that is not given, that the library links neither floating point nor a heap: by its undefined
symbols, and by linking all of it with the compiler's own helpers alone. Exit 1 if the check fails.
"""

import argparse

from fixel import commands


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--board", required=True)
    made.add_argument("--elf", help="the firmware (default: only the library)")
    made.add_argument("--usage", nargs="*", default=[], help="folders with its objects' .su files")
    made.add_argument("--library", action="append", default=[], metavar="CORE=FILE",
                      help="libfixel.a for a core")
    made.add_argument("--cross", default="arm-none-eabi-")
    made.add_argument("--out", required=True, help="the JSON file to write")
    return made


main = commands.main_of(parser, "fixel.bench.sizes")
