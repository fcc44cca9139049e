# SPDX-License-Identifier: MIT
"""Limits of programs: CPU time and sleep, never wall time."""

import subprocess
import sys
import time

import pytest
from viewers import runs

from fixel.base import limits

BURN = "while :; do :; done"
HOUR = 3600.0


def shell(script, cpu=HOUR, asleep=HOUR, **options):
    return limits.run(["sh", "-c", script], cpu, asleep, text=True, **options)


def test_a_program_that_ends():
    done = shell("echo out; echo err >&2; exit 3")
    assert (done.returncode, done.stdout, done.stderr) == (3, "out\n", "err\n")
    assert shell("echo out; echo err >&2", merge=True).stdout == "out\nerr\n"


@pytest.mark.parametrize("script", [BURN, f"({BURN}) & wait", f"while :; do {sys.executable} -c 'sum(range(10**6))'; done"])
def test_cpu_time_of_all_that_it_starts_is_limited(script):
    """Of itself, of a child, and of children that ended."""
    with pytest.raises(limits.LimitError, match="sh: it used 0.6 s of CPU time") as raised:
        shell(f"echo before; {script}", cpu=0.6)
    assert raised.value.output == "before\n"


def test_sleep_is_limited():
    with pytest.raises(limits.LimitError, match="it slept for 0.6 s"):
        shell("sleep 600", asleep=0.6)


def test_output_is_no_sleep():
    assert shell("for i in 1 2 3 4 5 6 7 8; do echo $i; sleep 0.2; done", asleep=0.8).returncode == 0


def test_news_between_two_late_looks_are_no_sleep():
    """This process may get no processor for longer than the limit."""
    child = subprocess.Popen(["sleep", "600"])
    try:
        watch = limits.Watch(child.pid, HOUR, 0.2)
        for renew in (watch.awake, watch.renew):
            time.sleep(0.4)
            renew()
            assert watch.check() is None
        time.sleep(0.4)
        assert watch.check() == "it slept for 0.2 s"
    finally:
        child.kill()
        child.wait()


def test_work_is_no_sleep():
    assert shell("i=0; while [ $i -lt 400000 ]; do i=$((i + 1)); done", asleep=0.3).returncode == 0


def test_wall_time_is_no_limit():
    """A process that gets a small part of a processor only, as on a busy machine."""
    child = subprocess.Popen(["sh", "-c", BURN])
    others = [subprocess.Popen(["sh", "-c", BURN]) for _ in range(6)]
    try:
        subprocess.run(["renice", "19", str(child.pid)], check=True, capture_output=True)
        watch, begun = limits.Watch(child.pid, HOUR, 0.5), time.monotonic()
        while time.monotonic() - begun < 2:
            assert watch.check() is None
            time.sleep(0.05)
        assert watch.used < 2
    finally:
        for each in (child, *others):
            each.kill()
            each.wait()


def test_news_renew_both_limits():
    child = subprocess.Popen(["sh", "-c", BURN])
    try:
        watch, begun = limits.Watch(child.pid, 0.5), time.monotonic()
        while watch.used < 1.5:
            assert watch.check() is None
            watch.renew()
            time.sleep(0.02)
            assert time.monotonic() - begun < HOUR
        while not (why := watch.check()):
            time.sleep(0.02)
        assert why == "it used 0.5 s of CPU time"
    finally:
        child.kill()
        child.wait()


def test_nothing_is_left_behind():
    with pytest.raises(limits.LimitError) as raised:
        shell("sleep 600 & echo $!; wait", asleep=0.5)
    number = int(raised.value.output)
    while runs(number):
        time.sleep(0.01)


@pytest.mark.parametrize("cpu, asleep, least, most", [(HOUR, 3.0, 11, 13), (3.0, HOUR, 11, 13), (HOUR, HOUR, 9, 10)])
def test_a_look_comes_each_second_or_each_quarter_of_a_limit(monkeypatch, cpu, asleep, least, most):
    """A look reads what is known of every process; many calls of check() make one."""
    now, looks = [100.0], []
    monkeypatch.setattr(limits.time, "monotonic", lambda: now[0])
    monkeypatch.setattr(limits, "_tree", lambda process: looks.append(now[0]) or {process: 0.0})
    monkeypatch.setattr(limits, "_is_ready", lambda process: False)
    watch, said = limits.Watch(1, cpu, asleep), []
    for _ in range(100):
        now[0] += 0.1
        said.append(watch.check())
    assert least <= len(looks) <= most
    assert [words for words in said if words] == ([] if asleep == HOUR else ["it slept for 3 s"] * (len(looks) - 3))


def test_a_time_in_which_this_process_was_stopped_is_one_second_of_sleep(monkeypatch):
    now = [100.0]
    monkeypatch.setattr(limits.time, "monotonic", lambda: now[0])
    monkeypatch.setattr(limits, "_tree", lambda process: {process: 0.0})
    monkeypatch.setattr(limits, "_is_ready", lambda process: False)
    watch = limits.Watch(1, HOUR, 2.5)
    for seconds, passed in ((600.0, False), (600.0, False), (600.0, True)):
        now[0] += seconds
        assert (watch.check() is not None) == passed


@pytest.mark.parametrize("state, ready", [("R", True), ("D", True), ("S", False), ("T", False), ("Z", False)])
def test_a_thread_that_could_run_or_waits_for_a_disk_is_ready(monkeypatch, state, ready):
    monkeypatch.setattr(limits.os, "listdir", lambda path: ["1", "2"])
    monkeypatch.setattr(limits, "_fields", lambda path: ["S", "0"] if path.endswith("/1/stat") else [state, "0"])
    assert limits._is_ready(1) == ready
    monkeypatch.setattr(limits, "_fields", lambda path: None)
    assert not limits._is_ready(1)


def test_cpu_time_counts_from_the_news(monkeypatch):
    now, used = [100.0], [0.0]
    monkeypatch.setattr(limits.time, "monotonic", lambda: now[0])
    monkeypatch.setattr(limits, "_tree", lambda process: {process: used[0]})
    watch = limits.Watch(1, 5.0)

    def later(seconds):
        now[0] += 1.5
        used[0] += seconds
        return watch.check()
    assert later(4.0) is None
    watch.renew()
    assert later(1.0) is None       # the look from which it counts
    assert later(4.5) is None and later(1.0) == "it used 5 s of CPU time"
