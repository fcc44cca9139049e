# SPDX-License-Identifier: MIT
"""Whether the tests of a clause fail when the clause is broken, for fixel trace --break.

A clause is broken by a seeded bug that names it; where there is none that the unit tests of the host can see, by mutants
of the lines that are tagged with it. Only the unit tests tagged with it run: a main() of their own calls them and no
other test of their file. The clause is shown if one of its seeded bugs is caught, or four of five mutants; if fewer of
the first five are killed, eight of ten. A mutant that does not compile, or that leaves the machine code as it was, or
that host_tests/build/survivors.toml has, is not counted.

Each is tried in a copy of the sources below the build folder: the changed sources are compiled, and linked before the
library that make has built for the unit tests. The clauses are a campaign (fixel/campaign/shards.py): each is a shard, and a process
breaks its clauses in a copy of the sources of its own.
"""

import contextlib
import dataclasses
import functools
import pathlib
import shlex
import shutil

from fixel.base import scratch
from fixel.base.errors import ToolError
from fixel.campaign import runner
from fixel.campaign.shards import Shard
from fixel.check import library_mutants, mutants, mutate, planting, trace

MAIN = """#include "unity.h"
__attribute__((weak)) void setUp(void);
__attribute__((weak)) void tearDown(void);
__attribute__((weak)) void setUp(void) {}
__attribute__((weak)) void tearDown(void) {}
%s
int main(void)
{
    UnityBegin("%s");
%s
    return UnityEnd();
}
"""
UNITS = "host_tests/unit/"
COPIED = ("lib", "boards", "host_tests/unit")
NEEDED = ((5, 4), (10, 8))      # so many mutants tried, so many of them killed
MOST = 30                       # mutants that are looked at
CPU_LEAST, CPU_TIMES = 5.0, 10  # a test's limit of CPU time: so many times what it takes, at least
SHARD_SETUP = "units"
_copies = contextlib.ExitStack()        # of this process


class Tree(library_mutants.Tree):
    """A copy of the sources. Objects of what is changed come before the library of the unit tests."""

    def __init__(self, folder, compiler, units, checkout):
        super().__init__(folder, compiler)
        self.compiler.remove("-fPIC")
        # Without sanitizers, in a third of the time: a test must see the mistake by itself.
        self.changed = shlex.split(library_mutants.PLAIN.sub("", compiler)) + ["-w", "-O1"]
        self.units = units
        self._symbols = {}
        shutil.rmtree(folder, ignore_errors=True)
        for name in COPIED:
            shutil.copytree(checkout / name, folder / name)

    def compile(self, source):
        to = self.object(source)
        to.parent.mkdir(parents=True, exist_ok=True)
        return self.run([*self.changed, "-c", source, "-o", to])

    def dependents(self, file):
        if file.endswith(".c"):
            return [pathlib.Path(file)]
        return [source for source in self.sources() if self._notes(source).exists() and
                mutate.includes(self._notes(source), self.folder, file)]

    def _notes(self, source):
        return self.units / source.with_suffix(".d")

    def linked(self, sources, suites):
        """Those of the sources that the programs of some suites link."""
        names = set().union(*(self._names(self.units / suite.name) for suite in suites))
        return [source for source in sources if self._names(self.units / source.with_suffix(".o")) & names]

    def _names(self, file):
        if file not in self._symbols:
            self._symbols[file] = library_mutants.symbols(file)
        return self._symbols[file]

    def built(self, name, suffix):
        return self.units / f"{name}{suffix}"

    def link_test(self, main, test, changed, to):
        """What was wrong with a program of a test's object, of changed objects and of the library."""
        rest = [self.units / name for name in ("unity.o", "assert.o", "libhelpers.a", "libfixel.a", "libparts.a")]
        return self.run([*self.compiler, main, test, *changed, *rest, "-lm", "-o", to])


