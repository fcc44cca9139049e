# SPDX-License-Identifier: MIT
"""Frames of a board that shares no memory: its ordinary frame dump, written into a FIFO as it goes,
so that the board waits for whoever reads; and its keys in a file of one byte."""

import fcntl
import os
import select

from fixel import dump
from fixel.errors import ToolError

KEYS_NAME = "keys"          # as boards/parts/semihosting_keys.c opens it
SMALL = 4096                # bytes that the FIFO may hold: what is in it is already old
POLL = 0.05                 # seconds
F_SETPIPE_SZ = 1031         # of Linux


class Stream:
    """The reading end of a FIFO into which a board writes a frame dump."""

    def __init__(self, path):
        self.path = path
        self.width = self.height = 0
        self.palette = b""
        self._data = b""
        try:
            os.mkfifo(path)
            # Without waiting for a writer; what is read then waits by itself.
            self._file = os.open(path, os.O_RDONLY | os.O_NONBLOCK)
            fcntl.fcntl(self._file, F_SETPIPE_SZ, SMALL)
        except OSError as error:
            raise ToolError(f"cannot make {path}: {error.strerror}") from error

    def _fill(self, size, alive):
        """Reads until size bytes are there; False where the board ended before."""
        while len(self._data) < size:
            select.select([self._file], [], [], POLL)
            try:
                block = os.read(self._file, size - len(self._data))
            except BlockingIOError:
                block = b""
            self._data += block
            if not block and not alive():
                return False
            if not block:
                select.select([], [], [], 0.001)    # a FIFO that nobody has opened yet reads as ended
        return True

    def _take(self, size):
        taken, self._data = self._data[:size], self._data[size:]
        return taken

    def open(self, alive):
        """Reads the dump's head; False where the board ended before."""
        if not self._fill(dump.HEAD.size + dump.PALETTE_BYTES, alive):
            return False
        self.width, self.height, self.palette = dump.parse_head(self._take(dump.HEAD.size + dump.PALETTE_BYTES))
        return True

    def frame(self, number, alive):
        """The next frame, which must have that number; None where the board ended before."""
        size = dump.frame_bytes(self.width, self.height)
        if not self._fill(size, alive):
            return None
        return dump.parse_frame(self._take(size), self.width, self.height, number)

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
