# SPDX-License-Identifier: MIT
"""Writes what the fields of a scene image are in C and in docs/formats.md, of their table in tools/fixel/image/fields.py, and what values and
defaults the keys of a scene file have in docs/scenes.md, of their tables in tools/fixel/scene/keys.py."""

import argparse
import pathlib
import re

from fixel.base import output
from fixel.commands import late
from fixel.image.fields import ENTRY, HEAD, HEADER, SECTIONS, VERSION

keys = late("fixel.scene", "keys")
ROOT = pathlib.Path(__file__).resolve().parents[3]
DOCUMENT, KEYS = "docs/formats.md", "docs/scenes.md"
WRITTEN = """/* SPDX-License-Identifier: MIT */
/* {}
 * Written by `fixel formats` of tools/fixel/image/fields.py: change that. Internal. */
#ifndef {guard}
#define {guard}

#include "{include}"

"""


def parser():
    """The command's arguments."""
    return argparse.ArgumentParser(description=__doc__)


def _asserted(record, fields, size):
    """The assertions that a record of C has its fields where an image has them."""
    lines, place = [f"FXL_STATIC_ASSERT(sizeof({record}) == {size}, FXL_AS_DOCUMENTED);"], 0
    for field in fields:
        if field.member:
            lines.append(f"FXL_STATIC_ASSERT(offsetof({record}, {field.member}) == {place}, FXL_AS_DOCUMENTED);")
        place += field.size
    return lines


def _records(room):
    """The assertions of a room's records."""
    lines = []
    for section in SECTIONS:
        if section.record and section.room == room:
            lines += _asserted(section.record, section.fields, section.entry.size)
    return lines


def _table():
    """What the library knows of each section."""
    rows = [f"    {{{section.entry.size}, {int(section.needed)}, {section.limit or section.most}, \"{section.what}\"}}, \\"
            for section in SECTIONS]
    width = max(map(len, rows))
    made = ["#define SECTION_TABLE ".ljust(width - 1) + "\\", *(row[:-1].ljust(width - 1) + "\\" for row in rows)]
    return ["/* Of each kind: bytes of an entry, whether a reader that does not know it must refuse the image, the most",
            " * entries, and its name in a fault. */", *made[:-1], made[-1].rstrip(" \\")]


# place field: a field of the header: the header
def scene_header():
    """lib/scene/scene_sections.h."""
    lines = [f"#define IMAGE_VERSION {VERSION}u", "", "/* The kinds of sections. */", "enum {",
             *(f"    {section.enum} = {number}," for number, section in enumerate(SECTIONS, 1)),
             f"    SECTION_KINDS = {len(SECTIONS) + 1} /* one more than the greatest */", "};", "", *_table(), ""]
    limits = {section.limit: section.most for section in SECTIONS if section.limit}
    lines += [f"FXL_STATIC_ASSERT({limit} == {most}, FXL_AS_DOCUMENTED);" for limit, most in limits.items()]
    lines += _asserted("fxl_image_header", HEADER, HEAD.size) + [f"FXL_STATIC_ASSERT(sizeof(fxl_image_section) == {ENTRY.size}, FXL_AS_DOCUMENTED);"]
    return WRITTEN.format("The sections of a scene image, and where its records have their fields (docs/formats.md).",
                          guard="FXL_SCENE_SECTIONS_H", include="scene_header.h") + \
        "\n".join([*lines, *_records("scene"), "", "#endif", ""])


def surface_header():
    """lib/paint/surface_sections.h."""
    return WRITTEN.format("Where the records of surfaces have their fields in a scene image (docs/formats.md).",
                          guard="FXL_SURFACE_SECTIONS_H", include="../scene/scene_header.h").replace(
        '.h"\n\n', '.h"\n#include "fixel/surfaces.h"\n\n', 1) + "\n".join([*_records("paint"), "", "#endif", ""])


def _range(section):
    return f"{section.least:,}" if section.least == section.most else f"{section.least:,}..{section.most:,}"


def header_page():
    """The table of the header's fields in docs/formats.md."""
    lines, place = ["| offset | type | field |", "| --- | --- | --- |"], 0
    for field in HEADER:
        lines.append(f"| {place} | {field.type} | {field.words} |")
        place += field.size
    return lines


