#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the tests: units on the host, the same units on emulated boards, the tools.

Prints a line for each suite, the whole output of failures, and which tests were left out because a board has
no room for them, and the ten files of tests that took the most CPU time. The last line is "N passed, N failed", and ", N skipped" if tests were skipped. Exit: 0 no
test failed, 1 a test failed or nothing ran. Limits are on CPU time and on sleep (fixel.base.limits), not on wall
time.
"""

from fixel.base import interpreter

interpreter.choose()  # before the imports that need a package

import argparse
import concurrent.futures
import dataclasses
import os
import pathlib
import re
import sys
import threading
import time
import xml.etree.ElementTree

from fixel.base import limits, scratch
from fixel.board import emulator
from fixel.check import units
from fixel.base.errors import ToolError, run_main
from fixel.base.table import coloured

HOST_CPU = 300          # seconds of CPU time for one program
BOARD_CPU = 300
PYTEST_CPU = 1800       # and for all that the tests of a file start
SLOWEST = 10            # files of tests that are named
QUIET = 20.0            # seconds without a line after which the one running is named
TESTS = pathlib.Path(__file__).resolve().parent.parent / "host_tests" / "tools"


@dataclasses.dataclass
class Outcome:
    """What a suite gave; output is shown where something failed."""
    passed: int = 0
    failed: int = 0
    skipped: int = 0
    output: str = ""
    cpu: float = 0.0    # seconds that it took, with all that it started


def count_unity(text):
    """Passed, failed, skipped as Unity printed them, a line for each test."""
    return tuple(len(re.findall(pattern, text, re.MULTILINE))
                 for pattern in (r":PASS\s*$", r":FAIL\b", r":IGNORE\b"))


def without_passes(text):
    """Unity's output less the lines of what passed."""
    return re.sub(r"^.*:PASS\s*\n", "", text, flags=re.MULTILINE).rstrip()


def run_host(program):
    """A Unity program on the host. One that ends early counts as a failure more."""
    # A path of its own: "x" alone would be looked for in PATH.
    command = [str(pathlib.Path(program).resolve())]
    try:
        done = limits.run(command, HOST_CPU, merge=True, text=True)
    except OSError as error:
        return Outcome(failed=1, output=f"{program}: {error.strerror}")
    except limits.LimitError as error:
        return Outcome(failed=1, output=f"{error.output}\n{error}")
    text = done.stdout
    passed, failed, skipped = count_unity(text)
    summary = re.search(r"^(\d+) Tests (\d+) Failures (\d+) Ignored", text, re.MULTILINE)
    if not summary or [int(n) for n in summary.groups()] != [passed + failed + skipped, failed, skipped]:
        failed += 1
        text += f"\n{program}: ended with {done.returncode} before its summary, or counted otherwise"
    elif done.returncode and not failed:
        failed += 1
        text += f"\n{program}: ended with {done.returncode} though nothing failed"
    return Outcome(passed, failed, skipped, text, done.cpu)


def run_board(elf):
    """A Unity program on its emulated board."""
    try:
        passed, failed, text, cpu = emulator.run_unit(elf, BOARD_CPU)
    except ToolError as error:
        return Outcome(failed=1, output=str(error))
    return Outcome(passed, failed, count_unity(text)[2], text, cpu)


def run_pytest(file):
    """One file of pytest tests."""
    with scratch.folder("test") as folder:
        report = folder / "report.xml"
        # The plug-in takes half a second, and says more only of tests that use Hypothesis.
        plugins = [] if "hypothesis" in file.read_text(encoding="utf-8") else ["-p", "no:hypothesispytest"]
        command = [sys.executable, "-m", "pytest", str(file), *plugins, "-q", "--tb=long", "--color=no",
                   "-rs", "-p", "no:cacheprovider", f"--junitxml={report}",
                   f"--basetemp={folder}/tmp"]
        try:
            done = limits.run(command, PYTEST_CPU, merge=True, text=True)
        except limits.LimitError as error:
            return Outcome(failed=1, output=f"{error.output}\n{error}")
        return dataclasses.replace(_pytest_outcome(report, done.returncode, done.stdout), cpu=done.cpu)


def _pytest_outcome(report, code, text):
    try:
        suite = xml.etree.ElementTree.parse(report).getroot().find("testsuite")
        total, skipped = int(suite.get("tests")), int(suite.get("skipped"))
        failed = int(suite.get("failures")) + int(suite.get("errors"))
    except (OSError, AttributeError, xml.etree.ElementTree.ParseError):
        return Outcome(failed=1, output=text)
    if code and not failed:     # 1: some failed; anything else: pytest itself did
        failed = 1
    return Outcome(max(0, total - failed - skipped), failed, skipped, text)


