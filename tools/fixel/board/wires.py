# SPDX-License-Identifier: MIT
"""The record of a display's wires (docs/formats.md, section 5): the pictures that a controller made of it, beside those
that were drawn."""

import dataclasses
import hashlib
import struct

import numpy

from fixel.base import reading
from fixel.board import controllers, crc, grey
from fixel.board.controllers import require
from fixel.base.errors import ToolError
from fixel.base.progress import Progress

NAME = "wires.bin"  # as boards write it, in the folder they start in
HEAD = struct.Struct("<cI")


def records(file):
    """(kind, bytes) of all that went over the wires, from an open file."""
    while True:
        head = file.read(HEAD.size)
        if not head:
            return
        require(len(head) == HEAD.size, "their record is cut off")
        kind, size = HEAD.unpack(head)
        data = file.read(size)
        require(len(data) == size, "their record is cut off")
        yield kind, data


@dataclasses.dataclass
class Wires:
    """What the wires showed of the frames that were drawn."""
    equal: int = 0      # frames that the display shows as they were drawn
    hashes: list = dataclasses.field(default_factory=list)      # a SHA-256 of each picture
    sent: crc.Crcs = dataclasses.field(default_factory=crc.Crcs)    # of the pixels of each frame, as they came


def read(file, model, turns=0):
    """Plays the record of an open file to a model of fixel.board.controllers; after each whole frame, (its picture for whoever
    turned the module by these quarter turns, the bytes of all pixels that came since the frame before)."""
    frames, pixels = 0, bytearray()
    for kind, data in records(file):
        if kind == b"C":
            model.take_command(data)
        elif kind == b"D":
            model.take_data(data)
            if model.takes_pixels:
                pixels += data
        elif kind == b"P":
            model.pause(int.from_bytes(data, "little"))
        elif kind == b"F":
            model.finish()
            require(int.from_bytes(data, "little") == frames, f"after frame {frames - 1} comes another than {frames}")
            frames += 1
            yield model.picture(turns), bytes(pixels)
            pixels.clear()
        else:
            require(False, f"their record has an unknown part {kind!r}")
    model.finish()


def rgb565(palette):
    """A palette (256 x 3) in 16 bits an entry."""
    red, green, blue = (palette[:, axis].astype(numpy.uint16) for axis in range(3))
    return (red >> 3) << 11 | (green >> 2) << 5 | blue >> 3


def turns_of(driver, width, height):
    """How many quarter turns the program gives a module for frames of this size: if it can show one, the long side of the glass
    is where that of the frame is; a square frame lies on an upright glass."""
    glass_width, glass_height = glass_of(driver, 0)
    return int(1 in controllers.model(driver).TURNS and (height > width) != (glass_height >= glass_width))


def glass_of(driver, turns):
    """Width and height of a module's glass, as seen."""
    _, glass = controllers.MODULES[driver]
    return (glass.height, glass.width) if turns % 2 else (glass.width, glass.height)


def shown(driver, pixels, palette, turns):
    """What the glass is to show of a frame: the frame in its middle, black around it."""
    height, width = pixels.shape
    model = controllers.model(driver)
    glass = numpy.zeros(glass_of(driver, turns)[::-1], numpy.uint16)
    top, left = ((outer - inner) // 2 for outer, inner in zip(glass.shape, pixels.shape))
    left, top = (place - place % unit for place, unit in zip((left, top), model.UNIT))
    levels = rgb565(palette)[pixels] if model.HIGHEST is None else grey.levels(pixels, palette, model.HIGHEST)
    glass[top:top + height, left:left + width] = levels
    return glass


def check_size(driver, width, height):
    """Refuses frames that are larger than the glass."""
    glass = glass_of(driver, turns_of(driver, width, height))
    if width > glass[0] or height > glass[1]:
        size = "x".join(map(str, glass))
        raise ToolError(f"frames of {width}x{height} do not fit the {size} of DRIVER={driver}: SCREEN={size} draws smaller ones")


def frame_bytes(driver, pixels):
    """Bytes that a display is sent of a frame. Before its first one it may be sent the black around the frames."""
    height, width = pixels.shape
    model, glass = controllers.MODULES[driver]
    return model.frame_bytes(width, height, glass)


def compare(path, driver, drawn, progress=None):
    """What the wires show of a dump's frames: Wires."""
    found = Wires()
    with reading.open_file(path) as file:
        turns = turns_of(driver, drawn.frames[0].pixels.shape[1], drawn.frames[0].pixels.shape[0]) if drawn.frames else 0
        model = controllers.start(driver)
        for picture, pixels in read(file, model, turns):
            require(len(found.hashes) < len(drawn.frames), "more frames come than were drawn")
            number = len(found.hashes)
            frame = drawn.frames[number].pixels
            wanted = shown(driver, frame, drawn.palette, turns)
            found.equal += picture.shape == wanted.shape and bool((picture == wanted).all())
            found.hashes.append(hashlib.sha256(picture.astype("<u2").tobytes("C")).hexdigest())
            # Of boxes all that came, but before a first frame the black around it comes too.
            found.sent.add(pixels if number > 0 and drawn.frames[number].boxes is not None else pixels[-frame_bytes(driver, frame):])
            model.alternates = number + 1 < len(drawn.frames) and drawn.frames[number + 1].boxes is None
            if progress:
                progress(len(found.hashes), len(drawn.frames))
    require(len(found.hashes) == len(drawn.frames), f"{len(found.hashes)} frames come, and {len(drawn.frames)} were drawn")
    return found


def told(driver, path, drawn):
    """What came over the wires of DRIVER=, if there is one, beside what was drawn, and the CRCs of both: for summary.json."""
    frame = crc.drawn(drawn.frames)
    if not driver:
        return {"wires_frames_equal": None, "wires_frame_sha256": None} | crc.summary(frame, None)
    with Progress(f"reading the wires of an {driver}") as progress:
        found = compare(path, driver, drawn, progress)
    return {"wires_frames_equal": found.equal, "wires_frame_sha256": found.hashes} | crc.summary(frame, found.sent)


def rows(summary):
    """A row for people of a summary; none without a driver."""
    return [[f"from the wires of an {summary['driver']}", f"{summary['wires_frames_equal']} of {summary['frames']} frames as they were drawn"]] \
        if summary["driver"] else []
