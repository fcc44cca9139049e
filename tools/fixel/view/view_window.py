# SPDX-License-Identifier: MIT
"""The viewer's side of the live window: memory that an emulated board shares (docs/formats.md, section 3); or, of a board that shares none, its
ordinary frame dump, written into a FIFO as it goes, so that the board waits for whoever reads, and its keys in a file of one byte.

check(waited) is asked while nothing comes, with the seconds waited so far: it
raises where the board has ended or hangs, and answers False where nobody wants
the frame any more.
"""

import fcntl
import mmap
import os
import select
import struct
import time

import numpy

from fixel.base.errors import ToolError
from fixel.board import dump

MAGIC, INVITATION, VERSION = 0x574C5846, 0x57454956, 2
MAGIC_AT, FORMAT_AT, FINISHED_AT, FRONT_AT, PIXEL_BITS_AT = 0, 4, 20, 24, 28
INVITATION_AT, REQUESTED_AT, KEYS_AT, PALETTE_AT = 32, 36, 40, 48
FORMAT = struct.Struct("<IHH2I")    # version, width, height, places of the slots
WORD = struct.Struct("<I")
FRAME = struct.Struct(f"<QII3i3I{len(dump.COUNTERS)}I")
PIXELS_AT = -(-FRAME.size // 8) * 8 # in a slot
MAPPED_MAX = 8 << 20                # bytes: two frames of the largest screen, and their heads
AHEAD = 1 << 16                     # frames that a board is asked for that need not wait
POLL = 0.0005                       # seconds


class Window:
    """A file that is a board's shared memory. What is read from it is checked: a program that went
    astray may have written there."""

    def __init__(self, path, size):
        self.path, self.size = path, size
        self._head, self._slots = None, ()
        self._shown = 0     # frames that were finished when one was last copied
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

    @staticmethod
    def _wait(condition, check):
        """Waits until condition() is something; None where nobody wants it any more."""
        started = time.monotonic()
        while not (found := condition()):
            if not check(time.monotonic() - started):
                return None
            time.sleep(POLL)
        return found

    # --- the board's side -----------------------------------------------------------

    def open(self, check):
        """Waits for the board to open its side: a dump's head, which promises no frames."""
        if not self._wait(lambda: self._word(MAGIC_AT) == MAGIC, check):
            return None
        version, width, height, *slots = FORMAT.unpack_from(self._memory, FORMAT_AT)
        if version != VERSION:
            raise ToolError(f"the board's window is of version {version}; this viewer reads version {VERSION}")
        if not (1 <= width <= dump.SCREEN_MAX and 1 <= height <= dump.SCREEN_MAX):
            raise ToolError(f"the board's window claims a screen of {width}x{height}")
        bits = self._word(PIXEL_BITS_AT)
        if bits not in dump.PIXELS:
            raise ToolError(f"the board's window claims pixels of {bits} bits")
        palette = self._memory[PALETTE_AT:PALETTE_AT + dump.PALETTE_BYTES]
        head = dump.Head(width, height, dump.PIXELS[bits], 0, dump.colours(bits, palette))
        room = PIXELS_AT + head.pixel_bytes
        if min(slots) < PALETTE_AT + dump.PALETTE_BYTES or max(slots) + room > len(self._memory) \
                or abs(slots[0] - slots[1]) < room:
            raise ToolError(f"the board's window has its frames at {slots[0]} and {slots[1]}, where they cannot be")
        self._slots, self._head = slots, head
        return head

    def copy(self):
        """The newest finished frame; None where the board finished another meanwhile: it may have
        begun to draw over what was copied."""
        finished, front = self._word(FINISHED_AT), self._word(FRONT_AT)
        if front >= len(self._slots):
            raise ToolError(f"the board's window says that its frame is in slot {front}; there are two")
        start = self._slots[front]
        copied = self._memory[start:start + PIXELS_AT + self._head.pixel_bytes]
        if self._word(FINISHED_AT) != finished:
            return None
        self._shown = finished
        instructions, number, clamped, *rest = FRAME.unpack_from(copied)
        pixels = numpy.frombuffer(copied, self._head.pixel, offset=PIXELS_AT).reshape(self._head.height, self._head.width)
        return dump.Frame(number, tuple(rest[:3]), tuple(rest[3:6]), pixels,
                          dict(zip(dump.COUNTERS, rest[6:])), clamped, instructions)

    # --- the viewer's side ----------------------------------------------------------

    def frame(self, check, waits=True):
        """The next frame; None where nobody wants it any more. waits: the board is to begin no other
        before it is asked again, and this is its last; without, it draws as fast as it can, and this is its newest."""
        self._put(REQUESTED_AT, self._word(FINISHED_AT) + (1 if waits else AHEAD))
        if not waits:
            return self._wait(lambda: self._word(FINISHED_AT) != self._shown and self.copy(), check)
        # A board that need not wait until now may be past the frame that was asked for.
        wanted = self._word(REQUESTED_AT)
        return self._wait(lambda: (self._word(FINISHED_AT) - wanted) & 0xFFFFFFFF < 1 << 31 and self.copy(), check)

    def hold(self, keys):
        """Which keys are held, as bits of fixel/player.h."""
        self._put(KEYS_AT, keys)

    def close(self):
        self._memory.close()


NAME = "the board's frames"     # what messages call them
KEYS_NAME = "keys"              # as boards/parts/semihosting.c opens it
SMALL = 4096                    # bytes that the FIFO may hold: what is in it is already old
STREAM_POLL = 0.02                     # seconds
F_SETPIPE_SZ = 1031             # of Linux


class Stream:
    """The reading end of a FIFO into which a board writes a frame dump."""

    def __init__(self, path):
        self._data, self._number, self._head, self._before = bytearray(), 0, None, None
        try:
            os.mkfifo(path)
            self._file = os.open(path, os.O_RDONLY | os.O_NONBLOCK)     # without waiting for a writer
            fcntl.fcntl(self._file, F_SETPIPE_SZ, SMALL)
        except OSError as error:
            raise ToolError(f"cannot make {path}: {error.strerror}") from error

    def _read(self, missing):
        """What is there by now; nothing also while nobody has opened the other end yet."""
        if not select.select([self._file], [], [], STREAM_POLL)[0]:
            return b""
        block = os.read(self._file, missing)
        if not block:
            time.sleep(STREAM_POLL)
        return block

    def _take(self, size, check):
        """The next bytes, so many; None where nobody wants them any more."""
        started = time.monotonic()
        while len(self._data) < size:
            block = self._read(size - len(self._data))
            self._data += block
            if not block and not check(time.monotonic() - started):
                return None
        taken = bytes(self._data[:size])
        del self._data[:size]
        return taken

    def open(self, check):
        """Waits for the dump's head."""
        head = self._take(dump.HEAD.size + dump.PALETTE_BYTES, check)
        if head is None:
            return None
        self._head = dump.parse_head(head, NAME)
        return self._head

    def frame(self, check, waits=True):
        """The next frame; None where nobody wants it any more. waits makes no difference: the board
        always waits for its reader, and is at most one frame ahead."""
        del waits
        where = f"{NAME}: frame {self._number}"
        data = dump.take_frame(lambda size: self._take(size, check), self._head, where)
        if data is None:
            return None
        self._before = dump.parse_frame(data, self._head, self._number, where, self._before)
        self._number += 1
        return self._before

    def close(self):
        os.close(self._file)


class KeyFile:
    """The keys that are held, in a file that the board reads for each frame."""

    def __init__(self, path):
        try:
            self._file = os.open(path, os.O_WRONLY | os.O_CREAT, 0o600)
        except OSError as error:
            raise ToolError(f"cannot make {path}: {error.strerror}") from error
        self.hold(0)

    def hold(self, keys):
        """One byte in one call: a reader sees the old one or the new one."""
        os.pwrite(self._file, bytes([keys]), 0)

    def close(self):
        os.close(self._file)