def all_suites(options):
    """(name, function, argument) of every suite, the long ones first."""
    suites = [(f"tools/{file.stem}", run_pytest, file) for file in sorted(TESTS.glob("test_*.py"))]
    suites += [(f"host/{name}", run_host, pathlib.Path(folder) / name)
               for folder, *names in options.host_units for name in names]
    suites += [(f"{board}/{elf.stem}", run_board, elf) for board, elf in units.of_boards(options)]
    return [suite for suite in suites
            if options.only in suite[0] and (not options.board or suite[0].startswith(f"{options.board}/"))]


def print_left_out(options):
    """What a board has no room for; its board.mk says why."""
    for board, *names in options.left_out:
        if options.board in ("", board):
            print(f"left out: {board}: {', '.join(names)} (no room: boards/{board}/board.mk)")


class Printer:
    """A line a suite; where nothing happens for long, what is still running."""

    def __init__(self, names):
        self.width = max(map(len, names), default=0)
        self.total, self.done = len(names), 0
        self.running = {}
        self.lock = threading.Lock()
        self.last = time.monotonic()

    def start(self, name):
        with self.lock:
            self.running[name] = time.monotonic()

    def end(self, name, outcome):
        with self.lock:
            seconds = time.monotonic() - self.running.pop(name)
            self.done += 1
            word = coloured("FAIL", "red") if outcome.failed else coloured("ok", "green") + "  "
            counts = f"{outcome.passed:5} passed" + \
                (f", {outcome.failed} failed" if outcome.failed else "") + \
                (f", {outcome.skipped} skipped" if outcome.skipped else "")
            print(f"[{self.done:{len(str(self.total))}}/{self.total}] {word} "
                  f"{name:{self.width}} {counts}  {seconds:.1f} s", flush=True)
            if outcome.failed:
                print(without_passes(outcome.output), flush=True)
            self.last = time.monotonic()

    def remind(self):
        """Names what is running where that has been the case for long."""
        with self.lock:
            if self.running and time.monotonic() - self.last > QUIET:
                print(f"        still running: {', '.join(self.running)}", file=sys.stderr, flush=True)
                self.last = time.monotonic()


def run_all(suites, workers):
    """Outcomes of all suites, run side by side."""
    printer = Printer([name for name, _, _ in suites])

    def one(name, function, argument):
        printer.start(name)
        outcome = function(argument)
        printer.end(name, outcome)
        return outcome

    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        futures = [pool.submit(one, *suite) for suite in suites]
        waiting = futures
        while waiting:
            waiting = concurrent.futures.wait(waiting, timeout=1.0).not_done
            printer.remind()
    return [future.result() for future in futures]


def print_slowest(taken):
    """The files of tests that took the most CPU time. taken: {name: seconds}."""
    print(f"slowest of {sum(taken.values()):.0f} s of CPU:")
    for name in sorted(taken, key=taken.get, reverse=True)[:SLOWEST]:
        print(f"{taken[name]:8.1f} s  {name}")


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--host-units", nargs="+", action="append", default=[], metavar=("FOLDER", "NAME"),
                        help="a folder of Unity programs for the host, and their names")
    units.add_options(parser)
    parser.add_argument("--board", default="", help="run only the suites of this board")
    parser.add_argument("--only", default="", help="run only suites with this word in their name")
    # One more than processors: some suites wait, for a browser or for time to pass.
    parser.add_argument("--workers", type=int, default=(os.cpu_count() or 1) + 1)
    options = parser.parse_args(argv)
    # The tests start tools some thousand times: a tool that Python has compiled before starts a third faster.
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    suites = all_suites(options)
    outcomes = run_all(suites, max(1, options.workers))
    print_left_out(options)
    passed, failed, skipped = (sum(getattr(outcome, name) for outcome in outcomes)
                               for name in ("passed", "failed", "skipped"))
    if passed + failed == 0:
        print("no test ran", file=sys.stderr)
    print_slowest({suite[0]: outcome.cpu for suite, outcome in zip(suites, outcomes)})
    print(f"{passed} passed, {failed} failed" + (f", {skipped} skipped" if skipped else ""))
    return 1 if failed or passed == 0 else 0


if __name__ == "__main__":
    run_main(main)
