# SPDX-License-Identifier: MIT
"""The tables of a scene image, found by its header: where they lie, and how long they are."""

import struct

from fixel.image import (image_beam, image_billboard, image_cluster, image_keys, image_light, image_models,
                         image_surface, image_turn)
from fixel.image.image_header import (BOARD_HEADER_SIZE, CLUSTER_HEADER_SIZE, HEADER_SIZE, LIGHT_HEADER_SIZE, LIT_HEADER_SIZE, POSES,
                                SURFACE_HEADER_SIZE, TURN_HEADER_SIZE)
from fixel.image.image_tree import NODE, NODES_MAX, fail

PALETTE = struct.Struct("<3B")
POSE = struct.Struct("<3i3I")
STRIDE = struct.Struct("<HH")


def _limits(kind):
    """A table's name, its entry, and the least and the most of them; in the order of the header."""
    return [("palette", PALETTE, 256, 256), ("vertices", image_models.VERTEX, 1, 1_000_000),
            ("corners", image_models.CORNER, 1, 4_000_000), ("faces", image_models.FACE, 1, 1_000_000),
            ("models", image_models.MODEL, 1, 65_535), ("objects", image_models.OBJECT, 1, 65_535),
            ("path", POSE if kind == POSES else STRIDE, 1, 1_000_000),
            ("keys", image_keys.KEY, 1, 1_000_000), ("nodes", NODE, 1, NODES_MAX),
            ("beams", image_beam.BEAM, 1, image_beam.BEAMS_MAX), ("lit", image_beam.LIT, 1, 1),
            ("clusters", image_cluster.CLUSTER, 1, image_cluster.CLUSTERS_MAX),
            ("turns", image_turn.TURN, 1, 65_535), ("motions", image_turn.MOTION, 1, 65_535),
            ("motion keys", image_turn.KEY, 1, image_turn.KEYS_MAX), ("light", image_light.BASE, 1, 1),
            ("point lights", image_light.POINT, 1, image_light.POINTS_MAX),
            ("levels", image_light.LEVEL, 1, image_light.LEVELS_MAX), *image_surface.TABLES, *image_billboard.TABLES]


def _places(blob, fields):
    """The offset and count of each table, and the names of those that may be missing."""
    optional = {"keys", "nodes", "beams", "lit", "clusters", "turns", "motions", "motion keys", "light", "point lights",
                "levels", *(name for name, *_ in image_surface.TABLES + image_billboard.TABLES)}
    beams, lit, clusters, turns, light, surfaces = (0, 0), (0, 0), (0, 0), (0,) * 6, (0,) * 6, (0,) * 14
    boards = (0,) * 6
    if fields[2] != HEADER_SIZE:
        *beams, lit, reserved = image_beam.LIT_HEADER.unpack_from(blob, HEADER_SIZE)
        if reserved:
            fail("reserved", "a reserved field of the header is not zero")
        lit = lit, min(beams[1], 1)
        optional -= {"beams", "lit"}
    if fields[2] >= CLUSTER_HEADER_SIZE:
        clusters = image_cluster.HEADER.unpack_from(blob, LIT_HEADER_SIZE)
        optional = optional - {"clusters"} | {"beams", "lit"}
    if fields[2] >= TURN_HEADER_SIZE:
        turns = image_turn.HEADER.unpack_from(blob, CLUSTER_HEADER_SIZE)
        optional = optional - {"turns"} | {"clusters"}
    if fields[2] >= LIGHT_HEADER_SIZE:
        light = image_light.HEADER.unpack_from(blob, TURN_HEADER_SIZE)
        optional = optional - {"light", "levels"} | {"turns"}
    if fields[2] >= SURFACE_HEADER_SIZE:
        *surfaces, _, _ = image_surface.HEADER.unpack_from(blob, LIGHT_HEADER_SIZE)
        if fields[2] == SURFACE_HEADER_SIZE or surfaces[9]:     # with billboards there may be no face map
            optional = optional - image_surface.NEEDED
        optional = optional | {"light"} | ({"levels"} if not light[1] else set())
    if fields[2] >= BOARD_HEADER_SIZE:
        boards = image_billboard.HEADER.unpack_from(blob, SURFACE_HEADER_SIZE)
        optional -= {name for name, *_ in image_billboard.TABLES}
    places = [*(fields[i:i + 2] for i in range(24, 38, 2)), fields[39:41], fields[41:43], beams, lit, clusters,
              turns[:2], turns[2:4], turns[4:], light[:2], light[2:4], light[4:], *zip(surfaces[::2], surfaces[1::2]),
              *zip(boards[::2], boards[1::2])]
    return places, optional


def _check_counts(tables):
    """Counts that go with others."""
    for name, held in (("vertices", tables["vertices"]), ("corners", tables["corners"])):
        if len(held) < 3:
            fail("count", f"{len(held)} {name} are fewer than 3")
    objects, turns, motions = len(tables["objects"]), len(tables["turns"]), len(tables["motions"])
    if turns > objects or motions > turns:
        fail("count", f"{objects} objects, {turns} turns and {motions} motions do not go together")
    if not tables["light"] and (tables["point lights"] or tables["levels"]):
        fail("count", "there are point lights or levels, but no light")
    if tables["face map"] and len(tables["face map"]) != len(tables["faces"]):
        fail("count", f"{len(tables['face map'])} entries of the face map for {len(tables['faces'])} faces")
    if tables["billboard map"] and len(tables["billboard map"]) != len(tables["models"]):
        fail("count", f"{len(tables['billboard map'])} entries of the billboard map for {len(tables['models'])} models")


def _unpacked(entry, table, count):
    """A list of tuples; of single numbers a tuple or bytes, which take a tenth of the memory."""
    if entry.format == "<B":
        return bytes(table)
    return struct.unpack(f"<{count}H", table) if entry.format == "<H" else list(entry.iter_unpack(table))


def read(blob, fields):
    """The tables (_unpacked), after their offsets and counts; empty where there are none."""
    size, tables = fields[3], {}
    places, optional = _places(blob, fields)
    for (offset, count), (name, entry, low, high) in zip(places, _limits(fields[12])):
        if name in optional and not count:
            if offset:
                fail("count", f"the header gives an offset of {name}, but a count of 0")
            tables[name] = []
            continue
        if not low <= count <= high:
            fail("count", f"{count} {name} are outside {low}..{high}")
        if offset % 4:
            fail("alignment", f"the table of {name} begins at {offset}, not a multiple of four")
        if offset < fields[2] or offset + count * entry.size > size:
            fail("offset", f"the table of {name} reaches outside the image")
        table = blob[offset:offset + count * entry.size]
        tables[name] = _unpacked(entry, table, count)
    _check_counts(tables)
    return list(tables.values())
