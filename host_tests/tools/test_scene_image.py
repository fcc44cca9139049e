# SPDX-License-Identifier: MIT
"""Scene images: round trips, what a damaged one is told, and its checks at the last value that each takes and the first that it refuses."""

import dataclasses
import math
import struct
import types
import zlib

import pytest
from hypothesis import given, settings, strategies as st

from conftest import run_cli
from fixel.base.errors import ToolError
from fixel.image import fields, image, image_billboard, image_header, image_models, image_placement, image_surface
from fixel.image.image import Face, Model, Object, SceneImage
from fixel.image.image_placement import COORDINATE_MAX, DEPTH_MAX, Key, Motion, SCALE_MAX, SCALE_MIN, SLACK
from fixel.image.image_surface import BITS_4, BITS_8
# place field: images that are broken, for the tools
from scene_sections import bodies, entry_at, joined, replaced, section

BUILT_PROGRAMS = ()
UP = (0, 1 << 30, 0)
SQUARE = [(-65536, 0, -65536), (-65536, 0, 65536), (65536, 0, 65536), (65536, 0, -65536)]


def scene(**changes):
    made = dict(width=320, height=240, fov=1 << 30, near=65536, far=64 << 16, inset=4,
                  background=0, palette=[(i, i, 255 - i) for i in range(256)],
                  models=[Model(list(SQUARE), [Face(UP, (0, 1, 2, 3), 7)])],
                  objects=[Object((0, -65536, 0), 0, 1), Object((1 << 20, 0, 0), 0)],
                  path_kind=image.POSES, path=[(0, 0, 0, 1, 2, 3), (5, 6, 7, 8, 9, 10)])
    made.update(changes)
    return SceneImage(**made)


def patched(blob, offset, data):
    """A blob with bytes replaced and the checksum put right again."""
    blob = bytearray(blob)
    blob[offset:offset + len(data)] = data
    blob[12:16] = struct.pack("<I", zlib.crc32(bytes(blob[16:])))
    return bytes(blob)


def refused(blob, status):
    with pytest.raises(ToolError, match=f"^{status}:"):
        image.unpack(blob)


def table(blob, number):
    """Offset and count of the section whose entry is the one with this number."""
    return struct.unpack_from("<II", blob, fields.HEAD.size + fields.ENTRY.size * number + 4)


def test_round_trip_of_poses_and_strides():
    for made in (scene(), scene(path_kind=image.STRIDES, path=[(1, 3), (0, 65535)],
                                start=(1, 2, 3, 4, 5, 6), gait=(7, 8, 9, 10))):
        blob = image.pack(made)
        assert image.unpack(blob) == made
        assert len(blob) % 4 == 0 and blob[:4] == b"FXLS"
        # A flash partition is longer than what is in it.
        assert image.unpack(blob + b"\xff" * 64) == made


def test_header_is_laid_out_as_the_chapter_says():
    blob = image.pack(scene())
    assert struct.unpack_from("<HHI", blob, 4) == (9, 7, len(blob))
    assert struct.unpack_from("<I", blob, 12)[0] == zlib.crc32(blob[16:])
    assert struct.unpack_from("<HHIiii", blob, 16) == (320, 240, 1 << 30, 65536, 64 << 16, 4)
    assert [table(blob, i)[1] for i in range(7)] == [256, 4, 4, 1, 1, 2, 2]
    assert all(table(blob, i)[0] % 4 == 0 for i in range(7))
    assert struct.unpack_from("<I", blob, 80) == (2,)
    assert table(blob, 0)[0] == 92 + 7 * 12


def test_the_centre_of_a_lens_is_a_section_of_its_own():
    made = scene(inset=0, centre=(-65536, 480 << 15))
    blob = image.pack(made)
    assert image.unpack(blob) == made
    assert struct.unpack_from("<ii", blob, section(blob, "centre of the lens")[0]) == made.centre
    assert len(blob) == 12 + 8 + len(image.pack(scene()))


@pytest.mark.parametrize("changes, status", [
    ({"centre": ((640 << 16) + 1, 0)}, "range"), ({"centre": (0, (-240 << 16) - 1)}, "range"),
    ({"centre": (0, 0), "inset": 1}, "range"), ({"centre": (160 << 16, 120 << 16)}, "reserved"),
    ({"centre": (500 << 16, 0), "fov": image_header.FOV_MAX}, "range")])
