# SPDX-License-Identifier: MIT
"""Programs that tools start: none outlives its tool, however that ends, and what one says is passed on."""

import pathlib
import re
import signal
import subprocess
import sys
import textwrap
import time

import pytest

from conftest import CHECKOUT, TOOLS, environment
from fixel.base import children
from fixel.base.errors import ToolError
from fixel.board.programs import run_program
from viewers import assert_gone, children as started_by, runs

BUILT_PROGRAMS = ()


def tool(folder, body):
    """A tool made up here, in a file; its body has `folder`."""
    file = folder / "tool.py"
    file.write_text("import pathlib, sys, time, threading, concurrent.futures\n"
                    f"sys.path.insert(0, {str(TOOLS)!r})\nfolder = pathlib.Path({str(folder)!r})\n"
                    "from fixel.base import children\nfrom fixel.base.errors import run_main\n"
                    f"def main(argv):\n{textwrap.indent(textwrap.dedent(body), '    ')}\n    return 0\nrun_main(main)\n",
                    encoding="utf-8")
    return [sys.executable, str(file)]


def wait_for(path, process):
    while not path.exists():
        assert process.poll() is None
        time.sleep(0.01)


SLEEPERS = """
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        waiting = [pool.submit(children.run, ["sleep", str(600 + number)]) for number in range(2)]
        process = children.start(["sleep", "602"], start_new_session=True)
        (folder / "started").touch()
        process.wait()
"""


@pytest.mark.parametrize("ending", [signal.SIGKILL, signal.SIGTERM, signal.SIGHUP, signal.SIGINT])
def test_children_end_with_their_tool(tmp_path, ending):
    process = subprocess.Popen(tool(tmp_path, SLEEPERS), stderr=subprocess.PIPE, text=True)
    wait_for(tmp_path / "started", process)
    found = {}
    while len(found) < 4:
        found = started_by(process.pid) | {process.pid: ""}
    process.send_signal(ending)
    _, words = process.communicate()
    assert process.returncode == (-ending if ending == signal.SIGKILL else 128 + ending)
    assert "Traceback" not in words
    assert_gone(found)


def test_a_tool_that_is_gone_before_its_child_has_begun(tmp_path):
    """The child looks for its parent: setpriv alone would ask the kernel for a signal that has been sent."""
    command = children.tied(["touch", tmp_path / "ran"])
    place = command.index(children.BECOME) + 1
    assert command[place].isdigit()
    command[place] = "1"      # somebody else's child
    assert subprocess.run(command, check=False).returncode == 1
    assert not (tmp_path / "ran").exists()


def test_a_killed_make_takes_its_tool_along(tmp_path):
    command = tool(tmp_path, '(folder / "started").touch()\ntime.sleep(600)')
    (tmp_path / "Makefile").write_text(f"all:\n\t@{' '.join(command)}\n", encoding="ascii")
    process = subprocess.Popen(["make", "-C", tmp_path], env=environment(), stdout=subprocess.DEVNULL)
    wait_for(tmp_path / "started", process)
    found = started_by(process.pid)
    assert any("tool.py" in each for each in found.values())
    process.kill()
    process.wait()
    assert_gone(found)


BUSY = """
        from fixel.base import errors
        real = errors.signal.setitimer
        def slow(*words):
            errors.signal.setitimer = real
            real(*words)
            time.sleep(0.3)     # the machine is busy
        errors.signal.setitimer = slow
"""


@pytest.mark.parametrize("machine", ["", BUSY], ids=["idle", "busy"])
@pytest.mark.parametrize("ending", [signal.SIGTERM, signal.SIGINT])
def test_a_signal_within_a_destructor_counts(tmp_path, ending, machine):
    """Python ignores what is raised there, so the tool would go on. Told once, it clears up undisturbed."""
    body = machine + """
        from fixel.base import errors
        errors.BEAT = 0.05
        class Slow:
            def __del__(self):
                (folder / "started").touch()
                time.sleep(600)
        Slow()
        try:
            time.sleep(600)
        finally:
            time.sleep(0.2)
            (folder / "cleared").touch()
    """
    process = subprocess.Popen(tool(tmp_path, body), stderr=subprocess.PIPE, text=True)
    wait_for(tmp_path / "started", process)
    process.send_signal(ending)
    _, words = process.communicate()
    assert process.returncode == 128 + ending
    assert words == ("interrupted\n" if ending == signal.SIGINT else f"ended by {ending.name}\n")
    assert (tmp_path / "cleared").exists()


