# SPDX-License-Identifier: MIT
"""Runs a board's program under watch, until it ends, hangs or does what it should not: how it ended, and what that means.

An emulator's exit code alone proves nothing: a reset and a SIGTERM give 0, a
lockup 134, a hang none at all. A run has succeeded only if the agreed exit code
of boards/contract/system.h came AND the end marker was printed.
"""

import dataclasses
import pathlib
import re
import signal
import subprocess
import time

from fixel.base import children, limits
from fixel.base.errors import ToolError
from fixel.board import firmware

CONTRACT = pathlib.Path(__file__).resolve().parents[3] / "boards" / "contract" / "system.h"
LOCKUP = 134  # QEMU aborts
HANG = 124    # the tool's own, as timeout(1) has it
BAD = 1       # any other ending that is no success
OUTPUT_MAX = 1 << 20  # bytes of text from a board
POLL = 0.02  # seconds


@dataclasses.dataclass(frozen=True)
class Ending:
    """How a program ended: its exit code (negative: a signal; None: it was
    stopped, because of why), all that it printed, after how long, and the CPU seconds that it took."""

    code: int | None
    output: str
    why: str
    seconds: float
    hung: bool = False  # it was stopped because nothing new came
    cpu: float = 0.0


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


def locked_up(ending):
    return ending.code == LOCKUP or ending.code == -signal.SIGABRT


def describe(ending):
    """What an ending was, in words."""
    meanings = exit_meanings()
    if ending.code is None:
        return ending.why
    if locked_up(ending):
        return "the core locked up (a fault inside a fault handler)"
    if ending.code < 0:
        return f"it was ended by signal {-ending.code}"
    if ending.code == 0:
        return "the emulator ended without the program's exit code: a reset, or it was terminated"
    if ending.code in meanings:
        return f"exit {ending.code}: {meanings[ending.code][1]}"
    return f"exit {ending.code}, which no program of ours gives"


def exit_status(ending):
    """With what a tool ends after an ending that was no success: the program's
    own code where it is one of the contract's."""
    if ending.hung:
        return HANG
    if locked_up(ending):
        return LOCKUP
    if ending.code in exit_meanings() and ending.code != exit_code("DONE"):
        return ending.code
    return BAD


def last_lines(text, count=30):
    """The end of what a program printed, as words of an error."""
    return "\n".join(f"  | {line}" for line in text.strip().splitlines()[-count:])


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
    raise ToolError(f"board {board} failed: {what}", exit_status(ending), last_lines(ending.output))


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
