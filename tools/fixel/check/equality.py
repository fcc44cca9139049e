# SPDX-License-Identifier: MIT
"""Compares each core's kernels with the portable ones, on the emulated core itself.

A program has both kernels, gives them the same boundary inputs and random inputs, and counts the
differences. The inputs are a campaign: shards of a million random inputs.

The record has a line for each kernel of each core: the hashes of the kernel's machine text and of what it was compared with
(kernel_text.py), and the number of random inputs for which both gave the same bits, as for all boundary inputs. A kernel that is on record with as many inputs
as are asked for is not compared again. The tool prints a line for each kernel, and puts those that it
compared and that are equal into the record. Exit: 0 all kernels are equal, 1 a kernel differs.
"""

import argparse
import pathlib
import re

from fixel.base import output, scratch
from fixel.base.arguments import whole_number
from fixel.base.errors import ToolError
from fixel.base.reading import shortened
from fixel.bench.bench import CORES, EXTRA_CORES
from fixel.campaign import runner
from fixel.campaign.shards import Shard
from fixel.check import kernel_text
from fixel.commands import late

emulator, endings, firmware, qemu = late("fixel.board", "emulator execute firmware qemu")

SHARD = 1000        # thousands of random inputs
SHARD_SHIFT, KERNEL_SHIFT = 10, 26  # as in firmware/equality/main.c
THOUSANDS_MAX = SHARD << KERNEL_SHIFT - SHARD_SHIFT
TIMEOUT = 3600.0    # seconds of CPU time for a kernel
LINE = re.compile(r"^equality: (\S+) (\d+)\nequality: differences (\d+)$", re.MULTILINE)
MARKER = re.compile(r"^equality: done$", re.MULTILINE)
RECORD = pathlib.Path(__file__).resolve().parents[3] / "firmware/equality/record.txt"
ROW = re.compile(r"(\S+) (\S+) ([0-9a-f]{12}) ([0-9a-f]{12}) ([1-9]\d*)")
HEAD = """\
# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: The Fixel authors
# For how many inputs, beside all boundary inputs, a kernel gave the bits of the portable C text. make equality writes it (ONLY=NAME: of this kernel).
# core kernel, hash of its machine text, hash of what it was compared with, random inputs
"""
ENOUGH = 10_000_000     # random inputs, which a release has of each kernel


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("cores", nargs="+", metavar="core", help="a core whose program is built, such as m3 or m0-small")
    made.add_argument("--thousands", default="10000", help="random inputs for each kernel, in thousands (THOUSANDS=)")
    made.add_argument("--only", default="", metavar="WORD,...", help="kernels, cores, or core/kernel (ONLY=fill,m3/depth-runs)")
    made.add_argument("--build", default="build", help="folder that make builds in")
    made.add_argument("--keep", metavar="FILE", default=str(RECORD), help="the record to read and to write (KEEP=)")
    runner.add_options(made)
    return made


def before(options):
    """The number of thousands; refuses what is none, and a word that names no kernel and no core."""
    listed = (RECORD.parent / "equality.h").read_text(encoding="utf-8")
    for word in filter(None, options.only.split(",")):
        core, _, kernel = word.rpartition("/")
        if f'TEST("{kernel}",' not in listed and (core or kernel.split("-")[0] not in (*CORES, *EXTRA_CORES)):
            raise ToolError(f"ONLY: no core and no kernel is called '{shortened(word)}'; firmware/equality/equality.h lists the kernels")
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


# --- the record ----------------------------------------------------------------

def recorded(path):
    """{(core, kernel, hash of its machine text, hash of what it was compared with): inputs}. No file: nothing is on record."""
    try:
        lines = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
    except FileNotFoundError:
        return {}
    except (OSError, UnicodeError) as error:
        raise ToolError(f"{path}: cannot be read: {error}") from error
    found = {}
    for number, line in enumerate(lines, 1):
        row = ROW.fullmatch(line)
        if row:
            found[row.groups()[:4]] = max(int(row[5]), found.get(row.groups()[:4], 0))
        elif line and not line.startswith("#"):
            raise ToolError(f"{path}:{number}: '{shortened(line)}' is no line such as 'm3 fill 0123456789ab 0123456789ab 10000000'; "
                            "take it out, and run make equality")
    return found


def renew(path, programs, rows):
    """Puts rows ({(core, kernel, hash, hash): inputs}) into the record. A line of the same kernel with other hashes goes, and so does
    one of a kernel that its core has no more. programs: {core: its kernels}."""
    known = recorded(path)
    names = {core: {kernel.name for kernel in some} for core, some in programs.items()}
    renewed = {key[:2] for key in rows}
    lines = {key: inputs for key, inputs in known.items()
             if key in rows or key[:2] not in renewed and key[1] in names.get(key[0], {key[1]})}
    for key, inputs in rows.items():
        lines[key] = max(inputs, lines.get(key, 0))
    if lines != known:
        text = "".join(f"{' '.join(key)} {inputs}\n" for key, inputs in sorted(lines.items(), key=lambda line: (line[0][1], *line[0])))
        output.write_file(pathlib.Path(path), HEAD + text)


