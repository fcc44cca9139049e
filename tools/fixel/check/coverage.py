# SPDX-License-Identifier: MIT
"""Says what of the library its tests reach: lines, branches and conditions of each room of lib/.

    fixel coverage --library libfixel-coverage.so --tests PROGRAM... [--replay PROGRAM CORPUS]... --out coverage.json

The library is built by Clang with counters (host_tests/unit/unit_coverage.mk). Runs the unit tests of the host and the
replays of the fuzzer's corpus. The JSON file has every file of lib/, and the conditions that nothing reaches.
Exit: 0 done, 1 a test failed, 2 could not run.
"""

import argparse
import os
import pathlib
import sys

from fixel.base import output, scratch
from fixel.base.table import table
from fixel.check import clang_coverage, corpus

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--library", required=True, help="the library with counters, a shared object")
    made.add_argument("--tests", nargs="+", required=True, help="unit tests that load it")
    made.add_argument("--replay", nargs=2, action="append", default=[], metavar=("PROGRAM", "CORPUS"),
                      help="a program that replays a corpus, and the corpus's archive")
    made.add_argument("--version", default="19", help="of LLVM's tools (default: 19)")
    made.add_argument("--out", required=True, help="the JSON file")
    made.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    return made


def main(argv):
    options = parser().parse_args(argv)
    programs = [[test] for test in options.tests]
    library = pathlib.Path(options.library).resolve()
    with scratch.folder("coverage", library.parent) as folder, scratch.folder("corpus") as inputs:
        programs += [[program, *corpus.unpack(corpus.read(archive), inputs)] for program, archive in options.replay]
        counts, failed = clang_coverage.run_programs(programs, folder.resolve(), options.jobs)
        files = clang_coverage.measured(library, counts, options.version, CHECKOUT)
    rooms = clang_coverage.by_room(files)
    output.write_json(options.out, {"rooms": rooms, "files": files})
    print(table(clang_coverage.rows(rooms), ["room", *clang_coverage.KINDS.values()]))
    for name, words in failed.items():
        print(f"{name} failed, so what it reaches may be more:\n{words}", file=sys.stderr)
    return 1 if failed else 0
