# SPDX-License-Identifier: MIT
"""The flash image: what is refused before anything is written, what is written,
and what stays when it goes wrong."""

import dataclasses
import os
import pathlib
import struct
import subprocess
import sys
import time

import pytest

from board_programs import BOARD, ROOT, built, fake_qemu, scene_bytes
from fixel import firmware, flash, qemu
from fixel.errors import ToolError


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
        flash.flash(*arguments, image)
    assert (image.read_bytes() if image.exists() else None) == before
    if image.parent.exists():
        assert [path.name for path in image.parent.iterdir()] == ([image.name] if before is not None else [])
    return str(caught.value)


def moved(elf, target, address):
    """A copy of a program whose first segment is for another address."""
    data = bytearray(elf.read_bytes())
    (table,) = struct.unpack_from("<I", data, 28)
    struct.pack_into("<I", data, table + 12, address)  # p_paddr
    target.write_bytes(data)
    return target


def test_what_is_written(elf, scene, image):
    result = flash.flash(BOARD, elf, scene, image)
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
    result = flash.flash(BOARD, elf, scene, image)
    data = image.read_bytes()
    sector = program.flash_sector
    used = sum(len(content) for _, content in program.segments)
    assert result.sectors_erased == -(-used // sector) + 1
    # The rest of the scene's sector is erased, the next one is as it was.
    assert data[program.scene_base + 400:program.scene_base + sector] == b"\xff" * (sector - 400)
    assert data[program.scene_base + sector] == 0


def test_a_second_scene_replaces_the_first(elf, scene, image, tmp_path):
    flash.flash(BOARD, elf, scene, image)
    other = tmp_path / "other.fxls"
    other.write_bytes(scene_bytes(200))
    flash.flash(BOARD, elf, other, image)
    base = firmware.load(elf).scene_base
    assert image.read_bytes()[base:base + 400] == other.read_bytes() + b"\xff" * 200


def test_a_program_for_another_board(scene, image, elf):
    assert "is for board host, not for mps2-an385" in refuse(image, BOARD, built("host/walk"), scene)
    assert "is for board mps2-an385, not for host" in refuse(image, "host", elf, scene)


def test_a_file_that_is_no_program(scene, image, tmp_path):
    assert "is not an ELF file" in refuse(image, BOARD, scene, scene)
    assert "does not name its board" in refuse(image, BOARD, pathlib.Path("/bin/sh"), scene)
    assert "cannot read" in refuse(image, BOARD, tmp_path / "none.elf", scene)


def test_a_program_that_does_not_fit(elf, scene, image, tmp_path):
    assert "does not fit" in refuse(image, BOARD, moved(elf, tmp_path / "a.elf", 0x3FFFF0), scene)
    assert "does not fit" in refuse(image, BOARD, moved(elf, tmp_path / "b.elf", 0x20000000), scene)


def test_a_program_that_reaches_into_the_scene(elf, scene, image, tmp_path):
    assert "reaches into the scene partition" in refuse(image, BOARD, moved(elf, tmp_path / "a.elf", 0x7FFF0), scene)


@pytest.mark.parametrize("spoil, words", [
    (lambda data: data[:100], "is not a scene image"),
    (lambda data: b"FXLT" + data[4:], "is not a scene image"),
    (lambda data: b"", "is not a scene image"),
    (lambda data: data[:-4], "says that it has 400"),
    (lambda data: data + bytes(4), "says that it has 400"),
    (lambda data: data[:300] + bytes([data[300] ^ 4]) + data[301:], "checksum does not match"),
    (lambda data: scene_bytes(version=2), "version 2"),
    (lambda data: scene_bytes(3584 * 1024 + 4), "does not fit"),
])
def test_a_scene_that_is_not_one(elf, scene, image, spoil, words):
    scene.write_bytes(spoil(scene.read_bytes()))
    assert words in refuse(image, BOARD, elf, scene)


def test_a_scene_that_just_fits(elf, scene, image):
    scene.write_bytes(scene_bytes(3584 * 1024))
    assert flash.flash(BOARD, elf, scene, image).parts[1].room == 3584 * 1024


def test_a_scene_that_is_not_there(elf, image, tmp_path):
    assert "cannot read" in refuse(image, BOARD, elf, tmp_path / "none.fxls")


def test_an_image_of_another_size(elf, scene, image):
    image.parent.mkdir()
    image.write_bytes(b"\xff" * 1000)
    assert "1000 bytes, 4194304 expected" in refuse(image, BOARD, elf, scene)


def test_an_image_that_cannot_be_written(elf, scene, tmp_path):
    (tmp_path / "file").write_bytes(b"")
    with pytest.raises(ToolError, match="cannot (read|write)"):
        flash.flash(BOARD, elf, scene, tmp_path / "file" / "board.bin")


def test_a_failed_verification_leaves_the_old_image(elf, scene, image, monkeypatch):
    flash.flash(BOARD, elf, scene, image)
    scene.write_bytes(scene_bytes(800))
    real = qemu.read_memory

    def stuck_bit(program, path):
        data = bytearray(real(program, path))
        data[0x80100] ^= 1
        return bytes(data)

    monkeypatch.setattr(qemu, "read_memory", stuck_bit)
    assert "verification failed at 0x80100" in refuse(image, BOARD, elf, scene)


def test_missing_qemu_leaves_the_old_image(elf, scene, image, monkeypatch, tmp_path):
    flash.flash(BOARD, elf, scene, image)
    monkeypatch.setenv("PATH", str(tmp_path))
    scene.write_bytes(scene_bytes(800))
    assert "apt-get install qemu-system-arm" in refuse(image, BOARD, elf, scene)


@pytest.mark.parametrize("number", ["INT", "KILL"])
def test_an_interrupted_flash_leaves_the_old_image(elf, scene, image, tmp_path, number):
    flash.flash(BOARD, elf, scene, image)
    before = image.read_bytes()
    scene.write_bytes(scene_bytes(800))
    path = fake_qemu(tmp_path / "bin", f"touch {tmp_path}/started; exec sleep 20")
    process = subprocess.Popen([sys.executable, ROOT / "tools" / "flash.py", "--board", BOARD, "--elf", elf,
                                "--scene", scene, "--image", image], env={**os.environ, "PATH": path},
                               stderr=subprocess.PIPE, text=True)
    deadline = time.monotonic() + 20
    while not (tmp_path / "started").exists() and time.monotonic() < deadline:
        time.sleep(0.02)
    process.send_signal(getattr(__import__("signal"), f"SIG{number}"))
    _, words = process.communicate(timeout=30)
    assert process.returncode != 0
    assert "Traceback" not in words
    assert image.read_bytes() == before
    if number == "INT":
        assert [left.name for left in image.parent.iterdir()] == [image.name]


def test_the_command(elf, scene, image):
    command = [sys.executable, ROOT / "tools" / "flash.py", "--board", BOARD, "--elf", elf, "--scene", scene,
               "--image", image]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "scene" in done.stdout and "0x00080000" in done.stdout and "verified" in done.stdout
    scene.write_bytes(b"x")
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert done.stderr.startswith("error: ") and done.stderr.count("\n") == 1


def test_the_host_has_the_scene_for_an_image(scene, image):
    result = flash.flash("host", built("host/walk"), scene, image)
    assert image.read_bytes() == scene.read_bytes()
    assert result.verified == 400


def test_a_program_without_content(elf):
    empty = dataclasses.replace(firmware.load(elf), segments=())
    with pytest.raises(ToolError, match="nothing to program"):
        flash.check_program(empty)
