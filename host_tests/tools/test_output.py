# SPDX-License-Identifier: MIT
"""What a tool writes, and where it does not: symbolic links stay, and what is no file is refused, and what the tool has read, by any name."""

import json
import os
import re
import resource
import shutil
import socket
import stat
import threading

import pytest
from PIL import Image

import warm_start
from board_programs import BOARD, built
from conftest import CHECKOUT, LAUNCHER, TOOLS, assert_one_sentence, dump_bytes, environment, random_frames, run_cli, run_make
from fixel.base import output, reading
from fixel.base.errors import ToolError
from fixel.board import emulator, flash_memory
from fixel.scene import making
from model_files import gltf, png

BUILT_PROGRAMS = ("boards/host/walk", "boards/mps2-an385/walk.elf")


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


# --- inputs stay ------------------------------------------------------------------------------

OBJ = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n"
MTL = "newmtl a\nKd 1 1 1\nmap_Kd p.png\n"
STL = "solid x\n" + "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n" + "endsolid\n"
FONT = """STARTFONT 2.1
FONT x
SIZE 8 75 75
FONTBOUNDINGBOX 8 8 0 0
STARTPROPERTIES 2
FONT_ASCENT 7
FONT_DESCENT 1
ENDPROPERTIES
CHARS 1
STARTCHAR A
ENCODING 65
SWIDTH 500 0
DWIDTH 8 0
BBX 1 1 0 0
BITMAP
80
ENDCHAR
ENDFONT
"""


@pytest.fixture
def inputs(tmp_path):
    """A scene that names each kind of file, and the other files that commands read."""
    picture = png([[[255, 0, 0], [0, 255, 0]], [[0, 0, 255], [9, 9, 9]]])
    (tmp_path / "p.png").write_bytes(picture)
    (tmp_path / "wall.png").write_bytes(picture)
    (tmp_path / "tree.png").write_bytes(picture)
    (tmp_path / "m.mtl").write_text(MTL)
    (tmp_path / "m.obj").write_text(OBJ)
    (tmp_path / "m.stl").write_text(STL)
    data, blob = gltf(uvs=[(0, 0), (1, 0), (1, 1), (0, 1)], image=picture)
    data["buffers"] = [{"byteLength": len(blob), "uri": "m.bin"}]
    (tmp_path / "m.bin").write_bytes(blob)
    (tmp_path / "m.gltf").write_text(json.dumps(data))
    (tmp_path / "scene.toml").write_text(
        '[[textures]]\nname = "wall"\nfile = "wall.png"\n'
        '[[billboards]]\nname = "tree"\nfile = "tree.png"\nsize = [1, 1]\n'
        '[[objects]]\nsolid = "box"\ntexture = "wall"\n[[objects]]\nbillboard = "tree"\nposition = [3, 0, 0]\n'
        '[[objects]]\nmodel = "m.obj"\nposition = [0, 3, 0]\n[[objects]]\nmodel = "m.stl"\nposition = [0, 0, 3]\n'
        '[[objects]]\nmodel = "m.gltf"\nposition = [0, 0, 6]\n')
    (tmp_path / "font.bdf").write_text(FONT)
    (tmp_path / "a.fxld").write_bytes(dump_bytes(random_frames(1)))
    return tmp_path


def contents(inputs):
    return {path.name: path.read_bytes() for path in inputs.iterdir() if path.is_file()}


def assert_refused(done, inputs, before, name):
    assert_one_sentence(done, name, "has read it as input", "name another file")
    assert contents(inputs) == before


NAMED = ["scene.toml", "wall.png", "tree.png", "m.obj", "m.mtl", "p.png", "m.stl", "m.gltf", "m.bin"]


def test_the_control(inputs):
    """The commands of this file do their work where the output is another file."""
    for command in (["build", inputs / "scene.toml", "-o", inputs / "out"],
                    ["export", "--c", "--name", "x", inputs / "m.obj", "-o", inputs / "out"],
                    ["texture", inputs / "p.png", "-o", inputs / "out"],
                    ["font", inputs / "font.bdf", "-o", inputs / "out"]):
        done = run_cli(*command)
        assert done.returncode == 0, done.stderr
        (inputs / "out").unlink()


@pytest.mark.parametrize("name", NAMED)
def test_build(inputs, name):
    before = contents(inputs)
    assert_refused(run_cli("build", inputs / "scene.toml", "-o", inputs / name), inputs, before, name)


@pytest.mark.parametrize("name", ["m.obj", "m.mtl", "p.png"])
def test_export(inputs, name):
    before = contents(inputs)
    done = run_cli("export", "--c", "--name", "x", inputs / "m.obj", "-o", inputs / name)
    assert_refused(done, inputs, before, name)


def test_export_of_an_image(inputs):
    making.build(str(CHECKOUT / "scenes" / "tiny.toml"), str(inputs / "tiny.fxls"), 2)
    before = contents(inputs)
    done = run_cli("export", "--c", inputs / "tiny.fxls", "-o", inputs / "tiny.fxls")
    assert_refused(done, inputs, before, "tiny.fxls")


