# SPDX-License-Identifier: MIT
"""A board that is powered on and talked to while it runs: keys down, pictures of its screen back.

    with Session(program, image, folder, ["frames=3", "hold"]) as session:
        session.wait_for_text("walk: done 3 frames", timeout=60)
        picture = session.screen()
"""

import pathlib
import time

import numpy
from PIL import Image

from fixel.base import limits
from fixel.board import execute, qemu
from fixel.board.execute import Ending, describe, last_lines
from fixel.base.errors import ToolError

OUTPUT = "output.txt"   # what the board prints, in the session's folder
POLL = 0.005            # seconds


class Session:
    """A running board; it ends with the with statement. folder: where it starts
    and leaves its files. words: arguments of the program; options: more of QEMU's."""

    def __init__(self, program, image, folder, words=(), options=()):
        self.program, self.folder = program, pathlib.Path(folder)
        self.machine = self._process = None
        told = ["-icount", "shift=0", *qemu.semihosting(["walk", *words]), *qemu.loader(program, image), *options]
        try:
            with (self.folder / OUTPUT).open("wb") as output:
                self._process, self.machine = qemu.start_stopped(program, told, self.folder, output)
            self.machine.execute("cont")
        except ToolError as error:
            self.close()
            raise error.with_words(last_lines(self.text())) from error
        except BaseException:
            self.close()
            raise

    def text(self):
        """What the board has printed so far."""
        return (self.folder / OUTPUT).read_text(encoding="utf-8", errors="replace")

    def wait_until(self, condition, timeout, what):
        """Waits for condition() to be true; ToolError where the board ends first, or uses timeout
        seconds of CPU time, or sleeps so long."""
        limit = limits.Watch(self._process.pid, timeout, timeout)
        while True:
            code = self._process.poll()     # before the condition: its last words count
            answer = condition()
            if answer:
                return answer
            if code is not None:
                ending = Ending(code, self.text(), "", 0)
                raise ToolError(f"board {self.program.board} ended before {what}: {describe(ending)}", exit_code=1,
                                words=last_lines(ending.output))
            passed = limit.check()
            if passed:
                raise ToolError(f"board {self.program.board}: no {what}: {passed}", exit_code=1,
                                words=last_lines(self.text()))
            time.sleep(POLL)

    def wait_for_text(self, text, timeout=60.0):
        """Waits until the board has printed something."""
        self.wait_until(lambda: text in self.text(), timeout, f"'{text}'")

    def wait_for_end(self, timeout=60.0):
        """The exit code with which the board's program ends by itself."""
        limit = limits.Watch(self._process.pid, timeout, timeout)
        while self._process.poll() is None:
            passed = limit.check()
            if passed:
                raise ToolError(f"board {self.program.board} did not end: {passed}", exit_code=1,
                                words=last_lines(self.text()))
            time.sleep(POLL)
        return self._process.returncode

    def screen(self, device=None):
        """What a screen of the board shows, as an array of colours (height x width x 3). device: the
        identity of the display, for a board with several."""
        if not self._has_screen():
            raise ToolError(f"board {self.program.board} has no screen in QEMU: there is nothing to see", exit_code=1)
        file = (self.folder / "screen.png").resolve()
        which = {"device": device} if device else {}
        self.machine.execute("screendump", filename=str(file), format="png", **which)
        with Image.open(file) as picture:
            return numpy.asarray(picture.convert("RGB"))

    def _has_screen(self):
        """Whether a device shows something: without one QEMU gives a picture that says so. Consoles
        for text are of a kind of their own since QEMU 8, which has no device to ask for."""
        consoles = [entry["name"] for entry in self.machine.execute("qom-list", path="/backend")
                    if entry["name"].startswith("console[") and "text" not in entry["type"]]
        return any(self.machine.execute("qom-get", path=f"/backend/{name}", property="device") for name in consoles)

    def close(self):
        """Ends the board."""
        if self.machine is not None:
            self.machine.close()
        if self._process is not None:
            execute.kill(self._process)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


KEYS = ("up", "down", "left", "right", "ctrl")  # of a board with buttons, as QEMU calls them


def touch_keys(machine):
    """Presses and releases every key once: until then QEMU has buttons down."""
    for code in KEYS:
        machine.key(code, down=True)
        machine.key(code, down=False)
