# SPDX-License-Identifier: MIT
"""A command that is killed at each of its renames, unlinks and links: OUT or OUT.old is whole, and the next command mends
it."""

import pathlib
import shutil
import signal
import subprocess
import sys

import pytest

from conftest import CHECKOUT, LAUNCHER, environment
from model_files import png

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
