# SPDX-License-Identifier: MIT
"""Breaks what the project claims, by a list that was written without reading the tests, and says which commands notice.

    fixel breaks --units DIR --cc COMMAND [--seed N] [--draw N | --only WORD] [--samples N] [--build DIR]

The entries of host_tests/breaks with blind = true are of four kinds. --seed draws the same number of each kind; with --only sentences it draws
sentences of clauses.txt that are no prose, and takes the breaks that name them: a sentence without one counts as not noticed. Each is made in a copy of
the checkout below DIR/breaks, and never in the checkout. The entry's command runs there in its narrowest form; if it
passes, the unit tests of the host, and then the proofs of the file. A break is noticed if a command fails and names what
the entry says. Writes DIR/breaks/breaks.json.

There is a copy for unit tests, one for proofs, and one for all else. In each a break is made at a time, in different ones side by
side. The last one is kept from one run to the next, with what make has built in it. make coverage and make rules look at the whole
library: the breaks of different files are made together, and each must be named for itself.
Exit: 0 nine of ten are noticed, 1 fewer, 2 could not run.
"""

import argparse
import concurrent.futures
import dataclasses
import filecmp
import functools
import hashlib
import os
import pathlib
import random
import shutil
import sys
import threading

from fixel.base import children, kept, output, spent
from fixel.base.errors import ToolError
from fixel.base.progress import Progress
from fixel.base.table import coloured, table
from fixel.check import clauses, planting, seeded_bugs, sentences, trace, trace_break
from fixel.prove import bugs as prove_bugs, provers, rows as prove_rows

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
ENOUGH = 0.9        # of the breaks must be noticed
NAMED, UNNAMED, PASSED = "failed and named", "failed, not named", "passed"
RESULTS = (NAMED, UNNAMED, PASSED)
COPIED = (*seeded_bugs.COPIED, "SPEC.md", "docs", "tools")
UNCOPIED = shutil.ignore_patterns("__pycache__", "corpus")
UNITS = "host_tests/unit/test_*.c"
COVERAGE = "build/host/coverage"
SECONDS = 12.0      # of CPU time that a file of unit tests may take as it is
TOGETHER = 10       # files of unit tests that are built before the first of them runs
WORDS = 300
SENTENCES = "sentences"     # of --only: draws these, not breaks
COPIES = ("units", "proofs", "checkout")
LAUNCHER = pathlib.Path(__file__).resolve().parents[1] / "launcher.py"


def blind(root):
    """The breaks that it draws from, by their ids: a seed draws the same ones wherever their lines move."""
    return sorted((each for each in planting.entries(root) if each.blind), key=lambda each: each.id)


def draw(breaks, seed, count):
    """So many breaks, the same number of each kind, or one more of the first kinds; all of a kind that has fewer."""
    drawn, kinds = [], list(planting.BLIND_KINDS)
    for place, kind in enumerate(kinds):
        those = [each for each in breaks if each.kind == kind]
        share = count // len(kinds) + (place < count % len(kinds))
        drawn += random.Random(f"{seed} {kind}").sample(those, min(share, len(those)))
    return drawn


def draw_sentences(root, seed, count):
    """So many sentences that are no prose, by their ids, in an order that a new sentence does not change."""
    _, said = clauses.recorded(root)
    ids = [clause + letter for clause, entries in said.items() for letter, state, _ in entries if state != sentences.PROSE]
    return sorted(ids, key=lambda id_: hashlib.sha256(f"{seed} {id_}".encode()).digest())[:count]


def of_sentences(root, breaks, drawn):
    """{id: breaks} of sentences: those that name it, or a claim of make report that has its tag."""
    claims = {}
    for tag in trace.shown_elsewhere(pathlib.Path(root), trace.pages_of(clauses.read(root))):
        claims.setdefault(tag.id, set()).add(tag.test.removeprefix("make report: "))
    return {id_: [each for each in breaks if each.names == id_ or
                  (each.command == "make report" and each.names in claims.get(id_, ()))] for id_ in drawn}


