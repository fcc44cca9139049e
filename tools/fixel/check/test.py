# SPDX-License-Identifier: MIT
"""Runs the tests: units on the host, the same units on emulated boards, the tools.

Prints a line for each suite, the whole output of failures, which tests were left out because a board has no room
for them, and the ten files of tests, or programs of such on a board, that took the most CPU time. The last line is
"N passed, N failed", and ", N skipped" if tests were skipped. Exit: 0 no test failed, 1 a test failed or nothing ran.
Limits are on CPU time and on sleep (fixel.base.limits), not on wall time.
"""

import argparse
import os
import pathlib

from fixel import commands
from fixel.base.errors import ToolError
from fixel.check import units

TESTS = pathlib.Path(__file__).resolve().parents[3] / "host_tests"


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--host-units", nargs="+", action="append", default=[], metavar=("FOLDER", "NAME"),
                      help="a folder of Unity programs for the host, and their names")
    units.add_options(made)
    made.add_argument("--board", default="", help="run only the suites of this board")
    made.add_argument("--only", default="", help="run only suites with one of these words in their name")
    made.add_argument("--needs", action="store_true", help="run nothing: print what --only needs of make")
    made.add_argument("--json", help="a file for the CPU seconds of each file of tests, or program of such on a board")
    made.add_argument("--whole", action="store_true", help="run all of what is otherwise sampled")
    # One more than processors: some suites wait, for a browser or for time to pass.
    made.add_argument("--workers", type=int, default=(os.cpu_count() or 1) + 1)
    return made


def before(options):
    """Refuses a word that no suite has in its name: a suite of the host or of a board for a unit test, one for each file of pytest."""
    units_of = [file.stem for file in TESTS.rglob("test_*.c")]
    boards = [folder.name for folder in (TESTS.parent / "boards").iterdir() if (folder / "board.mk").exists()]
    names = {f"{file.parent.name}/{file.stem}" for file in TESTS.glob("*/test_*.py")} | {f"{board}/{unit}" for board in boards for unit in units_of}
    unknown = [word for word in options.only.split() if not any(word in name for name in names)]
    if unknown:
        raise ToolError(f"no suite has '{unknown[0]}' in its name; names are such as host/test_scan, mps2-an385/test_scan, tools/test_stl")


main = commands.main_of(parser, "fixel.check.all_tests")
