# SPDX-License-Identifier: MIT
"""Every module of fixel/display.h at every turn: a frame that fills its glass, and one that does not, come out of the model
of its controller (tools/fixel/board/controllers.py) as they were drawn."""

import re
import subprocess

import numpy
import pytest

from conftest import CHECKOUT
from fixel.board import controllers, wires
from test_displays import LIBRARY, SCREEN

BUILT_PROGRAMS = ()
HEADER = (CHECKOUT / "lib/include/fixel/display.h").read_text(encoding="utf-8")
NAMES = re.findall(r"fxl_display_module fxl_module_(\w+);", HEADER)
DRIVERS = re.findall(r"fxl_display_driver (fxl_\w+);\s*/\* (.*?) of (.*?), (.*?) \*/", HEADER)
MOCK = CHECKOUT / "host_tests/boards/displays"
PROGRAM = r"""
#include <stdlib.h>
#include <stdio.h>
#include <fixel/display.h>
#include "wires_mock.h"
extern const fxl_display_port wires;
bool wires_open(void);
static const fxl_display_module *const modules[] = {MODULES};
static uint8_t palette[768], frame[480][480];
static fxl_display display;
static fxl_pump pump;
static uint64_t memory[FXL_PUMP_MEMORY(480, 8, 24)];
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


# Prints what the record of each driver says: its glass, memory and pixels; then of each module: glass, memory, offset, whether blue comes first, inversion; then of each turn that it has access, first
# column and row, and the argument of D3.
RECORDS = r"""
#include <stdio.h>
#include <fixel/driver.h>
#include <fixel/display.h>
static const fxl_display_module *const modules[] = {MODULES};
static const fxl_display_driver *const drivers[] = {DRIVERS};
static const struct { const fxl_pixel_format *format; const char *words; } formats[] = {
    {&fxl_pixels_rgb565, "RGB565"}, {&fxl_pixels_rgb666, "three bytes a pixel"}, {&fxl_pixels_grey4, "16 greys"},
    {&fxl_pixels_mono_pages, "pages of one bit"}, {&fxl_pixels_mono_rows, "rows of one bit"}};
int main(void)
{
    for (size_t i = 0; i < sizeof drivers / sizeof drivers[0]; i++) {
        size_t n = 0;
        while (formats[n].format != drivers[i]->family->format) { n++; }
        printf("%u x %u|%u x %u|%s\n", drivers[i]->width, drivers[i]->height, drivers[i]->memory_columns, drivers[i]->memory_rows, formats[n].words);
    }
    for (size_t i = 0; i < sizeof modules / sizeof modules[0]; i++) {
        const fxl_display_module *of = modules[i];
        const int is_blue_first = of->driver->family == &fxl_display_ssd1351 ? !(of->access & 4)
                                  : of->driver->family == &fxl_display_ssd1331 ? (of->access & 4) != 0 : (of->access & 8) != 0;
        printf("%u x %u|%u x %u|%u, %u|%s|%s", of->width, of->height, of->columns, of->rows, of->left, of->top,
               of->driver->family->exchanges == 0 ? "" : is_blue_first ? "BGR" : "RGB", of->is_inverted ? "yes" : "no");
        for (uint32_t turns = 0; turns < 4; turns++) {
            const fxl_display_config config = fxl_display_config_turned(of, turns);
            if (config.driver != NULL) { printf("|%02X %u, %u %02X", config.access, config.left, config.top, config.display_offset); }
        }
        printf("\n");
    }
    return 0;
}
"""


def rows_of_page(second="module", first="`fxl_module_`"):
    """A table of docs/displays.md, by the names of its first two columns: its head, and its rows."""
    lines = (CHECKOUT / "docs/displays.md").read_text(encoding="utf-8").splitlines()
    head = next(at for at, line in enumerate(lines) if line.startswith(f"| {first} | {second} |"))
    rows = []
    for line in lines[head + 2:]:
        if not line.startswith("|"):
            break
        rows.append([cell.strip() for cell in line.strip("|").split("|")])
    return [cell.strip() for cell in lines[head].strip("|").split("|")], rows


def clocks_of_page():
    """The highest clock of each controller, by its name."""
    lines = (CHECKOUT / "docs/displays.md").read_text(encoding="utf-8").splitlines()
    head = next(at for at, line in enumerate(lines) if line.startswith("| controller | highest clock"))
    clocks = {}
    for line in lines[head + 2:]:
        if not line.startswith("|"):
            break
        controllers_named, clock, _ = (cell.strip() for cell in line.strip("|").split("|"))
        clocks.update({name: clock for name in controllers_named.split(", ")})
    return clocks


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


@pytest.fixture(scope="module", name="printed")
def fixture_printed(tmp_path_factory):
    """What RECORDS prints, a list of cells for each driver, and then for each module."""
    tmp_path = tmp_path_factory.mktemp("records")
    text = RECORDS.replace("MODULES", ", ".join(f"&fxl_module_{name}" for name in NAMES))
    (tmp_path / "records.c").write_text(text.replace("{DRIVERS}", "{" + ", ".join(f"&{name}" for name, *_ in DRIVERS) + "}"), encoding="utf-8")
    subprocess.run(["gcc", "-std=c11", "-Wall", "-Wextra", "-Werror", "-ffunction-sections", "-Wl,--gc-sections", f"-I{CHECKOUT / 'lib/include'}",
                    "records.c", *LIBRARY, "-o", "records"], cwd=tmp_path, check=True)
    said = subprocess.run(["./records"], cwd=tmp_path, text=True, capture_output=True, check=True).stdout
    return [line.split("|") for line in said.splitlines()]


@pytest.fixture(name="records")
def fixture_records(printed):
    """The cells of each module."""
    return printed[len(DRIVERS):]


def test_header_and_page_say_of_each_driver_what_its_record_says(printed):
    """make run DRIVER= reads the header's lines."""
    assert len(DRIVERS) == HEADER.count("\nextern const fxl_display_driver ") > 15
    assert [list(facts) for _, *facts in DRIVERS] == printed[:len(DRIVERS)]
    head, rows = rows_of_page(first="driver", second="glass")
    assert head == ["driver", "glass", "memory of the controller", "pixels that it sends"]
    assert [[row[0].strip("`"), *row[1:]] for row in rows] == [[name, *(fact.replace(" x ", " × ") for fact in facts)] for name, *facts in DRIVERS]


