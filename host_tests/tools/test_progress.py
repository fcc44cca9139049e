# SPDX-License-Identifier: MIT
"""What a long job says of how far it is."""

import io
import types

import pytest

from fixel.base import progress


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
