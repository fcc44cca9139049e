# SPDX-License-Identifier: MIT
"""Tests the tests of the tools: puts small mistakes into tools/fixel, drawn at random, one at a time.

A mutant is tried in a copy of tools/ and host_tests/ below --build, with the --files files of tests that are
likeliest to see it (fixel.check.likely). It is killed where one of them fails. A file of tests that fails as it is, or
takes more than --slow seconds of CPU time, is passed over. host_tests/tools/survivors.toml has the mutants that change
no result: they are not drawn. Exit: 0 done, 1 fewer than --least per cent were killed, 2 could not run.
"""

import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import queue
import random
import shutil
import sys
import threading

from fixel.base import limits, output
from fixel.base.errors import ToolError
from fixel.base.progress import Progress
from fixel.check import likely, mutate_python, survivors

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
KNOWN = "host_tests/tools/survivors.toml"
COPIED = ("tools", "host_tests")
UNCOPIED = shutil.ignore_patterns("__pycache__")
CPU_TIMES = 4       # a file of tests may take so many times what it takes without a mutant
NICE = 5


class Tree:
    """A checkout of its own: copies of what is mutated and of its tests, and links to everything else."""

    def __init__(self, folder):
        self.folder = folder
        shutil.rmtree(folder, ignore_errors=True)
        for name in COPIED:
            shutil.copytree(CHECKOUT / name, folder / name, ignore=UNCOPIED)
        for each in CHECKOUT.iterdir():
            if not (folder / each.name).exists() and each.name != ".git":
                (folder / each.name).symlink_to(each)

    def run(self, tests, cpu):
        """None if files of tests pass, else the words of the first failure."""
        words = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", "--no-header", *map(str, tests)]
        try:
            done = limits.run(words, cpu, merge=True, text=True, cwd=self.folder,
                              env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
        except limits.LimitError as error:
            return str(error)
        if done.returncode == 0:
            return None
        failed = [line for line in done.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
        return failed[0] if failed else f"pytest ended with {done.returncode}"


class Trial:
    """Tries mutants in trees."""

    def __init__(self, tests, files, slow, seconds):
        """seconds: {name of a file of tests: what it takes as it is, or None}, to which more are added."""
        self._map, self._files, self._slow, self._seconds = tests, files, slow, seconds
        self._locks, self._lock = {}, threading.Lock()

    def seconds(self, tree, test):
        """CPU seconds of a file of tests as it is, in a tree that is not mutated; None where it fails or takes more than
        is allowed."""
        with self._lock:
            lock = self._locks.setdefault(test, threading.Lock())
        with lock:
            if test.name not in self._seconds:
                before = os.times()
                words = tree.run([test], self._slow)
                after = os.times()      # other trees' children too, so it is a bound
                taken = sum(after[2:4]) - sum(before[2:4])
                self._seconds[test.name] = None if words else max(1.0, min(taken, self._slow))
        return self._seconds[test.name]

    def tests(self, tree, mutant):
        """The files of tests that a mutant is tried with."""
        found = []
        for test in self._map.tests(mutant.file):
            test = test.relative_to(CHECKOUT)
            if self.seconds(tree, test) is not None:
                found.append(test)
            if len(found) == self._files:
                break
        return found

    def run(self, tree, mutant):
        """{"result", "tried", "words"} of a mutant; afterwards the tree is as it was."""
        file = tree.folder / mutant.file
        good = file.read_text(encoding="utf-8")
        tests = self.tests(tree, mutant)
        try:
            file.write_text(mutant.apply(good), encoding="utf-8")
            cpu = CPU_TIMES * sum(self._seconds[test.name] for test in tests) + limits.LOOK
            words = tree.run(tests, cpu) if tests else None
            return {"result": "killed" if words else "survived", "tried": [test.name for test in tests], "words": words or ""}
        finally:
            file.write_text(good, encoding="utf-8")


def state():
    """A hash of all that is copied."""
    found = hashlib.sha256()
    for name in COPIED:
        for path in sorted((CHECKOUT / name).rglob("*.*")):
            if path.is_file() and path.suffix != ".pyc":
                found.update(str(path).encode() + b"\0" + path.read_bytes())
    return found.hexdigest()


def read_seconds(file, key):
    """What files of tests took in an earlier run, if that was of the same sources."""
    try:
        kept = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return kept["seconds"] if kept.get("state") == key else {}


def draw(only, seed, count, known):
    """So many mutants that are not known to change no result."""
    found = []
    for path in sorted((CHECKOUT / "tools" / "fixel").rglob("*.py")):
        file, text = path.relative_to(CHECKOUT).as_posix(), path.read_text(encoding="utf-8")
        found += [mutant for mutant in mutate_python.mutants(file, text) if only in file and
                  (file, survivors.line_of(mutant, text), survivors.change_of(mutant)) not in known]
    if not found:
        raise ToolError(f"no file of tools/fixel has '{only}' in its name and a mutant")
    random.Random(seed).shuffle(found)
    return found[:count]


def try_all(trial, trees, drawn):
    """[(mutant, result)], in the order in which they were drawn."""
    free = queue.SimpleQueue()
    for tree in trees:
        free.put(tree)

    def work(mutant):
        tree = free.get()
        try:
            result = trial.run(tree, mutant)
        finally:
            free.put(tree)
        if result["result"] == "survived":
            print(f"survived: {mutant}", file=sys.stderr, flush=True)
        return mutant, result

    found = []
    with Progress("mutants", len(drawn)) as progress, concurrent.futures.ThreadPoolExecutor(len(trees)) as pool:
        for each in pool.map(work, drawn):
            found.append(each)
            progress(len(found))
    return found


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, required=True, help="of the choice of mutants")
    parser.add_argument("--count", type=int, default=100, help="so many mutants")
    parser.add_argument("--only", default="", help="only of files with this in their path")
    parser.add_argument("--files", type=int, default=4, help="so many files of tests for a mutant")
    parser.add_argument("--slow", type=float, default=30.0, help="seconds; files of tests that take more are passed over")
    parser.add_argument("--least", type=float, default=0.0, help="per cent that must be killed")
    parser.add_argument("--build", default="build", help="the build folder")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args(argv)
    os.nice(NICE)
    known = survivors.load(CHECKOUT / KNOWN, CHECKOUT, mutate_python.mutants)
    drawn = draw(options.only, options.seed, options.count, known)
    scratch = pathlib.Path(options.build).resolve() / "mutants"
    trees = [Tree(scratch / f"tools-{number}") for number in range(options.jobs)]
    times, key = scratch / "tools-seconds.json", f"{state()} {options.slow}"
    seconds = read_seconds(times, key)
    found = try_all(Trial(likely.Map(CHECKOUT), options.files, options.slow, seconds), trees, drawn)
    output.write_json(times, {"state": key, "seconds": seconds})
    killed = sum(result["result"] == "killed" for _, result in found)
    percent = 100 * killed / len(found)
    output.write_json(scratch / f"tools-seed-{options.seed}.json",
                      {"seed": options.seed, "count": len(found), "killed": killed, "percent": percent,
                       "known": len(known), "mutants": [{"mutant": str(mutant), **result} for mutant, result in found]})
    print(f"{killed} of {len(found)} mutants of the tools killed: {percent:.1f} % (seed {options.seed})")
    return 1 if percent < options.least else 0
