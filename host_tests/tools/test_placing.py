# SPDX-License-Identifier: MIT
"""Folders of results: what stays in them, what is undone, that two commands with one of them exclude each other, and that a command which is
killed at each of its renames, unlinks and links leaves OUT or OUT.old whole, and the next command mends it."""

import errno
import fcntl
import json
import multiprocessing
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

import pytest

from conftest import CHECKOUT, LAUNCHER, environment
from fixel.base import output, placing, scratch
from fixel.base.errors import ToolError
from model_files import png

BUILT_PROGRAMS = ()
PATTERNS = [*output.numbered("frame_", ".png"), "summary.json"]


@pytest.fixture(autouse=True)
def journals(tmp_path_factory, monkeypatch):
    """A folder of journals that no other process has."""
    folder = tmp_path_factory.mktemp("journals")
    monkeypatch.setattr(scratch, "JOURNALS", folder)
    monkeypatch.setattr(scratch, "_journal", scratch._Journal())
    return folder


@pytest.fixture
def out(tmp_path):
    """A folder with a result of three frames."""
    write(tmp_path / "out", "old", 3)
    return tmp_path / "out"


def write(out, tag, count, between=lambda: None):
    with output.replaced_folder(out, PATTERNS) as new:
        for number in range(count):
            (new / f"frame_{number:04d}.png").write_text(tag)
        (new / "summary.json").write_text(tag)
        between()


def texts(out):
    return {path.name: path.read_text() for path in out.iterdir() if path.is_file()}


def result(tag, count):
    return {**{f"frame_{number:04d}.png": tag for number in range(count)}, "summary.json": tag}


def assert_alone(out):
    assert [path.name for path in out.parent.iterdir()] == [out.name]


def test_the_folder_itself_stays(out):
    """A shell that stands in it sees the new results; and so do its permissions and its sub-folders."""
    out.chmod(0o710)
    (out / "sub").mkdir()
    before, sub = os.stat(out), os.stat(out / "sub")
    write(out, "new", 2)
    after = os.stat(out)
    assert (after.st_ino, after.st_mode) == (before.st_ino, before.st_mode)
    assert os.stat(out / "sub").st_ino == sub.st_ino
    assert texts(out) == result("new", 2)
    assert_alone(out)


@pytest.mark.parametrize("name", ["frame_mine.png", "frame_00.png", "board.fxld", "frame_0000.png.txt", "notes"])
def test_what_no_tool_wrote_stays(out, name):
    (out / name).write_text("mine")
    write(out, "new", 1)
    assert texts(out) == {**result("new", 1), name: "mine"}


def test_a_hard_link_of_a_result_keeps_what_it_has(out, tmp_path):
    os.link(out / "summary.json", tmp_path / "kept")
    write(out, "new", 1)
    assert (tmp_path / "kept").read_text() == "old"


def test_a_folder_with_the_name_of_a_result(out):
    (out / "frame_0000.png").unlink()
    (out / "frame_0000.png").mkdir()
    before = texts(out)
    with pytest.raises(ToolError, match="out: cannot be written: frame_0000.png in it is a folder"):
        write(out, "new", 1)
    assert texts(out) == before
    assert_alone(out)


def test_a_folder_that_is_called_out_old(out):
    """It is somebody's own, and no tool touches it."""
    shutil.copytree(out, out.with_name("out.old"))
    (out.parent / "out.old-2").write_text("mine too")
    write(out, "new", 1)
    assert texts(out) == result("new", 1) and texts(out.with_name("out.old")) == result("old", 3)
    assert sorted(path.name for path in out.parent.iterdir()) == ["out", "out.old", "out.old-2"]


