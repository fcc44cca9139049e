# SPDX-License-Identifier: MIT
"""The ways of frames and keys between a board and its viewer, against boards made up here."""

import struct
import threading

import numpy
import pytest

from conftest import COUNTERS_OF_A_FRAME, dump_bytes, random_frames
from fixel.base.errors import ToolError
from fixel.board import firmware
from fixel.view.view_window import KeyFile, Stream, Window
from view_bench import HELLO, bench_test, frame, read_frame, settled

BUILT_PROGRAMS = ()
WIDTH, HEIGHT = 32, 24
SLOTS = (4096, 8192)
PALETTE = bytes((5 * i) & 255 for i in range(768))


class FakeBoard:
    """The board's side of a window, from docs/formats.md, section 3, alone, on the file that a board would share."""

    def __init__(self, path):
        self.memory = numpy.memmap(path, numpy.uint8, "r+")

    def put(self, offset, layout, *values):
        data = struct.pack("<" + layout, *values)
        self.memory[offset:offset + len(data)] = numpy.frombuffer(data, numpy.uint8)

    def word(self, offset):
        return int(self.memory[offset:offset + 4].view("<u4")[0])

    def open(self, version=2, width=WIDTH, height=HEIGHT, slots=SLOTS, bits=8):
        self.put(28, "I", bits)
        self.put(4, "IHHII", version, width, height, *slots)
        self.memory[48:816] = numpy.frombuffer(PALETTE, numpy.uint8)
        self.put(0, "4s", b"FXLW")

    def finish(self, number, pixels, front=None):
        slot = number % 2 if front is None else front
        start = SLOTS[slot % 2]
        self.put(start, "QII3i3I9I", 1000 + number, number, 7, 1, -2, 3, 4, 5, 6, *COUNTERS_OF_A_FRAME)
        self.memory[start + 80:start + 80 + pixels.nbytes] = numpy.frombuffer(pixels.tobytes(), numpy.uint8)
        self.put(24, "I", slot)
        self.put(20, "I", number + 1)


@pytest.fixture
def patient():
    """A board that runs, for a test that must not hang: it is asked so often, however long that takes."""
    left = iter(range(10_000))

    def check(_waited):
        assert next(left, None) is not None, "nothing came"
        return True

    return check


@pytest.fixture
def pair(tmp_path, patient):
    """A window and a board that has opened its side."""
    window = Window(tmp_path / "window", 1 << 20)
    board = FakeBoard(tmp_path / "window")
    board.open()
    head = window.open(patient)
    assert (head.width, head.height, head.palette.tobytes()) == (WIDTH, HEIGHT, PALETTE)
    yield window, board
    window.close()


# --- the window -------------------------------------------------------------------

def test_the_board_is_invited_before_it_starts(tmp_path):
    """formats 3.3a."""
    window = Window(tmp_path / "window", 1 << 20)
    board = FakeBoard(tmp_path / "window")
    assert board.memory[32:36].tobytes() == b"VIEW"
    assert board.memory.size == 1 << 20 and not board.memory[:32].any()
    assert f"size={1 << 20}" in window.options[1] and "memory-backend=window" in window.options[3]


def test_the_window_waits_for_the_magic(tmp_path):
    """All else that a head has is there before it. formats 3.1c, 3.3c."""
    window, waits = Window(tmp_path / "window", 1 << 20), []
    board = FakeBoard(tmp_path / "window")
    board.open()
    board.put(0, "I", 0)

    def check(_waited):
        waits.append(window._head)
        if len(waits) == 3:
            board.put(0, "4s", b"FXLW")
        return len(waits) < 9

    head = window.open(check)
    assert waits == [None] * 3 and (head.width, head.height) == (WIDTH, HEIGHT)
    board.put(0, "I", 0)
    assert window.open(lambda _: False) is None
    window.close()


def test_a_comma_in_the_path(tmp_path):
    (tmp_path / "a,b").mkdir()
    assert "mem-path=" + str(tmp_path) + "/a,,b/window," in Window(tmp_path / "a,b" / "window", 4096).options[1]


def test_a_frame_and_what_is_told_of_it(pair):
    window, board = pair
    (pixels,) = random_frames(1, HEIGHT, WIDTH)
    board.finish(0, pixels)
    frame = window.copy()
    assert (frame.number, frame.clamped, frame.instructions) == (0, 7, 1000)
    assert (frame.position, frame.angles) == ((1, -2, 3), (4, 5, 6))
    assert tuple(frame.counters.values()) == COUNTERS_OF_A_FRAME
    assert numpy.array_equal(frame.pixels, pixels)


