# SPDX-License-Identifier: MIT
"""Fetches a board's frames at the chosen rate, in a thread of its own."""

import threading
import time

from fixel.base.errors import ToolError

IDLE_RATE = 1.0     # frames a second while nobody looks on: enough to see the board end


class Pump:
    """Calls show(frame) for each frame and failed(error) once where no more can come, from its thread."""

    def __init__(self, board, rate, show, failed):
        self._board, self._show, self._failed = board, show, failed
        self._rate = rate
        self._changed = threading.Event()
        self._closing = False
        self._thread = threading.Thread(target=self._run, name="pump", daemon=True)
        self._thread.start()

    def set_rate(self, rate):
        """Frames a second from now on; 0: as fast as it goes."""
        if rate != self._rate:
            self._rate = rate
            self._changed.set()

    def _run(self):
        due = time.monotonic()
        try:
            while (frame := self._board.frame(waits=self._rate != 0)) is not None:
                self._show(frame)
                due = self._pause(due)
        except ToolError as error:
            if not self._closing:
                self._failed(error)

    def _pause(self, due):
        """Waits for the time of the next frame, or a change of rate; answers that time. What came too
        late is not made up for."""
        rate, now = self._rate, time.monotonic()
        due = max(due + (1 / rate if rate else 0), now)
        if due > now and self._changed.wait(due - now):
            due = time.monotonic()
        self._changed.clear()
        return due

    def close(self):
        """Ends the thread. Ends the board first: a frame may be under way."""
        self._closing = True
        self._board.stop()
        self._changed.set()
        self._thread.join()
