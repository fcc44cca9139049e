# SPDX-License-Identifier: MIT
"""Copies of the checkout in which mutants of the tools are tried, and the tests for pytest that run in them."""

import json
import os
import pathlib
import shutil
import sys
import sysconfig
import time

from fixel.base import limits, scratch
from fixel.check.pytest_client import Client, EndedError

RECORDER = pathlib.Path(__file__).with_name("recorder")
COPIED = ("tools", "host_tests")
UNCOPIED = shutil.ignore_patterns("__pycache__")
PLAIN = ["-q", "-p", "no:cacheprovider", "-p", "no:hypothesispytest", "--no-header", "--tb=line"]
ASLEEP = 60.0       # seconds of sleep that are a hang


class Tree:
    """A checkout of its own: copies of what is mutated and of its tests, and links to everything else."""

    def __init__(self, folder, checkout):
        self.folder = folder
        shutil.rmtree(folder, ignore_errors=True)
        for name in COPIED:
            shutil.copytree(checkout / name, folder / name, ignore=UNCOPIED)
        for each in checkout.iterdir():
            if not (folder / each.name).exists() and each.name not in (".git", "build"):
                (folder / each.name).symlink_to(each)
        # Its journals of temporary files are its own: a mutant of scratch.py must not take those of commands that live for left over.
        (folder / "build").mkdir()
        for each in checkout.glob("build/*"):
            if each.name != scratch.JOURNALS.name:
                (folder / "build" / each.name).symlink_to(each)
        # Set-up would make .venv anew, which is a link, because its path is another.
        (folder / "tools" / "setup.sh").write_text("#!/bin/sh\n", encoding="utf-8")
        self._said, self._report = folder / "said.txt", folder / "report.jsonl"
        self._server, self._time = None, int(time.time())

    def record(self):
        """From here on the tests record the lines of the tools that they execute. Their Python is one that imports the
        recorder, also in a process that looks at no variable of the environment (python -I), as those of bounded.py."""
        packages = pathlib.Path(sysconfig.get_path("purelib"))
        venv = self.folder / ".venv"
        venv.unlink()
        made = venv / packages.relative_to(sys.prefix)
        made.mkdir(parents=True)
        (venv / "bin").mkdir()
        (venv / "bin/python").symlink_to(sys._base_executable)
        for command in pathlib.Path(sys.prefix, "bin").iterdir():
            if not (venv / "bin" / command.name).exists():
                (venv / "bin" / command.name).symlink_to(command)
        (venv / "pyvenv.cfg").write_text(f"home = {pathlib.Path(sys._base_executable).parent}\n", encoding="utf-8")
        (made / "recorder.pth").write_text(f"{packages}\n{RECORDER}\nimport line_recorder\n", encoding="utf-8")
        self._server = Client(venv / "bin/python", FIXEL_LINES_OF=str(self.folder / "tools/fixel"))

    def write(self, file, text):
        """Puts text into a file. What Python has compiled of it before is out of date for certain: it goes by seconds."""
        (self.folder / file).write_text(text, encoding="utf-8")
        self._time += 1
        os.utime(self.folder / file, (self._time, self._time))

    def run(self, tests, cpu, *options, lines=None, enough=0.0):
        """(exit code of pytest or words that say how else it ended, the report of each test by pytest_server.py).
        lines: the folder for the lines that each executes, of each test only parameters that take enough seconds."""
        if self._server is None:
            self._server = Client()
        self._report.unlink(missing_ok=True)
        words = [*PLAIN, *options, f"--basetemp={self.folder}/tmp", *(f"host_tests/{test}" for test in tests)]
        try:
            code, _ = self._server.run({"folder": str(self.folder), "words": words, "said": str(self._said),
                                        "report": str(self._report), "lines": lines and str(lines), "enough": enough}, cpu, ASLEEP)
        except (limits.LimitError, EndedError) as error:
            code = str(error)
        report = self._report.read_text(encoding="utf-8").splitlines() if self._report.exists() else []
        return code, [json.loads(line) for line in report]

    def close(self):
        if self._server is not None:
            self._server.close()
