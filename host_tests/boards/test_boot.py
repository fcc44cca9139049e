# SPDX-License-Identifier: MIT
"""Powering a board on: a whole dump or none, and no ending that passes for a
success without being one."""

import resource
import shutil
import signal
import struct
import subprocess
import sys
import zlib

import pytest

from board_programs import BOARD, built, fake_qemu, scene_bytes, tiny_scene
from conftest import LAUNCHER
from fixel.board import emulator, firmware, flash_memory
from fixel.base.errors import ToolError

BUILT_PROGRAMS = ()
FRAMES = 3


@pytest.fixture(scope="module")
def walk():
    return built(f"{BOARD}/walk.elf")


@pytest.fixture(scope="module")
def faults():
    return built(f"{BOARD}/faults.elf")


@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    return tiny_scene(tmp_path_factory.mktemp("scene"))


@pytest.fixture(scope="module")
def image(tmp_path_factory, walk, scene):
    path = tmp_path_factory.mktemp("flash") / "board.bin"
    flash_memory.flash(BOARD, walk, scene, path)
    return path


@pytest.fixture(scope="module")
def faults_image(tmp_path_factory, faults, scene):
    path = tmp_path_factory.mktemp("faults") / "board.bin"
    flash_memory.flash(BOARD, faults, scene, path)
    return path


@pytest.fixture
def dump(tmp_path):
    """Where a dump is to go; one of an earlier run is there."""
    path = tmp_path / "out" / "walk.fxld"
    path.parent.mkdir()
    path.write_bytes(b"earlier")
    return path


def refuse(dump, *arguments, **options):
    """The sentence of a failure; the dump of the earlier run must still be there,
    and nothing beside it."""
    with pytest.raises(ToolError) as caught:
        emulator.run(*arguments, dump, **options)
    assert caught.value.exit_code != 0
    assert dump.read_bytes() == b"earlier"
    assert [path.name for path in dump.parent.iterdir()] == [dump.name]
    return str(caught.value)


def pixels_and_poses(data):
    """A dump without its instruction counts and checksum."""
    _, _, width, height, _, frames = struct.unpack_from("<4sHHHHI", data)
    size = 32 + width * height + 48
    parts = [data[784 + n * size:784 + (n + 1) * size - 8] for n in range(frames)]
    return data[:784], parts


def test_a_run(image, walk, dump):
    seen = []
    result = emulator.run(BOARD, image, walk, dump, FRAMES, progress=lambda *step: seen.append(step))
    assert (result.board, result.cpu, result.frames) == (BOARD, "cortex-m3", FRAMES)
    assert seen[-1] == (FRAMES, FRAMES) and seen == sorted(seen)
    data = dump.read_bytes()
    assert data[:4] == b"FXLD" and data[-12:-8] == b"FEND"
    assert struct.unpack_from("<I", data, 12)[0] == FRAMES
    assert struct.unpack("<I", data[-4:])[0] == zlib.crc32(data[:-4])
    assert [path.name for path in dump.parent.iterdir()] == [dump.name]


def test_two_runs_are_identical_to_the_last_instruction(image, walk, tmp_path):
    for name in ("a", "b"):
        emulator.run(BOARD, image, walk, tmp_path / name, FRAMES)
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes()
    counts = [struct.unpack("<Q", part[-8:])[0] for part in frames_of((tmp_path / "a").read_bytes())]
    assert all(count > 10000 and count % 40 == 0 for count in counts)


def frames_of(data):
    _, _, width, height, _, frames = struct.unpack_from("<4sHHHHI", data)
    size = 32 + width * height + 48
    return [data[784 + n * size:784 + (n + 1) * size] for n in range(frames)]


def test_the_board_draws_what_the_host_draws_in_other_bands(image, walk, scene, tmp_path):
    emulator.run(BOARD, image, walk, tmp_path / "board", None)
    subprocess.run([built("host/walk"), scene, tmp_path / "host"], check=True, stderr=subprocess.DEVNULL)
    assert pixels_and_poses((tmp_path / "board").read_bytes()) == pixels_and_poses((tmp_path / "host").read_bytes())


