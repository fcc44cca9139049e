# SPDX-License-Identifier: MIT
"""docs/tutorials: each page's blocks are written to the files that they name, each of its commands is typed, in their order, and the
picture of the page is what comes out."""

import re
import shlex
import subprocess

import numpy
import pytest
from PIL import Image

import test_ports
from conftest import CHECKOUT, environment
from fixel.scene import making
from outside import need

PAGES = CHECKOUT / "docs" / "tutorials"
NAMES = ("cube", "model", "display", "board", "sensor", "game")
BLOCK = re.compile(r"```(?:c|ld|obj|mtl)\n((?:/\*|#) ([\w/]+\.\w+)\b.*?)```", re.DOTALL)
COMMAND = re.compile(r"^    (\w.*)$", re.MULTILINE)
# What a test cannot type: it has no end, or needs what only the reader has.
LEFT_OUT = ("qemu-system-arm", "make view", "cmake ")


def page(name):
    return (PAGES / f"{name}.md").read_text(encoding="utf-8")


def steps(text):
    """("write", file, text) and ("type", command) of a page, in its order. Lines within a block are no commands."""
    found = [(match.start(), "write", match[2], match[1]) for match in BLOCK.finditer(text)]
    blank = re.sub(r"```.*?```", lambda match: " " * len(match[0]), text, flags=re.DOTALL)
    found += [(match.start(), "type", match[1]) for match in COMMAND.finditer(blank) if not match[1].startswith(LEFT_OUT)]
    return [step[1:] for step in sorted(found)]


def follow(name, folder):
    """Does what a page says. The folder stands for my/, so that the checkout stays as it is."""
    for kind, *words in steps(page(name)):
        if kind == "write":
            file = folder / words[0]
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(words[1], encoding="utf-8")
        else:
            command = re.sub(r"\bmy\b(?=/|$|\s)", str(folder), words[0]).replace("-Imy", f"-I{folder}")
            if "BOARD=pico" in command:
                need("node", "npm")
            done = subprocess.run(["sh", "-c", command], cwd=CHECKOUT, env=environment(), stdin=subprocess.DEVNULL, text=True, capture_output=True,
                                  check=False)
            assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"
            if "make run" in command and "BOARD=host" not in command:
                assert re.search(r"equal to host +yes", done.stdout), done.stdout
    return folder


def pixels(file):
    with Image.open(file) as picture:
        return numpy.asarray(picture.convert("RGB"))


def test_the_pages_are_six_and_listed():
    index = (PAGES / "README.md").read_text(encoding="utf-8")
    assert re.findall(r"^\| \[(\w+)\]\(\w+\.md\)", index, re.MULTILINE) == list(NAMES)
    assert {file.stem for file in PAGES.glob("*.md")} == {*NAMES, "README"}
    for name in NAMES:
        text = page(name)
        assert text.count("```") == 2 * len(BLOCK.findall(text)), "a block that names no file"
        assert any(kind == "type" for kind, *_ in steps(text))


@pytest.mark.parametrize("name, picture", [("cube", "pictures/frame_0004.png"), ("model", "house/frame_0001.png"), ("sensor", "turned/frame_0034.png"), ("game", "played/frame_0055.png")])
def test_who_follows_the_page_gets_its_picture(name, picture, tmp_path):
    assert picture.rpartition("/")[2] in page(name) and picture.partition("/")[0] in page(name)
    follow(name, tmp_path)
    made = pixels(tmp_path / picture)
    assert (made == pixels(PAGES / f"{name}.png")).all() and len(numpy.unique(made.reshape(-1, 3), axis=0)) >= 4


def test_the_game_is_lost_without_the_step(tmp_path):
    follow_blocks("game", tmp_path)
    making.export(str(CHECKOUT / "examples/cube/cube.obj"), str(tmp_path / "game" / "cube_scene.h"))
    keys = tmp_path / "game" / "keys.c"
    keys.write_text(keys.read_text(encoding="utf-8").replace("frame < 10 ? FXL_KEY_LEFT : 0", "0"), encoding="utf-8")
    done = subprocess.run(["make", "run", f"PROGRAM={tmp_path / 'game'}", "BOARD=host", f"OUT={tmp_path / 'out'}"], cwd=CHECKOUT, env=environment(),
                          stdin=subprocess.DEVNULL, text=True, capture_output=True, check=False)
    assert done.returncode == 0 and len(list((tmp_path / "out").glob("frame_*.png"))) == 59, done.stdout + done.stderr


def follow_blocks(name, folder):
    """Writes a page's files alone."""
    for kind, *words in steps(page(name)):
        if kind == "write":
            (folder / words[0]).parent.mkdir(parents=True, exist_ok=True)
            (folder / words[0]).write_text(words[1], encoding="utf-8")


def test_the_board_prints_the_frames_of_the_host(tmp_path):
    """host_tests/boards/test_hello.py compares the numbers; here the page is followed to the emulator's command."""
    need("qemu-system-arm", "arm-none-eabi-gcc")
    follow("board", tmp_path)
    command, = [each for each in COMMAND.findall(page("board")) if each.startswith("qemu-system-arm")]
    process = subprocess.Popen(shlex.split(command.replace("my/", f"{tmp_path}/")), stdout=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True)
    try:
        said = [process.stdout.readline().strip() for _ in range(61)]
    finally:
        process.kill()
        process.communicate()
    assert all(re.fullmatch("[0-9a-f]{8}", line) for line in said) and len(set(said[:60])) == 60 and said[60] == said[0]


def test_the_display_shows_cube_and_text(tmp_path):
    """Against the doubles of the Pico SDK: what the program sends makes the picture on a model of the display."""
    need("node", "npm")
    follow("display", tmp_path)
    folder, declarations = tmp_path / "display", test_ports.TESTS / "pico_sdk"
    program = test_ports.built(tmp_path, "shown", folder, [folder / "main.c", folder / "fixel_pico.c", declarations / "double.c",
                                                           test_ports.TESTS / "diary.c"], [declarations, folder])
    said = subprocess.run([program], stdout=subprocess.PIPE, text=True, timeout=60, check=True).stdout
    assert not re.search("^fault", said, re.MULTILINE)
    module = test_ports.Module("st7789", (17, 20, 21))
    module.play([line.split(" ", 1) for line in said.splitlines()])
    frames = test_ports.expected(tmp_path, folder)
    assert len(module.pictures) == len(frames) == 3
    for picture, frame in zip(module.pictures, frames):
        assert (picture[16:] == frame[16:]).all(), "below the text it is the library's frame"
        assert (picture[:16] != frame[:16]).sum() > 100
    assert (colours(module.pictures[2]) == pixels(PAGES / "display.png")).all()


def colours(frame):
    """A frame of RGB565 as red, green and blue."""
    five, six = (frame >> 11 & 31, frame & 31), frame >> 5 & 63
    return numpy.stack([five[0] * 255 // 31, six * 255 // 63, five[1] * 255 // 31], axis=-1).astype(numpy.uint8)
