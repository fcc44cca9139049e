# SPDX-License-Identifier: MIT
"""For tests: scene images whose header or sections differ by one or two mistakes, one function for each kind of mistake."""

import struct

from fixel.image import fields
# place field: images that are broken, and the sections of an image
from scene_sections import ENTRY, bodies, joined, laid, sealed, summed

UNKNOWN = len(fields.SECTIONS) + 1      # the first kind that no reader knows
AT_SIZE, AT_CRC = 8, 12                 # in the header


def put(blob, at, chance):
    """Another number at a place: near the old one, an end of a range, or any."""
    size = chance.choice((1, 2, 4, 4))
    at -= at % size
    if at + size > len(blob):
        return
    old = int.from_bytes(blob[at:at + size], "little")
    new = chance.choice((old + chance.choice((-4, -1, 1, 4)), 0, 1, 255, 65535, 1 << 31, (1 << 32) - 1,
                         old ^ 1 << chance.randrange(8 * size), chance.getrandbits(8 * size)))
    blob[at:at + size] = (new % (1 << 8 * size)).to_bytes(size, "little")


def _number(blob, chance, places):
    new = bytearray(blob)
    put(new, chance.choice(places), chance)
    return summed(new)


def header_number(blob, chance):
    """Another number in the header."""
    return _number(blob, chance, (4, 6, AT_SIZE, 37, 38, 84, 88))


def _entries(blob):
    count, = struct.unpack_from("<H", blob, 6)
    return [fields.HEAD.size + ENTRY.size * number for number in range(count)]


def entry_number(blob, chance):
    """Another number in the table of sections."""
    return _number(blob, chance, [at + word for at in _entries(blob) for word in (0, 2, 3, 4, 8)])


def padding(blob, chance):
    """A byte before a section that is perhaps not zero."""
    offsets = [ENTRY.unpack_from(blob, at)[3] for at in _entries(blob)]
    return _number(blob, chance, [offset - back for offset in offsets for back in (1, 2, 3)])


def another_section(blob, chance):
    """A section less, or one that no reader knows."""
    parts = bodies(blob)
    kind = chance.choice([*parts, *range(UNKNOWN, UNKNOWN + 3)])
    if parts.pop(kind, None) is None:
        parts[kind] = chance.random() < 0.3, chance.randrange(4), bytes(chance.randrange(40))
    return joined(blob, parts)


def two_sections_less(blob, chance):
    """Without two sections."""
    parts = bodies(blob)
    for kind in chance.sample(list(parts), 2):
        del parts[kind]
    return joined(blob, parts)


def repeated_section(blob, chance):
    """A section twice, or two that have changed places."""
    parts = sorted(bodies(blob).items())
    at = chance.randrange(len(parts) - 1)
    if chance.random() < 0.5:
        parts.insert(at, parts[at])
    else:
        parts[at:at + 2] = parts[at + 1], parts[at]
    return laid(blob, parts)


def more_entries(blob, chance):
    """A section of one entry more than it may have, or than goes with another; or of as many."""
    parts = bodies(blob)
    kind = chance.choice(list(parts))
    one = fields.SECTIONS[kind - 1]
    partners = [one.most, *(count for _, count, _ in parts.values())]
    count = chance.choice([most for most in partners if most * one.entry.size < 40_000]) + chance.randrange(2)
    needed, old, body = parts[kind]
    parts[kind] = needed, count, (body * (count // old + 1))[:count * one.entry.size]
    return joined(blob, parts)


def moved_section(blob, chance):
    """The last section some bytes on or back, behind one that no reader knows or behind the one before it."""
    parts = bodies(blob)
    last = max(parts)
    if chance.random() < 0.5:
        parts[UNKNOWN] = False, 1, bytes(4 * chance.randrange(4))
        parts[UNKNOWN + 1] = False, 1, bytes(8)
        last = UNKNOWN + 1
    new = bytearray(joined(blob, parts))
    at = _entries(new)[sorted(parts).index(last)] + 4
    offset, = struct.unpack_from("<I", new, at)
    struct.pack_into("<I", new, at, max(offset + chance.choice((-8, -4, -1, 1, 2, 4, 8)), 0))
    return summed(new)


def damaged(blob, chance):
    """A bit is not as the checksum says, or the image is shorter or longer than it says."""
    new = bytearray(blob)
    kind = chance.randrange(3)
    if kind == 0:
        new[chance.randrange(AT_CRC, len(new))] ^= 1 << chance.randrange(8)
        return bytes(new)
    return bytes(new[:-chance.randrange(1, 9)]) if kind == 1 else bytes(new) + bytes(chance.randrange(1, 9))


def odd_size(blob, chance):
    """An image whose size is no multiple of four, with a checksum that matches."""
    parts = bodies(blob)
    parts[UNKNOWN] = False, 0, b""      # of any length, so that nothing else is wrong
    return sealed(joined(blob, parts) + bytes(chance.randrange(1, 4)))


KINDS = (header_number, entry_number, padding, another_section, two_sections_less, repeated_section, more_entries,
         moved_section, damaged, odd_size)
