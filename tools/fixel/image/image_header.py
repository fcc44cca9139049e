# SPDX-License-Identifier: MIT
"""The header of a scene image (docs/formats.md, section 1): its versions, and its fields, checked."""

import struct
import zlib

from fixel.image import image_beam, image_billboard, image_cluster, image_lens, image_light, image_surface, image_turn
from fixel.image.image_tree import fail

MAGIC = b"FXLS"
VERSION, VERSION_MORE, VERSION_CLUSTERS, VERSION_TURNS, VERSION_LIGHT, VERSION_BOARDS = 2, 3, 4, 5, 6, 7
HEADER_SIZE = 160
LIT_HEADER_SIZE = HEADER_SIZE + image_beam.LIT_HEADER.size               # of a scene with beams
CLUSTER_HEADER_SIZE = LIT_HEADER_SIZE + image_cluster.HEADER.size        # of a scene with clusters
TURN_HEADER_SIZE = CLUSTER_HEADER_SIZE + image_turn.HEADER.size          # of a scene with turned objects
LIGHT_HEADER_SIZE = TURN_HEADER_SIZE + image_light.HEADER.size           # of a scene with light at run time
SURFACE_HEADER_SIZE = LIGHT_HEADER_SIZE + image_surface.HEADER.size      # of a scene with surfaces
BOARD_HEADER_SIZE = SURFACE_HEADER_SIZE + image_billboard.HEADER.size    # of a scene with billboards
IMAGE_MAX = 16 << 20

POSES, STRIDES = 0, 1
BY_DEFAULT, BY_DEPTH = 0, 1      # the visibility method that an image asks for

HEAD = struct.Struct("<4sHHII HHI 3i BBH 3i3I 3iI 14I I 2I 2I I")
assert HEAD.size == HEADER_SIZE


def kind_of(nodes, beams, clusters, turns, light, surfaces, billboards):
    """The version of an image, and the size of its header."""
    if billboards:
        return VERSION_BOARDS, BOARD_HEADER_SIZE
    if light or surfaces:
        return VERSION_LIGHT, SURFACE_HEADER_SIZE if surfaces else LIGHT_HEADER_SIZE
    if turns:
        return VERSION_TURNS, TURN_HEADER_SIZE
    if clusters:
        return VERSION_CLUSTERS, CLUSTER_HEADER_SIZE
    return VERSION_MORE if nodes or beams else VERSION, LIT_HEADER_SIZE if beams else HEADER_SIZE


def has_centre(fields):
    """1 if the lens of a header's fields is off-centre, else 0."""
    return fields[13] & 0xFF


def visibility(fields):
    """The visibility method that a header's fields ask for."""
    return fields[13] >> 8


def read(blob):
    """The header's fields, checked up to its reserved ones."""
    if len(blob) < HEADER_SIZE:
        fail("size", f"{len(blob)} bytes are fewer than a header's {HEADER_SIZE}")
    fields = HEAD.unpack_from(blob)
    magic, version, header_size, size, crc = fields[:5]
    if magic != MAGIC:
        fail("magic", "this is not a scene image (it does not begin with FXLS)")
    sizes = {VERSION: [HEADER_SIZE], VERSION_MORE: [HEADER_SIZE, LIT_HEADER_SIZE],
             VERSION_CLUSTERS: [CLUSTER_HEADER_SIZE], VERSION_TURNS: [TURN_HEADER_SIZE],
             VERSION_LIGHT: [LIGHT_HEADER_SIZE, SURFACE_HEADER_SIZE], VERSION_BOARDS: [BOARD_HEADER_SIZE]}
    if version not in sizes:
        fail("version", f"a scene image of version {version}; this tool knows versions {VERSION} "
             f"to {VERSION_BOARDS}")
    if header_size not in sizes[version]:
        fail("size", f"a header of {header_size} bytes is not one of version {version}")
    if size % 4 or not header_size <= size <= IMAGE_MAX or size > len(blob):
        fail("size", f"the image says that it has {size} bytes; there are {len(blob)}")
    if zlib.crc32(blob[16:size]) != crc:
        fail("crc", "the checksum does not match: the image is damaged")
    if has_centre(fields) > 1 or visibility(fields) > BY_DEPTH or version == VERSION and any(fields[41:]) or \
            fields[12] not in (POSES, STRIDES):
        fail("reserved", "a reserved field of the header is not zero, or the kind of the path or the visibility method is "
             "unknown")
    if header_size >= SURFACE_HEADER_SIZE:
        *_, blend, first, reserved = image_surface.HEADER.unpack_from(blob, LIGHT_HEADER_SIZE)
        if reserved or not blend and first:
            fail("reserved", "a reserved field of the header is not zero")
    if version == VERSION_MORE and header_size == HEADER_SIZE and not any(fields[41:]):
        fail("version", f"version {VERSION_MORE} of a scene image without a BSP tree or beams")
    if size - header_size < has_centre(fields) * image_lens.CENTRE.size:
        fail("size", "the image ends before the centre of its lens")
    return fields


def blend_first(blob, fields):
    """The first colour of the blend table; 0 without one."""
    return image_surface.HEADER.unpack_from(blob, LIGHT_HEADER_SIZE)[-2] if fields[2] >= SURFACE_HEADER_SIZE else 0
