# SPDX-License-Identifier: MIT
"""For tests: the sections of a scene image, found and replaced."""

import struct
import zlib

from fixel.image import fields, image_tables

ENTRY = fields.ENTRY


def summed(blob):
    """With a checksum that matches the size that the image states."""
    blob = bytearray(blob)
    size, = struct.unpack_from("<I", blob, 8)
    struct.pack_into("<I", blob, 12, zlib.crc32(bytes(blob[16:size])))
    return bytes(blob)


def sealed(blob):
    """With a size and a checksum that match."""
    blob = bytearray(blob)
    struct.pack_into("<I", blob, 8, len(blob))
    return summed(blob)


def entries(blob):
    """{kind: (place of its entry in the table, offset, count)}."""
    found = {}
    for number in range(struct.unpack_from("<H", blob, 6)[0]):
        at = fields.HEAD.size + ENTRY.size * number
        kind, _, _, offset, count = ENTRY.unpack_from(blob, at)
        found[kind] = at, offset, count
    return found


def section(blob, name):
    """Where a section lies, and its count; 0, 0 where there is none."""
    return entries(blob).get(fields.KINDS[name], (0, 0, 0))[1:]


def entry_at(blob, name):
    """Where the entry of a section stands in the table: its offset 4 bytes on, its count 8."""
    return entries(blob)[fields.KINDS[name]][0]


def bodies(blob):
    """{kind: (whether it is needed, count, bytes)}, of the known sections."""
    return {kind: (fields.SECTIONS[kind - 1].needed, count,
                   blob[offset:offset + count * fields.SECTIONS[kind - 1].entry.size])
            for kind, (_, offset, count) in entries(blob).items()}


def joined(blob, parts):
    """An image with the header of another and these sections, as bodies gives them."""
    return laid(blob, sorted(parts.items()))


def laid(blob, parts):
    """An image with the header of another and these sections in this order: (kind, (whether it is needed, count, bytes))."""
    place, table, behind = fields.HEAD.size + ENTRY.size * len(parts), b"", b""
    for kind, (needed, count, body) in parts:
        table += ENTRY.pack(kind, int(needed), 0, place, count)
        padded = body.ljust(image_tables.aligned(len(body)), b"\0")
        behind += padded
        place += len(padded)
    head = bytearray(blob[:fields.HEAD.size])
    struct.pack_into("<H", head, 6, len(parts))
    return sealed(head + table + behind)


def replaced(blob, **tables):
    """An image with other sections: name=packed entries, a blank in the name as _; b"" takes it out."""
    parts = bodies(blob)
    for word, body in tables.items():
        name = word.replace("_", " ")
        kind, one = fields.KINDS[name], fields.SECTIONS[fields.KINDS[name] - 1]
        parts.pop(kind, None)
        if body:
            parts[kind] = one.needed, len(body) // one.entry.size, body
    return joined(blob, parts)
