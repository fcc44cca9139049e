# SPDX-License-Identifier: MIT
"""Limits of programs: CPU time and sleep, never wall time; and jobs in a process of their own, under limits: however the process ends, there
is its answer or one sentence."""

import os
import subprocess
import sys
import time
import types

import numpy as np
import pytest

from conftest import CHECKOUT, TOOLS, assert_one_sentence, environment, run_cli
from fixel.base import bounded, job, limits, reading
from fixel.base.errors import ToolError
from fixel.model import stl
from viewers import runs

BUILT_PROGRAMS = ()
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


# --- jobs in a process of their own -----------------------------------------------------------

HEAD = f"import json, os, signal, sys, time\nsys.path.insert(0, {str(TOOLS)!r})\nfrom fixel.base import errors, job\n"
SMALL = bounded.Limits(cpu=1, memory=200)
NAMED = r"x\.toml: at the stage '{}' .*{}.*; the limits are 1 s of CPU time \(--cpu-limit\) and 200 MiB of memory \(--memory-limit\)$"


def run(folder, body, limits=SMALL, subject="x.toml"):
    """A job of these lines, which may use request and report."""
    (folder / "worker.py").write_text(HEAD + "def do(request, report):\n" +
                                      "".join(f"    {line}\n" for line in body.splitlines()) + "job.serve(do)\n")
    return bounded.run(str(folder / "worker.py"), {"asked": 5}, subject, limits)


def test_a_job_answers(tmp_path):
    assert run(tmp_path, 'print("noise", flush=True)\nreturn [request["asked"], "ä\\n"]') == ([5, "ä\n"], b"")


def test_a_job_gives_bytes_of_any_size(tmp_path):
    assert run(tmp_path, 'report.give(bytes(range(256)) * 40_000)\nreturn 7') == (7, bytes(range(256)) * 40_000)
    assert run(tmp_path, 'report.give(b"")') == (None, b"")


def test_the_files_that_a_job_read_are_known(tmp_path):
    (tmp_path / "in").write_text("x")
    run(tmp_path, f"from fixel.base import reading\nreading.read_all({str(tmp_path / 'in')!r})", subject=str(tmp_path / "x.toml"))
    assert reading.identity(tmp_path / "in") in reading.opened()


def test_a_job_reads_no_file_outside_the_folder_of_its_subject(tmp_path):
    folder = tmp_path / "scenes"
    folder.mkdir()
    for file in (folder / "in", tmp_path / "out"):
        file.write_text("x")
    body = "from fixel.base import reading\nreturn reading.read_all({!r}).decode()"
    assert run(folder, body.format(str(folder / "in")), subject=str(folder / "x.toml"))[0] == "x"
    outside = body.format(str(tmp_path / "out"))
    with pytest.raises(ToolError, match="is outside .*, the folder of .*x.toml"):
        run(folder, outside, subject=str(folder / "x.toml"))
    allowed = bounded.Limits(cpu=1, memory=200, outside=True)
    assert run(folder, outside, allowed, subject=str(folder / "x.toml"))[0] == "x"


def test_a_refusal_comes_as_it_is(tmp_path):
    with pytest.raises(ToolError) as refused:
        run(tmp_path, 'raise errors.ToolError("x.toml: is wrong", 1, "words\\nof another")')
    assert (refused.value.message, refused.value.exit_code, refused.value.words) == ("x.toml: is wrong", 1, "words\nof another")


@pytest.mark.parametrize("body, words", [
    ("while True:\n    pass", "took the limit of 1 s of CPU time"),
    ("try:\n    while True:\n        pass\nexcept BaseException:\n    return 1", "took the limit of 1 s of CPU time"),
    ("return len(bytes(1 << 30))", "needs more than the limit of 200 MiB of memory"),
    ("made = []\nwhile True:\n    made.append([made] * 10)", "needs more than the limit of 200 MiB of memory"),
    ("raise OSError(12, 'x')", "needs more than the limit of 200 MiB of memory"),
    ("raise ImportError('failed to map segment from shared object')", "needs more than the limit of 200 MiB of memory"),
    ("os.kill(os.getpid(), signal.SIGKILL)", "was killed"),
    ("os.kill(os.getpid(), signal.SIGSEGV)", "was ended by SIGSEGV"),
    ("os._exit(0)", "ended without an answer"),
    ("os._exit(3)", "ended without an answer"),
    ("os.closerange(0, 100)\ntime.sleep(600)", "was killed"),
    ("report.send({'unknown': 1})\ntime.sleep(600)", "sent a damaged answer"),
    ("report.send({'done': 1})\ntime.sleep(600)", "sent a damaged answer"),
    ("report.send({'done': [1, 9]})\nos.write(1, b'short')\nos._exit(0)", "without an answer"),
    ("report.send([1])\ntime.sleep(600)", "sent a damaged answer"),
    ("return {}[0]", r"defect of the tool \(KeyError in worker.py, line 6\)")])
def test_each_end_is_one_sentence(tmp_path, body, words):
    """It names the file, the stage, the limits and their options."""
    with pytest.raises(ToolError, match=NAMED.format("face 9", words)) as refused:
        run(tmp_path, "report.stage('face 9')\n" + body)
    assert refused.value.exit_code == 2 and not refused.value.words


def test_a_process_that_cannot_begin(tmp_path):
    (tmp_path / "worker.py").write_text("syntax error")
    with pytest.raises(ToolError, match=NAMED.format("its start", "ended without an answer")):
        bounded.run(str(tmp_path / "worker.py"), {}, "x.toml", SMALL)


