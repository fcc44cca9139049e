# SPDX-License-Identifier: MIT
"""Files that are odd: FIFOs, which must not be waited for, names that a terminal would obey, a file for a folder, a file that holds something
else than its name says; and what messages quote of an input: short, on one line, and escaped."""

import io
import os
import zipfile

import pytest
from hypothesis import given, settings, strategies as st

import warm_start
from board_programs import BOARD, scene_bytes
from conftest import CHECKOUT, assert_one_sentence, dump_bytes, environment, random_frames, run_cli, without_progress
from fixel.base import foreign, output, progress, reading
from fixel.base.errors import ToolError, one_line
from fixel.board import boot as boot_tool, emulator, flash as flash_tool, run
from fixel.board.symbols import Symbols
from fixel.model import model_file, suffixes
from fixel.report import pictures as pictures_tool
from fixel.scene import compiler
from model_files import glb, gltf, png, stl, stl_text
from test_obj import CUBE
from test_ply import binary

BUILT_PROGRAMS = ()
ODD = "n\nerror: \x1b[31m"      # of a file's name
SHOWN = "n\\nerror: \\x1b[31m"
TINY = CHECKOUT / "scenes" / "tiny.toml"


# --- FIFOs ----------------------------------------------------------------------------

@pytest.fixture
def fifo(tmp_path):
    """One that nobody writes into. A test that waits for it sleeps until fixel test ends it."""
    os.mkfifo(tmp_path / "fifo")
    return tmp_path / "fifo"


@pytest.mark.parametrize("main, words", [
    (flash_tool.main, ["--board", BOARD, "--elf", "fifo", "--scene", "scene.fxls", "--image", "out"]),
    (boot_tool.main, ["--board", BOARD, "--elf", "fifo", "--image", "scene.fxls", "--dump", "out"]),
    (pictures_tool.main, ["--dumps", "fifo", "--frames", "1", "--out", "out"])], ids=["flash", "boot", "pictures"])
def test_a_fifo_is_refused(fifo, monkeypatch, main, words):
    monkeypatch.chdir(fifo.parent)
    (fifo.parent / "scene.fxls").write_bytes(scene_bytes())
    with pytest.raises(ToolError, match="^fifo: is a FIFO; give a regular file$"):
        main(words)
    assert not os.path.exists("out")


def test_no_symbols_of_a_fifo(fifo):
    assert Symbols(fifo).registers(1, 2) == "  pc  0x00000002\n  lr  0x00000001"


# --- names ----------------------------------------------------------------------------

def assert_shown(done, code=0):
    """The name is there, escaped, and nothing that a terminal obeys."""
    text = done.stdout + done.stderr
    assert done.returncode == code and SHOWN in text and "\x1b" not in text, text
    assert sum(line.startswith("error: ") for line in text.splitlines()) == bool(code), text


def test_names_of_scenes(tmp_path):
    file = tmp_path / f"{ODD}.fxls"
    assert_shown(run_cli("build", TINY, "-o", file, "--frames", 2))
    assert_shown(run_cli("info", file))
    assert_shown(run_cli("export", "--c", "--name", "tiny", file, "-o", tmp_path / f"{ODD}.h"))


def test_names_of_textures_and_fonts(tmp_path):
    (tmp_path / "a.ppm").write_bytes(b"P6 1 1 255\n123")
    assert_shown(run_cli("texture", tmp_path / "a.ppm", "-o", tmp_path / f"{ODD}.h"))
    (tmp_path / "a.bdf").write_text("STARTFONT 2.1\nFONTBOUNDINGBOX 3 3 0 0\nSTARTPROPERTIES 2\nFONT_ASCENT 3\nFONT_DESCENT 0\n"
                                    "ENDPROPERTIES\nCHARS 1\nSTARTCHAR a\nENCODING 65\nDWIDTH 4 0\nBBX 1 1 0 0\nBITMAP\n80\n"
                                    "ENDCHAR\nENDFONT\n")
    assert_shown(run_cli("font", tmp_path / "a.bdf", "-o", tmp_path / f"{ODD}.h"))


