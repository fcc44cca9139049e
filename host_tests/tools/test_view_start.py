# SPDX-License-Identifier: MIT
"""A board starts, however long the tool takes until it talks with QEMU and reads what the board writes."""

import asyncio
import threading
import time
import types

import pytest

from board_programs import ROOT, built
from fixel.scene import making
from fixel.board import firmware, flash_memory, qmp
from fixel.base.errors import ToolError
from fixel.board.session import Session
from fixel.view.view_board import Board, Buttons
from fixel.view.view_window import Stream

DELAY = 2.0     # seconds; 0.05 were enough for the FIFO to fill


@pytest.fixture
def slow(monkeypatch):
    """A tool that is slow between QEMU's start and its first word."""
    real = qmp.Channel.connect

    def connect(channel, *arguments):
        time.sleep(DELAY)
        return real(channel, *arguments)

    monkeypatch.setattr(qmp.Channel, "connect", connect)


@pytest.fixture
def started(tmp_path):
    """For a board: its program, a flash image with a scene, and a folder."""
    def prepare(board):
        elf, scene, image = built(f"{board}/walk.elf"), tmp_path / "tiny.fxls", tmp_path / "flash.bin"
        making.build(str(ROOT / "scenes" / "tiny.toml"), str(scene))
        flash_memory.flash(board, elf, scene, image)
        return firmware.load(elf, board), image, tmp_path

    return prepare


@pytest.mark.parametrize("board", ["lm3s6965evb", "netduino2", "microbit", "mps2-an385"])
def test_a_board_that_is_watched(board, slow, started):
    running = Board(*started(board))
    try:
        first = running.frame().number
        assert running.frame().number == first + 1
        if running.program.keys:
            assert_buttons_that_fail_are_told(running)
    finally:
        running.close()
    running.hold(1)     # of a board that is off, as a page may that is told later


def assert_buttons_that_fail_are_told(running):
    def refuse(_released, _pressed):
        raise ToolError("QEMU refuses the key")
    running._machine.keys = refuse
    running.hold(min(running.program.keys))
    while not running._keys.error:      # they are pressed in another thread
        time.sleep(0.01)
    with pytest.raises(ToolError, match="QEMU refuses the key"):
        while True:     # those that are drawn already come first
            running.frame()


def test_a_press_that_fails_is_not_forgotten_when_another_succeeds():
    pressed = threading.Event()

    def press(_, names):
        if names == {"broken"}:
            raise ToolError("QEMU refuses the key")
        pressed.set()
    buttons = Buttons(types.SimpleNamespace(key=lambda *_: None, keys=press), {1: ["broken"], 2: ["whole"]})
    for bit in (1, 2):
        buttons.hold(bit)
    pressed.wait()
    buttons.close()
    assert "refuses" in str(buttons.error)


class Deaf(qmp.QMPClient):
    """QEMU while a core waits for whoever reads its stream: it runs, and answers nothing before."""

    heard = None    # set once the stream is read

    async def execute(self, command, arguments=None, **more):
        answer = await super().execute(command, arguments, **more)
        if command == "cont":
            while not self.heard.is_set():
                await asyncio.sleep(0.001)
        return answer


def test_a_board_whose_qemu_answers_once_its_stream_is_read(started, monkeypatch):
    Deaf.heard = threading.Event()
    real = Stream.open

    def open_stream(stream, check):
        head = real(stream, check)
        Deaf.heard.set()
        return head

    monkeypatch.setattr(Stream, "open", open_stream)
    monkeypatch.setattr(qmp, "QMPClient", Deaf)
    running = Board(*started("netduino2"))
    try:
        assert running.frame().number == 0
    finally:
        running.close()


def test_a_board_that_qemu_does_not_start_says_so(started, monkeypatch):
    async def refuse(client, command, arguments=None, **more):
        return await real(client, "no-such-command" if command == "cont" else command, arguments, **more)

    real = qmp.QMPClient.execute
    monkeypatch.setattr(qmp.QMPClient, "execute", refuse)
    with pytest.raises(ToolError, match="QEMU refuses 'cont'"):
        Board(*started("netduino2"))


def test_a_board_that_is_talked_to(slow, started):
    with Session(*started("lm3s6965evb"), ["frames=2"]) as session:
        session.wait_for_text("walk: done 2 frames")