def test_a_centre_out_of_range_is_refused(changes, status):
    with pytest.raises(ToolError, match=f"^{status}:"):
        image.pack(scene(**{"inset": 0, **changes}))


def test_damaged_images_are_refused_with_the_status():
    blob = image.pack(scene())
    refused(blob[:100], "size")
    refused(blob[:-4], "size")
    refused(b"FXLD" + blob[4:], "magic")
    refused(patched(blob, 4, b"\1\0"), "version")
    refused(patched(blob, 4, b"\7\0"), "version")
    refused(patched(blob, 4, b"\10\0"), "version")
    refused(patched(blob, 6, b"\0\4"), "size")
    refused(patched(blob, 8, struct.pack("<I", image.IMAGE_MAX + 4)), "size")
    refused(patched(blob, 84, b"\1"), "reserved")
    refused(patched(blob, 88, b"\1"), "reserved")
    for unknown in b"\3\7\x10\x80":
        refused(patched(blob, 37, bytes([unknown])), "reserved")


@settings(max_examples=60, deadline=None)
@given(st.integers(16, 3000), st.integers(0, 7))
def test_any_flipped_bit_breaks_the_checksum(offset, bit):
    blob = bytearray(image.pack(scene()))
    blob[offset % (len(blob) - 16) + 16] ^= 1 << bit
    refused(bytes(blob), "crc")


@pytest.mark.parametrize("offset, data, status", [
    (16, b"\0\0", "range"), (16, struct.pack("<H", 1025), "range"),
    (20, struct.pack("<I", image_header.FOV_MIN - 1), "range"),
    (20, struct.pack("<I", image_header.FOV_MAX + 1), "range"),
    (24, struct.pack("<i", 255), "range"), (28, struct.pack("<i", 65536), "range"),
    (28, struct.pack("<i", image_header.FAR_MAX + 1), "range"), (32, struct.pack("<i", -1), "range"),
    (40, struct.pack("<i", image.COORDINATE_MAX + 1), "range"),
    (64, struct.pack("<i", -1), "range"), (76, struct.pack("<I", (1 << 30) + 1), "range"),
    # of the palette's entry at 92 and the vertices' at 104
    (92, b"\0", "offset"), (92, b"\2", "offset"), (94, b"\0", "reserved"), (94, b"\2", "reserved"), (95, b"\1", "reserved"),
    (104, b"\1", "offset"), (112, struct.pack("<I", 0), "count"),
    (112, struct.pack("<I", 1_000_001), "count"), (112, struct.pack("<I", 1_000_000), "offset"),
    (108, struct.pack("<I", 162), "alignment"), (108, struct.pack("<I", 0xFFFFFFFC), "offset"),
    (80, struct.pack("<I", 3), "count"),
])
def test_header_fields_out_of_range(offset, data, status):
    refused(patched(image.pack(scene()), offset, data), status)


@pytest.mark.parametrize("number, offset, data, status", [
    (3, 12, b"\2", "count"), (3, 12, b"\31", "count"), (3, 16, b"\1", "index"), (3, 18, b"\1", "index"), (3, 14, b"\1", "index"),
    (3, 4, struct.pack("<i", (1 << 30) - 3), "normal"),
    (2, 0, b"\4", "index"), (1, 4, struct.pack("<i", 5), "planarity"),
    (4, 0, b"\1", "index"), (4, 16, b"\2", "reserved"), (4, 17, b"\1", "reserved"),
    (4, 20, struct.pack("<i", 92681), "radius"), (4, 20, struct.pack("<i", -1), "range"),
    (4, 20, struct.pack("<i", image.RADIUS_MAX + 1), "range"),
    (5, 12, b"\1", "index"), (5, 15, b"\1", "reserved"),
    (5, 0, struct.pack("<i", image.COORDINATE_MAX - 65535), "range"),
    (6, 0, struct.pack("<i", image.COORDINATE_MAX + 1), "range"),
])
def test_table_entries_out_of_contract(number, offset, data, status):
    blob = image.pack(scene())
    refused(patched(blob, table(blob, number)[0] + offset, data), status)