def short_of(known, programs=None):
    """([(core, kernel, inputs)] with fewer inputs on record than a release has, number of kernels). programs: {core: kernels} as they
    are now, whose hashes count; None: the lines of the record."""
    now = known if programs is None else [(core, kernel.name, kernel.machine, kernel.text) for core, some in programs.items()
                                          for kernel in some]
    return [(*key[:2], known.get(key, 0)) for key in now if known.get(key, 0) < ENOUGH], len(now)


# --- as a campaign (fixel/campaign/shards.py) ----------------------------------

SHARD_SETUP = "run"


def elf_of(build, core):
    """The program of a core."""
    return pathlib.Path(build) / "equality" / f"{core}.elf"


def kernels_of(build, core):
    """{name: kernel} of a core's program."""
    return {kernel.name: kernel for kernel in kernel_text.kernels(elf_of(build, core))}


def run_shard(build, parameters):
    """What a kernel of a core gave: {"inputs", "differ"}."""
    core = parameters["core"]
    [(_, inputs, differ)] = compare(elf_of(build, core), parameters["thousands"], kernels_of(build, core)[parameters["kernel"]].number,
                                    parameters["shard"])
    return {"inputs": inputs, "differ": differ}


def shard_inputs(build, parameters):
    """A kernel's hashes: what another kernel's change leaves as it is need not be computed again."""
    kernel = kernels_of(build, parameters["core"])[parameters["kernel"]]
    return [kernel.machine, kernel.text, qemu.version()]


def shard_targets(build, parameters):
    return [str(elf_of(build, parameters["core"]))]


def programs_of(options):
    """{core: its kernels}, as the programs are now."""
    return {core: kernel_text.kernels(elf_of(options.build, core)) for core in options.cores}


def due(programs, options, known):
    """([(core, kernel)] to compare, [(core, kernel, inputs)] on record with as many inputs as are asked for): of those that ONLY names."""
    words, asked = set(filter(None, options.only.split(","))), 1000 * before(options)
    chosen = [(core, kernel) for core, some in programs.items() for kernel in some
              if not words or words & {core, kernel.name, f"{core}/{kernel.name}"}]
    if not chosen:
        raise ToolError(f"ONLY={options.only} names no kernel of {', '.join(programs)}")
    inputs = {(core, kernel): 0 if options.fresh else known.get((core, kernel.name, kernel.machine, kernel.text), 0)
              for core, kernel in chosen}
    return ([each for each in chosen if inputs[each] < asked], [(*each, inputs[each]) for each in chosen if inputs[each] >= asked])


def plan(some, thousands):
    """The shards of some kernels [(core, kernel)], one after the other; each has boundary inputs too."""
    found = []
    for core, kernel in some:
        for shard, first in enumerate(range(0, thousands, SHARD)):
            count = min(SHARD, thousands - first)
            found.append(Shard("equality", len(found), {"core": core, "kernel": kernel.name, "shard": shard, "thousands": count},
                               f"{core} {kernel.name}", 1000 * count))
    return found


def merge(some, results):
    """{(core, kernel's name): {"inputs", "differ"}} of the shards' results, in order."""
    rows = {}
    for shard, result in zip(some, results, strict=True):
        row = rows.setdefault(tuple(shard.kind.split()), {"inputs": 0, "differ": 0})
        for key in result:
            row[key] += result[key]
    return rows


def compute(some, thousands, options):
    """{(core, kernel): {"inputs", "differ"}} of some."""
    if not some:
        return {}
    shards = plan(some, thousands)
    done = runner.run("kernels compared, in shards", shards, options)
    rows = merge(shards, runner.whole(done))
    done.tell(options.build, 1000 * thousands)
    return {(core, kernel): rows[core, kernel.name] for core, kernel in some}


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    thousands = before(options)
    runner.jobs_of(options)
    programs = programs_of(options)
    new, old = due(programs, options, recorded(options.keep))
    rows = compute(new, thousands, options)
    after = programs_of(options)        # somebody may have built a program anew meanwhile
    renew(options.keep, after, {(core, kernel.name, kernel.machine, kernel.text): 1000 * thousands
                                for (core, kernel), row in rows.items() if not row["differ"] and kernel in after[core]})
    for core, kernel, inputs in old:
        print(f"{core:9} {kernel.name:18} {inputs:14,} random inputs, as on record")
    for (core, kernel), row in rows.items():
        print(f"{core:9} {kernel.name:18} {row['inputs']:14,} inputs  {row['differ']:,} differ")
    inputs, wrong = (sum(row[key] for row in rows.values()) for key in ("inputs", "differ"))
    print(f"{inputs:,} inputs of {len(rows)} kernels in {len(options.cores)} programs, {wrong:,} differ; {len(old)} kernels as on record")
    return 1 if wrong else 0
