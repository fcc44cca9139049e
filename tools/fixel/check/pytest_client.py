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


class Client:
    """One process of pytest_server.py, which runs one thing at a time."""

    def __init__(self, python=sys.executable, warm=None, **changes):
        """python: that of the tests. warm: the folder of warm_start.py, where all runs are of its checkout. changes: of their
        environment."""
        self._process = children.start([python, SERVER, *([warm] if warm else [])], stdin=subprocess.PIPE,
                                       stdout=subprocess.PIPE, text=True, bufsize=1,
                                       env={**os.environ, "OPENBLAS_NUM_THREADS": "1", **changes})

    def _answer(self):
        line = self._process.stdout.readline()
        if not line:
            raise ToolError("the process that runs the tests has ended; run the command again")
        return line.split()

    def run(self, request, cpu, asleep=limits.ASLEEP):
        """The exit code of a run and its CPU seconds. limits.LimitError where it passes a limit."""
        self._process.stdin.write(json.dumps(request) + "\n")
        process, passed = int(self._answer()[0]), None
        try:
            limits.wait_until(lambda: select.select([self._process.stdout], [], [], 0)[0], process, cpu, asleep, "its end")
        except limits.LimitError as error:
            passed = error
            limits.kill_tree(process)
        code, used = self._answer()
        if passed:
            raise passed
        return int(code), float(used)

    def close(self):
        self._process.stdin.close()
        self._process.wait()