def test_a_screen_and_a_lens_at_the_ends_of_their_ranges():
    ends = {"width": (1, image_header.SCREEN_MAX), "height": (1, image_header.SCREEN_MAX),
            "fov": (image_header.FOV_MIN, image_header.FOV_MAX)}
    sound = {"width": 320, "height": 240, "fov": 1 << 30, "near": 256, "far": image_header.FAR_MAX, "inset": 0}
    image_header.check_lens(**sound)
    for name, (least, most) in ends.items():
        for value in (least, most):
            image_header.check_lens(**{**sound, name: value})
        for value in (least - 1, most + 1):
            with pytest.raises(ToolError, match="^range:"):
                image_header.check_lens(**{**sound, name: value})


@pytest.mark.parametrize("fov, least", [(1 << 30, 3 * 320 << 15), (image_header.FOV_MIN, 3 * 320 << 15),
                                        (image_header.FOV_MAX, round(4 * 160 * 65536 / math.tan(image_header.FOV_MAX * math.pi / 2 ** 32)))])
def test_the_centre_of_a_lens_is_at_most_one_and_a_half_screens_and_four_focal_lengths_away(fov, least):
    middle_x, middle_y = image_header.middle(320, 240)
    for away in (least - 2, 2 - least):
        image_header.check_centre(320, 240, fov, 0, (middle_x + away, middle_y))
    for away in (least + 2, -2 - least):
        with pytest.raises(ToolError, match="the centre's x"):
            image_header.check_centre(320, 240, fov, 0, (middle_x + away, middle_y))
    with pytest.raises(ToolError, match="the centre's y"):
        image_header.check_centre(320, 240, 1 << 30, 0, (middle_x, middle_y + (3 * 240 << 15) + 1))


def test_values_at_the_ends_are_taken():
    blob = image.pack(scene(objects=[Object((image.COORDINATE_MAX - 65536, 0, 0), 0)]))
    at = table(blob, 1)[0] + 4
    # The square's first vertex may lie 4 units off, and no more.
    image.unpack(patched(blob, at + 12, struct.pack("<i", 4)))
    refused(patched(blob, at + 12, struct.pack("<i", 5)), "planarity")


@given(st.lists(st.tuples(*[st.integers(-2 * image.COORDINATE_MAX, 2 * image.COORDINATE_MAX)] * 3),
                min_size=1, max_size=4))
def test_the_radius_is_the_least_that_holds_every_vertex(vertices):
    radius = image.radius_of(vertices)
    square = max(x * x + y * y + z * z for x, y, z in vertices)
    assert radius * radius >= square and 0 <= radius <= image.RADIUS_MAX
    assert radius == 0 or (radius - 1) ** 2 < square


def test_the_radius_stands_in_the_model():
    blob = image.pack(scene())
    at = table(blob, 4)[0] + 20
    # The square's corners are sqrt(2) from its middle: 92681.9.
    assert struct.unpack_from("<i", blob, at) == (92682,)
    image.unpack(patched(blob, at, struct.pack("<i", image.RADIUS_MAX)))


def test_sorted_models_have_face_bounds():
    made = scene()
    made.models = [*made.models, Model(list(SQUARE), [Face(UP, (1, 2, 3), 7), Face(UP, (0, 1, 2, 3), 8)],
                                       image.SORTED)]
    blob = image.pack(made)
    assert image.unpack(blob) == made
    offset, count = section(blob, "keys")
    assert count == 2 and offset + 40 == len(blob)
    assert blob[entry_at(blob, "keys") + 2] == 0     # a reader may pass over them
    # Heights over the origin and the doubled middles of the boxes: the square is in y = 0.
    assert struct.unpack_from("<q3i", blob, offset) == (0, 0, 0, 0)
    for data, at, status in ((b"\1", offset, "face bounds"), (b"\1", offset + 39, "face bounds"),
                             (b"\3", entry_at(blob, "keys") + 8, "offset"), (b"\1", table(blob, 4)[0] + 24, "reserved"),
                             (b"\1", table(blob, 4)[0] + 28 + 24, "index"),
                             (b"\0", table(blob, 4)[0] + 28 + 16, "count"),
                             (b"\0", entry_at(blob, "keys") + 8, "count")):
        refused(patched(blob, at, data), status)
    refused(replaced(blob, keys=blob[offset:offset + 20]), "index")
    # They may be left out.
    assert image.unpack(replaced(blob, keys=b"")) == made


