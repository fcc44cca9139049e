# SPDX-License-Identifier: MIT
"""Tests the unit tests: puts small mistakes into the library, drawn at random, one at a time.

    fixel mutants --seed N [--count N] [--only WORD] --cc "COMMAND" --tests PROGRAM...

A mutant is killed where a unit test of the host fails with it, or where a replay of the fuzzer's corpus has answers
that are not on record; it survives where all pass. One that no compiler takes, or that leaves the machine code as it
was, is no mistake and is not counted. fixel.check.mutate says which mistakes there are. Mutants are compiled and run in copies under --build, never in the checkout.
The library of each is a shared object, so that only the mutated sources are compiled, and no test but those
that include a mutated header. A test is run where the program that make links of it holds the mutated source.
Tests that take more than --slow seconds of CPU time are left out. Writes all mutants as JSON. Exit: 0 done,
1 a test fails without a mutant, or fewer than --least per cent were killed, 2 could not run.
"""

import argparse
import concurrent.futures
import dataclasses
import os
import pathlib
import queue
import random
import re
import shlex
import shutil
import subprocess
import sys
import threading
import time

from fixel.base import children, limits, output
from fixel.check import mutate
from fixel.base.errors import ToolError
from fixel.base.progress import Progress, steps

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
ROOMS = "lib/*/*.[ch]"
# What is not mutated: what is of one family of cores, or chooses a family, and the public headers.
KEPT = re.compile(r"_(?:armv6m|armv7m|mve)\.|/(?:family|offsets)\.|^lib/include/")
SOURCES = "lib"
LIBRARY = "libmutant.so"
CPU_WORDS = "of CPU time"           # of fixel.base.limits, where a test took too much
NICE = 3
CPU_LEAST, CPU_TIMES = 5.0, 10      # a test's limit of CPU time: so many times what it takes, at least
PLAIN = re.compile(r"-fsanitize=\S+|-fno-sanitize-recover=\S+|-M\w+|-g\b|-W\S+|-O\d")


@dataclasses.dataclass(frozen=True)
class Test:
    """A program that make builds: of its own objects, and of the library."""
    program: pathlib.Path
    objects: tuple
    arguments: tuple = ()
    source: str = ""        # that is compiled anew where it includes a mutated header

    @property
    def name(self):
        return self.program.name


def unit_test(program):
    """A Unity program."""
    program = pathlib.Path(program).resolve()
    shared = [f"{program.name}.o", f"{program.name}_main.o", "unity.o", "assert.o", "libhelpers.a", "libparts.a"]
    return Test(program, tuple(map(program.with_name, shared)), (), f"host_tests/unit/{program.name}.c")


def replay(program, record, corpus, *objects):
    """A replay of a corpus, compared with its record."""
    files = sorted(str(file) for file in pathlib.Path(corpus).resolve().iterdir())
    return Test(pathlib.Path(program).resolve(), tuple(pathlib.Path(each).resolve() for each in objects),
                ("--record", str(pathlib.Path(record).resolve()), *files))


