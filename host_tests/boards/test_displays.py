# SPDX-License-Identifier: MIT
"""docs/displays.md is true to the letter: its driver is compiled and shows frames, and what comes over
the wires is read back as the display would."""

import re
import subprocess

import numpy
import pytest

from conftest import CHECKOUT
from fixel.board import controllers, grey, wires
from fixel.board.wires import rgb565

BUILT_PROGRAMS = ()
PAGE = (CHECKOUT / "docs" / "displays.md").read_text(encoding="utf-8")
MOCK = CHECKOUT / "host_tests" / "boards" / "displays"
WARNINGS = ["-std=c11", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wpedantic", "-Werror"]
INCLUDES = [f"-I{CHECKOUT / 'boards'}", f"-I{CHECKOUT / 'lib' / 'include'}"]
SCREEN = CHECKOUT / "lib" / "screen"
LIBRARY = [file for file in sorted(SCREEN.glob("*.c")) if file.stem not in ("band_crc", "font_5x7", "overlay", "pump", "reasons_screen", "text")]
# A frame of an OLED by a pump; the messages go to stdout, each with its length before it.
OLED = """
#include <stdio.h>
#include <fixel/display.h>
extern const fxl_display_port wires;
bool i2c_write(uint8_t address, const uint8_t *bytes, size_t size);
void wait_for(uint32_t milliseconds);
static uint8_t palette[768], frame[64][128];
static fxl_display display;
static fxl_pump pump;
static uint64_t memory[FXL_PUMP_MEMORY(128, 8, 1)];
bool i2c_write(uint8_t address, const uint8_t *bytes, size_t size)
{
    return address == 0x3C && putchar((int)size) != EOF && fwrite(bytes, 1, size, stdout) == size;
}
void wait_for(uint32_t milliseconds) { (void)milliseconds; }
int main(void)
{
    const fxl_display_config config = fxl_display_config_default(&fxl_ssd1306, 0);
    const fxl_pump_config pages = {&display.pixels, 128, 64, 8, NULL};
    if (fread(palette, 1, 768, stdin) != 768 || fread(frame, 1, 128 * 64, stdin) != 128 * 64 ||
        fxl_display_open(&display, &config, &wires, palette) ||
        fxl_pump_init(&pump, &pages, &display.sink, memory, sizeof memory)) { return 1; }
    for (uint16_t y = 0; y < 64; y = (uint16_t)(y + 8)) {
        const fxl_band band = {.pixels = frame[y], .width = 128, .stride = 128, .first_row = y, .rows = 8};
        if (fxl_pump_send_rows(&pump, &band)) { return 1; }
    }
    return fxl_pump_wait(&pump) != FXL_OK;
}
"""
OWN = """
#include <fixel/display.h>
#include "wires_mock.h"
extern const fxl_display_port wires;
extern const fxl_display_driver hx8357;
bool wires_open(void);
static const uint8_t palette[768];
static fxl_display display;
int main(void)
{
    const fxl_display_config config = fxl_display_config_default(&hx8357, 1);
    if (!wires_open() || fxl_display_open(&display, &config, &wires, palette)) { return 1; }
    wires_mock_end();
    return 0;
}
"""
WINDOWS = """
#include <stdio.h>
#include <stdlib.h>
#include <fixel/display.h>
#include "wires_mock.h"
extern const fxl_display_port wires;
extern const fxl_display_driver ili9225;
bool wires_open(void);
static uint8_t palette[768], frame[200 * 200];
static fxl_display display;
static fxl_pump pump;
static uint64_t memory[FXL_PUMP_MEMORY(200, 8, 16)];
int main(int argc, char **argv)
{
    const fxl_display_module module = {.driver = &ili9225, .width = 160, .height = 200, .left = 5, .top = 9, .columns = 176, .rows = 220};
    const fxl_display_config config = fxl_display_config_turned(&module, (uint32_t)atoi(argv[argc - 1]));
    const fxl_pump_config bands = {&display.pixels, config.width, config.height, 8, NULL};
    if (fread(palette, 1, 768, stdin) != 768 || fread(frame, 1, 32000, stdin) != 32000 || !wires_open() ||
        fxl_display_open(&display, &config, &wires, palette) ||
        fxl_pump_init(&pump, &bands, &display.sink, memory, sizeof memory)) { return 1; }
    for (uint16_t y = 0; y < config.height; y = (uint16_t)(y + 8)) {
        const fxl_band band = {.pixels = frame + y * config.width, .width = config.width, .stride = config.width, .first_row = y, .rows = 8};
        if (fxl_pump_send_rows(&pump, &band)) { return 1; }
    }
    if (fxl_pump_wait(&pump)) { return 1; }
    wires_mock_end();
    return 0;
}
"""
# A program with one driver, whose glass its own record gives.
ONE_DRIVER = """
#include <fixel/display.h>
extern const fxl_display_port wires;
static const uint8_t palette[768];
static fxl_display display;
int show(void);
int show(void)
{
    const fxl_display_config config = fxl_display_config_default(&fxl_st7789, 1);
    return fxl_display_open(&display, &config, &wires, palette) || fxl_display_place(&display, 100, 100);
}
"""
# The panel draws no frame itself, so what the pump calls to draw one is not linked.
LINK = ["-ffunction-sections", "-Wl,--gc-sections"]
SHOW = ["tft_panel.c", "board.c", MOCK / "wires_mock.c", MOCK / "show.c", CHECKOUT / "boards" / "parts" / "display.c",
        *LIBRARY, *LINK]
WIDTH, HEIGHT = 320, 240


def write_sources(folder):
    """The page's pieces of code as files."""
    i2c, own, windows, driver, board = re.findall(r"```c\n(.*?)```", PAGE, re.DOTALL)
    assert "tft_panel" in driver and "board_panels" in board
    assert "i2c_write" in i2c and "fxl_display_driver hx8357" in own and "fxl_display_driver ili9225" in windows
    (folder / "own_driver.c").write_text(own, encoding="utf-8")
    (folder / "own_windows.c").write_text(windows, encoding="utf-8")
    (folder / "i2c_wires.c").write_text(i2c, encoding="utf-8")
    (folder / "tft_panel.c").write_text(driver, encoding="utf-8")
    # The dump has a file of its own to go to, which is not this test's.
    (folder / "board.c").write_text(board.replace("&dump_panel, ", ""), encoding="utf-8")


def compile_all(compiler, folder, *options):
    """Compiles without a word of warning."""
    done = subprocess.run([*compiler, *WARNINGS, f"-I{folder}", f"-I{MOCK}", *INCLUDES, *options], cwd=folder,
                          text=True, capture_output=True, check=False)
    assert done.returncode == 0 and not done.stderr, done.stderr


@pytest.fixture(scope="module", params=("late", "early", "ili9341"), name="show")
def fixture_show(request, tmp_path_factory):
    """The program, for DMA that reads late or early, and for the other controller."""
    folder = tmp_path_factory.mktemp(request.param)
    write_sources(folder)
    compile_all(["gcc", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover"], folder,
                f"-DLATE={int(request.param != 'early')}",
                *(["-DDRIVER=fxl_ili9341"] if request.param == "ili9341" else []), *SHOW, SCREEN / "pump.c", "-o", "show")

    def run(palette, frames, rows):
        height, width = frames[0].shape
        done = subprocess.run(["./show", str(width), str(height), str(rows), str(8 * frames[0].itemsize)], cwd=folder, capture_output=True,
                              input=palette.tobytes() + b"".join(frame.tobytes() for frame in frames), check=False)
        return done, folder / "wires.bin", request.param == "ili9341"

    return run


def read_wires(file, driver="st7789"):
    """The display after all that came."""
    display = controllers.start(driver)
    with open(file, "rb") as record:
        assert not list(wires.read(record, display)), "the mock notes no frames"
    return display


def random_frames(width, height):
    generator = numpy.random.default_rng(width)
    return (generator.integers(0, 256, (256, 3), dtype=numpy.uint8),
            [generator.integers(0, 256, (height, width), dtype=numpy.uint8) for _ in range(2)])


@pytest.mark.parametrize("width, height, rows", [(320, 240, 240), (320, 240, 7), (128, 64, 1), (319, 239, 100),
                                                 (1, 1, 1)])
def test_the_display_shows_the_last_frame(show, width, height, rows):
    palette, frames = random_frames(width, height)
    done, record, is_ili9341 = show(palette, frames, rows)
    assert done.returncode == 0, done.stderr.decode()
    display = read_wires(record, "ili9341" if is_ili9341 else "st7789")
    left, top = (WIDTH - width) // 2, (HEIGHT - height) // 2
    expected = numpy.zeros((HEIGHT, WIDTH), numpy.uint16)
    expected[top:top + height, left:left + width] = rgb565(palette)[frames[1]]
    assert (display.picture(1) == expected).all()
    assert display.on
    assert (display.access, display.inverted) == ((0x28, False) if is_ili9341 else (0x60, True))


@pytest.mark.parametrize("width, height, rows", [(320, 240, 7), (319, 239, 100), (1, 1, 1)])
def test_the_display_shows_a_frame_of_rgb565_with_its_bytes_in_order(show, width, height, rows):
    palette, frames = random_frames(width, height)
    generator = numpy.random.default_rng(height)
    frames = [generator.integers(0, 1 << 16, frame.shape, dtype=numpy.uint16) for frame in frames]
    done, record, is_ili9341 = show(palette, frames, rows)
    assert done.returncode == 0, done.stderr.decode()
    shown = read_wires(record, "ili9341" if is_ili9341 else "st7789").picture(1)
    left, top = (WIDTH - width) // 2, (HEIGHT - height) // 2
    assert (shown[top:top + height, left:left + width] == frames[1]).all()


def test_a_frame_that_is_too_large_is_not_for_it(show):
    palette, frames = random_frames(321, 10)
    done, _, _ = show(palette, frames, 10)
    assert done.returncode == 1     # it is the board's only panel: nobody can show that


def test_the_driver_compiles_for_a_microcontroller(tmp_path):
    write_sources(tmp_path)
    compile_all(["arm-none-eabi-gcc", "-mcpu=cortex-m0", "-mthumb", "-ffreestanding", "-O2"], tmp_path,
                "-c", "tft_panel.c", "-o", "tft_panel.o")


def test_a_driver_outside_the_library_drives_a_display(tmp_path):
    """docs/displays.md, "A driver of your own": a list of commands, and the commands of MIPI for all else."""
    write_sources(tmp_path)
    (tmp_path / "main.c").write_text(OWN, encoding="utf-8")
    compile_all(["gcc", "-g", "-fsanitize=address,undefined"], tmp_path, "main.c", "own_driver.c", MOCK / "wires_mock.c",
                *LIBRARY, SCREEN / "pump.c", *LINK, "-o", "own")
    subprocess.run(["./own"], cwd=tmp_path, check=True)
    with open(tmp_path / "wires.bin", "rb") as record:
        sent = [(kind, data) for kind, data in wires.records(record)]
    at = sent.index((b"C", b"\xB9"))
    assert sent[at + 1] == (b"D", b"\xFF\x83\x57")
    assert sent.index((b"C", b"\x11")) < at < sent.index((b"C", b"\x36")) and sent[sent.index((b"C", b"\x36")) + 1] == (b"D", b"\xA0")
    assert (b"D", b"\x00\x00\x00\x1B") in sent and sent[-1] == (b"C", b"\x29")


class Ili9225:
    """Its registers and memory, after its data sheet: an index, then two bytes."""

    def __init__(self):
        self.registers, self.number, self.memory = {}, None, numpy.full((220, 176), controllers.UNWRITTEN, numpy.uint16)

    def take_command(self, data):
        self.number, = data

    def take_data(self, data):
        if self.number != 0x22:
            assert len(data) == 2
            self.registers[self.number] = int.from_bytes(data, "big")
            return
        value = self.registers
        column, row = value[0x20], value[0x21]
        across, down = (1 if value[0x03] & 0x10 else -1), (1 if value[0x03] & 0x20 else -1)
        columns, rows = range(value[0x37], value[0x36] + 1), range(value[0x39], value[0x38] + 1)
        assert len(data) == 2 * len(columns) * len(rows)
        for pixel in numpy.frombuffer(data, ">u2"):
            assert column in columns and row in rows
            self.memory[row, column] = pixel
            if value[0x03] & 0x08:      # rows first
                row += down
                if row not in rows:
                    row, column = (rows[0] if down > 0 else rows[-1]), column + across
            else:
                column += across
                if column not in columns:
                    column, row = (columns[0] if across > 0 else columns[-1]), row + down


@pytest.mark.parametrize("turns", range(4))
def test_a_family_outside_the_library_shows_frames_at_every_turn(tmp_path, turns):
    """The same: a controller of registers, whose windows are those of its memory. A glass of 160 x 200 in one corner of it."""
    write_sources(tmp_path)
    (tmp_path / "main.c").write_text(WINDOWS, encoding="utf-8")
    compile_all(["gcc", "-g", "-fsanitize=address,undefined"], tmp_path, "main.c", "own_windows.c", MOCK / "wires_mock.c",
                *LIBRARY, SCREEN / "pump.c", *LINK, "-o", "own")
    width, height = (200, 160) if turns % 2 else (160, 200)
    palette, (frame, _) = random_frames(width, height)
    subprocess.run(["./own", str(turns)], cwd=tmp_path, check=True, input=palette.tobytes() + frame.tobytes())
    model = Ili9225()
    with open(tmp_path / "wires.bin", "rb") as record:
        for kind, data in wires.records(record):
            if kind == b"C":
                model.take_command(data)
            elif kind == b"D":
                model.take_data(data)
    assert model.registers[0x07] == 0x1017 and model.registers[0x11] == 0x103B
    glass = model.memory[9:209, 5:165]
    assert (numpy.rot90(glass, turns) == rgb565(palette)[frame]).all()
    assert (model.memory != controllers.UNWRITTEN).sum() <= 160 * 200 and (model.memory[:9] == controllers.UNWRITTEN).all()


def test_a_pump_with_one_buffer_is_caught(tmp_path):
    """The mock sees what the contract forbids: DMA reads what is filled anew."""
    write_sources(tmp_path)
    whole = (SCREEN / "pump.c").read_text(encoding="utf-8")
    broken = whole.replace("pump->free_buffer ^= 1u;", "")
    assert broken != whole
    (tmp_path / "pump.c").write_text(broken, encoding="utf-8")
    compile_all(["gcc"], tmp_path, *SHOW, f"-I{SCREEN}", "pump.c", "-o", "show")
    palette, frames = random_frames(320, 240)
    subprocess.run(["./show", "320", "240", "16", "8"], cwd=tmp_path, check=True,
                   input=palette.tobytes() + b"".join(frame.tobytes() for frame in frames))
    assert (read_wires(tmp_path / "wires.bin").picture(1) != rgb565(palette)[frames[1]]).any()


def read_messages(data):
    """(64 x 128 pixels, whether it is on) of an SSD1306 after these messages."""
    display = controllers.start("ssd1306")
    while data:
        size, data = data[0], data[1:]
        message, data = data[:size], data[size:]
        assert message[0] in (0x00, 0x40)
        (display.take_data if message[0] == 0x40 else display.take_command)(message[1:])
    return display.picture(), display.on


def build_oled(folder):
    """The program that shows a frame of 128 x 64 on an OLED."""
    write_sources(folder)
    (folder / "oled.c").write_text(OLED, encoding="utf-8")
    compile_all(["gcc", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover"], folder, "oled.c",
                "i2c_wires.c", *LIBRARY, *LINK, SCREEN / "pump.c", "-o", "oled")
    return folder / "oled"


def test_an_oled_on_i2c_shows_a_frame(tmp_path):
    oled = build_oled(tmp_path)
    palette, (frame, _) = random_frames(128, 64)
    done = subprocess.run([oled], cwd=tmp_path, capture_output=True, input=palette.tobytes() + frame.tobytes(),
                          check=True)
    shown, on = read_messages(done.stdout)
    assert on and (shown == grey.levels(frame, palette, 1)).all()


def test_a_program_with_one_driver_links_nothing_of_modules(tmp_path):
    """Of a Cortex-M3 at -O2: 564 bytes of RAM, and flash for no module, no pages and no other controller."""
    (tmp_path / "one.c").write_text(ONE_DRIVER, encoding="utf-8")
    compile_all(["arm-none-eabi-gcc", "-mcpu=cortex-m3", "-mthumb", "-ffreestanding", "-O2"], tmp_path, "one.c", *LIBRARY, *LINK,
                "-fdata-sections", "-nostdlib", "-Wl,--entry=show", "-Wl,--defsym=wires=0", "-Wl,--defsym=memset=0",
                "-Wl,--defsym=memcpy=0", "-Wl,--defsym=fxl_row_to_16=0", "-lgcc", "-o", "one.elf")
    listed = subprocess.run(["arm-none-eabi-nm", "--print-size", "one.elf"], cwd=tmp_path, text=True, capture_output=True,
                            check=True).stdout
    sizes = {name: int(size, 16) for size, name in re.findall(r"^\w+ (\w+) \w (\w+)$", listed, re.MULTILINE)}
    assert sizes["display"] == 564
    assert not [name for name in sizes if re.search("turned|module|pages|mono|ssd1", name)]
    ours = [name for name in sizes if name.startswith("fxl_display_")]
    assert 600 < sum(sizes[name] for name in ours) < 900, "812 with gcc 12; 1,192 with fxl_display_config_turned"
