# SPDX-License-Identifier: MIT
"""Library and reference renderer on the same input at the boundary of each stage: the polygons of a scene, and
random input from the whole allowed range."""

from fixel.base import output
from fixel.image import image
from fixel.base.progress import Progress

STAGES = ("sphere", "clip", "clip_world", "transform", "project", "list", "fill", "cover", "split", "light", "placement")
KEYS = ("stage", "input", "samples", "max", "mean", "unit", "measure", "bound", "beyond_bound", "mismatched")
# A stage gets one random sample for this many samples of the report.
SAMPLES_PER = 50


def measure(programs, walk, samples, seed, folder):
    """A row for each stage and input."""
    file = folder / "twins.fxls"
    output.write_file(file, image.pack(walk.scene))
    count = max(1000, samples // SAMPLES_PER)
    with Progress(f"stages against double: {walk.name} and {count:,} random samples each"):
        rows = programs.stage_errors(file, count, seed)
    order = {name: place for place, name in enumerate(STAGES)}
    rows.sort(key=lambda row: (order.get(row["stage"], len(order)), row["input"] != "scene"))
    # No row without samples: a scene without beams has none for light, an unclipped scene none for clip.
    return [{key: row[key] for key in KEYS} for row in rows if row["samples"] > 0]


def complaints(rows):
    """What exceeded its bound, as sentences."""
    measured = {row["stage"] for row in rows if row["input"] == "random"}
    return [f"{stage}: no random sample was compared with double" for stage in STAGES if stage not in measured] + \
           [f"{row['stage']} on {row['input']} input: {row['beyond_bound'] + row['mismatched']:,} of "
            f"{row['samples']:,} samples exceed the bound ({row['bound']})"
            for row in rows if row["beyond_bound"] or row["mismatched"]]
