# SPDX-License-Identifier: MIT
"""For the tests of the live window: viewers, and what they start and leave behind."""

import pathlib
import re
import socket
import time

import pytest

from fixel.scene import making
from board_programs import ROOT, built

BOARDS = ("mps2-an385", "lm3s6965evb", "host")
WIDTH, HEIGHT = 1280, 800   # of the browser's window
SCREEN = (160, 120)         # of the plaza: a browser's driver copies each frame, so they are small


def ready(board, build):
    """Sees to it that what a viewer of a board starts is built; the board."""
    built(f"{board}/walk" if board == "host" else f"{board}/walk.elf")
    assert (build / "host" / "live").exists(), "make all builds it"
    return board


@pytest.fixture(scope="module", name="scene")
def plaza_image(tmp_path_factory):
    """The plaza as a scene image, so that not every viewer compiles it."""
    image = tmp_path_factory.mktemp("plaza") / "plaza.fxls"
    making.build(str(ROOT / "scenes" / "plaza.toml"), str(image), screen=SCREEN)
    return image


@pytest.fixture(scope="module", name="board", params=BOARDS)
def ready_board(request, build):
    """A board; what a viewer of it starts is built."""
    return ready(request.param, build)


def own_build(build, folder):
    """A folder with the programs of build, in which no other test's viewers leave anything."""
    for name in ("boards", "host"):
        (folder / name).symlink_to(build / name)
    return folder


def port_of(address):
    return int(re.search(r":(\d+)/", address)[1])


def left(build):
    """The folders of viewers that have not ended."""
    return {path.name for path in build.glob(".fixel-view-*")}


def children(process):
    """{number: command} of all that a process started, and what those started. A process that is about to
    become another program has no command for a moment: that moment is waited out."""
    found = processes_below(process)
    for _ in range(100):
        if all(found.values()):
            break
        time.sleep(0.02)
        found = processes_below(process)
    return found


def processes_below(process):
    """The same, as it is at this moment."""
    parents, commands = {}, {}
    for path in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            command = (path / "cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
            parents[int(path.name)] = int((path / "stat").read_text().rpartition(")")[2].split()[1])
            commands[int(path.name)] = command
        except OSError:
            pass    # it has just ended
    found, new = {}, {process}
    while new:
        new = {number for number, parent in parents.items() if parent in new}
        found |= {number: commands[number] for number in new}
    return found


def runs(number):
    """Whether a process does; one that nobody has waited for yet does not."""
    try:
        return pathlib.Path(f"/proc/{number}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def assert_gone(numbers):
    """Waits until none of them runs any more."""
    while any(map(runs, numbers)):
        time.sleep(0.05)


def assert_started(found):
    for names in (("qemu-system-arm", "host/walk"), ("host/live",)):    # the host is no emulated board
        assert any(name in command for command in found.values() for name in names), found


def own_port():
    """The words that give a viewer a port which no other test's viewer takes after it."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return "--port", str(free.getsockname()[1])


def assert_refuses(address):
    with pytest.raises(ConnectionRefusedError):
        socket.create_connection(("127.0.0.1", port_of(address)))


def wait_for_rest(page):
    """A frame may have been under way when the board was paused. The board's answer to a step comes after it."""
    page.wait_for_function("""() => new Promise((resolve) => {
        let seen = null;
        const look = () => {
            const number = document.getElementById("number").textContent;
            if (number === seen) {
                resolve(true);
            } else {
                seen = number;
                setTimeout(look, 500);
            }
        };
        look();
    })""")
