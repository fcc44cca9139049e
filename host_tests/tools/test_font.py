# SPDX-License-Identifier: MIT
"""fixel font: BDF files into headers that compilers take and that draw what the file shows, and refusals in one
sentence."""

import pathlib
import re
import subprocess
import tempfile

import pytest
from hypothesis import given, strategies as st

from fixel.image import font as c_font
from board_programs import ROOT
from conftest import assert_one_sentence, run_cli
from fixel.image import bdf
from fixel.base.errors import ToolError
from fuzzing import fuzzed, short_refusals, taken
from test_export import COMPILERS, compiled, printed

BUILT_PROGRAMS = ()
HEAD = """STARTFONT 2.1
FONT -made-for-the-test
SIZE 9 75 75
FONTBOUNDINGBOX 9 9 0 -2
STARTPROPERTIES 2
FONT_ASCENT 7
FONT_DESCENT 2
ENDPROPERTIES
CHARS 3
"""
QUESTION = """STARTCHAR question
ENCODING 63
SWIDTH 500 0
DWIDTH 4 0
BBX 3 3 0 0
BITMAP
E0
40
40
ENDCHAR
"""
WIDE = """STARTCHAR wide
ENCODING 65
SWIDTH 500 0
DWIDTH 10 0
BBX 9 2 -1 -2
BITMAP
80FF
FF80
ENDCHAR
"""
SPACE = """STARTCHAR space
ENCODING 66
SWIDTH 500 0
DWIDTH 3 0
BBX 0 0 0 0
BITMAP
ENDCHAR
"""
SOUND = HEAD + QUESTION + WIDE + SPACE + "ENDFONT\n"

PROGRAM = """
#include <stdio.h>
#include "font.h"
int main(void)
{
    static uint8_t pixels[20][24];
    const fxl_band band = {pixels[0], 24, 24, 0, 20, NULL, 0, 0};
    const fxl_text_style style = {&made_font, 1, 0};
    if (fxl_draw_text(&band, 1, 0, "A?BA\\n@", &style) != FXL_OK) { return 1; }
    for (int row = 0; row < 20; row++) {
        for (int column = 0; column < 24; column++) { putchar(pixels[row][column] ? 'X' : '.'); }
        putchar('\\n');
    }
    return 0;
}
"""


def written(folder, text, *options):
    """A header from a file of this text."""
    (folder / "made.bdf").write_text(text, encoding="latin-1")
    done = run_cli("font", folder / "made.bdf", "-o", folder / "font.h", *options)
    assert done.returncode == 0, done.stderr
    assert re.fullmatch(r"(note: .*\n)*.*/font.h: [a-z]+_font, [0-9]+ characters\n", done.stderr), done.stderr
    return (folder / "font.h").read_text()


def picture_of(tmp_path, compiler):
    return printed(compiled(tmp_path, PROGRAM, "-I", tmp_path, compiler=compiler,
                            name="main.cc" if "++" in compiler[0] else "main.c")).splitlines()


@pytest.mark.parametrize("compiler", COMPILERS, ids=" ".join)
def test_a_font_is_drawn_as_its_file_shows_it(tmp_path, compiler):
    """overlay 4.4c."""
    written(tmp_path, SOUND)
    rows = picture_of(tmp_path, compiler)
    wanted = [["."] * 24 for _ in range(20)]

    def put(left, top, *lines):
        for y, line in enumerate(lines):
            for x, letter in enumerate(line):
                if letter == "X":
                    wanted[top + y][left + x] = "X"
    # The baseline is row 7 of a line of 9; a pen at 1; A begins one pixel to the left of its pen.
    put(0, 7, "X.......X", "XXXXXXXXX")
    put(11, 4, "XXX", ".X.", ".X.")
    put(17, 7, "X......", "XXXXXXX")
    put(1, 13, "XXX", ".X.", ".X.")
    assert rows == ["".join(row) for row in wanted]


def test_what_is_right_of_the_width_is_not_drawn():
    assert bdf.parse(SOUND, "x").glyphs[65].rows == [b"\x80\x80", b"\xff\x80"]


def test_characters_are_chosen_and_the_unknown_one_is_among_them(tmp_path):
    """overlay 4.4f, 4.4k."""
    assert "made_font = {\n    made_bits, made_glyphs, 4, 63, 63, 9\n}" in written(tmp_path, SOUND)
    assert "made_font = {\n    made_bits, made_glyphs, 2, 65, 65, 9\n}" in written(tmp_path, SOUND, "--characters", "64-70")
    assert "other_font" in written(tmp_path, SOUND, "--name", "other")
    # A box stands in for the ascent and the descent.
    assert ", 63, 9\n}" in written(tmp_path, SOUND.replace("FONT_ASCENT 7\nFONT_DESCENT 2\n", ""))


