# SPDX-License-Identifier: MIT
"""The keys of lm3s6965evb: pressed in QEMU, seen by the firmware, walked by the viewer.

What the firmware took for keys is worked out from the poses in its dump. It must
be what was pressed; the same keys as a path of steps must give the same frames on
the host, bit for bit, and the same walk by the reference renderer.
"""

import dataclasses
import fcntl
import math
import os
import pathlib
import threading
import time

import pytest

from board_programs import built, flashed
from fixel.base import output
from fixel.board import dump, emulator, firmware
from fixel.image import image
from fixel.board.programs import HostPrograms
from fixel.board.session import Session, touch_keys

BUILT_PROGRAMS = ("host/judge",)
BOARD = "lm3s6965evb"
FRAMES = 800
PAUSE = 24              # frames for which a state of the keys lasts at least
PIPE_BYTES = 4096       # less than a frame
UNIT = 65536
TURN = 2 ** 32

# What is held, one state after the other, and what that means to the viewer.
SCRIPT = [
    ((), ()),
    (("up",), ("forward",)),
    (("up", "left"), ("forward", "left")),
    (("left",), ("left",)),
    ((), ()),
    (("right",), ("right",)),
    (("right", "down"), ("right", "back")),
    ((), ()),
    (("ctrl",), ()),
    (("ctrl", "up"), ("pitch_up",)),
    (("ctrl", "up", "left"), ("pitch_up", "roll_left")),
    (("ctrl", "left"), ("roll_left",)),
    (("ctrl",), ()),
    (("ctrl", "down"), ("pitch_down",)),
    (("ctrl",), ()),
    (("ctrl", "right"), ("roll_right",)),
    (("ctrl",), ()),
    ((), ()),
    (("up", "down", "left"), ("forward", "back", "left")),
    ((), ()),
]


class Gate:
    """A board's dump on its way to a file: the board waits where nobody takes its
    frames, so that it is hardly a frame ahead, however fast it is. QEMU waits with
    it, and answers no question: so with a question the gate is open."""

    def __init__(self, path, size, each):
        self.file, self._each, self._written = path.with_suffix(".taken"), each, 0
        self._head = dump.HEAD.size + dump.PALETTE_BYTES
        self._until, self._moved = 0, threading.Condition()
        os.mkfifo(path)
        self._end = os.open(path, os.O_RDONLY | os.O_NONBLOCK)  # waits for no writer
        os.set_blocking(self._end, True)
        fcntl.fcntl(self._end, fcntl.F_SETPIPE_SZ, size)
        self._thread = threading.Thread(target=self._take, daemon=True)
        self._thread.start()

    def frames(self):
        """How many have come."""
        return max(0, self._written - self._head) // self._each

    def _take(self):
        with self.file.open("wb") as to:
            while True:
                with self._moved:
                    self._moved.wait_for(lambda: self.frames() < self._until)
                data = os.read(self._end, 1 << 16)
                if not data and self._written:
                    return
                if not data:
                    time.sleep(0.005)   # no writer yet
                with self._moved:
                    to.write(data)
                    to.flush()
                    self._written += len(data)
                    self._moved.notify_all()

    def open(self, frames=1 << 30):
        """Lets so many more frames pass."""
        with self._moved:
            self._until = self.frames() + frames
            self._moved.notify_all()

    def finish(self):
        """Takes the rest, of a board that has ended."""
        self.open()
        self._thread.join(60)
        os.close(self._end)


def play(scene, folder):
    """Walks live while the script's keys are pressed; the board's dump."""
    gate = Gate(pathlib.Path(folder) / emulator.DUMP_NAME, PIPE_BYTES,
                dump.FRAME_HEAD.size + scene.host.width * scene.host.height + dump.FRAME_TAIL.size)
    with Session(scene.program, scene.image, folder, [f"frames={FRAMES}", "live"]) as board:

        def let_pass(count):
            until = gate.frames() + count
            gate.open(count)
            board.wait_until(lambda: gate.frames() >= until, 60, f"frame {until}")

        let_pass(2)
        gate.open()
        touch_keys(board.machine)
        held = set()
        for keys, _ in SCRIPT:
            gate.open()
            board.machine.keys(held - set(keys), set(keys) - held)
            held = set(keys)
            let_pass(PAUSE)
        gate.open()
        assert board.wait_for_end(120) == emulator.exit_code("DONE"), board.text()
    gate.finish()
    dump.check(gate.file, FRAMES)
    return dump.read_dump(gate.file)


