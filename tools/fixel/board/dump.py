# SPDX-License-Identifier: MIT
"""Reads a frame dump (docs/formats.md, section 2): everything is checked before anything is handed out."""

import dataclasses
import hashlib
import itertools
import struct
import zlib

import numpy

from fixel.base import picture, reading
from fixel.base.errors import ToolError

HEAD = struct.Struct("<4sHHHHI")
PALETTE_BYTES = 768
FRAME_HEAD = struct.Struct("<4sI3i3I")
FRAME_TAIL = struct.Struct("<9IIQ")
TAIL = struct.Struct("<4sII")
VERSION = 3
PIXELS = {8: numpy.dtype(numpy.uint8), 16: numpy.dtype("<u2")}    # by the bits of one
SCREEN_MAX = 1024
COUNTERS = ("in", "backfacing", "outside", "degenerate", "refused", "drawn", "clipped",
            "refused_calls", "spilled")


# place pixel-format: frames that are read from a dump
@dataclasses.dataclass(frozen=True)
class Frame:
    """One frame: its pixels, the pose they were drawn from, and what was counted."""
    number: int
    position: tuple     # x, y, z in 1/65536 world unit
    angles: tuple       # yaw, pitch, roll in 2^-32 turn
    pixels: numpy.ndarray   # height x width: uint8, palette indices; or uint16, colours of RGB565
    counters: dict
    clamped: int        # steps in which a coordinate was held at the range's end
    instructions: int   # 0 where the board cannot tell, and in a frame that the walk drew as two rectangles

    @property
    def sha256(self):
        """What a frame's pixels are known by."""
        return hashlib.sha256(self.pixels.tobytes()).hexdigest()


@dataclasses.dataclass(frozen=True)
class Dump:
    """A complete dump."""
    width: int
    height: int
    palette: numpy.ndarray  # x 3, uint8: red, green, blue of each value that a pixel may have
    frames: list

    @property
    def pictures_sha256(self):
        """What the pictures are known by, and the poses that they were drawn from. Counters and instructions are
        another matter: those of two boards differ."""
        parts = [(frame.position, frame.angles, frame.sha256) for frame in self.frames]
        head = (self.width, self.height, self.palette.tobytes())
        return hashlib.sha256(repr((head, parts)).encode()).hexdigest()


@dataclasses.dataclass(frozen=True)
class Head:
    """How a dump begins."""
    width: int
    height: int
    pixel: numpy.dtype
    frames: int             # to come; 0: the tail says how many
    palette: numpy.ndarray  # x 3, uint8: red, green, blue of each value that a pixel may have

    @property
    def pixel_bytes(self):
        """Bytes of a frame's pixels."""
        return self.width * self.height * self.pixel.itemsize

    @property
    def frame_bytes(self):
        """Bytes that one frame takes in a dump."""
        return FRAME_HEAD.size + self.pixel_bytes + FRAME_TAIL.size


def read_dump(path):
    """The dump in a file; ToolError with the first thing that is wrong with it."""
    return parse_dump(reading.read_all(path), path)


def parse_dump(data, name):
    """The dump in a block of bytes; name is what messages call it."""
    head = parse_head(data, name)
    frames, offset = [], HEAD.size + PALETTE_BYTES
    for number in range(head.frames) if head.frames else itertools.count():
        if data[offset:offset + 4] == b"FEND":
            break
        frames.append(parse_frame(data, offset, head, number, name))
        offset += head.frame_bytes
    _check_tail(data, offset, len(frames), head.frames, name)
    return Dump(head.width, head.height, head.palette, frames)


def parse_head(data, name):
    """The head of a dump that begins a block of bytes."""
    if data[:4] != b"FXLD":
        raise ToolError(f"{name}: not a frame dump: it does not begin with FXLD")
    if len(data) < HEAD.size + PALETTE_BYTES:
        raise ToolError(f"{name}: incomplete: it ends within its head")
    _, version, width, height, bits, promised = HEAD.unpack_from(data)
    if version != VERSION:
        raise ToolError(f"{name}: a dump of version {version}; these tools read version {VERSION}")
    if not (1 <= width <= SCREEN_MAX and 1 <= height <= SCREEN_MAX):
        raise ToolError(f"{name}: a screen of {width}x{height}; "
                        f"both must be 1..{SCREEN_MAX}")
    if bits not in PIXELS:
        raise ToolError(f"{name}: pixels of {bits} bits; a pixel has {' or '.join(map(str, PIXELS))}")
    return Head(width, height, PIXELS[bits], promised, colours(bits, data[HEAD.size:HEAD.size + PALETTE_BYTES]))


def colours(bits, palette):
    """The colours of pixels of so many bits, beside a palette of 256 entries that those of 8 bits are of."""
    return numpy.frombuffer(palette, numpy.uint8).reshape(256, 3) if bits == 8 else picture.rgb565_colours()


def parse_frame(data, offset, head, number, name):
    """The frame at an offset of a dump with that head, which must have that number."""
    where = f"{name}: frame {number} of {head.frames}, at byte {offset}"
    if offset + head.frame_bytes > len(data):
        raise ToolError(f"{where}: incomplete: the file ends at byte {len(data)}")
    magic, stated, *pose = FRAME_HEAD.unpack_from(data, offset)
    if magic != b"FRAM":
        raise ToolError(f"{where}: does not begin with FRAM")
    if stated != number:
        raise ToolError(f"{where}: it says that it is frame {stated}")
    pixels = numpy.frombuffer(data, head.pixel, head.width * head.height, offset + FRAME_HEAD.size)
    *counters, clamped, instructions = FRAME_TAIL.unpack_from(
        data, offset + FRAME_HEAD.size + head.pixel_bytes)
    return Frame(number, tuple(pose[:3]), tuple(pose[3:]), pixels.reshape(head.height, head.width),
                 dict(zip(COUNTERS, counters)), clamped, instructions)


def _check_tail(data, offset, read, promised, name):
    if len(data) < offset + TAIL.size or data[offset:offset + 4] != b"FEND":
        raise ToolError(f"{name}: incomplete: no tail after frame {read} of {promised}")
    _, written, checksum = TAIL.unpack_from(data, offset)
    if written != read or promised not in (0, read):
        raise ToolError(f"{name}: the head promises {promised} frames, the tail says {written}, "
                        f"and {read} are there")
    if len(data) != offset + TAIL.size:
        raise ToolError(f"{name}: {len(data) - offset - TAIL.size} bytes follow its tail")
    computed = zlib.crc32(data[:offset + 8])
    if checksum != computed:
        raise ToolError(f"{name}: damaged: its checksum is {computed:08x}, "
                        f"the tail says {checksum:08x}")
