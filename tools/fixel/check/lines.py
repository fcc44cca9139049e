# SPDX-License-Identifier: MIT
"""Which tests for pytest execute a line of the tools, as a recorded run of each file of tests has shown.

A record is kept below the build folder. Where a function of tests changes, only its tests are recorded again. A record
counts the lines of a function of the tools from where the function begins, so that it stays true where another function
changes. A record that is out of date costs time or lets a mutant survive; it never makes one look killed, because a test
that kills must pass without the mutant.
"""

import ast
import concurrent.futures
import functools
import hashlib
import json
import pathlib
import queue
import re
import shutil

from fixel.base import output
from fixel.base.progress import Progress

RUN, RUNS = 6.0, 6  # CPU seconds of a run of a file of tests, and runs; what did not end in them is not known
PARAMETERS = 1.0    # CPU seconds for the parameters of a test; its later ones are taken for like the slowest of these
KEPT = 30           # tests for a line
FUNCTION = ast.FunctionDef, ast.AsyncFunctionDef


class Functions:
    """The outermost functions of a file, by the lines."""

    def __init__(self, text):
        self._found = []
        self._collect(ast.parse(text), "")

    def _collect(self, node, name):
        for each in ast.iter_child_nodes(node):
            if isinstance(each, FUNCTION):
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


def words_of(file):
    """The words of a file's path."""
    return set(re.split(r"[/_.]", file))


def spread(tests, file=""):
    """Tests in an order in which the later parameters of each stand behind the earlier ones of all. Those whose file has more
    words of a tool's file come first."""
    words, place, before = words_of(file), {}, {}
    for test in sorted(tests):
        function = test.partition("[")[0]
        place[test] = before.get(function, 0)
        before[function] = place[test] + 1
    return sorted(place, key=lambda test: (-len(words & words_of(test.partition("::")[0])), place[test], test))


def files_of_tests(checkout):
    """The files of tests for pytest, from host_tests on."""
    folder = checkout / "host_tests"
    return sorted(file.relative_to(folder).as_posix() for file in folder.glob("*/test_*.py"))


def functions_of(text):
    """{name: hash of its text} of the functions of a file of tests."""
    return {node.name: hashlib.sha256(ast.unparse(node).encode()).hexdigest()
            for node in ast.parse(text).body if isinstance(node, FUNCTION) and node.name.startswith("test")}


def arguments_of(text):
    """{name: its arguments} of the functions of a file of tests: parameters and fixtures."""
    return {node.name: [each.arg for each in node.args.args] for node in ast.parse(text).body if isinstance(node, FUNCTION)}


def function_of(test):
    """The name of a test's function."""
    return test.partition("[")[0].rpartition("::")[2]


def observe(tree, file, names):
    """(the places of each test of functions that passed, parameters that were skipped) of a file of tests. A
    run that takes too long is ended, and the next one begins with the function in which that was, or behind it if the run
    began with it. If it was in a fixture, no function with this fixture is tried again."""
    folder, uses = tree.folder / "lines", arguments_of((tree.folder / "host_tests" / file).read_text(encoding="utf-8"))
    read = functools.cache(lambda name: Functions((tree.folder / "tools/fixel" / name).read_text(encoding="utf-8")))
    places, skipped = {}, []
    for _ in range(RUNS):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        code, report = tree.run([f"{file}::{name}" for name in names], RUN, lines=folder, enough=PARAMETERS)
        for each in report:
            if each["passed"]:
                places[each["test"]] = places_of(folder / str(each["number"]), read)
        skipped += [each["test"] for each in report if each["skipped"]]
        if not isinstance(code, str) or not (folder / "begun").exists():
            break
        begun, _, fixture = (folder / "begun").read_text(encoding="utf-8").partition("\n")
        names = [name for name in names[names.index(function_of(begun)) or 1:] if fixture not in uses[name]]
        if not names:
            break
    return places, skipped