def try_break(each, commands):
    """The steps of a break: what each command gave, up to the one that fails and names it; at most one more fails."""
    steps = []
    for command in commands.of(each):
        steps.append(command(each))
        if steps[-1].result == NAMED:
            break
    return steps


def try_all(drawn, commands):
    """The rows of all breaks, in their order. Those whose commands run in different copies are tried side by side."""
    rows = {}

    def one_copy(name):
        for each in (each for each in drawn if commands.copy_of(each) == name):
            print(f"breaks: {each.id}: {each.why}", file=sys.stderr, flush=True)
            rows[each.id] = row(each, try_break(each, commands))
            progress(len(rows))

    with Progress("breaks", len(drawn)) as progress, concurrent.futures.ThreadPoolExecutor() as pool:
        list(pool.map(one_copy, COPIES))
    return [rows[each.id] for each in drawn]


def best(steps):
    """The result of a break, from those of its commands."""
    return min((step.result for step in steps), key=RESULTS.index, default=PASSED)


def row(each, steps):
    """A break as the JSON file has it."""
    return {"id": each.id, "kind": each.kind, "file": each.file, "what": each.why, "command": each.command, "names": each.names,
            "result": best(steps), "steps": [vars(step) for step in steps]}


def print_rows(rows, stale):
    """For people."""
    for words in stale:
        print(f"not drawn: {words}")
    red = {NAMED: "", UNNAMED: "yellow", PASSED: "red"}
    print(table([[each["id"], each["steps"][-1]["command"] if each["steps"] else each["command"], each["names"],
                  coloured(each["result"], red[each["result"]]) if red[each["result"]] else each["result"]] for each in rows],
                ["break", "command", "must name", "result"]))
    for each in rows:
        if each["result"] != NAMED:
            print(f"{each['id']}: {each['file']}: {each['what']}")
            for step in each["steps"]:
                print(f"  {step['command']}: {step['result']}{': ' if step['words'] else ''}{step['words']}")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--root", default=str(CHECKOUT), help="the checkout to copy from")
    made.add_argument("--build", default="build", help="the build folder")
    made.add_argument("--units", required=True, help="the folder of the unit tests that make has built")
    made.add_argument("--cc", required=True, help="the compiler and the flags of the unit tests")
    made.add_argument("--seed", default="1", help="draws the breaks (SEED=)")
    made.add_argument("--draw", type=int, default=20, help="how many (DRAW=)")
    made.add_argument("--only", default="", help="all breaks with this in their id, kind or file, and none drawn; "
                      f"{SENTENCES}: draws sentences (ONLY=)")
    made.add_argument("--samples", type=int, default=1_000_000, help="of make report (SAMPLES=)")
    made.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    return made


def before(options):
    """Refuses a word that no break has, and a number that draws none."""
    if options.only not in ("", SENTENCES) and not any(each.is_called(options.only) for each in blind(options.root)):
        raise ToolError(f"no break of {planting.FOLDER} has '{options.only}' in its id, kind or file")
    if options.draw < 1 or options.samples < 1:
        raise ToolError("DRAW= is less than 1" if options.draw < 1 else "SAMPLES= is less than 1")


