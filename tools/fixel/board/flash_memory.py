# SPDX-License-Identifier: MIT
"""A board's persistent flash image: erase, program, verify.

The image file holds the whole flash, byte for byte; an erased byte is 0xFF. It
is replaced in one step, and only by an image that the emulated board has read
back correctly. The host board has no flash: its image is the scene itself.
"""

import dataclasses
import itertools
import pathlib
import zlib

from fixel.base import output, reading
from fixel.board import firmware, qemu, room
from fixel.base.errors import ToolError
from fixel.board.flash_image import ERASED, read_old, replace
from fixel.image.fields import HEAD, IMAGE_MAX, MAGIC, VERSION
from fixel.scene import target


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
    sectors_erased: tuple[int, ...]  # the size of each
    verified: int  # bytes
    uf2: int = 0    # as of firmware.Program


def read_scene(path):
    """A scene image from a file, checked so far as flashing needs it: whole,
    undamaged, of our version. What is in it, the board's loader checks."""
    try:
        found = output.not_a_file(path)
    except OSError as error:
        raise ToolError(f"cannot read {path}: {error.strerror}") from error
    if found:
        raise ToolError(f"cannot read {path}: it is {found}; name a scene image")
    data = reading.read_whole(path, IMAGE_MAX, "make it with tools/scene.py")
    if len(data) < HEAD.size or data[:4] != MAGIC:
        raise ToolError(f"{path} is not a scene image: make one with tools/scene.py")
    _, version, _, size, crc, *_ = HEAD.unpack_from(data)
    if version != VERSION:
        raise ToolError(f"{path} is a scene image of version {version}; this tool knows version {VERSION}: build it again "
                        "with tools/scene.py")
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


def check_partition(program):
    """Refuses a map on which erasing the scene would erase something else."""
    if program.offset(program.scene_base) not in sector_starts(program):
        raise ToolError(f"{program.path}: the scene partition at {program.scene_base:#x} does not begin with a "
                        "sector of the flash; BOARD_MEMORY in its board.mk must place it so")


def check_scene_fits(program, scene, path):
    if len(scene) > program.scene_size:
        larger = room.boards_for_scene(len(scene))
        raise ToolError(f"{path} does not fit: {len(scene)} bytes, the scene partition of board "
                        f"{program.board} has {program.scene_size}; a model may have fewer faces (--simplify)"
                        f"{', and the boards with the room are ' if larger else ''}{', '.join(larger)}")


def sector_starts(program):
    """The offset of each sector of the flash, and the flash's end."""
    return [0, *itertools.accumulate(program.sectors)]


def program_flash(program, scene, old):
    """Erases the sectors that are touched and programs them: (image, sizes of
    these sectors)."""
    data = bytearray(old)
    pieces = [(program.offset(address), content)
              for address, content in (*program.segments, (program.scene_base, scene))]
    touched = [(start, end) for start, end in itertools.pairwise(sector_starts(program))
               if any(offset < end and offset + len(content) > start for offset, content in pieces)]
    for start, end in touched:
        data[start:end] = ERASED * (end - start)
    for offset, content in pieces:
        data[offset:offset + len(content)] = content
    return bytes(data), tuple(end - start for start, end in touched)


def verify(program, image, data):
    """Compares what the emulated core reads with what was to be written."""
    seen = qemu.read_memory(program, image)
    if seen == data:
        return len(data)
    at = next((i for i, (a, b) in enumerate(zip(seen, data)) if a != b), min(len(seen), len(data)))
    raise ToolError(f"verification failed at {program.address(at):#x}: "
                    "the board does not read what was written; the old image is unchanged", exit_code=1)


def prepare(board, elf, scene):
    """Everything that can be refused before anything is written: the program
    and the scene's bytes, both read and found to fit the board."""
    program = firmware.load(elf, board)
    scene_bytes = read_scene(scene)
    if not program.hosted:
        check_program(program)
        check_partition(program)
        check_scene_fits(program, scene_bytes, scene)
    return program, scene_bytes


def parts_of(program, scene):
    low = min(address for address, _ in program.segments)
    high = max(address + len(content) for address, content in program.segments)
    room = (program.scene_base if program.offset(program.scene_base) < program.flash_size
            else program.flash_base + program.flash_size) - program.flash_base
    return (Part("program", low, high - low, room),
            Part("scene", program.scene_base, len(scene), program.scene_size))


def flash_host(program, scene, image):
    def read_back(path):
        if path.read_bytes() != scene:
            raise ToolError(f"verification failed: {path} does not hold what was written", exit_code=1)
        return len(scene)

    verified = replace(image, scene, read_back)
    return FlashResult(program.board, image, (Part("scene", 0, len(scene), len(scene)),), (), verified)


def flash(board, elf, scene, image):
    """Programs a board's image with a program and a scene; a FlashResult.
    Everything is checked before anything is written."""
    image = pathlib.Path(image)
    program, scene_bytes = prepare(board, elf, scene)
    if program.hosted:
        return flash_host(program, scene_bytes, image)
    data, sectors = program_flash(program, scene_bytes, read_old(program, image))
    verified = replace(image, data, lambda path: verify(program, path, data))
    return FlashResult(board, image, parts_of(program, scene_bytes), sectors, verified, program.uf2)


def retargeted(board, elf, image, asked, folder):
    """A copy of a flash image, in folder, whose scene is drawn as something else. asked: a target.Target."""
    program, copy = firmware.load(elf, board), folder / "asked.bin"
    data = bytearray(reading.read_whole(image, max(program.image_size, IMAGE_MAX), f"run 'make flash BOARD={board}'"))
    start = 0 if program.hosted else program.offset(program.scene_base)
    end = len(data) if program.hosted else start + program.scene_size
    data[start:end] = target.rewritten(bytes(data[start:end]), asked, f"the scene in {image}")
    output.write_file(copy, bytes(data))
    return copy
