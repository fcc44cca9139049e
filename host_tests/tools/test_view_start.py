# SPDX-License-Identifier: MIT
"""A board starts, however long the tool takes until it talks with QEMU and reads what the board writes."""

import time

import pytest

import scene as scene_tool
from board_programs import ROOT, built
from fixel import firmware, flash, qmp
from fixel.session import Session
from fixel.view_board import Board

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
        scene_tool.build(str(ROOT / "scenes" / "tiny.toml"), str(scene))
        flash.flash(board, elf, scene, image)
        return firmware.load(elf, board), image, tmp_path

    return prepare


@pytest.mark.parametrize("board", ["lm3s6965evb", "netduino2", "microbit", "mps2-an385"])
def test_a_board_that_is_watched(board, slow, started):
    running = Board(*started(board))
    try:
        first = running.frame().number
        assert running.frame().number == first + 1
    finally:
        running.close()


def test_a_board_that_is_talked_to(slow, started):
    with Session(*started("lm3s6965evb"), ["frames=2"]) as session:
        session.wait_for_text("walk: done 2 frames")
