# SPDX-License-Identifier: MIT
"""Runs the tests: units on the host, the same units on emulated boards, the tools.

Prints a line for each suite, the whole output of failures, which tests were left out because a board has no room
for them, and the ten files of tests, or programs of such on a board, that took the most CPU time. The last line is
"N passed, N failed", and ", N skipped" if tests were skipped. Exit: 0 no test failed, 1 a test failed or nothing ran.
Limits are on CPU time and on sleep (fixel.base.limits), not on wall time.
"""

import argparse
import ast
import contextlib
import dataclasses
import os
import pathlib
import queue
import re
import sys
import threading
import time

from fixel.base import limits, output, scratch, spent
from fixel.base.errors import ToolError
from fixel.base.table import coloured
from fixel.board import unit_tests
from fixel.commands import late

concurrent_futures, element_tree, traceback = late("concurrent.futures"), late("xml.etree.ElementTree"), late("traceback")
pytest_client = late("fixel.check", "pytest_client")

TESTS = pathlib.Path(__file__).resolve().parents[3] / "host_tests"
HOST_CPU = 300          # seconds of CPU time for one program of the host
PYTEST_CPU = 1800       # and for all that the tests of a file start
SLOWEST = 10            # files of tests that are named
QUIET = 20.0            # seconds without a line after which the one running is named
WARM = TESTS / "tools"  # the folder of warm_start.py


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--host-units", nargs="+", action="append", default=[], metavar=("FOLDER", "NAME"),
                      help="a folder of Unity programs for the host, and their names")
    unit_tests.add_options(made)
    made.add_argument("--board", default="", help="run only the suites of this board")
    made.add_argument("--only", default="", help="run only suites with one of these words in their name")
    made.add_argument("--needs", action="store_true", help="run nothing: print what --only needs of make")
    made.add_argument("--json", help="a file for the CPU seconds of each file of tests, or program of such on a board")
    made.add_argument("--whole", action="store_true", help="run all of what is otherwise sampled")
    # One more than processors: some suites wait, for a browser or for time to pass.
    made.add_argument("--workers", type=int, default=(os.cpu_count() or 1) + 1)
    return made


def before(options):
    """Refuses a word that no suite has in its name: a suite of the host or of a board for a unit test, one for each file of pytest."""
    # "_bare": UNIT_BARE in host_tests/unit/unit.mk
    units_of = [name for file in TESTS.rglob("test_*.c") for name in (file.stem, f"{file.stem}_bare")]
    boards = [folder.name for folder in (TESTS.parent / "boards").iterdir() if (folder / "board.mk").exists()]
    names = {f"{file.parent.name}/{file.stem}" for file in TESTS.glob("*/test_*.py")} | {f"{board}/{unit}" for board in boards for unit in units_of}
    unknown = [word for word in options.only.split() if not any(word in name for name in names)]
    if unknown:
        raise ToolError(f"no suite has '{unknown[0]}' in its name; names are such as host/test_scan, mps2-an385/test_scan, tools/test_stl")


@dataclasses.dataclass
class Outcome:
    """What a suite gave; output is shown where something failed."""
    passed: int = 0
    failed: int = 0
    skipped: int = 0
    output: str = ""
    cpu: float = 0.0    # seconds that it took, with all that it started
    no_room: str | None = None      # why a board has no room for the suite


def without_passes(text):
    """Unity's output less the lines of what passed."""
    return re.sub(r"^.*:PASS\s*\n", "", text, flags=re.MULTILINE).rstrip()


def run_host(program):
    """A Unity program on the host. One that ends early counts as a failure more."""
    # A path of its own: "x" alone would be looked for in PATH.
    command = [str(pathlib.Path(program).resolve())]
    try:
        done = limits.run(command, HOST_CPU, merge=True, text=True)
    except OSError as error:
        return Outcome(failed=1, output=f"{program}: {error.strerror}")
    except limits.LimitError as error:
        return Outcome(failed=1, output=f"{error.output}\n{error}")
    text = done.stdout
    passed, failed, skipped = unit_tests.count_unity(text)
    summary = re.search(r"^(\d+) Tests (\d+) Failures (\d+) Ignored", text, re.MULTILINE)
    if not summary or [int(n) for n in summary.groups()] != [passed + failed + skipped, failed, skipped]:
        failed += 1
        text += f"\n{program}: ended with {done.returncode} before its summary, or counted otherwise"
    elif done.returncode and not failed:
        failed += 1
        text += f"\n{program}: ended with {done.returncode} though nothing failed"
    return Outcome(passed, failed, skipped, text, done.cpu)


def run_board(argument):
    """Files of Unity tests on their emulated board: {name: Outcome}."""
    board, elf, names, every = argument
    return {f"{board}/{file.name}": Outcome(file.passed, file.failed, file.skipped, file.output, file.cpu, file.no_room)
            for file in unit_tests.run(elf, names, every)}


