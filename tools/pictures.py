#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes a page's picture anew: of frames of `make run` or `make wire`, side by side, or of the first program."""

from fixel import interpreter

interpreter.choose()  # before the imports that need a package

import argparse
import pathlib

from PIL import Image

from fixel import first_program, output, picture
from fixel.errors import ToolError, run_main

FRAMES = "30,45,105"       # of the plaza
GAP = 8


def side_by_side(run, numbers):
    """Frames of a run in a row."""
    files = [run / f"frame_{number:04d}.png" for number in numbers]
    missing = [str(file) for file in files if not file.exists()]
    if missing:
        raise ToolError(f"{missing[0]} does not exist: run `make run` on its scene first")
    frames = [Image.open(file).convert("RGB") for file in files]
    width, height = frames[0].size
    row = Image.new("RGB", (len(frames) * (width + GAP) - GAP, height), (255, 255, 255))
    for place, frame in enumerate(frames):
        row.paste(frame, (place * (width + GAP), 0))
    return row


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--run", type=pathlib.Path, help="where make run left its frames")
    what.add_argument("--library", type=pathlib.Path, help="libfixel.a of the host, for the first program")
    parser.add_argument("--frames", default=FRAMES, help="the frames' numbers, like 30,45,105")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="the picture")
    options = parser.parse_args(argv)
    if options.run:
        made = side_by_side(options.run, map(int, options.frames.split(",")))
    else:
        made = picture.palette_image(*first_program.draw(options.library)).convert("RGB")
    # 256 colours suffice for flat shading and make the file a fifth of the size.
    output.write_file(options.out, picture.png_bytes(made.quantize(256, dither=Image.Dither.NONE)))
    return 0


if __name__ == "__main__":
    run_main(main)
