# SPDX-License-Identifier: MIT
"""Powering on a board: QEMU for an emulated one, the program itself for the host.

An emulator's exit code alone proves nothing: a reset and a SIGTERM give 0, a
lockup 134, a hang none at all. A run has succeeded only if the agreed exit code
of boards/contract/system.h came AND the end marker was printed AND the dump is
whole.
"""

import dataclasses
import json
import os
import pathlib
import re
import shutil
import signal
import struct
import subprocess
import tempfile
import time
import zlib

from fixel import firmware
from fixel.errors import ToolError

QEMU = "qemu-system-arm"
CONTRACT = pathlib.Path(__file__).resolve().parents[2] / "boards" / "contract" / "system.h"
DUMP_NAME = "frames.fxld"  # as the boards write it, in the directory they start in
MARKER = re.compile(r"^walk: done (\d+) frames$", re.MULTILINE)
UNIT_MARKER = "unittest: done"
LOCKUP = 134  # QEMU aborts
HEAD = struct.Struct("<4sHHHHI768s")
DUMP_VERSION = 2
FRAME_EXTRA = 32 + 48  # bytes around a frame's pixels
TAIL = struct.Struct("<4sII")
OUTPUT_MAX = 1 << 20  # bytes of text from a board
POLL = 0.02  # seconds


@dataclasses.dataclass(frozen=True)
class Ending:
    """How a program ended: its exit code (negative: a signal; None: it was
    stopped, because of why), all that it printed, and after how long."""

    code: int | None
    output: str
    why: str
    seconds: float


@dataclasses.dataclass(frozen=True)
class RunResult:
    board: str
    cpu: str
    frames: int
    seconds: float
    output: str


def exit_meanings():
    """The table of exit codes, read from the board contract: code -> sentence."""
    pattern = re.compile(r"^\s*(SYSTEM_EXIT_\w+) = (\d+),?\s*/\* (.*?) \*/", re.MULTILINE)
    rows = pattern.findall(CONTRACT.read_text(encoding="utf-8"))
    return {int(number): (name, sentence) for name, number, sentence in rows}


def exit_code(name):
    """The number of SYSTEM_EXIT_<name>."""
    for number, (full, _) in exit_meanings().items():
        if full == f"SYSTEM_EXIT_{name}":
            return number
    raise KeyError(name)


def find_qemu():
    path = shutil.which(QEMU)
    if path is None:
        raise ToolError(f"{QEMU} is not installed: run 'sudo apt-get install qemu-system-arm'")
    return path


def escape(value):
    """A value inside a QEMU option, where a comma separates."""
    return str(value).replace(",", ",,")


def qemu_command(program, *options):
    return [find_qemu(), *program.qemu, "-display", "none", "-monitor", "none", "-serial", "null",
            "-no-reboot", *options]


def loader(program, image):
    return ["-device",
            f"loader,file={escape(pathlib.Path(image).resolve())},addr={program.flash_base:#x},force-raw=on"]


def semihosting(arguments):
    words = "".join(f",arg={escape(word)}" for word in arguments)
    return ["-semihosting-config", f"enable=on,target=native{words}"]


def kill(process):
    """SIGKILL: QEMU answers SIGTERM with exit code 0."""
    if process.poll() is None:
        process.kill()
    process.wait()


def execute(command, directory, timeout, watch=None):
    """Runs a command in a directory until it ends, or until timeout seconds
    passed without news, or until watch objects. watch() answers (news, objection):
    something that changes as long as the program gets on, and a sentence or None."""
    log = pathlib.Path(directory) / "output.txt"
    started = last = time.monotonic()
    seen, why = None, ""
    with log.open("wb") as output:
        try:
            process = subprocess.Popen(command, cwd=directory, stdin=subprocess.DEVNULL,
                                       stdout=output, stderr=subprocess.STDOUT)
        except OSError as error:
            raise ToolError(f"cannot start {command[0]}: {error.strerror}") from error
        try:
            while process.poll() is None and not why:
                time.sleep(POLL)
                news, why = watch() if watch else (None, None)
                now = time.monotonic()
                if news != seen:
                    seen, last = news, now
                if not why and now - last > timeout:
                    why = f"nothing new came for {timeout:g} s: it hangs"
                if not why and log.stat().st_size > OUTPUT_MAX:
                    why = "it prints without end"
            stopped = process.poll() is None
        finally:
            kill(process)
    with log.open("rb") as output:
        text = output.read(OUTPUT_MAX).decode("utf-8", "replace")
    return Ending(None if stopped else process.returncode, text, why if stopped else "",
                  time.monotonic() - started)


