#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares two sets of frames: PNGs, folders of PNGs, or frame dumps, in any combination.

Exit: 0 equal, 1 different, 2 cannot be compared.
"""

from fixel import interpreter

interpreter.choose()  # before the imports that need a package

import argparse
import contextlib
import json
import pathlib
import sys

import numpy
from PIL import Image, UnidentifiedImageError

from fixel import dump, output, picture
from fixel.errors import ToolError, run_main
from fixel.progress import steps
from fixel.table import coloured, table

EIGHT_BIT_MODES = ("1", "L", "LA", "P", "PA", "RGB", "RGBA")
SHOWN_ROWS = 20     # of frames that differ
PATTERNS = ["*_diff.png", "compare.json"]


def read_png(path):
    """Colours (height x width x 4) of a PNG of at most 8 bits a channel."""
    try:
        with Image.open(path) as image:
            if image.format != "PNG":
                raise ToolError(f"{path}: is {image.format}, not PNG")
            if image.mode not in EIGHT_BIT_MODES:
                raise ToolError(f"{path}: has more than 8 bits a channel ({image.mode})")
            return numpy.asarray(image.convert("RGBA"))
    except UnidentifiedImageError as error:
        raise ToolError(f"{path}: neither a PNG nor a frame dump nor a folder") from error
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        raise ToolError(f"{path}: cannot be read: {error}") from error


class Frames:
    """Frames by name, read one at a time."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.by_number = False      # names are only numbers: pair in order
        self.dump = None
        if self.path.is_dir():
            self.files = self._of_folder()
            self.names = [file.stem for file in self.files]
        elif self.path.is_file():
            with self.path.open("rb") as file:
                is_dump = file.read(4) == b"FXLD"
            if is_dump or self.path.suffix == ".fxld":
                self.dump = dump.read_dump(path)
                self.names = [f"frame_{frame.number:04d}" for frame in self.dump.frames]
            else:
                self.files, self.names = [self.path], [self.path.stem]
            self.by_number = True
        else:
            raise ToolError(f"{path}: there is no such file or folder")
        if not self.names:
            raise ToolError(f"{path}: holds no frames")

    def _of_folder(self):
        """The frames of a folder: frame_*.png where make run wrote it, else every PNG."""
        files = sorted(self.path.glob("frame_*.png")) or sorted(self.path.glob("*.png"))
        if not files:
            raise ToolError(f"{self.path}: a folder without a PNG")
        return files

    def colours(self, index):
        """Frame index as height x width x 4."""
        if self.dump:
            rgb = picture.as_rgb(self.dump.frames[index].pixels, self.dump.palette)
            return numpy.dstack([rgb, numpy.full(rgb.shape[:2], 255, numpy.uint8)])
        return read_png(self.files[index])


def check_pairing(a, b):
    """Refuses two sets whose frames do not pair up."""
    if len(a.names) != len(b.names):
        raise ToolError(f"{a.path} holds {len(a.names)} frames, {b.path} holds {len(b.names)}: "
                        f"there is nothing to compare the rest with")
    if not (a.by_number or b.by_number) and a.names != b.names:
        only = sorted(set(a.names) ^ set(b.names))[0]
        raise ToolError(f"{only}.png is in only one of {a.path} and {b.path}")


def compare_frame(name, a, b, tolerance):
    """What differs between two pictures of one size, and the mask of it."""
    if a.shape != b.shape:
        raise ToolError(f"{name}: the sizes differ: {a.shape[1]}x{a.shape[0]} and "
                        f"{b.shape[1]}x{b.shape[0]}")
    distance = numpy.abs(a.astype(numpy.int16) - b).max(axis=2)
    differs = distance > tolerance
    return {"name": name, "pixels": int(differs.size), "pixels_differing": int(differs.sum()),
            "largest_difference": int(distance.max())}, differs


def compare(path_a, path_b, tolerance, folder):
    """The comparison as a dictionary; side-by-side pictures of what differs go to folder."""
    a, b = Frames(path_a), Frames(path_b)
    check_pairing(a, b)
    frames = []
    for index in steps("comparing", range(len(a.names))):
        colours_a, colours_b = a.colours(index), b.colours(index)
        frame, differs = compare_frame(a.names[index], colours_a, colours_b, tolerance)
        frames.append(frame)
        if differs.any() and folder:
            sheet = picture.side_by_side(colours_a, colours_b, differs, ["A", "B"])
            (folder / f"{frame['name']}_diff.png").write_bytes(picture.png_bytes(sheet))
    differing = [frame for frame in frames if frame["pixels_differing"]]
    return {"a": str(path_a), "b": str(path_b), "tolerance": tolerance, "equal": not differing,
            "frames": len(frames), "frames_differing": len(differing),
            "pixels": sum(frame["pixels"] for frame in frames),
            "pixels_differing": sum(frame["pixels_differing"] for frame in frames),
            "largest_difference": max(frame["largest_difference"] for frame in frames),
            "per_frame": frames}


def print_table(result, out):
    """For people."""
    worst = sorted((frame for frame in result["per_frame"] if frame["pixels_differing"]),
                   key=lambda frame: (-frame["pixels_differing"], frame["name"]))
    if worst:
        print(table([[frame["name"], frame["pixels_differing"],
                      f"{100 * frame['pixels_differing'] / frame['pixels']:.4f} %",
                      frame["largest_difference"]] for frame in worst[:SHOWN_ROWS]],
                    ["frame", "pixels", "share", "largest"]))
        if len(worst) > SHOWN_ROWS:
            print(f"... and {len(worst) - SHOWN_ROWS} more frames")
    verdict = coloured("equal", "green") if result["equal"] else coloured("different", "red")
    print(f"{verdict}: {result['frames_differing']} of {result['frames']} frames, "
          f"{result['pixels_differing']:,} of {result['pixels']:,} pixels, "
          f"tolerance {result['tolerance']}")
    if out:
        print(f"JSON and pictures: {out}")


def tolerance_of(text):
    """0..255 from a command line."""
    if not (text.isascii() and text.isdigit() and int(text) <= 255):
        raise ToolError(f"TOLERANCE is '{text}'; it must be a whole number from 0 to 255")
    return int(text)


def main(argv):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--a", default="", help="a PNG, a folder of PNGs, or a frame dump (A=)")
    parser.add_argument("--b", default="", help="the other: a PNG, a folder of PNGs, or a frame dump (B=)")
    parser.add_argument("--tolerance", default="0",
                        help="largest difference of a colour channel that counts as equal")
    parser.add_argument("--out", help="folder for compare.json and the pictures")
    parser.add_argument("--json", action="store_true", help="JSON instead of the table")
    options = parser.parse_args(argv)
    for name in ("a", "b"):
        if not getattr(options, name):
            raise ToolError(f"{name.upper()}= is missing: make compare A=... B=... takes two PNGs, "
                            f"folders of PNGs, or frame dumps")
    tolerance = tolerance_of(options.tolerance)
    place = (output.replaced_folder(options.out, PATTERNS) if options.out
             else contextlib.nullcontext())
    with place as folder:
        result = compare(options.a, options.b, tolerance, folder)
        if folder:
            output.write_json(folder / "compare.json", result)
    if options.json:
        json.dump(result, sys.stdout, indent=2)
        print()
    else:
        print_table(result, options.out)
    return 0 if result["equal"] else 1


if __name__ == "__main__":
    run_main(main)
