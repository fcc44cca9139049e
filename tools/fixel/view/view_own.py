# SPDX-License-Identifier: MIT
"""A program of the user's own in the live window: it runs on this machine, is built anew when one of its files changes,
and says which face is at a pixel (firmware/own/watched.c)."""

import contextlib
import dataclasses
import itertools
import os
import pathlib
import re
import signal
import socket
import struct
import threading
import time

from fixel.base import children
from fixel.base.errors import ToolError, one_line, printable
from fixel.base.table import count_of
from fixel.board import emulator, execute, firmware, methods, own_run
from fixel.board.execute import Ending, describe, last_lines
from fixel.view.view_board import Board, ENDLESS, ProgramEnded
from fixel.view.view_window import KEYS_NAME

ROOT = pathlib.Path(__file__).resolve().parents[3]
REQUEST = struct.Struct("<4H")  # WANT_..., x, y, 0
ANSWER = struct.Struct("<4H")   # status, instance, face, 0
WANT_FRAME, WANT_FACE = 1, 2
LOOK = 0.25                     # seconds between two looks at the files
POLL = 0.05                     # seconds
MAKES_OWN = ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "MAKEOVERRIDES")
DONE = re.compile(r"^own: done (\d+) frames$", re.MULTILINE)
AGAIN = "A change of one of its files starts it again, and so does the page's \"back to start\""


def make(build, *words, **how):
    """Has the makefile build files, given as paths, in a folder; the finished process."""
    environment = {name: value for name, value in os.environ.items() if name not in MAKES_OWN}
    words = [os.path.relpath(word, ROOT) if isinstance(word, pathlib.Path) else word for word in words]
    return children.run(["make", "-s", f"BUILD={os.path.relpath(build, ROOT)}", *words], cwd=ROOT, env=environment, text=True, errors="replace", **how)


class Source:
    """The files of a program, and how it is built. path: a C file or a folder of C files, as PROGRAM= has it."""

    def __init__(self, path, name, build):
        self.path = path
        self.build = build
        self.elf = methods.elf_of(firmware.HOST, ROOT / os.path.relpath(build, ROOT), name)
        self.state = self._look()

    @property
    def name(self):
        return pathlib.Path(self.path).name

    def _sources(self):
        path = pathlib.Path(self.path)
        return sorted(path.glob("*.c")) if path.is_dir() else [path]

    def _included(self):
        """What the objects were compiled of, as the compiler wrote it."""
        for source in self._sources():
            with contextlib.suppress(OSError):
                text = (self.elf.parent / "own" / f"{own_run.name_of(source)}.d").read_text(encoding="utf-8", errors="replace")
                yield from map(pathlib.Path, re.findall(r"[^\s:\\]+", text.partition(":")[2]))

    def _look(self):
        """{file: when it was written, and its size} of the sources, what they include, and the headers beside them."""
        beside = {each.parent for each in self._sources()}
        found = {}
        for path in {*self._sources(), *self._included(), *(each for folder in beside for each in folder.glob("*.h"))}:
            with contextlib.suppress(OSError):
                status = (ROOT / path).stat()
                found[str(path)] = status.st_mtime_ns, status.st_size
        return found

    def has_changed(self):
        """Whether a file is another one than when this was asked last."""
        before, self.state = self.state, self._look()
        return self.state != before

    def make(self, **how):
        """Builds the program; the finished process."""
        done = make(self.build, f"PROGRAM={self.path}", self.elf, **how)
        self.state = self._look()   # which headers there are is known only now
        return done

    def refusal(self, done):
        """The error of a build that failed."""
        words = [line for line in (done.stderr or "").splitlines() if not line.startswith("make")]
        return ToolError(f"{one_line(self.name)} was not built; its next change builds it again", words="\n".join(words))


