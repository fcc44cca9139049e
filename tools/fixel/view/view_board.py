# SPDX-License-Identifier: MIT
"""A board that is watched while it runs: powered on, asked for frames, told of keys, and ended; and its frames, fetched at the chosen rate, or
one by one, in a thread of its own.

A board whose program says `window=` in its note shares memory with the viewer;
any other streams its dump. The keys go where the board has them: into the
window, into a file, or, where its note says `keys=`, to its emulated buttons.
"""

import concurrent.futures
import itertools
import pathlib
import shutil
import threading
import time

from fixel.base import limits
from fixel.base.errors import ToolError
from fixel.board import emulator, execute, qemu
from fixel.board.execute import Ending, OUTPUT_MAX, describe, exit_status, kill, last_lines
from fixel.board.symbols import Symbols
from fixel.view.view_window import KEYS_NAME, KeyFile, Stream
from fixel.view.view_window import Window

ENDLESS = 0xFFFFFFFF    # frames
HANG = 20.0             # seconds of CPU time, or of sleep, for a frame
PRESSED_MIN = 0.35      # seconds: a tap that a board at 30 frames a second does not take for a bounce
SETTLING = 20           # frames until a board has seen that its buttons are up, and that it is no bounce
OUTPUT = "output.txt"


def _nothing():
    """What is to be done for a program that was not started stopped."""


class Buttons:
    """The keys of a board that has some, pressed by QEMU's machine protocol. QEMU may answer only
    after the next frame was fetched, so nobody waits here."""

    def __init__(self, machine, names):
        self._machine, self._names = machine, names     # names: bit -> QEMU's names of the keys
        self._down = {}     # name -> when it was pressed
        self._worker = concurrent.futures.ThreadPoolExecutor(1, "buttons")
        self.error = None
        self.awake = self._submit(self._wake)

    def _submit(self, job, *arguments):
        def remember(future):
            if not future.cancelled() and future.exception() is not None:
                self.error = future.exception()

        future = self._worker.submit(job, *arguments)
        future.add_done_callback(remember)
        return future

    def _wake(self):
        """The emulated buttons read as pressed until each was pressed and let go."""
        every = sorted({name for names in self._names.values() for name in names})
        for down in (True, False):
            for name in every:
                self._machine.key(name, down)

    def _press(self, wanted):
        # At the same moment: an arrow that is let go after Ctrl would walk a step.
        released, pressed = self._down.keys() - wanted, wanted - self._down.keys()
        if released or pressed:
            time.sleep(max([0.0, *(self._down.pop(name) + PRESSED_MIN - time.monotonic() for name in released)]))
            self._machine.keys(released, pressed)
            self._down.update(dict.fromkeys(pressed, time.monotonic()))

    def hold(self, keys):
        wanted = {name for bit, names in self._names.items() if keys & bit for name in names}
        self._submit(self._press, wanted)

    def close(self):
        self._worker.shutdown(wait=True, cancel_futures=True)


class ProgramEnded(Exception):
    """A program has come to its end without an error, and may begin again."""


class Board:
    """A running board. Frames and restart are for one thread; hold and stop may come from another."""

    def __init__(self, program, image, folder):
        self.program, self._image = program, image
        self.folder = pathlib.Path(folder)
        self._folders = (self.folder / f"power-on-{number}" for number in itertools.count())
        self._process = self._machine = self._link = self._keys = None
        self._hand = threading.Lock()   # around what hold and stop touch
        self._held, self._ready, self._closing = 0, False, False
        try:
            self._power_on()
        except BaseException:
            self.close()
            raise

    # --- power on and off -----------------------------------------------------------

    def _power_on(self):
        self._folder = next(self._folders)
        self._folder.mkdir()
        options = [] if self.program.hosted else emulator.walk_options(self.program, self._image, ENDLESS, live=True)
        if self.program.window_size:
            self._link = keys = Window(self._folder / "window", self.program.window_size)
            options += self._link.options
        else:
            self._link = Stream(self._folder / emulator.DUMP_NAME)
            keys = None if self.program.keys else KeyFile(self._folder / KEYS_NAME)
        try:
            self._launch(options)
            keys = keys or Buttons(self._machine, self.program.keys)
        finally:
            self._keys = keys
        opened = self._link.open(self._check)
        if opened is not None:
            self.head = opened
            self._settle()

    def _settle(self):
        """Lets a board with buttons draw until it believes them; tells the board which keys are held."""
        if isinstance(self._keys, Buttons):
            while not self._keys.awake.done() and self.frame():
                pass
            for _ in range(SETTLING):
                self.frame()
        with self._hand:
            self._ready = True
            self._keys.hold(self._held)

    def _launch(self, options):
        """In a session of its own, so that Ctrl-C reaches this tool alone."""
        try:
            with (self._folder / OUTPUT).open("wb") as output:
                if self.program.hosted:
                    process = self._start_hosted(output)
                else:
                    process, self._machine = qemu.start_stopped(self.program, options, self._folder, output,
                                                                start_new_session=True)
            with self._hand:
                self._process = process
            self._limit = limits.Watch(process.pid, HANG, HANG)
            # Nobody reads its stream yet.
            self._resumed = self._machine.resume() if self._machine is not None else _nothing
        except ToolError as error:
            raise error.with_words(last_lines(self.text())) from error

    def _start_hosted(self, output):
        command = emulator.live_command(self.program, self._image, ENDLESS, KEYS_NAME)
        return execute.start(command, self._folder, output, (), start_new_session=True)

    def _power_off(self):
        with self._hand:
            self._ready = False
        if self._process is not None:
            kill(self._process)
        if self._keys is not None and self._keys is not self._link:
            self._keys.close()
        if self._machine is not None:
            self._machine.close()
        if self._link is not None:
            self._link.close()
        with self._hand:
            self._process = self._machine = self._link = self._keys = None

    def restart(self):
        """Powers it off and on; the next frame is its first. The keys that are held stay so."""
        self._power_off()
        shutil.rmtree(self._folder)
        self._power_on()

    # --- while it runs --------------------------------------------------------------

    def look(self):
        """Raises where the board has ended."""
        code = self._process.poll()
        if code is not None:
            ending = Ending(code, self.text(), "", 0)
            raise ToolError(f"board {self.program.board} ended: {describe(ending)}",
                            exit_status(ending), last_lines(ending.output))

    def _check(self, _waited):
        """Whether a frame is still wanted; raises where none will come."""
        if self._closing:
            return False
        self.look()
        self._resumed()
        passed = self._limit.check()
        if passed:
            raise ToolError(f"board {self.program.board} hangs: no frame came: {passed}", exit_code=1,
                            words=last_lines(self.text()))
        return True

    def text(self):
        """What the board has printed, with the functions of a fault named."""
        with (self._folder / OUTPUT).open("rb") as output:
            text = output.read(OUTPUT_MAX).decode("utf-8", "replace")
        return Symbols(self.program.path).name_faults(text)

    def frame(self, waits=True):
        """The next frame; None once the board is being stopped. waits: as in view_window.py."""
        self._limit.renew()
        if getattr(self._keys, "error", None):
            raise self._keys.error
        return self._link.frame(self._check, waits)

    def hold(self, keys):
        """Which keys are held from now on, as bits of fixel/player.h."""
        with self._hand:
            self._held = keys
            if self._ready:
                self._keys.hold(keys)

    def stop(self):
        """Ends the board at once; whoever waits for a frame gets None."""
        with self._hand:
            self._closing = True
            if self._process is not None:
                kill(self._process)

    def close(self):
        """Ends everything. Nobody may wait for a frame any more."""
        self.stop()
        self._power_off()


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
