# SPDX-License-Identifier: MIT
"""How fast the shards of a campaign are, and how long large campaigns take."""

from fixel.base.table import table

LARGE = {"10^9": 10 ** 9, "10^10": 10 ** 10, "10^12": 10 ** 12}
HOUR = 3600.0


def rows(done, seconds):
    """[{"kind", "shards", "samples", "seconds", "shard_seconds", "samples_a_second", "core_hours": {"10^9": ...}}] of the
    shards that are done; seconds: {number: CPU seconds}."""
    kinds = {}
    for shard in done:
        kinds.setdefault(shard.kind, []).append(shard)
    made = []
    for kind, some in kinds.items():
        spent, samples = sum(seconds[shard.number] for shard in some), sum(shard.samples for shard in some)
        made.append({"kind": kind, "shards": len(some), "samples": samples, "seconds": round(spent, 3),
                     "shard_seconds": round(spent / len(some), 3),
                     "samples_a_second": round(samples / spent, 1) if spent else None,
                     "core_hours": {name: round(spent / samples * count / HOUR, 3) for name, count in LARGE.items()}})
    return made


def shown(made):
    """The table for people."""
    return table([[row["kind"], row["samples"], row["shard_seconds"], row["samples_a_second"], *row["core_hours"].values()]
                  for row in made],
                 ["kind", "samples", "CPU s a shard", "samples a CPU s", *(f"core hours of {name}" for name in LARGE)])
