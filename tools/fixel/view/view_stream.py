# SPDX-License-Identifier: MIT
"""Frames of a board that shares no memory: its ordinary frame dump, written into a FIFO as it goes,
so that the board waits for whoever reads; and its keys in a file of one byte.

check(waited): as in view_window.py.
"""

import fcntl
import os
import select
import time

from fixel.board import dump
from fixel.base.errors import ToolError

NAME = "the board's frames"     # what messages call them
KEYS_NAME = "keys"              # as boards/parts/semihosting_keys.c opens it
SMALL = 4096                    # bytes that the FIFO may hold: what is in it is already old
POLL = 0.02                     # seconds
F_SETPIPE_SZ = 1031             # of Linux


class Stream:
    """The reading end of a FIFO into which a board writes a frame dump."""

    def __init__(self, path):
        self._data, self._number, self._head = bytearray(), 0, None
        try:
            os.mkfifo(path)
            self._file = os.open(path, os.O_RDONLY | os.O_NONBLOCK)     # without waiting for a writer
            fcntl.fcntl(self._file, F_SETPIPE_SZ, SMALL)
        except OSError as error:
            raise ToolError(f"cannot make {path}: {error.strerror}") from error

    def _read(self, missing):
        """What is there by now; nothing also while nobody has opened the other end yet."""
        if not select.select([self._file], [], [], POLL)[0]:
            return b""
        block = os.read(self._file, missing)
        if not block:
            time.sleep(POLL)
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
        data = self._take(self._head.frame_bytes, check)
        if data is None:
            return None
        frame = dump.parse_frame(data, 0, self._head, self._number, NAME)
        self._number += 1
        return frame

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
