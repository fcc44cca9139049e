# SPDX-License-Identifier: MIT
"""What a long job says of how far it is, and of the CPU time that it took, with all that it started."""

import io
import os
import re
import resource
import types

import pytest

from conftest import run_cli, run_make
from fixel.base import progress

BUILT_PROGRAMS = ("boards/host/walk", "host/judge", "host/raycast")


class Stream(io.StringIO):
    """A stream that is a terminal or none."""

    def __init__(self, terminal):
        super().__init__()
        self.isatty = lambda: terminal


@pytest.fixture
def clock(monkeypatch):
    """The time that the module sees; a test moves it."""
    now = types.SimpleNamespace(seconds=100.0)
    monkeypatch.setattr(progress, "time", types.SimpleNamespace(monotonic=lambda: now.seconds))
    return now


def test_without_a_terminal_there_is_a_line_now_and_then_and_the_time_at_the_end(clock):
    stream = Stream(False)
    with progress.Progress("a\njob", 200, stream) as told:
        for done in range(5):
            told(done)
            clock.seconds += 2.0
    assert stream.getvalue() == "a\\njob: 3 of 200 (1 %)\na\\njob: 10.0 s\n"


def test_a_short_job_and_one_that_fails_say_nothing_at_the_end(clock):
    stream = Stream(False)
    with progress.Progress("job", 3, stream):
        clock.seconds += 1.9
    with pytest.raises(ValueError), progress.Progress("job", 3, stream):
        clock.seconds += 9
        raise ValueError
    assert stream.getvalue() == ""


def test_a_terminal_has_one_line_that_changes_and_goes(clock):
    stream = Stream(True)
    with progress.Progress("job", 0, stream) as told:
        clock.seconds += 0.2
        told(1, 10)
        clock.seconds += 0.06
        told(2)
        clock.seconds += 0.06
        told(3)
    assert stream.getvalue() == "\rjob ...\rjob: 1 of 10 (10 %)\rjob: 3 of 10 (30 %)\r" + " " * 19 + "\r"


def test_a_job_of_unknown_length_says_what_is_done(clock):
    stream = Stream(False)
    with progress.Progress("job", stream=stream) as told:
        clock.seconds += 5.0
        told(7)
        told(8)
    assert stream.getvalue() == "job: 7\njob: 5.0 s\n"


def test_steps_say_how_many_are_done_before_each(clock):
    stream, seen = Stream(False), []
    for item in progress.steps("job", ["a", "b", "c"], stream):
        seen.append(item)
        clock.seconds += 6.0
    assert seen == ["a", "b", "c"]
    assert stream.getvalue() == "job: 1 of 3 (33 %)\njob: 2 of 3 (66 %)\njob: 18.0 s\n"


# --- CPU time ---------------------------------------------------------------------------------

SETTINGS = ["BOARD=host", "SCENE=scenes/tiny.toml", "FRAMES=1"]


def told(done):
    """The seconds, which are the last word on stderr; None without them."""
    found = re.search(r"^(\d+\.\d) s of CPU\n\Z", done.stderr, re.MULTILINE)
    return float(found[1]) if found else None


def test_a_command_tells_what_all_its_processes_took(build, tmp_path):
    """The kernel's count of them all, less what make does after the tool's last word."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = run_make("run", *SETTINGS, f"OUT={tmp_path / 'out'}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    taken = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    assert done.returncode == 0, done.stdout + done.stderr
    assert 0.8 * taken - 0.05 <= told(done) <= taken + 0.2     # it is told to a tenth


def test_a_tool_that_no_make_started_tells_nothing(build, tmp_path):
    words = ["--board", "host", "--scene", "scenes/tiny.toml", "--frames", "1", "--out", tmp_path / "out"]
    assert told(run_cli("run", *words)) is None


def test_what_this_process_took_counts():
    from fixel.base import spent
    before, own = spent.seconds(), sum(os.times()[:2])
    while sum(os.times()[:2]) < own + 0.2:
        sum(range(10_000))
    assert spent.seconds() > before + 0.15    # the kernel counts in hundredths


def test_what_the_kernel_says_of_this_process():
    from fixel.base import spent
    _, parent, taken = spent._process(os.getpid())
    own = sum(os.times()[:4])
    assert parent == os.getppid() and 0.5 * own < taken <= own + 0.001   # sums of hundredths