class Pytest:
    """Runs files of tests for pytest, each in a process of its own, which is a fork of one that has imported their packages."""

    def __init__(self):
        self._idle, self._clients = queue.SimpleQueue(), []

    def start(self, count):
        """To be called before run, by a thread that outlives all runs (children.py). count: how many run at a time."""
        self._clients = [pytest_client.Client(warm=WARM) for _ in range(count)]
        for client in self._clients:
            self._idle.put(client)

    def close(self):
        for client in self._clients:
            client.close()

    def run(self, file):
        """One file of pytest tests."""
        client = self._idle.get()
        try:
            with scratch.folder("test") as folder:
                said, report = folder / "said.txt", folder / "report.xml"
                # The plug-in takes long to import, and says more only of tests that use Hypothesis.
                plugins = [] if "hypothesis" in file.read_text(encoding="utf-8") else ["-p", "no:hypothesispytest"]
                words = [str(file), *plugins, "-q", "--tb=long", "--color=no", "-rs", "-p", "no:cacheprovider",
                         "-W", "ignore::pytest.PytestAssertRewriteWarning",     # hypothesis is imported already
                         f"--junitxml={report}", f"--basetemp={folder}/tmp"]
                try:
                    code, cpu = client.run({"folder": os.getcwd(), "words": words, "said": str(said)}, PYTEST_CPU)
                except (limits.LimitError, pytest_client.EndedError) as error:
                    return Outcome(failed=1, output=f"{_read(said)}\n{file}: {error}")
                return dataclasses.replace(_pytest_outcome(file, report, code, _read(said)), cpu=cpu)
        finally:
            self._idle.put(client)


def _read(file):
    return file.read_text(encoding="utf-8", errors="replace") if file.exists() else ""


def _pytest_outcome(file, report, code, text):
    try:
        suite = element_tree.parse(report).getroot().find("testsuite")
        total, skipped = int(suite.get("tests")), int(suite.get("skipped"))
        failed = int(suite.get("failures")) + int(suite.get("errors"))
    except (OSError, AttributeError, element_tree.ParseError):
        return Outcome(failed=1, output=f"{text}\n{file}: its process ended with {code} before its report")
    if code and not failed:     # 1: some failed; anything else: pytest itself did
        failed = 1
    return Outcome(max(0, total - failed - skipped), failed, skipped, text)


@dataclasses.dataclass(frozen=True)
class Job:
    """What runs as one: the suites in it, by their names. The function answers an Outcome where there is one suite, a
    dictionary of them by name where a board's program has many."""
    names: tuple
    function: object
    argument: object
    title: str = ""     # for the list of the slowest; empty: the suite's name


def is_chosen(options, name):
    """Whether a suite is asked for: its name has one of the words of --only."""
    words = options.only.split()
    return (not words or any(word in name for word in words)) and (not options.board or name.startswith(f"{options.board}/"))


def board_jobs(options):
    """A job for each program of a board, of its suites that are asked for."""
    for board, elf, names in unit_tests.of_boards(options):
        chosen = [name for name in names if is_chosen(options, f"{board}/{name}")]
        if chosen:
            yield Job(tuple(f"{board}/{name}" for name in chosen), run_board, (board, elf, chosen, len(chosen) == len(names)),
                      f"{board}/{elf.stem}")


def jobs_of_host(options, run_pytest):
    """The tests for pytest first, which take longest, then the units of the host."""
    jobs = [Job((f"{file.parent.name}/{file.stem}",), run_pytest, file) for file in sorted(TESTS.glob("*/test_*.py"))]
    jobs += [Job((f"host/{name}",), run_host, pathlib.Path(folder) / name)
             for folder, *names in options.host_units for name in names]
    return [job for job in jobs if is_chosen(options, job.names[0])]


def all_jobs(options, run_pytest):
    """Those of the host, then those of boards."""
    return jobs_of_host(options, run_pytest) + list(board_jobs(options))


def programs_of(file):
    """What a file of tests for pytest says that it runs, below build/: its BUILT_PROGRAMS, as text, but for names with a *, which
    its tests make."""
    for line in ast.parse(file.read_text(encoding="utf-8")).body:
        if isinstance(line, ast.Assign) and ast.unparse(line.targets[0]) == "BUILT_PROGRAMS":
            return tuple(name for name in ast.literal_eval(line.value) if "*" not in name)
    raise ToolError(f"{file}: it does not say what it runs: give it BUILT_PROGRAMS, the paths of programs below build/, or () for none")


def needs(options):
    """What make must have built for the suites of --only: paths; "unit:NAME" of a file of unit tests for a board."""
    found = set()
    for job in jobs_of_host(options, None):
        if job.function == run_host:
            found.add(str(job.argument))
        else:
            found |= {f"build/{name}" for name in programs_of(job.argument)}
    for board, _ in options.units:
        found |= {f"unit:{file.stem}" for file in (TESTS / "unit").glob("test_*.c") if is_chosen(options, f"{board}/{file.stem}")}
    return sorted(found)


