# SPDX-License-Identifier: MIT
"""Campaigns: commands whose work is numbered shards, run by processes of this machine or of a cluster.

`shards.py` says what a shard is, which modules are campaigns, and what each of them must have. `runner.py` takes the shards
that an earlier command has kept, has the others computed, keeps each when it is done, and answers all results in their order.
It prints how fast they are and how long large campaigns take, which `build/campaigns/NAME.json` has too. `local.py` computes
them in processes of this machine; `server.py` is the inside of such a process.

`cluster.py` has the shards computed by the workers of a Dask scheduler, and `worker.py`, which is sent to them, is what they
do: they build the checkout and start `server.py` of it. `sent.py` says which files of the checkout they get. docs/campaigns.md
says how a cluster is started.
"""
