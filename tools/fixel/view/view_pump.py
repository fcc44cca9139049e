# SPDX-License-Identifier: MIT
"""Fetches a board's frames at the chosen rate, or one by one, in a thread of its own."""

import threading
import time

from fixel.base.errors import ToolError
from fixel.view.view_board import ProgramEnded

IDLE_RATE = 1.0     # frames a second while nobody looks on: enough to see the board end
LOOK = 1.0          # seconds between two looks at a board that is paused: it may end
FRAME, RESTART, LOOK_AT, PICK = "frame", "restart", "look", "pick"     # what the thread does next


class Pump:
    """Calls show(frame) for each frame and failed(error) where no more can come, from its thread. picked: None, or called with
    (number of a frame, pixel, answer) for each pixel that is pointed at, of the frame that was shown last: then a board that
    has failed may be restarted."""

    def __init__(self, board, rate, show, failed, picked=None):
        self._board, self._show, self._failed, self._picked = board, show, failed, picked
        self._pointed, self._picks, self._shown = frozenset(), False, None
        self._failing = False   # the board can only be restarted
        self._rate, self._due = rate, time.monotonic()
        self._paused, self._steps, self._restarts, self._closing = False, 0, False, False
        self._runs_free = False     # the board draws without being asked
        self._changed = threading.Condition()
        self._thread = threading.Thread(target=self._run, name="pump", daemon=True)
        self._thread.start()

    # --- from other threads -----------------------------------------------------------

    def set_rate(self, rate):
        """Frames a second from now on; 0: as fast as it goes."""
        with self._changed:
            if rate != self._rate:
                self._rate, self._due = rate, time.monotonic()
                self._changed.notify()

    def pause(self, paused):
        """Whether frames come only for step()."""
        with self._changed:
            if paused != self._paused:
                self._paused, self._due = paused, time.monotonic()
                self._steps = 1 if paused and self._runs_free else 0    # the one at which it stops
                self._changed.notify()

    def step(self):
        """One frame more, where it is paused."""
        with self._changed:
            if self._paused:
                self._steps += 1
                self._changed.notify()

    def restart(self):
        """The board's first frame again, and from there as before."""
        with self._changed:
            self._restarts, self._steps = True, 1 if self._paused else 0
            self._changed.notify()

    def point(self, pixels):
        """Which pixels, (x, y), are pointed at from now on."""
        with self._changed:
            self._pointed, self._picks = frozenset(pixels), True
            self._changed.notify()

    def close(self):
        """Ends the thread. Ends the board first: a frame may be under way."""
        with self._changed:
            self._closing = True
            self._changed.notify()
        self._board.stop()
        self._thread.join()

    # --- in its own -------------------------------------------------------------------

    def _run(self):
        while (task := self._next()) is not None:
            try:
                self._do(task)
            except ProgramEnded:
                if task == FRAME:       # the last picture stays until the next one is due
                    self.restart()
            except ToolError as error:
                if self._closing:
                    return
                self._failed(error)
                if self._picked is None:
                    return
                self._failing = True

    def _do(self, task):
        if task == FRAME:
            self._fetch()
        elif task == RESTART:
            self._board.restart()
        elif task == PICK:
            self._pick()
        else:
            self._board.look()

    def _next(self):
        """Waits for the time of the next task; None at the end. What comes too late is not made up for."""
        with self._changed:
            looks = time.monotonic() + LOOK
            while not self._closing:
                now = time.monotonic()
                if self._restarts:
                    self._restarts, self._runs_free, self._due = False, False, now
                    self._failing, self._shown = False, None
                    return RESTART
                if self._failing:
                    self._changed.wait()
                    continue
                if self._picks and self._shown is not None:
                    self._picks = False
                    return PICK
                due = looks if self._paused else self._due
                if self._steps or not self._paused and now >= due:
                    self._steps -= self._steps > 0
                    self._runs_free = self._rate == 0 and not self._paused
                    return FRAME
                if now >= due:
                    return LOOK_AT
                self._changed.wait(due - now)
        return None

    def _fetch(self):
        frame = self._board.frame(not self._runs_free)
        if frame is None:
            return      # it is being stopped
        self._show(frame)
        with self._changed:
            self._shown, self._picks = frame, self._picked is not None
            self._due = max(self._due + (1 / self._rate if self._rate else 0), time.monotonic())

    def _pick(self):
        for pixel in self._pointed:
            answer = self._board.pick(*pixel)
            if answer is not None:
                self._picked(self._shown.number, pixel, answer)
