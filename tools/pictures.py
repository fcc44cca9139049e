#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes a picture of a document: frames of `make run` or `make wire`, side by side."""

from fixel import interpreter

interpreter.choose()  # before the imports that need a package

import argparse
import pathlib

from PIL import Image

from fixel import output, picture
from fixel.errors import ToolError, run_main

FRAMES = "30,45,105"       # of the plaza
GAP = 8


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--run", type=pathlib.Path, required=True, help="folder of make run's frames")
    parser.add_argument("--frames", default=FRAMES, help="numbers of the frames, like 30,45,105")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="the picture")
    options = parser.parse_args(argv)
    files = [options.run / f"frame_{number:04d}.png" for number in map(int, options.frames.split(","))]
    missing = [str(file) for file in files if not file.exists()]
    if missing:
        raise ToolError(f"{missing[0]} does not exist: run `make run` on its scene first")
    frames = [Image.open(file).convert("RGB") for file in files]
    width, height = frames[0].size
    row = Image.new("RGB", (len(frames) * (width + GAP) - GAP, height), (255, 255, 255))
    for place, frame in enumerate(frames):
        row.paste(frame, (place * (width + GAP), 0))
    # 256 colours suffice for flat shading and make the file a fifth of the size.
    output.write_file(options.out, picture.png_bytes(row.quantize(256, dither=Image.Dither.NONE)))
    return 0


if __name__ == "__main__":
    run_main(main)
