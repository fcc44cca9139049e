# SPDX-License-Identifier: MIT
"""The game: a recorded play gives the same frames on every board, and from the wires of displays."""

import hashlib
import json
import subprocess

import pytest
from conftest import run_cli, run_make

from fixel import dump, grey
from test_displays import build_oled, fixture_show, read_messages, read_wires, rgb565   # noqa: F401: show is a fixture

SCENE = "examples/game/game.toml"
SMALL = "128x64"
FRAMES = 320
# Of all frames of a screen, one after the other.
SHA256 = {
    "320x240": "ed4754fcd9b45e1a041cf4b49d7fb6ee41f870aed44e372bff0b66583d49ee58",
    SMALL: "62fc091dc93a8f4b191efb9c94e795722a24b854776913145642e37c40b7de79",
}


def play(out, board, screen, frames=FRAMES, rows=None):
    """The frames of the recorded play on a board, in bands of at most so many rows."""
    choice, options = (f"-rows-{rows}", ["--rows", rows]) if rows else ("", [])
    name = f"build/boards/{board}/game{choice}{'' if board == 'host' else '.elf'}"
    built = run_make(name, f"build/boards/host/game{choice}", "PROGRAM=game", *([f"ROWS={rows}"] if rows else []))
    assert built.returncode == 0, built.stdout + built.stderr
    done = run_cli("run", "--program", "game", "--board", board, "--scene", SCENE, "--screen", screen, "--out", out,
                   "--frames", frames, *options)
    assert done.returncode == 0, done.stdout + done.stderr
    summary = json.loads((out / "summary.json").read_text())
    assert summary["host_frames_equal"] and summary["pixels_differing"] is None
    return dump.read_dump(out / "board.fxld")


def digest(drawn):
    return hashlib.sha256(b"".join(frame.pixels.tobytes() for frame in drawn.frames)).hexdigest()


@pytest.fixture(scope="module", params=SHA256, name="played")
def fixture_played(request, tmp_path_factory):
    """The screen, and its frames on the host."""
    return request.param, play(tmp_path_factory.mktemp("game") / "out", "host", request.param)


def test_the_recorded_play_is_the_recorded_one(played):
    screen, drawn = played
    assert digest(drawn) == SHA256[screen]


@pytest.mark.parametrize("board", ["mps2-an385", "microbit", "mps3-an547", "lm3s6965evb"])
def test_boards_play_the_same_game(tmp_path, board):
    screen = SMALL if board == "lm3s6965evb" else "320x240"
    assert digest(play(tmp_path / "out", board, screen)) == SHA256[screen]


def test_bands_of_three_rows_play_the_same_game(tmp_path):
    assert digest(play(tmp_path / "out", "microbit", "320x240", rows=3)) == SHA256["320x240"]


def test_no_number_of_rows_is_refused():
    for rows in ("0", "1025", "x"):
        done = run_make("run", f"ROWS={rows}")
        assert done.returncode == 2 and f"ROWS={rows} is no number of rows from 1 to 1024" in done.stderr


def test_a_board_without_the_memory_says_so_before_anything_is_built(tmp_path):
    done = run_make("run", "PROGRAM=game", "BOARD=stm32vldiscovery", f"BUILD={tmp_path / 'build'}")
    assert done.returncode == 2 and not (tmp_path / "build").exists()
    said = [line for line in done.stderr.splitlines() if line]
    assert len(said) == 1 and "PROGRAM=game needs more memory than BOARD=stm32vldiscovery has; the boards" in said[0]
    assert " microbit " in said[0] and said[0].count("stm32vldiscovery") == 1


def test_it_is_a_game(played):
    """Shots, rocks and lives come and go, and the score is drawn."""
    _, drawn = played
    counts = {frame.counters["in"] for frame in drawn.frames}
    assert len(counts) > 10, "instances come and go"
    entries = {entry: sum(int((frame.pixels == entry).any()) for frame in drawn.frames) for entry in (252, 253, 254, 255)}
    assert entries[252] == entries[253] == FRAMES, "score and sight are in every frame"
    assert 0 < entries[254] < FRAMES and 0 < entries[255] <= FRAMES, "hits show, and lives run out"


PAIRS = [(40, 41), (250, 319)]  # the program shows two frames


def test_an_ili9341_shows_it(played, show):
    """Converted and sent by pump and driver, and read back from the wires."""
    screen, drawn = played
    for first, second in PAIRS:
        frames = [drawn.frames[first].pixels, drawn.frames[second].pixels]
        done, wires, _ = show(drawn.palette, frames, 8)
        assert done.returncode == 0, done.stderr.decode()
        height, width = frames[1].shape
        shown = read_wires(wires).memory[(240 - height) // 2:(240 + height) // 2, (320 - width) // 2:(320 + width) // 2]
        assert (shown == rgb565(drawn.palette)[frames[1]]).all()


def test_an_oled_shows_it(played, tmp_path):
    screen, drawn = played
    if screen != SMALL:
        return
    oled = build_oled(tmp_path)
    for frame in (drawn.frames[number].pixels for pair in PAIRS for number in pair):
        done = subprocess.run([oled], cwd=tmp_path, capture_output=True, input=drawn.palette.tobytes() + frame.tobytes(),
                              check=True)
        shown, on = read_messages(done.stdout)
        assert on and (shown == grey.levels(frame, drawn.palette, 1)).all()
