# SPDX-License-Identifier: MIT
"""Runs the shards of a campaign: those that an earlier command has kept are not computed again, the others run on this
machine. Results come in the order of the shards, so whoever merges them in that order gets the same
result however many processes there were and whatever was kept.

A result is kept when its shard is done, in the folder shards of the build folder, under the content of all that it depends
on. A campaign that is stopped goes on where it was, with the same command.
"""

import contextlib
import itertools
import os
import pathlib
import sys

from fixel.base import kept, output
from fixel.base.arguments import whole_number
from fixel.base.errors import ToolError
from fixel.base.progress import Progress
from fixel.campaign import local, rates, shards

JOBS_MAX = 1024
FOLDER, MOST = "shards", 4_000_000_000      # bytes: a hundred campaigns


def add_options(parser):
    """Those of each campaign."""
    parser.add_argument("--jobs", default="0", help="processes at a time; 0: one for each core (JOBS=)")
    kept.add_option(parser)


def jobs_of(options):
    """How many processes there are."""
    return whole_number("--jobs", str(options.jobs), 0, JOBS_MAX) or os.cpu_count() or 1


class Budget:
    """CPU seconds that a command may spend on shards; None: any number. spent: those of shards that this command computed."""

    def __init__(self, seconds=None):
        self.seconds, self.spent = seconds, 0.0

    def is_left(self):
        return self.seconds is None or self.spent < self.seconds


class Done:
    """What is done of a campaign: results (shard's number: result), and how many of them were kept."""

    def __init__(self, label, some):
        self.label, self.shards, self.results, self.seconds, self.kept = label, some, {}, {}, 0

    def take(self, shard, answer):
        self.results[shard.number], self.seconds[shard.number] = answer["result"], answer["seconds"]

    def in_order(self):
        """The results, of all shards."""
        return [self.results[shard.number] for shard in self.shards]

    def tell(self, build):
        """How far it went and how fast, for people and as JSON."""
        done = [shard for shard in self.shards if shard.number in self.results]
        table = rates.rows(done, self.seconds)
        output.write_json(pathlib.Path(build) / "campaigns" / f"{self.shards[0].campaign}.json",
                          {"shards": len(self.shards), "done": len(done), "kept": self.kept, "kinds": table})
        print(f"{self.label}: {len(done):,} of {len(self.shards):,} shards done, {self.kept:,} of them by earlier commands",
              file=sys.stderr)
        print(rates.shown(table), file=sys.stderr)


def run(label, some, options, budget=None, first=0):
    """Done: some shards, of one campaign, numbered from 0. Of those that stand behind the first ones, no more are begun once
    the budget is spent."""
    budget, done = budget or Budget(), Done(label, some)
    store = kept.Kept(options.build, options.fresh, FOLDER, MOST)
    keys = shards.Keys(options.build)
    todo = []
    for shard in some:
        found = store.value(keys.key(shard)) if store.reads else None
        if found is None:
            todo.append(shard)
        else:
            done.take(shard, found)
            done.kept += 1
    must = sum(shard.number < first for shard in todo)
    with Progress(label, len(some)) as progress:
        progress(done.kept)
        if todo:
            _compute(todo, options, (budget, must), done, (store, keys, progress))
    return done


def _compute(todo, options, limit, done, to):
    budget, must = limit
    store, keys, progress = to
    wanted = {shard.number: keys.key(shard) for shard in todo} if store.writes else {}
    begun = itertools.count()

    def go_on():
        return next(begun) < must or budget.is_left()

    with local.Pool(options.build, min(jobs_of(options), len(todo))) as pool, contextlib.closing(pool.compute(todo, go_on)) as answers:
        for shard, answer in answers:
            done.take(shard, answer)
            budget.spent += answer["seconds"]
            if store.writes and keys.key(shard) == wanted[shard.number]:    # nobody has built the programs anew meanwhile
                store.keep_value(wanted[shard.number], answer)
            progress(len(done.results))


def whole(done):
    """The results of a campaign of which every shard must be done."""
    if len(done.results) < len(done.shards):
        raise ToolError(f"{done.label}: {len(done.shards) - len(done.results):,} shards are missing")
    return done.in_order()
