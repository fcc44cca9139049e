# SPDX-License-Identifier: MIT
"""rp2040js, the emulator of the board pico: whether it is there, its command line, and what its core reads."""

import functools
import hashlib
import json
import pathlib
import shutil

from fixel.base import children, scratch
from fixel.base.errors import ToolError

NAME = "rp2040js"       # emulator= of a board's note
RUNNER = pathlib.Path(__file__).with_name("rp2040.mjs")
PACKAGE = pathlib.Path(__file__).resolve().parents[3] / ".node" / "node_modules" / "rp2040js"
SILENCE = 1000          # million cycles: 8 s of the time of the board, whose watchdog barks after 2
SILENCE_OF_TESTS = 20000    # a unit test may compute in double for minutes


def find():
    """The path of node. Refuses where it or the package is missing."""
    node = shutil.which("node")
    if node is None:
        raise ToolError("node is not installed: run 'sudo apt-get install nodejs npm'")
    if not (PACKAGE / "package.json").is_file():
        raise ToolError("rp2040js, which emulates the board, is not set up: run 'tools/setup.sh pico'")
    return node


@functools.cache
def version():
    """The version of the package, of node and of our own runner: what has been kept of another one counts no more."""
    package = json.loads((PACKAGE / "package.json").read_text(encoding="utf-8"))["version"]
    runner = b"".join(path.read_bytes() for path in sorted(RUNNER.parent.glob("rp2040*.mjs")))
    return f"rp2040js {package}, node {children.run([find(), '--version'], text=True).stdout.strip()}, {hashlib.sha256(runner).hexdigest()}"


def boot_crc(data):
    """CRC-32/MPEG-2, by which the boot ROM checks the second boot stage."""
    found = 0xFFFFFFFF
    for byte in data:
        found ^= byte << 24
        for _ in range(8):
            found = (found << 1 ^ (0x04C11DB7 if found >> 31 else 0)) & 0xFFFFFFFF
    return found


def command(image, *words, silence=SILENCE):
    """words: the program's arguments, its name first. silence: million cycles that it may go without a call to its host."""
    return [find(), str(RUNNER), str(PACKAGE), str(silence), str(pathlib.Path(image).resolve()), *words]


def image_of(program, scene=None):
    """The flash with a program that is run without a flash image: bytes. scene: those of the scene partition."""
    data = bytearray(b"\xff" * program.image_size)
    pieces = [*program.segments, *([(program.scene_base, scene)] if scene else [])]
    for address, content in pieces:
        offset = program.offset(address)
        data[offset:offset + len(content)] = content
    return bytes(data)


def read_memory(program, image):
    """The flash as the emulated core reads it, from an image."""
    with scratch.folder("verify") as folder:
        file = folder / "memory.bin"
        try:
            done = children.run(command(image, "--memory", str(file), str(program.image_size)), text=True)
            if done.returncode == 0:
                return file.read_bytes()
        except OSError as error:
            raise ToolError(f"{NAME} could not read the flash back: {error.strerror}", 1) from error
    raise ToolError(f"{NAME} could not read the flash back", 1, done.stderr.strip())
