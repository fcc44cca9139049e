# SPDX-License-Identifier: MIT
"""Compares every clipper with every visibility method: drawn on emulated cores, judged against double.

Writes clippers.json and clippers.html (one self-contained page). Exit: 0 every pixel is explained and
every core drew the frames of the host, 1 not, 2 the comparison could not be run.
"""

import argparse
import pathlib
import tomllib

from fixel import commands
from fixel.base.arguments import number
from fixel.base.errors import ToolError
from fixel.campaign import runner

PLAN = pathlib.Path(__file__).resolve().parents[3] / "bench" / "clippers.toml"
CORES = ("m3", "m0")
KINDS = ("clippers", "hidden", "scenes")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--cores", nargs="*", help="cores to measure, whose programs are built; all without")
    made.add_argument("--frames", type=number("FRAMES", 1, 1_000_000), help="number of frames of each scene, spread over its path (FRAMES=)")
    made.add_argument("--only", default="", help="names of clippers, methods, scenes, cores (ONLY=)")
    made.add_argument("--out", default="build/clippers", help="folder for the results")
    made.add_argument("--build", default="build", help="folder that make builds in")
    made.add_argument("--accept", action="store_true",
                      help="only take the run in --out into docs/clipping.md and bench/clippers.json")
    runner.add_options(made)
    return made


def refuse_strange(words, names):
    """Refuses a word that is none of the names."""
    strange = [word for word in words if word not in names]
    if strange:
        raise ToolError(f"ONLY names '{strange[0]}'; the names are: {', '.join(sorted(names))}")


def before(options):
    """Refuses a name that nothing of the plan has."""
    plan = tomllib.loads(PLAN.read_text(encoding="utf-8"))
    names = {*CORES, *(each["name"] for kind in KINDS for each in plan[kind])}
    refuse_strange(options.only.replace(",", " ").split(), names)
    if options.frames is not None and options.frames < 1:
        raise ToolError(f"FRAMES is {options.frames}; it must be at least 1")


main = commands.main_of(parser, "fixel.bench.clippers_report")
