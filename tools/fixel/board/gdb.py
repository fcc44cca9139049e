# SPDX-License-Identifier: MIT
"""Opens a debugger on a board's program, powered on from its flash image and stopped at main.

QEMU is stopped before the first instruction of the flash image, and GDB has the program's symbols.
"""

import argparse
import contextlib
import pathlib
import shutil
import signal
import socket
import subprocess
import threading
import time

from fixel.base import children, limits, reading, scratch
from fixel.base.errors import ToolError
from fixel.board import boot
from fixel.board.boot import positive
from fixel.commands import late

emulator, execute, firmware, qemu = late("fixel.board", "emulator execute firmware qemu")

GDB = "gdb-multiarch"
ROOT = pathlib.Path(__file__).resolve().parents[3]
PRINTERS = pathlib.Path(__file__).resolve().with_name("gdb_printers.py")
CONNECT = 60.0  # seconds of CPU time that GDB may take to read the symbols
LINGER = 0.5  # seconds that GDB has to thank for the last message


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    made.add_argument("--board", required=True, help="the board of the image and the program")
    made.add_argument("--image", required=True, help="the flash image")
    made.add_argument("--elf", required=True, help="the program that the image holds")
    made.add_argument("--frames", type=positive, help="number of frames (default: the whole path)")
    made.add_argument("--commands", help="a file of GDB commands (default: GDB asks for them)")
    return made


def before(options):
    """Refuses a file of commands that is not there, and a board without a flash image."""
    if options.commands:
        reading.open_regular(options.commands)[0].close()
    boot.before(options)


def main(argv):
    options = parser().parse_args(argv)
    return debug(options.board, options.elf, options.image, options.frames, options.commands)


def find_gdb():
    path = shutil.which(GDB)
    if path is None:
        raise ToolError(f"{GDB} is not installed: run 'sudo apt-get install {GDB}'")
    return path


def gdb_command(program, address, commands):
    """GDB, connected, and the program run to main; then the file of commands,
    after which it ends, or a person."""
    batch = ["-nx", "-batch"] if commands else []
    # The program says where its sources are below the checkout, not where that is.
    start = ["set confirm off", f"directory {ROOT}", f"source {PRINTERS}", "set remotetimeout 20", f"target remote {address}", "tbreak main", "continue"]
    return [find_gdb(), "-q", *batch, *(word for line in start for word in ("-ex", line)),
            *(["-x", str(pathlib.Path(commands).resolve())] if commands else []), str(program.path)]


def accept(listener, debugger):
    """The connection that the debugger makes; None where it ended before."""
    listener.settimeout(0.05)
    limit = limits.Watch(debugger.pid, CONNECT, CONNECT)
    while debugger.poll() is None:
        try:
            return listener.accept()[0]
        except TimeoutError:
            passed = limit.check()
            if passed:
                raise ToolError(f"{GDB} did not connect: {passed}", exit_code=1) from None
    return None


def hold_open(connection, process):
    """Keeps our copy of QEMU's end of the connection for a moment after QEMU has
    ended: GDB answers its last message, and an answer to nobody is an error."""
    def wait():
        process.wait()
        time.sleep(LINGER)
        connection.shutdown(socket.SHUT_RDWR)
        connection.close()

    threading.Thread(target=wait, daemon=True).start()


def start_board(program, image, frames, connection, folder):
    """QEMU, stopped, with the debugger's connection for its own."""
    number = connection.fileno()
    command = qemu.command(program, "-S", "-chardev", f"socket,id=gdb,fd={number}", "-gdb", "chardev:gdb",
                           *emulator.walk_options(program, image, frames))
    # A session of its own: Ctrl-C in the terminal is for the debugger.
    process = children.start(command, cwd=folder, stdin=subprocess.DEVNULL, pass_fds=(number,),
                             start_new_session=True)
    hold_open(connection, process)
    return process


@contextlib.contextmanager
def for_the_debugger():
    """While GDB has the terminal, Ctrl-C is its affair; what else would end us,
    ends GDB and the emulator too."""
    def leave(number, _):
        raise SystemExit(128 + number)

    # A function, not SIG_IGN, which GDB would inherit.
    handlers = {signal.SIGINT: lambda *_: None, signal.SIGTERM: leave, signal.SIGHUP: leave}
    before = {number: signal.signal(number, handler) for number, handler in handlers.items()}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def session(program, image, frames, commands, folder):
    """From GDB's start to its end: its exit code."""
    started = []
    with socket.socket(socket.AF_UNIX) as listener:
        address = pathlib.Path(folder) / "gdb.sock"
        listener.bind(str(address))
        listener.listen(1)
        try:
            debugger = children.start(gdb_command(program, address, commands), signal.SIGTERM)
            started.append(debugger)
            connection = accept(listener, debugger)
            if connection is not None:
                started.append(start_board(program, image, frames, connection, folder))
            code = debugger.wait()
            if connection is not None and started[-1].poll() == 1:
                raise ToolError(f"{qemu.QEMU} did not start; it says above why", exit_code=1)
            return code
        finally:
            for process in started:
                execute.kill(process)


def debug(board, elf, image, frames=None, commands=None):
    """Debugs a board's program until the debugger ends: GDB's exit code."""
    program = firmware.load(elf, board)
    if program.hosted:
        raise ToolError(f"board {firmware.HOST} needs no emulator: run 'gdb --args {elf} SCENE.fxls OUT.fxld'")
    if commands is not None and not pathlib.Path(commands).is_file():
        raise ToolError(f"cannot read the commands in {commands}: there is no such file")
    emulator.check_image(program, image)
    qemu.find_qemu()
    # What the program writes goes there; and nobody else may enter it.
    with scratch.folder("gdb") as folder, for_the_debugger():
        return session(program, pathlib.Path(image), frames, commands, folder)