def test_a_folder_with_blanks_and_commas(image, walk, tmp_path):
    folder = tmp_path / "a folder, with 'marks'"
    folder.mkdir()
    shutil.copy(image, folder / "x,y z.bin")
    emulator.run(BOARD, folder / "x,y z.bin", walk, folder / "d,e f.fxld", 1)
    assert (folder / "d,e f.fxld").stat().st_size > 784


@pytest.mark.parametrize("case, words", [
    ("reset", "a reset"),
    ("liar", "ended without the program's exit code"),
    ("mute", "did not print its end marker"),
    ("no-dump", "left no frame dump"),
    ("lockup", "locked up"),
    ("stack", "the stack overflowed"),
    ("divide", "division by zero"),
    ("flash", "write to flash"),
    ("nonsense", "an argument was not understood"),
    ("chatter", "prints without end"),
])
def test_an_ending_that_is_no_success(faults_image, faults, dump, case, words):
    assert words in refuse(dump, BOARD, faults_image, faults, extra=[case])


def test_a_hang(faults_image, faults, dump):
    assert "it hangs" in refuse(dump, BOARD, faults_image, faults, timeout=1, extra=["hang"])


def test_an_emulator_that_is_terminated(faults_image, faults, dump, tmp_path, monkeypatch):
    """QEMU answers SIGTERM with exit code 0, once it catches it: the 15th bit."""
    catches = "grep -Eq '^SigCgt:.*[4-7c-f][0-9a-f]{3}$' /proc/$pid/status"
    script = f'"$REAL" "$@" & pid=$!; until {catches}; do sleep 0.1; done; kill -TERM $pid; wait $pid'
    monkeypatch.setenv("PATH", fake_qemu(tmp_path / "bin", script))
    assert "terminated" in refuse(dump, BOARD, faults_image, faults, extra=["hang"])


def test_a_host_that_takes_only_part_of_the_dump(image, walk, dump, tmp_path, monkeypatch):
    """/dev/full takes nothing, and says so only when it is written to."""
    script = "ln -sf /dev/full frames.fxld; exec \"$REAL\" \"$@\""
    monkeypatch.setenv("PATH", fake_qemu(tmp_path / "bin", script))
    words = refuse(dump, BOARD, image, walk)
    assert f"exit {emulator.exit_code('DISPLAY')}" in words
    assert "did not take every pixel" in words


@pytest.mark.parametrize("spoil, words", [
    (lambda data: data[:-8] + b"\xff" * 8, "check"),
    (lambda data: data[:200] + bytes([data[200] ^ 1]) + data[201:], "check"),
    (lambda data: data[:4] + b"\x01" + data[5:], "version"),
    (lambda data: b"\xff" * len(data), "scene image"),
    (lambda data: data[:8] + struct.pack("<I", 0x7FFFFFFC) + data[12:], ""),
])
def test_a_bad_scene_ends_with_a_status_and_no_fault(image, walk, scene, dump, tmp_path, spoil, words):
    program = firmware.load(walk)
    data, _ = flash_memory.program_flash(program, spoil(scene.read_bytes()), image.read_bytes())
    bad = tmp_path / "bad.bin"
    bad.write_bytes(data)
    sentence = refuse(dump, BOARD, bad, walk)
    assert f"exit {emulator.exit_code('SCENE')}: the scene image was refused" in sentence
    assert words in sentence.split("walk: scene refused:")[1]


def test_an_image_of_another_program(image, faults, dump):
    assert "does not hold" in refuse(dump, BOARD, image, faults)


def test_an_image_of_another_size(image, walk, dump, tmp_path):
    cut = tmp_path / "cut.bin"
    cut.write_bytes(image.read_bytes()[:-1])
    assert "is not a flash image" in refuse(dump, BOARD, cut, walk)


