# SPDX-License-Identifier: MIT
"""Adds the frame hashes of scenes to host_tests/judges/frames/hashes.json. Changes no record.

    fixel frame-hashes SCENE... [--tree LAYERS] [--name NAME] [--build DIR]

SCENE is a .toml, an .obj or an .fxls. The tool compiles each scene, draws it on the host, and adds it under its name,
which is the file's without the suffix, or NAME. If the name has a record already, the scene must draw the same frames.
LAYERS takes the place of the scene's key "tree", as in fixel build.
Exit: 0 all scenes have records, 1 a scene draws other frames than its record, 2 the tool could not run.
"""

import argparse
import sys

from fixel.base import scratch
from fixel.base.errors import ToolError, one_line


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
    from fixel.check import frozen_frames
    if options.name and len(options.scenes) > 1:
        raise ToolError("--name is for one scene")
    records = frozen_frames.load()
    with scratch.folder("hashes") as folder:
        for scene in options.scenes:
            done = frozen_frames.add(scene, records, options.build, folder, options.name, options.tree)
            print(f"{one_line(scene)}: {done}", file=sys.stderr)
    frozen_frames.save(records)
    return 0
