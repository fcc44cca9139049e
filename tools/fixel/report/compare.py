# SPDX-License-Identifier: MIT
"""Compares two sets of frames: PNGs, folders of PNGs, or frame dumps, in any combination.

Exit: 0 equal, 1 different, 2 cannot be compared.
"""

import argparse
import contextlib
import glob
import io
import json
import os
import pathlib
import struct
import sys
import warnings

from fixel.base import output, reading
from fixel.base.errors import ToolError, one_line
from fixel.base.progress import steps
from fixel.base.table import coloured, table
from fixel.commands import late

Image = late("PIL.Image")
picture = late("fixel.base", "picture")
dump = late("fixel.board", "dump")
numpy = late("numpy")

SIDE_MAX = 4096         # pixels
PIXELS_MAX = 1 << 23    # of a PNG: two of them, and what is made of them, take less than 200 MB and 2 s
PNG_MAX = 64 << 20      # bytes of a PNG
DUMP_MAX = 1 << 30      # bytes of a frame dump
TEXTS_MAX = 64          # chunks of a PNG that may hold compressed texts, each of which Pillow expands
COMPRESSED = (b"iCCP", b"zTXt", b"iTXt")     # their kinds
BAND = 128              # rows at a time
SHOWN_ROWS = 20         # of frames that differ
RESULT, RESULT_MAX = "compare.json", 64 << 20   # bytes


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=f"{__doc__.splitlines()[0]} A PNG may have at most 8 bits a channel, "
                                   f"{SIDE_MAX:,} pixels a side and {PIXELS_MAX:,} together.")
    made.add_argument("--a", default="", help="a PNG, a folder of PNGs, or a frame dump (A=)")
    made.add_argument("--b", default="", help="the other: a PNG, a folder of PNGs, or a frame dump (B=)")
    made.add_argument("--tolerance", default="0",
                      help="largest difference of a colour channel that counts as equal")
    made.add_argument("--out", help="folder for compare.json and the pictures")
    made.add_argument("--json", action="store_true", help="JSON instead of the table")
    return made


def tolerance_of(text):
    """0..255 from a command line."""
    if not (len(text) <= 3 and text.isascii() and text.isdigit() and int(text) <= 255):
        raise ToolError(f"TOLERANCE is '{reading.shortened(text)}'; it must be a whole number from 0 to 255")
    return int(text)


def before(options):
    """Refuses one picture, and names at which there is nothing."""
    for name in ("a", "b"):
        path = getattr(options, name)
        if not path:
            raise ToolError(f"{name.upper()}= is missing: make compare A=... B=... takes two PNGs, folders of PNGs, or frame dumps")
        if not os.path.exists(path):
            raise ToolError(f"{path}: there is no such file or folder")
    tolerance_of(options.tolerance)


def check_head(path, blob):
    """Refuses what is no PNG, or one of more than 8 bits a channel: Pillow would drop the lower ones."""
    if blob[:8] != b"\x89PNG\r\n\x1a\n":
        raise ToolError(f"{path}: neither a PNG nor a frame dump nor a folder")
    if blob[12:16] != b"IHDR" or len(blob) < 33:
        raise ToolError(f"{path}: cannot be read: it does not begin with a PNG's head")
    if blob[24] > 8:
        raise ToolError(f"{path}: has {blob[24]} bits a channel; a PNG may have at most 8 bits a channel here")
    if sum(map(blob.count, COMPRESSED)) > TEXTS_MAX:
        raise ToolError(f"{path}: has more than {TEXTS_MAX} chunks of compressed text; save it without")


def check_size(path, width, height):
    """Refuses a picture that would take too long or too much memory."""
    if max(width, height) > SIDE_MAX or width * height > PIXELS_MAX:
        raise ToolError(f"{path}: {width}x{height} pixels are too many; a PNG may have at most {SIDE_MAX:,} a side "
                        f"and {PIXELS_MAX:,} together")


def read_png(path):
    """Colours (height x width x 4) of a PNG of at most 8 bits a channel."""
    blob = reading.read_whole(path, PNG_MAX, "make the picture smaller")
    check_head(path, blob)
    check_size(path, *struct.unpack_from(">II", blob, 16))
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with Image.open(io.BytesIO(blob), formats=("PNG",)) as image:
                check_size(path, *image.size)   # a damaged file may have two heads
                return rgba_of(image)
    except ToolError:
        raise
    except Image.UnidentifiedImageError as error:
        raise ToolError(f"{path}: cannot be read: its head is damaged") from error
    except Exception as error:      # Pillow's readers raise anything for a damaged file
        words = reading.shortened(str(error)) or type(error).__name__
        raise ToolError(f"{path}: cannot be read: {words}") from error


def bands(height):
    """The rows of a picture, some at a time: what is made of large pictures whole takes much memory."""
    return [slice(top, min(top + BAND, height)) for top in range(0, height, BAND)]


