# SPDX-License-Identifier: MIT
"""The board pico, where its tools are: the frames of scenes, a display's wires, the second boot stage, UF2 files, with and without
a debugger, ends of programs that went wild, and unit tests."""

import functools
import json
import re
import subprocess
import zlib

import own_tools
import pytest
from board_programs import ROOT, built, read_uf2
from conftest import run_cli, run_make
from fixel.board import benchmark, controllers, dump, emulator, firmware, crc as frame_crc, own_run, rp2040, wires
from fixel.scene import making

NEEDED = subprocess.run([ROOT / "tools/setup.sh", "--missing", "pico"], capture_output=True, text=True, check=True).stdout.split()
READY = not NEEDED and (rp2040.PACKAGE / "package.json").is_file()
here = pytest.mark.skipif(not READY, reason=f"needs {' '.join(NEEDED) or 'rp2040js: tools/setup.sh pico'}")
STAGE = 252     # bytes of the second boot stage, before its CRC


run = functools.partial(own_tools.run, "pico")


@here
@pytest.mark.parametrize("scene, words", own_tools.SCENES)
def test_scenes_are_equal_to_the_host(tmp_path, scene, words):
    assert own_tools.draw_scene("pico", tmp_path / "out", scene, words)["cpu"] == "cortex-m0plus"


@here
@pytest.mark.parametrize("words", own_tools.GAMES)
def test_the_game_is_equal_and_a_display_shows_it(tmp_path, words):
    own_tools.draw_game("pico", tmp_path / "out", words)


@here
@pytest.mark.parametrize("name", own_tools.EXPORTED)
def test_the_program_of_an_exported_scene_draws_the_frames_of_make_run(tmp_path, name):
    own_tools.draw_exported("pico", tmp_path, name)


@here
@pytest.mark.parametrize("name", [*own_tools.INSTRUMENTS, *own_tools.WHOLE])
def test_an_example_draws_the_hosts_frames(tmp_path, name):
    own_tools.draw_example("pico", tmp_path, name)


@here
def test_a_driver_of_pages_is_understood_from_the_wires(tmp_path):
    """Its commands have several bytes: the select line says where each ends."""
    _, summary = run(tmp_path / "out", "SCENE=scenes/tiny.toml", "SCREEN=128x64", "FRAMES=4", "DRIVER=ssd1306")
    assert summary["host_frames_equal"] and summary["wires_frames_equal"] == 4


@here
def test_cycles_are_shown_as_the_emulators(tmp_path):
    """Of two runs they are equal. They are no instructions, and are not called so."""
    counts = []
    for name in ("one", "two"):
        said, summary = run(tmp_path / name, "SCENE=scenes/tiny.toml", "FRAMES=4", "FRESH=1")
        assert "cycles a frame" in said and "as rp2040js counts" in said and "instructions a frame" not in said
        assert summary["instructions_per_frame"]["min"] is None and summary["cycles_per_frame"]["min"] > 0
        counts.append([frame.instructions for frame in dump.read_dump(tmp_path / name / "board.fxld").frames])
    assert counts[0] == counts[1]


@here
def test_the_showcase_says_cycles(tmp_path):
    done = run_make("showcase", "BOARD=pico", "ONLY=badge", f"OUT={tmp_path / 'out'}")
    assert done.returncode == 0, done.stdout + done.stderr
    row, = json.loads((tmp_path / "out" / "summary.json").read_text())["models"]
    assert row["instructions"] is None and row["cycles"] > 100_000 and "as rp2040js counts" in row["took"]
    assert row["took"] in (tmp_path / "out" / "index.html").read_text()


@here
@pytest.mark.parametrize("name", own_tools.UNITS)
def test_unit_tests_pass(name):
    own_tools.run_unit("pico", name)


@here
@pytest.mark.parametrize("text, code, sentence", [
    ("return *(volatile int *)0x60000000;", 46, "nothing at this address"),
    ("int got; __asm__ volatile(\"ldr %0, [%1]\" : \"=l\"(got) : \"l\"(0x20000001)); return got;", 42, "misaligned address"),
    ("__asm__ volatile(\".short 0xB600\");", 47, "an instruction that the core cannot execute"),
    ("((void (*)(void))0x30000001)();", 46, "nothing at this address"),
    ("for (;;) {}", 50, "the program hung"),
    ("__asm__ volatile(\"cpsid i\"); for (;;) {}", 50, "the program hung"),
    ("__asm__ volatile(\"bkpt #7\");", 47, "breakpoint 7")])