@pytest.mark.parametrize("command", [["texture", "p.png"], ["font", "font.bdf"]])
def test_texture_and_font(inputs, command):
    before, (*words, name) = contents(inputs), command
    assert_refused(run_cli(*words, inputs / name, "-o", inputs / name), inputs, before, name)


@pytest.mark.parametrize("make", [os.link, os.symlink])
def test_another_name_of_the_input(inputs, make):
    make(inputs / "m.obj", inputs / "other")
    before = contents(inputs)
    assert_refused(run_cli("build", inputs / "scene.toml", "-o", inputs / "other"), inputs, before, "other")


@pytest.mark.parametrize("name", ["frame_diff.png", "compare.json"])
def test_compare(inputs, name):
    """In the inputs of results the pictures of the comparison before are replaced: not if they are compared now."""
    (inputs / "out").mkdir()
    for each, colour in (("out/" + name, 1), ("b.png", 2)):
        (inputs / each).write_bytes(png([[[colour, 0, 0]]]))
    if name != "compare.json":      # it says which pictures it wrote
        (inputs / "out" / "compare.json").write_text('{"per_frame": [{"name": "frame", "pixels_differing": 1}]}')
    before = contents(inputs / "out")
    done = run_cli("compare", "--a", inputs / "out" / name, "--b", inputs / "b.png", "--out", inputs / "out")
    assert_refused(done, inputs / "out", before, name)


@pytest.fixture(scope="module")
def board_image(tmp_path_factory):
    path = tmp_path_factory.mktemp("flash")
    making.build(str(CHECKOUT / "scenes" / "tiny.toml"), str(path / "tiny.fxls"), 2)
    flash_memory.flash(BOARD, built(f"{BOARD}/walk.elf"), path / "tiny.fxls", path / "board.bin")
    return path / "board.bin"


@pytest.mark.parametrize("which", ["image", "elf"])
def test_boot(inputs, board_image, which):
    files = {"image": inputs / "board.bin", "elf": inputs / "walk.elf"}
    files["image"].write_bytes(board_image.read_bytes())
    files["elf"].write_bytes(built(f"{BOARD}/walk.elf").read_bytes())
    before = contents(inputs)
    done = run_cli("boot", "--board", BOARD, "--elf", files["elf"], "--image", files["image"], "--dump", files[which])
    assert_refused(done, inputs, before, files[which].name)


def test_flash(inputs, board_image):
    """The image is replaced, although it is read; the scene is not."""
    (inputs / "tiny.fxls").write_bytes(board_image.with_name("tiny.fxls").read_bytes())
    (inputs / "board.bin").write_bytes(board_image.read_bytes())
    words = ["flash", "--board", BOARD, "--elf", built(f"{BOARD}/walk.elf"), "--scene", inputs / "tiny.fxls", "--image"]
    done = run_cli(*words, inputs / "board.bin")
    assert done.returncode == 0, done.stderr
    before = contents(inputs)
    done = run_cli("flash", "--board", "host", "--elf", built("host/walk"), "--scene", inputs / "tiny.fxls", "--image",
                   inputs / "tiny.fxls")
    assert_refused(done, inputs, before, "tiny.fxls")


@pytest.mark.parametrize("words, name", [(["predict", f"BOARD={BOARD}", "JSON"], "m.obj"),
                                         (["predict", f"BOARD={BOARD}", "JSON"], "p.png"),
                                         (["screen", "BOARD=lm3s6965evb", "FRAMES=1", "SCREEN=128x64", "PICTURE"], "m.obj")])
def test_variables_of_make(inputs, words, name):
    before, (*words, variable) = contents(inputs), words
    done = run_make(*words, f"SCENE={inputs / 'm.obj'}", f"{variable}={inputs / name}")
    assert f"error: {inputs / name}: cannot be written: this command has read it as input" in done.stderr, done.stderr
    assert done.returncode and contents(inputs) == before


# --- in a process -----------------------------------------------------------------------

def test_what_this_process_wrote_it_may_write_again(tmp_path):
    output.write_file(tmp_path / "file", b"one")
    assert reading.read_all(tmp_path / "file") == b"one"
    output.write_file(tmp_path / "file", b"two")
    assert (tmp_path / "file").read_bytes() == b"two"


def test_what_another_process_opened(tmp_path):
    """A process that reads for this one tells it what it has opened."""
    (tmp_path / "input").write_bytes(b"in")
    found = os.stat(tmp_path / "input")
    reading.note_opened([[found.st_dev, found.st_ino]])     # as JSON would have it
    assert (found.st_dev, found.st_ino) in reading.opened()
    with pytest.raises(ToolError, match="has read it as input"):
        output.write_file(tmp_path / "input", b"out")
    assert (tmp_path / "input").read_bytes() == b"in"
