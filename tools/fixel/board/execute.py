# SPDX-License-Identifier: MIT
"""Runs a program under watch: until it ends, hangs, or does what it should not."""

import pathlib
import subprocess
import time

from fixel.base import children, limits
from fixel.board.ending import Ending
from fixel.base.errors import ToolError

OUTPUT_MAX = 1 << 20  # bytes of text from a board
POLL = 0.02  # seconds


def kill(process):
    """SIGKILL: QEMU answers SIGTERM with exit code 0."""
    if process.poll() is None:
        process.kill()
    process.wait()


def start(command, directory, output, inherited, **how):
    try:
        return children.start(command, cwd=directory, stdin=subprocess.DEVNULL, stdout=output,
                              stderr=subprocess.STDOUT, pass_fds=inherited, **how)
    except OSError as error:
        raise ToolError(f"cannot start {command[0]}: {error.strerror}") from error


def execute(command, directory, timeout, watch=None, inherited=(), where=None):
    """Runs a command in a directory until it ends, or until it used timeout seconds of CPU time
    or slept so long without news, or until watch objects; an Ending.

    watch() answers (news, objection): something that changes as long as the
    program gets on, and a sentence or None. inherited: file descriptors for the
    command. where(process) is asked before a program is stopped: lines that say
    where it is.
    """
    log = pathlib.Path(directory) / "output.txt"
    started = time.monotonic()
    seen, why, hung = None, "", False
    with log.open("wb") as output:
        process = start(command, directory, output, inherited)
        limit = limits.Watch(process.pid, timeout, timeout)
        try:
            while not limits.has_ended(process) and not why:
                time.sleep(POLL)
                news, why = watch() if watch else (None, None)
                if news != seen:
                    seen = news
                    limit.renew()
                passed = limit.check()
                if not why and passed:
                    why, hung = f"nothing new came while {passed}: it hangs", True
                if not why and log.stat().st_size > OUTPUT_MAX:
                    why = "it prints without end"
            stopped = not limits.has_ended(process)
            cpu = limits.cpu_of(process.pid)
            if stopped and where:
                why = f"{why}\n{where(process.pid)}"
        finally:
            kill(process)
    with log.open("rb") as output:
        text = output.read(OUTPUT_MAX).decode("utf-8", "replace")
    seconds = time.monotonic() - started
    if stopped:
        return Ending(None, text, why, seconds, hung, cpu)
    return Ending(process.returncode, text, "", seconds, cpu=cpu)
