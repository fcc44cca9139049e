# SPDX-License-Identifier: MIT
"""Every module of fixel/modules.h at every turn: a frame that fills its glass, and one that does not, come out of the model
of its controller (tools/fixel/board/controllers.py) as they were drawn."""

import re
import subprocess

import numpy
import pytest

from conftest import CHECKOUT
from fixel.board import controllers, wires
from test_displays import LIBRARY, SCREEN

HEADER = (CHECKOUT / "lib/include/fixel/modules.h").read_text(encoding="utf-8")
NAMES = re.findall(r"fxl_display_module fxl_module_(\w+);", HEADER)
MOCK = CHECKOUT / "host_tests/boards/displays"
PROGRAM = r"""
#include <stdlib.h>
#include <stdio.h>
#include <fixel/modules.h>
#include "wires_mock.h"
extern const fxl_display_port wires;
bool wires_open(void);
static const fxl_display_module *const modules[] = {MODULES};
static uint8_t palette[768], frame[480][480];
static fxl_display display;
static fxl_pump pump;
static uint64_t memory[FXL_PUMP_MEMORY(480, 8, 16)];
int main(int argc, char **argv)
{
    const fxl_display_config config = fxl_display_config_turned(modules[atoi(argv[argc - 3])], (uint32_t)atoi(argv[argc - 2]));
    const uint16_t less = (uint16_t)atoi(argv[argc - 1]);
    const uint16_t width = (uint16_t)(config.width - less), height = (uint16_t)(config.height - less);
    const fxl_pump_config bands = {&display.pixels, width, height, 8, NULL};
    if (config.driver == NULL) { return 2; }
    if (fread(palette, 1, 768, stdin) != 768 || !wires_open() || fxl_display_open(&display, &config, &wires, palette) ||
        fxl_display_place(&display, width, height) ||
        fxl_pump_init(&pump, &bands, &display.sink, memory, sizeof memory)) { return 1; }
    for (uint16_t y = 0; y < height; y++) { if (fread(frame[y], 1, width, stdin) != width) { return 1; } }
    for (uint16_t y = 0; y < height; y = (uint16_t)(y + 8)) {
        const fxl_band band = {.pixels = frame[y], .width = width, .stride = 480, .first_row = y,
                               .rows = (uint16_t)(height - y < 8 ? height - y : 8)};
        if (fxl_pump_send_rows(&pump, &band)) { return 1; }
    }
    if (fxl_pump_wait(&pump)) { return 1; }
    wires_mock_end();
    return 0;
}
"""


@pytest.fixture(scope="module", name="show")
def fixture_show(tmp_path_factory):
    """The program: shows the frames of stdin on a module of the header, by its place there."""
    folder = tmp_path_factory.mktemp("modules")
    listed = ", ".join(f"&fxl_module_{name}" for name in NAMES)
    (folder / "show.c").write_text(PROGRAM.replace("MODULES", listed), encoding="utf-8")
    done = subprocess.run(["gcc", "-std=c11", "-O1", "-Wall", "-Wextra", "-Werror", "-fsanitize=address,undefined",
                           "-ffunction-sections", "-Wl,--gc-sections", f"-I{MOCK}", f"-I{CHECKOUT / 'lib/include'}", "show.c",
                           MOCK / "wires_mock.c", *LIBRARY, SCREEN / "pump.c", "-o", "show"], cwd=folder, text=True, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr
    return folder


def test_the_models_have_every_module():
    assert len(NAMES) > 15 and set(NAMES) <= set(controllers.MODULES)


@pytest.mark.parametrize("less", (0, 11))
@pytest.mark.parametrize("turns", range(4))
@pytest.mark.parametrize("name", NAMES)
def test_a_module_shows_frames_at_every_turn(show, name, turns, less):
    random = numpy.random.default_rng(turns)
    palette = random.integers(0, 256, (256, 3), dtype=numpy.uint8)
    width, height = wires.glass_of(name, turns)
    frame = random.integers(0, 256, (height - less, width - less), dtype=numpy.uint8)
    done = subprocess.run(["./show", str(NAMES.index(name)), str(turns), str(less)], cwd=show, check=False, capture_output=True,
                          input=palette.tobytes() + frame.tobytes())
    if controllers.is_mono(name) and turns % 2:
        assert done.returncode == 2, "pages turn by halves"
        return
    assert done.returncode == 0, done.stderr.decode()
    model = controllers.start(name)
    with (show / "wires.bin").open("rb") as record:
        assert not list(wires.read(record, model)), "the mock notes no frames"
    assert (model.picture(turns) == wires.shown(name, frame, palette, turns)).all()
