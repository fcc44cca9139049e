# SPDX-License-Identifier: MIT
"""Says what of the library its tests reach: lines, branches and conditions of each room of lib/.

    fixel coverage --library libfixel-coverage.so --tests PROGRAM... [--replay PROGRAM CORPUS]... [--reasons FILE] --out coverage.json

The library is built by Clang with counters (host_tests/unit/unit_coverage.mk). Runs the unit tests of the host and the
replays of the fuzzer's corpus. With --reasons each branch and each condition must be reached, or stand in that file with a
proof or a reason. The JSON file has every file of lib/, and what nothing reaches with its reason.
Exit: 0 done, 1 a test failed, or a branch or a condition is neither reached nor has a reason; 2 could not run.
"""

import argparse
import os
import pathlib
import shutil
import sys

from fixel.base import output, scratch
from fixel.base.errors import ToolError
from fixel.base.table import table
from fixel.check import clang_coverage, corpus, gaps

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--root", default=str(CHECKOUT), help="the checkout that the library was built in")
    made.add_argument("--library", required=True, help="the library with counters, a shared object")
    made.add_argument("--tests", nargs="+", required=True, help="unit tests that load it")
    made.add_argument("--replay", nargs=2, action="append", default=[], metavar=("PROGRAM", "CORPUS"),
                      help="a program that replays a corpus, and the corpus's archive")
    made.add_argument("--reasons", help="the file of what cannot be reached, and why; without it nothing is compared")
    made.add_argument("--version", default="19", help="of LLVM's tools (default: 19)")
    made.add_argument("--out", required=True, help="the JSON file")
    made.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    return made


def compare(files, stated, path):
    """Says what has a reason, and what has none or no longer needs one. Whether nothing has to be done."""
    reasons = gaps.with_reasons(files, stated)
    new, gone = gaps.sentences(files, stated)
    print(f"with a proof or a reason in {path}: {reasons['branches']} branches, {reasons['conditions']} conditions; "
          f"without one: {len(new)} places")
    if new:
        print("not reached, and without a reason. Write a test; or a reason, if no test can reach it:\n"
              + "".join(f"  {line}\n" for line in new), file=sys.stderr)
    if gone:
        print(f"reached by now, or gone. Take these out of {path}:\n" + "".join(f"  {line}\n" for line in gone), file=sys.stderr)
    return not new and not gone


def main(argv):
    options = parser().parse_args(argv)
    if shutil.which(f"llvm-cov-{options.version}") is None:
        raise ToolError(f"not run: needs clang {options.version} and its llvm tools")
    root = pathlib.Path(options.root).resolve()
    stated = gaps.read(root / options.reasons) if options.reasons else {}
    programs = [[test] for test in options.tests]
    library = pathlib.Path(options.library).resolve()
    with scratch.folder("coverage", library.parent) as folder, scratch.folder("corpus") as inputs:
        programs += [[program, *corpus.unpack(corpus.read(archive), inputs)] for program, archive in options.replay]
        counts, failed = clang_coverage.run_programs(programs, folder.resolve(), options.jobs)
        files = clang_coverage.measured(library, counts, options.version, root)
    rooms = clang_coverage.by_room(files)
    listed = {name: {kind: counted[kind] for kind in clang_coverage.KINDS} for name, counted in files.items()}
    output.write_json(options.out, {"rooms": rooms, "files": listed, "open": gaps.as_rows(files, stated)})
    print(table(clang_coverage.rows(rooms), ["room", *clang_coverage.KINDS]))
    for name, words in failed.items():
        print(f"{name} failed, so what it reaches may be more:\n{words}", file=sys.stderr)
    is_covered = compare(files, stated, options.reasons) if options.reasons else True
    print(options.out)
    return 0 if is_covered and not failed else 1
