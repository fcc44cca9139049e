# SPDX-License-Identifier: MIT
"""Scene images: round trips, and what a damaged one is told."""

import math
import struct
import zlib

from hypothesis import given, settings, strategies as st
import pytest
from conftest import run_cli

from fixel.image import fields, image, image_header, image_models
from fixel.base.errors import ToolError
from fixel.image.image import Face, Model, Object, SceneImage
# place field: images that are broken, for the tools
from scene_sections import bodies, entry_at, joined, replaced, section

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
    assert struct.unpack_from("<HHI", blob, 4) == (8, 7, len(blob))
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
    refused(patched(blob, 4, b"\11\0"), "version")
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
    (3, 16, b"\2", "count"), (3, 16, b"\31", "count"), (3, 12, b"\1", "index"),
    (3, 18, b"\1", "count"), (3, 18, b"\31", "count"), (3, 18, b"\10", "index"), (3, 4, struct.pack("<i", (1 << 30) - 3), "normal"),
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
    assert 92 + 12 * len(fields.SECTIONS) <= 320 + 200      # with all that there is


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