class Suite:
    """The tagged tests of a file of unit tests."""

    def __init__(self, file, tests):
        self.file, self.name, self.tests = file, pathlib.PurePath(file).stem, sorted(set(tests))
        self.seconds = 0.0

    def main(self, tree):
        """The object of their main()."""
        source = tree.folder / f"{self.name}_tagged.c"
        declared = "\n".join(f"void {test}(void);" for test in self.tests)
        calls = "\n".join(f'    UnityDefaultTestRun({test}, "{test}", 0);' for test in self.tests)
        source.write_text(MAIN % (declared, self.name, calls), encoding="utf-8")
        said = tree.run([*tree.compiler, "-c", source.name, "-o", source.with_suffix(".o").name])
        if said:
            raise ToolError(f"the main() of {self.file}'s tests does not compile", words=said)
        return source.with_suffix(".o")

    def fails(self, tree, changed, file, cpu):
        """None if the tests pass with changed objects, else their first words of failure."""
        test = tree.built(self.name, ".o")
        notes = tree.built(self.name, ".d")
        if file.endswith(".h") and mutate.includes(notes, tree.folder, file):
            test = tree.folder / f"{self.name}.o"
            said = tree.run([*tree.compiler, "-c", self.file, "-o", test.name])
            if said:
                return None     # as a mutant that does not compile: it shows nothing
        program = tree.folder / self.name
        said = tree.link_test(tree.folder / f"{self.name}_tagged.o", test, changed, program)
        if said:
            raise ToolError(f"{self.file}: its tagged tests cannot be linked", words=said)
        return library_mutants.run_test(tree, library_mutants.Test(program, ()), program, cpu)


def suites_of(tests):
    """The tagged tests that run on the host, by file."""
    files = {}
    for tag in tests:
        if tag.file.startswith(UNITS):
            files.setdefault(tag.file, []).append(tag.test)
    return [Suite(file, names) for file, names in sorted(files.items())]


def tagged_mutants(folder, code):
    """[(key, mutant)] of the lines of tags, in an order that a change of one line does not change."""
    lines = {}
    for tag in code:
        path = pathlib.PurePath(tag.file)
        if tag.file.startswith("lib/") and path.suffix in (".c", ".h") and not library_mutants.KEPT.search(tag.file):
            lines.setdefault(tag.file, set()).update(range(tag.line, tag.last + 1))
    found = []
    for file, wanted in lines.items():
        text = (folder / file).read_text(encoding="utf-8")
        found += [(key, mutant) for key, mutant in mutate.keyed(mutate.mutants(file, text), text) if mutant.line in wanted]
    return sorted(found, key=lambda pair: mutate.place_of("trace", pair[0]))


class Breaker:
    """Tries clauses in one tree."""

    def __init__(self, tree, known):
        self._tree, self._known = tree, known

    def try_change(self, change, suites):
        """{"change", "result", "by"} of a bug or mutant; afterwards the tree is as it was."""
        tree, changed = self._tree, []
        with planting.planted(tree.folder, [change]):
            sources = tree.linked(tree.dependents(change.file), suites)
            for source in sources:
                if tree.compile(source):
                    return {"change": str(change), "result": "does not compile"}
                changed.append(tree.object(source))
            for suite in suites:
                words = suite.fails(tree, changed, change.file, CPU_LEAST + CPU_TIMES * suite.seconds)
                if words:
                    return {"change": str(change), "result": "killed", "by": f"{suite.name}: {words}"}
            if not isinstance(change, mutate.Mutant):
                return {"change": str(change), "result": "survived"}
            codes = [tree.machine_code(source) for source in sources]
        same = codes == [tree.machine_code(source) for source in sources]
        return {"change": str(change), "result": "same machine code" if same else "survived"}

    def check(self, id_, suites):
        """Demands that the tests pass as they are, and notes what they take."""
        for suite in suites:
            suite.main(self._tree)
            words = suite.fails(self._tree, [], "", 60.0)
            if words:
                raise ToolError(f"{id_}: {suite.file} fails though nothing is broken: {words}", exit_code=1)

    def clause(self, id_, code, suites, bugs):
        """What breaking a clause shows."""
        self.check(id_, suites)
        tried = []
        for bug in bugs:
            tried.append(self.try_change(bug, suites))
            if tried[-1]["result"] == "killed":
                return {"clause": id_, "shown": True, "by": tried[-1]["change"], "tried": tried}
        mutants = [mutant for key, mutant in tagged_mutants(self._tree.folder, code) if key[:3] not in self._known]
        counted = killed = 0
        for mutant in mutants[:MOST]:
            tried.append(self.try_change(mutant, suites))
            counted += tried[-1]["result"] in ("killed", "survived")
            killed += tried[-1]["result"] == "killed"
            if (counted, killed) in [(tries, least) for tries, most in NEEDED for least in range(most, tries + 1)]:
                return {"clause": id_, "shown": True, "by": f"{killed} of {counted} mutants", "tried": tried}
            if counted == NEEDED[-1][0] or counted - killed > NEEDED[-1][0] - NEEDED[-1][1]:
                break
        return {"clause": id_, "shown": False, "by": f"{killed} of {counted} mutants killed", "tried": tried}


