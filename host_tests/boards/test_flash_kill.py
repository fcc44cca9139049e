# SPDX-License-Identifier: MIT
"""A flash that is killed: whenever it happens, the image is the old one or the
new one, it boots, and the next flash finds nothing in its way."""

import os
import resource
import signal
import subprocess
import sys
import time

import pytest
import warm_start

from board_programs import BOARD, ROOT, built, fake_qemu
from conftest import LAUNCHER, environment, run_cli
from fixel.scene import making
from fixel.board import emulator, flash_memory

BUILT_PROGRAMS = ()


# fixel flash, which gets SIGKILL before its Nth line in the files that write the image.
KILLED_AT_LINE = """
import os, signal, sys
at = int(sys.argv.pop(1))
seen = 0
def trace(frame, event, _):
    global seen
    if not frame.f_code.co_filename.endswith(("/flash_image.py", "/output.py", "/scratch.py")):
        return None
    if event == "line":
        seen += 1
        if seen == at:
            os.kill(os.getpid(), signal.SIGKILL)
    return trace
sys.path.insert(0, "tools")
from fixel.board import flash
from fixel.base.errors import run_main
def main(argv):
    sys.settrace(trace)
    code = flash.main(argv)
    sys.settrace(None)
    return code
run_main(main)
"""
# The same, which gets a signal that ends it when a file grows past a limit.
KILLED_AT_SIZE = """
import resource, signal, sys
size = int(sys.argv.pop(1))
signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
sys.path.insert(0, "tools")
from fixel.board import flash
from fixel.base.errors import run_main
run_main(flash.main)
"""
LINES_MAX = 400


@pytest.fixture(scope="module")
def walk():
    return built(f"{BOARD}/walk.elf")


@pytest.fixture(scope="module")
def scenes(tmp_path_factory):
    """The scene that is there, and the one that is to come."""
    folder = tmp_path_factory.mktemp("scenes")
    for name, frames in (("old", 2), ("new", 3)):
        making.build(str(ROOT / "scenes" / "tiny.toml"), str(folder / f"{name}.fxls"), frames)
    return folder / "old.fxls", folder / "new.fxls"


@pytest.fixture
def image(tmp_path, walk, scenes):
    path = tmp_path / "flash" / "board.bin"
    flash_memory.flash(BOARD, walk, scenes[0], path)
    return path


def flash_command(walk, scene, image):
    return ["--board", BOARD, "--elf", walk, "--scene", scene, "--image", image]


def killed(driver, at, walk, scene, image):
    """A flash with a driver from above: its exit code."""
    words = ["fixel flash", at, *flash_command(walk, scene, image)]
    return warm_start.run([*map(str, words)], ROOT, environment(), driver).returncode


def boots_with(image, walk, folder):
    """How many frames a board draws from an image: 2 from the old one, 3 from the new one."""
    return emulator.run(BOARD, image, walk, folder / "frames.fxld").frames


def test_killed_at_any_line(image, walk, scenes, tmp_path):
    old = image.read_bytes()
    flash_memory.flash(BOARD, walk, scenes[1], tmp_path / "new.bin")
    new = (tmp_path / "new.bin").read_bytes()
    assert old != new
    states = []     # whether it is the new image; one that equals an image that has booted boots too
    for at in range(1, LINES_MAX, 2):
        image.write_bytes(old)
        code = killed(KILLED_AT_LINE, at, walk, scenes[1], image)
        assert code in (0, -signal.SIGKILL)
        if code == 0:
            break
        data = image.read_bytes()
        assert data in (old, new), f"neither the old nor the new image after line {at}"
        if (data == new) not in states:
            assert boots_with(image, walk, tmp_path) == (3 if data == new else 2)
        states.append(data == new)
    assert 20 < len(states) < LINES_MAX // 2  # it was killed often, and got through in the end
    assert False in states and True in states and states == sorted(states)
    assert [path.name for path in image.parent.iterdir()] == [image.name]  # the last one tidied up


@pytest.mark.parametrize("size", [0, 1, 4096, 1 << 20, (4 << 20) - 1])
def test_killed_within_a_write(image, walk, scenes, tmp_path, size):
    old = image.read_bytes()
    assert killed(KILLED_AT_SIZE, size, walk, scenes[1], image) == -signal.SIGXFSZ
    assert image.read_bytes() == old
    left = [path for path in image.parent.iterdir() if path != image]
    # With less room not even the journal can be written, and then no file is made.
    assert [path.stat().st_size for path in left] == ([size] if size >= 4096 else [])
    assert boots_with(image, walk, tmp_path) == 2
    assert run_cli("flash", *flash_command(walk, scenes[1], image)).returncode == 0
    assert [path.name for path in image.parent.iterdir()] == [image.name]
    assert boots_with(image, walk, tmp_path) == 3


def test_a_full_disk(image, walk, scenes):
    old = image.read_bytes()

    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 20, 1 << 20))

    done = subprocess.run([sys.executable, LAUNCHER, "flash", *flash_command(walk, scenes[1], image)],
                          capture_output=True, text=True, preexec_fn=limit, check=False)
    assert done.returncode == 2
    assert done.stderr == f"error: {image}: cannot be written: File too large; it is unchanged\n"
    assert image.read_bytes() == old
    assert [path.name for path in image.parent.iterdir()] == [image.name]


def test_a_cleaner_finds_no_file_before_it_is_locked(image, walk, scenes, monkeypatch):
    """Another flash comes just when this one has made its file."""
    real, others = os.open, []

    def make(path, *arguments, **options):
        handle = real(path, *arguments, **options)
        if os.path.dirname(path) == str(image.parent) and not others:
            others.append(None)
            others.append(run_cli("flash", *flash_command(walk, scenes[0], image)))
            assert os.path.exists(path)
        return handle

    monkeypatch.setattr(os, "open", make)
    flash_memory.flash(BOARD, walk, scenes[1], image)
    assert others[1].returncode == 0, others[1].stderr
    assert [path.name for path in image.parent.iterdir()] == [image.name]


def test_two_at_a_time_leave_each_other_alone(image, walk, scenes, tmp_path):
    """The one that verifies must still have its file when the other has tidied up."""
    go = tmp_path / "go"
    path = fake_qemu(tmp_path / "bin", f"touch {tmp_path}/started; while [ ! -e {go} ]; do sleep 0.05; done; "
                                       'exec "$REAL" "$@"')
    slow = subprocess.Popen([sys.executable, LAUNCHER, "flash", *flash_command(walk, scenes[0], image)],
                            env={**os.environ, "PATH": path}, stdout=subprocess.DEVNULL)
    while not (tmp_path / "started").exists():
        assert slow.poll() is None
        time.sleep(0.02)
    flash_memory.flash(BOARD, walk, scenes[1], image)
    assert boots_with(image, walk, tmp_path) == 3
    go.touch()
    assert slow.wait() == 0
    assert boots_with(image, walk, tmp_path) == 2
    assert [path.name for path in image.parent.iterdir()] == [image.name]