def around(difference):
    """An angle's difference, between minus and plus half a turn."""
    return (difference + TURN // 2) % TURN - TURN // 2


def turned(before, after, turn, plus, minus):
    """Which of a pair of keys turned an angle."""
    return {turn: {plus}, -turn: {minus}, 0: set()}[around(after - before)]


@dataclasses.dataclass
class Walker:
    """Keys from poses: docs/extras/player.md, backwards."""
    gait: tuple
    speed: float = 0.0

    def keys(self, before, after):
        acceleration, friction, top, turn = self.gait
        yaw, pitch, _ = (2 * math.pi * angle / TURN for angle in after.angles)
        ahead = (math.cos(pitch) * math.sin(yaw), math.cos(pitch) * math.cos(yaw))
        moved = [after.position[axis] - before.position[axis] for axis in (0, 2)]
        speed = (moved[0] * ahead[0] + moved[1] * ahead[1]) / (ahead[0] ** 2 + ahead[1] ** 2)
        candidates = {frozenset(): self.speed, frozenset(["forward"]): self.speed + acceleration,
                      frozenset(["back"]): self.speed - acceleration}
        candidates = {keys: min(max(value, -top), top) for keys, value in candidates.items()}
        error, found = min((abs(value - speed), keys) for keys, value in candidates.items())
        assert error < 8, f"frame {after.number}: no key moves like that"
        moving = candidates[found]
        self.speed = math.copysign(max(0, abs(moving) - friction), moving)
        return frozenset(found | turned(before.angles[0], after.angles[0], turn, "right", "left")
                         | turned(before.angles[1], after.angles[1], turn, "pitch_up", "pitch_down")
                         | turned(before.angles[2], after.angles[2], turn, "roll_left", "roll_right"))


def keys_seen(walked, start, gait):
    """The keys of each frame, as sets of names."""
    before = dump.Frame(-1, start[:3], start[3:], None, {}, 0, 0)
    walker, keys = Walker(gait), []
    for frame in walked.frames:
        keys.append(walker.keys(before, frame))
        before = frame
    return keys


def runs(values):
    """Values with how often each came in a row."""
    rows = []
    for value in values:
        if rows and rows[-1][0] == value:
            rows[-1][1] += 1
        else:
            rows.append([value, 1])
    return rows


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    return flashed(BOARD, "plaza", tmp_path_factory.mktemp("plaza"), (128, 64))


@pytest.fixture(scope="module")
def walked(scene, tmp_path_factory):
    """(the folder, the board's dump, the keys of each frame)"""
    folder = tmp_path_factory.mktemp("live")
    board = play(scene, folder)
    loaded = image.load(scene.scene)
    return folder, board, keys_seen(board, loaded.start, loaded.gait)


def opposites_cancel(keys):
    return frozenset(keys) - {"forward", "back"} if {"forward", "back"} <= set(keys) else frozenset(keys)


def test_the_viewer_saw_the_keys_that_were_pressed(walked):
    """In this order, each for as long as it was held, and no other for longer than the few frames in
    which one key of several had come and the next had not."""
    _, _, seen = walked
    steady = [keys for keys, count in runs(seen) if count >= PAUSE // 2]
    expected = [opposites_cancel(meaning) for _, meaning in SCRIPT]
    assert runs(steady) and [keys for keys, _ in runs(steady)] == [keys for keys, _ in runs(expected)]


def test_the_host_walks_the_same_way_with_the_same_keys(scene, walked, tmp_path):
    _, board, seen = walked
    scene_file = steps_image(scene, seen, tmp_path / "steps.fxls")
    emulator.run(firmware.HOST, scene_file, built("host/walk"), tmp_path / "host.fxld")
    host = dump.read_dump(tmp_path / "host.fxld")
    assert len(host.frames) == len(board.frames) == FRAMES
    for expected, frame in zip(host.frames, board.frames):
        assert (frame.position, frame.angles) == (expected.position, expected.angles), frame.number
        assert (frame.pixels == expected.pixels).all(), frame.number


def test_and_so_does_the_double_twin(build, scene, walked, tmp_path):
    folder, board, seen = walked
    scene_file = steps_image(scene, seen, tmp_path / "steps.fxls")
    verdict = HostPrograms(build).judge(scene_file, (folder / emulator.DUMP_NAME).with_suffix(".taken"), tmp_path / "judge.json",
                                        tmp_path / "twin.fxld")
    walk = verdict["walk"]
    assert walk["frames"] == FRAMES and walk["frames_beyond_bound"] == 0
    travelled = max(abs(a - b) for a, b in zip(board.frames[-1].position, board.frames[0].position))
    assert travelled > UNIT     # it went somewhere


def steps_image(scene, seen, file):
    """The scene with a path of steps: these keys."""
    loaded = image.load(scene.scene)
    loaded.path_kind = image.STRIDES
    loaded.path = [(sum(image.KEYS[key] for key in keys), count) for keys, count in runs(seen)]
    output.write_file(str(file), image.pack(loaded))
    return file
