# SPDX-License-Identifier: MIT
"""Tools' processes without the time that Python takes to import their packages: half a second, a thousand times.

A server imports what most tools import, and runs nothing. For each command it forks: the copy gets the command's words,
environment and output, runs the tool's program, and ends as a program does. So no command sees what another,
or a test, has changed. The process in which a scene is compiled (bounded.py) is a fork too: of the tool's process, or of
the server where a test starts it. test_warm_start.py compares such processes with those that Python starts from nothing.
Under make test the server is a fork of the process that has imported all this already (fixel.check.pytest_server)."""

import atexit
import contextlib
import ctypes
import gc
import importlib
import json
import os
import pathlib
import resource
import runpy
import signal
import socket
import subprocess
import sys
import tempfile
import threading

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"
sys.path.append(str(TOOLS.parent / "host_tests"))

import named_programs
PRELOADED = ("numpy", "PIL.Image", "elftools.elf.elffile", "fixel.scene.summary", "fixel.scene.texture",
             "fixel.board.run", "fixel.board.flash", "fixel.scene.worker", "fixel.scene.command")
PR_SET_PDEATHSIG = 1     # of Linux
REQUEST_MAX = 100_000    # characters
# MiB. A fork has up to 100 MiB of address space more than a process that Python starts from nothing, so a job that is
# limited to less than this is started from nothing.
FORKED_LEAST = 1000
# A process reads these when Python starts.
READ_AT_START = ("PYTHON", "LC_", "LANG", "OPENBLAS", "LD_")


# --- the server ---------------------------------------------------------------

def preload():
    """Imports what most tools import, and what their modules import late."""
    sys.path.insert(0, str(TOOLS))
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    from fixel.commands import Late
    for name in PRELOADED:
        for each in list(vars(importlib.import_module(name)).values()):
            if type(each) is Late:
                importlib.import_module(each.__name__)
    gc.freeze()     # what a fork collects, it copies


def serve(channel):
    """Answers requests until the channel ends: the number of the process, then its exit code. It comes back only in a fork
    that ends as Python itself does."""
    while True:
        request, handles, _, _ = socket.recv_fds(channel, 2 * REQUEST_MAX, 3)
        if not request:
            os._exit(0)     # to put all modules away takes a tenth of a second
        asked = json.loads(request)
        child = os.fork()
        if child == 0:
            channel.close()
            _become(asked, handles)
            return
        for handle in handles:
            os.close(handle)
        channel.sendall(json.dumps(child).encode())
        _, status = os.waitpid(child, 0)
        channel.sendall(json.dumps(os.waitstatus_to_exitcode(status)).encode())


def _become(asked, handles):
    for number, handle in enumerate(handles, 3 - len(handles)):
        os.dup2(handle, number)
        os.close(handle)
    os.environ.clear()
    os.environ.update(asked["environment"])
    os.chdir(asked["folder"])
    named_programs.heed()
    _limit(asked.get("limits", ()))
    if "job" in asked:
        _do_job(asked["job"])
    _start_jobs_by_fork()
    sys.argv[:] = asked["words"]
    code = None
    try:
        if asked["program"]:
            sys.argv[0] = "-c"
            exec(compile(asked["program"], "<string>", "exec"), {"__name__": "__main__"})
        else:
            runpy.run_path(sys.argv[0], run_name="__main__")
    except SystemExit as ended:
        code = ended.code
    end(code)


def end(code):
    """Ends this process as sys.exit(code) at the end of a program does, less the time to put all modules away. It comes
    back, for Python to end, where the output cannot be written."""
    if code is not None and not isinstance(code, int):
        print(code, file=sys.stderr)
        code = 1
    threading._shutdown()
    atexit._run_exitfuncs()
    try:
        sys.stdout.flush()
        sys.stderr.flush()
    except (OSError, ValueError):
        sys.exit(code)
    os._exit((code or 0) & 0xFF)


# --- jobs of bounded.py -------------------------------------------------------

