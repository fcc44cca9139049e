# SPDX-License-Identifier: MIT
"""Saves a picture of an emulated board's screen after the last frame."""

import argparse
import pathlib
import re
import shutil

from fixel import commands
from fixel.base import children
from fixel.base.errors import ToolError
from fixel.base.reading import quoted
from fixel.board import methods
from fixel.scene import scene_options


DEVICE = re.compile(r"[A-Za-z0-9][\w.-]*(,[\w.-]+=[^,]*)*")     # as QEMU's -device takes it


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    scene_options.add_board(made)
    scene_options.add(made)
    methods.add_options(made)
    made.add_argument("--device", help="a display to add to the board, in the words of QEMU's -device")
    made.add_argument("--out", required=True, type=pathlib.Path, help="the picture (.png)")
    made.add_argument("--build", default="build", help="folder that make builds in")
    made.add_argument("--timeout", type=float, default=120.0, help="limit of the drawing time in seconds (120)")
    return made


def before(options):
    """Refuses a folder in the place of the picture, and a device that QEMU has not, where QEMU is installed already."""
    if options.out is not None and options.out.is_dir():
        raise ToolError(f"{options.out}: cannot be written: it is a folder; name a file")
    if not options.device:
        return
    if not DEVICE.fullmatch(options.device):
        raise ToolError(f"DEVICE is {quoted(options.device)}; it must be like ssd0303 or name,property=value")
    qemu = shutil.which("qemu-system-arm")
    known = children.run([qemu, "-device", "help"], text=True).stdout if qemu else ""
    if known and f'name "{options.device.partition(",")[0]}"' not in known:
        raise ToolError(f"DEVICE is {quoted(options.device)}; QEMU has no such device: qemu-system-arm -device help lists them")


main = commands.main_of(parser, "fixel.board.screenshot")
