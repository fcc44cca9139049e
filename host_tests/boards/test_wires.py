# SPDX-License-Identifier: MIT
"""Frames through a driver of the library (make run DRIVER=): recorded at the wires, and read back by a controller."""

import argparse
import io
import json
import struct
import zlib

import numpy
import pytest
import own_tools
from board_programs import made
from conftest import assert_one_sentence, dump_bytes, random_frames, run_cli, run_make

from fixel.board import controllers, dump, flash, wires
from fixel.base.errors import ToolError

BUILT_PROGRAMS = ("boards/*/walk-on-*", "host/judge", "host/raycast")


def run_driver(out, driver, screen, board="host", frames=6, more=(), **changes):
    """make run of a few frames of scenes/tiny.toml."""
    for each in {board, "host"}:
        made(f"build/boards/{each}/walk-on-{driver}{'' if each == 'host' else '.elf'}", f"BOARD={board}", f"DRIVER={driver}")
    return run_cli("run", "--board", board, "--scene", "scenes/tiny.toml", "--screen", screen, "--frames", frames,
                   "--driver", driver, "--out", out, *more, **changes)


# Shapes beside the glass of each driver: turned, smaller, modules.
SHAPES = [("st7789", "320x240"), ("st7789", "240x240"), ("ili9341", "101x37"), ("st7735", "160x128"), ("ssd1306", "128x32"), ("sh1106", "77x41"),
          ("st7789_135x240", "240x135"), ("st7735_128x160_green", "128x160"), ("st7796", "480x320"), ("ili9488", "480x320"), ("ssd1351_128x96", "128x96"),
          ("ssd1351_128x96", "96x128"), ("ssd1309_128x64_column_2", "128x64"), ("ssd1306_64x48", "64x48"), ("sh1107_64x128", "64x128"),
          ("sh1106_72x40", "61x31")]


def glasses():
    """Each driver with the glass of its model."""
    return [(name, f"{glass.width}x{glass.height}") for name, (_, glass) in controllers.MODULES.items() if "_" not in name]


@pytest.mark.parametrize("driver, screen", [*glasses(), *SHAPES])
def test_every_driver_shows_frames_of_every_shape(tmp_path, driver, screen):
    done = run_driver(tmp_path / "out", driver, screen)
    assert done.returncode == 0, done.stdout + done.stderr
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert summary["driver"] == driver and summary["wires_frames_equal"] == 6
    assert len(set(summary["wires_frame_sha256"])) > 1, "the eye moves"
    assert f"CRC of all frames" in done.stdout and summary["frame_crc_all"] in done.stdout and summary["sent_crc_all"] in done.stdout
    assert len(summary["frame_crc"]) == len(summary["sent_crc"]) == 6
    assert f"from the wires of an {driver}" in done.stdout and "6 of 6 frames as they were drawn" in done.stdout


def test_an_rgb565_frame_is_sent_as_it_was_drawn(tmp_path):
    """Its bytes are the display's, so both CRCs are one number; of a palette they are not."""
    crcs = {}
    for pixels in ("rgb565", "palette"):
        done = run_driver(tmp_path / pixels, "st7789", "240x135", more=["--pixels", pixels])
        assert done.returncode == 0, done.stdout + done.stderr
        crcs[pixels] = json.loads((tmp_path / pixels / "summary.json").read_text())
    assert crcs["rgb565"]["frame_crc"] == crcs["rgb565"]["sent_crc"] and len(set(crcs["rgb565"]["frame_crc"])) > 1
    assert crcs["palette"]["frame_crc"] != crcs["palette"]["sent_crc"]
    frames = dump.read_dump(tmp_path / "rgb565" / "board.fxld").frames
    assert crcs["rgb565"]["frame_crc_all"] == f"{zlib.crc32(b''.join(frame.pixels.astype('>u2').tobytes() for frame in frames)):08x}"


STILL = """
[screen]
width = 128
height = 64
[[objects]]
solid = "box"
position = [3, 0, 9]
spin = { yaw = 6 }
[path]
keys = [{ position = [0, 0, 0], look_at = [0, 0, 6], frames = 4 }, { position = [0, 0, 0], look_at = [0, 0, 6] }]
"""