def test_a_frame_of_16_bits_a_pixel(tmp_path, patient):
    window = Window(tmp_path / "window", 1 << 20)
    board = FakeBoard(tmp_path / "window")
    board.open(bits=16)
    assert window.open(patient).palette.shape == (65536, 3)
    pixels = numpy.random.default_rng(1).integers(0, 65536, (HEIGHT, WIDTH), numpy.uint16)
    board.finish(0, pixels)
    assert numpy.array_equal(window.copy().pixels, pixels)
    window.close()


def test_a_frame_that_changed_while_it_was_copied_is_none(pair, monkeypatch):
    """formats 3.3g-h."""
    window, board = pair
    first, second = random_frames(2, HEIGHT, WIDTH)
    board.finish(0, first)
    real = window._word

    def race(offset):
        value = real(offset)
        if offset == 24:    # the front slot was read: now the board is faster
            board.finish(1, second)
        return value

    monkeypatch.setattr(window, "_word", race)
    assert window.copy() is None
    monkeypatch.undo()
    assert window.copy().number == 1


def test_the_board_is_asked_for_one_and_waited_for(pair):
    window, board = pair
    frames = random_frames(3, HEIGHT, WIDTH)
    for number, pixels in enumerate(frames):
        def answer(waited, number=number, pixels=pixels):
            assert board.word(36) == number + 1     # requested: one more than finished
            board.finish(number, pixels)
            return True
        frame = window.frame(answer)
        assert frame.number == number and numpy.array_equal(frame.pixels, pixels)


def test_a_board_that_need_not_wait(pair, patient):
    window, board = pair
    frames = random_frames(2, HEIGHT, WIDTH)
    board.finish(4, frames[0])
    assert window.frame(patient, waits=False).number == 4
    assert board.word(36) - board.word(20) > 1000

    def later(waited):
        board.finish(9, frames[1])
        return True
    assert window.frame(later, waits=False).number == 9    # not the same frame again


def test_a_board_that_runs_past_the_frame_that_it_is_asked_for(pair, patient):
    """It need not wait until it is asked for one frame: by then it may have finished more."""
    window, board = pair
    frames = random_frames(2, HEIGHT, WIDTH)
    board.finish(4, frames[0])
    assert window.frame(patient, waits=False).number == 4

    def answer(waited):
        board.finish(9, frames[1])
        return True
    assert window.frame(answer).number == 9


def test_frame_numbers_wrap(pair):
    window, board = pair
    (pixels,) = random_frames(1, HEIGHT, WIDTH)
    board.put(20, "I", 0xFFFFFFFF)

    def answer(waited):
        assert board.word(36) == 0
        board.finish(0, pixels)
        board.put(20, "I", 0)
        return True
    assert window.frame(answer) is not None


def test_nobody_wants_the_frame_any_more(pair):
    window, _ = pair
    assert window.frame(lambda waited: False) is None


def test_a_board_that_ended_says_so(pair):
    window, _ = pair

    def ended(waited):
        raise ToolError("it ended")
    with pytest.raises(ToolError, match="it ended"):
        window.frame(ended)


def test_keys_of_the_window(pair):
    window, board = pair
    window.hold(0x85)
    assert board.word(40) == 0x85
    window.hold(0)
    assert board.word(40) == 0


@pytest.mark.parametrize("changes, words", [
    ({"version": 1}, "version 1"), ({"bits": 4}, "pixels of 4 bits"), ({"width": 0}, "screen of 0x24"), ({"height": 1025}, "32x1025"),
    ({"slots": (100, 8192)}, "where they cannot be"), ({"slots": (4096, 4100)}, "where they cannot be"),
    ({"slots": (4096, (1 << 20) - 800)}, "where they cannot be")])
def test_a_board_that_went_astray(tmp_path, changes, words, patient):
    window = Window(tmp_path / "window", 1 << 20)
    FakeBoard(tmp_path / "window").open(**changes)
    with pytest.raises(ToolError, match=words):
        window.open(patient)


def test_a_front_that_is_none(pair):
    window, board = pair
    board.finish(0, random_frames(1, HEIGHT, WIDTH)[0], front=2)
    with pytest.raises(ToolError, match="slot 2; there are two"):
        window.copy()


def test_a_window_that_cannot_be_made(tmp_path):
    with pytest.raises(ToolError, match="cannot make"):
        Window(tmp_path / "none" / "window", 4096)


# --- the stream -------------------------------------------------------------------

def feed(path, data, step):
    """Writes into a FIFO as a board would, in a thread."""
    def write():
        with open(path, "wb", buffering=0) as file:
            for at in range(0, len(data), step):
                file.write(data[at:at + step])
    thread = threading.Thread(target=write)
    thread.start()
    return thread


