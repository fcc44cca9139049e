# SPDX-License-Identifier: MIT
"""Adds the frame hashes of scenes to host_tests/judges/frames/hashes.json. Changes no record.

    fixel frame-hashes SCENE... [--tree LAYERS] [--name NAME] [--build DIR]

SCENE is a .toml, an .obj or an .fxls. The tool compiles each scene, draws it on the host, and adds it under its name,
which is the file's without the suffix, or NAME. If the name has a record already, the scene must draw the same frames.
LAYERS takes the place of the scene's key "tree", as in fixel build.
A frame depends on what the scene says: not on the board, the clipper's caches, the bands or the list. A scene whose file or image
changes and whose frames stay keeps its record. Exit: 0 all scenes have records, 1 a scene draws other frames than its record, 2 the tool could not run.
"""

import argparse
import json
import pathlib
import sys

from fixel.base import output, scratch
from fixel.base.errors import one_line, ToolError
from fixel.commands import late
from fixel.scene import making

dump, programs = late("fixel.board", "dump programs")

FILE = pathlib.Path(__file__).resolve().parents[3] / "host_tests" / "judges" / "frames" / "hashes.json"
DIGITS = 16     # of a frame's SHA-256: 64 bits
# What became of the polygons; what depends on memory (spilled) or on the caller is left out.
COUNTERS = ("in", "backfacing", "outside", "degenerate", "refused", "drawn", "clipped")


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    made.add_argument("scenes", nargs="+", metavar="SCENE")
    made.add_argument("--tree", metavar="LAYERS", help="layers that are to have a tree, or none")
    made.add_argument("--name", help="the record's name; for one scene")
    made.add_argument("--build", default="build")
    return made


def main(argv):
    options = parser().parse_args(argv)
    if options.name and len(options.scenes) > 1:
        raise ToolError("--name is for one scene")
    records = load()
    with scratch.folder("hashes") as folder:
        for scene in options.scenes:
            done = add(scene, records, options.build, folder, options.name, options.tree)
            print(f"{one_line(scene)}: {done}", file=sys.stderr)
    save(records)
    return 0


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
    programs.run_program([pathlib.Path(build) / "host" / "frames", image, out])
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
