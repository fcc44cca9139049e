# SPDX-License-Identifier: MIT
"""A frame dump while a board writes it, and whether it is whole in the end.
What is in it, fixel.board.dump reads."""

import struct
import zlib

from fixel.base.errors import ToolError

HEAD = struct.Struct("<4sHHHHI768s")
VERSION = 3
FRAME_EXTRA = 32 + 48  # bytes around a frame's pixels
TAIL = struct.Struct("<4sII")


def length(frames, each):
    """Bytes of a dump of so many frames of so many bytes each."""
    return HEAD.size + frames * each + TAIL.size


def shape(path):
    """(frames, bytes) that a dump's head announces; None before it is there. 0 frames: the tail says how many."""
    try:
        with open(path, "rb") as file:
            head = file.read(HEAD.size)
    except OSError:
        return None
    if len(head) < HEAD.size:
        return None
    magic, version, width, height, bits, frames, _ = HEAD.unpack(head)
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
            each = max(1, (total - HEAD.size - TAIL.size) // max(1, frames))
            progress(min(frames, max(0, size - HEAD.size) // each), frames)
        return size, "it writes more than it announced" if size > total else None

    return look
