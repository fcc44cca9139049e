# SPDX-License-Identifier: MIT
"""A few kills of commands at random moments, and that `make kills` sees what a command leaves."""

import os
import signal
import subprocess
import types

import pytest

from board_programs import built
from conftest import run_cli
from fixel.check import kills
import viewers

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf", "boards/lm3s6965evb/walk.elf", "host/judge", "host/raycast", "host/live",
                  ".fixel-kills-*/*")     # links to them in the folder of a campaign
BOARDS = viewers.BOARDS[:2]     # of all commands but view-stream, and of that one
KILLS, SEED = 8, 13


def test_a_few_kills(build):
    for board in BOARDS:
        built(f"{board}/walk.elf")
    done = run_cli("kills", "--board", BOARDS[0], "--streaming", BOARDS[1], "--kills", KILLS, "--seed", SEED, "--commands", "run", "flash", "boot", "view", "view-stream")
    assert done.returncode == 0, done.stdout + done.stderr
    assert f"pass: {KILLS} of {KILLS} kills" in done.stdout


@pytest.mark.parametrize("arguments, words", [(("--kills", "0"), "KILLS is '0'"), (("--seed", "x"), "SEED is 'x'")])
def test_refused(arguments, words):
    done = run_cli("kills", "--board", BOARDS[0], "--streaming", BOARDS[1], *arguments)
    assert done.returncode == 2 and words in done.stderr


# --- what it looks for ----------------------------------------------------------------

@pytest.fixture
def campaign(build, tmp_path):
    """One in which nothing was killed yet. The old image and its frames are made up."""
    made = kills.Campaign(tmp_path, build, {}, "1000", *BOARDS)
    made.images, made.frames = {"old": b"image"}, {"new": ["hash"]}
    return made


def test_how_long_a_command_takes_is_from_its_start_to_its_end(campaign, monkeypatch):
    moments = iter([1000.0, 1002.5])
    monkeypatch.setattr(kills, "time", types.SimpleNamespace(monotonic=lambda: next(moments)))
    ended = types.SimpleNamespace(poll=lambda: 0, wait=lambda: 0, returncode=0)
    monkeypatch.setattr(campaign, "start", lambda command: ended)
    monkeypatch.setattr(campaign, "wait", lambda *_: None)
    campaign.measure("boot")
    assert campaign.times == {"boot": 2.5}


def test_nothing_is_left(campaign):
    assert campaign.left() == []


def test_a_process_that_is_left(campaign, monkeypatch):
    monkeypatch.setattr(kills, "GONE_WITHIN", 0)
    process = subprocess.Popen(["sleep", "600"], env=campaign.environment)
    try:
        while "sleep 600" not in str(campaign.marked()):
            assert process.poll() is None
        assert campaign.left() == [f"process {process.pid} still runs: sleep 600 "]
    finally:
        process.kill()
        process.wait()
    assert campaign.left() == []


@pytest.mark.parametrize("number", kills.SIGNALS)
def test_a_signal_that_the_caller_ignores(campaign, monkeypatch, number):
    """A campaign in the background, or under nohup, kills as any other."""
    monkeypatch.setattr(campaign, "words", lambda command, scene: ["sleep", "600"])
    ignored = [each for each in kills.SIGNALS if each != signal.SIGKILL]
    before = [signal.signal(each, signal.SIG_IGN) for each in ignored]
    try:
        process = campaign.start("run")
    finally:
        for each, handler in zip(ignored, before):
            signal.signal(each, handler)
    while campaign.marked().get(process.pid) != "sleep 600 ":
        assert process.poll() is None
    process.send_signal(number)
    assert process.wait() == -number


@pytest.mark.parametrize("name", ["tmp/.fixel-board-0", "build/.fixel-run-0", "out/.fixel-results-0", "out/run/.hidden",
                                  "out/flash/.fixel-output-0", "out/boot/other"])
def test_a_file_that_is_left(campaign, name):
    path = campaign.folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.touch()
    assert f"{name} is left" in campaign.left()


@pytest.mark.parametrize("name", ["flash/board.bin", "boot/board.fxld", "run/summary.json", "report/report.json"])
def test_half_a_result(campaign, name):
    path = campaign.folder / "out" / name
    path.parent.mkdir(parents=True)
    path.write_bytes(b"imag")
    assert any(sentence.startswith(f"out/{name} is not") for sentence in campaign.left())


def test_a_whole_image(campaign):
    (campaign.folder / "out" / "flash").mkdir()
    (campaign.folder / "out" / "flash" / "board.bin").write_bytes(b"image")
    assert campaign.left() == []


def test_tracebacks():
    text = "Traceback (most recent call last):\n  File ...\nValueError"
    assert kills.is_traceback(text) and not kills.is_traceback("error: no")
    assert os.environ.get(kills.MARK) is None


@pytest.mark.parametrize("complaints, code", [([], 0), (["it is left"], 1)])
def test_the_command_ends_with_what_it_found(monkeypatch, tmp_path, capsys, complaints, code):
    """Also in the background, where a shell ignores a signal that the commands must get."""
    seen = []

    def carry_out(options, campaign):
        seen.append((signal.getsignal(signal.SIGINT), options.kills, options.seed, campaign))
        return [kills.Kill("run", signal.SIGKILL, 0.5, False, False, complaints=complaints)]
    monkeypatch.setattr(kills, "carry_out", carry_out)
    monkeypatch.setattr(kills, "make_campaign", lambda options, folder: folder.parent)
    build, before = tmp_path / "new" / "build", signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        words = ["--kills", "3", "--seed", "5", "--build", str(build), "--commands", "run", "--board", "mps2-an385", "--streaming", "microbit"]
        assert kills.main(words) == code
    finally:
        signal.signal(signal.SIGINT, before)
    assert seen == [(signal.default_int_handler, 3, 5, seen[0][3])] and build.is_dir()
    assert f"{1 - len(complaints)} of 1 kills" in capsys.readouterr().out