def test_names_of_images_and_dumps(tmp_path, monkeypatch, capsys):
    """What boards are flashed with and run from, without a board."""
    result = type("Result", (), {"board": BOARD, "cpu": "m3", "frames": 2, "seconds": 1.0, "parts": (), "verified": 4,
                                 "sectors_erased": (), "image": tmp_path / ODD, "uf2": 0})
    monkeypatch.setattr(emulator, "run", lambda *_: result)
    monkeypatch.setattr(flash_tool.flash_memory, "flash", lambda *_: result)
    monkeypatch.setattr(flash_tool, "table", lambda *_: "")
    boot_tool.main(["--board", BOARD, "--elf", "a", "--image", "a", "--dump", ODD])
    flash_tool.main(["--board", BOARD, "--elf", "a", "--scene", "a.fxls", "--image", ODD])
    said = capsys.readouterr().out
    assert said.count(SHOWN) == 2 and "\x1b" not in said, said


def test_names_of_a_run(capsys):
    summary = {"board": BOARD, "cpu": "m3", "scene": ODD, "width": 1, "height": 1, "frames": 1, "pixels": 1,
               "pixels_differing": None, "program": "grey", "polygons": {"in": 1}, "driver": None,
               "instructions_per_frame": {"min": None}, "cycles_per_frame": {"min": None}, "host_frames_equal": True, "frames_empty": 0,
               "order_wrong_pixels": None, "pixels_unexplained": None, "wires_frames_equal": None, "kept": [], "spilled_note": "",
               "frame_crc_all": "00000000", "sent_crc_all": None,
               "display_bytes": 2, "display_bytes_by_boxes": None, "display_share_saved": None, "boxes_unknown": ""}
    run.print_summary(summary, ODD)
    said = capsys.readouterr().out
    assert said.count(SHOWN) == 3 and "\x1b" not in said, said


def test_labels_of_progress(capsys):
    with progress.Progress(ODD) as shown:
        shown.last_shown -= progress.PLAIN_INTERVAL
        shown(1)
    assert capsys.readouterr().err == f"{SHOWN}: 1\n"


@pytest.mark.parametrize("verb, words", [("info", [f"{ODD}.fxls"]), ("build", [f"{ODD}.toml", "-o", "out"]),
                                         ("build", [f"{ODD}/x.obj", "-o", "out"]),
                                         ("font", [f"{ODD}.bdf", "--name", "a", "-o", "out"]),
                                         ("pictures", ["--dumps", ODD, "--frames", "1", "--out", "out"])])
def test_an_error_with_a_name_is_one_line(verb, words):
    done = run_cli(verb, *words)
    assert_shown(done, code=2)
    assert len(without_progress(done.stderr)) == 1, done.stderr


def test_the_lines_of_a_compiler_stay(tmp_path):
    """What another program said keeps its line breaks; the message has none."""
    script = ("import sys; sys.path.insert(0, 'tools'); from fixel.base import errors\n"
              "def main(argv): raise errors.ToolError(argv[0], words='why\\nand where\\x1b')\n"
              "errors.run_main(main)\n")
    (tmp_path / "fail.py").write_text(script)
    done = warm_start.run([str(tmp_path / "fail.py"), "a\nb"], CHECKOUT, environment())
    assert (done.returncode, done.stderr) == (2, "error: a\\nb\nwhy\nand where\\x1b\n")


def test_a_name_is_told_whole():
    """One from the command line: a person gave it."""
    assert one_line("x" * 200) == "x" * 200 and one_line(ODD) == SHOWN
    assert_one_sentence(run_cli("info", "x" * 200), "x" * 200)


# --- what is given for something else -------------------------------------------------

def test_a_file_for_a_folder(tmp_path):
    (tmp_path / "b.bdf").write_text("mine")
    words = ["--board", BOARD, "--scene", TINY, "--build", tmp_path / "b.bdf"]
    sizes = [f"--{name}=1" for name in ("band", "order", "list", "cache")]
    for verb, more in (("predict", sizes), ("run", ["--out", tmp_path / "out"])):
        assert_one_sentence(run_cli(verb, *words, *more), f"{tmp_path / 'b.bdf'}: is there and is not a folder")
    with pytest.raises(ToolError, match="b.bdf/below: the folder cannot be made: Not a directory"):
        output.make_folder(tmp_path / "b.bdf" / "below")
    assert (tmp_path / "b.bdf").read_text() == "mine"


@pytest.mark.parametrize("frames", ["a", "", "1,", "-1", "1.5", "9" * 5000])
def test_numbers_of_frames_that_are_none(tmp_path, frames):
    done = run_cli("pictures", "--run", tmp_path, f"--frames={frames}", "--out", tmp_path / "p.png")
    assert_one_sentence(done, "--frames is", "like 30,45,105")
    assert len(done.stderr) < 200 and not list(tmp_path.iterdir())