def main(argv):
    options = parser().parse_args(argv)
    every = blind(options.root)
    stale = planting.stale(options.root, every)
    ready = [each for each in every if each.id not in stale]
    if options.only == SENTENCES:
        return try_sentences(options, ready)
    drawn = [each for each in ready if each.is_called(options.only)] if options.only else \
        draw(ready, options.seed, options.draw)
    if not drawn:
        raise ToolError(f"no break of {planting.FOLDER} has '{options.only}' in its id, kind or file" if options.only else
                        "DRAW= is less than 1")
    rows = try_all(drawn, Commands(options, drawn))
    noticed = sum(each["result"] == NAMED for each in rows)
    file = pathlib.Path(options.build) / "breaks/breaks.json"
    output.write_json(file, {"seed": options.seed, "only": options.only, "listed": len(every), "noticed": noticed,
                             "stale": list(stale.values()), "breaks": rows})
    print_rows(rows, stale.values())
    spent.tell()
    counts = ", ".join(f"{sum(each['result'] == result for each in rows)} {result}" for result in RESULTS)
    print(f"{noticed} of {len(rows)} breaks noticed ({counts}); of {len(every)} in the list {len(stale)} are stale; "
          f"{'' if options.only else f'seed {options.seed}; '}{file}")
    return 0 if noticed >= ENOUGH * len(rows) else 1


def try_sentences(options, ready):
    """Draws sentences and tries their breaks; only the command of a break counts, which for a sentence is its tagged tests."""
    named = of_sentences(options.root, ready, draw_sentences(options.root, options.seed, options.draw))
    drawn = list({each.id: each for breaks in named.values() for each in breaks}.values())
    rows = try_all(drawn, Commands(options, drawn))
    noticed_ids = {each["id"] for each in rows if each["result"] == NAMED}
    noticed = [id_ for id_, breaks in named.items() if any(each.id in noticed_ids for each in breaks)]
    print_rows(rows, [])
    spent.tell()
    without = [id_ for id_, breaks in named.items() if not breaks]
    print(f"without a break: {', '.join(without) or 'none'}")
    print(f"{len(noticed)} of {len(named)} sentences drawn are noticed when they are broken; seed {options.seed}")
    file = pathlib.Path(options.build) / "breaks/breaks.json"
    output.write_json(file, {"seed": options.seed, "only": options.only, "sentences": list(named), "noticed": len(noticed),
                             "without": without, "breaks": rows})
    return 0 if len(noticed) >= ENOUGH * len(named) else 1


@dataclasses.dataclass
class Step:
    """A command as a user types it, how it ended with a break, and its words on it."""
    command: str
    result: str
    words: str = ""


def refresh(root, folder):
    """Makes a copy like the checkout. Only files that differ are written, so that make builds no more than it must."""
    for name in COPIED:
        source, to = pathlib.Path(root) / name, folder / name
        for old in [each for each in to.rglob("*") if each.is_file() and not (source / each.relative_to(to)).exists()]:
            old.unlink()
        if source.is_dir():
            shutil.copytree(source, to, ignore=UNCOPIED, copy_function=_renew, dirs_exist_ok=True)
        elif source.exists():
            to.parent.mkdir(parents=True, exist_ok=True)
            _renew(source, to)


def _renew(source, to):
    if not (os.path.exists(to) and filecmp.cmp(source, to, shallow=False)):
        shutil.copy(source, to)


