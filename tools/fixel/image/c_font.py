# SPDX-License-Identifier: MIT
"""A font of a BDF file as a C header."""

import os
import re
import sys

from fixel.base import output
from fixel.image import bdf, c_scene, c_text
from fixel.base.errors import ToolError, one_line
from fixel.base.reading import quoted

BYTES_MAX = 65535       # of all pictures: fxl_glyph.first_byte


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


def export(source, out, name=None, characters="32-126"):
    """Writes a font as a header; answers the number of its characters."""
    name = os.path.splitext(os.path.basename(source))[0] if name is None else name
    c_scene.check_name(name)
    first, last = parse_characters(characters)
    font = bdf.read(source)
    output.write_file(out, header(font, name, os.path.basename(source), first, last))
    return sum(first <= code <= last for code in font.glyphs)


def command(options):
    """The command; its exit code."""
    count = export(options.font, options.out, options.name, options.characters)
    print(f"{one_line(options.out)}: {count} characters", file=sys.stderr)
    return 0