@pytest.mark.parametrize("file, name", [("helvR12-ISO8859-1.bdf", "helvR12_ISO8859_1"), ("6x13 B.bdf", "font_6x13_B"),
                                         ("fxl.bdf", "font_fxl"), ("\u00fc.bdf", "font"), ("plain.bdf", "plain")])
def test_names_come_from_those_of_files(tmp_path, file, name):
    (tmp_path / file).write_text(SOUND)
    done = run_cli("font", tmp_path / file, "-o", tmp_path / "font.h")
    assert done.returncode == 0 and f": {name}_font, 3 characters" in done.stderr, done.stderr
    assert f"{name}_font = " in (tmp_path / "font.h").read_text()


def test_a_file_without_its_end_is_read_with_a_note(tmp_path):
    """overlay 4.4h."""
    whole = written(tmp_path, SOUND)
    assert written(tmp_path, SOUND.replace("ENDFONT\n", "")) == whole
    assert any("ENDFONT is missing" in note for note in bdf.parse(SOUND.replace("ENDFONT\n", ""), "x").notes)
    assert not bdf.parse(SOUND, "x").notes


def test_a_font_without_letters_of_ascii_is_written_whole(tmp_path):
    """overlay 4.4f."""
    text = HEAD + QUESTION.replace("ENCODING 63", "ENCODING 7") + WIDE.replace("ENCODING 65", "ENCODING 200") + "ENDFONT\n"
    assert "made_glyphs, 194, 7, 7, 9\n" in written(tmp_path, text)
    (tmp_path / "made.bdf").write_text(text)
    done = run_cli("font", tmp_path / "made.bdf", "-o", tmp_path / "font.h")
    assert "none of the characters 32-126: those from 7 to 200 are written" in done.stderr and "2 characters" in done.stderr


def test_a_font_whose_codes_are_all_above_255_is_numbered_anew(tmp_path):
    """overlay 4.4g."""
    text = HEAD + WIDE.replace("ENCODING 65", "ENCODING 57345") + QUESTION.replace("ENCODING 63", "ENCODING 945") + "ENDFONT\n"
    font = bdf.parse(text, "x")
    alone = bdf.parse(SOUND, "x")
    assert font.glyphs == {32: alone.glyphs[63], 33: alone.glyphs[65]}
    assert font.notes == ["x: all 2 characters have codes above 255: U+03B1 to U+E001, in turn, are written as 32 to 33"]
    many = HEAD + "".join(QUESTION.replace("ENCODING 63", f"ENCODING {code}") for code in range(1000, 1300)) + "ENDFONT\n"
    assert "all 300 characters have codes above 255: U+03E8 to U+04C7, in turn, are written as 32 to 255" in bdf.parse(many, "x").notes[0]


def test_code_0_and_characters_without_codes_are_not_all_that_a_font_has():
    """overlay 4.4j."""
    alone = bdf.parse(SOUND, "x")
    control, none = QUESTION.replace("ENCODING 63", "ENCODING 0"), QUESTION.replace("ENCODING 63", "ENCODING -1 9")
    font = bdf.parse(HEAD + control + none + WIDE.replace("ENCODING 65", "ENCODING 65281") + "ENDFONT\n", "x")
    assert font.glyphs == {32: alone.glyphs[65]} and "all 1 characters have codes above 255: U+FF01 to U+FF01" in font.notes[0]
    font = bdf.parse(HEAD + none + WIDE.replace("ENCODING 65", "ENCODING -1") + "ENDFONT\n", "x")
    assert font.glyphs == {32: alone.glyphs[63], 33: alone.glyphs[65]}
    assert font.notes == ["x: all 2 characters have no code: the first 2, in turn, are written as 32 to 33"]
    above = WIDE.replace("ENCODING 65", "ENCODING 945")
    for ignored in (none, above):
        assert bdf.parse(SOUND.replace("ENDFONT", ignored + "ENDFONT"), "x") == alone


def test_a_mark_a_comment_and_an_advance_of_the_whole_font():
    alone = bdf.parse(SOUND, "x")
    assert bdf.parse("\xef\xbb\xbfCOMMENT made by hand\n" + SOUND, "x") == alone
    whole = SOUND.replace("DWIDTH 4 0\n", "").replace("FONTBOUNDINGBOX", "DWIDTH 4 0\nFONTBOUNDINGBOX")
    assert bdf.parse(whole, "x") == alone