def test_a_program_that_went_wild_ends(tmp_path, text, code, sentence):
    (tmp_path / "failing.c").write_text(f"int main(void)\n{{\n#ifdef __arm__\n{text}\n#endif\nreturn 0;\n}}\n", encoding="utf-8")
    done = run_make("run", "BOARD=pico", f"PROGRAM={tmp_path / 'failing.c'}", f"OUT={tmp_path / 'out'}")
    assert done.returncode == 2 and f"Error {code}" in done.stderr and f"{sentence}" in done.stderr, done.stderr


def second_stage():
    """The first 256 bytes of the walk's flash."""
    program = firmware.load(built("pico/walk.elf"), "pico")
    (address, content), = [each for each in program.segments if each[0] == program.flash_base]
    assert address == 0x10000000
    return content[:STAGE + 4]


@here
def test_the_second_stage_has_the_crc_that_the_boot_rom_checks():
    stage = second_stage()
    crc = rp2040.boot_crc(stage[:STAGE])
    assert rp2040.boot_crc(b"123456789") == 0x0376E6E7, "the check value of CRC-32/MPEG-2"
    assert int.from_bytes(stage[STAGE:], "little") == crc, f"boards/pico/boot2.c: the CRC is now {crc:#010x}"


@here
def test_a_flash_without_a_second_stage_does_not_start(tmp_path):
    program = firmware.load(built("pico/walk.elf"), "pico")
    data = bytearray(rp2040.image_of(program))
    data[4] ^= 1
    (tmp_path / "flash.bin").write_bytes(data)
    ending = emulator.emulate_pico(program, tmp_path / "flash.bin", ["walk"], tmp_path, 60)
    assert ending.code == emulator.exit_code("BOARD") and "the boot ROM does not start it" in ending.output


@here
@pytest.mark.parametrize("command", ["screen", "view"])
def test_what_only_qemu_can_is_refused(command):
    done = run_make(command, "BOARD=pico", "SCENE=scenes/tiny.toml")
    assert done.returncode == 2 and "BOARD=pico is emulated by rp2040js" in done.stderr, done.stdout + done.stderr


@here
def test_flash_writes_uf2_blocks(tmp_path):
    """The blocks hold the program and the scene where the image has them, in whole sectors, and the picture is drawn from them."""
    image = tmp_path / "pico.bin"
    done = run_cli("flash", "--board", "pico", "--elf", built("pico/walk.elf"), "--scene", ROOT / "scenes/tiny.toml", "--scenes", tmp_path,
                   "--image", image)
    assert done.returncode == 0 and "blocks of UF2" in done.stdout, done.stdout + done.stderr
    program = firmware.load(built("pico/walk.elf"), "pico")
    pages = read_uf2(image.with_suffix(".uf2").read_bytes())
    flash = bytearray(b"\xff" * program.image_size)
    for address, page in pages.items():
        flash[address - 0x10000000:address - 0x10000000 + 256] = page
    assert bytes(flash) == image.read_bytes()
    assert len(pages) % 16 == 0 and {address % 4096 for address in pages} == set(range(0, 4096, 256)), "whole sectors of 4 KiB"
    (tmp_path / "again.bin").write_bytes(flash)
    emulator.run("pico", tmp_path / "again.bin", program.path, tmp_path / "dump.fxld", frames=2)
    assert len(dump.read_dump(tmp_path / "dump.fxld").frames) == 2


@here
def test_the_benchmark_draws_the_frames_of_the_host(tmp_path):
    """It has no semihosting: a real Pico runs it from the UF2 file."""
    elf = built("pico/benchmark.elf")
    lines = [match.groupdict() for match in benchmark.LINE.finditer(benchmark.run(elf, "pico"))]
    hosted = [match.groupdict() for match in benchmark.LINE.finditer(benchmark.run(built("host/benchmark"), "host"))]
    assert [(line["scene"], line["crc"]) for line in lines] == [(line["scene"], line["crc"]) for line in hosted]
    assert all(line["clock"] == "125000000" and int(line["microseconds"]) > 100 for line in lines)
    program = firmware.load(elf)
    pages = read_uf2((tmp_path / "b.uf2").read_bytes()) if benchmark.write_uf2(elf, tmp_path / "b.uf2") else {}
    assert rp2040.boot_crc(pages[0x10000000][:STAGE]) == int.from_bytes(pages[0x10000000][STAGE:], "little")
    assert len(pages) * 256 >= sum(len(content) for _, content in program.segments)


