# SPDX-License-Identifier: MIT
"""The flash image: what is refused before anything is written, what is written, and what stays when it goes wrong;
and flash, power on and read the frames on every board there is."""

import dataclasses
import os
import pathlib
import random
import resource
import struct
import subprocess
import sys
import time
import types

import pytest

from board_programs import BOARD, built, EVERY_BOARD, fake_qemu, ROOT, scene_bytes, tiny_scene
from conftest import LAUNCHER
from fixel.base.errors import ToolError
from fixel.board import dump, emulator, firmware, flash_memory, qemu

BUILT_PROGRAMS = ()


@pytest.fixture(scope="module")
def elf():
    return built(f"{BOARD}/faults.elf")


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "some.fxls"
    path.write_bytes(scene_bytes())
    return path


@pytest.fixture
def image(tmp_path):
    return tmp_path / "flash" / "board.bin"


def refuse(image, *arguments):
    """The sentence of a refusal; nothing may have been written."""
    before = image.read_bytes() if image.exists() else None
    with pytest.raises(ToolError) as caught:
        flash_memory.flash(*arguments, image)
    assert (image.read_bytes() if image.exists() else None) == before
    if image.parent.exists():
        assert [path.name for path in image.parent.iterdir()] == ([image.name] if before is not None else [])
    return str(caught.value)


def moved(elf, target, address):
    """A copy of a program whose first loaded segment is for another address."""
    data = bytearray(elf.read_bytes())
    (table,) = struct.unpack_from("<I", data, 28)
    size, count = struct.unpack_from("<HH", data, 42)
    first = next(at for at in range(table, table + size * count, size)
                 if struct.unpack_from("<I", data, at)[0] == 1)  # p_type: PT_LOAD
    struct.pack_into("<I", data, first + 12, address)  # p_paddr
    target.write_bytes(data)
    return target


def test_what_is_written(elf, scene, image):
    result = flash_memory.flash(BOARD, elf, scene, image)
    data = image.read_bytes()
    program = firmware.load(elf)
    assert len(data) == program.flash_size == result.verified
    expected = bytearray(b"\xff" * program.flash_size)
    for address, content in program.segments:
        expected[address:address + len(content)] = content
    expected[program.scene_base:program.scene_base + 400] = scene.read_bytes()
    assert data == bytes(expected)
    assert [path.name for path in image.parent.iterdir()] == [image.name]
    assert image.stat().st_mode & 0o444 == 0o444


