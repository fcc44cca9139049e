# SPDX-License-Identifier: MIT
"""How the live window starts and ends: a board starts, however long the tool takes until it talks with QEMU and reads what the board writes;
it ends by Ctrl-C, by other signals, by force, with its board; and what it refuses."""

import asyncio
import os
import pty
import re
import signal
import subprocess
import sys
import termios
import threading
import time
import types

import pytest

from board_programs import ROOT, built
from conftest import CHECKOUT, LAUNCHER, assert_one_sentence, environment, run_cli
from fixel.base.errors import ToolError
from fixel.board import firmware, flash_memory, qemu as qmp
from fixel.board.session import Session
from fixel.scene import making
from fixel.view import browser, view
from fixel.view.view_board import Board, Buttons
from fixel.view.view_window import Stream
from viewers import (HEIGHT, WIDTH, assert_gone, assert_refuses, assert_started, children, left, own_build, own_port, plaza_image, ready,
                     ready_board)     # plaza_image and ready_board are fixtures

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "boards/lm3s6965evb/walk.elf", "boards/microbit/walk.elf",
                  "boards/netduino2/walk.elf", "host/live")
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


# --- how it ends ------------------------------------------------------------------------------

@pytest.fixture
def programs(build, tmp_path):
    return own_build(build, tmp_path)


def read_until(terminal, pattern):
    text = ""
    while (found := re.search(pattern, text)) is None:
        text += os.read(terminal, 4096).decode(errors="replace")
    return found


def test_ctrl_c_ends_everything(board, build, chromium):
    """make view in a terminal of its own, with a page that looks on and a key down; impatiently."""
    ours, theirs = pty.openpty()
    sane = termios.tcgetattr(theirs)
    process = subprocess.Popen(["make", "--no-print-directory", "view", f"BOARD={board}",
                                f"PORT={own_port()[1]}"], cwd=CHECKOUT,
                               stdin=theirs, stdout=theirs, stderr=theirs, env=environment(),
                               preexec_fn=lambda: os.login_tty(os.dup(theirs)))
    try:
        address = read_until(ours, browser.ADDRESS)[0]
        with browser.page(chromium, address, WIDTH, HEIGHT) as page:
            page.keyboard.down("ArrowUp")
            found = children(process.pid)
            assert_started(found)
            folder = build / re.search(r"[.]fixel-view-\w+", " ".join(found.values()))[0]
            assert folder.is_dir()
            for _ in range(3):
                os.write(ours, b"\x03")
                time.sleep(0.05)
            page.wait_for_selector("#state.ended")
            assert page.inner_text("#banner") == "The view was ended."
        assert process.wait() in (0, -signal.SIGINT, 128 + signal.SIGINT)
        assert_gone(found)
        assert not folder.exists()
        assert_refuses(address)
        assert termios.tcgetattr(theirs) == sane
    finally:
        process.kill()
        process.wait()
        os.close(ours)
        os.close(theirs)


@pytest.mark.parametrize("ending", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_other_endings(scene, build, programs, ending):
    ready("mps2-an385", build)
    with browser.viewing("mps2-an385", scene, programs, own_port()) as (process, address):
        found = children(process.pid)
        assert_started(found)
        process.send_signal(ending)
        assert process.wait() == 0 and "error" not in process.stderr.read()
        assert_gone(found)
    assert not left(programs)
    assert_refuses(address)


@pytest.mark.parametrize("sign", [".fixel-view-", "qemu-system-arm", "host/live"])
@pytest.mark.parametrize("ending", [signal.SIGINT, signal.SIGTERM])
def test_ended_while_it_starts(scene, build, programs, ending, sign):
    """As soon as the first sign of what it starts is seen."""
    ready("mps2-an385", build)
    process = subprocess.Popen([sys.executable, str(LAUNCHER), "view", "--board", "mps2-an385", "--scene", str(scene),
                                "--build", str(programs)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
    try:
        while not any(sign in each for each in [*left(programs), *children(process.pid).values()]):
            assert process.poll() is None, f"{sign} does not come"
            time.sleep(0.005)
        found = children(process.pid)
        process.send_signal(ending)
        _, words = process.communicate()
        assert process.returncode in (0, 128 + ending) and "Traceback" not in words, words
        assert_gone(found)
        assert not left(programs)
    finally:
        process.kill()
        process.communicate()


def test_killed_it_leaves_nothing_running(board, scene, programs):
    with browser.viewing(board, scene, programs, own_port()) as (process, address):
        found = children(process.pid)
        assert_started(found)
        process.kill()
        assert_gone(found)
    assert_refuses(address)


def test_a_board_that_ends_is_an_error_on_the_page_and_in_the_terminal(board, scene, programs, chromium):
    with browser.viewing(board, scene, programs, own_port()) as (process, address), \
            browser.page(chromium, address, WIDTH, HEIGHT) as page:
        (qemu,) = [number for number, command in children(process.pid).items() if "qemu-system-arm" in command or "host/walk" in command]
        os.kill(qemu, signal.SIGKILL)
        page.wait_for_selector("#state.ended")
        assert f"board {board} ended" in page.inner_text("#banner")
        assert process.wait() not in (0, None)
        words = process.stderr.read()
        assert f"error: board {board} ended: it was ended by signal 9\n" in words and "Traceback" not in words
    assert not left(programs)


# --- what is refused ----------------------------------------------------------------

@pytest.mark.parametrize("options, words", [
    (("--port", "web"), "PORT is 'web'"),
    (("--port", "65536"), "from 1 to 65535"), (("--port", "0"), "from 1 to 65535"),
    (("--scene", "none.toml"), "none.toml"), (("--scene", "scene.fxls", "--screen", "128x64"), "scene.fxls"),
    (("--screen", "0x0"), "0x0"), (("--build", "/nowhere/at/all"), "/nowhere/at/all")])
def test_refused(scene, programs, options, words):
    start = ["--board", "mps2-an385", "--scene", scene, "--build", programs]
    assert_one_sentence(run_cli("view", *start, *options), words)
    assert not left(programs)


def test_a_visibility_method_that_there_is_not_is_refused_before_a_program_is_looked_for(monkeypatch):
    monkeypatch.setattr(view, "view", None)
    with pytest.raises(ToolError, match="there is no VISIBILITY 'none'; the visibility methods are: "):
        view.main(["--board", "mps2-an385", "--scene", "scene.toml", "--visibility", "none"])
