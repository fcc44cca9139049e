# SPDX-License-Identifier: MIT
"""make gdb: a debugger on the running program, and nothing left when it ends."""

import fcntl
import os
import pathlib
import pty
import re
import select
import signal
import subprocess
import sys
import termios
import time

import pytest

from board_programs import BOARD, ROOT, built, fake_qemu
from conftest import LAUNCHER, assert_one_sentence, environment, run_cli
from fixel.base import limits
from fixel.scene import making
from fixel.board import gdb, flash_memory, qemu

BUILT_PROGRAMS = ()
ELSEWHERE = "stm32vldiscovery"  # its flash does not begin at 0


@pytest.fixture(scope="module")
def walk():
    return built(f"{BOARD}/walk.elf")


def flashed(board, folder):
    """A board's flash image with its walk and a scene."""
    making.build(str(ROOT / "scenes" / "tiny.toml"), str(folder / "tiny.fxls"))
    flash_memory.flash(board, built(f"{board}/walk.elf"), folder / "tiny.fxls", folder / "board.bin")
    return folder / "board.bin"


@pytest.fixture(scope="module")
def image(tmp_path_factory):
    return flashed(BOARD, tmp_path_factory.mktemp("flash"))


def words(image, walk, *more, board=BOARD):
    return ["--board", board, "--image", image, "--elf", walk, *more]


def started_in(folder):
    """Programs that run in a folder below this one: here, emulators."""
    found = []
    for entry in pathlib.Path("/proc").glob("[0-9]*/cwd"):
        try:
            where = os.readlink(entry)
        except OSError:
            continue
        if where.startswith(f"{folder}/"):
            found.append(where)
    return found


@pytest.mark.parametrize("board", [BOARD, ELSEWHERE])
def test_a_file_of_commands(board, tmp_path):
    image, commands = flashed(board, tmp_path), tmp_path / "commands"
    commands.write_text("break fxl_frame_begin\ncontinue\nbacktrace\nprint renderer->scene->instance_count\n"
                        "print/rx *pose\nprint *pose\ndelete\ncontinue\n", encoding="ascii")
    done = run_cli("gdb", *words(image, built(f"{board}/walk.elf"), "--frames", 2, "--commands", commands,
                                 board=board), TMPDIR=str(tmp_path))
    assert done.returncode == 0, done.stdout + done.stderr
    assert re.search(r"^Temporary breakpoint 1, main \(.*firmware/walk/main\.c:\d+$", done.stdout, re.MULTILINE)
    assert re.search(r"^Breakpoint 2, fxl_frame_begin \(.*lib/draw/render\.c:\d+$", done.stdout, re.MULTILINE)
    assert re.search(r"^#\d+ .*\bwalk \(\) at firmware/walk/walk\.c:\d+$", done.stdout, re.MULTILINE)
    assert re.search(r"^#\d+ .*\bmain \(", done.stdout, re.MULTILINE)
    assert re.search(r"^\$1 = [1-9]\d*$", done.stdout, re.MULTILINE), done.stdout
    assert re.search(r"^\$2 = \{position = \{x = 0x", done.stdout, re.MULTILINE), done.stdout
    assert re.search(r"^\$3 = \{position = \{x = -?[\d.e-]+ \[-?\d+\], .*yaw = [\d.e-]+ degrees \[0x[\da-f]{8}\]",
                     done.stdout, re.MULTILINE), done.stdout
    assert "exited with code 0135" in done.stdout  # 93: the program ran on to its agreed end
    assert "walk: done 2 frames" in done.stdout + done.stderr
    assert not started_in(tmp_path)


NUMBERS = """#include <fixel/types.h>
volatile fxl_q16_16 length = FXL_UNITS(-2) - 32768;
fxl_q2_30 sine = 1 << 29;
fxl_q1_31 part = 1u << 31;
fxl_q18_46 product = INT64_C(-3) << 44;
const fxl_angle left = FXL_DEGREES(-12);
fxl_angle quarter = FXL_DEGREES(90);
int32_t plain = 65536;
int main(void) { return left == 0; }
"""


def test_numbers_and_angles_are_printed_readably(tmp_path):
    """By a program of this machine."""
    (tmp_path / "numbers.c").write_text(NUMBERS, encoding="ascii")
    subprocess.run(["gcc", "-g", f"-I{ROOT / 'lib' / 'include'}", tmp_path / "numbers.c", "-o", tmp_path / "numbers"], check=True)
    names = ("length", "sine", "part", "product", "left", "quarter", "plain", "/r length")
    asked = [word for name in names for word in ("-ex", f"print{name}" if name.startswith("/") else f"print {name}")]
    done = subprocess.run([gdb.GDB, "-nx", "-q", "-batch", "-ex", f"source {gdb.PRINTERS}", *asked, tmp_path / "numbers"],
                          text=True, capture_output=True, check=True)
    assert [line.partition(" = ")[2] for line in done.stdout.splitlines()] == [
        "-2.5 [-163840]", "0.5 [536870912]", "1 [2147483648]", "-0.75 [-52776558133248]", "-12 degrees [0xf7777777]",
        "90 degrees [0x40000000]", "65536", "-163840"], done.stderr


