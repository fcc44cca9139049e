# SPDX-License-Identifier: MIT
"""Counts the executed instructions of the workloads and of the library's kernels.

Writes the report bench.md, bench.json, and plots. Two runs give the same figures. With --pixels, --order or --depth it
draws the workloads so and as their scenes ask, with this library alone, and writes target.json and nothing else. Exit: 0 all was
measured, 1 a program of the bench failed or drew a wrong picture, 2 the bench could not be run.
"""

import argparse
import pathlib
import tomllib

from fixel import commands
from fixel.base.errors import ToolError
from fixel.scene import target

CORES = ("m0", "m3", "m4f", "m55")
PLAN = pathlib.Path(__file__).resolve().parents[3] / "bench" / "bench.toml"


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--cores", "--core", nargs="+", help="cores to measure, whose programs are built; all without")
    made.add_argument("--workloads", "--workload", nargs="+", help="workloads to draw; all without")
    made.add_argument("--left-out", nargs="*", default=[], help="cores that no board has")
    made.add_argument("--out", default="build/bench", help="folder for the results")
    made.add_argument("--build", default="build", help="folder that make builds in")
    target.add_options(made)
    return made


def workloads():
    """The names of the workloads, in a palette and to RGB565."""
    plan = tomllib.loads(PLAN.read_text(encoding="utf-8"))
    return [each["name"] for kind in ("workloads", "rgb565") for each in plan.get(kind, ())]


def refuse_workload(name):
    """Refuses a name that no workload has."""
    if name not in (None, *workloads()):
        raise ToolError(f"there is no workload '{name}'; the workloads are: {', '.join(workloads())}")


def before(options):
    """Refuses a workload that there is not."""
    for name in options.workloads or ():
        refuse_workload(name)


main = commands.main_of(parser, "fixel.bench.bench_report")
