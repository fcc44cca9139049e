# SPDX-License-Identifier: MIT
"""Programming a real board by OpenOCD: the command, what is refused before it
runs, and what is said of a board that it left half programmed."""

import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import time

import pytest

from board_programs import ROOT, built
from conftest import LAUNCHER, assert_one_sentence, environment, run_cli
from fixel.scene import making
from fixel.board import firmware, probe

BUILT_PROGRAMS = ()
DONE = "** Programming Started **\n** Programming Finished **\n** Verified OK **\n"


def board_settings(name):
    """boards/*/board.mk that set something: board -> what."""
    found = {}
    for path in sorted((ROOT / "boards").glob("*/board.mk")):
        for line in path.read_text(encoding="utf-8").splitlines():
            if line.startswith(f"{name} := "):
                found[path.parent.name] = line.removeprefix(f"{name} := ")
    return found


CONFIGURED = board_settings("BOARD_OPENOCD")
BOARD = sorted(CONFIGURED)[0]


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    path = tmp_path_factory.mktemp("scene") / "tiny.fxls"
    making.build(str(ROOT / "scenes" / "tiny.toml"), str(path))
    return path


@pytest.fixture
def image(tmp_path):
    return tmp_path / "flash" / "board.bin"


def words(scene, image, board=BOARD, elf=None, more=("--probe", "openocd")):
    return ["--board", board, "--elf", elf or built(f"{board}/walk.elf"), "--scene", scene, "--image", image, *more]


def fake_openocd(folder, script):
    """A PATH on which openocd notes its arguments and then runs a script."""
    folder.mkdir()
    path = folder / "openocd"
    path.write_text(f'#!/bin/sh\nprintf "%s\\n" "$@" >{folder}/arguments\n{script}\n', encoding="ascii")
    path.chmod(0o755)
    return f"{folder}{os.pathsep}{os.environ['PATH']}"


def say(text):
    return f"printf '%s' '{text}' >&2"


@pytest.mark.parametrize("board", sorted(CONFIGURED))
def test_the_command_of_a_board(scene, image, board):
    done = run_cli("flash", *words(scene, image, board, more=("--probe", "openocd", "--dry-run")), PATH="/nowhere")
    assert done.returncode == 0, done.stderr
    elf = built(f"{board}/walk.elf")
    base = firmware.load(elf).scene_base
    assert shlex.split(done.stdout) == ["openocd", *CONFIGURED[board].split(), "-c", f"program {{{elf}}} verify",
                                        "-c", f"program {{{scene}}} {base:#010x} verify reset exit"]
    assert not image.parent.exists()


def test_a_board_without_a_configuration(scene, image):
    done = run_cli("flash", *words(scene, image, "mps2-an385", more=("--probe", "openocd", "--dry-run")))
    assert_one_sentence(done, "no OpenOCD configuration for board mps2-an385", "BOARD_OPENOCD")


def test_both_are_programmed(scene, image, tmp_path):
    path = fake_openocd(tmp_path / "bin", say(DONE + DONE))
    done = run_cli("flash", *words(scene, image), PATH=path)
    assert done.returncode == 0, done.stderr
    command, last = done.stdout.splitlines()
    assert ["openocd", *(tmp_path / "bin" / "arguments").read_text().splitlines()] == shlex.split(command)
    assert last == f"{BOARD}: program and scene programmed and verified"
    assert "** Verified OK **" in done.stderr
    assert not image.parent.exists()  # the image for the emulator is another matter


@pytest.mark.parametrize("script, how, state", [
    (say("Error: no device found\n") + "; exit 1", "ended with 1", "nothing was written"),
    (say("** Programming Started **\nError: lost\n") + "; exit 1", "ended with 1", "half written"),
    (say(DONE + "** Programming Started **\n") + "; exit 1", "ended with 1", "half written"),
    (say(DONE), "verified 1 of 2 parts", "half written"),
    ("exit 0", "verified 0 of 2 parts", "nothing was written"),
    (say("** Programming Started **\n") + "; kill -KILL $$", "ended with -9", "half written"),
])
def test_what_is_said_of_a_failure(scene, image, tmp_path, script, how, state):
    done = run_cli("flash", *words(scene, image), PATH=fake_openocd(tmp_path / "bin", script))
    assert_one_sentence(done, f"board {BOARD} was not programmed", how, state, code=1)


def test_an_interrupt_says_what_the_board_is_left_with(scene, image, tmp_path):
    script = f"trap 'exit 1' INT; {say('** Programming Started **')}; echo >&2; touch {tmp_path}/started; " \
             "while true; do sleep 0.05; done"
    process = subprocess.Popen([sys.executable, LAUNCHER, "flash", *words(scene, image)],
                               env=environment(PATH=fake_openocd(tmp_path / "bin", script)), text=True,
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True)
    while not (tmp_path / "started").exists():
        assert process.poll() is None
        time.sleep(0.02)
    os.killpg(process.pid, 2)  # SIGINT, as a terminal does
    _, text = process.communicate()
    assert process.returncode == 1
    assert "half written" in text and "Traceback" not in text


def test_what_is_refused_before_openocd_runs(scene, image, tmp_path):
    path = fake_openocd(tmp_path / "bin", "exit 1")
    bad = tmp_path / "bad.fxls"
    bad.write_bytes(scene.read_bytes()[:-1])
    braces = tmp_path / "a}b.fxls"
    shutil.copy(scene, braces)
    cut = tmp_path / "cut.elf"
    cut.write_bytes(built(f"{BOARD}/walk.elf").read_bytes()[:5000])
    for arguments, sentence in (
            (words(bad, image), "cut off or overgrown"),
            (words(braces, image), "without braces"),
            (words(scene, image, elf=cut), "not an ELF file, or a damaged one"),
            (words(scene, image, elf=built("mps2-an385/walk.elf")), f"is for board mps2-an385, not for {BOARD}"),
            (words(scene, image, more=("--probe", "jlink")), "it may be openocd"),
            (words(scene, image, more=("--dry-run",)), "DRY_RUN needs a PROBE")):
        assert_one_sentence(run_cli("flash", *arguments, PATH=path), sentence)
    assert not (tmp_path / "bin" / "arguments").exists()


def test_a_missing_openocd(scene, image):
    assert_one_sentence(run_cli("flash", *words(scene, image), PATH="/nowhere"), "sudo apt-get install openocd")


@pytest.mark.parametrize("board", sorted(CONFIGURED))
def test_openocd_knows_the_configuration(scene, board):
    """It reads all of it and gets as far as looking for a probe, of which none
    has the serial number that it is told."""
    assert shutil.which("openocd"), "tools/setup.sh test installs it"
    command = probe.command(firmware.load(built(f"{board}/walk.elf")), scene)
    first = command.index("-c")
    command[first:first] = ["-c", "adapter serial fixel-none"]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT)
    assert done.returncode == 1
    assert "** OpenOCD init failed **" in done.stderr, done.stderr
    for wrong in ("Can't find", "invalid command", "wrong # args", "Unexpected command line"):
        assert wrong not in done.stderr
    for name in CONFIGURED[board].split():
        assert name == "-f" or any((pathlib.Path(folder) / name).exists() for folder in
                                   ("/usr/share/openocd/scripts", "/usr/local/share/openocd/scripts"))