@pytest.mark.parametrize("step", [7, 1000, 100000])
def test_a_dump_as_it_comes(tmp_path, step, patient):
    frames = random_frames(3)
    stream = Stream(tmp_path / "frames")
    thread = feed(tmp_path / "frames", dump_bytes(frames, palette=PALETTE), step)
    head = stream.open(patient)
    assert (head.width, head.height, head.palette.tobytes()) == (32, 24, PALETTE)
    for number, pixels in enumerate(frames):
        frame = stream.frame(patient)
        assert (frame.number, frame.position) == (number, (1, -2, 3))
        assert numpy.array_equal(frame.pixels, pixels)
        assert tuple(frame.counters.values()) == COUNTERS_OF_A_FRAME
    stream.close()
    thread.join(5)


def test_a_stream_that_ends_within_a_frame(tmp_path, patient):
    stream = Stream(tmp_path / "frames")
    thread = feed(tmp_path / "frames", dump_bytes(random_frames(2))[:2000], 500)
    assert stream.open(patient)
    asked = []

    def board_is_gone(waited):
        asked.append(waited)
        return len(asked) < 3
    assert stream.frame(patient) is not None
    assert stream.frame(board_is_gone) is None
    thread.join(5)


@pytest.mark.parametrize("data, words", [(b"not a dump" * 100, "does not begin with FXLD"),
                                         (dump_bytes(random_frames(1), version=9), "version 9")])
def test_a_stream_of_something_else(tmp_path, data, words, patient):
    stream = Stream(tmp_path / "frames")
    thread = feed(tmp_path / "frames", data, 2000)
    with pytest.raises(ToolError, match=words):
        stream.open(patient)
    stream.close()
    thread.join(5)


def test_a_frame_that_is_damaged(tmp_path, patient):
    data = bytearray(dump_bytes(random_frames(2)))
    second = data.index(b"FRAM", 1000)
    data[second:second + 4] = b"MARF"
    stream = Stream(tmp_path / "frames")
    thread = feed(tmp_path / "frames", bytes(data), 2000)
    assert stream.open(patient) and stream.frame(patient)
    with pytest.raises(ToolError, match="does not begin with FRAM"):
        stream.frame(patient)
    stream.close()
    thread.join(5)


def test_keys_of_a_file(tmp_path):
    keys = KeyFile(tmp_path / "keys")
    assert (tmp_path / "keys").read_bytes() == b"\0"
    keys.hold(0xC1)
    assert (tmp_path / "keys").read_bytes() == b"\xC1"
    keys.close()


def test_buttons_in_a_note():
    assert firmware.read_keys("") == {}
    assert firmware.read_keys("1:up,16:ctrl+up") == {1: ("up",), 16: ("ctrl", "up")}


# --- pixels that are pointed at ---------------------------------------------------------

@bench_test
async def test_a_pixel_is_told_to_those_who_point_at_it(bench):
    bench.hub.hello = {**HELLO, "judged": False, "picks": True, "width": 8, "height": 4}
    one, other = await bench.tab(), await bench.tab()
    bench.hub.show(frame(1))
    for socket in (one, other):
        await read_frame(socket)
    await one.send_json({"type": "point", "pixel": [7, 3]})
    await settled()
    assert bench.pump.pointed == {(7, 3)}
    bench.hub.picked(1, (7, 3), (0, 5, 9))
    assert await one.receive_json(timeout=None) == {"type": "picked", "number": 1, "pixel": [7, 3], "status": 0, "instance": 5, "face": 9}
    bench.hub.show(frame(2))
    assert (await read_frame(other))[0]["number"] == 2, "nothing came between"
    await one.close()
    await settled()
    assert bench.pump.pointed == set() and not bench.hub.picks


@bench_test
async def test_frames_of_another_size_are_greeted_anew_and_the_page_points_again(bench):
    bench.hub.hello = {**HELLO, "picks": True, "width": 8, "height": 4}
    socket = await bench.tab()
    await socket.send_json({"type": "point", "pixel": [7, 3]})
    await settled()
    bench.hub.begin({**bench.hub.hello})
    assert bench.pump.pointed == {(7, 3)}
    bench.hub.begin({**bench.hub.hello, "width": 4})
    assert bench.pump.pointed == set() and (await socket.receive_json(timeout=None))["width"] == 4


@pytest.mark.parametrize("pixel", [[8, 0], [0, 4], [-1, 0], [0], [0, 0, 0], [True, 0], [0.0, 0], "0,0", 0, {}])
def test_what_is_no_pixel_ends_the_tab(pixel):
    @bench_test
    async def refused(bench):
        bench.hub.hello = {**HELLO, "picks": True, "width": 8, "height": 4}
        socket = await bench.tab()
        await socket.send_json({"type": "point", "pixel": pixel})
        assert (await socket.receive(timeout=None)).data == 1008
        assert not bench.pump.pointed
    refused()


@bench_test
async def test_a_board_that_picks_nothing_is_pointed_at_by_nobody(bench):
    socket = await bench.tab()
    await socket.send_json({"type": "point", "pixel": [0, 0]})
    assert (await socket.receive(timeout=None)).data == 1008
