# SPDX-License-Identifier: MIT
"""No tool overwrites what it has read: an output that is one of its inputs, by any name, is refused."""

import json
import os

import pytest

from board_programs import BOARD, built
from conftest import CHECKOUT, assert_one_sentence, dump_bytes, random_frames, run_cli, run_make
from fixel.base import output, reading
from fixel.scene import making
from fixel.board import flash_memory
from fixel.base.errors import ToolError
from model_files import gltf, png

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
def folder(tmp_path):
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


def contents(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


def assert_refused(done, folder, before, name):
    assert_one_sentence(done, name, "has read it as input", "name another file")
    assert contents(folder) == before


NAMED = ["scene.toml", "wall.png", "tree.png", "m.obj", "m.mtl", "p.png", "m.stl", "m.gltf", "m.bin"]


def test_the_control(folder):
    """The commands of this file do their work where the output is another file."""
    for command in (["build", folder / "scene.toml", "-o", folder / "out"],
                    ["export", "--c", "--name", "x", folder / "m.obj", "-o", folder / "out"],
                    ["texture", folder / "p.png", "-o", folder / "out"],
                    ["font", folder / "font.bdf", "-o", folder / "out"]):
        done = run_cli(*command)
        assert done.returncode == 0, done.stderr
        (folder / "out").unlink()


@pytest.mark.parametrize("name", NAMED)
def test_build(folder, name):
    before = contents(folder)
    assert_refused(run_cli("build", folder / "scene.toml", "-o", folder / name), folder, before, name)


@pytest.mark.parametrize("name", ["m.obj", "m.mtl", "p.png"])
def test_export(folder, name):
    before = contents(folder)
    done = run_cli("export", "--c", "--name", "x", folder / "m.obj", "-o", folder / name)
    assert_refused(done, folder, before, name)


def test_export_of_an_image(folder):
    making.build(str(CHECKOUT / "scenes" / "tiny.toml"), str(folder / "tiny.fxls"), 2)
    before = contents(folder)
    done = run_cli("export", "--c", folder / "tiny.fxls", "-o", folder / "tiny.fxls")
    assert_refused(done, folder, before, "tiny.fxls")


@pytest.mark.parametrize("command", [["texture", "p.png"], ["font", "font.bdf"]])
def test_texture_and_font(folder, command):
    before, (*words, name) = contents(folder), command
    assert_refused(run_cli(*words, folder / name, "-o", folder / name), folder, before, name)


@pytest.mark.parametrize("make", [os.link, os.symlink])
def test_another_name_of_the_input(folder, make):
    make(folder / "m.obj", folder / "other")
    before = contents(folder)
    assert_refused(run_cli("build", folder / "scene.toml", "-o", folder / "other"), folder, before, "other")


@pytest.mark.parametrize("name", ["frame_diff.png", "compare.json"])
def test_compare(folder, name):
    """In the folder of results the pictures of the comparison before are replaced: not if they are compared now."""
    (folder / "out").mkdir()
    for each, colour in (("out/" + name, 1), ("b.png", 2)):
        (folder / each).write_bytes(png([[[colour, 0, 0]]]))
    if name != "compare.json":      # it says which pictures it wrote
        (folder / "out" / "compare.json").write_text('{"per_frame": [{"name": "frame", "pixels_differing": 1}]}')
    before = contents(folder / "out")
    done = run_cli("compare", "--a", folder / "out" / name, "--b", folder / "b.png", "--out", folder / "out")
    assert_refused(done, folder / "out", before, name)


@pytest.fixture(scope="module")
def image(tmp_path_factory):
    path = tmp_path_factory.mktemp("flash")
    making.build(str(CHECKOUT / "scenes" / "tiny.toml"), str(path / "tiny.fxls"), 2)
    flash_memory.flash(BOARD, built(f"{BOARD}/walk.elf"), path / "tiny.fxls", path / "board.bin")
    return path / "board.bin"


@pytest.mark.parametrize("which", ["image", "elf"])
def test_boot(folder, image, which):
    files = {"image": folder / "board.bin", "elf": folder / "walk.elf"}
    files["image"].write_bytes(image.read_bytes())
    files["elf"].write_bytes(built(f"{BOARD}/walk.elf").read_bytes())
    before = contents(folder)
    done = run_cli("boot", "--board", BOARD, "--elf", files["elf"], "--image", files["image"], "--dump", files[which])
    assert_refused(done, folder, before, files[which].name)


def test_flash(folder, image):
    """The image is replaced, although it is read; the scene is not."""
    (folder / "tiny.fxls").write_bytes(image.with_name("tiny.fxls").read_bytes())
    (folder / "board.bin").write_bytes(image.read_bytes())
    words = ["flash", "--board", BOARD, "--elf", built(f"{BOARD}/walk.elf"), "--scene", folder / "tiny.fxls", "--image"]
    done = run_cli(*words, folder / "board.bin")
    assert done.returncode == 0, done.stderr
    before = contents(folder)
    done = run_cli("flash", "--board", "host", "--elf", built("host/walk"), "--scene", folder / "tiny.fxls", "--image",
                   folder / "tiny.fxls")
    assert_refused(done, folder, before, "tiny.fxls")


@pytest.mark.parametrize("words, name", [(["predict", f"BOARD={BOARD}", "JSON"], "m.obj"),
                                         (["predict", f"BOARD={BOARD}", "JSON"], "p.png"),
                                         (["screen", "BOARD=lm3s6965evb", "FRAMES=1", "SCREEN=128x64", "PICTURE"], "m.obj")])
def test_variables_of_make(folder, words, name):
    before, (*words, variable) = contents(folder), words
    done = run_make(*words, f"SCENE={folder / 'm.obj'}", f"{variable}={folder / name}")
    assert f"error: {folder / name}: cannot be written: this command has read it as input" in done.stderr, done.stderr
    assert done.returncode and contents(folder) == before


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
