# SPDX-License-Identifier: MIT
"""Rows that other programs prove: Z3 (equations of integers), Gappa (errors of roundings), a C program that enumerates inputs.

The text of Z3 or Gappa is a transcription. The row has a hash of each function that it was written from, and fails when the text of one
changes. A program that enumerates includes the library's own text, and may run a transcription beside it (formulas.py). What C
leaves undefined ends it by a trap, so a function that it runs on every input of its range is also free of that.
"""

import os
import re

from fixel.base import limits, scratch
from fixel.prove import cbmc, formulas, functions, rows
from fixel.prove.cbmc import Failed, TooLong

# No warning is an error: a mutant that leaves something unused must run.
C_FLAGS = ("-std=gnu11", "-O2", "-w", "-fsanitize=undefined", "-fsanitize-undefined-trap-on-error",
           "-Ilib/include", "-Ilib", "-Ihost_tests/proofs")
COMMENT = re.compile(r"#.*")
BOUND = re.compile(r"\bin \[|<=|>=")
GOALS = re.compile(r"->([^{}]*)\}")
ENDED = re.compile(r"^([\d,]+) inputs$", re.MULTILINE)


def preprocessed(root, row, case):
    """All that the result depends on: the prover's text, and that of the library."""
    if row.tool == "enumeration":
        with scratch.folder("inputs") as folder:
            return C_FLAGS, cbmc.text_of(root, row, ["-xc", *_flags(row, case, folder)])
    return row.program, [functions.text_of(root, function) for function in row.of]


def _flags(row, case, folder):
    """Of the compiler. A program that includes formula.h finds it in a folder, where it is written."""
    flags = [*C_FLAGS, f"-DHARNESS={row.harness}", *([] if case is None else [f"-DCASE={case}"]), *row.flags]
    if formulas.INCLUDE not in row.place.read_text(encoding="utf-8"):
        return flags
    beside = [each for path in row.place.parent.iterdir() if path.suffix in (".smt2", ".gappa") for each in rows.rows_of(path)]
    (folder / "formula.h").write_text(formulas.header(rows.rows_of(row.place), {each.id: each for each in beside}), encoding="utf-8")
    return [*flags, f"-I{folder}"]


def _run(words, root, path=None):
    environment = {**os.environ, **({"PATH": path} if path else {}), "LC_ALL": "C"}
    try:
        return limits.run([str(word) for word in words], cbmc.SECONDS, merge=True, text=True, cwd=root, env=environment)
    except limits.LimitError as error:
        raise TooLong(f"{words[0]} had not ended after {cbmc.SECONDS} s of CPU time") from error


def check_texts(root, row):
    """A transcription stands for functions as they were when it was written."""
    if not row.of:
        raise Failed("it is a transcription, and names no function in 'of'")
    for function, known in row.of.items():
        if functions.text_of(root, function) != known:
            file, _, name = function.rpartition(":")
            raise Failed(f"{name} of {file} has changed since {row.place.name} was written from it: see that the formula still says what the C "
                         f"text says, then: fixel prove --accept --only '{row.id}'")


def _run_on(words, root, row):
    """As _run, on a file with the row's program."""
    with scratch.folder("program") as folder:
        program = folder / row.place.name
        program.write_text(row.program, encoding="utf-8")
        return _run([*words, program], root)


def _z3(programs, root, row):
    """Each query must be unsat, but those after (echo "possible"), which show that what is assumed can be."""
    done = _run_on([programs / "z3", f"-T:{cbmc.SECONDS}"], root, row)
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
    """Gappa says nothing of a proved goal that states its bound, but for a divisor of a hint that may be 0: such a hint has its
    condition in braces, which Gappa proves. It warns of hypotheses that contradict each other, and that fails the row."""
    text = COMMENT.sub("", row.program)
    goals = GOALS.findall(text)
    if not goals or any("?" in goal for goal in goals):
        raise Failed(f"{row.place.name} has no goal with a bound: {{ what is assumed -> what is in [a, b] }}")
    bare = [hint.strip() for hint in text.partition("}")[2].split(";") if "/" in hint and "<>" not in hint]
    if bare:
        raise Failed(f"{row.place.name}: the hint '{bare[0]}' divides, and does not say by what that is not 0: {{ d <> 0 }}")
    done = _run_on([programs / "gappa"], root, row)
    said = [line for line in done.stdout.splitlines() if line.strip() and "assumed to be nonzero" not in line]
    if done.returncode or said:
        raise Failed(f"gappa: {' '.join(' '.join(said).split())[-160:]}")
    return {"checks": sum(len(BOUND.findall(goal)) for goal in goals), "within": [], "seconds": done.cpu}


def _enumeration(root, row, case):
    with scratch.folder("inputs") as folder:
        built = _run(["gcc", *_flags(row, case, folder), "-o", folder / "inputs", row.place, *row.links, "-lm"], root)
        if built.returncode:
            raise Failed(f"gcc: {next((line for line in built.stdout.splitlines() if 'error' in line), 'failed')}")
        done = _run([folder / "inputs"], root)
    counted = ENDED.search(done.stdout)
    if done.returncode or not counted:
        raise Failed(f"{' '.join(done.stdout.split())[:160] or 'it said nothing'} (exit code {done.returncode})")
    return {"checks": int(counted[1].replace(",", "")), "within": [], "seconds": built.cpu + done.cpu}


def prove(programs, root, row, case):
    """As cbmc.prove."""
    if row.tool == "enumeration":
        return _enumeration(root, row, case)
    check_texts(root, row)
    return (_z3 if row.tool == "z3" else _gappa)(programs, root, row)
