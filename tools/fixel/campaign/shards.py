# SPDX-License-Identifier: MIT
"""A shard: a numbered part of a campaign, whose result depends on the checkout and its own parameters alone.

A campaign is a module that has
    run_shard(build, parameters)        the result, which JSON holds; build: the folder that make builds in
    shard_inputs(build, parameters)     what it depends on beside the parameters: paths of files, and texts
    SHARD_SETUP                         what tools/setup.sh installs for it
    shard_targets(build, parameters)    what make builds for it
A result has no time, no path of this machine, and nothing of a generator of random numbers that the parameters do not seed.
"""

import dataclasses
import hashlib
import importlib
import json
import os
import pathlib

from fixel.base import kept
from fixel.base.errors import ToolError

CAMPAIGNS = {
    "clippers": "fixel.bench.clippers_run",
    "equality": "fixel.check.equality",
    "fuzz": "fixel.check.fuzz",
    "library-mutants": "fixel.check.library_mutants",
    "prove": "fixel.prove.proving",
    "report": "fixel.report.report_shards",
    "tools-mutants": "fixel.check.tool_mutants",
    "trace": "fixel.check.trace_break",
}
AGAIN = "again"     # a result that has this key is not kept: another run may end otherwise


@dataclasses.dataclass(frozen=True)
class Shard:
    """number: its place in the campaign, which is its place in the merge. parameters: what JSON holds. kind: shards of one kind
    take the same time a sample. samples: how many it has, 0 if it is none of samples."""
    campaign: str
    number: int
    parameters: dict
    kind: str
    samples: int


def module_of(campaign):
    """The module of a campaign."""
    return importlib.import_module(CAMPAIGNS[campaign])


class Keys:
    """The keys under which results are kept. A file is read once while it stays as it is."""

    def __init__(self, build):
        self._build, self._digests = pathlib.Path(build), {}

    def _digest(self, path):
        try:
            state = os.stat(path)
        except OSError as error:
            raise ToolError(f"{path}: cannot be read: {error.strerror}; make all builds the programs of campaigns") from error
        name = (os.fspath(path), state.st_mtime_ns, state.st_size, state.st_ino)
        if name not in self._digests:
            with open(path, "rb") as file:
                self._digests[name] = hashlib.file_digest(file, "sha256").hexdigest()
        return self._digests[name]

    def key(self, shard):
        """Of the campaign, the parameters, and the content of all inputs."""
        inputs = module_of(shard.campaign).shard_inputs(self._build, shard.parameters)
        return kept.key_of([shard.campaign, json.dumps(shard.parameters, sort_keys=True),
                            *((self._digest(each) if isinstance(each, os.PathLike) else each) for each in inputs)])
