# SPDX-License-Identifier: MIT
"""Adds the frame hashes of scenes to host_tests/judges/frames/hashes.json. Changes no record.

    fixel frame-hashes SCENE... [--tree LAYERS] [--name NAME] [--build DIR]

SCENE is a .toml, an .obj or an .fxls. The tool compiles each scene, draws it on the host, and adds it under its name,
which is the file's without the suffix, or NAME. If the name has a record already, the scene must draw the same frames.
LAYERS takes the place of the scene's key "tree", as in fixel build.
Exit: 0 all scenes have records, 1 a scene draws other frames than its record, 2 the tool could not run.
"""

import argparse
import pathlib
import sys

from fixel.base import scratch
from fixel.scene import making
from fixel.board import dump
from fixel.check import frozen_frames
from fixel.base.errors import ToolError, one_line
from fixel.board.programs import run_program


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
        wrong = frozen_frames.difference(records[name], drawn)
        if wrong:
            raise ToolError(f"{scene}: {wrong}", exit_code=1)
        return "on record"
    records[name] = frozen_frames.record_of(drawn)
    return "added"


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("scenes", nargs="+", metavar="SCENE")
    parser.add_argument("--tree", metavar="LAYERS", help="layers that are to have a tree, or none")
    parser.add_argument("--name", help="the record's name; for one scene")
    parser.add_argument("--build", default="build")
    options = parser.parse_args(argv)
    if options.name and len(options.scenes) > 1:
        raise ToolError("--name is for one scene")
    records = frozen_frames.load()
    with scratch.folder("hashes") as folder:
        for scene in options.scenes:
            done = add(scene, records, options.build, folder, options.name, options.tree)
            print(f"{one_line(scene)}: {done}", file=sys.stderr)
    frozen_frames.save(records)
    return 0
