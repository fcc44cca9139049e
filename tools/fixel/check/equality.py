# SPDX-License-Identifier: MIT
"""Compares each core's kernels with the portable ones, on the emulated core itself.

A program has both kernels, gives them the same boundary inputs and random inputs, and counts the
differences. The tool prints a line for each kernel, and writes them to DIR/equality/equality.json. The inputs are
a campaign: shards of a million random inputs. Exit: 0 all kernels are equal, 1 a kernel differs.
"""

import argparse
import pathlib
import re

from fixel.base import output, scratch
from fixel.base.arguments import whole_number
from fixel.base.errors import ToolError
from fixel.campaign import runner
from fixel.campaign.shards import Shard
from fixel.commands import late

emulator, endings, firmware, qemu = late("fixel.board", "emulator execute firmware qemu")

SHARD = 1000        # thousands of random inputs
SHARD_SHIFT, KERNEL_SHIFT = 10, 26  # as in firmware/equality/main.c
THOUSANDS_MAX = SHARD << KERNEL_SHIFT - SHARD_SHIFT
TIMEOUT = 3600.0    # seconds of CPU time for a kernel
LINE = re.compile(r"^equality: (\S+) (\d+)\nequality: differences (\d+)$", re.MULTILINE)
NAME = re.compile(r"^equality: kernel (\S+)$", re.MULTILINE)
MARKER = re.compile(r"^equality: done$", re.MULTILINE)


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("cores", nargs="+", metavar="core", help="a core whose program is built, such as m3 or m0-small")
    made.add_argument("--thousands", default="10000", help="random inputs for each kernel, in thousands (THOUSANDS=)")
    made.add_argument("--build", default="build", help="folder that make builds in")
    made.add_argument("--keep", metavar="FILE", help="write the result there too, for the report of make bench (KEEP=)")
    runner.add_options(made)
    return made


def before(options):
    """The number of thousands; refuses what is none."""
    return whole_number("--thousands", options.thousands, 1, THOUSANDS_MAX)


def execute(elf, number, timeout):
    """What a program prints that is asked for frames=number."""
    program = firmware.load(elf)
    options = [*qemu.semihosting(["equality", f"frames={number}"]), "-kernel", str(program.path.resolve())]
    with scratch.folder("equality") as folder:
        ending = emulator.emulate(program, options, folder, timeout)
    wrong = any(int(each[2]) for each in LINE.findall(ending.output))
    if ending.code != endings.exit_code("TEST" if wrong else "DONE") or not MARKER.search(ending.output):
        raise ToolError(f"{elf}: {endings.describe(ending)}", exit_code=1, words=ending.output)
    return ending.output


def kernels(elf):
    """The names of a program's kernels, in its order."""
    names = NAME.findall(execute(elf, 0, TIMEOUT))
    if not names:
        raise ToolError(f"{elf} names no kernel")
    return names


def compare(elf, thousands, kernel=0, shard=0, timeout=TIMEOUT):
    """[(name, cases, differences)] of one kernel, counted from 1, or of all of them."""
    done = LINE.findall(execute(elf, kernel << KERNEL_SHIFT | shard << SHARD_SHIFT | thousands, timeout))
    if not done:
        raise ToolError(f"{elf} compared nothing")
    return [(name, int(cases), int(wrong)) for name, cases, wrong in done]


def first_difference(elf, thousands, timeout):
    """None if no kernel of a core differs, else words that say which does."""
    try:
        wrong = [name for name, _, wrong in compare(elf, thousands, timeout=timeout) if wrong]
    except ToolError as error:
        return str(error)
    return f"{wrong[0]} differs" if wrong else None


# --- as a campaign (fixel/campaign/shards.py) ----------------------------------

SHARD_SETUP = "run"


def elf_of(build, core):
    """The program of a core."""
    return pathlib.Path(build) / "equality" / f"{core}.elf"


def run_shard(build, parameters):
    """What a kernel of a core gave: {"inputs", "differ"}."""
    [(_, inputs, differ)] = compare(elf_of(build, parameters["core"]), parameters["thousands"], parameters["kernel"],
                                    parameters["shard"])
    return {"inputs": inputs, "differ": differ}


def shard_inputs(build, parameters):
    return [elf_of(build, parameters["core"]), qemu.version()]


def shard_targets(build, parameters):
    return [str(elf_of(build, parameters["core"]))]


def plan(build, cores, thousands):
    """The shards of all kernels of some cores, one kernel after the other; each has boundary inputs too."""
    found = []
    for core in cores:
        for number, name in enumerate(kernels(elf_of(build, core)), 1):
            for shard, first in enumerate(range(0, thousands, SHARD)):
                count = min(SHARD, thousands - first)
                found.append(Shard("equality", len(found), {"core": core, "kernel": number, "shard": shard, "thousands": count},
                                   f"{core} {name}", 1000 * count))
    return found


def merge(some, results):
    """[{"core", "kernel", "inputs", "differ"}] of the shards' results, in order."""
    rows = {}
    for shard, result in zip(some, results, strict=True):
        core, kernel = shard.kind.split()
        row = rows.setdefault(shard.kind, {"core": core, "kernel": kernel, "inputs": 0, "differ": 0})
        for key in result:
            row[key] += result[key]
    return list(rows.values())


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    thousands = before(options)
    runner.jobs_of(options)
    some = plan(options.build, options.cores, thousands)
    done = runner.run("kernels compared, in shards", some, options)
    rows = merge(some, runner.whole(done))
    done.tell(options.build, 1000 * thousands)
    for path in filter(None, (pathlib.Path(options.build) / "equality" / "equality.json", options.keep)):
        output.write_json(path, {"rows": rows})
    for row in rows:
        print(f"{row['core']:9} {row['kernel']:18} {row['inputs']:14,} inputs  {row['differ']:,} differ")
    inputs, wrong = (sum(row[key] for row in rows) for key in ("inputs", "differ"))
    print(f"{inputs:,} inputs of {len(rows)} kernels in {len(options.cores)} programs, {wrong:,} differ")
    return 1 if wrong else 0
