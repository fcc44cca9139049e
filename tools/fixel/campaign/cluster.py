# SPDX-License-Identifier: MIT
"""Shards on a cluster: the workers of a Dask scheduler build the checkout as it is here and compute them (worker.py)."""

import json
import logging
import pathlib
import zlib

import cloudpickle
import distributed

from fixel.base import kept
from fixel.base.errors import ToolError, one_line
from fixel.campaign import sent, shards, worker
from fixel.campaign.local import checked, describe

CHECKOUT = pathlib.Path(__file__).resolve().parents[3]
PATIENCE = 30           # seconds for the scheduler, and for its first worker
AHEAD = 3               # shards of each thread of a worker that are there or on their way
# The workers have no module of Fixel, so these are sent as they stand. Dask does that with what is of __main__.
cloudpickle.register_pickle_by_value(worker)
worker.compute.__module__ = worker.Checkout.__module__ = "__main__"
RETRIES = 3             # of a shard whose worker fails otherwise than by a sentence


def files(root=CHECKOUT):
    """The paths of the checkout's files, without git as a worker lists them."""
    return sent.of_git(root) if (root / ".git").exists() else sent.inside(root, worker.files(root))


def connect(address):
    """The client of a scheduler that has a worker."""
    logging.disable(logging.ERROR)      # what matters comes as an answer
    try:
        client = distributed.Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, TimeoutError, ValueError) as error:
        raise ToolError(f"CLUSTER={address}: no Dask scheduler answers there: {one_line(error)}") from error
    try:
        client.wait_for_workers(1, timeout=PATIENCE)
    except TimeoutError as error:
        client.close()
        raise ToolError(f"CLUSTER={address}: the scheduler there has no worker; start some: dask worker {address}") from error
    return client


class Pool:
    """The workers of a scheduler; as local.Pool."""

    def __init__(self, address, root=CHECKOUT):
        tar = worker.archive(root, files(root))
        self.checkout = worker.name_of(tar)
        self._client = connect(address)
        try:
            self._client.register_plugin(worker.Checkout(self.checkout, zlib.compress(tar)))
        except Exception as error:
            self._client.close()
            raise ToolError(f"CLUSTER={address}: its workers do not take the checkout: {one_line(error)}; they need the versions "
                            f"of Python and Dask that are here") from error

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._client.close()

    def submit(self, shard):
        """A shard's future. Its name on the cluster is that of its checkout and its parameters."""
        module = shards.module_of(shard.campaign)
        request = {"campaign": shard.campaign, "parameters": shard.parameters}
        key = kept.key_of([self.checkout, json.dumps(request, sort_keys=True)])
        return self._client.submit(worker.compute, self.checkout, request, module.SHARD_SETUP,
                                   module.shard_targets(pathlib.Path("build"), shard.parameters), key=f"fixel-{key}", retries=RETRIES)

    def _width(self):
        """How many shards are given to the cluster at a time: workers may come and go."""
        return AHEAD * max(1, sum(each["nthreads"] for each in self._client.scheduler_info(n_workers=-1)["workers"].values()))

    def compute(self, todo, go_on):
        todo, waiting = iter(todo), {}
        answers = distributed.as_completed(loop=self._client.loop)
        while True:
            while len(waiting) < self._width() and go_on():
                shard = next(todo, None)
                if shard is None:
                    break
                future = self.submit(shard)
                waiting[future] = shard
                answers.add(future)
            if not waiting:
                return
            future = next(answers)
            yield waiting[future], self._answer(waiting.pop(future), future)

    @staticmethod
    def _answer(shard, future):
        if future.status != "finished":
            raise ToolError(f"{describe(shard)}: its worker failed: {one_line(future.exception() or future.status)}")
        said = future.result()
        if "refused" in said:
            raise ToolError(f"{describe(shard)}: {said['refused']}")
        return checked(shard, said)
