# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: The Fixel authors
"""What make says while it builds: how many files of how many on a terminal, little elsewhere, commands with V=1."""

import os
import pty
import re
import shlex
import subprocess

from conftest import CHECKOUT, environment

BUILT_PROGRAMS = ()
OBJECTS = ("beneath", "dump", "explain", "judge")


def watched(**changes):
    """The environment of a make that a user's command calls, not a test's."""
    return environment(MAKELEVEL="1", FIXEL_SET_UP="", **changes)


def command(tmp_path, *settings):
    """The make that a command calls to have files built."""
    return ["make", "--no-print-directory", *settings, f"BUILD={tmp_path}", *(f"{tmp_path}/host/objects/judges/judge/{name}.o" for name in OBJECTS)]


def built(tmp_path, *settings):
    return subprocess.run(command(tmp_path, *settings), cwd=CHECKOUT, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          check=True, env=watched())


def test_a_terminal_has_one_line_that_changes(tmp_path):
    ours, theirs = pty.openpty()
    process = subprocess.Popen(command(tmp_path), cwd=CHECKOUT, stdin=subprocess.DEVNULL, stdout=theirs, stderr=theirs,
                               env=watched())
    os.close(theirs)
    said = b""
    try:
        while more := os.read(ours, 4096):
            said += more
    except OSError:     # the terminal's other end is closed
        pass
    os.close(ours)
    assert process.wait() == 0
    assert re.findall(r"(\d+) of (\d+)\r", said.decode()) == [(str(n), str(len(OBJECTS))) for n in range(1, len(OBJECTS) + 1)]
    assert b"\n" not in said and b"judge" not in said


def test_a_pipe_has_no_line_for_each_file(tmp_path):
    done = built(tmp_path)
    assert done.stdout == "" and done.stderr == ""
    assert {file.stem for file in tmp_path.rglob("*.o")} == set(OBJECTS)


def test_a_pipe_has_a_line_each_10_seconds(tmp_path):
    """By a clock that goes on by 6 seconds whenever make asks for the time, which is at each tenth file; make -n builds none."""
    clock = tmp_path / "bin" / "date"
    clock.parent.mkdir()
    clock.write_text(f"#!/bin/sh\ncd {shlex.quote(str(tmp_path))}\necho >> asked\necho $(($(wc -l < asked) * 6))\n")
    clock.chmod(0o755)
    sources = sorted((CHECKOUT / "host_tests" / "judges").glob("*/*.c"))
    done = subprocess.run(["make", "-n", f"BUILD={tmp_path}",
                           *(f"{tmp_path}/host/objects/judges/{file.parent.name}/{file.stem}.o" for file in sources)],
                          cwd=CHECKOUT, capture_output=True, text=True, check=True,
                          env=watched(PATH=f"{clock.parent}:{os.environ['PATH']}"))
    told = [int(number) for number in re.findall(rf"building: (\d+) of {len(sources)}$", done.stdout, re.MULTILINE)]
    assert told == list(range(30, len(sources) + 1, 20)) != []


def test_v_shows_the_commands(tmp_path):
    assert sum(" -c host_tests/judges/judge/" in line for line in built(tmp_path, "V=1").stdout.replace("\\\n", " ").splitlines()) \
        == len(OBJECTS)
