# SPDX-License-Identifier: MIT
"""Builds pictures of random worlds up from what changed, step by step, and compares each with the whole frame (docs/extras/changed.md).

Exit: 0 every picture was equal, 1 one was not, 2 it could not be tried.
"""

import argparse
import os
import pathlib

from fixel.base import children, parallel
from fixel.base.arguments import whole_number
from fixel.base.errors import ToolError
from fixel.base.table import coloured, table

PROGRAM = "test_changed"
STEPS_MAX, EACH = 100_000_000, 10_000     # steps, and those of a process, whose seeds follow one another


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--steps", default="100000", help="how many (STEPS=)")
    made.add_argument("--seed", default="1", help="of the first worlds (SEED=)")
    made.add_argument("--units", required=True, help="folder of the unit tests")
    return made


def before(options):
    """The options, as the command needs them."""
    options.steps = whole_number("STEPS", options.steps, 1, STEPS_MAX)
    options.seed = whole_number("SEED", options.seed, 0, 2 ** 31 - 1)
    return options


def follow(program, steps, seed):
    """What the program says of so many steps, where a picture is not the frame; else ""."""
    done = children.run([program], text=True, env={**os.environ, "FIXEL_CHANGED_STEPS": str(steps), "FIXEL_CHANGED_SEED": str(seed)})
    if done.returncode == 0:
        return ""
    return next((line for line in done.stdout.splitlines() if ":FAIL" in line), "") or (done.stderr.strip() or f"it ended with {done.returncode}").splitlines()[-1]


def main(argv):
    """The command; its exit code."""
    options = before(parser().parse_args(argv))
    program = pathlib.Path(options.units) / PROGRAM
    if not program.exists():
        raise ToolError(f"{program} is not built: make changed builds it")
    counts = [min(EACH, options.steps - begun) for begun in range(0, options.steps, EACH)]
    found = parallel.run("following worlds", {options.seed + number: (follow, program, count, options.seed + number) for number, count in enumerate(counts)})
    wrong = {seed: said for seed, said in found.items() if said}
    print(table([["steps", f"{options.steps:,}, seeds {options.seed} to {options.seed + len(counts) - 1}"],
                 ["runs with a wrong picture", len(wrong)]]))
    for seed, said in wrong.items():
        print(f"FIXEL_CHANGED_STEPS={EACH} FIXEL_CHANGED_SEED={seed} {program}: {said}")
    print(coloured("FAIL", "red") if wrong else coloured("pass", "green"))
    return 1 if wrong else 0