def test_a_frame_that_a_dump_has_not(tmp_path):
    (tmp_path / "a.fxld").write_bytes(dump_bytes(random_frames(2)))
    for number, code in ((1, 0), (2, 2)):
        done = run_cli("pictures", "--dumps", tmp_path / "a.fxld", "--frames", number, "--out", tmp_path / "p.png")
        assert done.returncode == code, done.stderr
    assert_one_sentence(done, "a.fxld: has no frame 2")


# --- what a file holds ------------------------------------------------------------------------

def _zip(name):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        archive.writestr(name, CUBE)
    return out.getvalue()


DATA = {
    "obj": CUBE.encode(), "marked obj": CUBE.encode("utf-16"), "glb": glb(*gltf()), "gltf": b'{"asset": {"version": "2.0"}}', "ply": binary(),
    "stl": stl([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]), "text stl": stl_text(), "zip": _zip("a.obj"), "3mf": _zip("3D/3dmodel.model"),
    "fbx": b"Kaydara FBX Binary  \0\x1a\0" + bytes(90), "fbx text": b"; FBX 7.3.0 project file\n", "blend": b"BLENDER-v293" + bytes(90),
    "dae": b'<?xml version="1.0"?>\n<COLLADA xmlns="x">', "usd": b"#usda 1.0\n", "vox": b"VOX \x96\0\0\0MAIN", "7z": b"7z\xbc\xaf\x27\x1c\0",
    "page": b"<!DOCTYPE html>\n<html>", "lfs": b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n", "png": png([[(1, 2, 3)]])}
WORDS = {"obj": "an OBJ file: rename it to .obj", "marked obj": "an OBJ file: rename", "glb": "a GLB file: rename it to .glb", "gltf": "a JSON text.*rename it to .gltf",
         "ply": "a PLY file: rename it to .ply", "stl": "an STL file: rename it to .stl", "text stl": "an STL file: rename it to .stl",
         "zip": "an archive: unpack it", "3mf": "a 3MF file: .*STL", "fbx": "an FBX file: .*Blender", "fbx text": "an FBX file: .*Blender",
         "blend": "a file of Blender: .*glTF", "dae": "a Collada file: .*Blender", "usd": "a USD file: .*Blender", "vox": "a file of MagicaVoxel: export it there as OBJ",
         "7z": "an archive: unpack", "page": "a web page.*download", "lfs": "a pointer of Git LFS.*git lfs pull", "png": "an image: 'fixel texture'"}
OWN = {"obj": {"obj", "marked obj"}, "glb": {"glb", "gltf"}, "gltf": {"glb", "gltf"}, "ply": {"ply"}, "stl": {"stl", "text stl"}}


@pytest.mark.parametrize("suffix", OWN)
@pytest.mark.parametrize("kind", DATA)
def test_content_goes_before_the_name(tmp_path, suffix, kind):
    path = tmp_path / f"model.{suffix}"
    path.write_bytes(DATA[kind])
    if kind in OWN[suffix]:
        if kind != "gltf":      # which has no face
            assert model_file.reader_of(path)(str(path))[0].faces
        return
    with pytest.raises(ToolError, match=f"model.{suffix}: holds {WORDS[kind]}"):
        model_file.reader_of(path)(str(path), path.name)


@pytest.mark.parametrize("head", [b"ply\n", b"solid thing\nfacet", b"<html>", b"glTF", b"v 1 2 3\n", b"PK\x03\x04"])
def test_a_binary_stl_file_may_begin_with_anything(tmp_path, head):
    path = tmp_path / "model.stl"
    path.write_bytes(head.ljust(80, b" ") + DATA["stl"][80:])
    assert len(model_file.reader_of(path)(str(path))[0].faces) == 4


# Beginnings of formats that no test above has; what they must be named.
BEGINNINGS = {
    "bbmodel": (b'{"meta":{"format_version":"4.9","model_format":"free"}}', "Blockbench"), "md2": (b"IDP2\x08\0\0\0", "Quake"), "md3": (b"IDP3", "Quake"),
    "mdl": (b"IDST\x0a\0\0\0", "Half-Life"), "iqm": (b"INTERQUAKEMODEL\0", "Inter-Quake"), "md5mesh": (b"MD5Version 10\n", "Doom 3"),
    "bsp": (b"IBSP\x2e\0\0\0", "level"), "old bsp": (b"\x1d\0\0\0" + bytes(40), "level"), "map": (b'// Game: Quake\n// Format: Valve\n{\n"classname" "worldspawn"\n}', "TrenchBroom"),
    "tmx": (b'<?xml version="1.0" encoding="UTF-8"?>\n<map version="1.10">', "Tiled"), "tmj": (b'{ "compressionlevel":-1,\n "height":8,', "Tiled"),
    "ldtk": (b'{\n\t"__header__": {\n\t\t"fileType": "LDtk Project JSON"', "LDtk"),
    "aseprite": (b"\x40\0\0\0\xe0\xa5" + bytes(40), "Aseprite"), "ttf": (b"\0\1\0\0\0\x0c" + bytes(40), "TrueType"), "otf": (b"OTTO\0", "OpenType"), "woff2": (b"wOF2", "font"),
    "bdf": (b"STARTFONT 2.1\n", "fixel font"), "qoi": (b"qoif\0\0\0\x08", "QOI"), "svg": (b'<?xml version="1.0"?>\n<svg xmlns="x">', "SVG"), "dds": (b"DDS ", "DDS"),
    "tif": (b"II*\0", "TIFF"), "psd": (b"8BPS", "PSD"), "3ds": (b"MM\x10\0\0\0\x02\0\x0a\0\0\0", "3D Studio"), "step": (b"ISO-10303-21;\nHEADER;", "STEP"),
    "ifc": (b"ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));", "IFC"), "usdz": (b"PK\x03\x04" + bytes(26) + b"house.usdc", "USD"), "jpg": (b"\xff\xd8\xff\xe0", "fixel texture"),
    "godot": (b"[gd_scene load_steps=2 format=3]\n", "Godot"), "dxf": (b"  0\r\nSECTION\r\n", "DXF"), "las": (b"LASF", "points"), "ole": (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "SolidWorks"),
    "fxls": (b"FXLS" + bytes(40), "scene image"), "mtl": (b"# Blender MTL\nnewmtl a\n", "materials")}


@pytest.mark.parametrize("kind", BEGINNINGS)
def test_a_file_without_an_ending_is_known_by_how_it_begins(tmp_path, kind):
    blob, word = BEGINNINGS[kind]
    (tmp_path / "unnamed").write_bytes(blob)
    with pytest.raises(ToolError, match=f"unnamed: holds .*{word}"):
        compiler.compile_scene(str(tmp_path / "unnamed"))
    (tmp_path / "model.obj").write_bytes(blob)
    with pytest.raises(ToolError, match=f"model.obj: holds .*{word}"):
        compiler.compile_scene(str(tmp_path / "model.obj"))


@pytest.mark.parametrize("found", foreign.FORMATS, ids=lambda found: found.kind)
def test_a_format_is_known_by_its_endings_whatever_is_in_the_file(tmp_path, found):
    """Each row names what the file is and a way on. A file that is not there, or says nothing, is known by its name; an object of a scene is
    refused alike."""
    assert found.endings or found.beginning
    assert len(found.way.split()) >= 3 and not found.way.endswith(".")
    for ending in found.endings:
        path = tmp_path / f"thing{ending.upper()}"
        for blob in (None, b"\x9d\xfe nothing that begins like a file"):
            if blob:
                path.write_bytes(blob)
            with pytest.raises(ToolError) as refused:
                compiler.compile_scene(str(path))
            assert found.kind in refused.value.message and found.way in refused.value.message
        (tmp_path / "scene.toml").write_text(f'[path]\norbit = {{ radius = 4 }}\n[[objects]]\nmodel = "thing{ending}"\n')
        with pytest.raises(ToolError) as refused:
            compiler.compile_scene(str(tmp_path / "scene.toml"))
        assert found.way in refused.value.message


def test_no_ending_is_of_two_formats_or_of_one_that_is_read():
    endings = [ending for found in foreign.FORMATS for ending in found.endings]
    assert len(endings) == len(set(endings)) and not set(endings) & set(suffixes.READ)


@pytest.mark.parametrize("kind, name, word", [("zip", "level.litematic", "Minecraft"), ("zip", "part.f3d", "Fusion"), ("zip", "thing.zip", "unpack"),
                                              ("gltf", "level.tmj", "Tiled"), ("gltf", "cow.bbmodel", "Blockbench"), ("gltf", "thing.json", "rename")])
def test_an_archive_or_a_json_text_is_known_by_its_name_where_that_says_more(tmp_path, kind, name, word):
    (tmp_path / name).write_bytes(DATA[kind])
    with pytest.raises(ToolError, match=word):
        compiler.compile_scene(str(tmp_path / name))


@pytest.mark.parametrize("kind, word", [("ttf", "otf2bdf"), ("jpg", "no font"), ("blend", "no font")])
def test_fixel_font_names_what_it_was_given(tmp_path, kind, word):
    (tmp_path / "font").write_bytes(BEGINNINGS.get(kind, (DATA.get(kind),))[0])
    assert_one_sentence(run_cli("font", tmp_path / "font", "-o", tmp_path / "out.h"), word)


# --- what messages quote ----------------------------------------------------------------------

MOST = 80
TEXTS = st.one_of(st.text(max_size=200), st.text(alphabet="\x1b\n\"\\\u202ea", max_size=200),
                  st.integers(0, 10 ** 6).map(lambda count: "x" * count))
VALUES = st.recursive(st.one_of(TEXTS, st.integers(), st.floats(), st.booleans(), st.integers(1, 40000).map(lambda bits: 1 << bits)),
                      lambda inner: st.one_of(st.lists(inner, max_size=9), st.dictionaries(TEXTS, inner, max_size=9)),
                      max_leaves=20)
fixed = settings(max_examples=300, deadline=None, database=None, derandomize=True)


@fixed
@given(VALUES)
def test_a_value_is_quoted_short(value):
    text = reading.quoted(value)
    assert text.isprintable() and 0 < len(text) <= MOST + 2 * isinstance(value, str), text   # and two quotes


@fixed
@given(TEXTS)
def test_words_of_others_are_shortened(words):
    text = reading.shortened(words)
    assert text.isprintable() and len(text) <= MOST, text


def test_what_is_short_is_told_whole():
    assert reading.quoted("x" * MOST) == '"' + "x" * MOST + '"'
    assert reading.quoted("x" * (MOST + 1)) == '"' + "x" * (MOST - 3) + '..."'
    assert reading.shortened("y" * MOST) == "y" * MOST
    assert reading.shortened("y" * MOST + "z") == "y" * 40 + "..." + "y" * 36 + "z"
    assert (reading.quoted('a"\\\n\x1b'), reading.quoted(5), reading.quoted([1, "b"])) == (
        '"a\\"\\\\\\n\\x1b"', "5", "[1, 'b']")


@pytest.mark.parametrize("table, row, use", [
    ("textures", 'pattern = "crate"\nsize = [4, 4]\n', 'solid = "box"\ntexture = "none"'),
    ("billboards", 'pattern = "tree"\npixels = [8, 8]\nsize = [1, 1]\n', 'billboard = "none"')])
def test_the_names_that_there_are(tmp_path, table, row, use):
    """A list of all of them would be as long as the file, and could hold what a terminal obeys."""
    file, name = tmp_path / "scene.toml", "\\u001b[31m" + "x" * 500
    file.write_text(f'[[{table}]]\nname = "{name}"\n{row}[[objects]]\n{use}\n')
    with pytest.raises(ToolError, match='there is no .* "none"') as refused:
        compiler.compile_scene(str(file))
    there = str(refused.value).split(f"the scene's {table}: ")[1]
    assert there.isprintable() and len(there) <= MOST, there


def test_files_outside_the_folder_of_a_name_are_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(reading, "_confined", None)
    for name in ("here/x.toml", "here/below/y", "z"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(name)
    (tmp_path / "here/in").symlink_to("below/y")
    (tmp_path / "here/out").symlink_to("../z")
    for folder, named, before in ((tmp_path / "here", "x.toml", ""), (tmp_path, "here/x.toml", "here/")):
        monkeypatch.chdir(folder)
        reading.confine(named)
        for name in ("x.toml", "below/y", "in", "below/../x.toml"):
            with reading.open_file(before + name) as file:
                assert file.read()
        for name in ("../z", "out"):
            with pytest.raises(ToolError, match=f"is outside {'here' if before else '.'}, the folder of {named}"):
                reading.open_file(before + name)
    # What the user named may itself be a link.
    reading.confine("here/out")
    with reading.open_file("here/out") as file:
        assert file.read() == b"z"
