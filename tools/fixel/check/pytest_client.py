# SPDX-License-Identifier: MIT
"""Asks pytest_server.py to run tests for pytest."""

import json
import os
import pathlib
import select
import subprocess
import sys

from fixel.base import children, limits
from fixel.base.errors import ToolError

SERVER = pathlib.Path(__file__).with_name("pytest_server.py")


class EndedError(ToolError):
    """The process that forks for each run ended during one. The next run gets a new process."""


class Client:
    """One process of pytest_server.py, which runs one thing at a time. If it has ended, the next run starts it anew: then the
    thread of that run must outlive all later ones (children.py)."""

    def __init__(self, python=sys.executable, warm=None, **changes):
        """python: that of the tests. warm: the folder of warm_start.py, where all runs are of its checkout. changes: of their
        environment."""
        self._command = [python, SERVER, *([warm] if warm else [])]
        self._environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", **changes}
        self._start()

    def _start(self):
        self._process = children.start(self._command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1,
                                       env=self._environment)

    def _ask(self, request):
        """Sends a request to a process that lives: one that ended between two runs has not begun this one."""
        line = json.dumps(request) + "\n"
        try:
            if self._process.poll() is None:
                self._process.stdin.write(line)
                return
        except BrokenPipeError:
            pass
        self.close()
        self._start()
        self._process.stdin.write(line)

    def _answer(self):
        """The words of a line of the process."""
        line = self._process.stdout.readline()
        if not line.endswith("\n"):
            raise EndedError("the process that runs the tests has ended", exit_code=1)
        return line.split()

    def run(self, request, cpu, asleep=limits.ASLEEP):
        """The exit code of a run and its CPU seconds. limits.LimitError where it passes a limit, EndedError where its process
        ends."""
        try:
            self._ask(request)
            process, passed = int(self._answer()[0]), None
            try:
                limits.wait_until(lambda: select.select([self._process.stdout], [], [], 0)[0], process, cpu, asleep, "its end")
            except limits.LimitError as error:
                passed = error
                limits.kill_tree(process)
            code, used = self._answer()
        except (BrokenPipeError, ValueError, EndedError) as error:
            self._process.kill()    # one whose answer is none
            ended = self._process.wait()
            raise EndedError(f"the process that runs the tests has ended with {ended}", exit_code=1) from error
        if passed:
            raise passed
        return int(code), float(used)

    def close(self):
        for pipe in (self._process.stdin, self._process.stdout):
            try:
                pipe.close()
            except BrokenPipeError:     # it has ended, and a request was left
                pass
        self._process.wait()
