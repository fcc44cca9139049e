# SPDX-License-Identifier: MIT
"""The game: a recorded play gives the same frames on every board, and again from the wires of displays."""

import hashlib
import json
import subprocess

import pytest
from board_programs import EVERY_BOARD, made
from conftest import CHECKOUT, run_cli, run_make, sampled

from fixel.scene import making
from fixel.base.errors import ToolError
from fixel.board import controllers, dump, emulator, firmware, flash_memory, wires

BUILT_PROGRAMS = ("boards/*/game*", "host/judge", "host/libfixel.a", "host/predict", "host/raycast")
SCENE = "examples/game/game.toml"
SMALL = "128x64"
FRAMES = 320
# Of all frames of a screen, one after the other.
SHA256 = {
    "320x240": "ed4754fcd9b45e1a041cf4b49d7fb6ee41f870aed44e372bff0b66583d49ee58",
    SMALL: "62fc091dc93a8f4b191efb9c94e795722a24b854776913145642e37c40b7de79",
}
# A driver for each screen, and all pictures that a controller makes of what it sends: RGB565, and 1 bit in pages.
WIRES = {
    "320x240": ("ili9341", "0cafa88305c89422467eafc354ef0e4cdff6ce765503a305a63fb5fb8ab38738"),
    SMALL: ("ssd1306", "4ceade738b0c655ab48cf1fb824a7d8adbcdb9553c348ba0d0dd52b450e1ab57"),
}
# place board: with little memory: TOO_SMALL, and the boards on which the game has RGB565
TOO_SMALL = {"stm32vldiscovery"}    # 8 KiB
BOARDS = [firmware.HOST, *sampled("game", [board for board in EVERY_BOARD if board not in TOO_SMALL], 3)]


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


@pytest.fixture(scope="module", name="image")
def fixture_image(tmp_path_factory):
    """The scene image for each screen."""
    folder = tmp_path_factory.mktemp("scene")
    for screen in SHA256:
        making.build(str(CHECKOUT / SCENE), str(folder / f"{screen}.fxls"), screen=making.parse_screen(screen))
    return lambda screen: folder / f"{screen}.fxls"


@pytest.fixture(scope="module", params=SHA256, name="played")
def fixture_played(request, image, tmp_path_factory):
    """The screen, and its frames on the host."""
    folder = tmp_path_factory.mktemp("game")
    emulator.run(firmware.HOST, image(request.param), made("build/boards/host/game", "BOARD=host", "PROGRAM=game"),
                 folder / "host.fxld")
    return request.param, dump.read_dump(folder / "host.fxld")


def test_the_recorded_play_is_the_recorded_one(played):
    screen, drawn = played
    assert digest(drawn) == SHA256[screen]


def played_on(driver, board, image, folder):
    """The frames of the game on a board, and what the wires of a display's driver say of them."""
    elf = made(f"build/boards/{board}/game-on-{driver}{'' if board == firmware.HOST else '.elf'}", f"BOARD={board}",
               "PROGRAM=game", f"DRIVER={driver}")
    file, record = folder / "board.fxld", folder / "wires.bin"
    flash_memory.flash(board, elf, image, folder / "board.bin")
    emulator.run(board, folder / "board.bin", elf, file, record=record)
    drawn = dump.read_dump(file)
    return drawn, wires.compare(record, driver, drawn)


@pytest.mark.parametrize("screen", SHA256)
@pytest.mark.parametrize("board", BOARDS)
def test_every_board_plays_the_same_game_and_sends_it(tmp_path, image, board, screen):
    """Before conversion the frames are the recorded ones; then by pump and driver, in bands of eight rows (three on the
    microbit at 320x240), to a controller that shows every one of them."""
    driver, sha256 = WIRES[screen]
    drawn, found = played_on(driver, board, image(screen), tmp_path)
    assert digest(drawn) == SHA256[screen]
    assert found.equal == len(found.hashes) == FRAMES
    assert hashlib.sha256("".join(found.hashes).encode()).hexdigest() == sha256


