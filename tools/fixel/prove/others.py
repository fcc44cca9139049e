# SPDX-License-Identifier: MIT
"""Rows that other programs prove: Z3 (equations of integers), Gappa (errors of roundings), a C program that tries every input.

The text of Z3 or Gappa is a transcription. The row quotes the lines of the library that it stands for, and each must
still stand in the function's file, in their order.
"""

import os
import re

from fixel.base import limits, scratch
from fixel.prove import cbmc
from fixel.prove.cbmc import Failed, TooLong

C_FLAGS = ("-std=c11", "-O2", "-Wall", "-Wextra", "-Werror", "-Ilib/include", "-Ilib", "-Ihost_tests/proofs")
ENDED = re.compile(r"^([\d,]+) inputs$", re.MULTILINE)


def preprocessed(root, row, _case):
    """The prover's text, and the file of the library that it stands for."""
    return row.place.read_bytes(), (root / row.function.rpartition(":")[0]).read_bytes(), _library(root) if row.tool == "every input" else b""


def _library(root):
    """The text of the rooms that programs include."""
    return [path.read_bytes() for path in sorted((root / "lib").rglob("*.[ch]"))]


def _run(words, root, path=None):
    environment = {**os.environ, **({"PATH": path} if path else {}), "LC_ALL": "C"}
    try:
        return limits.run([str(word) for word in words], cbmc.SECONDS, merge=True, text=True, cwd=root, env=environment)
    except limits.LimitError as error:
        raise TooLong(f"{words[0]} had not ended after {cbmc.SECONDS} s of CPU time") from error


def check_quotes(root, row):
    """The lines that a transcription stands for, as they are now."""
    file = row.function.rpartition(":")[0]
    text = " ".join((root / file).read_text(encoding="utf-8").split())
    place = 0
    for line in row.text:
        found = text.find(" ".join(line.split()), place)
        if found < 0:
            raise Failed(f"{row.place.name} stands for '{line}', and {file} does not have it (any more, or there)")
        place = found + 1
    if not row.text and row.tool != "every input":
        raise Failed("it is a transcription, and names no line of the library")


def _z3(programs, root, row):
    """Each query must be unsat, but those after (echo "sat"), which show that what is assumed can be."""
    done = _run([programs / "z3", f"-T:{cbmc.SECONDS}", row.place], root)
    words = done.stdout.split()
    wanted = [("sat", "unsat")[word != "possible"] for word in words[0::2]]
    got = words[1::2]
    if not got or words[0] not in ("possible", "proved"):
        raise Failed(f"z3: {done.stdout.strip()[:100]}: each (check-sat) needs (echo \"proved\") or (echo \"possible\") before it")
    bad = [number for number, (want, have) in enumerate(zip(wanted, got), 1) if want != have]
    if bad or len(wanted) != len(got):
        raise Failed(f"z3: query {bad[0] if bad else len(got)} is {got[bad[0] - 1] if bad else 'missing'}")
    if "possible" not in words[0::2]:
        raise Failed("z3: no query shows that what is assumed is possible")
    return {"checks": len(got), "within": [], "seconds": done.cpu}


def _gappa(programs, root, row):
    done = _run([programs / "gappa", row.place], root)
    if done.returncode or "Error" in done.stdout or "some enclosures were not satisfied" in done.stdout.lower():
        raise Failed(f"gappa: {' '.join(done.stdout.split())[-160:]}")
    return {"checks": max(1, row.place.read_text(encoding="utf-8").count("->")), "within": [], "seconds": done.cpu}


def _every_input(root, row):
    with scratch.folder("inputs") as folder:
        built = _run(["gcc", *C_FLAGS, "-o", folder / "inputs", row.place, *row.links], root)
        if built.returncode:
            raise Failed(f"gcc: {next((line for line in built.stdout.splitlines() if 'error' in line), 'failed')}")
        done = _run([folder / "inputs"], root)
    counted = ENDED.search(done.stdout)
    if done.returncode or not counted:
        raise Failed(f"{' '.join(done.stdout.split())[:160] or 'it said nothing'} (exit code {done.returncode})")
    return {"checks": int(counted[1].replace(",", "")), "within": [], "seconds": built.cpu + done.cpu}


def prove(programs, root, row, _case):
    """As cbmc.prove."""
    check_quotes(root, row)
    if row.tool == "every input":
        return _every_input(root, row)
    return (_z3 if row.tool == "z3" else _gappa)(programs, root, row)
