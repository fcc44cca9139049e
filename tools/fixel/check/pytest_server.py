# SPDX-License-Identifier: MIT
"""Runs tests for pytest in processes that need not import pytest and other large packages: each is a fork of this one.

A program, which fixel.check.pytest_client starts. It imports nothing of the tools, so that a fork can run the tools of any
checkout, unless it is started with the folder of warm_start.py: then its runs are of that checkout, and so are the servers
of warm_start.py that they ask, which are forks too. Each line of its input asks for a run: {"folder", "words", "said"}. It
answers with two lines: the number of the process, then its exit code and its CPU seconds with those of all that it waited
for. A run puts its output into the file "said". A run with "report" adds a line for each test to that file: {"test",
"passed", "skipped", "cpu", "number"}. Where "lines" names a folder, its file "number" has the lines that the test executed,
and its file "begun" the test that began last, and its fixture that does; parameters of a test are skipped once others took
"enough" CPU seconds. Such a run ends without what a program does at its end.
"""

import ctypes
import gc
import json
import os
import pathlib
import signal
import sys

PRELOADED = ("pytest", "_pytest.junitxml", "hypothesis", "numpy", "PIL.Image", "elftools.elf.elffile", "matplotlib.figure",
             "matplotlib.backends.backend_svg")
PR_SET_PDEATHSIG = 1    # of Linux
TICKS = os.sysconf("SC_CLK_TCK")


def cpu_seconds():
    """Of this process and its children, those that still run included."""
    taken = sum(os.times()[:4])
    for process in pathlib.Path(f"/proc/self/task/{os.getpid()}/children").read_text(encoding="utf-8").split():
        try:
            fields = pathlib.Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
        except OSError:
            continue
        taken += sum(map(int, fields[11:15])) / TICKS
    return taken


class Report:
    """A plug-in of pytest: a line for each test that ended."""

    def __init__(self, asked):
        self.file, self.lines, self.enough = asked["report"], asked["lines"], asked["enough"]
        self.recorder = sys.modules.get("line_recorder")
        self.number, self.spent, self.test = 0, {}, ""

    def pytest_runtest_logstart(self, nodeid, location):
        self.passed, self.skipped, self.before = True, False, cpu_seconds()
        if self.lines:
            self.number += 1
            self.test = nodeid
            self.begin()
            os.environ["FIXEL_LINES"] = str(pathlib.Path(self.lines) / str(self.number))
            self.recorder.recorder.begin()

    def begin(self, fixture=""):
        """Notes what runs from here on: a test, or a fixture that it needs."""
        if self.lines:
            (pathlib.Path(self.lines) / "begun").write_text(f"{self.test}\n{fixture}", encoding="utf-8")

    def pytest_fixture_setup(self, fixturedef, request):
        self.begin(fixturedef.argname)

    def pytest_runtest_call(self, item):
        self.begin()

    def pytest_runtest_setup(self, item):
        if self.lines and self.spent.get(item.nodeid.partition("[")[0], 0.0) > self.enough:
            import pytest
            self.skipped = True
            pytest.skip("enough of its parameters are recorded")

    def pytest_runtest_logreport(self, report):
        self.passed = self.passed and report.passed

    def pytest_runtest_logfinish(self, nodeid, location):
        taken, function = round(cpu_seconds() - self.before, 3), nodeid.partition("[")[0]
        self.spent[function] = self.spent.get(function, 0.0) + taken
        found = {"test": nodeid, "passed": self.passed, "skipped": self.skipped, "cpu": taken, "number": self.number}
        with open(self.file, "a", encoding="utf-8") as report:
            report.write(json.dumps(found) + "\n")


def run(asked):
    """What a fork does; its exit code."""
    import pytest
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, int(signal.SIGKILL))
    said = os.open(asked["said"], os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    os.dup2(said, 1)
    os.dup2(said, 2)
    os.chdir(asked["folder"])
    return int(pytest.main(asked["words"], plugins=[Report(asked)] if "report" in asked else []))


def end(asked):
    """Runs in a fork, and ends it."""
    if "report" not in asked:
        code = run(asked)
        if warm_start:
            warm_start.end(code)
        sys.exit(code)
    code = 3
    try:
        code = run(asked)
        sys.stdout.flush()
    finally:
        os._exit(code)


def answer():
    """Runs what is asked for. In the fork that serves the run as warm_start.py does: the channel that it reads."""
    for line in sys.stdin:
        process = os.fork()
        if process == 0:
            channel = warm_start.branch() if warm_start else None
            if channel is None:
                end(json.loads(line))
            return channel
        print(process, flush=True)
        _, status, used = os.wait4(process, 0)
        print(os.waitstatus_to_exitcode(status), used.ru_utime + used.ru_stime, flush=True)
    return None


if __name__ == "__main__":
    sys.path.pop(0)     # this folder
    for ignored in (signal.SIGHUP, signal.SIGTERM):     # by nohup, or by a shell in the background
        signal.signal(ignored, signal.SIG_DFL)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    for name in PRELOADED:
        __import__(name)
    warm_start = None
    if sys.argv[1:]:
        sys.path.append(sys.argv[1])
        import warm_start
        warm_start.preload()
    gc.freeze()     # what a fork collects, it copies
    served = answer()
    if served:
        warm_start.serve(served)    # comes back in the process of a tool, to end as a program does
