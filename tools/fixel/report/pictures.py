# SPDX-License-Identifier: MIT
"""Makes a picture of a document: frames of `make run` or `make wire`, or of frame dumps, side by side."""

import argparse
import pathlib
import re

from fixel.base import output, reading
from fixel.base.errors import ToolError
from fixel.base.reading import quoted
from fixel.commands import late

Image = late("PIL.Image")
picture = late("fixel.base", "picture")
dump = late("fixel.board", "dump")

FRAMES = "30,45,105"       # of the plaza
GAP = 8


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__)
    source = made.add_mutually_exclusive_group(required=True)
    source.add_argument("--run", type=pathlib.Path, help="folder of make run's frames")
    source.add_argument("--dumps", type=pathlib.Path, nargs="+", help="frame dumps, one for each number")
    made.add_argument("--frames", default=FRAMES, help="numbers of the frames, like 30,45,105")
    made.add_argument("--out", type=pathlib.Path, required=True, help="the picture")
    return made


def parse_frames(text):
    """Numbers of frames from "30,45,105"."""
    numbers = text.split(",")
    if not all(re.fullmatch("[0-9]{1,7}", number) for number in numbers):
        raise ToolError(f"--frames is {quoted(text)}; it must be numbers of frames, like {FRAMES}")
    return list(map(int, numbers))


def opened_picture(file):
    """A picture that make run wrote, in red, green and blue."""
    with reading.open_file(file) as opened, Image.open(opened) as made:
        return made.convert("RGB")


def of_run(folder, numbers):
    """Pictures of frames of make run."""
    files = [folder / f"frame_{number:04d}.png" for number in numbers]
    missing = [str(file) for file in files if not file.exists()]
    if missing:
        raise ToolError(f"{missing[0]} does not exist: run `make run` on its scene first")
    return [opened_picture(file) for file in files]


def of_dumps(files, numbers):
    """A picture of each frame dump."""
    made = []
    for file, number in zip(files, numbers, strict=True):
        drawn = dump.read_dump(file)
        if number >= len(drawn.frames):
            raise ToolError(f"{file}: has no frame {number}; its frames are counted from 0, and it has {len(drawn.frames)}")
        made.append(picture.palette_image(drawn.frames[number].pixels, drawn.palette).convert("RGB"))
    return made


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    numbers = parse_frames(options.frames)
    if options.dumps and len(options.dumps) != len(numbers):
        raise ToolError("--frames must have a number for each of --dumps")
    frames = of_dumps(options.dumps, numbers) if options.dumps else of_run(options.run, numbers)
    width, height = frames[0].size
    row = Image.new("RGB", (len(frames) * (width + GAP) - GAP, height), (255, 255, 255))
    for place, frame in enumerate(frames):
        row.paste(frame, (place * (width + GAP), 0))
    # 256 colours suffice for flat shading and make the file a fifth of the size.
    output.write_file(options.out, picture.png_bytes(row.quantize(256, dither=Image.Dither.NONE)))
    return 0
