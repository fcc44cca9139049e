# SPDX-License-Identifier: MIT
"""Programming the real board through a debug probe, by OpenOCD."""

import pathlib
import shlex
import shutil
import signal
import subprocess
import sys

from fixel.base import children
from fixel.board import flash_memory
from fixel.base.errors import ToolError
from fixel.board.flash import OPENOCD

STARTED = "** Programming Started **"
VERIFIED = "** Verified OK **"


def braced(path):
    """A path as one word of Tcl."""
    text = str(path)
    if any(letter in text for letter in "{}\\\n"):
        raise ToolError(f"OpenOCD cannot be told the path {text!r}: move it to one without braces and backslashes")
    return f"{{{text}}}"


def command(program, scene):
    """What programs a board with a program and a scene image, and starts it."""
    if not program.openocd:
        raise ToolError(f"there is no OpenOCD configuration for board {program.board}: its board.mk sets no "
                        "BOARD_OPENOCD. Without PROBE= its flash image for the emulator is written")
    return [OPENOCD, *program.openocd,
            "-c", f"program {braced(program.path)} verify",
            "-c", f"program {braced(scene)} {program.scene_base:#010x} verify reset exit"]


def show(words):
    """A command as a person would type it."""
    return " ".join(shlex.quote(word) for word in words)


def judge(program, code, seen):
    """Raises where OpenOCD did not do all: its exit code alone proves nothing."""
    if code == 0 and seen.count(VERIFIED) == 2:
        return
    how = f"{OPENOCD} ended with {code}" if code else f"{OPENOCD} verified {seen.count(VERIFIED)} of 2 parts"
    state = ("the board's flash may be half written: until it is programmed again, do not expect it to start"
             if STARTED in seen else "nothing was written, the board has what it had before")
    raise ToolError(f"board {program.board} was not programmed: {how}; {state}", exit_code=1)


def run(program, words):
    """Runs OpenOCD, passes on what it says, and answers with its exit code and
    the lines by which it says how far it got."""
    seen = []
    try:
        # By force it could leave the debug probe in a state that only its plug ends.
        process = children.start(words, signal.SIGTERM, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                 stderr=subprocess.STDOUT, text=True, errors="replace")
    except OSError as error:
        raise ToolError(f"cannot start {words[0]}: {error.strerror}") from error
    try:
        with process:
            for line in process.stdout:
                print(f"  {line.rstrip()}", file=sys.stderr, flush=True)
                seen += [mark for mark in (STARTED, VERIFIED) if mark in line]
    except KeyboardInterrupt:
        # It may have begun to program: its words may not have been read yet.
        judge(program, process.wait() or 130, [*seen, STARTED])
        raise
    return process.returncode, seen


def program_board(board, elf, scene, dry_run):
    """Programs the real board; what flash_memory.flash refuses, is refused here too.
    The command is printed before it runs; dry_run: it does not run."""
    program, _ = flash_memory.prepare(board, elf, scene)
    words = command(program, pathlib.Path(scene))
    print(show(words), flush=True)
    if dry_run:
        return
    if shutil.which(OPENOCD) is None:
        raise ToolError(f"{OPENOCD} is not installed: run 'sudo apt-get install {OPENOCD}'")
    judge(program, *run(program, words))
