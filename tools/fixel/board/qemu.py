# SPDX-License-Identifier: MIT
"""QEMU's command line for a board's program, and what it shows of the emulated core."""

import functools
import pathlib
import re
import shutil

from fixel.base import children, scratch
from fixel.board import execute, qmp, rp2040
from fixel.base.errors import ToolError
from fixel.board.symbols import Symbols

QEMU = "qemu-system-arm"
PACKAGES = {QEMU: "qemu-system-arm", "qemu-system-riscv32": "qemu-system-misc"}
ANSWER = 10.0  # seconds of CPU time that a program that hangs may take to answer


def find_qemu(name=QEMU):
    """The path of an emulator. name: a program's emulator."""
    if name == rp2040.NAME:
        return rp2040.find()
    path = shutil.which(name)
    if path is None:
        raise ToolError(f"{name} is not installed: run 'sudo apt-get install {PACKAGES.get(name, name)}'")
    return path


@functools.cache
def version(name=QEMU):
    """What an emulator says of its version."""
    if name == rp2040.NAME:
        return rp2040.version()
    return children.run([find_qemu(name), "--version"], text=True).stdout


def escape(value):
    """A value inside a QEMU option, where a comma separates."""
    return str(value).replace(",", ",,")


def command(program, *options):
    if program.emulator == rp2040.NAME:
        raise ToolError(f"BOARD={program.board} is emulated by {rp2040.NAME}, which only runs a program to its end: "
                        "name a board of QEMU")
    return [find_qemu(program.emulator), *program.qemu, "-display", "none", "-monitor", "none", "-serial", "null",
            "-no-reboot", *options]


def loader(program, image):
    """The flash as an image file has it. A second flash gets the whole file too, so placed that its part of it is where
    it belongs: below there must be nothing, and QEMU drops the rest."""
    file = escape(pathlib.Path(image).resolve())
    return [word for base, _, offset in program.banks
            for word in ("-device", f"loader,file={file},addr={base - offset:#x},force-raw=on")]


def scene_loader(program, file):
    """A file at the scene partition, for a program that is loaded by -kernel."""
    return ["-device", f"loader,file={escape(pathlib.Path(file).resolve())},addr={program.scene_base:#x},force-raw=on"]


def semihosting(arguments):
    words = "".join(f",arg={escape(word)}" for word in arguments)
    return ["-semihosting-config", f"enable=on,target=native{words}"]


def where(channel, program, process):
    """Where the core of a running QEMU is, as lines of text; it is stopped there."""
    try:
        with channel.connect(process, ANSWER) as machine:
            machine.execute("stop", timeout=ANSWER)
            text = machine.monitor("info registers")
    except ToolError as error:
        return f"  the emulator does not say where: {error}"
    found = [re.search(rf"(?:{name})([0-9a-f]{{8}})", text) for name in (r"\bR14=|x1/ra +", r"\bR15=|\bpc +")]
    if None in found:
        return "  the emulator does not say where"
    lr, pc = (int(match[1], 16) for match in found)
    return Symbols(program.path).registers(lr, pc)


def start_stopped(program, options, folder, output, timeout=qmp.TIMEOUT, **how):
    """Starts QEMU in a folder, with the core stopped before its first instruction: (process, Machine). A core that
    runs could fill a FIFO that nobody reads yet, and QEMU answers nothing while the core waits. timeout: for the
    first answer. how: as for subprocess.Popen."""
    with qmp.Channel() as channel:
        process = execute.start(command(program, "-S", *channel.options, *options), folder, output, channel.fds, **how)
        try:
            return process, channel.connect(process.pid, timeout)
        except BaseException:
            execute.kill(process)
            raise


def read_memory(program, image, timeout=30.0):
    """The flash as the emulated core sees it, from an image, before its first
    instruction."""
    if program.emulator == rp2040.NAME:
        return rp2040.read_memory(program, image)
    with scratch.folder("verify") as folder, \
            (folder / "words.txt").open("w+", encoding="utf-8", errors="replace") as words:
        try:
            process, machine = start_stopped(program, loader(program, image), folder, words, timeout)
            try:
                # As the core sees it: not every bus behind it is the system's.
                files = [folder / f"memory-{number}.bin" for number in range(len(program.banks))]
                for file, (base, size, _) in zip(files, program.banks):
                    machine.execute("memsave", timeout, val=base, size=size, filename=str(file))
                machine.quit()
                return b"".join(file.read_bytes() for file in files)
            finally:
                machine.close()
                execute.kill(process)
        except ToolError as error:
            words.seek(0)
            raise ToolError(f"{program.emulator} could not read the flash back: {error.message}", 1,
                            error.words).with_words(words.read().rstrip()) from error
