# SPDX-License-Identifier: MIT
"""A board's persistent flash image: erase, program, verify.

The image file holds the whole flash, byte for byte; an erased byte is 0xFF. It
is replaced in one step, and only by an image that the emulated board has read
back correctly. The host board has no flash: its image is the scene itself.
"""

import dataclasses
import os
import pathlib
import struct
import tempfile
import zlib

from fixel import firmware, qemu
from fixel.errors import ToolError

ERASED = b"\xff"
SCENE_HEAD = struct.Struct("<4sHHII")  # magic, version, header size, image size, CRC-32
SCENE_VERSION = 1
SCENE_HEADER_SIZE = 160


@dataclasses.dataclass(frozen=True)
class Part:
    """Something that was programmed."""

    name: str
    address: int
    size: int
    room: int


@dataclasses.dataclass(frozen=True)
class FlashResult:
    board: str
    image: pathlib.Path
    parts: tuple[Part, ...]
    sectors_erased: int
    sector_size: int
    verified: int  # bytes


def read_scene(path):
    """A scene image from a file, checked so far as flashing needs it: whole,
    undamaged, of our version. What is in it, the board's loader checks."""
    try:
        data = pathlib.Path(path).read_bytes()
    except OSError as error:
        raise ToolError(f"cannot read {path}: {error.strerror}") from error
    if len(data) < SCENE_HEADER_SIZE or data[:4] != b"FXLS":
        raise ToolError(f"{path} is not a scene image: make one with tools/scene.py")
    _, version, header_size, size, crc = SCENE_HEAD.unpack_from(data)
    if version != SCENE_VERSION or header_size != SCENE_HEADER_SIZE:
        raise ToolError(f"{path} is a scene image of version {version} with a header of {header_size} "
                        f"bytes; this tool knows version {SCENE_VERSION} with {SCENE_HEADER_SIZE}: "
                        "make it again with tools/scene.py")
    if size != len(data):
        raise ToolError(f"{path} has {len(data)} bytes but says that it has {size}: "
                        "it is cut off or overgrown, make it again")
    if zlib.crc32(data[16:]) != crc:
        raise ToolError(f"{path} is damaged: its checksum does not match, make it again")
    return data


def check_program(program):
    """Refuses a program that does not lie within flash, below the scene."""
    if not program.segments:
        raise ToolError(f"{program.path} has nothing to program")
    for address, content in program.segments:
        end = address + len(content)
        if address < program.flash_base or end > program.flash_base + program.flash_size:
            raise ToolError(f"{program.path} does not fit: {len(content)} bytes at {address:#x}, flash is "
                            f"{program.flash_base:#x} to {program.flash_base + program.flash_size:#x}")
        if address < program.scene_base + program.scene_size and end > program.scene_base:
            raise ToolError(f"{program.path} reaches into the scene partition: {len(content)} bytes at "
                            f"{address:#x}, the partition begins at {program.scene_base:#x}")


def check_scene_fits(program, scene, path):
    if len(scene) > program.scene_size:
        raise ToolError(f"{path} does not fit: {len(scene)} bytes, the scene partition of board "
                        f"{program.board} has {program.scene_size}")


def read_old(program, image):
    """What the flash holds so far: the image file, or erased flash."""
    try:
        old = pathlib.Path(image).read_bytes()
    except FileNotFoundError:
        return ERASED * program.flash_size
    except OSError as error:
        raise ToolError(f"cannot read {image}: {error.strerror}") from error
    if len(old) != program.flash_size:
        raise ToolError(f"{image} is not a flash image of board {program.board}: {len(old)} bytes, "
                        f"{program.flash_size} expected; delete it to begin with erased flash")
    return old


def program_flash(program, scene, old):
    """Erases the sectors that are touched and programs them: (image, sectors)."""
    data = bytearray(old)
    pieces = [(address - program.flash_base, content)
              for address, content in (*program.segments, (program.scene_base, scene))]
    sector = program.flash_sector
    touched = {number for offset, content in pieces
               for number in range(offset // sector, (offset + len(content) - 1) // sector + 1)}
    for number in touched:
        data[number * sector:(number + 1) * sector] = ERASED * sector
    for offset, content in pieces:
        data[offset:offset + len(content)] = content
    return bytes(data), len(touched)


def verify(program, image, data):
    """Compares what the emulated core reads with what was to be written."""
    seen = qemu.read_memory(program, image)
    if seen == data:
        return len(data)
    at = next((i for i, (a, b) in enumerate(zip(seen, data)) if a != b), min(len(seen), len(data)))
    raise ToolError(f"verification failed at {program.flash_base + at:#x}: "
                    "the board does not read what was written; the old image is unchanged", exit_code=1)


def replace(image, data, check):
    """Writes a file beside the image, checks it and puts it in the image's
    place; on any failure the image stays as it was."""
    temporary = None
    try:
        image.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(prefix=f".{image.name}-", dir=image.parent)
        temporary = pathlib.Path(name)
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        temporary.chmod(0o644)  # mkstemp lets nobody else read
        result = check(temporary)
        os.replace(temporary, image)
        temporary = None
        return result
    except OSError as error:
        raise ToolError(f"cannot write {image}: {error.strerror}") from error
    finally:
        if temporary is not None:
            temporary.unlink(missing_ok=True)


def flash(board, elf, scene, image):
    """Programs a board's image with a program and a scene; a FlashResult.
    Everything is checked before anything is written."""
    image = pathlib.Path(image)
    program = firmware.load(elf, board)
    scene_bytes = read_scene(scene)
    if program.hosted:
        def read_back(path):
            if path.read_bytes() != scene_bytes:
                raise ToolError(f"verification failed: {path} does not hold what was written", exit_code=1)
            return len(scene_bytes)

        verified = replace(image, scene_bytes, read_back)
        return FlashResult(board, image, (Part("scene", 0, len(scene_bytes), len(scene_bytes)),), 0, 0, verified)
    check_program(program)
    check_scene_fits(program, scene_bytes, scene)
    data, sectors = program_flash(program, scene_bytes, read_old(program, image))
    verified = replace(image, data, lambda path: verify(program, path, data))
    low = min(address for address, _ in program.segments)
    high = max(address + len(content) for address, content in program.segments)
    parts = (Part("program", low, high - low, program.scene_base - program.flash_base),
             Part("scene", program.scene_base, len(scene_bytes), program.scene_size))
    return FlashResult(board, image, parts, sectors, program.flash_sector, verified)
