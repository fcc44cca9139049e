# SPDX-License-Identifier: MIT
"""Counts the executed instructions of the workloads and of the library's kernels.

Writes the report bench.md, bench.json, and plots. Two runs give the same figures. With --pixels, --order or --depth it
draws the workloads so and as their scenes ask, with this library alone, and writes target.json and nothing else. Exit: 0 all was
measured, 1 a program of the bench failed or drew a wrong picture, 2 the bench could not be run.
"""

import argparse

from fixel import commands
from fixel.scene import target


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


main = commands.main_of(parser, "fixel.bench.bench_report")
