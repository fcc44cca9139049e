# SPDX-License-Identifier: MIT
"""Writes a bitmap font, a BDF file, as a C header for fxl_draw_text.

    fixel font FONT.bdf -o OUT.h [--name NAME] [--characters FIRST-LAST]
        NAME: by default that of the file, with _ for what no C name has
        FIRST-LAST: codes of Latin-1, by default 32-126, or all of a font that has none of these"""

import argparse
import os
import re
import sys

from fixel.base import output
from fixel.base.errors import ToolError, one_line
from fixel.base.reading import quoted
from fixel.commands import late
from fixel.image import bdf, c_names, c_text

c_scene = late("fixel.image", "c_scene")

DEFAULT = "32-126"      # the characters that are written
BYTES_MAX = 65535       # of all pictures: fxl_glyph.first_byte


def parser():
    """The options of the command."""
    made = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    made.add_argument("font", help="a BDF file")
    made.add_argument("-o", "--out", required=True)
    made.add_argument("--name", help="what the header's names begin with; without, the file's name")
    made.add_argument("--characters", metavar="FIRST-LAST", help="codes, 32-126 by default")
    return made


def parse_characters(text):
    """First and last code from "32-126"."""
    match = re.fullmatch("([0-9]{1,3})-([0-9]{1,3})", text)
    first, last = map(int, match.groups()) if match else (1, 0)
    if not 1 <= first <= last <= 255:
        raise ToolError(f"--characters is {quoted(text)}; it must be like 32-126, from 1 to 255, the lower code first")
    return first, last


def header(font, name, source, first, last):
    """The text of a header with these characters; those that the font lacks are drawn as its unknown one."""
    there = [code for code in range(first, last + 1) if code in font.glyphs]
    if not there:
        raise ToolError(f"{source}: has none of the characters {first}-{last}")
    last = there[-1]
    unknown = ord("?") if ord("?") in there else there[0]
    bits, records = [], {}
    for code in there:
        glyph = font.glyphs[code]
        # An empty picture may begin anywhere.
        records[code] = c_text.braces(len(bits) if any(glyph.rows) else 0, glyph.width, glyph.height, glyph.left,
                                      glyph.top, glyph.advance, 0)
        bits += [f"0x{byte:02X}" for row in glyph.rows for byte in row]
        if len(bits) > BYTES_MAX:
            raise ToolError(f"{source}: the pictures of the characters take more than {BYTES_MAX:,} bytes; choose "
                            "fewer by --characters, or a smaller font")
    items = [records.get(code, records[unknown]) for code in range(there[0], last + 1)]
    members = f"{name}_bits, {name}_glyphs, {len(items)}, {there[0]}, {unknown}, {font.line_height}"
    return c_text.header(
        f"Written by fixel font from {c_scene.printable(source)}: characters {there[0]}..{last}, lines of "
        f"{font.line_height} pixels.", f"{name.upper()}_FONT_H", ["fixel/overlay.h"],
        [c_text.table("uint8_t", f"{name}_bits", bits or ["0x00"]),
         c_text.table("fxl_glyph", f"{name}_glyphs", items, "First byte, width, height, left, top, advance, 0."),
         c_text.record("fxl_font", f"{name}_font", [members])])


def chosen(font, source):
    """(first, last) of the characters where none are asked for: those of ASCII, or all of a font that has none of these;
    and a note or None."""
    first, last = parse_characters(DEFAULT)
    there = sorted(code for code in font.glyphs if code)
    if not there or any(first <= code <= last for code in there):
        return first, last, None
    return there[0], there[-1], f"{source}: has none of the characters {DEFAULT}: those from {there[0]} to {there[-1]} are written"


def export(source, out, name=None, characters=None):
    """Writes a font as a header; answers (the number of its characters, the name that its names begin with, notes)."""
    name = c_names.name_of_file(source, "font") if name is None else name
    c_names.check_name(name)
    asked = characters and parse_characters(characters)
    font = bdf.read(source)
    first, last, note = (*asked, None) if asked else chosen(font, source)
    output.write_file(out, header(font, name, os.path.basename(source), first, last))
    return sum(first <= code <= last for code in font.glyphs), name, font.notes + ([note] if note else [])


def main(argv):
    """The command; its exit code."""
    options = parser().parse_args(argv)
    count, name, notes = export(options.font, options.out, options.name, options.characters)
    for note in notes:
        print(f"note: {one_line(note)}", file=sys.stderr)
    print(f"{one_line(options.out)}: {name}_font, {count} characters", file=sys.stderr)
    return 0
