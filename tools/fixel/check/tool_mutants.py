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
import json
import os
import pathlib
import shutil
import sys
import sysconfig
import time

from fixel.base import kept, limits, scratch
from fixel.campaign import runner
from fixel.check import lines, mutate, mutate_python, planting
from fixel.check.pytest_client import Client, EndedError

NAME, CAMPAIGN = "tools", "tools-mutants"
CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
CPU_TEST, CPU_MORE = lines.RUN, 15.0    # CPU seconds that each of some tests may take, and all of them beside
TESTS = 60                      # at most for a mutant
FIRST = 5                       # tests that run before the others are imported
MISSING = (4, 5)                # pytest has not found a test
MADE = {"build", "dist", ".git", ".venv", ".node", "__pycache__"}   # what is no part of a checkout

SHARD_SETUP = "test"
_held = contextlib.ExitStack()  # copies of this process
RECORDER = pathlib.Path(__file__).with_name("recorder")
COPIED = ("tools", "host_tests")
UNCOPIED = shutil.ignore_patterns("__pycache__")
PLAIN = ["-q", "-p", "no:cacheprovider", "-p", "no:hypothesispytest", "--no-header", "--tb=line"]
ASLEEP = 60.0       # seconds of sleep that are a hang


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
    return Trial(Tree(_held.enter_context(scratch.folder("mutants", build)) / "tree", CHECKOUT))


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
    mutant = mutate.find(CHECKOUT, parameters["mutant"], mutate_python.mutants)
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
            self._records.complete(lambda: [Tree(held.enter_context(scratch.folder("mutants", build)) / "tree", CHECKOUT)
                                            for _ in range(runner.jobs_of(options))])

    def parameters(self, key, mutant):
        """Of the shard of a mutant."""
        text = (CHECKOUT / mutant.file).read_text(encoding="utf-8")
        return {"mutant": key, "tests": self._records.tests(mutant, text)[:TESTS]}


class Tree:
    """A checkout of its own: copies of what is mutated and of its tests, and links to everything else."""

    def __init__(self, folder, checkout):
        self.folder = folder
        shutil.rmtree(folder, ignore_errors=True)
        for name in COPIED:
            shutil.copytree(checkout / name, folder / name, ignore=UNCOPIED)
        for each in checkout.iterdir():
            if not (folder / each.name).exists() and each.name not in (".git", "build"):
                (folder / each.name).symlink_to(each)
        # Its journals of temporary files are its own: a mutant of scratch.py must not take those of commands that live for left over.
        (folder / "build").mkdir()
        for each in checkout.glob("build/*"):
            if each.name != scratch.JOURNALS.name:
                (folder / "build" / each.name).symlink_to(each)
        # Set-up would make .venv anew, which is a link, because its path is another.
        (folder / "tools" / "setup.sh").write_text("#!/bin/sh\n", encoding="utf-8")
        self._said, self._report = folder / "said.txt", folder / "report.jsonl"
        self._server, self._time = None, int(time.time())

    def record(self):
        """From here on the tests record the lines of the tools that they execute. Their Python is one that imports the
        recorder, also in a process that looks at no variable of the environment (python -I), as those of bounded.py."""
        packages = pathlib.Path(sysconfig.get_path("purelib"))
        venv = self.folder / ".venv"
        venv.unlink()
        made = venv / packages.relative_to(sys.prefix)
        made.mkdir(parents=True)
        (venv / "bin").mkdir()
        (venv / "bin/python").symlink_to(sys._base_executable)
        for command in pathlib.Path(sys.prefix, "bin").iterdir():
            if not (venv / "bin" / command.name).exists():
                (venv / "bin" / command.name).symlink_to(command)
        (venv / "pyvenv.cfg").write_text(f"home = {pathlib.Path(sys._base_executable).parent}\n", encoding="utf-8")
        (made / "recorder.pth").write_text(f"{packages}\n{RECORDER}\nimport line_recorder\n", encoding="utf-8")
        self._server = Client(venv / "bin/python", FIXEL_LINES_OF=str(self.folder / "tools/fixel"))

    def write(self, file, text):
        """Puts text into a file. What Python has compiled of it before is out of date for certain: it goes by seconds."""
        (self.folder / file).write_text(text, encoding="utf-8")
        self._time += 1
        os.utime(self.folder / file, (self._time, self._time))

    def run(self, tests, cpu, *options, lines=None, enough=0.0):
        """(exit code of pytest or words that say how else it ended, the report of each test by pytest_server.py).
        lines: the folder for the lines that each executes, of each test only parameters that take enough seconds."""
        if self._server is None:
            self._server = Client()
        self._report.unlink(missing_ok=True)
        words = [*PLAIN, *options, f"--basetemp={self.folder}/tmp", *(f"host_tests/{test}" for test in tests)]
        try:
            code, _ = self._server.run({"folder": str(self.folder), "words": words, "said": str(self._said),
                                        "report": str(self._report), "lines": lines and str(lines), "enough": enough}, cpu, ASLEEP)
        except (limits.LimitError, EndedError) as error:
            code = str(error)
        report = self._report.read_text(encoding="utf-8").splitlines() if self._report.exists() else []
        return code, [json.loads(line) for line in report]

    def close(self):
        if self._server is not None:
            self._server.close()
