# SPDX-License-Identifier: MIT
"""The reference renderer beside a board that is watched: build/host/live answers frame by frame.

Slower than the board it skips frames, never the other way round: what is asked
for replaces what was not begun yet.
"""

import dataclasses
import struct
import subprocess
import threading

from fixel.base import children
from fixel.board import dump
from fixel.base.errors import ToolError

PARTS = 4                                       # of an answer, in the order of these bits
FRAME, OUTLINES, FACES, VERDICT = 1, 2, 4, 8    # what may be wanted, as bits; host_tests/judges/live says what each is
WANTS_ALL = FRAME | OUTLINES | FACES | VERDICT
FACE_SIZE = 16                                  # bytes of a pixel's face: host_tests/judges/live/main.c
REQUEST = struct.Struct("<4sB3x3i3II")
ANSWER = struct.Struct(f"<4sI{PARTS}I")


@dataclasses.dataclass(frozen=True)
class Answer:
    """What the reference renderer says of one frame of the board."""
    frame: dump.Frame
    given: int      # the parts that were wanted, as bits
    parts: tuple    # bytes of each part; empty where it was not wanted


class Reference:
    """The program, and a thread that talks with it. found(answer) and failed(error) are called from
    that thread. options: more for the program."""

    def __init__(self, program, scene, found, failed, options=()):
        self._found, self._failed = found, failed
        self._ready = threading.Condition()
        self._next, self._closing = None, False
        self._asked = 0
        try:
            # Its words on stderr are short: they wait in the pipe until they are wanted.
            self._process = children.start([program, scene, *options], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                           stderr=subprocess.PIPE, start_new_session=True)
        except OSError as error:
            raise ToolError(f"cannot start {program}: {error.strerror}; make all builds it") from error
        self._thread = threading.Thread(target=self._run, name="reference", daemon=True)
        self._thread.start()

    def ask(self, frame, wants):
        """Asks about a frame. What was asked before and is not begun is forgotten."""
        with self._ready:
            self._next = (frame, wants)
            self._ready.notify()

    def _run(self):
        try:
            while (asked := self._wait()) is not None:
                self._found(self._answer(*asked))
        except (OSError, struct.error, ToolError) as error:
            if not self._closing:
                self._process.kill()
                words = self._process.stderr.read().decode(errors="replace").strip()
                self._failed(ToolError(f"the reference renderer ended: {words or error}", exit_code=1))

    def _wait(self):
        with self._ready:
            self._ready.wait_for(lambda: self._closing or self._next)
            asked, self._next = self._next, None
        return None if self._closing else asked

    def _answer(self, frame, wants):
        self._process.stdin.write(REQUEST.pack(b"ASKS", wants, *frame.position, *frame.angles, frame.number))
        if wants & VERDICT:
            self._process.stdin.write(frame.pixels.tobytes())
        self._process.stdin.flush()
        magic, number, *sizes = ANSWER.unpack(self._read(ANSWER.size))
        area = frame.pixels.size
        wanted = [size if wants >> i & 1 else 0
                  for i, size in enumerate((frame.pixels.nbytes, sizes[1], FACE_SIZE * area, area))]
        if magic != b"TWIN" or number != self._asked or sizes != wanted:
            raise ToolError("its answer does not have the agreed form")
        self._asked += 1
        return Answer(frame, wants, tuple(self._read(size) for size in sizes))

    def _read(self, size):
        data = self._process.stdout.read(size)
        if len(data) != size:
            raise ToolError("its answer is cut off")
        return data

    def close(self):
        """Ends the program and the thread."""
        with self._ready:
            self._closing = True
            self._ready.notify()
        self._process.kill()
        self._thread.join()
        self._process.wait()
        for pipe in (self._process.stdin, self._process.stdout, self._process.stderr):
            try:
                pipe.close()
            except OSError:
                pass    # a request that could not be sent any more