def describe(ending):
    """What an ending was, in words."""
    meanings = exit_meanings()
    if ending.code is None:
        return ending.why
    if ending.code == LOCKUP or ending.code == -signal.SIGABRT:
        return "the core locked up (a fault inside a fault handler)"
    if ending.code < 0:
        return f"it was ended by signal {-ending.code}"
    if ending.code == 0:
        return "the emulator ended without the program's exit code: a reset, or it was terminated"
    if ending.code in meanings:
        return f"exit {ending.code}: {meanings[ending.code][1]}"
    return f"exit {ending.code}, which no program of ours gives"


def last_lines(text, count=30):
    lines = text.strip().splitlines()[-count:]
    return "".join(f"\n  | {line}" for line in lines)


def require_done(ending, agreed, marker, board):
    """The marker's match, or an error that says what came instead."""
    match = marker.search(ending.output)
    if ending.code == agreed and match:
        return match
    what = describe(ending)
    if ending.code == agreed:
        what = "it ended as agreed but did not print its end marker"
    elif ending.code == 0 and board == firmware.HOST:
        what = "it ended without its end marker"
    raise ToolError(f"board {board} failed: {what}{last_lines(ending.output)}", exit_code=1)


def dump_shape(path):
    """(frames, bytes) that a dump's head announces; None before it is there."""
    try:
        with open(path, "rb") as file:
            head = file.read(HEAD.size)
    except OSError:
        return None
    if len(head) < HEAD.size:
        return None
    magic, version, width, height, _, frames, _ = HEAD.unpack(head)
    if magic != b"FXLD" or version != DUMP_VERSION:
        return None
    return frames, HEAD.size + frames * (width * height + FRAME_EXTRA) + TAIL.size


def check_dump(path, frames):
    """Whether a dump is whole: length, tail, checksum."""
    shape = dump_shape(path)
    if shape is None:
        raise ToolError("the board was done but left no frame dump", exit_code=1)
    if shape[0] != frames or path.stat().st_size != shape[1]:
        raise ToolError(f"the board's dump is not whole: {path.stat().st_size} bytes, "
                        f"{shape[1]} expected for {shape[0]} frames", exit_code=1)
    crc = 0
    left = shape[1] - 4
    with path.open("rb") as file:
        while left > 0:
            block = file.read(min(left, 1 << 20))
            crc = zlib.crc32(block, crc)
            left -= len(block)
        (stated,) = struct.unpack("<I", file.read(4))
    if stated != crc:
        raise ToolError("the board's dump is damaged: its checksum does not match", exit_code=1)


