# SPDX-License-Identifier: MIT
"""Boards' programs for the tests of flashing, booting and screens."""

import dataclasses
import fcntl
import functools
import os
import pathlib
import shutil
import stat
import struct
import subprocess
import zlib

import named_programs
from fixel.board import dump, emulator, firmware, flash_memory, session
from fixel.scene import making

ROOT = pathlib.Path(__file__).resolve().parents[2]
BOARD = "mps2-an385"
# Without those whose tools make test does not install: tests of their own have them.
EVERY_BOARD = sorted(path.parent.name for path in (ROOT / "boards").glob("*/board.mk")
                     if path.parent.name != "host" and "BOARD_SETUP :=" not in path.read_text(encoding="utf-8"))


@functools.cache
def made(target, *settings):
    """A file of this make, made if it is not new enough: once in a process, which sees no sources change. What
    make test has built just now is new; to ask make takes a second."""
    named_programs.add(ROOT / target)
    if str(target) in os.environ.get("FIXEL_BUILT", "").split():
        return ROOT / target
    (ROOT / "build").mkdir(exist_ok=True)
    with open(ROOT / "build" / ".board-tests.lock", "w", encoding="ascii") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # several test files run at a time
        environment = {key: value for key, value in os.environ.items()
                       if key not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL")}
        done = subprocess.run(["make", "--no-print-directory", *settings, str(target)], cwd=ROOT,
                              env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return ROOT / target


def built(name):
    """A file under build/boards, made by make if it is not new enough."""
    return made(pathlib.Path("build") / "boards" / name, f"BOARD={name.split('/')[0]}")


def tiny_scene(folder):
    """scenes/tiny.toml as an image."""
    path = folder / "tiny.fxls"
    making.build(str(ROOT / "scenes" / "tiny.toml"), str(path))
    return path


def scene_bytes(size=400, version=9):
    """Bytes that the flash tool takes for a scene image; no loader would."""
    body = struct.pack("<4sHHI", b"FXLS", version, 0, size)
    rest = bytes((7 * i) & 255 for i in range(size - 16))
    return body + struct.pack("<I", zlib.crc32(rest)) + rest


def fake_qemu(directory, script):
    """A directory for PATH in which qemu-system-arm is a shell script; in it
    "$REAL" is the real one."""
    directory.mkdir()
    path = directory / "qemu-system-arm"
    path.write_text(f"#!/bin/sh\nREAL={shutil.which('qemu-system-arm')}\n{script}\n", encoding="ascii")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return f"{directory}{os.pathsep}{os.environ['PATH']}"


def read_uf2(data):
    """{address: bytes} by the format's specification, without the tool's own reader."""
    assert len(data) % 512 == 0
    pages = {}
    for number, start in enumerate(range(0, len(data), 512)):
        words = struct.unpack_from("<8I", data, start)
        assert words[:3] == (0x0A324655, 0x9E5D5157, 0x2000) and words[4:] == (256, number, len(data) // 512, 0xE48BFF56)
        assert data[start + 508:start + 512] == bytes.fromhex("306fb10a") and not any(data[start + 288:start + 508])
        pages[words[3]] = data[start + 32:start + 288]
    return pages


# --- screens ------------------------------------------------------------------------

@dataclasses.dataclass(frozen=True)
class Flashed:
    """A scene in a board's flash, and the host's frames of its path."""
    program: firmware.Program
    image: pathlib.Path     # the flash image
    scene: pathlib.Path     # the scene image
    host: dump.Dump


def flashed(board, scene, folder, screen=None):
    """scenes/<scene>.toml in the flash of a board, at a screen of its own where one is given."""
    folder = pathlib.Path(folder)
    image, bin_file, frames = folder / "scene.fxls", folder / "board.bin", folder / "host.fxld"
    making.build(str(ROOT / "scenes" / f"{scene}.toml"), str(image), screen=screen)
    elf = built(f"{board}/walk.elf")
    flash_memory.flash(board, elf, image, bin_file)
    emulator.run(firmware.HOST, image, built("host/walk"), frames)
    return Flashed(firmware.load(elf, board), bin_file, image, dump.read_dump(frames))


def screen_after(flashed_scene, frames, folder, device=None, options=()):
    """What a screen shows when so many frames were drawn, and the board's own dump of them."""
    with session.Session(flashed_scene.program, flashed_scene.image, folder, [f"frames={frames}", "hold"],
                         options) as board:
        board.wait_for_text(f"walk: done {frames} frames\n")
        return board.screen(device), dump.read_dump(pathlib.Path(folder) / emulator.DUMP_NAME)
