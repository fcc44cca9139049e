# SPDX-License-Identifier: MIT
"""QEMU's command line for a board's program, what it shows of the emulated core, and talk to a running QEMU by its machine protocol:
keys, pictures, registers.

    with qemu.Channel() as channel:
        process = children.start([*command, *channel.options], pass_fds=channel.fds)
        with channel.connect(process.pid) as machine:
            machine.key("up", down=True)
            machine.screendump("screen.png")
            machine.quit()

A channel is a pair of connected sockets, one of which QEMU inherits: there is no address at which anybody else could reach it,
and nothing to clean up. The protocol is the package qemu.qmp's, whose interface is asynchronous; here every call waits for its
answer, has a limit, and may come from any thread. The limit is CPU time or sleep of QEMU (fixel.base.limits).
"""

import asyncio
import concurrent.futures
import functools
import logging
import pathlib
import re
import shutil
import socket
import threading

from qemu.qmp import ExecuteError, QMPClient, QMPError

from fixel.base import children, limits, scratch
from fixel.base.errors import ToolError
from fixel.board import execute, rp2040
from fixel.board.symbols import Symbols

QEMU = "qemu-system-arm"
PACKAGES = {QEMU: "qemu-system-arm", "qemu-system-riscv32": "qemu-system-misc"}
ANSWER = 10.0  # seconds of CPU time that a program that hangs may take to answer
TIMEOUT = 10.0  # seconds for an answer
POLL = 0.05

# The package logs what it also raises.
logging.getLogger("qemu.qmp").addHandler(logging.NullHandler())
logging.getLogger("qemu.qmp").propagate = False


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


def start_stopped(program, options, folder, output, timeout=TIMEOUT, **how):
    """Starts QEMU in a folder, with the core stopped before its first instruction: (process, Machine). A core that
    runs could fill a FIFO that nobody reads yet, and QEMU answers nothing while the core waits. timeout: for the
    first answer. how: as for subprocess.Popen."""
    with Channel() as channel:
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


def _complain(loop, context):
    """Says what nobody waited for, but for what close() cancelled, since Python 3.13 the package
    leaves that behind, and for the end of the connection: every command that waits is told of it,
    and after an interrupt there may be none."""
    if not isinstance(context.get("exception"), (asyncio.CancelledError, EOFError, ConnectionError)):
        loop.default_exception_handler(context)


class Channel:
    """The wire between this process and a QEMU that is about to be started."""

    def __init__(self):
        self._ours, self._theirs = socket.socketpair(socket.AF_UNIX)

    @property
    def fds(self):
        """What QEMU must inherit: pass_fds of subprocess.Popen."""
        return (self._theirs.fileno(),)

    @property
    def options(self):
        """What QEMU must be told."""
        return ["-chardev", f"socket,id=qmp,fd={self._theirs.fileno()}", "-mon", "chardev=qmp,mode=control"]

    def connect(self, process, timeout=TIMEOUT):
        """The Machine at the other end. To be called once, after QEMU was started as that process."""
        self._theirs.close()  # QEMU has its own: when it ends, we see it
        connection, self._ours = self._ours, None
        return Machine(connection, process, timeout)

    def close(self):
        for end in (self._ours, self._theirs):
            if end is not None:
                end.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


class Machine:
    """A running QEMU. What goes wrong is a ToolError that names the command."""

    def __init__(self, connection, process, timeout=TIMEOUT):
        self.timeout = timeout
        self._process = process
        self._loop = asyncio.new_event_loop()
        self._loop.set_exception_handler(_complain)
        self._thread = threading.Thread(target=self._loop.run_forever, name="qmp", daemon=True)
        self._thread.start()
        self._client = None
        try:
            self._client = self._wait("greeting", self._connect(connection), timeout)
        except BaseException:
            self.close()
            connection.close()
            raise

    @staticmethod
    async def _connect(connection):
        client = QMPClient("fixel")
        await client.connect(connection)
        return client

    def _begin(self, coroutine):
        """A Future of the outcome of a coroutine, which runs in the thread of the loop."""
        return asyncio.run_coroutine_threadsafe(coroutine, self._loop)

    @staticmethod
    def _outcome(what, future):
        try:
            return future.result()
        except ExecuteError as error:
            raise ToolError(f"QEMU refuses '{what}': {error}", exit_code=1) from error
        except (QMPError, OSError, EOFError, concurrent.futures.CancelledError) as error:
            raise ToolError(f"QEMU was gone before it answered '{what}'", exit_code=1) from error

    def _wait(self, what, coroutine, timeout):
        future = self._begin(coroutine)
        try:
            limits.wait_for(future, self._process, timeout)
        except limits.LimitError as error:
            raise ToolError(f"QEMU did not answer '{what}': {error}", exit_code=1) from error
        finally:
            future.cancel()  # after an interrupt nobody waits for it any more
        return self._outcome(what, future)

    def execute(self, command, /, timeout=None, **arguments):
        """What QEMU answers to a command of its machine protocol."""
        return self._wait(command, self._client.execute(command, arguments or None), timeout or self.timeout)

    def resume(self):
        """Lets the core run, and waits for nothing: a core that writes into a full FIFO stops QEMU until somebody
        reads, so whoever is to read must not wait for an answer before. To be called for what became of it: None
        while there is no answer; ToolError where QEMU refused, or was gone."""
        future = self._begin(self._client.execute("cont"))
        return lambda: self._outcome("cont", future) if future.done() else None

    def monitor(self, line):
        """What QEMU answers to a line of its monitor for people, as text."""
        return self.execute("human-monitor-command", **{"command-line": line})

    def keys(self, released, pressed):
        """Releases and presses keys, all at the same moment: QKeyCodes such as "up", "ctrl", "a"."""
        events = [{"type": "key", "data": {"down": down, "key": {"type": "qcode", "data": code}}}
                  for down, codes in ((False, released), (True, pressed)) for code in sorted(codes)]
        self.execute("input-send-event", events=events)

    def key(self, code, down):
        """Presses or releases a key."""
        self.keys(*((), (code,)) if down else ((code,), ()))

    def screendump(self, path):
        """A picture of the emulated screen, as PNG."""
        path = pathlib.Path(path).resolve()
        self.execute("screendump", filename=str(path), format="png")
        return path

    def quit(self):
        """Ends QEMU. It may be gone before it has answered."""
        try:
            self.execute("quit")
        except ToolError:
            pass
        self.close()

    def close(self):
        """Ends the connection, and leaves QEMU running."""
        if self._loop.is_closed():
            return
        if self._client is not None:
            try:
                self._wait("disconnect", self._client.disconnect(), self.timeout)
            except ToolError:
                pass  # it ended badly because QEMU was gone
        asyncio.run_coroutine_threadsafe(self._cancel_all(), self._loop).result()
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    @staticmethod
    async def _cancel_all():
        """Ends what is still waiting, as after an interrupt."""
        tasks = asyncio.all_tasks() - {asyncio.current_task()}
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
