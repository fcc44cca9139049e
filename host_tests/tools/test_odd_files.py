# SPDX-License-Identifier: MIT
"""Files that are odd: FIFOs, which must not be waited for, names that a terminal would obey, a file for a folder."""

import os

import pytest
import warm_start

from fixel.board import boot as boot_tool
from fixel.board import flash as flash_tool
from fixel.report import pictures as pictures_tool
from fixel.board import emulator, flashing, judged_run
from board_programs import BOARD, scene_bytes
from conftest import CHECKOUT, assert_one_sentence, dump_bytes, environment, random_frames, run_cli, without_progress
from fixel.base import output, progress
from fixel.base.errors import ToolError, one_line
from fixel.board.symbols import Symbols

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
    monkeypatch.setattr(flashing, "flash", lambda *_: result)
    monkeypatch.setattr(flashing, "table", lambda *_: "")
    boot_tool.main(["--board", BOARD, "--elf", "a", "--image", "a", "--dump", ODD])
    flash_tool.main(["--board", BOARD, "--elf", "a", "--scene", "a.fxls", "--image", ODD])
    said = capsys.readouterr().out
    assert said.count(SHOWN) == 2 and "\x1b" not in said, said


def test_names_of_a_run(capsys):
    summary = {"board": BOARD, "cpu": "m3", "scene": ODD, "width": 1, "height": 1, "frames": 1, "pixels": 1,
               "pixels_differing": None, "program": "grey", "polygons": {"in": 1}, "driver": None,
               "instructions_per_frame": {"min": None}, "cycles_per_frame": {"min": None}, "host_frames_equal": True, "frames_empty": 0,
               "order_wrong_pixels": None, "pixels_unexplained": None, "wires_frames_equal": None, "kept": [], "spilled_note": "",
               "frame_crc_all": "00000000", "sent_crc_all": None}
    judged_run.print_summary(summary, ODD)
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
