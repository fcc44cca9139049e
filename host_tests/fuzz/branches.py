# SPDX-License-Identifier: MIT
"""Which branches of the library a run of inputs takes, as gcov counts them.

A condition that the compiler cannot decide has two branches, a switch one a case. What the compiler
decides in this build (FXL_IS_SMALL, the kernels of other cores) or leaves out (FXL_ASSERT) has none.
A function of a header counts once, however many files include it.
"""

import collections
import gzip
import json
import os
import shutil
import subprocess

from conftest import CHECKOUT


def run(program, files, folder):
    """Runs a program on files. What it counts is added to that of the runs before in the folder."""
    done = subprocess.run([program, *files], text=True, capture_output=True, check=False,
                          env={**os.environ, "GCOV_PREFIX": str(folder)})
    assert done.returncode == 0, done.stdout + done.stderr


def counts(objects, folder):
    """{(file, line, number of the branch in the line): times taken} of lib/. An object of a source that is gone does not
    count."""
    place = folder / objects.resolve().relative_to("/")
    for notes in objects.rglob("*.gcno"):
        if not (CHECKOUT / "lib" / notes.relative_to(objects)).with_suffix(".c").exists():
            continue
        to = place / notes.relative_to(objects)
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(notes, to)
    data = sorted(str(file) for file in place.rglob("*.gcno"))
    subprocess.run(["gcov", "--json-format", "--branch-probabilities", "--preserve-paths", *data], cwd=place,
                   check=True, capture_output=True)
    taken = collections.Counter()
    for report in place.glob("*.gcov.json.gz"):
        for file in json.loads(gzip.decompress(report.read_bytes()))["files"]:
            name = os.path.relpath(CHECKOUT / file["file"], CHECKOUT)
            if name.startswith("lib/"):
                add_lines(taken, name, file["lines"])
    return taken


def add_lines(taken, name, lines):
    numbers = collections.Counter()
    for line in lines:
        number = line["line_number"]
        for branch in line["branches"]:
            taken[name, number, numbers[number]] += branch["count"]
            numbers[number] += 1