@pytest.mark.parametrize("driver", ["ssd1306", "ls013b7dh03"])
def test_what_boxes_would_save_is_told_in_what_the_display_takes(tmp_path, driver):
    """Pages of eight rows, and whole rows."""
    (tmp_path / "still.toml").write_text(STILL, encoding="utf-8")
    made("build/host/predict")
    said, summary = own_tools.run("host", tmp_path / "out", f"SCENE={tmp_path / 'still.toml'}", "ALLOW_OUTSIDE=1", f"DRIVER={driver}")
    whole = {"ssd1306": 1024, "ls013b7dh03": 20 * 64}[driver]
    assert summary["display_bytes"] == whole and 0 < summary["display_bytes_by_boxes"] < whole / 2
    assert f"{whole:,} to a display; boxes of what changed would take" in said and " % saved" in said


def test_a_board_of_16_kib_sends_row_by_row(tmp_path):
    done = run_driver(tmp_path / "out", "st7789", "320x240", "microbit", 3)
    assert done.returncode == 0, done.stdout + done.stderr
    assert json.loads((tmp_path / "out" / "summary.json").read_text())["wires_frames_equal"] == 3


# place board: with little memory: the boards of little flash that have room for a driver
@pytest.mark.parametrize("board, driver", [("lm3s6965evb", "ili9341"), ("microbit", "ili9341"), ("netduino2", "ili9341"),
                                           ("netduinoplus2", "ili9341"), ("lm3s6965evb", "ili9488"), ("netduino2", "ili9488"),
                                           ("lm3s6965evb", "st7796")])
def test_boards_of_little_memory_have_room_for_a_driver(board, driver):
    made(f"build/boards/{board}/walk-on-{driver}.elf", f"BOARD={board}", f"DRIVER={driver}")


def test_frames_that_are_larger_than_the_glass_are_refused_before_anything_is_drawn(tmp_path):
    done = run_driver(tmp_path / "out", "ssd1306", "129x64")
    assert_one_sentence(done, "frames of 129x64 do not fit the 128x64 of DRIVER=ssd1306", "SCREEN=128x64")
    assert not (tmp_path / "out" / "summary.json").exists()


def test_what_make_refuses():
    for settings, sentence in ((["run", "DRIVER=hd44780"], 'there is no DRIVER "hd44780"; the drivers are: gc9107'),
                               (["run", "DRIVER=ssd1306", "ROWS=12"], "ROWS=12 must be a multiple of 8"),
                               (["run", "DRIVER=ssd1306", "BOARD=stm32vldiscovery"],
                                "DRIVER=ssd1306 needs more memory than BOARD=stm32vldiscovery has"),
                               (["run", "DRIVER=st7796", "BOARD=microbit"], "DRIVER=st7796 needs more memory than BOARD=microbit has"),
                               (["view", "DRIVER=ssd1306"], "DRIVER= is no variable of make view")):
        done = run_make(*settings)
        assert done.returncode == 2 and sentence in done.stderr, done.stderr


# --- what reads a record -----------------------------------------------------------


def record(*parts):
    """The bytes of (kind, bytes) parts."""
    return b"".join(kind + struct.pack("<I", len(data)) + data for kind, data in parts)


def command(code, *data):
    return [(b"C", bytes([code])), *([(b"D", bytes(data))] if data else [])]


def pause(milliseconds):
    return [(b"P", struct.pack("<I", milliseconds))]


AWAKE = [*command(0x01), *pause(150), *command(0x11), *pause(120), *command(0x3A, 0x55), *command(0x36, 0x28)]
DOT = [*command(0x2A, 0, 5, 0, 5), *command(0x2B, 0, 7, 0, 7), *command(0x2C, 0xF8, 0x00)]  # column 5, row 7
END = (b"F", struct.pack("<I", 0))


def read(data, name="ili9341", turns=1):
    return [picture for picture, _ in wires.read(io.BytesIO(data), controllers.start(name), turns)]


def test_a_record_becomes_a_picture():
    shown, = read(record(*AWAKE, *command(0x29), *DOT, END))
    assert shown.shape == (240, 320) and shown[7, 5] == 0xF800
    assert (shown != controllers.UNWRITTEN).sum() == 1


