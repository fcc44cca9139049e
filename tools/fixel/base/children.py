# SPDX-License-Identifier: MIT
"""The one way in which a tool starts another program, so that no program outlives the tool.

A child gets a signal when the tool ends, however the tool ends. The kernel sends it (PR_SET_PDEATHSIG):
setpriv asks for it, then becomes a shell, and the shell becomes the program. The shell ends if the tool was
gone before setpriv had asked. The kernel counts the end of the thread that started the child as the tool's
end, so a thread must not end before its children.
"""

import ctypes
import errno
import os
import shutil
import signal
import subprocess

SETPRIV = "setpriv"
# $0 is the tool's process.
BECOME = 'test "$PPID" = "$0" || exit 1; exec "$@"'
PR_SET_PDEATHSIG = 1    # of Linux

_running = {}           # process -> its subprocess.Popen
_ending = False


def _require(program, folder, path):
    """Refuses what cannot be started as subprocess.Popen would: the shell would only print it."""
    place = os.path.join(folder or "", program) if os.sep in program else program
    if shutil.which(place, path=path) is None:
        number = errno.EACCES if os.sep in program and os.path.exists(place) else errno.ENOENT
        raise OSError(number, os.strerror(number), program)


def tied(command, last=signal.SIGKILL, folder=None, path=None):
    """A command that ends with this process, by the signal last."""
    words = [os.fspath(word) if isinstance(word, os.PathLike) else str(word) for word in command]
    if shutil.which(SETPRIV) is None:
        raise OSError(errno.ENOENT, f"{SETPRIV} is not installed: run 'sudo apt-get install util-linux'")
    _require(words[0], folder, path)
    return [shutil.which(SETPRIV), "--pdeathsig", last.name.removeprefix("SIG"), "/bin/sh", "-c", BECOME,
            str(os.getpid()), *words]


def start(command, last=signal.SIGKILL, **how):
    """subprocess.Popen of a command that ends with this process. last: the signal with which it ends. how: as
    for subprocess.Popen."""
    if _ending:
        raise KeyboardInterrupt
    environment = how.get("env") or os.environ
    process = subprocess.Popen(tied(command, last, how.get("cwd"), environment.get("PATH")), **how)
    process.last = last
    for number, each in list(_running.items()):
        if each.returncode is not None:
            _running.pop(number, None)
    _running[process.pid] = process
    if _ending:     # meanwhile
        process.send_signal(last)
    return process


def run(command, **how):
    """subprocess.run of such a command, without input and with captured output unless how says otherwise."""
    streams = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    with start(command, **{**streams, **how}) as process:
        try:
            said = process.communicate()
        except BaseException:
            process.kill()
            raise
    return subprocess.CompletedProcess(command, process.returncode, *said)


def end_all():
    """Ends all children, and lets no other start: a thread that waits for a child gets on. May be called by a
    signal handler."""
    global _ending
    _ending = True
    for process in list(_running.values()):
        process.send_signal(process.last)


def follow_parent():
    """This process gets SIGTERM when its parent ends."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, int(signal.SIGTERM))