# Plays the scene file's path to examples/game/on_display.c; what is sent goes to stdout as a record of wires.
ON_DISPLAY = """
#include <stdio.h>
#include "game/on_display.h"
static _Alignas(8) unsigned char bytes[1 << 18];
static fxl_scene_image image;
static uint32_t frame, stride, played;
static void put(int kind, const uint8_t *data, size_t size)
{
    const uint32_t count = (uint32_t)size;
    putchar(kind);
    fwrite(&count, 4, 1, stdout);
    fwrite(data, 1, size, stdout);
}
static bool send(void *user, bool is_data, const uint8_t *data, size_t size)
{
    (void)user;
    put(is_data ? 'D' : 'C', data, size);
    return true;
}
static bool start(void *user, const uint8_t *data, size_t size) { return send(user, true, data, size); }
static bool wait(void *user) { (void)user; return true; }
static void pause(void *user, uint32_t time) { (void)user; put('P', (const uint8_t *)&time, 4); }
static bool next_keys(uint32_t *keys)
{
    if (frame > 0) {
        const uint32_t last = frame - 1;
        put('F', (const uint8_t *)&last, 4);
    }
    if (played == image.segments[stride].frames) {
        stride++;
        played = 0;
    }
    if (frame == image.frame_count) { return false; }
    played++;
    frame++;
    *keys = image.segments[stride].keys;
    return true;
}
int main(int argc, char **argv)
{
    const fxl_display_driver *const driver = argc > 1 ? &fxl_ssd1306 : &fxl_ili9341;
    const fxl_display_config module = fxl_display_config_default(driver, argc > 1 ? 0 : 1);
    const fxl_display_port port = {NULL, send, start, wait, pause};
    const size_t size = fread(bytes, 1, sizeof bytes, stdin);
    (void)argv;
    return fxl_scene_open(bytes, size, &image, NULL) ||
           game_on_display(bytes, size, &module, &port, next_keys);
}
"""


@pytest.mark.parametrize("screen", SHA256)
def test_the_example_draws_it_on_a_display(tmp_path, image, build, screen):
    """With neither board nor walk: the bands of the pump are drawn into, and sent."""
    driver, sha256 = WIRES[screen]
    (tmp_path / "main.c").write_text(ON_DISPLAY, encoding="utf-8")
    examples = CHECKOUT / "examples"
    done = subprocess.run(["gcc", "-std=c11", "-Wall", "-Wextra", "-Werror", "-fsanitize=address,undefined", f"-I{examples}",
                           f"-I{CHECKOUT / 'lib/include'}", "main.c", examples / "game/game.c", examples / "game/on_display.c",
                           build / "host/libfixel.a", "-o", "play"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    with (tmp_path / "wires.bin").open("wb") as record, image(screen).open("rb") as scene:
        subprocess.run([tmp_path / "play", *(["small"] if screen == SMALL else [])], stdin=scene, stdout=record, check=True)
    with (tmp_path / "wires.bin").open("rb") as record:
        hashes = [hashlib.sha256(shown.astype("<u2").tobytes()).hexdigest()
                  for shown, _ in wires.read(record, controllers.start(driver), int(1 in controllers.model(driver).TURNS))]
    assert len(hashes) == FRAMES and hashlib.sha256("".join(hashes).encode()).hexdigest() == sha256


@pytest.fixture(scope="module", name="rgb565_image")
def fixture_rgb565_image(tmp_path_factory):
    """The image of the scene that asks for RGB565, with a depth buffer of so many bits, for each screen."""
    folder = tmp_path_factory.mktemp("rgb565")
    text = (CHECKOUT / SCENE).read_text(encoding="utf-8")

    def make(screen, depth=0):
        scene = folder / f"{depth}.toml"
        scene.write_text(text.replace("[view]\n", f'[view]\npixels = "rgb565"\ndepth = {depth}\n'), encoding="utf-8")
        making.build(str(scene), str(folder / f"{screen}-{depth}.fxls"), screen=making.parse_screen(screen))
        return folder / f"{screen}-{depth}.fxls"

    return make


@pytest.mark.parametrize("board", BOARDS)
def test_every_board_plays_it_in_rgb565_also_on_a_display(tmp_path, played, rgb565_image, board):
    """Faces and words have the colours of the palette that the recorded frames are of; black and white is made of these colours."""
    screen, recorded = played
    driver, _ = WIRES[screen]
    drawn, found = played_on(driver, board, rgb565_image(screen), tmp_path)
    colours = wires.rgb565(recorded.palette)
    assert all((frame.pixels == colours[indices.pixels]).all()
               for frame, indices in zip(drawn.frames, recorded.frames, strict=True))
    assert found.equal == len(found.hashes) == FRAMES


@pytest.mark.parametrize("board, depth", [("microbit", 16), ("lm3s6965evb", 32), ("netduinoplus2", 16)])
def test_a_board_without_room_for_rgb565_with_a_depth_buffer_names_both(tmp_path, rgb565_image, board, depth):
    elf = made(f"build/boards/{board}/game.elf", f"BOARD={board}", "PROGRAM=game")
    flash_memory.flash(board, elf, rgb565_image("320x240", depth), tmp_path / "board.bin")
    with pytest.raises(ToolError, match=f"this board's program draws no RGB565 with a depth buffer of {depth} bits: leave out"):
        emulator.run(board, tmp_path / "board.bin", elf, tmp_path / "board.fxld")


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