@pytest.mark.parametrize("data, sentence", [
    (record(*AWAKE, *DOT, END), "never turned on"),
    (record(*AWAKE, *command(0x29), END)[:-1], "cut off"),
    (record(*AWAKE, *command(0x29), END)[:-8], "cut off"),
    (record(*command(0x01), *command(0x11), END), "woken too early"),
    (record(*command(0x01), *pause(150), *command(0x11), *command(0x29), END), "turned on too early"),
    (record(*AWAKE, *command(0x2A, 0, 5, 1, 64), END), "beyond its memory"),
    (record(*AWAKE, *command(0x2A, 0, 5), END), "four bytes an axis"),
    (record(*AWAKE, *command(0x2A, 0, 5, 0, 6, 0, 7), END), "four bytes an axis"),
    (record(*AWAKE, *command(0x2B, 0, 5, 0, 240), END), "beyond its memory"),
    (record(*AWAKE, *command(0x2A, 0, 5, 0, 6), *command(0x2B, 0, 7, 0, 7), *command(0x2C, 1, 2), END), "whole and once"),
    (record(*AWAKE, *command(0x3A, 0x66), *DOT, END), "16 bits"),
    (record(*AWAKE, *command(0x3A), END), "0 bytes of data"),
    (record(*AWAKE, *command(0x77), END), "no command 0x77"),
    (record((b"C", b"\x01\x11"), END), "2 bytes come as one command"),
    (record((b"D", b"\x01"), END), "without a command"),
    (record((b"X", b"\x01"), END), "unknown part"),
    (record(*AWAKE, *command(0x29), (b"F", struct.pack("<I", 1))), "comes another than 0"),
])
def test_wires_that_break_a_rule_are_told(data, sentence):
    with pytest.raises(ToolError, match=sentence):
        read(data)


@pytest.mark.parametrize("data, sentence", [
    (record((b"C", b"\xAE"), END), "never turned on"),
    (record((b"C", b"\xAF\x81"), END), "lacks its argument"),
    (record((b"C", b"\xAF\x99"), END), "no command 0x99"),
    (record((b"C", b"\xAF\xB8"), END), "no command 0xb8"),
    (record((b"C", b"\xAF\x1F"), (b"D", b"\1"), END), "behind the last column"),
    (record((b"C", b"\xAF"), (b"D", b"\1"), (b"C", b"\xAE"), END), "never turned on"),
    (record((b"C", b"\xAF\xB0\x0F\x17"), (b"D", b"\1\2"), END), "behind the last column"),
])
def test_pages_that_break_a_rule_are_told(data, sentence):
    with pytest.raises(ToolError, match=sentence):
        read(data, "ssd1306", 0)


# What each model of a data sheet refuses: whole messages (C commands, D data), and the sentence.
LEVELS = bytes(64 * 128)
OF_1327 = b"\xAF\x15\x00\x3F\x75\x00\x7F"


@pytest.mark.parametrize("name, data, sentence", [
    ("ssd1327", record((b"C", b"\xA0\x51\xAF\x15\x00\x40\x75\x00\x7F"), END), "beyond its memory"),
    ("ssd1327", record((b"C", b"\xA0\x51\xAF\x15\x00"), END), "lacks an argument"),
    ("ssd1327", record((b"C", b"\xA0\x51" + OF_1327), (b"D", LEVELS[1:]), END), "whole and once"),
    ("ssd1327", record((b"C", b"\xA0\x11"), END), "on two sides"),
    ("ssd1327", record((b"C", b"\xA0\x51\xA6" + OF_1327), (b"D", LEVELS), END), "shows no memory"),
    ("ssd1327_96x96", record((b"C", b"\xA0\x51\xA8\x5F\xA2\x00\xAF"), END), "not scanned"),
    ("ssd1322", record((b"C", b"\xA0"), (b"D", b"\x14"), END), "has 1 bytes of data"),
    ("ssd1322", record((b"C", b"\xA0"), (b"D", b"\x14\x01"), END), "scanned from both sides"),
    ("ssd1331", record((b"C", b"\xA0\x72\xAF"), END), "supply"),
    ("ssd1331", record((b"C", b"\x5C"), END), "no command 0x5c"),
    ("gc9107", record(*command(0xB0, 0xC0), END), "locked"),
    ("gc9107", record(*AWAKE, *command(0x29), END), "voltages were not set"),
    ("st7565", record((b"C", b"\xAF"), END), "voltages are off"),
    ("st7565", record((b"C", b"\x2F\xAF\xD3\x00"), END), "no command 0xd3"),
    ("st7565", record((b"C", b"\x2F\xAF\xE2\xAF"), END), "voltages are off"),
    ("pcd8544", record((b"C", b"\x20\x0C"), END), "voltages are not those"),
    ("pcd8544", record((b"C", b"\x21\xC0\x13\x24\x0C"), END), "never turned on"),
    ("pcd8544", record((b"C", b"\x21\xC0\x13\x20\x08"), END), "shows no memory"),
    ("pcd8544", record((b"C", b"\x20\xD4"), END), "column is beyond"),
    ("pcd8544", record((b"C", b"\x20\x46"), END), "page is beyond"),
    ("pcd8544", record((b"C", b"\x22"), (b"D", b"\x01"), END), "along rows"),
    ("ls013b7dh03", record((b"C", b"\x80"), END), "no line for commands"),
    ("ls013b7dh03", record((b"D", bytes([0x80, 0x80, *bytes(17)])), END), "whole rows"),
    ("ls013b7dh03", record((b"D", bytes([0x80, 0x81, *bytes(18)])), END), "no row 129"),
    ("ls013b7dh03", record((b"D", bytes([0x80, 0x80, *bytes(18)])), END), "polarity did not change"),
])
def test_what_the_model_of_each_data_sheet_refuses(name, data, sentence):
    with pytest.raises(ToolError, match=sentence):
        read(data, name, 0)