def is_seen_here(bug):
    """Whether a bug is in code of the host: those of other cores are only seen by comparisons of kernels, and by unit tests on boards."""
    return bug.file.endswith((".c", ".h")) and not library_mutants.KEPT.search(bug.file) and \
        not (bug.tests and all(test.startswith(("equality/", "m3/")) for test in bug.tests))


def inputs(id_, code, suites, bugs, checkout, units, compiler):
    """All that the result of a clause depends on."""
    files = sorted({tag.file for tag in code} | {bug.file for bug in bugs})
    return [id_, compiler, [(tag.file, tag.line, tag.last) for tag in code], [dataclasses.astuple(bug) for bug in bugs],
            [(suite.name, suite.tests) for suite in suites], *(checkout / file for file in files),
            *(units / suite.name for suite in suites), pathlib.Path(__file__)]


@functools.cache
def _rows():
    """The rows of the checkout's trace."""
    return trace.join(*trace.read(trace.CHECKOUT))


@functools.cache
def _breaker(build, units, compiler):
    folder = _copies.enter_context(scratch.folder("trace", build))
    known = mutate.load(trace.CHECKOUT / trace.SURVIVORS, trace.CHECKOUT, mutants.mutants_of)
    return Breaker(Tree(folder / "tree", shlex.join(shlex.split(compiler)), pathlib.Path(units).resolve(),
                                                trace.CHECKOUT), known)


def _parts(parameters):
    """(the row of a clause, the tests that run, the seeded bugs that they can see)."""
    row = _rows()[parameters["clause"]]
    return row, suites_of(row["tests"]), list(filter(is_seen_here, row["bugs"]))


def run_shard(build, parameters):
    """What breaking a clause shows."""
    row, suites, bugs = _parts(parameters)
    if not suites:
        return {"clause": row["id"], "shown": False, "by": "no unit test of the host has it", "tried": []}
    return _breaker(build.resolve(), parameters["units"], parameters["compiler"]).clause(row["id"], row["code"], suites, bugs)


def shard_inputs(_build, parameters):
    row, suites, bugs = _parts(parameters)
    return inputs(row["id"], row["code"], suites, bugs, trace.CHECKOUT, pathlib.Path(parameters["units"]).resolve(),
                  parameters["compiler"])


def shard_targets(_build, parameters):
    return [f"{parameters['units']}/{suite.name}" for suite in _parts(parameters)[1]]


def break_all(rows, options):
    """What breaking each of the rows gave, in their order."""
    some = [Shard("trace", number, {"clause": row["id"], "units": options.units, "compiler": options.cc}, "clause", 0)
            for number, row in enumerate(rows)]
    done = runner.run("clauses broken", some, options)
    done.tell(options.build)
    return runner.whole(done)