def rgba_of(image):
    """An opened picture's colours."""
    colours = numpy.empty((image.height, image.width, 4), numpy.uint8)
    for rows in bands(image.height):
        colours[rows] = image.crop((0, rows.start, image.width, rows.stop)).convert("RGBA")
    return colours


class Frames:
    """Frames by name, read one at a time."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.by_number = False      # names are only numbers: pair in order
        self.dump = None
        if os.path.isdir(path):
            self.files = self._of_folder()
            self.names = [file.stem for file in self.files]
        elif os.path.exists(path):
            if reading.read_start(path, 4) == b"FXLD" or self.path.suffix == ".fxld":
                self.dump = dump.parse_dump(reading.read_whole(path, DUMP_MAX, "compare fewer frames"), path)
                self.names = [f"frame_{frame.number:04d}" for frame in self.dump.frames]
            else:
                self.files, self.names = [self.path], [self.path.stem]
            self.by_number = True
        else:
            raise ToolError(f"{path}: there is no such file or folder")
        if not self.names:
            raise ToolError(f"{path}: holds no frames")

    def _of_folder(self):
        """The frames of a folder: frame_0000.png and so on where make run wrote it, else every PNG."""
        files = sorted(file for pattern in output.numbered("frame_", ".png") for file in self.path.glob(pattern)) \
            or sorted(self.path.glob("*.png"))
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
    distance = numpy.empty(a.shape[:2], numpy.uint8)
    for rows in bands(len(a)):
        apart = numpy.maximum(a[rows], b[rows]) - numpy.minimum(a[rows], b[rows])
        distance[rows] = apart.max(axis=2)
    differs = distance > tolerance
    return {"name": name, "pixels": int(differs.size), "pixels_differing": int(differs.sum()),
            "largest_difference": int(distance.max())}, differs


def fullest(counts):
    """The slice of at most SCREEN_MAX entries with the largest sum; of several, the middle one."""
    size = min(dump.SCREEN_MAX, len(counts))
    sums = numpy.concatenate([[0], counts.cumsum()])
    sums = sums[size:] - sums[:-size]
    starts = numpy.flatnonzero(sums == sums.max())
    start = int(starts[len(starts) // 2])
    return slice(start, start + size)


def sheet_of(a, b, differs):
    """Two pictures side by side as a PNG's bytes; of large ones, the part of a screen's size where they differ most."""
    rows = fullest(differs.sum(axis=1))
    columns = fullest(differs[rows].sum(axis=0))
    part = differs[rows, columns]
    where = "" if part.size == differs.size else f" from column {columns.start}, row {rows.start}"
    return picture.png_bytes(picture.side_by_side(a[rows, columns], b[rows, columns], part, ["A" + where, "B" + where]))


def picture_of(frame):
    """The name of the picture of a frame's differences."""
    return f"{frame}_diff.png"


def written_before(folder):
    """Globs of the files in a folder of results that the comparison before wrote there, by its own words."""
    try:
        file, _ = reading.open_regular(folder / RESULT)
        with file:
            frames = json.loads(file.read(RESULT_MAX))["per_frame"]
        return [*(glob.escape(picture_of(frame["name"])) for frame in frames if frame["pixels_differing"]), RESULT]
    except (ToolError, OSError, ValueError, KeyError, TypeError, RecursionError):   # it is none of ours
        return [RESULT]


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
            (folder / picture_of(frame["name"])).write_bytes(sheet_of(colours_a, colours_b, differs))
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
        print(table([[one_line(frame["name"]), frame["pixels_differing"],
                      f"{100 * frame['pixels_differing'] / frame['pixels']:.4f} %",
                      frame["largest_difference"]] for frame in worst[:SHOWN_ROWS]],
                    ["frame", "pixels", "share", "largest"]))
        if len(worst) > SHOWN_ROWS:
            print(f"... and {len(worst) - SHOWN_ROWS} more frames")
    verdict = coloured("equal", "green") if result["equal"] else coloured("different", "red")
    frames, differing = result["frames"], result["frames_differing"]
    print(f"{verdict}: {frames - differing:,} of {frames:,} frames equal, "
          f"{result['pixels_differing']:,} of {result['pixels']:,} pixels differ, tolerance {result['tolerance']}")
    if out:
        print(f"JSON and pictures: {one_line(out)}")


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    before(options)
    tolerance = tolerance_of(options.tolerance)
    place = (output.replaced_folder(options.out, written_before) if options.out
             else contextlib.nullcontext())
    with place as folder:
        result = compare(options.a, options.b, tolerance, folder)
        if folder:
            output.write_json(folder / RESULT, result)
    if options.json:
        json.dump(result, sys.stdout, indent=2)
        print()
    else:
        print_table(result, options.out)
    return 0 if result["equal"] else 1
