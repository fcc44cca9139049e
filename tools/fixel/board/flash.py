# SPDX-License-Identifier: MIT
"""Writes a program and a scene to a board: to its persistent flash image, or by a debug probe to the real one."""

import argparse

from fixel import commands
from fixel.base.errors import ToolError
from fixel.scene import scene_options

OPENOCD = "openocd"
PROBES = (OPENOCD,)


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    made.add_argument("--board", required=True, help="the board of the program and the scene")
    made.add_argument("--elf", required=True, help="the program")
    scene_options.add(made)
    made.add_argument("--scenes", default="build/scenes", help="folder for the compiled scene image")
    made.add_argument("--image", required=True, help="the flash image to write")
    made.add_argument("--program", default="walk", help="the name of the program (walk)")
    made.add_argument("--driver", help="the display of a program that runs without a debugger")
    made.add_argument("--probe", default="", help="openocd: program the real board instead")
    made.add_argument("--dry-run", action="store_true", help="with --probe: only print the command")
    return made


def before(options):
    """Refuses a probe that there is not."""
    if options.probe and options.probe not in PROBES:
        raise ToolError(f"PROBE is '{options.probe}'; it may be {' or '.join(PROBES)}")
    if options.dry_run and not options.probe:
        raise ToolError("DRY_RUN needs a PROBE")


main = commands.main_of(parser, "fixel.board.flashing")
