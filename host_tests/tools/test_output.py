# SPDX-License-Identifier: MIT
"""What a tool writes, and where it does not: symbolic links stay, and what is no file is refused."""

import os
import re
import resource
import shutil
import socket
import stat
import threading

import pytest
import warm_start
from PIL import Image

from board_programs import BOARD, built
from conftest import CHECKOUT, LAUNCHER, TOOLS, assert_one_sentence, environment, run_cli
from fixel.base import output
from fixel.scene import making
from fixel.board import emulator, flash_memory
from fixel.base.errors import ToolError


def fifo(path):
    os.mkfifo(path)


def device(path):
    """One as /dev/null, which a tool run by root may spoil without harm."""
    try:
        os.mknod(path, stat.S_IFCHR | 0o666, os.makedev(1, 3))
    except PermissionError:
        pytest.skip("only root may make a device")


def a_socket(path):
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(str(path))


THINGS = ((fifo, "a FIFO"), (device, "a device"), (a_socket, "a socket"), (os.mkdir, "a folder"))


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder of results, which is the current one: the address of a socket is short."""
    (tmp_path / "out").mkdir()
    monkeypatch.chdir(tmp_path / "out")
    return tmp_path / "out"


def assert_alone(path):
    """Nothing is beside it."""
    assert [each.name for each in path.parent.iterdir()] == [path.name]


def assert_same(path, before):
    after = os.lstat(path)
    assert (after.st_ino, after.st_mode) == (before.st_ino, before.st_mode)
    assert_alone(path)


@pytest.mark.parametrize("make, what", THINGS)
def test_what_is_no_file_is_refused(folder, make, what):
    make("thing")
    before = os.lstat("thing")
    with pytest.raises(ToolError, match=f"^thing: cannot be written: it is {what}; name a file$"):
        output.write_file("thing", b"x")
    assert_same(folder / "thing", before)


@pytest.mark.parametrize("make, what", THINGS)
def test_a_link_to_what_is_no_file_is_refused(folder, tmp_path, make, what):
    make("../thing")
    (folder / "link").symlink_to("../thing")
    with pytest.raises(ToolError, match=f"it is {what}"):
        output.write_file("link", b"x")
    assert os.readlink("link") == "../thing"
    assert_alone(folder / "link")


@pytest.mark.parametrize("before", [b"old", None])
def test_a_symbolic_link_stays(folder, tmp_path, before):
    """One to a link to a file elsewhere; also where that file is still to come."""
    (tmp_path / "far").mkdir()
    if before:
        (tmp_path / "far" / "target").write_bytes(before)
    (folder / "second").symlink_to("../far/target")
    (folder / "first").symlink_to("second")
    output.write_file("first", b"new")
    assert (os.readlink("first"), os.readlink("second")) == ("second", "../far/target")
    assert (tmp_path / "far" / "target").read_bytes() == b"new"
    assert_alone(tmp_path / "far" / "target")


def test_links_that_lead_nowhere(folder):
    (folder / "loop").symlink_to("loop")
    with pytest.raises(ToolError, match="cannot be written: Too many levels of symbolic links"):
        output.write_file("loop", b"x")


def test_a_check_that_fails_leaves_the_file_as_it_was(folder):
    (folder / "file").write_bytes(b"old")

    def check(new):
        assert new.read_bytes() == b"new" and (folder / "file").read_bytes() == b"old"
        raise ToolError("no")

    with pytest.raises(ToolError, match="no"):
        output.replace("file", b"new", check)
    assert (folder / "file").read_bytes() == b"old"
    assert_alone(folder / "file")


def test_a_folder_of_results_behind_a_link(folder, tmp_path):
    (tmp_path / "far").mkdir()
    (folder / "link").symlink_to("../far")
    with output.replaced_folder("link", ["a"]) as new:
        (new / "a").write_bytes(b"x")
    assert os.readlink("link") == "../far" and [path.name for path in (tmp_path / "far").iterdir()] == ["a"]


@pytest.mark.parametrize("make", [fifo, device, a_socket])
def test_a_folder_of_results_that_is_none(folder, make):
    make("thing")
    before = os.lstat("thing")
    with pytest.raises(ToolError, match="it is there and is not a folder"), output.replaced_folder("thing", ["a"]):
        pass
    assert_same(folder / "thing", before)


# --- as a user meets it ---------------------------------------------------------------

@pytest.fixture(scope="module")
def scene(tmp_path_factory):
    path = tmp_path_factory.mktemp("scene") / "tiny.fxls"
    making.build(str(CHECKOUT / "scenes" / "tiny.toml"), str(path), 2)
    return path


@pytest.fixture(scope="module")
def image(tmp_path_factory, scene):
    path = tmp_path_factory.mktemp("flash") / "board.bin"
    flash_memory.flash(BOARD, built(f"{BOARD}/walk.elf"), scene, path)
    return path


def commands(scene, image, out):
    """Commands that write a file, by name."""
    elf = built(f"{BOARD}/walk.elf")
    return {"build": ["build", scene.with_name("tiny.toml"), "-o", out],
            "export": ["export", "--c", "--name", "tiny", scene, "-o", out],
            "flash": ["flash", "--board", BOARD, "--elf", elf, "--scene", scene, "--image", out],
            "boot": ["boot", "--board", BOARD, "--elf", elf, "--image", image, "--dump", out]}


COMMANDS = ("build", "export", "flash", "boot")


@pytest.fixture
def command_of(scene, image):
    scene.with_name("tiny.toml").write_bytes((CHECKOUT / "scenes" / "tiny.toml").read_bytes())
    return lambda name, out: commands(scene, image, out)[name]


@pytest.mark.parametrize("make, what", [THINGS[0], THINGS[1], THINGS[3]])
@pytest.mark.parametrize("name", COMMANDS)
def test_tools_refuse_what_is_no_file(folder, command_of, name, make, what):
    make("thing")
    before = os.lstat("thing")
    assert_one_sentence(run_cli(*command_of(name, folder / "thing")), str(folder / "thing"), f"it is {what}; name a file")
    assert_same(folder / "thing", before)


@pytest.mark.parametrize("name", COMMANDS)
def test_tools_write_through_a_link(folder, tmp_path, command_of, name):
    (folder / "link").symlink_to("../target")
    done = run_cli(*command_of(name, folder / "link"))
    assert done.returncode == 0, done.stderr
    assert os.readlink("link") == "../target" and (tmp_path / "target").stat().st_size > 1000
    assert_alone(folder / "link")


@pytest.mark.parametrize("make, what", [THINGS[0], THINGS[3]])
def test_an_image_that_is_no_file_is_not_read(folder, image, scene, make, what):
    """Nobody would ever write into the FIFO."""
    make("thing")
    with pytest.raises(ToolError, match=f"cannot read the flash image: thing: is {what}; .* 'make flash BOARD={BOARD}'"):
        emulator.run(BOARD, "thing", built(f"{BOARD}/walk.elf"), "walk.fxld")
    with pytest.raises(ToolError, match=f"cannot read thing: it is {what}"):
        flash_memory.flash(BOARD, built(f"{BOARD}/walk.elf"), "thing", folder / "board.bin")


def test_no_tool_replaces_a_file_otherwise():
    """Every other file is within a folder of scratch.py or of replaced_folder; an installed wheel has links to its programs."""
    found = {str(file.relative_to(TOOLS)) for file in TOOLS.rglob("*.py")
             if re.search(r"os\.re(place|name)\(", file.read_text(encoding="utf-8"))}
    assert found == {"fixel/base/kept.py", "fixel/base/output.py", "fixel/base/placing.py", "wheel/fixel/programs.py"}


# --- while a scene is compiled ------------------------------------------------------------

@pytest.fixture
def skin(tmp_path):
    """A picture of as many texels as there are bytes that a file may have."""
    Image.new("RGB", (64, 64), (9, 99, 199)).save(tmp_path / "skin.png")
    return tmp_path / "skin.png"


@pytest.mark.parametrize("words", [["build", CHECKOUT / "scenes/tiny.toml"], ["export", "--c", CHECKOUT / "scenes/tiny.toml"], ["texture"]], ids=lambda words: words[0])
def test_a_file_that_a_limit_of_the_system_cuts_off_is_one_sentence(tmp_path, skin, words):
    """ulimit -f: the file that was there before stays."""
    words = [*words, *([skin] if words == ["texture"] else []), "-o", tmp_path / "out"]
    (tmp_path / "out").write_text("before")
    done = warm_start.run([str(LAUNCHER), *map(str, words)], CHECKOUT, environment(), limits=[(resource.RLIMIT_FSIZE, 1000)])
    assert_one_sentence(done, "out", "cannot be written", "too large")
    assert (tmp_path / "out").read_text() == "before" and sorted(path.name for path in tmp_path.iterdir()) == ["out", "skin.png"]


def test_a_scene_is_compiled_while_somebody_empties_the_folder_of_temporary_files(tmp_path):
    """A command of a damaged tool once took the temporary folder of a living one for left over."""
    place, ended = tmp_path / "tmp", threading.Event()
    place.mkdir()

    def empty():
        while not ended.is_set():
            for path in place.iterdir():
                shutil.rmtree(path, ignore_errors=True)
    cleaner = threading.Thread(target=empty)
    cleaner.start()
    try:
        done = run_cli("build", CHECKOUT / "scenes/tiny.toml", "-o", tmp_path / "out.fxls", TMPDIR=str(place))
    finally:
        ended.set()
        cleaner.join()
    assert done.returncode == 0 and (tmp_path / "out.fxls").stat().st_size, done.stderr
