# SPDX-License-Identifier: MIT
"""Writes the library as two files, fixel.h and fixel.c, which any compiler of C11 or C++11 takes.

They have all of the library but the study and the kernels in assembly. The frames are those of the library, bit for bit.
Exit: 0 written, 2 a file cannot be written.
"""

import argparse
import pathlib

from fixel.base import output
from fixel.base.version import version
from fixel.package import one_text


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--out", type=pathlib.Path, default=pathlib.Path("build/one-file"), metavar="FOLDER", help="where to (build/one-file)")
    return made


def main(argv):
    folder = parser().parse_args(argv).out
    for name, text in (("fixel.h", one_text.header_text(version())), ("fixel.c", one_text.source_of_all(version()))):
        output.write_file(folder / name, text)
        print(f"{folder / name}: {len(text.encode()) // 1000} KB")
    return 0
