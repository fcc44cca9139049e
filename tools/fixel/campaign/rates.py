# SPDX-License-Identifier: MIT
"""How fast the shards of a campaign are, and how long large campaigns take."""

from fixel.base.table import table

LARGE = {"10^9": 10 ** 9, "10^10": 10 ** 10, "10^12": 10 ** 12}
HOUR = 3600.0


def of(kind, some, samples, spent):
    """A row: so many samples, of some shards, which took so many seconds."""
    return {"kind": kind, "shards": len(some), "samples": samples, "seconds": round(spent, 3),
            "shard_seconds": round(spent / len(some), 3), "samples_a_second": round(samples / spent, 1) if samples and spent else None,
            "core_hours": {name: round(spent / samples * count / HOUR, 3) if samples else None for name, count in LARGE.items()}}


def rows(done, seconds):
    """[{"kind", "shards", "samples", "seconds", "shard_seconds", "samples_a_second", "core_hours": {"10^9": ...}}] of the
    shards that are done; seconds: {number: CPU seconds}."""
    kinds = {}
    for shard in done:
        kinds.setdefault(shard.kind, []).append(shard)
    return [of(kind, some, sum(shard.samples for shard in some), sum(seconds[shard.number] for shard in some))
            for kind, some in kinds.items()]


def whole(made, planned, size):
    """The row of a campaign of so many samples, of which each kind of shards has its share: planned has all its shards."""
    takes = {row["kind"]: row["seconds"] / row["samples"] for row in made}
    return of("all, in proportion", planned, size, sum(takes[shard.kind] * shard.samples for shard in planned))


def shown(made):
    """The table for people. Shards that are no samples have a rate and nothing else."""
    if not any(row["samples"] for row in made):
        return table([[row["kind"], row["shards"], row["shard_seconds"]] for row in made], ["kind", "shards", "CPU s a shard"])
    return table([[row["kind"], row["samples"], row["shard_seconds"], row["samples_a_second"], *row["core_hours"].values()]
                  for row in made],
                 ["kind", "samples", "CPU s a shard", "samples a CPU s", *(f"core hours of {name}" for name in LARGE)])
