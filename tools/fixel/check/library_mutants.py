# SPDX-License-Identifier: MIT
"""Mutants of the library: in copies of its sources below the build folder, tried with the unit tests of the host and with
a replay of the fuzzer's corpus, whose answers must be those on record. Each is a shard (fixel/campaign/shards.py).

One that no compiler takes, or that leaves the machine code as it was, is no mistake and is not counted. mutate.py says
which mistakes there are. The library of each is a shared object, so that only the mutated sources are compiled, and no
test but those that include a mutated header. A test is run where the program that make links of it holds the mutated
source. The tests of SLOW are left out. Nothing that is measured decides what is run.

A process has a copy of its own (Trial). What all copies are made of is built once, by the first process that needs it.
"""

import concurrent.futures
import contextlib
import dataclasses
import fcntl
import functools
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess

from fixel.base import children, kept, limits, scratch
from fixel.base.errors import ToolError
from fixel.check import corpus, fuzz, mutate, planting

NAME, CAMPAIGN = "library", "library-mutants"
CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
ROOMS = "lib/*/*.[ch]"
# What is not mutated: what is of one family of cores, or chooses a family, and the public headers.
KEPT = re.compile(r"_(?:armv6m|armv7m|mve)\.|/(?:family|offsets)\.|^lib/include/")
COPIED = ("lib", "boards", "host_tests/unit")
UNITS = "host_tests/unit"
LIBRARY = "libmutant.so"
SLOW = ("test_watertight", "test_watertight_clippers")  # they take more than 5 seconds of CPU time
LAST = ("test_sequences", "test_corner_colours", "test_surface_light")  # they take more than 1 second
CPU, CPU_LAST = 20.0, 60.0      # a test's limit of CPU time; of LAST
PLAIN = re.compile(r"-fsanitize=\S+|-fno-sanitize-recover=\S+|-M\w+|-g\b|-W\S+|-O\d")

SHARD_SETUP = "units"
_held = contextlib.ExitStack()      # copies and locks of this process


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


def make_tree(folder, compiler):
    """A tree whose library is built as it is."""
    for name in COPIED:
        shutil.copytree(CHECKOUT / name, folder / name)
    tree = Tree(folder, compiler)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        said = [each for each in pool.map(tree.compile, tree.sources()) if each] or [tree.link()]
    if said[0]:
        raise ToolError("the library does not build", words=said[0])
    return tree


def link_test(tree, objects, to):
    """A test with the library as a shared object that is found when it starts; what was wrong, if it was."""
    return tree.run([*tree.compiler, *objects, tree.folder / LIBRARY, "-lm", "-o", to])


def make_base(folder, compiler, tests):
    """Fills a folder with what the trees of all processes have in common: a tree, the tests linked with its library, with
    which they pass, and names.json, the global names of each test."""
    tree = make_tree(folder / "tree", compiler)
    (folder / "tests").mkdir()

    def check(test):
        program = folder / "tests" / test.name
        said = link_test(tree, test.objects, program)
        if said:
            raise ToolError(f"{test.name} cannot be linked", words=said)
        words = run_test(tree, test, program, cpu_of(test))
        if words:
            raise ToolError(f"{test.name} fails without a mutant: {words}", exit_code=1)
        return test.name, sorted(symbols(test.program))

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        (folder / "names.json").write_text(json.dumps(dict(pool.map(check, tests))), encoding="utf-8")


