# SPDX-License-Identifier: MIT
"""Powering on a board: QEMU or rp2040js for an emulated one, the program itself for the host.

A run has succeeded only if it ended as fixel.board.execute demands AND its dump is
whole.
"""

import contextlib
import dataclasses
import os
import pathlib
import re

from fixel.base import output, reading, scratch
from fixel.board import dump as dump_file, firmware, qemu, rp2040, wires
from fixel.board.execute import CONTRACT, describe, Ending, execute, exit_code, exit_meanings, OUTPUT_MAX, require_done
from fixel.base.errors import ToolError
from fixel.image.fields import IMAGE_MAX
from fixel.board.qemu import find_qemu
from fixel.board.symbols import Symbols

# What its callers need of the parts.
__all__ = ["CONTRACT", "Ending", "OUTPUT_MAX", "RunResult", "check_image", "describe", "emulate", "exit_code",
           "exit_meanings", "find_qemu", "run", "run_text", "walk_options"]

DUMP_NAME = "frames.fxld"  # as the boards write it, in the directory they start in
MARKER = re.compile(r"^(?:walk|own): done (\d+) frames$", re.MULTILINE)


@dataclasses.dataclass(frozen=True)
class RunResult:
    board: str
    cpu: str
    frames: int
    seconds: float
    output: str


def emulate(program, options, directory, timeout, watch=None):
    """Runs a program on its emulated board; an Ending, in which the functions
    of a fault or a hang are named."""
    with qemu.Channel() as channel:
        command = qemu.command(program, *options, *channel.options)
        ending = execute(command, directory, timeout, watch, channel.fds,
                         lambda process: qemu.where(channel, program, process))
    return dataclasses.replace(ending, output=Symbols(program.path).name_faults(ending.output))


def check_image(program, image):
    """Refuses an image that does not hold this very program."""
    try:
        file = reading.open_file(image)
    except ToolError as error:
        raise ToolError(f"cannot read the flash image: {error.message}; run 'make flash BOARD={program.board}'") from error
    with file:
        size = os.fstat(file.fileno()).st_size
        if program.hosted:      # it reads the scene image itself, and refuses what is none
            if size > IMAGE_MAX:
                raise ToolError(f"{image} is no scene image: {size:,} bytes are more than its limit of {IMAGE_MAX:,}")
            return
        if size != program.image_size:
            raise ToolError(f"{image} is not a flash image of board {program.board}: "
                            f"{size} bytes, {program.image_size} expected")
        data = file.read(size)
    for address, content in program.segments:
        offset = program.offset(address)
        if data[offset:offset + len(content)] != content:
            raise ToolError(f"{image} does not hold {program.path}: "
                            f"run 'make flash BOARD={program.board}'")


@contextlib.contextmanager
def work_directory(dump):
    """A directory beside the dump, so that a rename can put it in place."""
    with contextlib.ExitStack() as stack:
        try:
            dump.parent.mkdir(parents=True, exist_ok=True)
            folder = stack.enter_context(scratch.folder("boot", dump.parent))
        except OSError as error:
            raise ToolError(f"cannot write into {dump.parent}: {error.strerror}") from error
        yield folder


def emulate_pico(program, image, words, directory, timeout, watch=None, silence=rp2040.SILENCE):
    """As emulate, by rp2040js, from a flash image. words, silence: as for rp2040.command."""
    ending = execute(rp2040.command(image, *words, silence=silence), directory, timeout, watch)
    return dataclasses.replace(ending, output=Symbols(program.path).name_faults(ending.output))


def walk_words(frames=None, live=False, extra=()):
    """The arguments of the walk."""
    return ["walk", *([f"frames={frames}"] if frames else []), *(["live"] if live else []), *extra]


def walk_options(program, image, frames=None, live=False, extra=()):
    """What QEMU is told to walk from a flash image."""
    return ["-icount", "shift=0", *qemu.semihosting(walk_words(frames, live, extra)), *qemu.loader(program, image)]


def live_command(program, image, frames, keys):
    """The host's walk while a player walks, in the folder of its FIFO and of the file of keys."""
    return [str(program.path.resolve()), str(pathlib.Path(image).resolve()), DUMP_NAME, str(frames), keys]


def power_on(program, image, frames, timeout, live, extra, directory, watch):
    if program.hosted:
        command = [str(program.path.resolve()), str(image.resolve()), DUMP_NAME, str(frames or 0)]
        return execute(command, directory, timeout, watch)
    if program.emulator == rp2040.NAME:
        return emulate_pico(program, image, walk_words(frames, live, extra), directory, timeout, watch)
    return emulate(program, walk_options(program, image, frames, live, extra), directory, timeout, watch)


def put_in_place(part, target):
    """A whole file of a run that succeeded."""
    try:
        output.move(part, target)
    except FileNotFoundError as error:
        raise ToolError(f"the board was done but left no {part.name}", exit_code=1) from error
    except OSError as error:
        raise ToolError(f"cannot write {target}: {error.strerror}") from error


def run(board, image, elf, dump, frames=None, timeout=60.0, progress=None, live=False, extra=(), record=None, at_most=False):
    """Powers a board on from its flash image and fetches its frame dump, and the record of its display's wires
    where one is wanted.

    frames: how many, None or 0 for the whole path. timeout: seconds of CPU
    time, or of sleep, without anything new in the dump after which the board counts as hung.
    progress(done, total) is called as frames come. extra: more words for the
    program. record: where the wires' is to be. at_most: it may draw fewer frames than it is asked for. Answers a RunResult, or raises ToolError and leaves the dump as it
    was before.
    """
    image, dump = pathlib.Path(image), output.target_of(dump)
    program = firmware.load(elf, board)
    check_image(program, image)
    output.refuse_input(dump, dump)     # before the board's time is spent
    agreed = 0 if program.hosted else exit_code("DONE")
    with work_directory(dump) as directory:
        part = directory / DUMP_NAME
        ending = power_on(program, image, frames, timeout, live, extra, directory,
                          dump_file.watch(part, progress))
        marker = require_done(ending, agreed, MARKER, board)
        done = int(marker.group(1))
        if frames and (done > frames if at_most else done != frames):
            raise ToolError(f"board {board} drew {done} frames, {frames} were asked for", exit_code=1)
        dump_file.check(part, done)
        if progress:
            progress(done, done)
        put_in_place(part, dump)
        if record:
            put_in_place(directory / wires.NAME, record)
    return RunResult(program.board, program.cpu, done, ending.seconds, ending.output)


def run_text(elf, arguments=(), timeout=60.0, icount=True, scene=None, extra=()):
    """Runs a program without a flash image, for what it prints; an Ending. scene: a file for the scene partition. extra: options of QEMU."""
    program = firmware.load(elf)
    if program.emulator == rp2040.NAME:
        return run_pico_text(program, arguments, timeout, scene)
    options = [*(["-icount", "shift=0"] if icount else []), *qemu.semihosting(arguments),
               *(qemu.scene_loader(program, scene) if scene else []), *extra, "-kernel", str(program.path.resolve())]
    with scratch.folder("board") as directory:
        return emulate(program, options, directory, timeout)


def run_pico_text(program, arguments, timeout, scene):
    """run_text on the board pico, which boots from a flash image made for it."""
    with scratch.folder("board") as directory:
        image = directory / "flash.bin"
        image.write_bytes(rp2040.image_of(program, pathlib.Path(scene).read_bytes() if scene else None))
        return emulate_pico(program, image, arguments, directory, timeout, silence=rp2040.SILENCE_OF_TESTS)
