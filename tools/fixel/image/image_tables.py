# SPDX-License-Identifier: MIT
"""The sections of a scene image: where they lie, and how long they are (docs/formats.md, section 1.2); and the ranges of bytes that records
name, of texels, of sprite pixels, of their colours. Records may name the same range, and ranges may overlap; none is copied."""

import struct

from fixel.base.errors import ToolError
from fixel.image.fields import ALWAYS, ENTRY, HEAD, KINDS, SECTIONS, TOGETHER, entry
from fixel.image.image_tree import fail

PALETTE, POSE, STRIDE = map(entry, ("palette", "poses", "strides"))


def aligned(size):
    """The next multiple of four."""
    return size + -size % 4


def pack(tables):
    """The table of sections and the sections: of {name: packed entries, or all of them in one}. What has none is left out."""
    bodies = {}
    for section in SECTIONS:
        table = tables.get(section.name) or b""
        if table:
            bodies[section] = table if isinstance(table, bytes) else b"".join(table)
    place, entries = HEAD.size + ENTRY.size * len(bodies), b""
    for section, body in bodies.items():
        entries += ENTRY.pack(KINDS[section.name], int(section.needed), 0, place, len(body) // section.entry.size)
        place += aligned(len(body))
    return len(bodies), entries + b"".join(body.ljust(aligned(len(body)), b"\0") for body in bodies.values())


def _check_entry(number, kind, needed, reserved, last):
    """A section's kind, and what stands beside it; whether the kind is known."""
    if kind <= last:
        fail("offset", f"section {number} has kind {kind}, which does not rise")
    known = kind <= len(SECTIONS)
    if reserved or needed > 1 or (known and needed != SECTIONS[kind - 1].needed):
        fail("reserved", f"section {number} has a reserved field that is not zero, or says wrongly whether it is needed")
    if not known and needed:
        fail("version", f"section {number} has kind {kind}, which this tool does not know and the scene needs: "
             "a newer Fixel made the image")
    return known


def _check_place(what, offset, place, exact):
    """Where a section begins: at a place, or not before it."""
    if offset % 4:
        fail("alignment", f"{what} begins at {offset}, not a multiple of four")
    if offset != place if exact else offset < place:
        fail("offset", f"{what} does not begin where the section before it ends")


def _sections(blob, head):
    """{name: (offset, count)} of the known sections, and the kinds of the others."""
    size, found, unknown, last = head.image_size, {}, [], 0
    place, exact = HEAD.size + ENTRY.size * head.section_count, True    # the length of an unknown section is not known
    for number in range(head.section_count):
        kind, needed, reserved, offset, count = ENTRY.unpack_from(blob, HEAD.size + ENTRY.size * number)
        known, last = _check_entry(number, kind, needed, reserved, last), kind
        if known:
            section = SECTIONS[kind - 1]
            what, end = f"the table of {section.name}", offset + count * section.entry.size
            if not 1 <= count <= section.most:
                fail("count", f"{count} {section.name} are outside 1..{section.most}")
            found[section.name] = offset, count
        else:
            what, end = f"section {number}", offset
            unknown.append(kind)
        _check_place(what, offset, place, exact)
        if end > size:
            fail("offset", f"{what} reaches outside the image")
        place, exact = aligned(end), known
        if any(blob[end:place]):
            fail("reserved", f"bytes behind {what} are not zero")
    if exact and place != size:
        fail("size", f"the sections end at {place}, and the image at {size}")
    return found, unknown


def _check_presence(head, found):
    """Sections that must be there, and those that go together."""
    for name in ALWAYS:
        if name not in found:
            fail("count", f"the image has no {name}")
    if ("poses" in found) == ("strides" in found):
        fail("count", "the image must have one path, of poses or of segments")
    for some, needed in TOGETHER:
        present = [name for name in some if name in found]
        missing = [name for name in needed if name not in found]
        if present and missing:
            fail("count", f"the image has {present[0]}, but no {missing[0]}")
    if head.bsp_instance and "nodes" not in found:
        fail("reserved", "the header names a BSP instance, but there is no BSP tree")
    if head.blend_first and "blend table" not in found:
        fail("reserved", "the header names a first colour of the blend table, but there is none")


def _check_counts(tables):
    """Counts that are too small, or go with others."""
    for section in SECTIONS:
        if tables[section.name] and len(tables[section.name]) < section.least:
            fail("count", f"{len(tables[section.name])} {section.name} are fewer than {section.least}")
    objects, placements, motions = len(tables["objects"]), len(tables["placements"]), len(tables["motions"])
    if placements > objects or motions > placements:
        fail("count", f"{objects} objects, {placements} placements and {motions} motions do not go together")
    if tables["face map"] and len(tables["face map"]) != len(tables["faces"]):
        fail("count", f"{len(tables['face map'])} entries of the face map for {len(tables['faces'])} faces")
    if tables["wholes"] and len(tables["wholes"]) != len(tables["faces"]):
        fail("count", f"{len(tables['wholes'])} entries of the whole faces for {len(tables['faces'])} faces")
    if tables["billboard map"] and len(tables["billboard map"]) != len(tables["models"]):
        fail("count", f"{len(tables['billboard map'])} entries of the billboard map for {len(tables['models'])} models")
    if tables["line map"] and len(tables["line map"]) != len(tables["models"]) + 1:
        fail("count", f"{len(tables['line map'])} entries of the line map for {len(tables['models'])} models")
    if tables["horizon colours"] and len(tables["horizon colours"]) != len(tables["horizon"]) + 1:
        fail("count", f"{len(tables['horizon colours'])} colours of the horizon for {len(tables['horizon'])} sines")


def _unpacked(one, table, count):
    """A list of tuples; of single numbers a tuple or bytes, which take a tenth of the memory."""
    if one.format == "<B":
        return bytes(table)
    return struct.unpack(f"<{count}{one.format[1]}", table) if one.format in ("<H", "<I") else list(one.iter_unpack(table))


def read(blob, head):
    """{name: its entries (_unpacked); empty where there are none}, and the kinds of unknown sections that are not needed."""
    found, unknown = _sections(blob, head)
    _check_presence(head, found)
    tables = {section.name: [] for section in SECTIONS}
    for name, (offset, count) in found.items():
        one = entry(name)
        tables[name] = _unpacked(one, blob[offset:offset + count * one.size], count)
    _check_counts(tables)
    return tables, unknown


class Ranges:
    """The ranges of one table, each made once."""

    def __init__(self, blob):
        self.blob, self.made = memoryview(blob or b""), {}

    def at(self, first, size):
        if (first, size) not in self.made:
            self.made[first, size] = self.blob[first:first + size]
        return self.made[first, size]


def check_apart(scene, name):
    """Each range of an image becomes a table of its own in C. What overlaps would make a small image a large text."""
    records = [(one.texels, one.colours) for one in (scene.surfaces.textures if scene.surfaces else ())]
    records += [(one.pixels, one.colours) for one in (scene.billboards.boards if scene.billboards else ())]
    ranges = {id(blob): len(blob) for record in records for blob in record}
    if sum(ranges.values()) > scene.size:
        raise ToolError(f"{name}: its textures and sprites overlap: they have {sum(ranges.values()):,} bytes in an image of "
                        f"{scene.size:,}, and in C each is a table of its own; build the image anew from its scene file")
