# SPDX-License-Identifier: MIT
"""Frozen frames: what a scene draws, as hashes that never change.

A frame depends on what the scene says: not on the board, the clipper's caches, the bands or the list. A record is found by
the scene's name. So a scene whose file or image changes and whose frames stay keeps its record.
"""

import json
import pathlib

from fixel.base import output
from fixel.base.errors import ToolError
from fixel.board import dump
from fixel.board.programs import run_program
from fixel.scene import making

FILE = pathlib.Path(__file__).resolve().parents[3] / "host_tests" / "judges" / "frames" / "hashes.json"
DIGITS = 16     # of a frame's SHA-256: 64 bits
# What became of the polygons; what depends on memory (spilled) or on the caller is left out.
COUNTERS = ("in", "backfacing", "outside", "degenerate", "refused", "drawn", "clipped")


def record_of(drawn):
    """The record of a dump: a hash for each frame, and the counters added up."""
    return {"counters": {what: sum(frame.counters[what] for frame in drawn.frames) for what in COUNTERS},
            "frames": [frame.sha256[:DIGITS] for frame in drawn.frames]}


def load(file=FILE):
    """All records: the scene's name -> record."""
    try:
        return json.loads(pathlib.Path(file).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ToolError(f"{file}: cannot be read: {error}") from error


def save(records, file=FILE):
    """Writes all records, in the order of the scenes' names."""
    output.write_file(file, json.dumps(dict(sorted(records.items())), indent=1) + "\n")


def difference(record, drawn):
    """The first difference between a dump and its record, as a sentence; "" where they agree."""
    ours, frozen = record_of(drawn), record["frames"]
    if len(ours["frames"]) != len(frozen):
        return f"{len(ours['frames'])} frames, {len(frozen)} are on record"
    for number, (one, other) in enumerate(zip(ours["frames"], frozen)):
        if one != other:
            return f"frame {number} has the hash {one}, on record is {other}"
    if ours["counters"] != record["counters"]:
        return f"counters are {ours['counters']}, on record are {record['counters']}"
    return ""


def drawn_by_host(image, build, folder):
    """The frames of an image as build/host/frames draws them."""
    out = folder / "frames.fxld"
    run_program([pathlib.Path(build) / "host" / "frames", image, out])
    return dump.read_dump(out)


def add(scene, records, build, folder, name=None, layers=None):
    """Adds a scene's record; answers what was done, as a word. layers: those that are to have a tree, instead of what the
    scene says."""
    image = pathlib.Path(scene)
    if image.suffix != ".fxls":
        image = folder / "scene.fxls"
        making.build(str(scene), str(image), layers=layers)
    name, drawn = name or pathlib.Path(scene).stem, drawn_by_host(image, build, folder)
    if name in records:
        wrong = difference(records[name], drawn)
        if wrong:
            raise ToolError(f"{scene}: {wrong}", exit_code=1)
        return "on record"
    records[name] = record_of(drawn)
    return "added"