def test_no_image(walk, dump, tmp_path):
    assert "make flash BOARD=mps2-an385" in refuse(dump, BOARD, tmp_path / "none.bin", walk)


def test_another_board(image, walk, dump):
    assert "is for board mps2-an385, not for host" in refuse(dump, "host", image, walk)


def test_a_missing_emulator(image, walk, dump, monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    assert "sudo apt-get install qemu-system-arm" in refuse(dump, BOARD, image, walk)


def test_a_dump_that_cannot_be_written(image, walk, tmp_path):
    (tmp_path / "file").write_bytes(b"")
    with pytest.raises(ToolError, match="cannot be written"):
        emulator.run(BOARD, image, walk, tmp_path / "file" / "walk.fxld", 1)
    with pytest.raises(ToolError, match="it is a folder"):
        emulator.run(BOARD, image, walk, tmp_path, 1)


def test_the_command(image, walk, dump):
    command = [sys.executable, LAUNCHER, "boot", "--board", BOARD, "--image", image, "--elf", walk,
               "--dump", dump, "--frames", "2"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "2 frames" in done.stdout
    done = subprocess.run([*command[:-1], "0"], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    done = subprocess.run([*command[:6], image.with_name("none.bin"), *command[7:]],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "error: cannot read the flash image" in done.stderr


def host(*arguments, limit=None):
    def prepare():
        if limit is not None:
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    return subprocess.run([built("host/walk"), *arguments], capture_output=True, text=True, check=False,
                          preexec_fn=prepare)


def test_the_host_as_a_board(scene, dump):
    image = dump.parent.parent / "host.bin"
    flash_memory.flash("host", built("host/walk"), scene, image)
    result = emulator.run("host", image, built("host/walk"), dump, FRAMES)
    assert (result.board, result.frames) == ("host", FRAMES)
    assert dump.read_bytes()[:4] == b"FXLD"


def test_the_host_leaves_no_part_of_a_dump(scene, dump):
    done = host(scene, dump, limit=4096)
    assert done.returncode == emulator.exit_code("DISPLAY")
    assert "cannot write" in done.stderr
    assert dump.read_bytes() == b"earlier"
    assert [path.name for path in dump.parent.iterdir()] == [dump.name]


@pytest.mark.parametrize("arguments, code, words", [
    ((), "ARGUMENT", "usage"),
    (("{scene}", "{dump}", "x"), "ARGUMENT", "FRAMES is a number"),
    (("{scene}", "{dump}", "-1"), "ARGUMENT", "FRAMES is a number"),
    (("{scene}", "{dump}", "1000001"), "ARGUMENT", "FRAMES is a number"),
    (("{dump}.none", "{dump}"), "STORE", "cannot read"),
    (("/", "{dump}"), "STORE", "cannot read"),
    (("{dump}", "{dump}"), "SCENE", "walk: scene refused"),
    (("{scene}", "{dump}/x"), "DISPLAY", "cannot write"),
    (("{scene}", "/"), "DISPLAY", "cannot write"),
])
def test_the_host_refuses(scene, dump, arguments, code, words):
    done = host(*(word.format(scene=scene, dump=dump) for word in arguments))
    assert done.returncode == emulator.exit_code(code), done.stderr
    assert words in done.stderr
    assert dump.read_bytes() == b"earlier"
    assert [path.name for path in dump.parent.iterdir()] == [dump.name]


def test_a_scene_that_only_looks_like_one(walk, dump, tmp_path):
    """The flash tool takes it; the loader on the board does not."""
    fake = tmp_path / "fake.fxls"
    fake.write_bytes(scene_bytes())
    image = tmp_path / "fake.bin"
    flash_memory.flash(BOARD, walk, fake, image)
    assert "walk: scene refused" in refuse(dump, BOARD, image, walk)