@pytest.mark.parametrize("ending", [signal.SIGTERM, signal.SIGHUP, signal.SIGINT])
def test_a_signal_just_before_a_wait_counts(tmp_path, ending):
    """It sets Python's mark, and does not interrupt the wait: so does _thread.interrupt_main."""
    body = f"""
        import _thread
        threading.Timer(0.2, _thread.interrupt_main, [{int(ending)}]).start()
        time.sleep(600)
    """
    done = subprocess.run(tool(tmp_path, body), stderr=subprocess.PIPE, text=True, check=False)
    assert done.returncode == 128 + ending
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("ending", [signal.SIGTERM, signal.SIGHUP, signal.SIGINT])
def test_a_tool_that_cannot_clear_up_ends_all_the_same(tmp_path, ending):
    """A signal may come where it leaves a lock held that the clearing up needs."""
    body = """
        from fixel.base import errors
        errors.LAST = 1.0
        lock = threading.Lock()
        try:
            (folder / "started").touch()
            time.sleep(600)
        finally:
            lock.acquire()
            lock.acquire()
    """
    process = subprocess.Popen(tool(tmp_path, body))
    wait_for(tmp_path / "started", process)
    process.send_signal(ending)
    assert process.wait() == 128 + ending


@pytest.mark.parametrize("last", ["sys.exit(3)", "raise SystemExit(3)", "return 3"])
def test_nothing_interrupts_a_tool_that_ends(tmp_path, last):
    """Python's own end may take long: then it has no handlers any more."""
    body = f"""
        class Slow:
            def __del__(self, sleep=time.sleep):
                sleep(1.5)
        pathlib.slow = Slow()       # a module's: destroyed at the very end
        {last}
    """
    assert subprocess.run(tool(tmp_path, body), check=False).returncode == 3


def test_an_ignored_signal_stays_ignored(tmp_path):
    body = """
        import os, signal
        os.kill(os.getpid(), signal.SIGHUP)
        assert signal.getsignal(signal.SIGHUP) == signal.SIG_IGN
    """
    assert subprocess.run(["nohup", *tool(tmp_path, body)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          check=False).returncode == 0


@pytest.mark.parametrize("program, error", [("none", FileNotFoundError), ("./none", FileNotFoundError),
                                            ("./plain", PermissionError), ("plain", FileNotFoundError)])
def test_a_program_that_cannot_be_started(tmp_path, program, error):
    (tmp_path / "plain").write_text("", encoding="ascii")
    with pytest.raises(error) as raised:
        children.start([program], cwd=tmp_path)
    assert raised.value.filename == program


def test_a_program_of_another_folder_and_path(tmp_path):
    program = tmp_path / "here"
    program.write_text("#!/bin/sh\necho $0 $1\n", encoding="ascii")
    program.chmod(0o755)
    assert children.run(["./here", "a b"], cwd=tmp_path, text=True).stdout == "./here a b\n"
    assert children.run(["here", "c"], env={"PATH": f"{tmp_path}:/usr/bin:/bin"}, text=True).stdout == f"{program} c\n"


def test_no_setpriv(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(OSError, match="setpriv is not installed: run 'sudo apt-get install util-linux'"):
        children.start(["/bin/true"])


def test_every_tool_starts_its_children_so():
    """No tool has another way. What is sent to a worker of a cluster can include nothing of Fixel, and ends its children itself."""
    other = re.compile(r"subprocess\.(Popen|run|call|check_call|check_output)\(|os\.(system|popen|spawn\w*|posix_spawn\w*)\(")
    found = [f"{file.relative_to(CHECKOUT)}: {line.strip()}" for file in TOOLS.rglob("*.py")
             if file.name != "children.py" and file != TOOLS / "fixel/campaign/worker.py"
             for line in file.read_text(encoding="utf-8").splitlines() if other.search(line)]
    assert not found


def test_runs_sees_the_dead():
    """What the tests above rely on."""
    process = subprocess.Popen(["sleep", "600"])
    assert runs(process.pid)
    process.kill()
    process.wait()
    assert not runs(process.pid) and pathlib.Path("/proc/self").exists()


@pytest.mark.parametrize("code", [0, 3])
def test_what_a_program_says_is_passed_on_and_its_last_words_are_the_error(tmp_path, capsys, code):
    program = tmp_path / "draw"
    program.write_text(f"#!/bin/sh\necho drawn\nprintf 'one\\ntwo\\nerror: three\\n' >&2\nexit {code}\n", encoding="ascii")
    program.chmod(0o755)
    if code:
        with pytest.raises(ToolError, match="^draw: three$"):
            run_program([program])
    else:
        assert run_program([program]) == "drawn\n"
    assert capsys.readouterr().err == "one\ntwo\n" + "error: three\n" * (code == 0)