def test_halves_of_a_byte_are_two_greys():
    """By the data sheet of an SSD1327: with 51 in A0 the upper half is on the left of a glass that stands on its head, with 42 too."""
    for access, place in ((0x51, (2, 6)), (0x42, (125, 120))):
        blank = [(b"C", bytes([0xA0, access]) + OF_1327), (b"D", LEVELS)]
        shown, = read(record(*blank, (b"C", b"\x15\x03\x03\x75\x02\x02"), (b"D", b"\x5C"), END), "ssd1327", 0)
        row, column = place
        assert sorted(shown[shown > 0].tolist()) == [5, 12]
        assert shown[row, column:column + 2].tolist() == ([5, 12] if access == 0x51 else [12, 5])


def test_four_greys_are_an_address_of_an_ssd1322():
    start = [*command(0xA0, 0x14, 0x11), *command(0xCA, 63), *command(0xAF), *command(0x15, 28, 91), *command(0x75, 0, 63), *command(0x5C)]
    start[-1:] = [(b"C", b"\x5C"), (b"D", bytes(64 * 128))]
    for access, place in ((0x14, (2, 4)), (0x06, (61, 248))):
        dot = [*command(0xA0, access, 0x11), *command(0x15, 29, 29), *command(0x75, 2, 2), *command(0x5C, 0x12, 0x34)]
        shown, = read(record(*start, *dot, END), "ssd1322", 0)
        row, column = place
        assert shown[row, column:column + 4].tolist() == ([1, 2, 3, 4] if access == 0x14 else [4, 3, 2, 1])


def test_a_row_of_a_memory_lcd_has_its_number_with_the_lowest_bit_first():
    """Row 3 is 11000000 in the order of the wires; the first pixel is on the left, and 1 is white."""
    clear = (b"D", b"\x20\x00")
    row = (b"D", bytes([0xC0, 0b11000000, 0x00, 0x7F, *[0xFF] * 14, 0, 0]))
    shown, = read(record(clear, row, END), "ls013b7dh03", 0)
    assert shown[2, :10].tolist() == [0] * 9 + [1] and shown.sum() == 128 * 128 - 9


def test_a_real_board_does_not_drive_a_chip_select_that_is_high():
    for driver in ("ls013b7dh03", "ls027b7dh01_400x240"):
        with pytest.raises(ToolError, match=f"DRIVER={driver} .*chip select.*BOARD=pico"):
            flash.check_display(argparse.Namespace(driver=driver, board="pico"), None)


def test_a_byte_of_a_page_is_a_column_of_eight_rows():
    # Page 2, column 0x15, of which the glass of an SH1106 shows all but two on each side; then only the low digit changes.
    shown, = read(record((b"C", b"\xA1\xC8\xAF\xB2\x05\x11"), (b"D", b"\x81\x01"), (b"C", b"\x03"), (b"D", b"\xFE"),
                         END), "sh1106", 0)
    assert shown.shape == (64, 128)
    assert [shown[16:24, column].tolist() for column in (0x13 - 2, 0x15 - 2, 0x16 - 2)] == \
        [[0, 1, 1, 1, 1, 1, 1, 1], [1, 0, 0, 0, 0, 0, 0, 1], [1, 0, 0, 0, 0, 0, 0, 0]]
    unwritten = [1, 0, 1, 0, 0, 1, 0, 1]
    assert shown[8:16, 0x13].tolist() == shown[16:24, 0x12].tolist() == shown[24:32, 0x13].tolist() == unwritten


