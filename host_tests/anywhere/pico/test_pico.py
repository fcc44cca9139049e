# SPDX-License-Identifier: MIT
"""The board pico, where its tools are: the frames of scenes, a display's wires, the second boot stage, UF2 files, ends of
programs that went wild, and unit tests."""

import functools
import json
import subprocess

import own_tools
import pytest
from board_programs import ROOT, built, read_uf2
from conftest import run_cli, run_make
from fixel.board import benchmarking, dump, emulator, firmware, rp2040

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
    lines = [match.groupdict() for match in benchmarking.LINE.finditer(benchmarking.run(elf, "pico"))]
    hosted = [match.groupdict() for match in benchmarking.LINE.finditer(benchmarking.run(built("host/benchmark"), "host"))]
    assert [(line["scene"], line["crc"]) for line in lines] == [(line["scene"], line["crc"]) for line in hosted]
    assert all(line["clock"] == "125000000" and int(line["microseconds"]) > 100 for line in lines)
    program = firmware.load(elf)
    pages = read_uf2((tmp_path / "b.uf2").read_bytes()) if benchmarking.write_uf2(elf, tmp_path / "b.uf2") else {}
    assert rp2040.boot_crc(pages[0x10000000][:STAGE]) == int.from_bytes(pages[0x10000000][STAGE:], "little")
    assert len(pages) * 256 >= sum(len(content) for _, content in program.segments)