# --- make flash DRIVER=: without a debugger ---------------------------------------------

TEXTURED = ROOT / "host_tests/tools/models/plain_texture.glb"
# Its variables have values that are not 0, and it returns: when it is called anew, they must be what they were at first.
COUNTING = """
#include <fixel.h>
#include "cube_scene.h"
static fxl_renderer renderer;
static uint64_t memory[CUBE_MEMORY];
static uint8_t pixels[ROWS][WIDTH];
static uint32_t frame = 3, drawn;
int main(void)
{
    fxl_config config = fxl_config_default(WIDTH, HEIGHT);
    if (drawn != 0 || fxl_renderer_init(&renderer, &cube_scene, &config, memory, sizeof memory)) { return 1; }
    for (; drawn < 2; drawn++) {
        if (fxl_frame_begin(&renderer, &cube_path[frame++])) { return 2; }
        for (uint16_t row = 0; row < HEIGHT; row += ROWS) {
            const fxl_band band = {.pixels = pixels[0], .width = WIDTH, .stride = WIDTH, .first_row = row, .rows = ROWS};
            fxl_fill_band(&band, config.background);
            if (fxl_frame_draw(&renderer, &band)) { return 3; }
        }
    }
    return 0;
}
"""


def counting(folder, width, height):
    """COUNTING in a folder of its own, with its scene."""
    (folder / "own").mkdir()
    making.export(str(ROOT / "examples/cube/cube.obj"), str(folder / "own/cube_scene.h"), frames=8)
    (folder / "own/main.c").write_text(f"#define WIDTH {width}\n#define HEIGHT {height}\n#define ROWS 16\n{COUNTING}", encoding="utf-8")
    return f"PROGRAM={folder / 'own'}"


def flash_alone(folder, driver, *words):
    """make flash DRIVER=: what it said. Its UF2 file is then flash.bin in the folder, in a flash that has nothing else."""
    done = run_make("flash", "BOARD=pico", f"DRIVER={driver}", *words)
    assert done.returncode == 0, done.stdout + done.stderr
    flash = bytearray(b"\xff" * 2**21)
    for address, page in read_uf2((ROOT / re.search(r"copy (\S+\.uf2) to the drive", done.stdout)[1]).read_bytes()).items():
        flash[address - 0x10000000:address - 0x10000000 + 256] = page
    (folder / "flash.bin").write_bytes(flash)
    return done.stdout


def run_alone(folder, frames):
    """Runs flash.bin without a debugger, where a call to one is a fault: its ending. The wires of its display are recorded in the folder."""
    program = firmware.load(built("pico/walk.elf"), "pico")
    return emulator.emulate_pico(program, folder / "flash.bin", ["--alone", str(frames)], folder, 60)


def shown_alone(folder, driver, width, height, frames):
    """The CRCs of the pictures that a controller made of so many frames of flash.bin, and of the bytes of their pixels."""
    ending = run_alone(folder, frames)
    assert ending.code == emulator.exit_code("DONE"), ending.output
    assert ending.output == f"alone: {frames} frames, core 125000000 Hz, SPI 62500000 Hz\n"
    model, glass = controllers.MODULES[driver]
    size = model.frame_bytes(width, height, glass)
    with (folder / wires.NAME).open("rb") as file:
        found = list(wires.read(file, controllers.start(driver), wires.turns_of(driver, width, height)))
    return [crc(picture) for picture, _ in found], [f"{zlib.crc32(sent[-size:]):08x}" for _, sent in found]


def crc(picture):
    """The CRC of a picture of 16 bits a pixel."""
    return f"{zlib.crc32(frame_crc.pixel_bytes(picture.astype('<u2'))):08x}"