class Own(Board):
    """Such a program while it runs. begun(head) is called whenever it runs anew."""

    def __init__(self, source, image, folder):
        self.source, self.begun = source, lambda head: None
        self._viewer, self._owes_frame = None, False
        super().__init__(firmware.load(source.elf, firmware.HOST), image, folder)

    # --- power on and off -----------------------------------------------------------

    def _start_hosted(self, output):
        self._viewer, other = socket.socketpair()
        self._viewer.settimeout(POLL)
        self._owes_frame = False
        with other:
            command = emulator.live_command(self.program, self._image, ENDLESS, KEYS_NAME)
            return execute.start([*command, str(other.fileno())], self._folder, output, (other.fileno(),), start_new_session=True)

    def _power_on(self):
        super()._power_on()
        if self.head.pixel.itemsize == 1:
            palette = own_run.palette_of(self.source.elf)
            self.head = dataclasses.replace(self.head, palette=own_run.greys() if palette is None else palette)

    def _power_off(self):
        if self._viewer is not None:
            self._viewer.close()
            self._viewer = None
        super()._power_off()

    def restart(self):
        super().restart()
        self.begun(self.head)

    # --- while it runs --------------------------------------------------------------

    def look(self):
        """Raises where the program has ended: ProgramEnded where it drew frames that can begin anew."""
        code = self._process.poll()
        if code is None:
            return
        text = self.text()
        done, words = DONE.search(text), last_lines(own_run.OURS.sub("", text))
        if code == 0 and done and int(done[1]) > 1:
            raise ProgramEnded
        if code == 0 and done:
            said = f"has ended after {count_of(int(done[1]), 'frame')}: main returned 0"
        elif code < 0:
            said = f"crashed: signal {-code} ({signal.Signals(-code).name})"
        else:
            said = f"has ended: {describe(Ending(code, text, '', 0)) if code else 'it called exit'}"
        raise ToolError(f"{one_line(self.source.name)} {said}. {AGAIN}.", exit_code=1, words=words)

    def _ask(self, *request):
        with contextlib.suppress(OSError):      # it has ended, which whoever waits for the answer sees
            self._viewer.sendall(REQUEST.pack(*request, 0))

    def frame(self, waits=True):
        """The next frame, which the program begins now: it always waits until it is asked."""
        if self._owes_frame:
            self._ask(WANT_FRAME, 0, 0)
        self._owes_frame = False
        frame = super().frame(waits)
        self._owes_frame = frame is not None
        return frame

    def pick(self, x, y):
        """What fxl_pick_face says of a pixel of the frame that came last: (status, instance, face); None where nobody
        answers."""
        if not self._owes_frame:
            return None
        self._limit.renew()
        self._ask(WANT_FACE, x, y)
        data = b""
        while len(data) < ANSWER.size:
            try:
                block = self._viewer.recv(ANSWER.size - len(data))
            except TimeoutError:
                if self._check(0):
                    continue
                return None
            except OSError:
                block = b""
            if not block:
                return None
            data += block
        return ANSWER.unpack(data)[:3]


class Watcher:
    """Looks at the files of a program in a thread of its own, and builds it when one has changed: built() or
    failed(error)."""

    def __init__(self, source, built, failed):
        self._source, self._built, self._failed = source, built, failed
        self._closing = threading.Event()
        self._thread = threading.Thread(target=self._run, name="watcher", daemon=True)
        self._thread.start()

    def _run(self):
        while not self._closing.wait(LOOK):
            if self._source.has_changed():
                self._build()

    def _build(self):
        before = stamp(self._source.elf)
        done = self._source.make()
        if self._closing.is_set():
            return
        if done.returncode != 0:
            self._failed(self._source.refusal(done))
        else:
            self._built(stamp(self._source.elf) != before, printable(done.stderr))

    def close(self):
        """Ends the thread, after a build that is under way."""
        self._closing.set()
        self._thread.join()


def stamp(path):
    """When a file was written; None where there is none."""
    with contextlib.suppress(OSError):
        return pathlib.Path(path).stat().st_mtime_ns
    return None


def first_build(source):
    """Builds the program, and waits for the user where it does not compile."""
    while source.make(stdout=None, stderr=None).returncode != 0:
        wait_for_change(source, f"{one_line(source.path)} was not built.")


def wait_for_change(source, why):
    """Says that, and waits until a file of the program changes."""
    print(f"{why}\nWaiting until one of its files changes (Ctrl-C ends it).", flush=True)
    while not source.has_changed():
        time.sleep(LOOK)


def start(source, image, folder):
    """The running program; where it ends before its first frame, that of the user's next try."""
    for tries in itertools.count():
        place = folder / f"try-{tries}"
        place.mkdir()
        try:
            return Own(source, image, place)
        except ToolError as error:
            wait_for_change(source, error.shown())
            first_build(source)
