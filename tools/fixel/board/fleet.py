# SPDX-License-Identifier: MIT
"""What a board makes of scenes and unit tests: sizes, frames against the host's, stack, instructions."""

import dataclasses
import pathlib
import re

from elftools.elf.elffile import ELFFile

from fixel.base import reading
from fixel.board import counted, dump, emulator, firmware, flash_memory, methods
from fixel.base.errors import ToolError

TIMEOUT = 60.0          # seconds of CPU time without a new frame
STACK = re.compile(r"^stack: (\d+) of (\d+) bytes\b", re.MULTILINE)
RAM_SYMBOLS = ("fxl_stack_limit", "fxl_ram_free", "fxl_ram_end")    # RAM begins with the stack


@dataclasses.dataclass(frozen=True)
class Scene:
    """A scene and what the host makes of it."""
    name: str
    image: pathlib.Path     # .fxls
    host: dump.Dump


@dataclasses.dataclass
class Walk:
    """A scene on a board. why_not: no room for it there. error: it failed."""
    scene: str
    why_not: str | None = None
    error: str | None = None
    frames: int = 0
    instructions_per_frame: int | None = None
    hash_equal: bool | None = None
    first_different: int | None = None  # number of a frame
    stack_bytes: int | None = None      # the deepest that was seen
    stack_reserved: int | None = None


def sizes(elf_path):
    """Flash and RAM of a board's program: what it takes, and what there is.

    RAM is everything that is set aside when it starts, its stacks included."""
    program = firmware.load(elf_path)
    with reading.open_file(elf_path) as file:
        table = ELFFile(file).get_section_by_name(".symtab")
        found = {name: table.get_symbol_by_name(name) for name in RAM_SYMBOLS}
    missing = [name for name, symbols in found.items() if not symbols]
    if missing:
        raise ToolError(f"{elf_path} has no symbol {missing[0]}: linker/sections.ld defines it")
    start, free, end = (found[name][0]["st_value"] for name in RAM_SYMBOLS)
    used = sum(len(content) for _, content in program.segments)
    return {"flash_bytes": used, "flash_size": program.image_size,
            "scene_room": program.scene_size, "ram_bytes": free - start, "ram_size": end - start,
            "ram_free": end - free}


def stack_reserved(elf_path):
    """Bytes that a board's program sets aside for its stack."""
    with reading.open_file(elf_path) as file:
        return ELFFile(file).get_section_by_name(".symtab").get_symbol_by_name("fxl_stack_size")[0]["st_value"]


def walk(board, build, scene, folder):
    """Walks a scene on a board and compares each frame with the host's."""
    result = Walk(scene.name)
    elf = methods.elf_of(board, build)
    room, size = firmware.load(elf, board).scene_size, scene.image.stat().st_size
    if size > room:
        result.why_not = f"the scene has {size:,} bytes, the board's scene partition {room:,}"
        return result
    try:
        _run(result, board, elf, scene, folder)
    except ToolError as error:
        if error.exit_code == emulator.exit_code("CAPACITY"):
            result.why_not = _last_words(error)
        else:
            result.error = str(error)
    return result


def _last_words(error):
    """What the program itself said: the last line of its own that an error quotes, or the last of all."""
    lines = [line.removeprefix("  | ") for line in str(error).splitlines()]
    return next((line for line in reversed(lines) if line.startswith("walk: ")), lines[-1]).removeprefix("walk: ")


def _run(result, board, elf, scene, folder):
    image, file = folder / f"{board}-{scene.name}.bin", folder / f"{board}-{scene.name}.fxld"
    flash_memory.flash(board, elf, scene.image, image)
    done = emulator.run(board, image, elf, file, timeout=TIMEOUT)
    drawn = dump.read_dump(file)
    result.frames = len(drawn.frames)
    result.instructions_per_frame = counted.summary(drawn.frames, firmware.load(elf, board))["instructions_per_frame"]["mean"]
    result.first_different = first_difference(drawn, scene.host)
    result.hash_equal = result.first_different is None
    seen = STACK.search(done.output)
    if seen:
        result.stack_bytes, result.stack_reserved = int(seen[1]), int(seen[2])
    image.unlink()
    file.unlink()


def stack_seen(board, elf, image, folder):
    """The deepest stack of the program that a board saw when it walked a scene; None where it does not say."""
    flashed, file = folder / f"{board}.bin", folder / f"{board}.fxld"
    flash_memory.flash(board, elf, image, flashed)
    seen = STACK.search(emulator.run(board, flashed, elf, file, timeout=TIMEOUT).output)
    return int(seen[1]) if seen else None


def frame_hashes(frames):
    """Of each frame: its pixels, and the pose that they were drawn from."""
    return [(frame.sha256, frame.position, frame.angles) for frame in frames]


def first_difference(drawn, expected):
    """The first frame whose hash or pose is another than expected; None where all are equal."""
    if (drawn.width, drawn.height, drawn.palette.tobytes()) != \
            (expected.width, expected.height, expected.palette.tobytes()):
        return 0
    ours, theirs = frame_hashes(drawn.frames), frame_hashes(expected.frames)
    for number, (one, other) in enumerate(zip(ours, theirs)):
        if one != other:
            return number
    return None if len(ours) == len(theirs) else min(len(ours), len(theirs))
