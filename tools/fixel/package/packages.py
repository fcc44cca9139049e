# SPDX-License-Identifier: MIT
"""Writes the packages of Arduino, PlatformIO, ESP-IDF, Zephyr, Conan and Rust: the library's sources, and each one's own manifests.

All come from one table, layouts.toml. Exit: 0 written, 2 a file cannot be written or there is no such package.
"""

import argparse
import pathlib
import tomllib

from fixel.base.errors import ToolError
from fixel.base.nearest import question
from fixel.commands import late

layouts = late("fixel.package", "layouts")

TABLE = pathlib.Path(__file__).with_name("layouts.toml")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--only", default="", metavar="PACKAGE", help="one of them: arduino, platformio, esp-idf, zephyr, conan or rust")
    made.add_argument("--out", type=pathlib.Path, default=pathlib.Path("build/packages"), metavar="FOLDER", help="where to (build/packages)")
    return made


def table():
    """The layouts of all packages."""
    return tomllib.loads(TABLE.read_text(encoding="utf-8"))


def before(options):
    """The layouts of all packages; refuses a name that none has."""
    known = table()
    if options.only and options.only not in known:
        raise ToolError(f"there is no package '{options.only}'{question(options.only, known)}; there are: {', '.join(known)}")
    return known


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)     # before the module that does the work is imported
    return layouts.command(options)