def test_only_touched_sectors_are_erased(elf, scene, image):
    program = firmware.load(elf)
    image.parent.mkdir()
    old = bytearray(b"\x00" * program.flash_size)
    image.write_bytes(old)
    result = flash_memory.flash(BOARD, elf, scene, image)
    data = image.read_bytes()
    (sector,) = set(program.sectors)
    used = sum(len(content) for _, content in program.segments)
    assert result.sectors_erased == (sector,) * (-(-used // sector) + 1)
    # The rest of the scene's sector is erased, the next one is as it was.
    assert data[program.scene_base + 400:program.scene_base + sector] == b"\xff" * (sector - 400)
    assert data[program.scene_base + sector] == 0


def with_sectors(elf, target, *runs):
    """A copy of a program whose memory map has sectors of different sizes: count
    and size of each run of equal ones."""
    table = target.with_suffix(".table")
    table.write_bytes(b"".join(struct.pack("<II", *run) for run in runs))
    subprocess.run(["arm-none-eabi-objcopy", "--add-section", f".fxl_sectors={table}", elf, target], check=True)
    table.unlink()
    return target


STM32F4 = ((4, 16384), (1, 65536), (31, 131072))  # as an STM32F405 begins, but 4 MiB long


def test_sectors_of_different_sizes(elf, scene, image, tmp_path):
    uneven = with_sectors(elf, tmp_path / "uneven.elf", *STM32F4)
    program = firmware.load(uneven)
    assert program.sectors == (16384,) * 4 + (65536,) + (131072,) * 31
    image.parent.mkdir()
    image.write_bytes(b"\0" * program.flash_size)
    used = sum(len(content) for _, content in program.segments)
    assert used <= 16384
    assert flash_memory.flash(BOARD, uneven, scene, image).sectors_erased == (16384, 131072)
    data = image.read_bytes()
    assert data[used:16384] == b"\xff" * (16384 - used) and data[16384] == 0
    base = program.scene_base
    assert data[base - 1] == 0 and data[base + 400:base + 131072] == b"\xff" * (131072 - 400)
    assert data[base + 131072] == 0


def test_a_program_over_sectors_of_different_sizes(elf):
    program = dataclasses.replace(
        firmware.load(elf), sectors=(16384,) * 4 + (65536,) + (131072,) * 31, flash_base=0x08000000,
        scene_base=0x08080000, segments=((0x08000000 + 3 * 16384 - 4, b"\x11" * (16384 + 8)),))
    data, erased = flash_memory.program_flash(program, b"\x22" * 131073, b"\0" * program.flash_size)
    assert erased == (16384, 16384, 65536, 131072, 131072)
    assert data[32767] == 0 and data[32768:49148] == b"\xff" * 16380 and data[49148:65540] == b"\x11" * 16392
    assert data[65540:131072] == b"\xff" * 65532 and data[131072:0x80000] == bytes(0x80000 - 131072)
    assert data[0x80000:0x80000 + 131073] == b"\x22" * 131073


@pytest.mark.parametrize("runs, words", [
    (((4, 16384),), "4 of 16384 bytes, and that the flash has 4194304"),
    (((4, 16384), (1, 4194304)), "4 of 16384 and 1 of 4194304 bytes"),
    (((1 << 22, 1),), "4194304 of 1 bytes"),
    (((1, 4194304), (5, 0)), "5 of 0 bytes"),
    ((), "none"),
    (((4, 1048576),), "does not begin with a sector"),
])
def test_a_map_of_sectors_that_cannot_be(elf, scene, image, tmp_path, runs, words):
    assert words in refuse(image, BOARD, with_sectors(elf, tmp_path / "bad.elf", *runs), scene)


def test_a_second_scene_replaces_the_first(elf, scene, image, tmp_path):
    flash_memory.flash(BOARD, elf, scene, image)
    other = tmp_path / "other.fxls"
    other.write_bytes(scene_bytes(200))
    flash_memory.flash(BOARD, elf, other, image)
    base = firmware.load(elf).scene_base
    assert image.read_bytes()[base:base + 400] == other.read_bytes() + b"\xff" * 200


def test_a_program_for_another_board(scene, image, elf):
    assert "is for board host, not for mps2-an385" in refuse(image, BOARD, built("host/walk"), scene)
    assert "is for board mps2-an385, not for host" in refuse(image, "host", elf, scene)


def test_a_program_that_is_cut_off(elf, scene, image, tmp_path):
    data = elf.read_bytes()
    cut = tmp_path / "cut.elf"
    for size in sorted({0, 1, 4, 16, 51, 52, *range(100, len(data), len(data) // 40), len(data) - 1}):
        cut.write_bytes(data[:size])
        refuse(image, BOARD, cut, scene)


def test_a_damaged_program_ends_in_a_sentence(elf, tmp_path):
    """Or is read as what it then says; never in a traceback."""
    good = elf.read_bytes()
    damaged = tmp_path / "damaged.elf"
    generator = random.Random(1)
    (table,) = struct.unpack_from("<I", good, 32)
    places = [*range(52), *range(table, len(good)), *range(52, 52 + 3 * 32)]
    refused = 0
    for _ in range(400):
        data = bytearray(good)
        for _ in range(generator.randint(1, 4)):
            data[generator.choice(places)] ^= 1 << generator.randrange(8)
        damaged.write_bytes(data)
        try:
            firmware.load(damaged)
        except ToolError as error:
            refused += 1
            assert str(damaged) in str(error)
    assert refused > 50


def test_a_file_that_is_no_program(scene, image, tmp_path):
    assert "is not an ELF file" in refuse(image, BOARD, scene, scene)
    assert "does not name its board" in refuse(image, BOARD, pathlib.Path("/bin/sh"), scene)
    assert "there is no such program" in refuse(image, BOARD, tmp_path / "none.elf", scene)


def test_a_program_that_does_not_fit(elf, scene, image, tmp_path):
    assert "does not fit" in refuse(image, BOARD, moved(elf, tmp_path / "a.elf", 0x3FFFF0), scene)
    assert "does not fit" in refuse(image, BOARD, moved(elf, tmp_path / "b.elf", 0x20000000), scene)


def test_a_program_that_reaches_into_the_scene(elf, scene, image, tmp_path):
    assert "reaches into the scene partition" in refuse(image, BOARD, moved(elf, tmp_path / "a.elf", 0x7FFF0), scene)


@pytest.mark.parametrize("spoil, words", [
    (lambda data: data[:91], "is not a scene image"),
    (lambda data: data[:100], "says that it has 400"),
    (lambda data: b"FXLT" + data[4:], "is not a scene image"),
    (lambda data: b"", "is not a scene image"),
    (lambda data: data[:-4], "says that it has 400"),
    (lambda data: data + bytes(4), "says that it has 400"),
    (lambda data: data[:300] + bytes([data[300] ^ 4]) + data[301:], "checksum does not match"),
    (lambda data: scene_bytes(version=8), "version 8; this tool knows version 9: build it again"),
    (lambda data: scene_bytes(3584 * 1024 + 4), "does not fit"),
])
def test_a_scene_that_is_not_one(elf, scene, image, spoil, words):
    scene.write_bytes(spoil(scene.read_bytes()))
    assert words in refuse(image, BOARD, elf, scene)


def test_a_scene_that_just_fits(elf, scene, image):
    scene.write_bytes(scene_bytes(3584 * 1024))
    assert flash_memory.flash(BOARD, elf, scene, image).parts[1].room == 3584 * 1024


def test_a_scene_that_is_not_there(elf, image, tmp_path):
    assert "cannot be read" in refuse(image, BOARD, elf, tmp_path / "none.fxls")


def test_an_image_of_another_size(elf, scene, image):
    image.parent.mkdir()
    image.write_bytes(b"\xff" * 1000)
    assert "1000 bytes, 4194304 expected" in refuse(image, BOARD, elf, scene)


@pytest.fixture
def little_memory():
    """256 MiB more than the process has now."""
    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    pages = int(pathlib.Path("/proc/self/statm").read_text().split()[0])
    resource.setrlimit(resource.RLIMIT_AS, (pages * resource.getpagesize() + (256 << 20), hard))
    yield
    resource.setrlimit(resource.RLIMIT_AS, (soft, hard))


def test_a_file_of_3_gib_is_refused_unread(elf, scene, tmp_path, little_memory):
    huge = tmp_path / "huge.bin"
    huge.touch()
    os.truncate(huge, 3 << 30)
    with pytest.raises(MemoryError):
        huge.read_bytes()
    with pytest.raises(ToolError, match="3221225472 bytes, 4194304 expected"):
        flash_memory.flash(BOARD, elf, scene, huge)
    with pytest.raises(ToolError, match="3221225472 bytes, 4194304 expected"):
        emulator.run(BOARD, huge, elf, tmp_path / "dump")
    with pytest.raises(ToolError, match="huge.bin"):
        flash_memory.flash(BOARD, elf, huge, tmp_path / "board.bin")
    assert [path.name for path in tmp_path.iterdir() if path != scene] == [huge.name]


def test_an_image_that_cannot_be_written(elf, scene, tmp_path):
    (tmp_path / "file").write_bytes(b"")
    with pytest.raises(ToolError, match="cannot be written: Not a directory"):
        flash_memory.flash(BOARD, elf, scene, tmp_path / "file" / "board.bin")


def test_a_failed_verification_leaves_the_old_image(elf, scene, image, monkeypatch):
    flash_memory.flash(BOARD, elf, scene, image)
    scene.write_bytes(scene_bytes(800))
    real = qemu.read_memory

    def stuck_bit(program, path):
        data = bytearray(real(program, path))
        data[0x80100] ^= 1
        return bytes(data)

    monkeypatch.setattr(qemu, "read_memory", stuck_bit)
    assert "verification failed at 0x80100" in refuse(image, BOARD, elf, scene)


def test_an_emulator_that_does_not_read_the_flash_is_ended(elf, image, monkeypatch):
    done = []

    def refuse(*_, **__):
        raise ToolError("QEMU refuses 'memsave'")
    machine = types.SimpleNamespace(execute=refuse, close=lambda: done.append("closed"))
    monkeypatch.setattr(qemu, "start_stopped", lambda *_: ("process", machine))
    monkeypatch.setattr(qemu.execute, "kill", done.append)
    with pytest.raises(ToolError, match="could not read the flash back: QEMU refuses 'memsave'"):
        qemu.read_memory(firmware.load(elf, BOARD), image)
    assert done == ["closed", "process"]


def test_missing_qemu_leaves_the_old_image(elf, scene, image, monkeypatch, tmp_path):
    flash_memory.flash(BOARD, elf, scene, image)
    monkeypatch.setenv("PATH", str(tmp_path))
    scene.write_bytes(scene_bytes(800))
    assert "apt-get install qemu-system-arm" in refuse(image, BOARD, elf, scene)


@pytest.mark.parametrize("number", ["INT", "KILL"])
def test_an_interrupted_flash_leaves_the_old_image(elf, scene, image, tmp_path, number):
    flash_memory.flash(BOARD, elf, scene, image)
    before = image.read_bytes()
    scene.write_bytes(scene_bytes(800))
    path = fake_qemu(tmp_path / "bin", f"touch {tmp_path}/started; exec sleep 20")
    process = subprocess.Popen([sys.executable, LAUNCHER, "flash", "--board", BOARD, "--elf", elf,
                                "--scene", scene, "--image", image], env={**os.environ, "PATH": path},
                               stderr=subprocess.PIPE, text=True)
    while not (tmp_path / "started").exists():
        assert process.poll() is None
        time.sleep(0.02)
    process.send_signal(getattr(__import__("signal"), f"SIG{number}"))
    _, words = process.communicate()
    assert process.returncode != 0
    assert "Traceback" not in words
    assert image.read_bytes() == before
    if number == "INT":
        assert [left.name for left in image.parent.iterdir()] == [image.name]


def test_the_command(elf, scene, image):
    command = [sys.executable, LAUNCHER, "flash", "--board", BOARD, "--elf", elf, "--scene", scene,
               "--image", image]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "scene" in done.stdout and "0x00080000" in done.stdout and "verified" in done.stdout
    scene.write_bytes(b"x")
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert done.stderr.startswith("error: ") and done.stderr.count("\n") == 1


def test_the_host_has_the_scene_for_an_image(scene, image):
    result = flash_memory.flash("host", built("host/walk"), scene, image)
    assert image.read_bytes() == scene.read_bytes()
    assert result.verified == 400


def test_a_program_without_content(elf):
    empty = dataclasses.replace(firmware.load(elf), segments=())
    with pytest.raises(ToolError, match="nothing to program"):
        flash_memory.check_program(empty)


# --- every board --------------------------------------------------------------------

BOARDS = sorted([firmware.HOST, *EVERY_BOARD])
EMULATED = [board for board in BOARDS if board != firmware.HOST]
FRAMES = 2


def walk(board):
    return built(f"{board}/walk" if board == firmware.HOST else f"{board}/walk.elf")


@pytest.fixture(scope="module")
def drawn_scene(tmp_path_factory):
    return tiny_scene(tmp_path_factory.mktemp("scene"))


@pytest.fixture(scope="module")
def of_the_host(tmp_path_factory, drawn_scene):
    folder = tmp_path_factory.mktemp("host")
    flash_memory.flash(firmware.HOST, walk(firmware.HOST), drawn_scene, folder / "host.bin")
    emulator.run(firmware.HOST, folder / "host.bin", walk(firmware.HOST), folder / "host.fxld", FRAMES)
    return dump.read_dump(folder / "host.fxld")


@pytest.mark.parametrize("board", BOARDS)
def test_flash_and_boot(board, drawn_scene, of_the_host, tmp_path):
    image = tmp_path / "flash.bin"
    result = flash_memory.flash(board, walk(board), drawn_scene, image)
    program = firmware.load(walk(board))
    assert result.verified == image.stat().st_size == (program.image_size or drawn_scene.stat().st_size)
    emulator.run(board, image, walk(board), tmp_path / "board.fxld", FRAMES)
    drawn = dump.read_dump(tmp_path / "board.fxld")
    assert [frame.pixels.tobytes() for frame in drawn.frames] == \
        [frame.pixels.tobytes() for frame in of_the_host.frames]


@pytest.mark.parametrize("board", EMULATED)
def test_a_scene_larger_than_the_partition(board, drawn_scene, tmp_path):
    program = firmware.load(walk(board))
    large = tmp_path / "large.fxls"
    large.write_bytes(scene_bytes(program.scene_size + 4))
    with pytest.raises(ToolError, match="does not fit"):
        flash_memory.flash(board, walk(board), large, tmp_path / "flash.bin")
    assert not (tmp_path / "flash.bin").exists()


@pytest.mark.parametrize("board", EMULATED)
def test_the_program_of_every_other_board_is_refused(board, drawn_scene, tmp_path):
    for other in BOARDS:
        if other != board:
            with pytest.raises(ToolError, match=f"is for board {other}, not for {board}"):
                flash_memory.flash(board, walk(other), drawn_scene, tmp_path / "flash.bin")
    assert not (tmp_path / "flash.bin").exists()


@pytest.mark.parametrize("board", EMULATED)
def test_the_map_of_the_flash(board):
    program = firmware.load(walk(board))
    assert sum(program.sectors) == program.image_size
    first, last = program.offset(program.scene_base), program.offset(program.scene_base + program.scene_size - 1)
    assert first in flash_memory.sector_starts(program) and last - first == program.scene_size - 1
    assert [program.offset(program.address(offset)) for offset in (0, first, last)] == [0, first, last]
    for base, size, _ in program.banks:
        assert program.offset(base - 1) is None and program.offset(base + size) is None


@pytest.mark.parametrize("board", EMULATED)
def test_a_byte_of_the_image_that_went_bad(board, drawn_scene, tmp_path):
    """In the program the tool sees it, in the scene the board does."""
    image = tmp_path / "flash.bin"
    flash_memory.flash(board, walk(board), drawn_scene, image)
    good = image.read_bytes()
    program = firmware.load(walk(board))
    for address, words in ((program.segments[0][0] + 1000, "does not hold"),
                           (program.scene_base + 300, "the scene image was refused")):
        bad = bytearray(good)
        bad[program.offset(address)] ^= 0x10
        image.write_bytes(bad)
        with pytest.raises(ToolError, match=words):
            emulator.run(board, image, walk(board), tmp_path / "board.fxld", FRAMES)
    assert not (tmp_path / "board.fxld").exists()