def dump_watch(path, progress):
    """A watch for execute: news is the dump's size."""
    shape = None

    def watch():
        nonlocal shape
        part = path.with_name(path.name + ".part")  # the host's name for it
        current = part if part.exists() else path
        shape = shape or dump_shape(current)
        size = current.stat().st_size if current.exists() else 0
        if shape is None:
            return size, None
        frames, total = shape
        if progress:
            each = max(1, (total - HEAD.size - TAIL.size) // max(1, frames))
            progress(min(frames, max(0, size - HEAD.size) // each), frames)
        return size, "it writes more than it announced" if size > total else None

    return watch


def check_image(program, image):
    """Refuses an image that does not hold this very program."""
    try:
        data = pathlib.Path(image).read_bytes()
    except OSError as error:
        raise ToolError(f"cannot read the flash image {image}: {error.strerror}; "
                        f"run 'make flash BOARD={program.board}'") from error
    if program.hosted:
        return
    if len(data) != program.flash_size:
        raise ToolError(f"{image} is not a flash image of board {program.board}: "
                        f"{len(data)} bytes, {program.flash_size} expected")
    for address, content in program.segments:
        offset = address - program.flash_base
        if data[offset:offset + len(content)] != content:
            raise ToolError(f"{image} does not hold {program.path}: "
                            f"run 'make flash BOARD={program.board}'")


def work_directory(dump):
    """A directory beside the dump, so that a rename can put it in place."""
    try:
        dump.parent.mkdir(parents=True, exist_ok=True)
        if dump.is_dir():
            raise ToolError(f"cannot write {dump}: it is a directory")
        return tempfile.TemporaryDirectory(prefix=".boot-", dir=dump.parent)
    except OSError as error:
        raise ToolError(f"cannot write into {dump.parent}: {error.strerror}") from error


def boot_command(program, image, frames, live, extra):
    if program.hosted:
        return [str(program.path.resolve()), str(image.resolve()), DUMP_NAME, str(frames or 0)]
    words = ["walk"] + ([f"frames={frames}"] if frames else []) + (["live"] if live else [])
    return qemu_command(program, "-icount", "shift=0", *semihosting([*words, *extra]),
                        *loader(program, image))


def run(board, image, elf, dump, frames=None, timeout=60.0, progress=None, live=False, extra=()):
    """Powers a board on from its flash image and fetches its frame dump.

    frames: how many, None or 0 for the whole path. timeout: seconds without
    anything new in the dump after which the board counts as hung.
    progress(done, total) is called as frames come. extra: more words for the
    program. Answers a RunResult, or raises ToolError and leaves the dump as it
    was before.
    """
    image, dump = pathlib.Path(image), pathlib.Path(dump)
    program = firmware.load(elf, board)
    check_image(program, image)
    agreed = 0 if program.hosted else exit_code("DONE")
    with work_directory(dump) as directory:
        part = pathlib.Path(directory) / DUMP_NAME
        ending = execute(boot_command(program, image, frames, live, extra), directory, timeout,
                         dump_watch(part, progress))
        marker = require_done(ending, agreed, MARKER, board)
        done = int(marker.group(1))
        if frames and done != frames:
            raise ToolError(f"board {board} drew {done} frames, {frames} were asked for", exit_code=1)
        check_dump(part, done)
        if progress:
            progress(done, done)
        try:
            os.replace(part, dump)
        except OSError as error:
            raise ToolError(f"cannot write {dump}: {error.strerror}") from error
    return RunResult(program.board, program.cpu, done, ending.seconds, ending.output)


def run_text(elf, arguments=(), timeout=60.0, icount=True):
    """Runs a program without a flash image, for what it prints; an Ending."""
    program = firmware.load(elf)
    count = ["-icount", "shift=0"] if icount else []
    with tempfile.TemporaryDirectory(prefix="fixel-") as directory:
        return execute(qemu_command(program, *count, *semihosting(arguments),
                                    "-kernel", str(program.path.resolve())), directory, timeout)


def run_unit(elf, timeout=300.0):
    """Runs one Unity program on its emulated board: (passed, failed, output).

    A program that does not get to its end counts as one failure more; the
    output then ends with a line that says why."""
    ending = run_text(elf, ["unittest"], timeout, icount=False)
    passed = len(re.findall(r":PASS\s*$", ending.output, re.MULTILINE))
    failed = len(re.findall(r":FAIL\b", ending.output))
    expected = exit_code("TEST") if failed else exit_code("DONE")
    if ending.code == expected and UNIT_MARKER in ending.output:
        return passed, failed, ending.output
    return passed, failed + 1, f"{ending.output}\n{elf}: {describe(ending)}\n"


def read_memory(program, image, timeout=30.0):
    """The flash as the emulated core sees it, from an image, before its first
    instruction."""
    with tempfile.TemporaryDirectory(prefix="fixel-") as directory:
        saved = pathlib.Path(directory) / "memory.bin"
        requests = [{"execute": "qmp_capabilities"},
                    {"execute": "pmemsave", "arguments": {"val": program.flash_base,
                                                          "size": program.flash_size,
                                                          "filename": str(saved)}},
                    {"execute": "quit"}]
        command = qemu_command(program, "-S", "-qmp", "stdio", *loader(program, image))
        try:
            result = subprocess.run(command, input="".join(json.dumps(r) + "\n" for r in requests),
                                    capture_output=True, text=True, timeout=timeout, check=False)
        except subprocess.TimeoutExpired as error:
            raise ToolError(f"{QEMU} did not answer within {timeout:g} s", exit_code=1) from error
        if '"error"' in result.stdout or not saved.exists():
            raise ToolError(f"{QEMU} could not read the flash back"
                            f"{last_lines(result.stderr or result.stdout)}", exit_code=1)
        return saved.read_bytes()
