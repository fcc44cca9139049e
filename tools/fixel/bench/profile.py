# SPDX-License-Identifier: MIT
"""Shows where the instructions of a workload go: by function, by line, and as a flame graph.

Counts are exact. Cycles are an ESTIMATE from a table of costs (bench/cycles.toml).
"""

import argparse

from fixel import commands
from fixel.base.arguments import number
from fixel.base.errors import ToolError
from fixel.bench import bench


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--workload", required=True)
    made.add_argument("--core", required=True)
    made.add_argument("--renderer", help="default: fixel, or fixel-native for what is drawn to RGB565")
    made.add_argument("--frames", type=number("FRAMES", 1, 1_000_000), help="number of frames (default: the whole path)")
    made.add_argument("--out", help="folder for the results")
    made.add_argument("--build", default="build", help="folder that make builds in")
    return made


def before(options):
    """Refuses a workload or a core that there is not."""
    bench.refuse_workload(options.workload)
    if options.core not in (None, *bench.CORES):
        raise ToolError(f"there is no core '{options.core}'; the cores are: {', '.join(bench.CORES)}")


main = commands.main_of(parser, "fixel.bench.profiling")
