# SPDX-License-Identifier: MIT
"""The dump reader: what is whole is read, what is not is refused and said; and fixel crc, the CRC-32 of its frames, and of what a display got of
them."""

import json
import os
import struct
import zlib

import numpy
import pytest
from hypothesis import given, settings, strategies as st

from conftest import COUNTERS_OF_A_FRAME, assert_one_sentence, dump_bytes, random_frames, run_cli
from fixel.base.errors import ToolError
from fixel.board import dump, crc

BUILT_PROGRAMS = ()
FRAMES = random_frames(3, 5, 7)
WHOLE = dump_bytes(FRAMES)
HEAD = 16 + 768
FRAME = 4 + 4 + 24 + 35 + 36 + 4 + 8


def refused(data):
    with pytest.raises(ToolError) as caught:
        dump.parse_dump(data, "board.fxld")
    assert str(caught.value).startswith("board.fxld: ")
    assert "\n" not in str(caught.value)
    return str(caught.value)


def with_checksum(data):
    """data with its last four bytes made right: only what else is wrong is wrong."""
    return data[:-4] + struct.pack("<I", zlib.crc32(data[:-4]))


def changed(offset, replacement):
    return with_checksum(WHOLE[:offset] + replacement + WHOLE[offset + len(replacement):])


def test_whole_dump_is_read():
    read = dump.parse_dump(WHOLE, "board.fxld")
    assert (read.width, read.height, len(read.frames)) == (7, 5, 3)
    for frame, pixels in zip(read.frames, FRAMES):
        assert numpy.array_equal(frame.pixels, pixels)
        assert frame.position == (1, -2, 3) and frame.angles == (4, 5, 6)
        assert tuple(frame.counters.values()) == COUNTERS_OF_A_FRAME
    assert [frame.instructions for frame in read.frames] == [1000, 1001, 1002]
    assert read.palette[0].tolist() == [0, 1, 2] and read.palette.shape == (256, 3)


@pytest.mark.parametrize("length", [0, 3, 4, 15, HEAD - 1, HEAD, HEAD + 1, HEAD + FRAME,
                                    HEAD + 3 * FRAME, len(WHOLE) - 1])
def test_truncated(length):
    message = refused(WHOLE[:length])
    assert "incomplete" in message or "not a frame dump" in message


@given(st.integers(0, len(WHOLE) - 1))
@settings(max_examples=200, deadline=None)
def test_every_truncation_is_refused(length):
    refused(WHOLE[:length])