@here
@pytest.mark.parametrize("words", [[f"SCENE={TEXTURED}", "FRAMES=3"], ["PROGRAM=game", "FRAMES=3"], ["SCENE=scenes/spin.toml", "FRAMES=3"]])
def test_a_uf2_file_draws_without_a_debugger_what_make_run_draws(tmp_path, words):
    """Again and again, each time from the first frame on. The ILI9341 has the frames' size turned."""
    _, summary = run(tmp_path / "out", "DRIVER=ili9341", *words)
    flash_alone(tmp_path, "ili9341", *words)
    _, sent = shown_alone(tmp_path, "ili9341", 320, 240, 7)
    expected = summary["sent_crc"]
    assert len(set(expected)) == 3 and sent == [*expected, *expected, expected[0]]


@here
def test_a_program_of_ones_own_draws_its_textured_model_on_a_display_without_a_debugger(tmp_path):
    """By the program that export writes beside the scene: the frames of make run, with the scene and with the program."""
    (tmp_path / "own").mkdir()
    done = run_cli("export", "--c", "--board", "pico", "--frames", "3", TEXTURED, "-o", tmp_path / "own/model_scene.h", "--program", tmp_path / "own/main.c")
    assert done.returncode == 0, done.stderr
    _, drawn = run(tmp_path / "drawn", f"SCENE={TEXTURED}", "FRAMES=3", "DRIVER=st7789")
    _, own = run(tmp_path / "out", f"PROGRAM={tmp_path / 'own'}", "DRIVER=st7789")
    flash_alone(tmp_path, "st7789", f"PROGRAM={tmp_path / 'own'}")
    pictures, sent = shown_alone(tmp_path, "st7789", 320, 240, 5)
    expected = own["frame_crc"]
    assert own["wires_frames_equal"] == 3 and own["sent_crc"] == expected
    assert expected == drawn["frame_crc"] == drawn["sent_crc"] and len(set(expected)) == 3
    assert pictures == sent == [*expected, *expected[:2]]


@here
@pytest.mark.parametrize("driver, width, height", [("st7789", 320, 240), ("ssd1306", 128, 64)])
def test_a_program_of_ones_own_has_its_palette_and_begins_anew(tmp_path, driver, width, height):
    program = counting(tmp_path, width, height)
    _, summary = run(tmp_path / "out", program)
    flash_alone(tmp_path, driver, program)
    pictures, _ = shown_alone(tmp_path, driver, width, height, 5)
    palette = own_run.palette_of(ROOT / f"build/boards/pico/{summary['program']}.elf")
    frames = dump.read_dump(tmp_path / "out" / "board.fxld").frames
    one, other = [crc(wires.shown(driver, frame.pixels, palette, wires.turns_of(driver, width, height))) for frame in frames]
    assert pictures == [one, other, one, other, one] and one != other


@here
def test_a_program_whose_frames_the_display_has_no_room_for_says_so_on_the_serial_port(tmp_path):
    flash_alone(tmp_path, "ssd1306", counting(tmp_path, 320, 240))
    ending = run_alone(tmp_path, 1)
    assert ending.code != emulator.exit_code("DONE")
    assert "the display could not be opened: the frames may be larger" in ending.output and "\nexit 15\n" in ending.output


@here
def test_a_program_with_semihosting_is_a_fault_without_a_debugger(tmp_path):
    """The control of the tests above: what make flash writes without DRIVER=, which says so."""
    done = run_make("flash", "BOARD=pico", "SCENE=scenes/tiny.toml")
    assert done.returncode == 0 and "needs a debug probe" in done.stdout and "st7789" in done.stdout, done.stdout + done.stderr
    (tmp_path / "flash.bin").write_bytes((ROOT / "build/flash/pico.bin").read_bytes())
    ending = run_alone(tmp_path, 1)
    assert ending.code == emulator.exit_code("USAGE") and "a call to a debugger, and there is none" in ending.output


@here
def test_the_wires_that_are_printed_are_those_of_the_port(tmp_path):
    said = flash_alone(tmp_path, "ssd1306", "SCENE=scenes/tiny.toml", "SCREEN=128x64", "FRAMES=2")
    page = (ROOT / "ports/pico_sdk/README.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (CLK|DIN|CS|D/C|RESET)\b.* \| (\d+) \|$", page, re.MULTILINE)
    assert len(rows) == 5 and re.findall(r"^(\S+) +(\d+)$", said, re.MULTILINE) == rows
    assert "at 125 MHz" in said and "at 62.5 MHz" in said and "BOOTSEL" in said