class Tree:
    """A copy of the library's sources, their objects, and the shared object that the tests load."""

    def __init__(self, folder, compiler):
        self.folder = folder
        self.compiler = shlex.split(compiler) + ["-w", "-fPIC"]
        self.plain = shlex.split(PLAIN.sub("", compiler)) + ["-w", "-O2"]

    def sources(self):
        return sorted(path.relative_to(self.folder) for path in self.folder.glob("lib/*/*.c"))

    def run(self, command):
        """What a command said if it failed, else None."""
        done = children.run([str(part) for part in command], cwd=self.folder,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
        return (done.stdout or "failed") if done.returncode else None

    def compile(self, source):
        """The object that the tests use. -MMD of the compiler's flags leaves its headers beside it."""
        to = self.object(source)
        to.parent.mkdir(parents=True, exist_ok=True)
        return self.run([*self.compiler, "-c", source, "-o", to])

    def machine_code(self, source):
        """An object for comparison: optimised, without sanitizers, which note the columns of the source."""
        to = self.folder / "plain.o"
        return None if self.run([*self.plain, "-c", source, "-o", to]) else to.read_bytes()

    def object(self, source):
        return self.folder / "objects" / source.with_suffix(".o")

    def link(self):
        return self.run([*self.compiler, "-shared", f"-Wl,-soname,{LIBRARY}", *sorted((self.folder / "objects").rglob("*.o")), "-o", LIBRARY])

    def dependents(self, file):
        """The sources that a source or header goes into."""
        if file.endswith(".c"):
            return [pathlib.Path(file)]
        return [source for source in self.sources()
                if mutate.includes(self.object(source).with_suffix(".d"), self.folder, file)]


def make_trees(scratch, compiler, count):
    """So many trees whose libraries are built as they are."""
    shutil.rmtree(scratch / "0", ignore_errors=True)
    for name in (SOURCES, "boards", "host_tests/unit"):
        shutil.copytree(CHECKOUT / name, scratch / "0" / name)
    first = Tree(scratch / "0", compiler)
    with concurrent.futures.ThreadPoolExecutor(count) as pool:
        said = [each for each in pool.map(first.compile, first.sources()) if each] or [first.link()]
    if said[0]:
        raise ToolError("the library does not build", words=said[0])
    for number in range(1, count):
        shutil.rmtree(scratch / str(number), ignore_errors=True)
        shutil.copytree(scratch / "0", scratch / str(number))
    return [Tree(scratch / str(number), compiler) for number in range(max(1, count))]


def link_test(tree, objects, to):
    """A test with the library as a shared object that is found when it starts; what was wrong, if it was."""
    return tree.run([*tree.compiler, *objects, tree.folder / LIBRARY, "-lm", "-o", to])


def link_tests(tree, tests):
    """{test: its program with the shared library}."""
    folder = tree.folder.parent / "tests"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for test in tests:
        said = link_test(tree, test.objects, folder / test.name)
        if said:
            raise ToolError(f"{test.name} cannot be linked", words=said)
    return {test: folder / test.name for test in tests}


def build_including(tree, tests, file):
    """{test: its program} of those that include a mutated header; of none where that does not compile."""
    folder, built = tree.folder / "tests", {}
    folder.mkdir(exist_ok=True)
    for test in tests:
        if not file.endswith(".h") or not test.source or \
                not mutate.includes(test.program.with_name(f"{test.name}.d"), CHECKOUT, file):
            continue
        to = folder / test.name
        anew = to.with_suffix(".o")
        if tree.run([*tree.compiler, "-c", test.source, "-o", anew]) or link_test(tree, (anew, *test.objects[1:]), to):
            continue
        built[test] = to
    return built


def run_test(tree, test, program, cpu):
    """None if a test passes with a tree's library, else its first words of failure."""
    paths = {**os.environ, "LD_LIBRARY_PATH": str(tree.folder), "UBSAN_OPTIONS": "print_stacktrace=0"}
    try:
        done = limits.run([str(program), *test.arguments], cpu, merge=True, text=True, cwd=tree.folder, env=paths)
    except limits.LimitError as error:
        return str(error)
    if done.returncode == 0:
        return None
    return next((line for line in done.stdout.splitlines() if ":FAIL" in line or "rror:" in line or "does not hold" in line),
                f"ended with {done.returncode}")


def symbols(file):
    """The global names that an object or a program defines."""
    done = children.run(["nm", "-g", "--defined-only", str(file)], text=True)
    done.check_returncode()
    return {line.split()[-1] for line in done.stdout.splitlines() if line}


def time_tests(tree, tests, slow):
    """{test: seconds of CPU time} of the library as it is, without tests that take more than slow seconds."""
    seconds = {}
    for test in steps("tests as they are", sorted(tests, key=lambda test: test.name)):
        before = os.times()
        words = run_test(tree, test, tests[test], slow)
        if words and CPU_WORDS in words:
            continue
        if words:
            raise ToolError(f"{test.name} fails without a mutant: {words}", exit_code=1)
        after = os.times()
        seconds[test] = after.children_user + after.children_system - before.children_user - before.children_system
    return seconds


def likely_first(file, seconds, names, linked, including):
    """The tests that include the file or link one of the names: those with a word of its name first, then quick ones."""
    words = set(pathlib.Path(file).stem.split("_"))
    return sorted((test for test in seconds if not names or test in including or names & linked[test.name]),
                  key=lambda test: (-len(words & set(test.name.split("_"))), seconds[test]))


def build_mutant(tree, sources, text, good, file):
    """None if the mutated tree may be tried; else why not: as a rule its machine code is what it was."""
    same = True
    for source in sources:
        file.write_text(good, encoding="utf-8")
        before = tree.machine_code(source)
        file.write_text(text, encoding="utf-8")
        after = tree.machine_code(source)
        if after is None:
            return "does not compile"
        same = same and before == after
    if same:
        return "same machine code"
    for source in sources:
        said = tree.compile(source)
        if said:
            return said
    return tree.link()


def try_mutant(tree, mutant, tests, seconds, linked):
    """{"result", "by", "words"} of a mutant; afterwards the tree is as it was."""
    file = tree.folder / mutant.file
    good = file.read_text(encoding="utf-8")
    sources = tree.dependents(mutant.file)
    kept = {tree.object(source): tree.object(source).read_bytes() for source in sources}
    names = set().union(*map(symbols, kept))
    try:
        said = build_mutant(tree, sources, mutant.apply(good), good, file) if sources else "not compiled"
        if said:
            return {"result": "no mutant", "words": said.strip().splitlines()[0]}
        including = build_including(tree, tests, mutant.file)
        for test in likely_first(mutant.file, seconds, names, linked, including):
            words = run_test(tree, test, including.get(test, tests[test]), max(CPU_LEAST, CPU_TIMES * seconds[test]))
            if words:
                return {"result": "killed", "by": test.name, "words": words}
        return {"result": "survived"}
    finally:
        file.write_text(good, encoding="utf-8")
        for place, content in kept.items():
            place.write_bytes(content)


def try_all(trees, drawn, count, tests, seconds, linked):
    """The first count mutants of those drawn that are any, in the order in which they were drawn."""
    free, results, lock, places = queue.SimpleQueue(), {}, threading.Lock(), iter(range(len(drawn)))
    for tree in trees:
        free.put(tree)

    def counted():
        return sum(result["result"] != "no mutant" for result in results.values())

    def work():
        tree = free.get()
        while True:
            with lock:
                place = next(places, None) if counted() < count else None
            if place is None:
                return
            result = try_mutant(tree, drawn[place], tests, seconds, linked)
            with lock:
                results[place] = result
                progress(min(counted(), count))
                if result["result"] == "survived":
                    print(f"survived: {drawn[place]}", file=sys.stderr, flush=True)

    with Progress("mutants", count) as progress, concurrent.futures.ThreadPoolExecutor(len(trees)) as pool:
        for future in [pool.submit(work) for _ in trees]:
            future.result()
    tried = [(drawn[place], results[place]) for place in sorted(results)]
    found = [pair for pair in tried if pair[1]["result"] != "no mutant"][:count]
    return found, len(tried) - counted()


def all_mutants(only):
    files = sorted(path.relative_to(CHECKOUT).as_posix() for path in CHECKOUT.glob(ROOMS))
    found = [mutant for file in files if KEPT.search(file) is None
             for mutant in mutate.mutants(file, (CHECKOUT / file).read_text(encoding="utf-8")) if only in mutant.file]
    if not found:
        raise ToolError(f"no file of the library has '{only}' in its name and a mutant")
    return found


def print_result(result):
    """For people."""
    for each in result["mutants"]:
        if each["result"] == "survived":
            print(f"survived: {each['mutant']}")
    print(f"{result['killed']} of {result['count']} mutants killed: {result['percent']:.1f} % "
          f"(seed {result['seed']}; {result['not_counted']} more were no mutants)")


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, required=True, help="of the choice of mutants")
    parser.add_argument("--count", type=int, default=200, help="so many mutants")
    parser.add_argument("--only", default="", help="only of files with this in their path")
    parser.add_argument("--slow", type=float, default=5.0, help="seconds; tests that take more are left out")
    parser.add_argument("--least", type=float, default=0.0, help="per cent that must be killed")
    parser.add_argument("--build", default="build", help="the build folder")
    parser.add_argument("--cc", required=True, help="the compiler and the flags of the unit tests")
    parser.add_argument("--tests", nargs="+", required=True, help="the unit tests of the host")
    parser.add_argument("--replay", nargs="+", action="append", default=[], metavar=("PROGRAM", "RECORD"),
                        help="a program that replays a corpus, the record of its answers, the corpus, its objects")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args(argv)
    os.nice(NICE)
    drawn = all_mutants(options.only)
    random.Random(options.seed).shuffle(drawn)
    scratch = pathlib.Path(options.build).resolve() / "mutants"
    print(f"mutants: {len(drawn)} to draw from; building the library", file=sys.stderr, flush=True)
    trees = make_trees(scratch, options.cc, options.jobs)
    tests = link_tests(trees[0], [*map(unit_test, options.tests), *(replay(*each) for each in options.replay)])
    seconds = time_tests(trees[0], tests, options.slow)
    linked = {test.name: symbols(test.program) for test in tests}
    started = time.monotonic()
    found, not_counted = try_all(trees, drawn, options.count, tests, seconds, linked)
    killed = sum(result["result"] == "killed" for _, result in found)
    result = {"seed": options.seed, "count": len(found), "killed": killed, "percent": 100 * killed / len(found),
              "not_counted": not_counted, "left_out": sorted(test.name for test in set(tests) - set(seconds)),
              "seconds": round(time.monotonic() - started),
              "mutants": [{"mutant": str(mutant), **result} for mutant, result in found]}
    output.write_json(scratch / f"seed-{options.seed}.json", result)
    print_result(result)
    return 1 if result["percent"] < options.least else 0