def test_rows_become_columns_and_run_the_other_way():
    upright = [*command(0x36, 0x48), *command(0x2A, 0, 0, 0, 0), *command(0x2B, 1, 0, 1, 0), *command(0x2C, 0x12, 0x34)]
    shown, = read(record(*AWAKE, *command(0x29), *DOT, *upright, END))
    assert shown.shape == (240, 320) and shown[7, 5] == 0xF800
    assert numpy.rot90(shown, -1)[256, 0] == 0x1234
    assert (shown != controllers.UNWRITTEN).sum() == 2
    shown, = read(record(*AWAKE, *command(0x29), *command(0x36, 0xE8), *DOT, END))
    assert shown[239 - 7, 319 - 5] == 0xF800
    with pytest.raises(ToolError, match="for another turn"):
        read(record(*AWAKE, *command(0x29), *command(0x2A, 0, 0, 1, 0), *command(0x36, 0x48), *command(0x2C, 1, 2), END))


def test_colours_in_another_order_and_inverted_show():
    shown, = read(record(*AWAKE, *command(0x36, 0x20), *command(0x29), *DOT, END))
    assert shown[7, 5] == 0x001F
    shown, = read(record(*AWAKE, *command(0x21), *command(0x29), *DOT, END))
    assert shown[7, 5] == 0x07FF


def test_rows_of_pages_are_joined_as_they_were_told():
    dot = [(b"C", b"\xAF\xB0\x00\x10"), (b"D", b"\x01")]
    for told, place in ((b"\xA1\xC8", (0, 0)), (b"\xA0\xC8", (0, 127)), (b"\xA1\xC0", (63, 0)), (b"\xA1\xC8\xD3\x3E", (2, 0))):
        blank = [part for page in range(8) for part in
                 [(b"C", bytes([0xB0 + page, 0x00, 0x10])), (b"D", bytes(128))]]
        shown, = read(record(*blank, *dot, (b"C", told), END), "ssd1306", 0)
        assert shown.sum() == 1 and shown[place] == 1
    for told, words in ((b"\xDA\x02", "of other COM pins"), (b"\xA8\x1F", "of another glass")):
        with pytest.raises(ToolError, match=words):
            read(record(*dot, (b"C", told), END), "ssd1306", 0)


def test_one_wrong_pixel_is_a_frame_that_differs(tmp_path):
    frames = random_frames(2, 240, 320)
    palette = numpy.random.default_rng(5).integers(0, 256, (256, 3), dtype=numpy.uint8)
    file = tmp_path / "frames.fxld"
    file.write_bytes(dump_bytes(frames, palette.tobytes()))
    whole = [*command(0x2A, 0, 0, 1, 63), *command(0x2B, 0, 0, 0, 239)]
    parts = [*AWAKE, *command(0x29)]
    for number, frame in enumerate(frames):
        sent = wires.rgb565(palette)[frame].astype(">u2")
        sent[200, 100] ^= number    # of the second frame one bit is wrong
        parts += [*whole, (b"C", b"\x2C"), (b"D", sent.tobytes()), (b"F", struct.pack("<I", number))]
    (tmp_path / "wires.bin").write_bytes(record(*parts))
    found = wires.compare(tmp_path / "wires.bin", "ili9341", dump.read_dump(file))
    assert found.equal == 1 and len(found.hashes) == 2
    colours = [wires.rgb565(palette)[frame].astype(">u2") for frame in frames]
    colours[1][200, 100] ^= 1
    assert found.sent.each == [f"{zlib.crc32(sent.tobytes()):08x}" for sent in colours]
    assert found.sent.all == f"{zlib.crc32(b''.join(sent.tobytes() for sent in colours)):08x}"
    (tmp_path / "wires.bin").write_bytes(record(*parts[:-1]))
    with pytest.raises(ToolError, match="1 frames come, and 2 were drawn"):
        wires.compare(tmp_path / "wires.bin", "ili9341", dump.read_dump(file))


def test_a_run_whose_wires_differ_fails(tmp_path, monkeypatch):
    """A driver that shows another frame than was drawn ends in FAIL, and exit code 1."""
    from fixel.board import run as run_tool
    made("build/boards/host/walk-on-sh1106", "BOARD=host", "DRIVER=sh1106")
    monkeypatch.setattr(wires, "shown", lambda driver, pixels, palette, turns: numpy.zeros((64, 128), numpy.uint16))
    code = run_tool.main(["--board", "host", "--scene", "scenes/tiny.toml", "--screen", "128x64", "--frames", "4",
                          "--driver", "sh1106", "--out", str(tmp_path / "out")])
    assert code == 1
    assert json.loads((tmp_path / "out" / "summary.json").read_text())["wires_frames_equal"] < 4