@pytest.mark.parametrize("call", ["rename", "unlink", "link"])
def test_a_failure_leaves_the_results_before(out, monkeypatch, call):
    """At each call in turn; then what was done is undone by calls that succeed."""
    real, failed = getattr(os, call), []

    def failing(number):
        left = [number]

        def once(*arguments, **options):
            left[0] -= 1
            if left[0] == 0:
                failed.append(number)
                raise OSError(errno.EIO, "Input/output error")
            return real(*arguments, **options)
        return once

    for number in range(1, 5):
        with monkeypatch.context() as patched:
            patched.setattr(os, call, failing(number))
            try:
                write(out, "new", 2)
            except ToolError as error:
                assert "cannot be written: Input/output error" in str(error)
        if texts(out) != result("old", 3):      # the copy in a link's stead, or a failure after all was done
            assert texts(out) == result("new", 2)
            write(out, "old", 3)
        scratch.remove_left_over(placing.mend)
        assert_alone(out)
    assert failed == [1, 2, 3, 4]


@pytest.mark.parametrize("has_links", [True, False])
def test_ctrl_c_amid_the_renames(out, monkeypatch, has_links):
    """Also on a file system without hard links."""
    def no_link(*_, **__):
        raise OSError(errno.EPERM, "Operation not permitted")

    def rename(old, new, real=os.rename):
        if str(new).endswith("summary.json"):
            raise KeyboardInterrupt
        return real(old, new)

    if not has_links:
        monkeypatch.setattr(os, "link", no_link)
        write(out, "second", 4)
        assert texts(out) == result("second", 4)
    before = texts(out)
    with monkeypatch.context() as patched:
        patched.setattr(os, "rename", rename)
        with pytest.raises(KeyboardInterrupt):
            write(out, "newer", 1)
    assert texts(out) == before
    assert_alone(out)
    assert not scratch._journal._paths


def test_a_folder_above_that_may_not_be_written(out, monkeypatch):
    """As of a volume of a container: all temporary files are in OUT."""
    real = os.access
    monkeypatch.setattr(os, "access", lambda path, mode: os.fspath(path) != str(out.parent) and real(path, mode))
    seen = []
    write(out, "new", 1, lambda: seen.extend(os.listdir(out.parent)))
    assert seen == ["out"] and texts(out) == result("new", 1)
    assert sorted(os.listdir(out)) == sorted(result("new", 1))


def test_a_note_that_is_damaged(out, journals):
    """A journal that is another's costs nobody a file."""
    shutil.copytree(out, out.with_name("out.old"))
    before = texts(out.with_name("out.old"))
    (out / "summary.json").write_text("newer")
    note = {"out": str(out), "old": str(out) + ".old", "inode": 1, "patterns": PATTERNS, "new": {}}
    for text in (json.dumps(note), str(note), "{", "{}", '{"out": 5}'):
        (journals / "1-x").write_bytes(text.encode() + b"\0")
        assert scratch.remove_left_over(placing.mend) == []
    assert texts(out)["summary.json"] == "newer" and texts(out.with_name("out.old")) == before


# --- two commands -----------------------------------------------------------------------

def one(out, tag, count, barrier, answers):
    try:
        write(out, tag, count, barrier.wait)
        answers.put("ok")
    except BaseException as error:
        answers.put(repr(error))


@pytest.mark.parametrize("before", [False, True])
def test_simultaneous_ends(tmp_path, before):
    """Today's results are those of one command, whole, and both are content."""
    for trial in range(15):
        out = tmp_path / f"out{trial}"
        if before:
            write(out, "old", 9)
        barrier, answers = multiprocessing.Barrier(2), multiprocessing.Queue()
        processes = [multiprocessing.Process(target=one, args=(out, tag, count, barrier, answers))
                     for tag, count in (("A", 16), ("B", 5))]
        for each in processes:
            each.start()
        assert [answers.get(), answers.get()] == ["ok", "ok"]
        for each in processes:
            each.join()
        assert texts(out) in (result("A", 16), result("B", 5))
    assert len(list(tmp_path.iterdir())) == 15