def record(tree, file, names):
    """{"tests": those that are known, "lines": {"FILE:FUNCTION:LINE": tests}} of functions of a file of tests."""
    places, skipped = observe(tree, file, names)
    like = {}
    for test in places:
        like.setdefault(function_of(test), []).append(test)
    for test in skipped:
        others = like.get(function_of(test), [])
        if others:
            places[test] = set().union(*(places[other] for other in others))
    found = {}
    for test in places:
        for place in places[test]:
            found.setdefault(place, []).append(test)
    return {"tests": sorted(places), "lines": {place: spread(tests)[:KEPT] for place, tests in found.items()}}


def places_of(file, read):
    """{"FILE:FUNCTION:LINE"} of what a test executed. read(name): the functions of a file of the tools."""
    lines = set(file.read_text(encoding="utf-8").split()) if file.exists() else set()
    found = set()
    for name, _, line in (each.rpartition(":") for each in lines):
        place = read(name).place(int(line))
        if place:
            found.add(f"tools/fixel/{name}:{place[0]}:{place[1]}")
    return found


class Records:
    """The records of all files of tests."""

    def __init__(self, folder, checkout):
        self._folder, self._checkout, self._functions = pathlib.Path(folder), checkout, {}
        self._lines = {}

    def _file(self, file):
        return self._folder / file.replace("/", "-").replace(".py", ".json")

    def _load(self, file, wanted):
        """What is recorded of a file of tests, without functions whose text is not the wanted one."""
        try:
            kept = json.loads(self._file(file).read_text(encoding="utf-8"))
            of = {name: content for name, content in kept["of"].items() if wanted.get(name) == content}
            known = {test for test in kept["tests"] if function_of(test) in of}
        except (OSError, ValueError, AttributeError, KeyError):     # none, or one of another version
            return {"of": {}, "tests": set(), "lines": {}}
        lines = {place: [test for test in tests if test in known] for place, tests in kept["lines"].items()}
        return {"of": of, "tests": known, "lines": lines}

    def _take(self, record):
        for place, tests in record["lines"].items():
            self._lines.setdefault(place, []).extend(tests)

    def complete(self, make_trees):
        """Records the functions of tests that have no record, or a record of other text. make_trees(): as many trees as
        work side by side."""
        wanted = {file: functions_of((self._checkout / "host_tests" / file).read_text(encoding="utf-8"))
                  for file in files_of_tests(self._checkout)}
        kept = {file: self._load(file, of) for file, of in wanted.items()}
        for each in kept.values():
            self._take(each)
        missing = [file for file, of in wanted.items() if kept[file]["of"] != of]
        if missing:
            self._record(missing, wanted, kept, make_trees())

    def _record(self, missing, wanted, kept, made):
        """Records what is missing of files of tests, in trees that work side by side."""
        free = queue.SimpleQueue()
        for tree in made:
            tree.record()
            free.put(tree)

        def work(file):
            tree, old = free.get(), kept[file]
            try:
                new = record(tree, file, [name for name in wanted[file] if name not in old["of"]])
            finally:
                free.put(tree)
            lines = {place: old["lines"].get(place, []) + new["lines"].get(place, [])
                     for place in {*old["lines"], *new["lines"]}}
            output.write_json(self._file(file), {"of": wanted[file], "tests": sorted({*old["tests"], *new["tests"]}),
                                                 "lines": lines})
            self._take(new)

        with Progress("tests that execute each line", len(missing)) as progress, \
                concurrent.futures.ThreadPoolExecutor(len(made)) as pool:
            for done, future in enumerate(concurrent.futures.as_completed([pool.submit(work, file) for file in missing]), 1):
                future.result()
                progress(done)
        for tree in made:
            tree.close()

    def place(self, mutant, text):
        """(the function of a mutant, which of its lines), or None. text: of the file as it is."""
        if mutant.file not in self._functions:
            self._functions[mutant.file] = Functions(text)
        return self._functions[mutant.file].place(mutant.line)

    def tests(self, mutant, text):
        """The tests that execute a mutant's line; then others that execute its function."""
        place = self.place(mutant, text)
        if place is None:
            return []
        found = []
        for line in dict.fromkeys((place[1], 0)):
            tests = set(self._lines.get(f"{mutant.file}:{place[0]}:{line}", [])) - set(found)
            found += spread(tests, mutant.file)
        return found