def test_programs_name_no_folder_of_the_checkout_and_sources_are_found(image, walk, tmp_path):
    """From another folder too."""
    for program in (walk, built("host/walk")):
        assert os.fsencode(ROOT) not in program.read_bytes()
    commands = tmp_path / "commands"
    commands.write_text("list main\ninfo source\n")
    done = subprocess.run([sys.executable, LAUNCHER, "gdb", *words(image, walk, "--commands", commands)], cwd=tmp_path,
                          text=True, capture_output=True, check=False, env=environment())
    assert done.returncode == 0, done.stdout + done.stderr
    assert re.search(r"^\d+\s+int main\(", done.stdout, re.MULTILINE), done.stdout
    assert f"Located in {ROOT}/firmware/walk/" in done.stdout, done.stdout


def test_a_command_that_fails(image, walk, tmp_path):
    (tmp_path / "commands").write_text("break no_such_function_at_all\nprint no_such_thing\n", encoding="ascii")
    done = run_cli("gdb", *words(image, walk, "--commands", tmp_path / "commands"), TMPDIR=str(tmp_path))
    assert done.returncode != 0
    assert not started_in(tmp_path)


class Terminal:
    """fixel gdb at a terminal, and a person before it."""

    def __init__(self, folder, *arguments):
        self.ours, theirs = pty.openpty()
        self.seen = ""
        self.process = subprocess.Popen(
            [sys.executable, LAUNCHER, "gdb", *map(str, arguments)], stdin=theirs, stdout=theirs,
            stderr=theirs, start_new_session=True, cwd=ROOT,
            env=environment(TMPDIR=str(folder), TERM="dumb", HOME=str(folder)),
            preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0))
        os.close(theirs)

    def expect(self, text):
        while text not in self.seen:
            if select.select([self.ours], [], [], 0.1)[0]:
                self.seen += os.read(self.ours, 4096).decode(errors="replace")
            else:
                assert self.process.poll() is None, self.seen
        self.seen = self.seen.split(text, 1)[1]

    def works(self):
        """Waits until the processes have used some more CPU time."""
        watch = limits.Watch(self.process.pid, cpu=3600.0)
        while watch.check() is None and watch.used == 0.0:
            time.sleep(0.01)
        used = watch.used
        while watch.check() is None and watch.used < used + 0.2:
            time.sleep(0.01)

    def type(self, text):
        os.write(self.ours, text.encode())

    def close(self):
        self.process.kill()
        self.process.wait()
        os.close(self.ours)


@pytest.fixture
def terminal(tmp_path):
    opened = []

    def start(*arguments):
        opened.append(Terminal(tmp_path, *arguments))
        return opened[-1]

    yield start
    for one in opened:
        one.close()


def test_a_person_interrupts_and_quits(image, walk, tmp_path, terminal):
    one = terminal(*words(image, walk, "--frames", 1000000))
    one.expect("Temporary breakpoint 1, main")
    one.expect("(gdb) ")
    one.type("continue\n")
    one.expect("Continuing.")
    one.works()     # the program runs: QEMU uses the processor, which it does not while it is stopped
    one.type("\x03")
    one.expect("SIGINT")
    one.expect("(gdb) ")
    one.type("print/d sizeof(fxl_pose)\n")
    one.expect("= 24")
    assert started_in(tmp_path)
    one.type("quit\n")
    assert one.process.wait() == 0
    assert not started_in(tmp_path)


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_tool_that_is_ended_takes_the_emulator_with_it(image, walk, tmp_path, terminal, number):
    one = terminal(*words(image, walk))
    one.expect("(gdb) ")
    assert started_in(tmp_path)
    one.process.send_signal(number)
    assert one.process.wait() == 128 + number
    assert not started_in(tmp_path)


def test_what_is_refused(image, walk, tmp_path):
    assert_one_sentence(run_cli("gdb", *words(tmp_path / "none.bin", walk)), "make flash BOARD=")
    assert_one_sentence(run_cli("gdb", *words(image, built(f"{BOARD}/faults.elf"))), "does not hold")
    assert_one_sentence(run_cli("gdb", *words(image, walk, "--commands", tmp_path / "none")), "no such file")
    assert_one_sentence(run_cli("gdb", "--board", "host", "--image", image, "--elf", built("host/walk")),
                        "needs no emulator")
    assert_one_sentence(run_cli("gdb", *words(image, walk), PATH=str(tmp_path)), "apt-get install qemu-system-arm")
    (tmp_path / qemu.QEMU).symlink_to(qemu.find_qemu())
    assert_one_sentence(run_cli("gdb", *words(image, walk), PATH=str(tmp_path)), "apt-get install gdb-multiarch")


def test_an_emulator_that_does_not_start(image, walk, tmp_path):
    path = fake_qemu(tmp_path / "bin", "echo no such machine >&2; exit 1")
    (tmp_path / "commands").write_text("backtrace\n", encoding="ascii")
    done = run_cli("gdb", *words(image, walk, "--commands", tmp_path / "commands"), PATH=path)
    assert_one_sentence(done, "did not start", code=1)
    assert "no such machine" in done.stderr
