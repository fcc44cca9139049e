# SPDX-License-Identifier: MIT
"""Runs the shards of a campaign: those that an earlier command has kept are not computed again, the others run on this
machine or on a cluster. Results come in the order of the shards, so whoever merges them in that order gets the same
result however many processes there were and whatever was kept.

A result is kept when its shard is done, in the folder shards of the build folder, under the content of all that it depends
on. A campaign that is stopped goes on where it was, with the same command.
"""

import contextlib
import itertools
import os
import pathlib
import re
import sys

from fixel.base import children, kept, output
from fixel.base.arguments import whole_number
from fixel.base.errors import ToolError
from fixel.base.progress import Progress
from fixel.base.table import table
from fixel.campaign import local, shards

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
JOBS_MAX = 1024
ADDRESS = re.compile(r"(tcp|tls)://[^/\s]+:\d{1,5}")
FOLDER, MOST = "shards", 4_000_000_000      # bytes: a hundred campaigns
LARGE = {"10^9": 10 ** 9, "10^10": 10 ** 10, "10^12": 10 ** 12}
HOUR = 3600.0


def add_options(parser):
    """Those of each campaign."""
    parser.add_argument("--jobs", default="0", help="processes at a time; 0: one for each core (JOBS=)")
    parser.add_argument("--cluster", default="", metavar="tcp://HOST:PORT",
                        help="a Dask scheduler, whose workers compute the shards (CLUSTER=)")
    kept.add_option(parser)


def check(options):
    """Refuses what is no number of processes, or no address."""
    jobs_of(options)
    if options.cluster and not ADDRESS.fullmatch(options.cluster):
        raise ToolError(f"CLUSTER is '{options.cluster}'; it must be the address of a Dask scheduler, such as tcp://192.168.1.7:8786")


def jobs_of(options):
    """How many processes there are."""
    return whole_number("--jobs", str(options.jobs), 0, JOBS_MAX) or os.cpu_count() or 1


def _pool(options, todo):
    check(options)
    if not options.cluster:
        return local.Pool(options.build, min(jobs_of(options), len(todo)))
    if children.run(["tools/setup.sh", "cluster"], cwd=CHECKOUT, stdout=None, stderr=None).returncode:
        raise ToolError("CLUSTER needs the Python package Dask, and set-up could not install it; its words are above")
    from fixel.campaign import cluster      # it needs packages that nothing else needs
    return cluster.Pool(options.cluster)


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

    def add(self, other):
        """Takes what is done of other shards of the campaign."""
        self.shards += other.shards
        self.results.update(other.results)
        self.seconds.update(other.seconds)
        self.kept += other.kept

    def in_order(self):
        """The results, of all shards."""
        return [self.results[shard.number] for shard in self.shards]

    def tell(self, build, size=None):
        """How far it went and how fast, for people and as JSON. size: of the campaign in samples, where each kind of shards
        has a share of them."""
        done = [shard for shard in self.shards if shard.number in self.results]
        made = rates_of(done, self.seconds)
        if size and len(made) > 1:
            made.append(rate_of_whole(made, self.shards, size))
        output.write_json(pathlib.Path(build) / "campaigns" / f"{self.shards[0].campaign}.json",
                          {"shards": len(self.shards), "done": len(done), "kept": self.kept, "kinds": made})
        print(f"{self.label}: {len(done):,} of {len(self.shards):,} shards done, {self.kept:,} of them by earlier commands",
              file=sys.stderr)
        print(rates_as_text(made), file=sys.stderr)


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

    with _pool(options, todo) as pool, contextlib.closing(pool.compute(todo, go_on)) as answers:
        for shard, answer in answers:
            done.take(shard, answer)
            budget.spent += answer["seconds"]
            lasts = not (isinstance(answer["result"], dict) and shards.AGAIN in answer["result"])
            if store.writes and lasts and keys.key(shard) == wanted[shard.number]:    # nobody has built the programs anew meanwhile
                store.keep_value(wanted[shard.number], answer)
            progress(len(done.results))


def whole(done):
    """The results of a campaign of which every shard must be done."""
    if len(done.results) < len(done.shards):
        raise ToolError(f"{done.label}: {len(done.shards) - len(done.results):,} shards are missing")
    return done.in_order()


# --- how fast the shards are, and how long large campaigns take ---------------------

def rate_of(kind, some, samples, spent):
    """A row: so many samples, of some shards, which took so many seconds."""
    return {"kind": kind, "shards": len(some), "samples": samples, "seconds": round(spent, 3),
            "shard_seconds": round(spent / len(some), 3), "samples_a_second": round(samples / spent, 1) if samples and spent else None,
            "core_hours": {name: round(spent / samples * count / HOUR, 3) if samples else None for name, count in LARGE.items()}}


def rates_of(done, seconds):
    """[{"kind", "shards", "samples", "seconds", "shard_seconds", "samples_a_second", "core_hours": {"10^9": ...}}] of the
    shards that are done; seconds: {number: CPU seconds}."""
    kinds = {}
    for shard in done:
        kinds.setdefault(shard.kind, []).append(shard)
    return [rate_of(kind, some, sum(shard.samples for shard in some), sum(seconds[shard.number] for shard in some))
            for kind, some in kinds.items()]


def rate_of_whole(made, planned, size):
    """The row of a campaign of so many samples, of which each kind of shards has its share: planned has all its shards."""
    takes = {row["kind"]: row["seconds"] / row["samples"] for row in made}
    return rate_of("all, in proportion", planned, size, sum(takes[shard.kind] * shard.samples for shard in planned))


def rates_as_text(made):
    """The table for people. Shards that are no samples have a rate and nothing else."""
    if not any(row["samples"] for row in made):
        return table([[row["kind"], row["shards"], row["shard_seconds"]] for row in made], ["kind", "shards", "CPU s a shard"])
    return table([[row["kind"], row["samples"], row["shard_seconds"], row["samples_a_second"], *row["core_hours"].values()]
                  for row in made],
                 ["kind", "samples", "CPU s a shard", "samples a CPU s", *(f"core hours of {name}" for name in LARGE)])
