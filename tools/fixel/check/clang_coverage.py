# SPDX-License-Identifier: MIT
"""What of the library its tests reach: lines, branches, and conditions of decisions, as Clang counts them.

A condition is reached where two tests show that it alone decides (MC/DC): the decision's value changes with it while
the other conditions stay or do not matter. A decision of one condition has none: its branches say the same.
"""

import collections
import concurrent.futures
import json
import os
import pathlib
import subprocess

from fixel.base import children
from fixel.base.errors import ToolError
from fixel.base.progress import Progress

KINDS = {"lines": "lines", "branches": "branches", "mcdc": "conditions"}     # of llvm-cov -> of the table
WORDS = 2000    # the last characters of what a program said
LEVELS = 3      # of a path: lib/include/fixel


def run_programs(programs, folder, jobs):
    """Runs [program, arguments...] each: (files of counts in the folder, {name of a program that failed: its words})."""
    def run(job):
        number, command = job
        counts = folder / f"{number}.profraw"
        done = children.run([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, errors="replace",
                            env={**os.environ, "LLVM_PROFILE_FILE": str(counts)})
        return counts, done.stdout[-WORDS:] if done.returncode else None

    with Progress("programs", len(programs)) as progress, concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        found = []
        for result in pool.map(run, enumerate(programs)):
            found.append(result)
            progress(len(found))
    failed = {pathlib.Path(command[0]).name: words for command, (_, words) in zip(programs, found) if words is not None}
    return [counts for counts, _ in found if counts.exists()], failed


def call(tool, *words):
    done = children.run([tool, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise ToolError(f"{tool} fails", 1, done.stderr[-WORDS:])
    return done.stdout


def measured(library, counts, version, checkout):
    """{file of lib/: {kind: [reached, all], "unreached": [line of a condition]}}."""
    merged = library.with_name("coverage.profdata")
    listed = library.with_name("counts.txt")
    listed.write_text("".join(f"{file}\n" for file in counts), encoding="utf-8")
    call(f"llvm-profdata-{version}", "merge", "-sparse", "-f", listed, "-o", merged)
    exported = json.loads(call(f"llvm-cov-{version}", "export", "-skip-functions", "-skip-expansions",
                               f"-instr-profile={merged}", library))
    return dict(sorted(of_files(exported["data"][0]["files"], checkout).items()))


def of_files(files, checkout):
    """The same, of an export's files."""
    found = {}
    for file in files:
        name = os.path.relpath(checkout / file["filename"], checkout)
        if name.startswith("lib/"):
            found[name] = {KINDS[kind]: [file["summary"][kind]["covered"], file["summary"][kind]["count"]] for kind in KINDS}
            found[name]["unreached"] = unreached(file.get("mcdc_records", []))
    return found


def unreached(records):
    """[line, condition of the decision there from 1] of conditions that no pair of tests decides by."""
    return [[record[0], place] for record in records for place, reached in enumerate(record[-1], 1) if not reached]


def by_room(files):
    """{room of lib/: {kind: [reached, all]}}, and "all together"."""
    rooms = collections.defaultdict(lambda: {kind: [0, 0] for kind in KINDS.values()})
    for name, counted in files.items():
        for room in ("/".join(name.split("/")[:-1][:LEVELS]), "all together"):
            for kind in KINDS.values():
                rooms[room][kind] = [a + b for a, b in zip(rooms[room][kind], counted[kind])]
    together = rooms.pop("all together", None)
    return {**dict(sorted(rooms.items())), **({"all together": together} if together else {})}


def percent(reached, every):
    return 100 * reached / every if every else None


def rows(rooms):
    """Rows of the table: for each room reached, all and per cent of each kind."""
    return [[room, *(f"{reached:,} of {every:,}" + (f"  {percent(reached, every):5.1f} %" if every else "")
                     for reached, every in counted.values())] for room, counted in rooms.items()]