def print_left_out(options, outcomes):
    """What a board has no room for, and why."""
    for board, _ in options.units:
        if options.board in ("", board):
            no_room = {**unit_tests.left_out(options, board),
                       **{name.partition("/")[2]: outcome.no_room for name, outcome in outcomes.items()
                          if outcome.no_room and name.startswith(f"{board}/")}}
            if no_room:
                print(f"left out, no room: {board}: {unit_tests.with_reasons(no_room)}")


class Printer:
    """A line a suite; where nothing happens for long, what is still running."""

    def __init__(self, names):
        self.width = max(map(len, names), default=0)
        self.total, self.done = len(names), 0
        self.running = {}
        self.lock = threading.Lock()
        self.last = time.monotonic()

    def start(self, job):
        with self.lock:
            self.running[job.names[0]] = time.monotonic()

    def end(self, job, outcomes):
        """A line for each suite. The time is that of the job, and stands behind the last of its suites."""
        with self.lock:
            seconds = time.monotonic() - self.running.pop(job.names[0])
            for name, outcome in outcomes.items():
                self._print(name, outcome, f"  {seconds:.1f} s" if name == job.names[-1] else "")
            self.last = time.monotonic()

    def _print(self, name, outcome, took):
        self.done += 1
        word = coloured("FAIL", "red") if outcome.failed else "none" if outcome.no_room else coloured("ok", "green") + "  "
        counts = f"{outcome.passed:5} passed" + \
            (f", {outcome.failed} failed" if outcome.failed else "") + \
            (f", {outcome.skipped} skipped" if outcome.skipped else "") + \
            (f", no room: {outcome.no_room}" if outcome.no_room else "")
        print(f"[{self.done:{len(str(self.total))}}/{self.total}] {word} {name:{self.width}} {counts}{took}", flush=True)
        if outcome.failed:
            print(without_passes(outcome.output), flush=True)

    def remind(self):
        """Names what is running where that has been the case for long."""
        with self.lock:
            if self.running and time.monotonic() - self.last > QUIET:
                print(f"        still running: {', '.join(self.running)}", file=sys.stderr, flush=True)
                self.last = time.monotonic()


def run_all(options):
    """{suite: Outcome} of all jobs, run side by side, and {job: CPU seconds}."""
    tests, workers = Pytest(), max(1, options.workers)
    jobs = all_jobs(options, tests.run)
    with contextlib.closing(tests):
        tests.start(min(workers, sum(job.function == tests.run for job in jobs)))
        return run_jobs(jobs, workers)


def run_jobs(jobs, workers):
    """As run_all."""
    printer = Printer([name for job in jobs for name in job.names])

    def one(job):
        printer.start(job)
        try:
            outcome = job.function(job.argument)
        except Exception:   # the others run, and the last line comes
            outcome = {name: Outcome(failed=1, output=traceback.format_exc()) for name in job.names}
        outcomes = outcome if isinstance(outcome, dict) else {job.names[0]: outcome}
        printer.end(job, outcomes)
        return outcomes

    with concurrent_futures.ThreadPoolExecutor(workers) as pool:
        futures = {pool.submit(one, job): job for job in jobs}
        waiting = futures
        while waiting:
            waiting = concurrent_futures.wait(waiting, timeout=1.0).not_done
            printer.remind()
    outcomes = [(job, future.result()) for future, job in futures.items()]
    return ({name: outcome for _, each in outcomes for name, outcome in each.items()},
            {job.title or job.names[0]: sum(outcome.cpu for outcome in each.values()) for job, each in outcomes})


def print_slowest(taken):
    """What took the most CPU time: files of tests, and programs of many on a board. taken: {name: seconds}."""
    print(f"slowest of {sum(taken.values()):.0f} s of CPU:")
    for name in sorted(taken, key=taken.get, reverse=True)[:SLOWEST]:
        print(f"{taken[name]:8.1f} s  {name}")


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    if options.needs:
        print(*needs(options), sep="\n")
        return 0
    # The tests start tools some thousand times: a tool that Python has compiled before starts a third faster.
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    os.environ["FIXEL_SET_UP"] = os.getcwd()    # tools/setup.sh need not look again
    if options.whole:
        os.environ["FIXEL_WHOLE"] = "1"     # host_tests/conftest.py reads it
    outcomes, taken = run_all(options)
    print_left_out(options, outcomes)
    passed, failed, skipped = (sum(getattr(outcome, name) for outcome in outcomes.values())
                               for name in ("passed", "failed", "skipped"))
    if passed + failed == 0:
        print("no test ran", file=sys.stderr)
    print_slowest(taken)
    if options.json:
        output.write_json(options.json, {name: round(taken[name], 2) for name in sorted(taken, key=taken.get, reverse=True)})
    spent.tell()
    boards = [board for board, _ in options.units if any(name.startswith(f"{board}/") for name in outcomes)]
    if options.only and boards and not options.board:
        print(f"unit tests ran on the host and on {', '.join(boards)}: BOARD= names another, and without ONLY= all run")
    print(f"{passed} passed, {failed} failed" + (f", {skipped} skipped" if skipped else ""))
    return 1 if failed or passed == 0 else 0
