# SPDX-License-Identifier: MIT
"""Reads a frame dump (docs/formats.md, section 2): everything is checked before anything is handed out."""

import dataclasses
import hashlib
import struct
import zlib

import numpy

from fixel.base import reading
from fixel.base.errors import ToolError

HEAD = struct.Struct("<4sHHHHI")
PALETTE_BYTES = 768
FRAME_HEAD = struct.Struct("<4sI3i3I")
FRAME_TAIL = struct.Struct("<9IIQ")
TAIL = struct.Struct("<4sII")
VERSION = 2
SCREEN_MAX = 1024
COUNTERS = ("in", "backfacing", "outside", "degenerate", "refused", "drawn", "clipped",
            "refused_calls", "spilled")


@dataclasses.dataclass(frozen=True)
class Frame:
    """One frame: palette indices, the pose they were drawn from, and what was counted."""
    number: int
    position: tuple     # x, y, z in 1/65536 world unit
    angles: tuple       # yaw, pitch, roll in 2^-32 turn
    pixels: numpy.ndarray   # height x width, uint8
    counters: dict
    clamped: int        # steps in which a coordinate was held at the range's end
    instructions: int   # 0 where the board cannot tell

    @property
    def sha256(self):
        """What a frame's pixels are known by."""
        return hashlib.sha256(self.pixels.tobytes()).hexdigest()


@dataclasses.dataclass(frozen=True)
class Dump:
    """A complete dump."""
    width: int
    height: int
    palette: numpy.ndarray  # 256 x 3, uint8
    frames: list

    @property
    def pictures_sha256(self):
        """What the pictures are known by, and the poses that they were drawn from. Counters and instructions are
        another matter: those of two boards differ."""
        parts = [(frame.position, frame.angles, frame.sha256) for frame in self.frames]
        head = (self.width, self.height, self.palette.tobytes())
        return hashlib.sha256(repr((head, parts)).encode()).hexdigest()


def frame_bytes(width, height):
    """Bytes that one frame takes in a dump."""
    return FRAME_HEAD.size + width * height + FRAME_TAIL.size


def read_dump(path):
    """The dump in a file; ToolError with the first thing that is wrong with it."""
    return parse_dump(reading.read_all(path), path)


def parse_dump(data, name):
    """The dump in a block of bytes; name is what messages call it."""
    width, height, promised, palette = parse_head(data, name)
    frames, offset = [], HEAD.size + PALETTE_BYTES
    for number in range(promised):
        if data[offset:offset + 4] == b"FEND":
            break
        frames.append(parse_frame(data, offset, width, height, number, promised, name))
        offset += frame_bytes(width, height)
    _check_tail(data, offset, len(frames), promised, name)
    return Dump(width, height, palette, frames)


def parse_head(data, name):
    """Width, height, frames promised and palette of a dump that begins a block of bytes."""
    if data[:4] != b"FXLD":
        raise ToolError(f"{name}: not a frame dump: it does not begin with FXLD")
    if len(data) < HEAD.size + PALETTE_BYTES:
        raise ToolError(f"{name}: incomplete: it ends within its head")
    _, version, width, height, reserved, promised = HEAD.unpack_from(data)
    if version != VERSION:
        raise ToolError(f"{name}: a dump of version {version}; these tools read version {VERSION}")
    if not (1 <= width <= SCREEN_MAX and 1 <= height <= SCREEN_MAX):
        raise ToolError(f"{name}: a screen of {width}x{height}; "
                        f"both must be 1..{SCREEN_MAX}")
    if reserved:
        raise ToolError(f"{name}: the reserved field at byte 10 is {reserved} and must be 0")
    palette = numpy.frombuffer(data, numpy.uint8, PALETTE_BYTES, HEAD.size).reshape(256, 3)
    return width, height, promised, palette


def parse_frame(data, offset, width, height, number, promised, name):
    """The frame at an offset, which must have that number."""
    where = f"{name}: frame {number} of {promised}, at byte {offset}"
    if offset + frame_bytes(width, height) > len(data):
        raise ToolError(f"{where}: incomplete: the file ends at byte {len(data)}")
    magic, stated, *pose = FRAME_HEAD.unpack_from(data, offset)
    if magic != b"FRAM":
        raise ToolError(f"{where}: does not begin with FRAM")
    if stated != number:
        raise ToolError(f"{where}: it says that it is frame {stated}")
    pixels = numpy.frombuffer(data, numpy.uint8, width * height, offset + FRAME_HEAD.size)
    *counters, clamped, instructions = FRAME_TAIL.unpack_from(
        data, offset + FRAME_HEAD.size + width * height)
    return Frame(number, tuple(pose[:3]), tuple(pose[3:]), pixels.reshape(height, width),
                 dict(zip(COUNTERS, counters)), clamped, instructions)


def _check_tail(data, offset, read, promised, name):
    if len(data) < offset + TAIL.size or data[offset:offset + 4] != b"FEND":
        raise ToolError(f"{name}: incomplete: no tail after frame {read} of {promised}")
    _, written, checksum = TAIL.unpack_from(data, offset)
    if written != read or read != promised:
        raise ToolError(f"{name}: the head promises {promised} frames, the tail says {written}, "
                        f"and {read} are there")
    if len(data) != offset + TAIL.size:
        raise ToolError(f"{name}: {len(data) - offset - TAIL.size} bytes follow its tail")
    computed = zlib.crc32(data[:offset + 8])
    if checksum != computed:
        raise ToolError(f"{name}: damaged: its checksum is {computed:08x}, "
                        f"the tail says {checksum:08x}")
