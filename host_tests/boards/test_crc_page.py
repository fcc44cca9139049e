# SPDX-License-Identifier: MIT
"""docs/crc.md is true to the letter: its programs are compiled and run, and its commands are executed."""

import re
import shlex
import subprocess
import zlib

import named_programs
import numpy
import pytest
from conftest import CHECKOUT, run_cli, run_make

from fixel.scene import making
from test_hello import WHOLE

BUILT_PROGRAMS = ("boards/host/walk", "host/judge", "host/raycast", "host/predict")
PAGE = (CHECKOUT / "docs" / "crc.md").read_text(encoding="utf-8")
BLOCKS = {re.search(r"\w+\.c\b", text).group(0): text for text in re.findall(r"```c\n(.*?)```", PAGE, re.DOTALL)}
COMMANDS = [line.strip() for line in re.sub(r"```.*?```", "", PAGE, flags=re.DOTALL).splitlines() if re.match(r" {4,6}\S", line)]
WARNINGS = ["-std=c11", "-O2", "-Wall", "-Wextra", "-Wshadow", "-Werror"]
HOST = CHECKOUT / "build" / "lib" / "host"
# A display of 320 x 240 in RGB565 whose wires write the pixels to stdout, and then the CRC of them.
WIRED = """
#include <stdio.h>
#include <fixel/all.h>
#include "cube_scene.h"
extern uint32_t sent;
fxl_display_port counted(void);
static bool is_frame;
static bool send(void *user, bool is_data, const uint8_t *bytes, size_t size)
{
    (void)user; (void)is_data; (void)bytes; (void)size;
    return true;
}
static bool start(void *user, const uint8_t *bytes, size_t size)
{
    (void)user;
    return !is_frame || fwrite(bytes, 1, size, stdout) == size;
}
static bool wait(void *user) { (void)user; return true; }
static void pause(void *user, uint32_t milliseconds) { (void)user; (void)milliseconds; }
const fxl_display_port wires = {NULL, send, start, wait, pause};
static fxl_renderer renderer;
static fxl_display display;
static fxl_pump pump;
static uint64_t memory[CUBE_MEMORY], bands[FXL_PUMP_MEMORY(320, 8, 16)];
int main(void)
{
    const fxl_display_port port = counted();
    const fxl_display_config config = fxl_display_config_default(&fxl_st7789, 1);
    fxl_config view = cube_config;
    view.target = &fxl_palette; /* a byte a pixel */
    if (fxl_renderer_init(&renderer, &cube_scene, &view, memory, sizeof memory) ||
        fxl_display_open(&display, &config, &port, cube_palette[0])) { return 1; }
    const fxl_pump_config rows = {&display.pixels, 320, 240, 8, NULL};
    if (fxl_pump_init(&pump, &rows, &display.sink, bands, sizeof bands)) { return 1; }
    is_frame = true;
    sent = FXL_CRC_START;
    if (fxl_pump_frame(&pump, &renderer, &cube_path[7]) || fxl_pump_wait(&pump)) { return 1; }
    printf("%08lx", (unsigned long)sent);
    return 0;
}
"""


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    """A folder with the page's files, the exported scene among them, and Fixel's folders."""
    folder = tmp_path_factory.mktemp("crc")
    for name, text in {**BLOCKS, "whole.c": WHOLE, "wired.c": WIRED}.items():
        (folder / name).write_text(text, encoding="utf-8")
    for name in ("build", "tools", "examples"):
        (folder / name).symlink_to(CHECKOUT / name)
    making.export(str(CHECKOUT / "examples/cube/cube.obj"), str(folder / "cube_scene.h"), frames=60)
    assert run_make("lib", "CORE=host").returncode == 0
    named_programs.add(HOST / "libfixel.a")
    return folder


def drawn(folder, *files):
    """What a program of these files writes."""
    done = subprocess.run(["gcc", *WARNINGS, f"-I{HOST / 'include'}", *files, HOST / "libfixel.a", "-o", "program"],
                          cwd=folder, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    return subprocess.run([folder / "program"], capture_output=True, check=True).stdout


def test_the_page_has_its_programs():
    assert set(BLOCKS) == {"check.c", "counted.c"} and PAGE.count("```") == 2 * len(BLOCKS)


def test_the_program_prints_the_crc_of_each_frame(page):
    frames = numpy.frombuffer(drawn(page, "whole.c"), numpy.uint8).reshape(60, 240 * 320)
    said = drawn(page, "check.c").decode().splitlines()
    assert said == [f"{number}: frame {zlib.crc32(frame.tobytes()):08x}" for number, frame in enumerate(frames)]
    assert len(set(line.split()[-1] for line in said)) == 60


def test_the_port_counts_what_is_sent(page):
    said = drawn(page, "wired.c", "counted.c")
    pixels, crc = said[:-8], said[-8:].decode()
    assert len(pixels) == 2 * 320 * 240 and crc == f"{zlib.crc32(pixels):08x}"


def test_the_commands_run_as_written(page):
    """make and fixel where Fixel is; the others where the reader's files are."""
    assert [command.split()[0] for command in COMMANDS] == \
        ["tools/scene.py", "make", "gcc", "./check", "./check", "make", ".venv/bin/fixel"]
    for command in COMMANDS[:-2]:
        if command.startswith("make "):
            done = run_make(*shlex.split(command)[1:])
        else:
            done = subprocess.run(command, shell=True, cwd=page, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stdout if "diff" in command else "") == (0, ""), (command, done.stderr)
    text = (page / "frames.txt").read_text()
    (page / "frames.txt").write_text(text.replace("7: frame ", "7: frame f", 1))
    assert subprocess.run(COMMANDS[4], shell=True, cwd=page, capture_output=True, check=False).returncode == 1, "another picture"


def test_the_tools_print_what_the_page_says(tmp_path):
    words = dict(word.split("=") for word in shlex.split(COMMANDS[-2])[2:])
    out = tmp_path / "run"
    done = run_cli("run", "--board", words["BOARD"], "--scene", words["SCENE"], "--frames", words["FRAMES"], "--out", out)
    assert done.returncode == 0, done.stdout + done.stderr
    crc = run_cli("crc", out / "board.fxld")
    assert crc.returncode == 0 and len(crc.stdout.splitlines()) == 3
    assert crc.stdout.splitlines()[-1].removeprefix("all: ") in done.stdout