def test_the_last_one_stands(out):
    """The lock is held only while a folder is put in place: one command ends while another one is at work."""
    write(out, "slow", 2, lambda: write(out, "quick", 4))
    assert texts(out) == result("slow", 2)


def test_one_waits_for_the_lock(out):
    barrier, answers = multiprocessing.Barrier(2), multiprocessing.Queue()
    process = multiprocessing.Process(target=one, args=(out, "new", 1, barrier, answers))
    process.start()     # before the lock is taken: a fork would hold it, too
    handle = os.open(out.parent, os.O_RDONLY)
    fcntl.flock(handle, fcntl.LOCK_EX)
    barrier.wait()
    while f"-> FLOCK  ADVISORY  WRITE {process.pid}" not in waiting():
        assert process.is_alive()
        time.sleep(0.01)
    assert texts(out) == result("old", 3)
    os.close(handle)
    process.join()
    assert answers.get() == "ok" and texts(out) == result("new", 1)


def waiting():
    with open("/proc/locks", encoding="ascii") as locks:
        return locks.read()


def test_a_file_system_that_locks_no_folder(out, monkeypatch, journals):
    real, locked = fcntl.flock, []

    def flock(handle, flags):
        path = os.readlink(f"/proc/self/fd/{handle}")
        if path == str(out.parent):
            raise OSError(errno.EBADF, "Bad file descriptor")
        locked.append(path)
        return real(handle, flags)

    monkeypatch.setattr(fcntl, "flock", flock)
    write(out, "new", 1)
    assert texts(out) == result("new", 1) and str(journals / placing.LOCK) in locked


def test_the_first_name_that_is_free(tmp_path):
    out = tmp_path / "out"
    assert placing._free_name(out).name == "out.old"
    (tmp_path / "out.old").mkdir()
    assert placing._free_name(out).name == "out.old-2"
    (tmp_path / "out.old-2").symlink_to("nowhere")      # somebody's too
    assert placing._free_name(out).name == "out.old-3"
    (tmp_path / "out.old-4").touch()
    assert placing._free_name(out).name == "out.old-3"


# --- kills ------------------------------------------------------------------------------------

DRIVER = pathlib.Path(__file__).with_name("killed_at.py")
OLD, NEW, SAME = 2, 1, 1     # frames that differ, in the comparison before and in this one, and frames that are equal
MOST = 200                   # calls of a command; one that survives none of them is broken
BACK = "a command was killed while it put its results there; those before are back"


home = None     # a checkout of these tests alone: a tool that other tests start would mend what is broken here


@pytest.fixture(scope="module", autouse=True)
def checkout(tmp_path_factory):
    global home
    home = tmp_path_factory.mktemp("checkout")
    shutil.copytree(CHECKOUT / "tools", home / "tools", ignore=shutil.ignore_patterns("__pycache__"))
    (home / ".venv").symlink_to(CHECKOUT / ".venv")


def run(*words):
    return subprocess.run([sys.executable, *words], cwd=home, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          check=False, env=environment())


def run_tool(command, *words):
    return run(home / LAUNCHER.relative_to(CHECKOUT), command, *words)


def killed_at(number, command, *words):
    """A command that is killed before its N-th call."""
    return run(DRIVER, str(number), home / LAUNCHER.relative_to(CHECKOUT), command, *words)


def frames(folder, count, colour):
    """Pictures of which the first ones differ from those of another colour."""
    folder.mkdir()
    for number in range(count + SAME):
        (folder / f"frame_{number:04d}.png").write_bytes(png([[[colour if number < count else 0, number, 0]]]))


def words(place, count):
    return ["compare", "--a", place / f"a{count}", "--b", place / f"b{count}", "--out", place / "out"]