@given(st.integers(0, len(WHOLE) * 8 - 1))
@settings(max_examples=300, deadline=None)
def test_every_flipped_bit_is_refused(bit):
    data = bytearray(WHOLE)
    data[bit // 8] ^= 1 << bit % 8
    refused(bytes(data))


def box_dump(boxes, beyond=0):
    """A dump of two frames of boxes; beyond: columns by which they leave the frame."""
    out = WHOLE[:12] + struct.pack("<I", 0) + WHOLE[16:HEAD]
    for number, (x, columns, y, rows) in enumerate(boxes):
        out += b"FRAM" + struct.pack("<I3i3I", number | 1 << 31, 1, -2, 3, 4, 5, 6) + struct.pack("<4H", x + beyond, columns, y, rows)
        out += FRAMES[number][y:y + rows, x:x + columns].tobytes() + bytes(8)
        out += struct.pack("<9IIQ", *COUNTERS_OF_A_FRAME, 0, 1000)
    return with_checksum(out + b"FEND" + struct.pack("<I", len(boxes)) + bytes(4))


BOXES = [(0, 7, 0, 5), (2, 4, 1, 3)]


def test_a_frame_of_boxes_is_the_one_before_with_them():
    first, second = dump.parse_dump(box_dump(BOXES), "board.fxld").frames
    expected = FRAMES[0].copy()
    expected[1:4, 2:6] = FRAMES[1][1:4, 2:6]
    assert numpy.array_equal(first.pixels, FRAMES[0]) and numpy.array_equal(second.pixels, expected)
    assert first.boxes == (BOXES[0],) and second.boxes == (BOXES[1],) and second.pixels.dtype == numpy.uint8
    assert second.instructions == 1000 and tuple(second.counters.values()) == COUNTERS_OF_A_FRAME


def test_boxes_that_are_not_those_of_frames_are_refused():
    assert "frame 1 of 0" in refused(box_dump(BOXES)[:-120]) and "incomplete" in refused(box_dump(BOXES)[:-120])
    assert "leave pixels out" in refused(box_dump([(0, 7, 0, 4)]))
    assert "beyond the frame" in refused(box_dump(BOXES, 1))


def test_not_a_dump():
    assert "does not begin with FXLD" in refused(b"\x89PNG" + WHOLE[4:])


def test_other_version():
    assert "version 1" in refused(dump_bytes(FRAMES, version=1))


def test_pixels_of_other_bits():
    assert "pixels of 4 bits; a pixel has 8 or 16" in refused(dump_bytes(FRAMES, bits=4))
    refused(dump_bytes(FRAMES, bits=16))    # its frames are longer


def test_pixels_of_16_bits_and_their_colours():
    frames = [numpy.array([[0, 0xFFFF, 0xF800], [0x07E0, 0x001F, 0x8410]], "<u2")]
    read = dump.parse_dump(dump_bytes(frames, bits=16), "board.fxld")
    assert numpy.array_equal(read.frames[0].pixels, frames[0])
    assert read.palette[read.frames[0].pixels].tolist() == [[[0, 0, 0], [255, 255, 255], [255, 0, 0]],
                                                            [[0, 255, 0], [0, 0, 255], [132, 130, 132]]]


def test_screen_of_no_pixels_and_too_large():
    assert "0x5" in refused(changed(6, b"\0\0"))
    assert "1025x5" in refused(changed(6, struct.pack("<H", 1025)))


def test_frames_out_of_order():
    assert "says that it is frame 7" in refused(changed(HEAD + FRAME + 4, struct.pack("<I", 7)))


def test_frame_without_magic():
    assert "FRAM" in refused(changed(HEAD + FRAME, b"XXXX"))


def test_fewer_frames_than_promised():
    assert "promises 5" in refused(dump_bytes(FRAMES, promised=5))


def test_more_frames_than_promised():
    refused(dump_bytes(FRAMES, promised=2))


def test_something_follows_the_tail():
    assert "follow its tail" in refused(WHOLE + b"\0")


def test_a_promise_of_four_billion_frames_takes_no_memory():
    refused(changed(12, b"\xff\xff\xff\xff"))


def test_missing_file(tmp_path):
    with pytest.raises(ToolError, match="No such file"):
        dump.read_dump(tmp_path / "none.fxld")


# --- while a board writes it --------------------------------------------------------

@pytest.fixture(name="file")
def fixture_file(tmp_path):
    """A dump of more bytes than are read at a time."""
    file = tmp_path / "board.fxld"
    file.write_bytes(dump_bytes(random_frames(3, 600, 800)))
    assert file.stat().st_size > 1 << 20
    return file


def test_a_dump_that_is_whole_passes(file):
    assert dump.shape(file) == (3, file.stat().st_size)
    assert dump.check(file, 3) is None


@pytest.mark.parametrize("place", [HEAD + 100, (1 << 20) + 1, -5, -1])
def test_a_byte_that_differs_anywhere_is_damage(file, place):
    data = bytearray(file.read_bytes())
    data[place] ^= 1
    file.write_bytes(data)
    with pytest.raises(ToolError, match="damaged") as refused:
        dump.check(file, 3)
    assert refused.value.exit_code == 1


@pytest.mark.parametrize("change", [lambda data: data[:-1], lambda data: data + b"x"])
def test_a_dump_of_another_length_is_not_whole(file, change):
    size = file.stat().st_size
    file.write_bytes(change(file.read_bytes()))
    with pytest.raises(ToolError, match=f"{size} expected for 3 frames"):
        dump.check(file, 3)


def test_a_dump_of_other_frames_or_none_is_not_whole(file, tmp_path):
    with pytest.raises(ToolError, match="not whole"):
        dump.check(file, 4)
    with pytest.raises(ToolError, match="left no frame dump"):
        dump.check(tmp_path / "none.fxld", 3)


@pytest.mark.parametrize("head", [b"", b"FXLX", WHOLE[:HEAD - 1], b"FXLX" + WHOLE[4:], dump_bytes(FRAMES, version=2),
                                  dump_bytes(FRAMES, bits=9)])
def test_a_head_that_is_none_announces_nothing(tmp_path, head):
    (tmp_path / "board.fxld").write_bytes(head)
    assert dump.shape(tmp_path / "board.fxld") is None


def test_pixels_of_16_bits_take_two_bytes(tmp_path):
    (tmp_path / "board.fxld").write_bytes(dump_bytes(FRAMES, bits=16)[:HEAD])
    assert dump.shape(tmp_path / "board.fxld") == (3, len(WHOLE) + 3 * 5 * 7)


def test_frames_are_told_while_a_dump_grows(tmp_path):
    told, file = [], tmp_path / "board.fxld"
    look = dump.watch(file, lambda done, frames: told.append((done, frames)))
    assert look() == (0, None) and not told
    part = tmp_path / "board.fxld.part"
    for size in (HEAD - 1, HEAD, HEAD + FRAME - 1, HEAD + FRAME, len(WHOLE)):
        part.write_bytes(WHOLE[:size])
        assert look() == (size, None)
    assert told == [(0, 3), (0, 3), (1, 3), (3, 3)]
    part.rename(file)
    assert look() == (len(WHOLE), None)
    file.write_bytes(WHOLE + b"x")
    assert look() == (len(WHOLE) + 1, "it writes more than it announced")


@pytest.mark.parametrize("looks", range(8))
def test_a_dump_that_is_renamed_while_it_is_looked_at(tmp_path, monkeypatch, looks):
    """The host's board renames it when it is whole: at any moment of a look."""
    file, part, real, asked = tmp_path / "board.fxld", tmp_path / "board.fxld.part", os.stat, []
    part.write_bytes(WHOLE)

    def stat(path, *more, **how):
        asked.append(path)
        if len(asked) == looks + 1:
            part.rename(file)
        return real(path, *more, **how)

    monkeypatch.setattr(os, "stat", stat)
    look = dump.watch(file, None)
    assert [look() for _ in range(4)][-1] == (len(WHOLE), None)


# --- CRC-32 -----------------------------------------------------------------------------------

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
    assert crc.pixel_bytes(numpy.array([[0x1234, 0x00FF]], "<u2")) == bytes([0x12, 0x34, 0x00, 0xFF])
    assert crc.pixel_bytes(numpy.array([[0x12, 0xFF]], numpy.uint8)) == bytes([0x12, 0xFF])
