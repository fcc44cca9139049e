# SPDX-License-Identifier: MIT
"""Frozen frames: what a scene image draws, as hashes that never change.

A frame is a function of the scene image alone: not of the board, the clipper's caches, the
bands or the list. So the record of an image is found by the image's own CRC-32, and a changed
scene file is a new record, not a changed one.
"""

import json
import pathlib

from fixel.base import output
from fixel.base.errors import ToolError

FILE = pathlib.Path(__file__).resolve().parents[3] / "host_tests" / "judges" / "frames" / "hashes.json"
DIGITS = 16     # of a frame's SHA-256: 64 bits
# What became of the polygons; what depends on memory (spilled) or on the caller is left out.
COUNTERS = ("in", "backfacing", "outside", "degenerate", "refused", "drawn", "clipped")


def image_key(image):
    """The CRC-32 that an image states of itself, as the file's key."""
    return pathlib.Path(image).read_bytes()[12:16][::-1].hex()


def record_of(name, drawn):
    """The record of a dump: a hash for each frame, and the counters added up."""
    return {"scene": name,
            "counters": {what: sum(frame.counters[what] for frame in drawn.frames) for what in COUNTERS},
            "frames": [frame.sha256[:DIGITS] for frame in drawn.frames]}


def load(file=FILE):
    """All records: key -> record."""
    try:
        return json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ToolError(f"{file}: cannot be read: {error}") from error


def save(records, file=FILE):
    """Writes all records, in the order of the scenes' names."""
    ordered = dict(sorted(records.items(), key=lambda item: (item[1]["scene"], item[0])))
    output.write_file(file, json.dumps(ordered, indent=1) + "\n")


def difference(record, drawn):
    """The first difference between a dump and its record, as a sentence; "" where they agree."""
    ours, frozen = record_of(record["scene"], drawn), record["frames"]
    if len(ours["frames"]) != len(frozen):
        return f"{len(ours['frames'])} frames, {len(frozen)} are on record"
    for number, (one, other) in enumerate(zip(ours["frames"], frozen)):
        if one != other:
            return f"frame {number} has the hash {one}, on record is {other}"
    if ours["counters"] != record["counters"]:
        return f"counters are {ours['counters']}, on record are {record['counters']}"
    return ""
