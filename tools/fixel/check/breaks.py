# SPDX-License-Identifier: MIT
"""Breaks what the project claims, by a list that was written without reading the tests, and says which commands notice.

    fixel breaks --units DIR --cc COMMAND [--seed N] [--draw N | --only WORD] [--samples N] [--build DIR]

The entries of host_tests/breaks with blind = true are of four kinds. --seed draws the same number of each kind. Each is made in a copy of
the checkout below DIR/breaks, and never in the checkout. The entry's command runs there in its narrowest form; if it
passes, the unit tests of the host, and then the proofs of the file. A break is noticed if a command fails and names what
the entry says. Writes DIR/breaks/breaks.json.
Exit: 0 nine of ten are noticed, 1 fewer, 2 could not run.
"""

import argparse
import concurrent.futures
import os
import pathlib
import random
import sys

from fixel.base import output, spent
from fixel.base.errors import ToolError
from fixel.base.progress import Progress
from fixel.base.table import coloured, table
from fixel.check import break_commands, planting

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
ENOUGH = 0.9        # of the breaks must be noticed
RESULTS = (break_commands.NAMED, break_commands.UNNAMED, break_commands.PASSED)


def blind(root):
    """The breaks that it draws from, by their ids: a seed draws the same ones wherever their lines move."""
    return sorted((each for each in planting.entries(root) if each.blind), key=lambda each: each.id)


def draw(breaks, seed, count):
    """So many breaks, the same number of each kind, or one more of the first kinds; all of a kind that has fewer."""
    drawn, kinds = [], list(planting.BLIND_KINDS)
    for place, kind in enumerate(kinds):
        those = [each for each in breaks if each.kind == kind]
        share = count // len(kinds) + (place < count % len(kinds))
        drawn += random.Random(f"{seed} {kind}").sample(those, min(share, len(those)))
    return drawn


def try_break(each, commands):
    """The steps of a break: what each command gave, up to the one that fails and names it; at most one more fails."""
    steps = []
    for command in commands.of(each):
        steps.append(command(each))
        if steps[-1].result == break_commands.NAMED:
            break
    return steps


def try_all(drawn, commands):
    """The rows of all breaks, in their order. Those whose commands run in different copies are tried side by side."""
    rows = {}

    def one_copy(name):
        for each in (each for each in drawn if commands.copy_of(each) == name):
            print(f"breaks: {each.id}: {each.why}", file=sys.stderr, flush=True)
            rows[each.id] = row(each, try_break(each, commands))
            progress(len(rows))

    with Progress("breaks", len(drawn)) as progress, concurrent.futures.ThreadPoolExecutor() as pool:
        list(pool.map(one_copy, break_commands.COPIES))
    return [rows[each.id] for each in drawn]


def best(steps):
    """The result of a break, from those of its commands."""
    return min((step.result for step in steps), key=RESULTS.index, default=break_commands.PASSED)


def row(each, steps):
    """A break as the JSON file has it."""
    return {"id": each.id, "kind": each.kind, "file": each.file, "what": each.why, "command": each.command, "names": each.names,
            "result": best(steps), "steps": [vars(step) for step in steps]}


def print_rows(rows, stale):
    """For people."""
    for words in stale:
        print(f"not drawn: {words}")
    red = {break_commands.NAMED: "", break_commands.UNNAMED: "yellow", break_commands.PASSED: "red"}
    print(table([[each["id"], each["steps"][-1]["command"] if each["steps"] else each["command"], each["names"],
                  coloured(each["result"], red[each["result"]]) if red[each["result"]] else each["result"]] for each in rows],
                ["break", "command", "must name", "result"]))
    for each in rows:
        if each["result"] != break_commands.NAMED:
            print(f"{each['id']}: {each['file']}: {each['what']}")
            for step in each["steps"]:
                print(f"  {step['command']}: {step['result']}{': ' if step['words'] else ''}{step['words']}")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--root", default=str(CHECKOUT), help="the checkout to copy from")
    made.add_argument("--build", default="build", help="the build folder")
    made.add_argument("--units", required=True, help="the folder of the unit tests that make has built")
    made.add_argument("--cc", required=True, help="the compiler and the flags of the unit tests")
    made.add_argument("--seed", default="1", help="draws the breaks (SEED=)")
    made.add_argument("--draw", type=int, default=20, help="how many (DRAW=)")
    made.add_argument("--only", default="", help="all breaks with this in their id, kind or file, and none drawn (ONLY=)")
    made.add_argument("--samples", type=int, default=1_000_000, help="of make report (SAMPLES=)")
    made.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    return made


def before(options):
    """Refuses a word that no break has, and a number that draws none."""
    if options.only and not any(each.is_called(options.only) for each in blind(options.root)):
        raise ToolError(f"no break of {planting.FOLDER} has '{options.only}' in its id, kind or file")
    if options.draw < 1 or options.samples < 1:
        raise ToolError("DRAW= is less than 1" if options.draw < 1 else "SAMPLES= is less than 1")


def main(argv):
    options = parser().parse_args(argv)
    every = blind(options.root)
    stale = planting.stale(options.root, every)
    ready = [each for each in every if each.id not in stale]
    drawn = [each for each in ready if each.is_called(options.only)] if options.only else \
        draw(ready, options.seed, options.draw)
    if not drawn:
        raise ToolError(f"no break of {planting.FOLDER} has '{options.only}' in its id, kind or file" if options.only else
                        "DRAW= is less than 1")
    rows = try_all(drawn, break_commands.Commands(options, drawn))
    noticed = sum(each["result"] == break_commands.NAMED for each in rows)
    file = pathlib.Path(options.build) / "breaks/breaks.json"
    output.write_json(file, {"seed": options.seed, "only": options.only, "listed": len(every), "noticed": noticed,
                             "stale": list(stale.values()), "breaks": rows})
    print_rows(rows, stale.values())
    spent.tell()
    counts = ", ".join(f"{sum(each['result'] == result for each in rows)} {result}" for result in RESULTS)
    print(f"{noticed} of {len(rows)} breaks noticed ({counts}); of {len(every)} in the list {len(stale)} are stale; "
          f"{'' if options.only else f'seed {options.seed}; '}{file}")
    return 0 if noticed >= ENOUGH * len(rows) else 1