@given(st.lists(st.tuples(*[st.integers(-2 * image.COORDINATE_MAX, 2 * image.COORDINATE_MAX)] * 3),
                min_size=3, max_size=6), st.tuples(*[st.integers(-(1 << 30), 1 << 30)] * 3))
def test_a_key_is_the_plane_and_the_box(vertices, normal):
    corners = tuple(range(len(vertices)))
    height, *box = image_models.key_of(Model(vertices, []), Face(normal, corners, 0))
    assert height == sum(n * c for n, c in zip(normal, vertices[0]))
    assert box == [min(v[i] for v in vertices) + max(v[i] for v in vertices) for i in range(3)]


def test_pack_refuses_what_a_loader_would():
    with pytest.raises(ToolError, match="^range:"):
        image.pack(scene(objects=[Object((image.COORDINATE_MAX, 0, 0), 0)]))
    with pytest.raises(ToolError, match="^size:.*at most"):
        image.pack(scene(path=[(0,) * 6] * 700_000))


def test_sections_take_no_more_than_stated():
    """Beside its tables an image has a header of 92 bytes and 12 for each section; the smallest has seven."""
    blob = image.pack(scene())
    used = sum(-(-table(blob, number)[1] * fields.SECTIONS[number].entry.size // 4) * 4 for number in range(6))
    assert len(blob) == 92 + 7 * 12 + used + 2 * 24 and 92 + 7 * 12 <= 160 + 200
    beside = {"strides", "scale of the lens"}     # in the place of poses and of a horizon
    assert beside < {section.name for section in fields.SECTIONS}
    assert 92 + 12 * (len(fields.SECTIONS) - len(beside)) <= 320 + 200      # with all that an image may have


def saved(folder, blob):
    """A file with an image."""
    (folder / "this.fxls").write_bytes(blob)
    return folder / "this.fxls"


def test_info_names_a_section_that_it_does_not_know(tmp_path):
    file = tmp_path / "later.fxls"
    blob = image.pack(scene())
    file.write_bytes(joined(blob, {**bodies(blob), len(fields.SECTIONS) + 3: (False, 1, b"news")}))
    done = run_cli("info", file)
    assert done.returncode == 0 and f"sections of kind {len(fields.SECTIONS) + 3}" in done.stdout, done.stdout + done.stderr
    assert "unknown" not in run_cli("info", saved(tmp_path, blob)).stdout


# --- ranges -----------------------------------------------------------------------------------

ONE = 1 << 16


def refuses(status, check, *arguments):
    with pytest.raises(ToolError, match=f"^{status}:"):
        check(*arguments)


# --- objects ------------------------------------------------------------------------

def test_vertices_of_all_objects_together(monkeypatch):
    monkeypatch.setattr(image_models, "PLACED_MAX", 7)
    models = [types.SimpleNamespace(vertices=[(0, 0, 0)] * count) for count in (3, 4)]
    rows = [(1, 2, 3, number, 5, 0) for number in (0, 1)]
    assert [(item.centre, item.model, item.layer) for item in image_models.read_objects(rows, models)] == \
        [((1, 2, 3), 0, 5), ((1, 2, 3), 1, 5)]
    refuses("count", image_models.read_objects, [*rows, rows[0]], models)
    refuses("index", image_models.read_objects, [(1, 2, 3, 2, 5, 0)], models)
    refuses("reserved", image_models.read_objects, [(1, 2, 3, 0, 5, 1)], models)


def test_a_billboard_reaches_as_far_as_its_model_and_no_farther(monkeypatch):
    monkeypatch.setattr(image_billboard, "_read_board", lambda *_: None)
    monkeypatch.setattr(image_billboard, "_check_board", lambda *_: None)
    model = types.SimpleNamespace(kind=None, faces=[None])
    found = dict(zip(image_billboard.TABLES, ([()], [1], b"")))

    def read(square):
        monkeypatch.setattr(image_billboard, "_reach", lambda board: square)
        return image_billboard.read(found, [model], [5])
    assert read(25).model_map == [1]
    refuses("radius", read, 26)
    refuses("index", image_billboard.read, {**found, "billboard map": [2]}, [model], [5])
    refuses("count", image_billboard.read, found, [types.SimpleNamespace(kind=None, faces=[None, None])], [5])


def test_face_bounds_are_written_where_faces_are_sorted():
    """With a depth buffer only if a surface is mixed with what is beneath, or if clusters find faces by them. formats 1.6f."""
    def bounds(**changes):
        made = scene(**changes)
        made.models = [dataclasses.replace(model, kind=image.SORTED) for model in made.models]
        assert image.unpack(image.pack(made)) == made
        return section(image.pack(made), "keys")[1]

    def looks(flags):
        return image_surface.Surfaces(surfaces=[image_surface.Surface(flags=flags, opacity=16)])

    assert bounds() and not bounds(depth_bits=16) and not bounds(depth_bits=32)
    flagged = {flags: image_models.has_keys(types.SimpleNamespace(depth_bits=16, surfaces=looks(flags), models=[]))
               for flags in (0, image_surface.LIT, image_surface.BLENDED, image_surface.ADDED | image_surface.LIT)}
    assert list(flagged.values()) == [False, False, True, True]
    clustered = types.SimpleNamespace(clusters=["a cluster"])
    assert image_models.has_keys(types.SimpleNamespace(depth_bits=16, surfaces=None, models=[clustered]))


# --- surfaces -----------------------------------------------------------------------

def surfaces(**changes):
    """The tables of an image with a texture of 2 x 2 texels and one surface, which no face has."""
    return {**dict(zip(image_surface.TABLES, ([(0, 0, 1, 1, BITS_8, 0, 0, 1, 0)], b"abcd", [(1, 0, 0, 16, 0, 0, 0, 0)], [], [0], [], [], []))),
            **changes}


MODELS = [types.SimpleNamespace(vertices=[(0, 0, 0), (4, 0, 0), (4, 4, 0), (8, 8, 0)],
                                faces=[types.SimpleNamespace(corners=(0, 1, 2, 3), mapped=None)])]


def test_texels_and_colours_end_with_their_table():
    texture = image_surface.read(surfaces(), 0, MODELS).textures[0]
    assert bytes(texture.texels) == b"abcd" and texture.log_width == 1
    refuses("offset", image_surface.read, surfaces(texels=b"abc"), 0, MODELS)
    four = [(0, 2, 1, 1, BITS_4, 0, 0, 1, 0)]
    texture = image_surface.read(surfaces(textures=four, texels=bytes(range(18))), 0, MODELS).textures[0]
    assert bytes(texture.texels) == b"\0\1" and bytes(texture.colours) == bytes(range(2, 18))
    refuses("offset", image_surface.read, surfaces(textures=four, texels=bytes(17)), 0, MODELS)
    refuses("reserved", image_surface.read, surfaces(textures=[(0, 1, 1, 1, BITS_8, 0, 0, 1, 0)]), 0, MODELS)


def test_texels_of_rgb565_are_for_an_image_of_rgb565():
    """A key of their own, an even place, two bytes a texel."""
    def wide(place, key=0, bits=16):
        found = surfaces(textures=[(place, 0, 1, 1, image_surface.RGB565, image_surface.KEYED, key, 1, 0xFEDC)], texels=bytes(range(11)))
        return image_surface.read, found, 0, MODELS, bits

    read, *arguments = wide(2)
    texture = read(*arguments).textures[0]
    assert bytes(texture.texels) == bytes(range(2, 10)) and texture.key_565 == 0xFEDC
    refuses("offset", *wide(4))
    refuses("alignment", *wide(1))
    refuses("reserved", *wide(2, key=1))
    refuses("reserved", *wide(2, bits=8))
    refuses("reserved", image_surface.read, surfaces(textures=[(0, 0, 1, 1, BITS_8, 0, 0, 1, 1)]), 0, MODELS)


def test_colours_are_added_in_an_image_of_rgb565():
    def looks(flags, bits):
        return image_surface.read, surfaces(surfaces=[(0, 0, flags, 16, 0, 0, 0, 0)]), 0, MODELS, bits

    added, blended = image_surface.ADDED, image_surface.BLENDED
    for flags in (added, added | image_surface.LIT, blended):   # which needs no table
        read, *arguments = looks(flags, 16)
        assert read(*arguments).surfaces[0].flags == flags
    refuses("reserved", *looks(added, 8))
    refuses("argument", *looks(blended, 8))
    refuses("reserved", *looks(added | blended, 16))
    refuses("reserved", *looks(2 * image_surface.COLOURS, 16))
    refuses("reserved", *looks(image_surface.COLOURS, 8))


def test_a_blend_table_ends_with_the_palette():
    """formats 1.4f."""
    rows = [bytes(256)] * 6
    made = image_surface.read(surfaces(**{"blend table": rows}), 250, MODELS)
    assert made.blend_first == 250 and len(made.blend) == 6
    refuses("count", image_surface.read, surfaces(**{"blend table": rows}), 251, MODELS)
    assert image_surface.read(surfaces(), 255, MODELS).blend_first == 255
    refuses("count", image_surface.read, surfaces(), 256, MODELS)


def test_a_blended_surface_shows_up_to_all_of_its_own_colour():
    def looks(flags, sixteenths, *reserved):
        return surfaces(surfaces=[(0, 0, flags, 16, sixteenths, *reserved, 0)], **{"blend table": [bytes(256)]})

    for sixteenths in (0, 1, 16):
        assert image_surface.read(looks(image_surface.BLENDED, sixteenths, 0, 0), 0, MODELS).surfaces[0].sixteenths == sixteenths
    refuses("range", image_surface.read, looks(image_surface.BLENDED, 17, 0, 0), 0, MODELS)
    refuses("reserved", image_surface.read, looks(0, 1, 0, 0), 0, MODELS)
    refuses("reserved", image_surface.read, looks(image_surface.BLENDED, 1, 0, 1), 0, MODELS)


def mapped(*vertices, surface=0, coordinates=(0, 0, 1, 0, 1, 1), corners=(0, 1, 2)):
    table = [(*coordinates[2 * i:2 * i + 2], vertex, 0) for i, vertex in enumerate(vertices)]
    return surfaces(**{"mapped faces": [(surface, *corners)], "mapped corners": table, "face map": [1]})


def test_a_face_has_a_mapping_of_three_vertices_that_are_on_no_line():
    most = image_surface.TEXEL_MAX
    image_surface.read(mapped(0, 1, 2, coordinates=(most, -most, 0, 0, 0, 0)), 0, MODELS)
    assert MODELS[0].faces[0].mapped.texels[0] == (most, -most) and MODELS[0].faces[0].mapped.vertices == (0, 1, 2)
    for status, found in (("degenerate", mapped(0, 2, 3)), ("index", mapped(0, 1, 4)), ("degenerate", mapped(1, 1, 2)),
                          ("index", mapped(0, 1, 2, surface=1)), ("index", mapped(0, 1, 2, corners=(0, 1, 3))),
                          ("range", mapped(0, 1, 2, coordinates=(most + 1, 0, 0, 0, 0, 0))),
                          ("index", {**mapped(0, 1, 2), "face map": [2]})):
        refuses(status, image_surface.read, found, 0, MODELS)


def test_a_surface_counts_corners_from_its_first():
    """formats 1.12e."""
    found = mapped(0, 0, 1, 2, coordinates=(0, 0) + (0, 0, 1, 0, 1, 1))
    found["surfaces"] = [(0, 0, 0, 16, 0, 0, 0, 1)]
    image_surface.read(found, 0, MODELS)
    assert MODELS[0].faces[0].mapped.vertices == (0, 1, 2)
    for first in (2, 4):
        refuses("index", image_surface.read, {**found, "surfaces": [(0, 0, 0, 16, 0, 0, 0, first)]}, 0, MODELS)
    refuses("index", image_surface.read, {**found, "surfaces": [(0, 0, 0, 16, 0, 0, 0, 5)]}, 0, MODELS)


def test_faces_share_corners_up_to_65536_a_surface():
    """Of the faces of a strip each shares two corners with the one before. Where a surface has as many as its faces can count, one
    like it goes on, and the faces are read as they were. formats 1.12d."""
    count = image_surface.CORNERS_OF_SURFACE
    strip = [image_surface.Mapped(0, (i, i + 1, i + 2), ((i, 0), (i + 1, 0), (i + 2, 0))) for i in range(count)]
    look = image_surface.Surface(opacity=7)
    placed, faces, corners = image_surface.share_corners(strip[:-2], [look])
    assert (placed, len(corners)) == ([(look, 0)], count) and faces[-1] == (0, (count - 3, count - 2, count - 1))
    placed, faces, corners = image_surface.share_corners(strip, [look])
    assert placed == [(look, 0), (look, count)] and len(corners) == count + 4 and faces[-2:] == [(1, (0, 1, 2)), (1, (1, 2, 3))]
    for one, (surface, numbers) in zip(strip, faces):
        assert tuple(corners[placed[surface][1] + number][1] for number in numbers) == one.vertices


@pytest.mark.parametrize("way, is_line", [((1, 0, 0), True), ((0, 1, 0), True), ((0, 0, 1), True), ((1, 2, -3), True),
                                          ((0, 0, 0), True)])
@pytest.mark.parametrize("axis", range(3))
def test_corners_on_one_line(way, is_line, axis):
    a, b = (5, 6, 7), tuple(c + w for c, w in zip((5, 6, 7), way))
    c = tuple(p - 4 * w for p, w in zip(a, way))
    assert image_surface._on_one_line(a, b, c) == is_line
    beside = tuple(p + (i == axis) for i, p in enumerate(c))
    along_axis = [i for i in range(3) if way[i]] in ([axis], [])
    assert image_surface._on_one_line(a, b, beside) == along_axis


# --- motions ------------------------------------------------------------------------

def motion(centre=(0, 0, 0), scale=ONE, parent=0, **more):
    return Motion([Key(0, centre, (0, 0, 0), scale)], parent=parent, **more)


def chain(count, **last):
    """Motions each of which has the one before it as its parent."""
    made = [motion(parent=number) for number in range(count)]
    return [*made, motion(parent=count, **last)]


def test_a_motion_reaches_to_the_end_of_the_world():
    for scale, reach in ((ONE, 100), (2 * ONE, 200), (ONE // 2, 50), (ONE + 1, 101)):
        most = COORDINATE_MAX - reach - SLACK
        image_placement._check_chain([motion((0, -most, 0), scale)], 0, 100)
        refuses("range", image_placement._check_chain, [motion((0, -most - 1, 0), scale)], 0, 100)
    # The radius of a circle counts along x and z.
    most = COORDINATE_MAX - 100 - SLACK - 7
    image_placement._check_chain([motion((most, 0, 0), radius=7)], 0, 100)
    refuses("range", image_placement._check_chain, [motion((most + 1, 0, 0), radius=7)], 0, 100)
    image_placement._check_chain([motion((0, most + 7, 0), radius=7)], 0, 100)


def test_a_child_reaches_as_far_as_its_parents_carry_it():
    """The child is 1000 from its parent, which counts as 1001, since roots are rounded. The parent doubles that, and the
    child's own size too."""
    reach = 2 * 1001 + SLACK + 200 + SLACK
    for beyond in (0, 1):
        motions = [motion((COORDINATE_MAX - reach + beyond, 0, 0), 2 * ONE), motion((600, 0, 800), parent=1)]
        if beyond:
            refuses("range", image_placement._check_chain, motions, 1, 100)
        else:
            image_placement._check_chain(motions, 1, 100)


@pytest.mark.parametrize("parents, own, status", [
    ([ONE], SCALE_MIN, None), ([ONE], SCALE_MAX, None), ([ONE // 2], SCALE_MIN, "range"), ([2 * ONE], SCALE_MAX, "range"),
    ([ONE // 2], 2 * SCALE_MIN, None), ([2 * ONE], SCALE_MAX // 2, None), ([ONE // 2, ONE // 2], 2 * SCALE_MIN, "range")])
def test_the_scale_of_a_child_with_those_of_its_parents(parents, own, status):
    motions = [motion(scale=scale, parent=number) for number, scale in enumerate([*parents, own])]
    if status:
        refuses(status, image_placement._check_chain, motions, len(parents), 0)
    else:
        image_placement._check_chain(motions, len(parents), 0)


def test_how_many_parents_a_motion_may_have():
    image_placement._check_chain(chain(DEPTH_MAX), DEPTH_MAX, 0)
    refuses("count", image_placement._check_chain, chain(DEPTH_MAX + 1), DEPTH_MAX + 1, 0)
