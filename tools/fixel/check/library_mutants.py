# SPDX-License-Identifier: MIT
"""Mutants of the library: in copies of its sources below the build folder, tried with the unit tests of the host and with
a replay of the fuzzer's corpus, whose answers must be those on record.

One that no compiler takes, or that leaves the machine code as it was, is no mistake and is not counted. mutate.py says
which mistakes there are. The library of each is a shared object, so that only the mutated sources are compiled, and no
test but those that include a mutated header. A test is run where the program that make links of it holds the mutated
source. Tests that take more than --slow seconds of CPU time are left out.
"""

import concurrent.futures
import dataclasses
import os
import pathlib
import re
import shlex
import shutil
import subprocess

from fixel.base import children, limits
from fixel.base.errors import ToolError
from fixel.base.progress import steps
from fixel.check import corpus, mutate

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
ROOMS = "lib/*/*.[ch]"
# What is not mutated: what is of one family of cores, or chooses a family, and the public headers.
KEPT = re.compile(r"_(?:armv6m|armv7m|mve)\.|/(?:family|offsets)\.|^lib/include/")
SOURCES = "lib"
LIBRARY = "libmutant.so"
CPU_WORDS = "of CPU time"           # of fixel.base.limits, where a test took too much
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


def replay(folder, program, record, archive, *objects):
    """A replay of a corpus, whose inputs are written into the folder, compared with its record."""
    files = corpus.unpack(corpus.read(archive), folder.resolve() / pathlib.Path(archive).stem)
    return Test(pathlib.Path(program).resolve(), tuple(pathlib.Path(each).resolve() for each in objects),
                ("--record", str(pathlib.Path(record).resolve()), *map(str, files)))


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


class Library:
    """What mutants.py tries mutants of."""
    name = "library"

    def __init__(self, options, scratch, checkout):
        self._options, self._scratch, self._checkout = options, scratch / "library", checkout
        self._tests, self._seconds, self._linked = {}, {}, {}

    @staticmethod
    def add_options(parser):
        parser.add_argument("--slow", type=float, default=5.0, help="seconds; unit tests that take more are left out")
        parser.add_argument("--cc", help="the compiler and the flags of the unit tests")
        parser.add_argument("--tests", nargs="+", default=[], help="the unit tests of the host")
        parser.add_argument("--replay", nargs="+", action="append", default=[], metavar=("PROGRAM", "RECORD"),
                            help="a program that replays a corpus, the record of its answers, the corpus's archive, its objects")

    def files(self):
        """The files that mutants are made of."""
        return sorted(path for path in self._checkout.glob(ROOMS)
                      if KEPT.search(path.relative_to(self._checkout).as_posix()) is None)

    def prepare(self):
        """The copies in which mutants are tried."""
        options = self._options
        trees = make_trees(self._scratch, options.cc, options.jobs)
        self._tests = link_tests(trees[0], [*map(unit_test, options.tests), *self._replays()])
        self._seconds = time_tests(trees[0], self._tests, options.slow)
        self._linked = {test.name: symbols(test.program) for test in self._tests}
        return trees

    def _replays(self):
        return [replay(self._scratch / "inputs", *each) for each in self._options.replay]

    def run(self, tree, mutant):
        return try_mutant(tree, mutant, self._tests, self._seconds, self._linked)

    def left_out(self):
        """The tests that take too long."""
        return sorted(test.name for test in set(self._tests) - set(self._seconds))

    def close(self):
        pass
