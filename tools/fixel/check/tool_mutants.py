# SPDX-License-Identifier: MIT
"""Mutants of the tools: in copies of the checkout below the build folder, tried with tests for pytest. Each is a shard
(fixel/campaign/shards.py).

A mutant is tried with at most TESTS tests, until one fails: those that execute its line (lines.py), then others that
execute its function, and of each those first whose file has a name like the tool's. Which they are, the plan says, so that
nothing that is measured while a mutant is tried decides what is run. The first few run by themselves: they kill most
mutants, and pytest imports no file of the others. A test that fails is run once without the mutant: one that fails then too
says nothing, and the mutant is tried without it. A mutant that no test executes survives.
"""

import contextlib
import functools
import os
import pathlib

from fixel.base import kept, scratch
from fixel.campaign import runner
from fixel.check import lines, mutate_python, planting, survivors, trees

NAME, CAMPAIGN = "tools", "tools-mutants"
CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
CPU_TEST, CPU_MORE = lines.RUN, 15.0    # CPU seconds that each of some tests may take, and all of them beside
TESTS = 60                      # at most for a mutant
FIRST = 5                       # tests that run before the others are imported
MISSING = (4, 5)                # pytest has not found a test
MADE = {"build", "dist", ".git", ".venv", ".node", "__pycache__"}   # what is no part of a checkout

SHARD_SETUP = "test"
_held = contextlib.ExitStack()  # copies of this process


def files(checkout):
    """The files that mutants are made of."""
    return sorted((checkout / "tools" / "fixel").rglob("*.py"))


def cpu_of(tests):
    """The CPU time that tests may take."""
    return CPU_TEST * len(tests) + CPU_MORE


class Trial:
    """Tries mutants, in a tree of its own."""

    def __init__(self, tree):
        self._tree = tree
        self._good, self._bad = set(), set()    # tests that pass, or fail, without a mutant

    def _passes(self, tests):
        """Whether tests pass without a mutant."""
        if self._good.issuperset(tests):
            return True
        code, report = self._tree.run(tests, cpu_of(tests))
        self._good.update(each["test"] for each in report if each["passed"])
        self._bad.update(each["test"] for each in report if not each["passed"])
        if code in MISSING:     # of several it says not which
            if len(tests) > 1:
                return all([self._passes([test]) for test in tests])
            self._bad.update(tests)
        if isinstance(code, str):   # of a limit, which the test that ran last has passed
            self._bad.update([test for test in tests if test not in [each["test"] for each in report]][:1])
        return code == 0

    def _try(self, mutant, tests):
        """(exit code, report) of tests with a mutant; afterwards the tree is as it was."""
        tried = []
        with planting.planted(self._tree.folder, [mutant], self._tree.write):
            for some in filter(None, (tests[:FIRST], tests[FIRST:])):
                code, report = self._tree.run(some, cpu_of(some), "-x")
                tried += report
                if code != 0:
                    break
            return code, tried

    def run(self, mutant, tests):
        """{"result"} of a mutant; with "words" where it survived though it was not tried."""
        while True:
            tests = [test for test in tests if test not in self._bad]
            if not tests:
                return {"result": "survived", "words": "no test that passes without it executes it"}
            code, report = self._try(mutant, tests)
            if code == 0:
                return {"result": "survived"}
            failed = [each["test"] for each in report if not each["passed"]]
            before = len(self._bad)
            if self._passes(failed or tests):
                return {"result": "killed"}
            if len(self._bad) == before:
                return {"result": "survived", "words": "the tests do not pass without it"}


@functools.cache
def _trial(build):
    return Trial(trees.Tree(_held.enter_context(scratch.folder("mutants", build)) / "tree", CHECKOUT))


@functools.cache
def _content():
    """A hash of the checkout, of which the tests may read every file: as it is when the command begins, and copies it."""
    found = []
    for folder, inside, names in os.walk(CHECKOUT):
        inside[:] = sorted(name for name in inside if name not in MADE)
        paths = [pathlib.Path(folder, name) for name in sorted(names)]
        found += [each for path in paths if path.is_file() for each in (str(path.relative_to(CHECKOUT)), path)]
    return kept.key_of(found)


def run_shard(build, parameters):
    mutant = survivors.find(CHECKOUT, parameters["mutant"], mutate_python.mutants)
    return _trial(build.resolve()).run(mutant, parameters["tests"])


def shard_inputs(_build, _parameters):
    return [_content()]


def shard_targets(_build, _parameters):
    return ["all", "test-programs"]


class Plan:
    """The parameters of the shards, by a record of which tests execute which line: it is made once for a build folder."""

    def __init__(self, options):
        build = pathlib.Path(options.build).resolve()
        self._records = lines.Records(build / "mutants" / "lines", CHECKOUT)
        with contextlib.ExitStack() as held:
            self._records.complete(lambda: [trees.Tree(held.enter_context(scratch.folder("mutants", build)) / "tree", CHECKOUT)
                                            for _ in range(runner.jobs_of(options))])

    def parameters(self, key, mutant):
        """Of the shard of a mutant."""
        text = (CHECKOUT / mutant.file).read_text(encoding="utf-8")
        return {"mutant": key, "tests": self._records.tests(mutant, text)[:TESTS]}
