# SPDX-License-Identifier: MIT
"""The clauses that fixel trace --break breaks, as a campaign (fixel/campaign/shards.py): each is a shard. A process breaks its
clauses in a copy of the sources of its own."""

import contextlib
import functools
import pathlib
import shlex

from fixel.base import scratch
from fixel.campaign import runner
from fixel.campaign.shards import Shard
from fixel.check import mutants, survivors, trace, trace_break

SHARD_SETUP = "units"
_copies = contextlib.ExitStack()        # of this process


@functools.cache
def _rows():
    """The rows of the checkout's trace."""
    return trace.join(*trace.read(trace.CHECKOUT))


@functools.cache
def _breaker(build, units, compiler):
    folder = _copies.enter_context(scratch.folder("trace", build))
    known = survivors.load(trace.CHECKOUT / trace.SURVIVORS, trace.CHECKOUT, mutants.mutants_of)
    return trace_break.Breaker(trace_break.Tree(folder / "tree", shlex.join(shlex.split(compiler)), pathlib.Path(units).resolve(),
                                                trace.CHECKOUT), known)


def _parts(parameters):
    """(the row of a clause, the tests that run, the seeded bugs that they can see)."""
    row = _rows()[parameters["clause"]]
    return row, trace_break.suites_of(row["tests"]), list(filter(trace_break.is_seen_here, row["bugs"]))


def run_shard(build, parameters):
    """What breaking a clause shows."""
    row, suites, bugs = _parts(parameters)
    if not suites:
        return {"clause": row["id"], "shown": False, "by": "no unit test of the host has it", "tried": []}
    return _breaker(build.resolve(), parameters["units"], parameters["compiler"]).clause(row["id"], row["code"], suites, bugs)


def shard_inputs(_build, parameters):
    row, suites, bugs = _parts(parameters)
    return trace_break.inputs(row["id"], row["code"], suites, bugs, trace.CHECKOUT, pathlib.Path(parameters["units"]).resolve(),
                              parameters["compiler"])


def shard_targets(_build, parameters):
    return [f"{parameters['units']}/{suite.name}" for suite in _parts(parameters)[1]]


def break_all(rows, options):
    """What breaking each of the rows gave, in their order."""
    some = [Shard("trace", number, {"clause": row["id"], "units": options.units, "compiler": options.cc}, "clause", 0)
            for number, row in enumerate(rows)]
    done = runner.run("clauses broken", some, options)
    done.tell(options.build)
    return runner.whole(done)
