# SPDX-License-Identifier: MIT
"""The wire to a running QEMU: answers, refusals, time-outs, and an end that is clean."""

import asyncio
import signal
import struct
import subprocess
import threading

import pytest
from PIL import Image

from fixel.board import emulator, qemu as qmp
from fixel.base.errors import ToolError

BUILT_PROGRAMS = ()


@pytest.fixture
def qemu():
    """Starts QEMU, stopped before its first instruction: (process, machine)."""
    started = []

    def start(machine="mps2-an385", *options):
        with qmp.Channel() as channel:
            process = subprocess.Popen([emulator.find_qemu(), "-M", machine, "-display", "none", "-S",
                                        "-serial", "null", "-monitor", "none", *options, *channel.options],
                                       pass_fds=channel.fds, stdin=subprocess.DEVNULL)
            started.append(process)
            return process, channel.connect(process.pid)

    yield start
    for process in started:
        process.kill()
        process.wait()


def test_a_command_and_its_answer(qemu):
    process, machine = qemu()
    with machine:
        assert machine.execute("query-status")["running"] is False
        assert "R15=" in machine.monitor("info registers")
        machine.quit()
    assert process.wait() == 0


def test_a_refusal_names_the_command(qemu):
    _, machine = qemu()
    with machine, pytest.raises(ToolError, match="QEMU refuses 'no-such-command': .*not been found"):
        machine.execute("no-such-command")


def test_a_machine_that_died(qemu):
    process, machine = qemu()
    process.kill()
    process.wait()
    with machine, pytest.raises(ToolError, match="gone before it answered 'query-status'"):
        machine.execute("query-status")


def test_a_machine_that_is_frozen(qemu):
    process, machine = qemu()
    with machine:
        process.send_signal(signal.SIGSTOP)
        with pytest.raises(ToolError, match="did not answer 'query-status': it slept for 0.3 s"):
            machine.execute("query-status", timeout=0.3)
        process.send_signal(signal.SIGCONT)
        assert machine.execute("query-version")["qemu"]["major"] >= 7


def test_a_qemu_that_never_speaks():
    with qmp.Channel() as channel:
        process = subprocess.Popen(["sleep", "600"], pass_fds=channel.fds)
        try:
            with pytest.raises(ToolError, match="did not answer 'greeting': it slept for 0.2 s"):
                channel.connect(process.pid, timeout=0.2)
        finally:
            process.kill()
            process.wait()


def test_a_qemu_that_does_not_start():
    with qmp.Channel() as channel:
        process = subprocess.Popen(["true"], pass_fds=channel.fds)
        with pytest.raises(ToolError, match="gone before it answered 'greeting'"):
            channel.connect(process.pid)
        process.wait()


def test_keys_and_a_picture(qemu, tmp_path):
    image = tmp_path / "idle.bin"
    image.write_bytes(struct.pack("<IIH", 0x20001000, 9, 0xE7FE))  # stack, reset: b .
    _, machine = qemu("lm3s6965evb", "-device", f"loader,file={image},addr=0,force-raw=on")
    with machine:
        machine.execute("cont")
        for down in (True, False):
            machine.key("up", down)
        with pytest.raises(ToolError, match="QEMU refuses 'input-send-event'"):
            machine.key("no such key", True)
        with Image.open(machine.screendump(tmp_path / "screen.png")) as picture:
            assert (picture.format, picture.size) == ("PNG", (512, 256))
        with pytest.raises(ToolError, match="QEMU refuses 'screendump'"):
            machine.screendump(tmp_path / "none" / "screen.png")


def test_many_threads(qemu):
    _, machine = qemu()
    answers = []
    with machine:
        threads = [threading.Thread(target=lambda: answers.append(machine.execute("query-name")))
                   for _ in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    assert answers == [{}] * 8


def test_nothing_is_left(qemu):
    before = threading.active_count()
    for _ in range(3):
        process, machine = qemu()
        machine.close()
        machine.close()
        assert process.poll() is None  # closing leaves it running
    assert threading.active_count() == before


@pytest.mark.parametrize("exception, is_said", [
    (EOFError(), False), (ConnectionResetError(), False), (asyncio.CancelledError(), False), (ValueError("odd"), True)])
def test_what_an_interrupt_leaves_behind_is_not_said(exception, is_said, caplog):
    """After an interrupt nobody waits for the end of the connection, which is then no fault to be told."""
    loop = asyncio.new_event_loop()
    try:
        qmp._complain(loop, {"message": "exception was never retrieved", "exception": exception})
    finally:
        loop.close()
    assert ("never retrieved" in caplog.text) == is_said