def test_what_is_being_done_is_told_now_and_then(tmp_path, capfd, monkeypatch):
    monkeypatch.setattr(bounded, "QUIET_SECONDS", 0)
    run(tmp_path, "job.PAUSE = 1e9\nreport.stage('a\\x1b')\nfor i in range(100):\n    report(f'face {i}')\nreport.stage('b')\nreport.stage('b')")
    assert capfd.readouterr().err == "scene: a\\x1b\nscene: b\n"


def test_how_far_a_stage_is_is_told_when_the_last_words_are_some_time_old(monkeypatch):
    now, told = [100.0], []
    monkeypatch.setattr(job, "time", types.SimpleNamespace(monotonic=lambda: now[0]))
    report = job.Report(told.append)
    report.stage("reading the file")
    for passed, words in ((job.PAUSE / 2, "1 of 3"), (job.PAUSE, "2 of 3"), (job.PAUSE / 2, "3 of 3")):
        now[0] += passed
        report(words)
    assert told == [{"stage": "reading the file"}, {"stage": "2 of 3"}]


def test_a_limit_that_a_system_lacks_is_said_once(tmp_path, capfd, monkeypatch):
    monkeypatch.setattr(bounded, "_told_without", False)
    body = "report.send({'without': 'memory'})\nreturn 1"
    assert run(tmp_path, body) == run(tmp_path, body) == (1, b"")
    assert capfd.readouterr().err == "note: this system has no limit of memory for a process: scenes are compiled without\n"


def test_which_limits_a_system_lacks():
    """In a process of its own, which they would bind."""
    code = ("import resource\nfrom fixel.base import job\nreal = resource.setrlimit\n"
            "def refuse(kind, limits):\n    if kind == resource.RLIMIT_AS:\n        raise ValueError\n    real(kind, limits)\n"
            "resource.setrlimit = refuse\nprint(job._limit(7, 1 << 30), resource.getrlimit(resource.RLIMIT_CPU)[0])\n"
            "resource.setrlimit = real\nprint(job._limit(6, 1 << 30), resource.getrlimit(resource.RLIMIT_AS)[0])")
    done = subprocess.run([sys.executable, "-c", code], cwd=TOOLS, env=environment(), capture_output=True, text=True, check=True)
    assert done.stdout == f"['memory'] 7\n[] {1 << 30}\n"


def test_limits_that_hold_already_are_kept():
    code = ("import resource\nfrom fixel.base import bounded\nresource.setrlimit(resource.RLIMIT_CPU, (9, 20))\n"
            "print(bounded.Limits(cpu=30).effective()[0], bounded.Limits(cpu=5).effective()[0])")
    done = subprocess.run([sys.executable, "-c", code], cwd=TOOLS, env=environment(), capture_output=True, text=True, check=True)
    assert done.stdout == "9 5\n"


def test_the_defaults(monkeypatch):
    """60 s, and 2 GiB or half of the machine's memory."""
    monkeypatch.setattr(bounded, "_at_most_present", lambda kind, wanted: wanted)
    for pages, memory in ((1 << 24, 2 << 30), (1 << 18, 512 << 20), (1, 64 << 20)):
        monkeypatch.setattr(os, "sysconf", {"SC_PHYS_PAGES": pages, "SC_PAGE_SIZE": 4096}.get)
        assert bounded.Limits().effective() == (60, memory)


@pytest.mark.parametrize("option", ["--cpu-limit", "--memory-limit"])
@pytest.mark.parametrize("text", ["0", "-1", "1_0", "٣", "nan", "9" * 5000, ""])
def test_limits_that_are_none(tmp_path, option, text):
    done = run_cli("build", CHECKOUT / "scenes" / "tiny.toml", "-o", tmp_path / "out", option, text)
    assert_one_sentence(done, option, "must be a whole number from")
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("command", [["build"], ["export", "--c"]])
@pytest.mark.parametrize("option, words", [(("--cpu-limit", "1"), "took the limit of 1 s of CPU time"),
                                           (("--memory-limit", "100"), "more than the limit of 100 MiB of memory")])
def test_a_scene_beyond_a_limit_leaves_nothing(tmp_path, command, option, words):
    head, triangles = bytes(80) + (65_000).to_bytes(4, "little"), np.zeros(65_000, stl._TRIANGLE)
    triangles["corners"] = np.random.default_rng(5).random((65_000, 3, 3))
    (tmp_path / "m.stl").write_bytes(head + triangles.tobytes())
    (tmp_path / "out").write_text("old")
    done = run_cli(*command, tmp_path / "m.stl", "-o", tmp_path / "out", *option)
    assert_one_sentence(done, "m.stl", "at the stage", words, option[0])
    assert (tmp_path / "out").read_text() == "old" and sorted(os.listdir(tmp_path)) == ["m.stl", "out"]


def test_it_ends_with_the_tool(tmp_path):
    """A tool that is killed leaves no process that goes on to compile."""
    code = HEAD + f"from fixel.base import bounded\nbounded.run({str(tmp_path / 'worker.py')!r}, {{}}, 'x')"
    (tmp_path / "worker.py").write_text(HEAD + f"def do(request, report):\n    open({str(tmp_path / 'pid')!r}, 'w').write(str(os.getpid()))\n"
                                        "    time.sleep(600)\njob.serve(do)\n")
    tool = subprocess.Popen([sys.executable, "-c", code], env=environment())
    while not (tmp_path / "pid").exists() or not (tmp_path / "pid").read_text():
        time.sleep(0.02)
    worker = int((tmp_path / "pid").read_text())
    tool.kill()
    tool.wait()
    while _runs(worker):
        time.sleep(0.02)


def _runs(process):
    try:
        with open(f"/proc/{process}/stat", encoding="utf-8") as file:
            return file.read().rpartition(")")[2].split()[0] not in "ZX"
    except FileNotFoundError:
        return False
