# SPDX-License-Identifier: MIT
"""Tools' processes without the time that Python takes to import their packages: half a second, a thousand times.

A server imports what most tools import, and runs nothing. For each command it forks: the copy gets the command's words,
environment and output, runs the tool's program, and ends as a program does. So no command sees what another,
or a test, has changed. test_warm_start.py compares such processes with those that Python starts from nothing.
Under make test the server is a fork of the process that has imported all this already (fixel.check.pytest_server)."""

import atexit
import contextlib
import gc
import json
import os
import pathlib
import runpy
import socket
import subprocess
import sys
import tempfile
import threading

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"
PRELOADED = ("numpy", "PIL.Image", "elftools.elf.elffile", "fixel.scene.summary", "fixel.scene.texture",
             "fixel.board.judged_run", "fixel.board.flashing")
REQUEST_MAX = 100_000    # characters
# A process reads these when Python starts.
READ_AT_START = ("PYTHON", "LC_", "LANG", "OPENBLAS", "LD_")


# --- the server ---------------------------------------------------------------

def preload():
    """Imports what most tools import."""
    sys.path.insert(0, str(TOOLS))
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    for name in PRELOADED:
        __import__(name)
    gc.freeze()     # what a fork collects, it copies


def serve(channel):
    """Answers requests until the channel ends. It comes back in the fork that has run a tool's program alone."""
    while True:
        request, handles, _, _ = socket.recv_fds(channel, 2 * REQUEST_MAX, 2)
        if not request:
            os._exit(0)     # to put all modules away takes a tenth of a second
        asked = json.loads(request)
        child = os.fork()
        if child == 0:
            channel.close()
            _become(asked, handles)     # where it does not end this process, as a tool does, the caller does
            return
        for handle in handles:
            os.close(handle)
        _, status = os.waitpid(child, 0)
        channel.sendall(json.dumps(os.waitstatus_to_exitcode(status)).encode())


def _become(asked, handles):
    for number, handle in enumerate(handles, 1):
        os.dup2(handle, number)
        os.close(handle)
    os.environ.clear()
    os.environ.update(asked["environment"])
    os.chdir(asked["folder"])
    sys.argv[:] = asked["words"]
    if asked["program"]:
        sys.argv[0] = "-c"
        exec(compile(asked["program"], "<string>", "exec"), {"__name__": "__main__"})
    else:
        runpy.run_path(sys.argv[0], run_name="__main__")


# --- its client ---------------------------------------------------------------

class _Client:
    """The server of this process, started when it is first asked."""

    def __init__(self):
        self.guard, self.channel, self.owner, self.wait = threading.Lock(), None, None, None

    def _open(self):
        if self.channel is None or self.owner != os.getpid():
            self.channel, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
            server = subprocess.Popen([sys.executable, __file__, str(theirs.fileno())], stdin=subprocess.DEVNULL,
                                      stdout=subprocess.DEVNULL, pass_fds=[theirs.fileno()])
            theirs.close()
            self._have(server.wait)

    def branch(self):
        """Forks: this process asks the fork, which gets the channel that it is to serve."""
        self.channel, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        process = os.fork()
        if process:
            theirs.close()
            self._have(lambda: os.waitpid(process, 0))
            return None
        self.channel.close()
        self.channel = None
        nothing = os.open(os.devnull, os.O_RDWR)
        for stream in range(3):
            os.dup2(nothing, stream)
        os.close(nothing)
        return theirs

    def _have(self, wait):
        self.owner, self.wait = os.getpid(), wait
        atexit.register(self.close)

    def close(self):
        if self.owner == os.getpid() and self.channel is not None:
            self.channel.close()
            self.wait()
            self.channel = None

    def ask(self, request, handles):
        self._open()
        socket.send_fds(self.channel, [json.dumps(request).encode()], handles)
        answer = self.channel.recv(64)
        assert answer, "the server of warm_start.py has ended"
        return json.loads(answer)


_client = _Client()
branch = _client.branch


def can_run(environment):
    """Whether a process with this environment may come from the server."""
    def relevant(of):
        return {name: value for name, value in of.items() if name.startswith(READ_AT_START)}
    return relevant(environment) == relevant(os.environ)


def cold(words, folder, environment, program=None):
    """As run, from nothing."""
    command = [sys.executable, *(["-c", program, *words[1:]] if program else words)]
    return subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False,
                          env=environment)


def run(words, folder, environment, program=None):
    """Runs a tool's file, which is the first of the words, or a program's text instead: a subprocess.CompletedProcess."""
    request = {"words": words, "folder": str(folder), "environment": environment, "program": program}
    if len(json.dumps(request)) > REQUEST_MAX or not can_run(environment) or \
            not _client.guard.acquire(blocking=False):      # busy: of two at once, one starts from nothing
        return cold(words, folder, environment, program)
    with contextlib.ExitStack() as stack:
        stack.callback(_client.guard.release)
        said = [stack.enter_context(tempfile.TemporaryFile()) for _ in range(2)]
        code = _client.ask(request, [file.fileno() for file in said])
        for file in said:
            file.seek(0)
        return subprocess.CompletedProcess(words, code, *(file.read().decode().replace("\r\n", "\n") for file in said))


if __name__ == "__main__":
    preload()
    serve(socket.socket(fileno=int(sys.argv[1])))
