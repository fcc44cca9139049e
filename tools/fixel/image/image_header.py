# SPDX-License-Identifier: MIT
"""The header of a scene image (docs/formats.md, section 1.1), checked."""

import zlib
from types import SimpleNamespace

from fixel.image.fields import ENTRY, HEAD, HEADER, IMAGE_MAX, MAGIC, VERSION
from fixel.image.image_tree import fail

POSES, STRIDES = 0, 1            # kinds of path
DEPTHS = (0, 16, 32)            # bits of the depth buffer that an image asks for, by the low bits of its target
# place pixel-format: the bits of target
RGB565, BY_DISTANCE = 4, 8      # bits of the target


def pack(values):
    """The bytes of a header: {member: a number, or the numbers of a field of several}."""
    numbers = []
    for field in HEADER:
        value = values[field.member]
        numbers += value if isinstance(value, (list, tuple)) else [value]
    return HEAD.pack(*numbers)


def _fields(blob):
    numbers, found = iter(HEAD.unpack_from(blob)), {}
    for field in HEADER:
        count = int(field.format[:-1] or 1) if field.format[-1] != "s" else 1
        values = tuple(next(numbers) for _ in range(count))
        found[field.member.replace(".", "_")] = values if count > 1 else values[0]
    return SimpleNamespace(**found)


def read(blob):
    """The header's fields by their members, checked."""
    if len(blob) < HEAD.size:
        fail("size", f"{len(blob)} bytes are fewer than a header's {HEAD.size}")
    head = _fields(blob)
    if head.magic != MAGIC:
        fail("magic", "this is not a scene image (it does not begin with FXLS)")
    if head.version != VERSION:
        fail("version", f"a scene image of version {head.version}; this tool knows version {VERSION}: build it again")
    size = head.image_size
    if size % 4 or not HEAD.size + head.section_count * ENTRY.size <= size <= IMAGE_MAX or size > len(blob):
        fail("size", f"the image says that it has {size} bytes; there are {len(blob)}")
    if zlib.crc32(blob[16:size]) != head.crc:
        fail("crc", "the checksum does not match: the image is damaged")
    if head.target >= 2 * BY_DISTANCE or head.target % RGB565 >= len(DEPTHS):
        fail("reserved", "the header asks for a target that is not known")
    return head


def target(scene):
    """What a scene asks for, as one byte."""
    return DEPTHS.index(scene.depth_bits) + (RGB565 if scene.pixel_bits == 16 else 0) + (BY_DISTANCE if scene.by_distance else 0)


def _offset(member):
    before = [field.member for field in HEADER].index(member)
    return sum(field.size for field in HEADER[:before])


def retargeted(blob, scene):
    """The bytes of an image, longer or not, that asks for what a SceneImage asks for."""
    made, crc = bytearray(blob), _offset("crc")
    made[_offset("target")] = target(scene)
    made[crc:crc + 4] = zlib.crc32(made[16:scene.size]).to_bytes(4, "little")
    return bytes(made)