def _do_job(program):
    """What a process of bounded.py does, in a fork. Streams and signals are as for a program that starts."""
    code = 1
    try:
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, int(signal.SIGKILL))
        os.closerange(3, os.sysconf("SC_OPEN_MAX"))
        for number in (signal.SIGHUP, signal.SIGTERM, signal.SIGALRM):
            if signal.getsignal(number) is not signal.SIG_IGN:
                signal.signal(number, signal.SIG_DFL)
        if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:
            signal.signal(signal.SIGINT, signal.default_int_handler)
        sys.unraisablehook, sys.excepthook = sys.__unraisablehook__, sys.__excepthook__
        sys.stdin, sys.stdout, sys.stderr = (open(number, mode, closefd=False) for number, mode in enumerate("rww"))
        sys.argv[:] = [program]
        runpy.run_path(program, run_name="__main__")
        code = 0
    except BaseException:
        sys.excepthook(*sys.exc_info())
    finally:
        with contextlib.suppress(OSError):
            sys.stdout.flush()
        os._exit(code)


class _Job:
    """A process that does a job, as children.start answers one. With it standard input and output."""

    def __init__(self, start):
        """start([its standard input, its standard output]): its number, and a function that waits for its exit code."""
        asks, hears = os.pipe(), os.pipe()
        self.stdin, self.stdout = open(asks[1], "wb"), open(hears[0], "rb")
        self.returncode, self.last = None, signal.SIGKILL
        try:
            self.pid, self._wait = start([asks[0], hears[1]])
        finally:
            os.close(asks[0])
            os.close(hears[1])

    def send_signal(self, number):
        with contextlib.suppress(ProcessLookupError):
            os.kill(self.pid, number)

    def kill(self):
        self.send_signal(signal.SIGKILL)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stdout.close()
        with contextlib.suppress(BrokenPipeError):
            self.stdin.close()
        self.returncode = self._wait()


def _may_fork(limits):
    return limits.memory is None or limits.memory >= FORKED_LEAST


def _start_jobs_by_fork():
    """Jobs of this process, which is a fork itself, are forks of it."""
    from fixel.base import bounded, children
    cold_start = bounded.start

    def start(program, limits):
        if not _may_fork(limits) or threading.active_count() > 1:
            return cold_start(program, limits)
        job = _Job(lambda handles: _fork_for(program, handles))
        children._running[job.pid] = job
        return job
    bounded.start = start


def _fork_for(program, handles):
    sys.stdout.flush()
    sys.stderr.flush()
    child = os.fork()
    if child == 0:
        for number, handle in enumerate(handles):
            os.dup2(handle, number)
        _do_job(program)
    return child, lambda: os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


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
        """The number of the process that the server makes."""
        self._open()
        socket.send_fds(self.channel, [json.dumps(request).encode()], handles)
        return self.answer()

    def answer(self):
        """The second answer is the exit code."""
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


def cold(words, folder, environment, program=None, limits=()):
    """As run, from nothing."""
    command = [sys.executable, *(["-c", program, *words[1:]] if program else words)]
    return subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", check=False,
                          env=environment, preexec_fn=lambda: _limit(limits))


def _limit(limits):
    for kind, most in limits:
        resource.setrlimit(kind, (most, most))


def run(words, folder, environment, program=None, limits=()):
    """Runs a tool's file, which is the first of the words, or a program's text instead: a subprocess.CompletedProcess.
    limits: pairs for resource.setrlimit, of the tool."""
    request = {"words": words, "folder": str(folder), "environment": environment, "program": program, "limits": limits}
    if len(json.dumps(request)) > REQUEST_MAX or not can_run(environment) or \
            not _client.guard.acquire(blocking=False):      # busy: of two at once, one starts from nothing
        return cold(words, folder, environment, program, limits)
    with contextlib.ExitStack() as stack:
        stack.callback(_client.guard.release)
        said = [stack.enter_context(tempfile.TemporaryFile()) for _ in range(2)]
        _client.ask(request, [file.fileno() for file in said])
        code = _client.answer()
        for file in said:
            file.seek(0)
        return subprocess.CompletedProcess(words, code, *(file.read().decode(errors="replace").replace("\r\n", "\n") for file in said))


def job_start(cold_start):
    """bounded.start for a process that runs tests: jobs are forks of the server. cold_start: bounded.start itself."""
    def start(program, limits):
        request = {"job": program, "folder": os.getcwd(), "environment": dict(os.environ)}
        if not _may_fork(limits) or len(json.dumps(request)) > REQUEST_MAX or not _client.guard.acquire(blocking=False):
            return cold_start(program, limits)

        def wait():
            try:
                return _client.answer()
            finally:
                _client.guard.release()
        try:
            return _Job(lambda handles: (_client.ask(request, [*handles, 2]), wait))
        except BaseException:
            _client.guard.release()
            raise
    return start


if __name__ == "__main__":
    preload()
    serve(socket.socket(fileno=int(sys.argv[1])))
