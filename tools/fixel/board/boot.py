# SPDX-License-Identifier: MIT
"""Boots a board from its flash image and fetches its frame dump."""

import argparse
import os
import pathlib

from fixel.base import scratch
from fixel.base.errors import ToolError, one_line
from fixel.base.progress import Progress
from fixel.scene import scene_options, target


def positive(text):
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text} is not at least 1")
    return value


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    made.add_argument("--board", required=True, help="the board of the image and the program")
    made.add_argument("--image", required=True, help="the flash image")
    made.add_argument("--elf", required=True, help="the program that the image holds")
    made.add_argument("--dump", required=True, help="the frame dump to write (.fxld)")
    made.add_argument("--frames", type=positive, help="number of frames (default: the whole path)")
    made.add_argument("--timeout", type=float, default=60.0,
                      help="seconds without a new frame after which the board hangs (60)")
    target.add_options(made)
    return made


def before(options):
    """Refuses a board without a flash image. The image is the recipe's, or none."""
    board = os.environ.get("BOARD", scene_options.BOARD)
    image = pathlib.Path("build/flash") / f"{board}.bin"
    if options.image is None and not image.exists():
        raise ToolError(f"{image}: there is no flash image of {board}; make flash BOARD={board} writes it, with the scene")


def main(argv):
    options = parser().parse_args(argv)
    asked = target.of_options(options)
    from fixel.board import emulator, flash_memory
    with scratch.folder("boot") as folder, Progress(f"frames on {options.board}") as progress:
        image = flash_memory.retargeted(options.board, options.elf, options.image, asked, folder) if asked else options.image
        result = emulator.run(options.board, image, options.elf, options.dump, options.frames, options.timeout, progress)
    print(f"{result.board} ({result.cpu}): {result.frames} frames in {result.seconds:.1f} s: {one_line(options.dump)}")
    return 0
