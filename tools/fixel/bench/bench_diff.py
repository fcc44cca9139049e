# SPDX-License-Identifier: MIT
"""Compares a run of make bench with the baseline, or makes the run the new baseline.

Exit: 0 no figure of Fixel is worse by more than the threshold, 1 a figure is worse or missing, 2 there
is nothing to compare. --accept makes the run the baseline, and renews the tables of docs/performance.md.
"""

import argparse

from fixel import commands


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--baseline", default="bench/baseline.json")
    made.add_argument("--current", default="build/bench/bench.json")
    made.add_argument("--threshold", type=float, default=0.5, help="per cent that count as no change")
    made.add_argument("--accept", action="store_true", help="make the current run the baseline")
    made.add_argument("--document", default="docs/performance.md")
    return made


main = commands.main_of(parser, "fixel.bench.baseline")