@pytest.fixture(scope="module")
def wanted(tmp_path_factory, checkout):
    """The results of two comparisons, and a folder with their input: (place, before, after)."""
    place, found = tmp_path_factory.mktemp("wanted"), []
    for count in (OLD, NEW):
        frames(place / f"a{count}", count, 10 + count)
        frames(place / f"b{count}", count, 50 + count)
        assert run_tool(*words(place, count)).returncode == 1
        found.append(results(place / "out"))
        shutil.rmtree(place / "out")
    assert len(found[0]) == OLD + 1 and len(found[1]) == NEW + 1
    return place, *found


def results(folder):
    """{name: content} of the files, without those of somebody else."""
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file() and path.name != "notes_diff.png"}


def prepare(place, before):
    """OUT with results, and with what no tool wrote. One of its files has a name like those of results."""
    for path in place.glob("out*"):
        shutil.rmtree(path)
    if before is None:
        return
    out = place / "out"
    (out / "mine").mkdir(parents=True)
    (out / "mine" / "compare.json").write_text("not yours")
    (out / "notes_diff.png").write_text("nor this")
    (out / "link").symlink_to("nowhere")
    for name, content in before.items():
        (out / name).write_bytes(content)


def assert_strangers(out):
    assert (out / "mine" / "compare.json").read_text() == "not yours"
    assert (out / "notes_diff.png").read_text() == "nor this" and (out / "link").readlink() == pathlib.Path("nowhere")


def whole(place, before, after):
    """Whether OUT is whole, and whether OUT or OUT.old is."""
    there = [results(folder) in (before, after) for folder in (place / "out", place / "out.old") if folder.exists()]
    return bool(there and there[0] and (place / "out").exists()), any(there)


def assert_mended(place, before, after, was_whole, said):
    out = place / "out"
    assert results(out) in (before, after)
    assert (BACK in said) == (not was_whole), said
    assert sorted(path.name for path in place.iterdir()) == ["a1", "a2", "b1", "b2", "out"]
    assert_strangers(out)


def test_a_kill_at_each_call(wanted):
    place, before, after = wanted
    broken = 0
    for number in range(1, MOST):
        prepare(place, before)
        done = killed_at(number, *words(place, NEW))
        if done.returncode != -signal.SIGKILL:
            break
        out_is_whole, one_is_whole = whole(place, before, after)
        assert one_is_whole, number
        assert_strangers(place / "out")
        broken += not out_is_whole
        assert_mended(place, before, after, out_is_whole, run_tool("boot", "--help").stderr)
    assert done.returncode == 1, done.stderr
    assert results(place / "out") == after
    assert_strangers(place / "out")
    assert number > 2 * (OLD + NEW) and broken >= OLD + NEW     # each unlink and each rename was one of them


def test_a_kill_while_the_next_command_mends(wanted):
    """As above; the command that mends is killed at each of its calls, too."""
    place, before, after = wanted
    for number in range(1, MOST):
        prepare(place, before)
        assert killed_at(2 * OLD + 4, *words(place, NEW)).returncode == -signal.SIGKILL     # amid the unlinks
        assert whole(place, before, after) == (False, True)
        done = killed_at(number, "boot", "--help")
        assert whole(place, before, after)[1], number
        assert_strangers(place / "out")
        out_is_whole, _ = whole(place, before, after)
        if done.returncode != -signal.SIGKILL:
            break
        assert_mended(place, before, before, out_is_whole, run_tool("boot", "--help").stderr)
    assert done.returncode == 0 and number > 2 * OLD
    assert_mended(place, before, before, False, done.stderr)


def test_a_kill_before_there_was_a_folder(wanted):
    place, _, after = wanted
    for number in range(1, MOST):
        prepare(place, None)
        done = killed_at(number, *words(place, NEW))
        assert not (place / "out").exists() or results(place / "out") == after, number
        assert run_tool("boot", "--help").returncode == 0
        assert not [path for path in place.iterdir() if path.name.startswith(".")]
        if done.returncode != -signal.SIGKILL:
            break
    assert done.returncode == 1 and number > 1 and results(place / "out") == after
