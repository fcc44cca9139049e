# SPDX-License-Identifier: MIT
"""A tool from the server of warm_start.py does what one does that Python starts from nothing, and is as alone."""

import os
import signal

import pytest
import warm_start
from conftest import CHECKOUT, LAUNCHER, TOOLS, environment, without_progress
from fixel.commands import COMMANDS

BUILT_PROGRAMS = ()


def both(words, program=None, folder=CHECKOUT, **changes):
    """What a command from the server, and one from nothing, end with and say."""
    words = [str(word) for word in words]
    found = [start(words, folder, environment(**changes), program) for start in (warm_start.run, warm_start.cold)]
    return [(done.returncode, done.stdout, done.stderr) for done in found]


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_starts_either_way(command):
    warm, cold = both([LAUNCHER, command, "--help"])
    assert warm == cold and "Traceback" not in cold[2]


@pytest.mark.parametrize("words", [["build", "none.toml", "-o", "x.fxls"], ["build"], ["--none"], []])
def test_what_is_refused(words):
    warm, cold = ([*ended, without_progress(said)] for *ended, said in both([TOOLS / "scene.py", *words]))
    assert warm == cold and cold[0] == 2


def test_a_result(tmp_path):
    found = []
    for start in (warm_start.run, warm_start.cold):
        done = start([str(TOOLS / "scene.py"), "build", str(CHECKOUT / "scenes/tiny.toml"), "-o", "tiny.fxls"], tmp_path, environment())
        found.append([done.returncode, done.stdout, without_progress(done.stderr), (tmp_path / "tiny.fxls").read_bytes()])
        (tmp_path / "tiny.fxls").unlink()
    warm, cold = found
    assert warm == cold and warm[:3] == [0, "", ["tiny.fxls: 2,512 bytes, 5 objects, 16 frames"]]


JOB = """import json, os, signal, sys, threading
print(json.dumps([sys.stdin.read(), [os.environ.get(name) for name in ("FIXEL_MARK", "OPENBLAS_NUM_THREADS")], os.getcwd(), len(sys.argv), threading.active_count(),
                  [str(signal.getsignal(each)) for each in (1, 2, 13, 14, 15)], signal.getitimer(signal.ITIMER_REAL),
                  len(os.listdir("/proc/self/fd"))]), flush=True)
os.kill(os.getpid(), signal.SIGTERM)
"""
# As a tool does, whose signals and environment are not those that it began with.
STARTED = """import os, signal, sys
sys.path.insert(0, {tools!r})
from fixel.base import bounded
from fixel.base.errors import run_main
def main(_):
    with bounded.start({file!r}, bounded.Limits({limits})) as process:
        process.stdin.write(b"asked")
        process.stdin.close()
        print(process.stdout.read().decode())
    print(process.returncode)
    return 3
run_main(main)
"""


def test_a_job_begins_as_one_that_python_starts_from_nothing(tmp_path):
    """In a tool from the server, whose jobs are forks; with a limit of memory, which makes it a process from nothing; and
    in a tool from nothing."""
    (tmp_path / "job.py").write_text(JOB)
    fork, fresh = (STARTED.format(tools=str(TOOLS), file=str(tmp_path / "job.py"), limits=limits) for limits in ("", "memory=500"))
    changed = environment(OPENBLAS_NUM_THREADS="1", FIXEL_MARK="here")
    found = [start(["x"], tmp_path, changed, program) for start, program in
             ((warm_start.run, fork), (warm_start.run, fresh), (warm_start.cold, fork))]
    assert {(done.returncode, done.stderr) for done in found} == {(3, "")}, found
    told, _, code = zip(*(done.stdout.partition("\n") for done in found))
    assert told[0] == told[1] == told[2] and "asked" in told[0] and set(code) == {f"\n{-signal.SIGTERM}\n"}


def test_a_job_of_a_test_sees_nothing_that_the_test_changes(tmp_path, monkeypatch):
    from fixel.base import bounded
    from fixel.board import run
    monkeypatch.setattr(run, "PATTERNS", "changed")
    (tmp_path / "job.py").write_text(f"import sys\nsys.path.insert(0, {str(TOOLS)!r})\n"
                                     "from fixel.board import run\nprint(run.PATTERNS)\n")
    for limits in (bounded.Limits(), bounded.Limits(memory=500)):
        with bounded.start(str(tmp_path / "job.py"), limits) as process:
            process.stdin.close()
            assert "frame" in process.stdout.read().decode()
        assert process.returncode == 0


def test_a_job_of_a_test_can_be_killed(tmp_path):
    from fixel.base import bounded
    (tmp_path / "job.py").write_text("import time\nprint(1, flush=True)\ntime.sleep(600)\n")
    with bounded.start(str(tmp_path / "job.py"), bounded.Limits()) as process:
        assert process.stdout.readline() == b"1\n"
        process.kill()
    assert process.returncode == -signal.SIGKILL
    assert bounded.start.__module__ == "warm_start"


@pytest.mark.parametrize("program", [
    "import sys; sys.exit(7)", "import sys; sys.exit('words')", "print('é', '\\udc80'.encode('utf-8', 'replace'))",
    "import os, signal; os.kill(os.getpid(), signal.SIGKILL)", "import os; os._exit(3)",
    "import sys; print(sys.argv)", "import os; print(sorted(os.environ.items()), os.getcwd())",
    "import os, sys; print(os.isatty(0), os.isatty(1), sys.stdin.read() == '')",
    "import atexit; atexit.register(print, 'at the end')", "import sys; print(1); print(2, file=sys.stderr); print(3)",
    "import signal; print([signal.getsignal(each) for each in (1, 2, 13, 15)])",
    "import os; print(len(os.listdir('/proc/self/fd')) < 10)",
    "import threading; print(threading.active_count())",
])
def test_a_process_is_one_of_its_own(tmp_path, program):
    warm, cold = both(["x", "y z", ""], program, tmp_path, FIXEL_MARK="here")
    assert warm == cold


def test_nothing_is_left_of_the_command_before():
    change = "import sys; sys.path.insert(0, 'tools'); from fixel.board import run; print(run.PATTERNS); run.PATTERNS.append(1)"
    first, second = (warm_start.run(["x"], CHECKOUT, environment(), change).stdout for _ in range(2))
    assert first == second and "frame" in first


def test_a_test_changes_no_command(monkeypatch):
    from fixel.board import run
    monkeypatch.setattr(run, "PATTERNS", ["changed"])
    monkeypatch.setitem(os.environ, "FIXEL_MARK", "changed")
    words = "import os, sys; sys.path.insert(0, 'tools'); from fixel.board import run; print(run.PATTERNS, os.environ.get('FIXEL_MARK'))"
    assert "changed" not in warm_start.run(["x"], CHECKOUT, {**environment(), "FIXEL_MARK": "mine"}, words).stdout


@pytest.mark.parametrize("name, value", [("PYTHONIOENCODING", "latin-1"), ("LC_ALL", "C"), ("LANG", "C")])
def test_what_python_reads_at_its_start_is_heeded(name, value):
    assert warm_start.can_run(environment()) and not warm_start.can_run(environment(**{name: value}))


def test_an_end_by_a_signal_is_told():
    done = warm_start.run(["x"], CHECKOUT, environment(), "import os; os.kill(os.getpid(), 15)")
    assert done.returncode == -signal.SIGTERM