class Commands:
    """The commands for the breaks that were drawn."""

    def __init__(self, options, drawn):
        self._options, self._drawn, self._root = options, drawn, pathlib.Path(options.root).resolve()
        self._build = pathlib.Path(options.build).resolve()
        self._copy = self._build / "breaks/checkout"
        refresh(self._root, self._copy)
        self._locks = {name: threading.Lock() for name in COPIES}

    @staticmethod
    def copy_of(each):
        """The name of the copy in which the entry's own command runs."""
        return {"make test": "units", "make prove": "proofs"}.get(each.command, "checkout")

    def of(self, each):
        """The commands that are tried for a break, in their order."""
        first = {"make test": self.tagged_tests, "make prove": self.proofs, "make report": self.report, "make trace": self.trace,
                 "make coverage": self.coverage, "make rules": self.rules}[each.command]
        more = [("units", self.host_tests), ("proofs", self.proofs_of_file)] if each.file.startswith("lib/") else []
        return [functools.partial(self._alone, name, run) for name, run in ((self.copy_of(each), first), *more)]

    def _alone(self, name, run, each):
        with self._locks[name]:
            return run(each)

    # --- tests ---

    @functools.cached_property
    def _breaker(self):
        tree = trace_break.Tree(self._build / "breaks/units", self._options.cc, pathlib.Path(self._options.units).resolve(), self._root)
        return tree, trace_break.Breaker(tree, {})

    @functools.cached_property
    def _rows_of_trace(self):
        found, code, tests, seeded = trace.read(self._root)
        clauses.match_sentences(found, clauses.recorded(self._root)[1])
        return trace.join(found, code, tests, seeded)

    def _tagged(self, id_):
        """The tests that have the tag of a clause, or of a sentence."""
        row = self._rows_of_trace.get(clauses.clause_of(id_))
        if row is None or id_ == row["id"]:
            return row["tests"] if row else []
        return [tag for each in row["clause"].sentences if row["id"] + each.letter == id_ for tag in trace.tests_of(row, each)]

    @functools.cached_property
    def _every(self):
        """All tests of the host, by file."""
        return trace_break.suites_of([
            clauses.Tag("", path.relative_to(self._root).as_posix(), 0, 0, match[1]) for path in sorted(self._root.glob(UNITS))
            for match in map(clauses.C_TEST.match, path.read_text(encoding="utf-8").splitlines()) if match])

    def _try_suites(self, each, suites, is_named):
        """The step of some files of tests, of which the first that fails is named."""
        tree, breaker = self._breaker
        for suite in suites:
            suite.seconds = SECONDS
            suite.main(tree)
        tried = breaker.try_change(each, suites)
        command = "make test BOARD=host ONLY=" + (tried["by"].split(":")[0] if "by" in tried else suites[0].name if len(suites) == 1 else "host/")
        if tried["result"] == "killed":
            return Step(command, NAMED if is_named else UNNAMED, tried["by"])
        return Step(command, PASSED, "" if tried["result"] == "survived" else tried["result"])

    def tagged_tests(self, each):
        """The tests that have the tag of the clause or sentence."""
        suites = trace_break.suites_of(self._tagged(each.names))
        if not suites:
            return Step("make test", PASSED, f"no unit test of the host has the tag {each.names}")
        return self._try_suites(each, suites, is_named=True)

    def host_tests(self, each):
        """All unit tests whose programs have what is broken, those of a like name first."""
        tree, _ = self._breaker
        sources, words = tree.dependents(each.file), set(pathlib.PurePath(each.file).stem.split("_"))
        suites = sorted((suite for suite in self._every if tree.linked(sources, [suite])),
                        key=lambda suite: -len(words & set(suite.name.split("_"))))
        step = Step("make test BOARD=host ONLY=host/", PASSED)
        for first in range(0, len(suites), TOGETHER):
            step = self._try_suites(each, suites[first:first + TOGETHER], is_named=False)
            if step.result != PASSED:
                break
        return step

    # --- proofs ---

    @functools.cached_property
    def _provers(self):
        programs = provers.obtain(self._build, lambda words: print(f"prove: {words}", file=sys.stderr, flush=True))
        folder = self._build / "breaks/proofs"
        shutil.rmtree(folder, ignore_errors=True)
        prove_bugs.make_copy(self._root, folder)
        return programs, folder, kept.Kept(self._build), provers.versions(programs)

    def _try_rows(self, each, rows, command):
        programs, folder, store, versions = self._provers
        step = Step(command, PASSED, "" if rows else "no row proves it")
        for row in rows:
            done = prove_bugs.try_bug(programs, folder, each, row, store, versions)
            if done["noticed"]:
                is_named = each.names == row.name or each.names in done["words"]
                step = Step(f"make prove ONLY={row.id}", NAMED if is_named else UNNAMED, done["words"][:WORDS])
            if step.result == NAMED:
                break
        return step

    def _rows(self, wanted):
        """Those of CBMC first."""
        return sorted((row for row in prove_rows.read(self._root) if wanted(row)), key=lambda row: row.tool != "cbmc")

    def proofs(self, each):
        """The rows of the function; where it has none and is proved within others, those of its file."""
        rows = self._rows(lambda row: row.name == each.names)
        return self._try_rows(each, rows, f"make prove ONLY={each.names}") if rows else self.proofs_of_file(each)

    def proofs_of_file(self, each):
        """The other rows of the file's functions."""
        return self._try_rows(each, self._rows(lambda row: row.function.startswith(f"{each.file}:") and row.name != each.names),
                              f"make prove ONLY={each.file}")

    # --- tools ---

    def _make(self, *targets):
        said = seeded_bugs.build_targets(self._copy, targets, self._options.jobs)
        if said:
            raise ToolError(f"{targets[0]} does not build with a break", words=said)

    def _tool(self, writes, *words):
        """(exit code, what it printed) of a tool of the checkout, in the copy. writes: its JSON file, without which it did not end."""
        writes = self._copy / "build" / writes
        writes.unlink(missing_ok=True)
        done = children.run([sys.executable, LAUNCHER, *map(str, words)], cwd=self._copy, text=True, errors="replace")
        if done.returncode > 1 or not writes.exists():
            raise ToolError(f"fixel {words[0]} could not run", words=done.stderr[-10 * WORDS:])
        return done.returncode, f"{done.stdout}\n{done.stderr}"

    def report(self, each):
        """The claim alone."""
        with planting.planted(self._copy, [each]):
            self._make("build/host/oracle")
            code, said = self._tool("report/claims.json", "report", "--only", each.names, "--samples", self._options.samples)
        lines = [line for line in said.splitlines() if "FAIL" in line]
        result = PASSED if code == 0 else NAMED if any(each.names in line for line in lines) else UNNAMED
        return Step(f"make report ONLY={each.names} SAMPLES={self._options.samples}", result, " ".join(lines)[:WORDS])

    def trace(self, each):
        with planting.planted(self._copy, [each]):
            _, said = self._tool("trace.json", "trace", "--root", self._copy)
        return _line_with("make trace", said, each.names)

    # --- what looks at the whole library ---

    def _together(self, each, run):
        """What `run` printed with this break and those of other files that have the same command."""
        those = self.__dict__.setdefault(f"rounds of {each.command}", {})
        if each.id not in those:
            files = {other.file: other for other in reversed(self._drawn)
                     if other.command == each.command and other.id not in those} | {each.file: each}
            with planting.planted(self._copy, files.values()):
                said = run()
            those.update({other.id: said for other in files.values()})
        return those[each.id]

    def coverage(self, each):
        return _line_with("make coverage", self._together(each, self._cover), f"{each.file}", f"| {each.names} |")

    def _cover(self):
        self._make(f"{COVERAGE}/libfixel-coverage.so")      # which the programs look for below the folder that they run in
        built = self._build / "host/coverage"
        tests = [built / path.stem for path in sorted(self._root.glob(UNITS))]
        replays = [word for path in sorted(self._root.glob("host_tests/fuzz/corpus/*.zip"))
                   for word in ("--replay", built / f"replay_{path.stem}", path)]
        return self._tool("coverage.json", "coverage", "--root", self._copy, "--library", f"{COVERAGE}/libfixel-coverage.so", "--tests", *tests,
                          *replays, "--reasons", "host_tests/unit/uncovered.toml", "--out", "build/coverage.json")[1]

    def rules(self, each):
        return _line_with("make rules", self._together(each, self._check_rules), f"{each.file}:", f": rule {each.names}:")

    def _check_rules(self):
        return self._tool("rules.json", "rules", "--root", self._copy, "--json", "build/rules.json")[1]


def _line_with(command, said, *words):
    """The step of a command that names a break in a line with these words."""
    found = [line for line in said.splitlines() if all(each in line for each in words)]
    return Step(command, NAMED if found else PASSED, found[0].strip()[:WORDS] if found else "")
