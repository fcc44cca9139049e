# SPDX-License-Identifier: MIT
"""Which tests for pytest execute a line of the tools, as a recorded run of each file of tests has shown.

A record is kept below the build folder until its file of tests changes. It counts the lines of a function from where
the function begins, so that it stays true where another function changes. A record that is out of date costs time or
lets a mutant survive; it never makes one look killed, because a test that kills must pass without the mutant.
"""

import ast
import concurrent.futures
import hashlib
import json
import pathlib
import queue
import shutil

from fixel.base import output
from fixel.base.progress import Progress

FILE = 60.0         # CPU seconds for a file of tests; its tests that come later are not known
PARAMETERS = 15.0   # CPU seconds for the parameters of a test; its later ones are not known
KEPT = 30           # tests for a line
LEAST = 0.05        # CPU seconds; a test costs no less: its file is imported


class Functions:
    """The outermost functions of a file, by the lines."""

    def __init__(self, text):
        self._found = []
        self._collect(ast.parse(text), "")

    def _collect(self, node, name):
        for each in ast.iter_child_nodes(node):
            if isinstance(each, (ast.FunctionDef, ast.AsyncFunctionDef)):
                first = min([each.lineno, *(mark.lineno for mark in each.decorator_list)])
                self._found.append((first, each.end_lineno, f"{name}{each.name}"))
            else:
                self._collect(each, f"{name}{each.name}." if isinstance(each, ast.ClassDef) else name)

    def place(self, line):
        """(the function's name, which of its lines), or None outside functions."""
        for first, last, name in self._found:
            if first <= line <= last:
                return name, line - first
        return None


def spread(tests, seconds):
    """Tests, the quickest first; of several that differ only in parameters, each later one counts as slower."""
    cost, before = {}, {}
    for test in sorted(tests, key=lambda test: (seconds[test], test)):
        function = test.partition("[")[0]
        before[function] = before.get(function, 0) + 1
        cost[test] = before[function] * max(seconds[test], LEAST)
    return sorted(cost, key=lambda test: (cost[test], test))


def files_of_tests(checkout):
    """The files of tests for pytest, from host_tests on."""
    folder = checkout / "host_tests"
    return sorted(file.relative_to(folder).as_posix() for file in folder.glob("*/test_*.py"))


def record(tree, file):
    """{"seconds": {test: CPU seconds}, "lines": {"FILE:FUNCTION:LINE": tests}} of a file of tests."""
    folder = tree.folder / "lines"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    _, report = tree.run([file], FILE, lines=folder, enough=PARAMETERS)
    seconds = {each["test"]: each["cpu"] for each in report if each["passed"]}
    found, functions = {}, {}
    for each in report:
        lines = folder / str(each["number"])
        if each["test"] not in seconds or not lines.exists():
            continue
        for line in set(lines.read_text(encoding="utf-8").split()):
            name, _, number = line.rpartition(":")
            if name not in functions:
                functions[name] = Functions((tree.folder / "tools/fixel" / name).read_text(encoding="utf-8"))
            place = functions[name].place(int(number))
            if place:
                found.setdefault(f"tools/fixel/{name}:{place[0]}:{place[1]}", []).append(each["test"])
    return {"seconds": seconds, "lines": {place: spread(tests, seconds)[:KEPT] for place, tests in found.items()}}


class Records:
    """The records of all files of tests."""

    def __init__(self, folder, checkout):
        self._folder, self._checkout, self._functions = pathlib.Path(folder), checkout, {}
        self.seconds, self._lines = {}, {}

    def _file(self, file):
        return self._folder / file.replace("/", "-").replace(".py", ".json")

    def _load(self, file, content):
        try:
            kept = json.loads(self._file(file).read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return False
        if kept["of"] != content:
            return False
        self.seconds.update(kept["seconds"])
        for place, tests in kept["lines"].items():
            self._lines.setdefault(place, []).extend(tests)
        return True

    def complete(self, make_trees):
        """Records the files of tests that have no record, or a record of other text. make_trees(): as many trees as
        work side by side."""
        wanted = {file: hashlib.sha256((self._checkout / "host_tests" / file).read_bytes()).hexdigest()
                  for file in files_of_tests(self._checkout)}
        missing = [file for file, content in wanted.items() if not self._load(file, content)]
        if not missing:
            return
        made, free = make_trees(), queue.SimpleQueue()
        for tree in made:
            free.put(tree)

        def work(file):
            tree = free.get()
            try:
                output.write_json(self._file(file), {"of": wanted[file], **record(tree, file)})
            finally:
                free.put(tree)
            self._load(file, wanted[file])

        with Progress("tests that execute each line", len(missing)) as progress, \
                concurrent.futures.ThreadPoolExecutor(len(made)) as pool:
            for done, future in enumerate(concurrent.futures.as_completed([pool.submit(work, file) for file in missing]), 1):
                future.result()
                progress(done)
        for tree in made:
            tree.close()

    def tests(self, mutant, text):
        """The tests that execute a mutant's line, the quickest first; then others that execute its function. text: of the
        file as it is."""
        if mutant.file not in self._functions:
            self._functions[mutant.file] = Functions(text)
        place = self._functions[mutant.file].place(mutant.line)
        if place is None:
            return []
        found = []
        for line in dict.fromkeys((place[1], 0)):
            tests = set(self._lines.get(f"{mutant.file}:{place[0]}:{line}", [])) - set(found)
            found += spread(tests, self.seconds)
        return found
