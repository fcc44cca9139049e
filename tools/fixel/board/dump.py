# SPDX-License-Identifier: MIT
"""Reads a frame dump (docs/formats.md, section 2): everything is checked before anything is handed out. And watches one that a board writes."""

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
BOXES = 1 << 31     # beside the number of a frame of boxes
BOX = struct.Struct("<4H")      # first column, columns, first row, rows
FRAME_TAIL = struct.Struct("<9IIQ")
TAIL = struct.Struct("<4sII")
VERSION = 3
PIXELS = {8: numpy.dtype(numpy.uint8), 16: numpy.dtype("<u2")}    # by the bits of one
SCREEN_MAX = 1024
COUNTERS = ("in", "backfacing", "outside", "degenerate", "refused", "drawn", "clipped",
            "refused_calls", "spilled")
HEAD_SIZE = HEAD.size + PALETTE_BYTES
FRAME_EXTRA = FRAME_HEAD.size + FRAME_TAIL.size     # bytes around a frame's pixels


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
    boxes: tuple | None = None  # (first column, columns, first row, rows) of each that was drawn; None: the whole frame was

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
        where = f"{name}: frame {number} of {head.frames}, at byte {offset}"
        taken = take_frame(_taker(data, offset, where), head, where)
        frames.append(parse_frame(taken, head, number, where, frames[-1] if frames else None))
        offset += len(taken)
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


def _taker(data, offset, where):
    """A function that hands out the bytes from an offset on, so many each time."""
    view = memoryview(data)

    def take(size):
        nonlocal offset
        if offset + size > len(data):
            raise ToolError(f"{where}: incomplete: the file ends at byte {len(data)}")
        offset += size
        return view[offset - size:offset]
    return take


def take_frame(take, head, where):
    """The bytes of the next frame of a dump with that head. take(size) hands out the next ones; where it answers None, so does this."""
    parts = [take(FRAME_HEAD.size)]
    if parts[0] is None or not FRAME_HEAD.unpack(parts[0])[1] & BOXES:
        parts.append(parts[0] and take(head.frame_bytes - FRAME_HEAD.size))
        return None if None in parts else b"".join(parts)
    while parts[-1] is not None:
        parts.append(take(BOX.size))
        first_column, columns, first_row, rows = BOX.unpack(parts[-1]) if parts[-1] else (0, 0, 0, 0)
        if first_column + columns > head.width or first_row + rows > head.height:
            raise ToolError(f"{where}: a box is beyond the frame")
        if columns == 0:
            break
        parts.append(take(columns * rows * head.pixel.itemsize))
    parts.append(parts[-1] and take(FRAME_TAIL.size))
    return None if None in parts else b"".join(parts)


def _boxes(data, head, where, before):
    """The picture that boxes make of the one before, and those boxes."""
    pixels = numpy.full((head.height, head.width), -1, numpy.int32) if before is None else before.copy()
    boxes, offset = [], FRAME_HEAD.size
    while True:
        first_column, columns, first_row, rows = box = BOX.unpack_from(data, offset)
        offset += BOX.size
        if columns == 0:
            break
        part = numpy.frombuffer(data, head.pixel, columns * rows, offset)
        pixels[first_row:first_row + rows, first_column:first_column + columns] = part.reshape(rows, columns)
        boxes.append(box)
        offset += part.nbytes
    if (pixels < 0).any():
        raise ToolError(f"{where}: the first frame has boxes that leave pixels out")
    return pixels.astype(head.pixel), tuple(boxes)


def parse_frame(data, head, number, where, before):
    """The frame whose bytes these are, which must have that number. where: what messages call it; before: the frame before, or None."""
    magic, stated, *pose = FRAME_HEAD.unpack_from(data)
    if magic != b"FRAM":
        raise ToolError(f"{where}: does not begin with FRAM")
    if stated & ~BOXES != number:
        raise ToolError(f"{where}: it says that it is frame {stated}")
    if stated & BOXES:
        pixels, boxes = _boxes(data, head, where, before and before.pixels)
    else:
        pixels, boxes = numpy.frombuffer(data, head.pixel, head.width * head.height, FRAME_HEAD.size).reshape(head.height, head.width), None
    *counters, clamped, instructions = FRAME_TAIL.unpack_from(data, len(data) - FRAME_TAIL.size)
    return Frame(number, tuple(pose[:3]), tuple(pose[3:]), pixels, dict(zip(COUNTERS, counters)), clamped, instructions, boxes)


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


# --- a dump while a board writes it, and whether it is whole in the end ------------

def length(frames, each):
    """Bytes of a dump of so many frames of so many bytes each."""
    return HEAD_SIZE + frames * each + TAIL.size


def shape(path):
    """(frames, bytes) that a dump's head announces; None before it is there. 0 frames: the tail says how many."""
    try:
        with open(path, "rb") as file:
            head = file.read(HEAD_SIZE)
    except OSError:
        return None
    if len(head) < HEAD_SIZE:
        return None
    magic, version, width, height, bits, frames = HEAD.unpack_from(head)
    if magic != b"FXLD" or version != VERSION or bits not in (8, 16):
        return None
    return frames, length(frames, width * height * bits // 8 + FRAME_EXTRA)


def check(path, frames):
    """Whether a dump is whole: length, tail, checksum."""
    announced = shape(path)
    if announced is None:
        raise ToolError("the board was done but left no frame dump", exit_code=1)
    if announced[0] == 0:   # it announces nothing
        announced = frames, _size(path)
    if announced[0] != frames or path.stat().st_size != announced[1]:
        raise ToolError(f"the board's dump is not whole: {path.stat().st_size} bytes, "
                        f"{announced[1]} expected for {announced[0]} frames", exit_code=1)
    crc = 0
    left = announced[1] - 4
    with path.open("rb") as file:
        while left > 0:
            block = file.read(min(left, 1 << 20))
            crc = zlib.crc32(block, crc)
            left -= len(block)
        (stated,) = struct.unpack("<I", file.read(4))
    if stated != crc:
        raise ToolError("the board's dump is damaged: its checksum does not match", exit_code=1)


def _size(path):
    """Bytes of a file; 0 where none is, or is no more: the board may rename it at any moment."""
    try:
        return path.stat().st_size
    except FileNotFoundError:
        return 0


def watch(path, progress):
    """A watch for fixel.board.execute: news is the dump's size."""
    announced = None

    def look():
        nonlocal announced
        part = path.with_name(path.name + ".part")  # the host's name for it, until it is whole
        announced = announced or shape(part) or shape(path)
        size = max(_size(part), _size(path))
        if announced is None or announced[0] == 0:
            return size, None
        frames, total = announced
        if progress:
            each = max(1, (total - HEAD_SIZE - TAIL.size) // max(1, frames))
            progress(min(frames, max(0, size - HEAD_SIZE) // each), frames)
        return size, "it writes more than it announced" if size > total else None

    return look
