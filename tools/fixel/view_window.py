# SPDX-License-Identifier: MIT
"""The viewer's side of the live window (SPEC.md 9b): memory that the emulated board shares."""

import mmap
import os
import struct

import numpy

from fixel import dump
from fixel.errors import ToolError

MAGIC, INVITATION, VERSION = 0x574C5846, 0x57454956, 1
MAGIC_AT, FORMAT_AT, FINISHED_AT, FRONT_AT = 0, 4, 20, 24
INVITATION_AT, REQUESTED_AT, KEYS_AT, PALETTE_AT = 32, 36, 40, 48
FORMAT = struct.Struct("<IHH2I")    # version, width, height, places of the slots
WORD = struct.Struct("<I")
FRAME = struct.Struct("<I3i3I8IIQ")
MAPPED_MAX = 4 << 20                # bytes: two frames of the largest screen, and their heads
AHEAD = 1 << 16                     # frames that a board is asked for that need not wait


class Window:
    """A file that is a board's shared memory. Everything read from it is checked: a program that
    went astray may have written there."""

    def __init__(self, path, size):
        self.path, self.size = path, size
        self.width = self.height = 0
        self.palette = b""
        self._slots = ()
        try:
            with open(path, "w+b") as file:
                os.ftruncate(file.fileno(), size)   # sparse: only what is written takes room
                self._memory = mmap.mmap(file.fileno(), min(size, MAPPED_MAX))
        except OSError as error:
            raise ToolError(f"cannot make {path}: {error.strerror}") from error
        self._put(INVITATION_AT, INVITATION)

    @property
    def options(self):
        """What QEMU must be told."""
        path = str(self.path).replace(",", ",,")
        return ["-object", f"memory-backend-file,id=window,size={self.size},mem-path={path},share=on",
                "-machine", "memory-backend=window"]

    def _word(self, offset):
        return WORD.unpack_from(self._memory, offset)[0]

    def _put(self, offset, value):
        WORD.pack_into(self._memory, offset, value & 0xFFFFFFFF)

    def open(self):
        """Whether the board has opened its side; reads the format once it has."""
        if self.width:
            return True
        if self._word(MAGIC_AT) != MAGIC:
            return False
        version, width, height, *slots = FORMAT.unpack_from(self._memory, FORMAT_AT)
        if version != VERSION:
            raise ToolError(f"the board's window is of version {version}; this viewer reads version {VERSION}")
        if not (1 <= width <= dump.SCREEN_MAX and 1 <= height <= dump.SCREEN_MAX):
            raise ToolError(f"the board's window claims a screen of {width}x{height}")
        room = FRAME.size + width * height
        if any(slot < PALETTE_AT + dump.PALETTE_BYTES or slot + room > len(self._memory) for slot in slots) \
                or abs(slots[0] - slots[1]) < room:
            raise ToolError(f"the board's window has its frames at {slots[0]} and {slots[1]}, where they cannot be")
        self._slots = slots
        self.palette = self._memory[PALETTE_AT:PALETTE_AT + dump.PALETTE_BYTES]
        self.width, self.height = width, height
        return True

    @property
    def finished(self):
        """Frames that the board has finished, modulo 2^32."""
        return self._word(FINISHED_AT)

    def request(self, more=1):
        """Asks for so many frames beyond those that are finished."""
        self._put(REQUESTED_AT, self.finished + more)

    def hold(self, keys):
        """Which keys are held, as bits of fixel/viewer.h."""
        self._put(KEYS_AT, keys)

    def frame(self):
        """The newest frame, or None where the board finished another while this one was copied:
        it may have begun to draw over it."""
        finished = self.finished
        front = self._word(FRONT_AT)
        if front > 1:
            raise ToolError(f"the board's window says that its frame is in slot {front}; there are two")
        start = self._slots[front]
        copied = self._memory[start:start + FRAME.size + self.width * self.height]
        if self.finished != finished:
            return None
        number, *rest = FRAME.unpack_from(copied)
        pixels = numpy.frombuffer(copied, numpy.uint8, offset=FRAME.size).reshape(self.height, self.width)
        return dump.Frame(number, tuple(rest[:3]), tuple(rest[3:6]), pixels,
                          dict(zip(dump.COUNTERS, rest[6:14])), rest[14], rest[15])

    def close(self):
        self._memory.close()
