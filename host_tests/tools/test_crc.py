# SPDX-License-Identifier: MIT
"""fixel crc: the CRC-32 of the frames of a dump, and of what a display got of them."""

import json
import struct
import zlib

import numpy
import pytest
from conftest import assert_one_sentence, dump_bytes, random_frames, run_cli

from fixel.board import frame_crc


@pytest.fixture
def frames(tmp_path):
    made = random_frames(3, 16, 8)
    (tmp_path / "frames.fxld").write_bytes(dump_bytes(made))
    return made


def record(frames):
    """The wires of an SSD1306 that shows a picture of 16 x 8: noise, of 16 bytes a frame. Before the first one comes more."""
    def part(kind, data):
        return kind + struct.pack("<I", len(data)) + bytes(data)
    awake = part(b"C", [0xA8, 63, 0xAF]) + part(b"D", [0] * 100)
    return awake + b"".join(part(b"C", [0xB0, 0x00, 0x10]) + part(b"D", data) + part(b"F", struct.pack("<I", number))
                            for number, data in enumerate(frames))


def test_a_line_for_each_frame(tmp_path, frames):
    done = run_cli("crc", tmp_path / "frames.fxld")
    expected = [f"{number}: frame {zlib.crc32(frame.tobytes()):08x}, sent -" for number, frame in enumerate(frames)]
    whole = zlib.crc32(b"".join(frame.tobytes() for frame in frames))
    assert (done.returncode, done.stdout.splitlines()) == (0, [*expected, f"all: frame {whole:08x}, sent -"])


def test_what_a_display_got(tmp_path, frames):
    sent = [bytes(range(number, number + 16)) for number in range(3)]
    (tmp_path / "wires.bin").write_bytes(record(sent))
    done = run_cli("crc", tmp_path / "frames.fxld", "--wires", tmp_path / "wires.bin", "--driver", "ssd1306", "--json")
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert found["frame_crc"] == [f"{zlib.crc32(frame.tobytes()):08x}" for frame in frames]
    assert found["sent_crc"] == [f"{zlib.crc32(data):08x}" for data in sent], "not what came before the first frame"
    assert found["sent_crc_all"] == f"{zlib.crc32(b''.join(sent)):08x}"


@pytest.mark.parametrize("words, sentence", [
    (["--driver", "st7789"], "--wires and --driver belong together"), (["--wires", "x"], "--wires and --driver belong together"),
    (["--wires", "x", "--driver", "st7788"], "there is no driver st7788")])
def test_options_that_make_no_sense(tmp_path, frames, words, sentence):
    done = run_cli("crc", tmp_path / "frames.fxld", *words)
    assert_one_sentence(done, sentence)
    assert len(frames) == 3


def test_the_high_byte_of_a_colour_comes_first():
    assert frame_crc.pixel_bytes(numpy.array([[0x1234, 0x00FF]], "<u2")) == bytes([0x12, 0x34, 0x00, 0xFF])
    assert frame_crc.pixel_bytes(numpy.array([[0x12, 0xFF]], numpy.uint8)) == bytes([0x12, 0xFF])