def sections_page():
    """The table of the sections."""
    lines = ["| kind | section | needed | entries | an entry | bytes |", "| --- | --- | --- | --- | --- | --- |"]
    for number, section in enumerate(SECTIONS, 1):
        entry = "; ".join(f"{field.type} {field.words}" for field in section.fields) + (f" ({section.note})" if section.note else "")
        lines.append(f"| {number} | {section.title} | {'yes' if section.needed else 'no'} | {_range(section)} | {entry} | "
                     f"{section.entry.size} |")
    return lines


def page(text):
    """docs/formats.md with its tables of fields renewed."""
    for name, lines in (("header", header_page()), ("sections", sections_page())):
        text, found = re.subn(f"(<!-- fields: {name} -->\n).*?(<!-- end -->)", lambda match, lines=lines:
                              match[1] + "\n".join(lines) + "\n" + match[2], text, flags=re.DOTALL)
        assert found == 1, name
    return text


# place key: where its row stands in the page, if its table is new
# The tables of docs/scenes.md: what stands before a key, its table in keys.py, and which of its keys; none: all.
def _key_tables():
    baked = {"direction", "ambient", *keys.BAKED}
    own = {*keys.OBJECT} - {*keys.SURFACE, *keys.TURNED, *keys.LINES}
    return {
        "top": [("", keys.TOP, {"background"}), ("screen.", keys.SCREEN, None), ("view.", keys.VIEW, None), ("light.", keys.LIGHT, baked),
                ("glow.", keys.GLOW, None), ("palette.", keys.PALETTE, None), ("horizon.", keys.HORIZON, None),
                ("", keys.TOP, {"tree", "textures", "billboards", "objects", "beams", "path"})],
        "objects": [("", keys.OBJECT, own), ("ring.", keys.RING, None), ("repeat.", keys.REPEAT, None), ("", keys.SPRITE, {"billboard"})],
        "textures": [("", keys.TEXTURE, None)], "surfaces": [("", keys.SURFACE, None), ("images.", keys.IMAGES, None)],
        "billboards": [("", keys.BILLBOARD, None)],
        "lines": [("", keys.LINES, None), ("edges.", keys.EDGES, None), ("lines[].", keys.POLYLINE, None), ("points[].", keys.DOTS, None)],
        "motions": [("", keys.TURNED, None), ("spin.", keys.SPIN, None), ("motion.", keys.MOTION, None), ("motion.keys[].", keys.MOTION_KEY, None)],
        "light": [("light.", keys.LIGHT, {*keys.LIGHT} - baked), ("light.points[].", keys.POINT, None), ("light.fog.", keys.FOG, None)],
        "beams": [("", keys.BEAM, None)],
        "path": [("", keys.PATH, None), ("keys[].", keys.PATH_KEY, None), ("orbit.", keys.ORBIT, None), ("steps[].", keys.STEP, None),
                 ("start.", keys.START, None), ("gait.", keys.GAIT, None)]}


def keys_page(text):
    """docs/scenes.md with the values and defaults of keys renewed. What a key means stands in the last cell of its row, and stays."""
    for name, parts in _key_tables().items():
        block = re.compile(f"(<!-- keys: {name} -->\n)(.*?)(<!-- end -->)", re.DOTALL)
        found = block.search(text)
        meanings = {cells[1].strip(" `"): cells[4].strip() for cells in (re.split(r"(?<!\\)\|", row) for row in found[2].splitlines()) if len(cells) == 6}
        lines = ["| key | value | default | meaning |", "| --- | --- | --- | --- |"]
        for before, table, those in parts:
            lines += [f"| `{before}{key}` | {row.kind.values()} | {row.default_words()} | {meanings.get(before + key, '')} |"
                      for key, row in table.items() if those is None or key in those]
        text = text[:found.start(2)] + "\n".join(lines) + "\n" + text[found.end(2):]
    return text


def texts():
    """{file: what it must hold}."""
    return {KEYS: keys_page((ROOT / KEYS).read_text(encoding="utf-8")),
            "lib/scene/scene_sections.h": scene_header(), "lib/paint/surface_sections.h": surface_header(),
            DOCUMENT: page((ROOT / DOCUMENT).read_text(encoding="utf-8"))}


def main(argv):
    """The command."""
    parser().parse_args(argv)
    for file, text in texts().items():
        if not (ROOT / file).exists() or (ROOT / file).read_text(encoding="utf-8") != text:
            output.write_file(ROOT / file, text.encode())
            print(f"renewed {file}")
    return 0
