# SPDX-License-Identifier: MIT
"""Writes the packages of Arduino, PlatformIO, ESP-IDF, Zephyr, Conan and Rust: the library as two files, and each one's own manifests.

All come from one table, layouts.toml. Exit: 0 written, 2 a file cannot be written or there is no such package.
"""

import argparse
import pathlib

from fixel import commands


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--only", default="", metavar="PACKAGE", help="one of them: arduino, platformio, esp-idf, zephyr, conan or rust")
    made.add_argument("--out", type=pathlib.Path, default=pathlib.Path("build/packages"), metavar="FOLDER", help="where to (build/packages)")
    return made


main = commands.main_of(parser, "fixel.package.layouts")