@pytest.mark.parametrize("text, words", [
    ("", "is not a BDF font"),
    ("STARTFONT 2.1\n", "ENDFONT is missing"),
    (HEAD + "ENDFONT\n", "has none of the characters 32-126"),
    (SOUND.replace("FONT_ASCENT 7", "FONT_ASCENT high"), "must have 1 whole number"),
    (SOUND.replace("FONT_ASCENT 7", "FONT_ASCENT 255"), "pixels high"),
    (SOUND.replace("FONT_ASCENT 7", "FONT_ASCENT 200"), "at most 127"),
    (SOUND.replace("BBX 3 3 0 0", "BBX 3 300 0 0"), "is outside -255..255"),
    (SOUND.replace("BBX 3 3 0 0", "BBX -3 3 0 0"), "a box of -3 x 3 pixels"),
    (SOUND.replace("BBX 3 3 0 0", "BBX 3 3"), "must have 4 whole numbers"),
    (SOUND.replace("BBX 3 3 0 0\n", ""), "BITMAP stands before BBX"),
    (SOUND.replace("DWIDTH 4 0\n", ""), "has no DWIDTH"),
    (SOUND.replace("DWIDTH 4 0", "DWIDTH -4 0"), "goes to the left"),
    (SOUND.replace("80FF", "80"), "expected a row of 2 or more bytes"),
    (SOUND.replace("40\n40\n", "40\n"), "expected a row"),
    (SOUND.replace("ENCODING 65", "ENCODING 63"), "a second time"),
    (HEAD + QUESTION.replace("ENDCHAR\n", "") + "ENDFONT\n", "does not end"),
    (SOUND.replace("FONT_ASCENT 7\n", "").replace("FONTBOUNDINGBOX 9 9 0 -2\n", ""), "how high a line is"),
])
def test_what_is_no_font_is_refused_in_one_sentence(tmp_path, text, words):
    (tmp_path / "made.bdf").write_text(text)
    done = run_cli("font", tmp_path / "made.bdf", "-o", tmp_path / "font.h")
    assert_one_sentence(done)
    assert done.returncode == 2 and words in done.stderr and not (tmp_path / "font.h").exists()


@pytest.mark.parametrize("arguments, words", [
    (["--characters", "9"], "like 32-126"), (["--characters", "0-5"], "like 32-126"),
    (["--characters", "50-40"], "like 32-126"), (["--name", "2x"], "must begin with a letter")])
def test_arguments_that_cannot_be_are_refused(tmp_path, arguments, words):
    (tmp_path / "made.bdf").write_text(SOUND)
    done = run_cli("font", tmp_path / "made.bdf", "-o", tmp_path / "font.h", *arguments)
    assert_one_sentence(done)
    assert done.returncode == 2 and words in done.stderr


@pytest.mark.parametrize("text, codes", [("1-255", (1, 255)), ("65-65", (65, 65)), ("032-126", (32, 126))])
def test_codes_of_characters(text, codes):
    assert c_font.parse_characters(text) == codes


@pytest.mark.parametrize("text", ["0-5", "5-4", "1-256", "1-2000", "-5", "5-", "5", "5-6-7", " 5-6", "a-b", ""])
def test_codes_that_no_character_has(text):
    with pytest.raises(ToolError, match="like 32-126, from 1 to 255"):
        c_font.parse_characters(text)


def test_pictures_of_too_many_bytes_are_refused():
    row = "FF" * 32 + "\n"
    large = "".join(f"STARTCHAR c\nENCODING {code}\nDWIDTH 255 0\nBBX 255 100 0 0\nBITMAP\n{row * 100}ENDCHAR\n"
                    for code in range(40, 70))
    with pytest.raises(ToolError, match="more than 65,535 bytes"):
        c_font.header(bdf.parse(HEAD.replace("ASCENT 7", "ASCENT 100") + large + "ENDFONT\n", "x"), "x", "x", 32, 126)


LINES = st.sampled_from([*SOUND.splitlines(), "BBX 255 255 -255 255", "ENCODING -1", "ENCODING 99999999999", "BITMAP",
                         "DWIDTH 0 0", "FF", "F", "\x1b[31m", "FONT_DESCENT -200", "9" * 5000, "BBX \u0663 1 1 1", ""])


@fuzzed(0.15)
@given(st.lists(LINES, max_size=12), st.integers(0, 30), st.integers(0, 5))
def test_any_lines_give_a_font_or_one_sentence(lines, place, cut):
    whole = SOUND.splitlines()
    text = "\n".join(whole[:place] + lines + whole[place + cut:]) + "\n"
    with tempfile.TemporaryDirectory() as folder:
        file, out = pathlib.Path(folder, "made.bdf"), pathlib.Path(folder, "font.h")
        file.write_bytes(text.encode("utf-8"))
        sound = taken["sound"]
        with short_refusals(folder):
            c_font.export(str(file), str(out))
        assert out.exists() == (taken["sound"] > sound)
        if out.exists() and place % 10 == 0:
            check = subprocess.run(["gcc", "-fsyntax-only", "-x", "c", f"-I{ROOT}/lib/include", str(out)], check=False,
                                   capture_output=True, text=True)
            assert check.returncode == 0, check.stderr