def hold(folder, make):
    """A folder that make(new folder) has filled, by one process for all. It stays while a process that has it lives; another
    one of its kind goes when nobody has it."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    lock = _held.enter_context(open(folder.with_suffix(".lock"), "ab"))
    fcntl.flock(lock, fcntl.LOCK_SH)
    # Not by an exclusive lock of the same file: who waited for that would wait for the end of whoever was first.
    with open(folder.parent / f"{NAME}.making", "ab") as making:
        fcntl.flock(making, fcntl.LOCK_EX)
        if not folder.exists():
            _remove_others(folder)
            with scratch.folder("mutants", folder.parent) as new:
                make(new)
                new.rename(folder)


def _remove_others(folder):
    for path in folder.parent.glob(f"{NAME}-*.lock"):
        with open(path, "ab") as lock, contextlib.suppress(BlockingIOError):
            if path != folder.with_suffix(".lock"):
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                shutil.rmtree(path.with_suffix(""), ignore_errors=True)


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


def cpu_of(test):
    """The CPU time that a test may take."""
    return CPU_LAST if test.name in LAST else CPU


def run_test(tree, test, program, cpu):
    """None if a test passes with a tree's library, else its first words of failure. It runs at the same addresses each time
    where the system allows that: a mutant may read what nobody has written."""
    paths = {"PATH": os.defpath, "LD_LIBRARY_PATH": str(tree.folder), "UBSAN_OPTIONS": "print_stacktrace=0"}
    try:
        done = limits.run([*fuzz.prefix(), str(program), *test.arguments], cpu, merge=True, text=True,
                          cwd=tree.folder, env=paths)
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


def likely_first(file, tests, names, linked, including):
    """The tests that include the file or link one of the names: those with a word of its name first, then quick ones."""
    words = set(pathlib.Path(file).stem.split("_"))
    return sorted((test for test in tests if not names or test in including or not names.isdisjoint(linked[test.name])),
                  key=lambda test: (-len(words & set(test.name.split("_"))), test.name in LAST, test.name))


def no_mutant(tree, sources, mutant):
    """None if a mutant may be tried; else why not: as a rule its machine code is what it was."""
    same = True
    for source in sources:
        before = tree.machine_code(source)
        with planting.planted(tree.folder, [mutant]):
            after = tree.machine_code(source)
        if after is None:
            return "does not compile"
        same = same and before == after
    return "same machine code" if same else None


def build_mutant(tree, sources):
    """None if the library of a mutated tree is built; else why not."""
    if any(tree.compile(source) for source in sources):
        return "does not compile"
    return "does not link" if tree.link() else None


def try_mutant(tree, mutant, tests, linked):
    """{"result"} of a mutant, with "words" if it is none; afterwards the tree is as it was. tests: {test: its program}."""
    sources = tree.dependents(mutant.file)
    kept = {tree.object(source): tree.object(source).read_bytes() for source in sources}
    names = set().union(*map(symbols, kept))
    said = no_mutant(tree, sources, mutant) if sources else "not compiled"
    if said:
        return {"result": "no mutant", "words": said}
    try:
        with planting.planted(tree.folder, [mutant]):
            said = build_mutant(tree, sources)
            if said:
                return {"result": "no mutant", "words": said}
            including = build_including(tree, tests, mutant.file)
            for test in likely_first(mutant.file, tests, names, linked, including):
                if run_test(tree, test, including.get(test, tests[test]), cpu_of(test)):
                    return {"result": "killed"}
            return {"result": "survived"}
    finally:
        for place, content in kept.items():
            place.write_bytes(content)


def files(checkout):
    """The files that mutants are made of."""
    return sorted(path for path in checkout.glob(ROOMS) if KEPT.search(path.relative_to(checkout).as_posix()) is None)


def unit_programs(settings):
    """The unit tests that make builds, without the slow ones."""
    sources = sorted((CHECKOUT / UNITS).glob("test_*.c"))
    return [pathlib.Path(settings["units"]) / source.stem for source in sources if source.stem not in SLOW]


class Trial:
    """Tries mutants, in a tree of its own."""

    def __init__(self, folder, build, settings):
        tests = [*map(unit_test, unit_programs(settings)), *(replay(folder / "inputs", *each) for each in settings["replays"])]
        base = build / "mutants" / f"{NAME}-{kept.key_of(inputs_of(settings))[:16]}"
        hold(base, lambda new: make_base(new, settings["compiler"], tests))
        shutil.copytree(base / "tree", folder / "tree")
        self._tree = Tree(folder / "tree", settings["compiler"])
        self._tests = {test: base / "tests" / test.name for test in tests}
        self._linked = json.loads((base / "names.json").read_text(encoding="utf-8"))

    def run(self, mutant):
        return try_mutant(self._tree, mutant, self._tests, self._linked)


@functools.cache
def _trial(build, settings):
    folder = _held.enter_context(scratch.folder("mutants", build))
    return Trial(folder, build, json.loads(settings))


@functools.cache
def _copied():
    """The files that a tree has."""
    return sorted(path for name in COPIED for path in (CHECKOUT / name).rglob("*") if path.is_file())


def inputs_of(settings):
    """What the result of each mutant depends on."""
    replays = [pathlib.Path(file) for each in settings["replays"] for file in each]
    return [settings["compiler"], *_copied(), *unit_programs(settings), *replays, pathlib.Path(__file__)]


def run_shard(build, parameters):
    mutant = mutate.find(CHECKOUT, parameters["mutant"], mutate.mutants)
    return _trial(build.resolve(), json.dumps(parameters["settings"], sort_keys=True)).run(mutant)


def shard_inputs(_build, parameters):
    return inputs_of(parameters["settings"])


def shard_targets(_build, parameters):
    return [*map(str, unit_programs(parameters["settings"])), *(each[0] for each in parameters["settings"]["replays"])]


class Plan:
    """The parameters of the shards."""

    def __init__(self, options):
        self._settings = {"units": options.units, "compiler": options.cc, "replays": options.replay}

    @staticmethod
    def add_options(parser):
        parser.add_argument("--cc", help="the compiler and the flags of the unit tests")
        parser.add_argument("--units", help="the folder of the unit tests of the host")
        parser.add_argument("--replay", nargs="+", action="append", default=[], metavar=("PROGRAM", "RECORD"),
                            help="a program that replays a corpus, the record of its answers, the corpus's archive, its objects")

    def parameters(self, key, _mutant):
        """Of the shard of a mutant."""
        return {"mutant": key, "settings": self._settings}
