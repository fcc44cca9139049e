# SPDX-License-Identifier: MIT
"""Proves properties of the shipped text for every input: the rows above the harnesses of host_tests/proofs.

    fixel prove [--only WORD] [--accept] [--bugs] [--mutants] [--numbers] [--fresh] [--cluster tcp://HOST:PORT]

Every function of the library is proved, proved within a row of another, or measured, which host_tests/proofs/measured.toml
says with the reason; of assembly it says which kernel of make equality compares it with the C text. Writes DIR/prove/prove.json. With --bugs each seeded bug that names a row must make the row fail.
With --numbers no prover runs: the numbers of rows and functions in SOUNDNESS.md and docs/evidence.md are renewed, by the rows and lists as they are.
Exit: 0 all proved, 1 a row is not proved, was skipped or lost a check, a function has no row, or a bug was not noticed,
2 could not run.
"""

import argparse
import importlib
import pathlib

from fixel.base.errors import ToolError
from fixel.campaign import runner
from fixel.prove import rows

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--build", default="build", help="the build folder")
    made.add_argument("--root", default=str(CHECKOUT), help="the checkout that is proved")
    made.add_argument("--only", default="", help="only rows with this in their id, function or file")
    made.add_argument("--bugs", action="store_true", help="put each seeded bug that names a row into a copy; the row must fail (BUGS=1)")
    made.add_argument("--mutants", action="store_true", help="put small mistakes into the functions of host_tests/proofs/mutants.toml, or of --only; their rows must fail")
    made.add_argument("--tidy", action="store_true", help="write the numbers of checks into the rows, and take what is proved now, or gone, out of the "
                           "lists of what is measured")
    made.add_argument("--numbers", action="store_true", help="run no prover; write the numbers of rows and functions into SOUNDNESS.md and docs/evidence.md")
    made.add_argument("--accept", action="store_true", help="of the rows of --only: write the hashes of the functions that they were written from, as these are now")
    made.add_argument("--seconds", type=int, default=120, help="of CPU time that a row may take")
    runner.add_options(made)
    return made


def before(options):
    """The rows that are asked for; refuses a word that none has."""
    if options.accept and not options.only:
        raise ToolError("--accept says that formulas were compared with functions that have changed: name their rows by --only")
    every = rows.read(pathlib.Path(options.root).resolve())
    named = {row.id for row in every if options.only in f"{row.id} {row.function} {row.place}"}
    found = [row for row in every if {row.id, row.formula} & named]      # a formula is run beside its function
    if not found:
        raise ToolError(f"no row has '{options.only}' in its id, function or file")
    return found


def main(argv):
    options = parser().parse_args(argv)
    return importlib.import_module("fixel.prove.proving").command(options)