def test_the_page_says_of_each_module_what_its_record_says(records):
    head, rows = rows_of_page()
    assert head[2:7] == ["glass", "memory as wired", "offset", "colours", "inverted"]
    assert [row[0].strip("`") for row in rows] == NAMES
    assert [row[2:7] for row in rows] == [[cell.replace("x", "×") for cell in record[:5]] for record in records]


# The pixels of a model's FORMAT, or of its highest grey.
PIXELS_OF = {0x55: "16 bits", 0x66: "18 bits", 15: "4 bits", 1: "1 bit"}


def at_turns(cell, count):
    """The values of a cell, one a turn."""
    values = cell.split("; ")
    return values * count if len(values) == 1 else values


def told(show, name, turns):
    """The model of a module after a frame of the program."""
    width, height = wires.glass_of(name, turns)
    subprocess.run(["./show", str(NAMES.index(name)), str(turns), "0"], cwd=show, check=True, input=bytes(768 + width * height))
    model = controllers.start(name)
    with (show / "wires.bin").open("rb") as record:
        assert not list(wires.read(record, model))
    model.finish()
    return model


def test_each_module_is_told_the_facts_of_the_page(show, records):
    """The table of facts, each with its source, against the record at every turn and against what comes over the wires."""
    head, rows = rows_of_page("access")
    assert head[3:] == ["lines", "start", "offset", "COM pins", "pixels", "source"] and [row[0].strip("`") for row in rows] == NAMES
    for (name, access, place, lines, start, offset, com_pins, pixels, source), record in zip(rows, records):
        name, turned = name.strip("`"), record[5:]
        of = controllers.model(name)
        assert len(source) > 10 and len(turned) == len(of.TURNS)
        wanted = zip(at_turns(access, len(turned)), at_turns(place, len(turned)), at_turns(offset or "00", len(turned)))
        assert [" ".join(each) for each in wanted] == turned, name
        for at, turns in enumerate(of.TURNS):
            model, count = told(show, name, turns), len(turned)
            assert pixels == (PIXELS_OF[of.FORMAT] if of.HIGHEST is None else PIXELS_OF[of.HIGHEST]), name
            bits, moved = int(at_turns(access, count)[at], 16), int(at_turns(offset or "00", count)[at], 16)
            if isinstance(model, controllers.Windows):
                assert (model.bits, model.lines, model.start_line, model.offset) == (bits, int(lines), int(start), moved), name
            elif isinstance(model, controllers.Colour):
                assert model.format == of.FORMAT and model.access == bits and offset == com_pins == lines == start == "", name
            elif isinstance(model, controllers.Pages):
                assert bits == 8 * model.scan_mirrored + model.segments_mirrored and start == "0", name
                assert model.scanned_lines == int(lines) and model.settings.get(0xDC, 0) == 0 and model.settings.get(0xD3, 0) == moved, name
                assert com_pins == "" or model.settings[0xDA] == int(com_pins, 16), name
            else:
                assert (bits, lines, start) == (0, str(model.glass.height), "0"), name


def test_the_page_says_of_each_module_how_it_is_joined():
    head, rows = rows_of_page()
    assert head[7:] == ["SPI mode", "highest clock", "pins at turn 0", "tried on glass"]
    clocks = clocks_of_page()
    for name, *_, mode, clock, pins, tried in rows:
        assert clock == clocks[name.strip("`").split("_")[0].upper()]
        assert mode == ("0, or 3" if "st7789" in name else "0") and pins in ("above", "left", "below", "?") and tried == "no"
    assert "None was tried on glass" in HEADER.replace("\n * ", " "), "a module that was: say which in header and page"


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
    if turns not in controllers.model(name).TURNS:
        assert done.returncode == 2, "it cannot turn so"
        return
    assert done.returncode == 0, done.stderr.decode()
    model = controllers.start(name)
    with (show / "wires.bin").open("rb") as record:
        assert not list(wires.read(record, model)), "the mock notes no frames"
    assert (model.picture(turns) == wires.shown(name, frame, palette, turns)).all()
