# SPDX-License-Identifier: MIT
"""Boots a board from its flash image and fetches its frame dump."""

import argparse

from fixel.board.emulator import run
from fixel.base.errors import one_line
from fixel.base.progress import Progress


def positive(text):
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text} is not at least 1")
    return value


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--board", required=True, help="the board of the image and the program")
    parser.add_argument("--image", required=True, help="the flash image")
    parser.add_argument("--elf", required=True, help="the program that the image holds")
    parser.add_argument("--dump", required=True, help="the frame dump to write (.fxld)")
    parser.add_argument("--frames", type=positive, help="number of frames (default: the whole path)")
    parser.add_argument("--timeout", type=float, default=60.0,
                        help="seconds without a new frame after which the board hangs (60)")
    options = parser.parse_args(argv)
    with Progress(f"frames on {options.board}") as progress:
        result = run(options.board, options.image, options.elf, options.dump, options.frames,
                     options.timeout, progress)
    print(f"{result.board} ({result.cpu}): {result.frames} frames in {result.seconds:.1f} s: {one_line(options.dump)}")
    return 0
